// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh_reader.h"
#include "core/mesh/surface.h"
#include "tests/core/mesh/test_data.h"

#include <cmath>
#include <gmock/gmock.h>
#include <random>

namespace trixel {
namespace {

// Either a mesh that keeps what TriangleMesh promises, or one sentence.
void expectMeshOrSentence(MeshFormat format, std::string_view bytes)
{
    NoProgress progress;
    const auto mesh = parseMesh(format, bytes, progress);
    if (!mesh) {
        ASSERT_EQ(mesh.error().kind, ErrorKind::Contents);
        ASSERT_THAT(mesh.error().message,
                    testing::AnyOf(testing::HasSubstr("expected"), "the file is empty"));
        ASSERT_LT(mesh.error().message.size(), 200U);
        return;
    }
    ASSERT_GT(mesh->faceCount(), 0U);
    ASSERT_LE(mesh->faceCount() + mesh->positions.size(), bytes.size());
    ASSERT_TRUE(mesh->sourceFaces.empty() || mesh->sourceFaces.size() == mesh->faceCount());
    for (const Triangle& t : mesh->triangles) {
        ASSERT_LT(std::max({t[0], t[1], t[2]}), mesh->positions.size());
    }
    for (const glm::vec3& p : mesh->positions) {
        ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
    }
}

struct Seed
{
    MeshFormat format;
    std::string bytes;
};

// Small valid files of every format and kind.
std::vector<Seed> validSeeds()
{
    std::vector<Seed> seeds;
    for (const char* folder : {"mesh-cases", "mesh-formats"}) {
        for (const auto& path : test::filesIn(folder)) {
            const Seed seed{*meshFormatOf(path), *readFile(path)};
            NoProgress progress;
            if (parseMesh(seed.format, seed.bytes, progress)) {
                seeds.push_back(seed);
            }
        }
    }
    return seeds;
}

TEST(HostileMeshesTest, everyFileOpensRightOrGetsOneSentence)
{
    std::size_t files = 0;
    for (const auto& path : test::filesIn("hostile/mesh")) {
        SCOPED_TRACE(path);
        expectMeshOrSentence(*meshFormatOf(path), *readFile(path));
        ++files;
    }
    EXPECT_EQ(files, 72U);
}

TEST(HostileMeshesTest, everyFileReadAsAnotherFormatGetsOneSentence)
{
    for (const char* folder : {"hostile/mesh", "mesh-cases", "mesh-formats"}) {
        for (const auto& path : test::filesIn(folder)) {
            SCOPED_TRACE(path);
            for (const MeshFormat format :
                 {MeshFormat::Obj, MeshFormat::Ply, MeshFormat::Stl, MeshFormat::Off}) {
                expectMeshOrSentence(format, *readFile(path));
            }
        }
    }
}

TEST(HostileMeshesTest, truncationAtEveryLengthIsHandled)
{
    const auto seeds = validSeeds();
    ASSERT_GT(seeds.size(), 25U);
    for (const Seed& seed : seeds) {
        for (std::size_t length = 0; length < seed.bytes.size(); ++length) {
            SCOPED_TRACE(seed.bytes.substr(0, length));
            ASSERT_NO_FATAL_FAILURE(
                expectMeshOrSentence(seed.format, std::string_view(seed.bytes).substr(0, length)));
        }
    }
}

// Formats that count their elements notice every lost byte, but for the last newline.
TEST(HostileMeshesTest, truncationOfCountedFormatsIsRefused)
{
    for (const Seed& seed : validSeeds()) {
        const bool endsWithColours = seed.bytes.ends_with("  1 2 3\n");
        if (seed.format == MeshFormat::Obj || endsWithColours) {
            continue;
        }
        std::size_t end = seed.bytes.find_last_not_of(" \r\n") + 1;
        const bool namesTheEnd = seed.bytes.substr(0, 5) == "solid";
        end = namesTheEnd ? std::min(end, seed.bytes.rfind("endsolid") + 8) : end;
        for (std::size_t length = 0; length < end; ++length) {
            NoProgress progress;
            const auto mesh =
                parseMesh(seed.format, std::string_view(seed.bytes).substr(0, length), progress);
            // A cut inside the last number of a text leaves a shorter number.
            const bool cutsLastNumber = seed.bytes.find_first_of(" \n", length) >= end &&
                                        seed.bytes.find_last_of(" \n", length - 1) + 1 < length;
            EXPECT_FALSE(mesh && !cutsLastNumber) << seed.bytes.substr(0, length);
        }
    }
}

TEST(HostileMeshesTest, randomDamageIsHandled)
{
    std::mt19937 random(20240607);
    const auto seeds = validSeeds();
    std::size_t accepted = 0;
    for (int round = 0; round < 40'000; ++round) {
        const Seed& seed = seeds[random() % seeds.size()];
        std::string bytes = seed.bytes;
        for (unsigned change = random() % 4; change-- > 0 && !bytes.empty();) {
            const std::size_t at = random() % bytes.size();
            switch (random() % 5) {
            case 0:
                bytes[at] = static_cast<char>(bytes[at] ^ (1 << random() % 8));
                break;
            case 1:
                bytes[at] = static_cast<char>(random());
                break;
            case 2:
                bytes.erase(at, 1 + random() % 8);
                break;
            case 3:
                bytes.insert(at, bytes.substr(random() % bytes.size(), 1 + random() % 16));
                break;
            default:
                bytes[at] = "0123456789-.e/\\\n\r #"[random() % 19];
                break;
            }
        }
        SCOPED_TRACE(bytes);
        ASSERT_NO_FATAL_FAILURE(expectMeshOrSentence(seed.format, bytes));
        NoProgress progress;
        if (const auto mesh = parseMesh(seed.format, bytes, progress)) {
            ++accepted;
            ASSERT_TRUE(Surface::build(*mesh, progress));
        }
    }
    EXPECT_GT(accepted, 1000U);
    EXPECT_LT(accepted, 39'000U);
}

TEST(HostileMeshesTest, countsAreNotBelievedBeforeTheFileIsLongEnough)
{
    // Each asks for gigabytes; within the test's time limit only if nothing is reserved for them.
    for (const auto& [format, text] : std::initializer_list<std::pair<MeshFormat, std::string>>{
             {MeshFormat::Off, "OFF\n2000000000 2000000000 0\n0 0 0\n"},
             {MeshFormat::Off,
              "OFF BINARY\n\x7f\xff\xff\xff\x7f\xff\xff\xff" + std::string(40, '\0')},
             {MeshFormat::Ply,
              "ply\nformat ascii 1.0\nelement vertex 4611686018427387904\n"
              "property float x\nproperty float y\nproperty float z\n"
              "element face 4611686018427387904\n"
              "property list uchar int vertex_indices\nend_header\n0 0 0\n"},
             {MeshFormat::Ply,
              "ply\nformat binary_little_endian 1.0\nelement vertex 0\n"
              "property float x\nproperty float y\nproperty float z\n"
              "element nothing 4000000000000\nelement face 1\n"
              "property list uint int vertex_indices\nend_header\n\xff\xff\xff\xff" +
                  std::string(40, '\0')}}) {
        NoProgress progress;
        EXPECT_FALSE(parseMesh(format, text, progress));
    }
}

} // namespace
} // namespace trixel
