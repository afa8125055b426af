// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/mesh/uv_mesh.h"
#include "core/mesh/mesh_reader.h"
#include "tests/core/cancel_after.h"
#include "tests/core/test_meshes.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <fstream>
#include <gmock/gmock.h>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

using namespace trixel;
using namespace trixel::test;
using testing::HasSubstr;

namespace {

class MeshFiles : public testing::Test
{
protected:
    MeshFiles()
        : mesh(sphereMesh(1))
        , uvMesh{mesh, FaceMap<FaceUvs>(mesh.faceCount()), {"one.png", "two.png"}}
    {
        std::string name = (std::filesystem::temp_directory_path() / "trixel-mesh-XXXXXX").string();
        folder = mkdtemp(name.data());
        for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
            const auto at = static_cast<float>(f) / 128.0F;
            uvMesh.uvs[faceId(f)] = {f < 30 ? 0U : 1U,
                                     {glm::vec2(at, 0.1F), glm::vec2(1, at), glm::vec2(0.3F, 1)}};
        }
    }
    ~MeshFiles() override { std::filesystem::remove_all(folder); }

    std::filesystem::path at(const std::string& name) const { return folder / name; }
    static std::string bytesOf(const std::filesystem::path& path)
    {
        std::ifstream file(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    std::size_t fileCount() const
    {
        return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder),
                                                      std::filesystem::directory_iterator()));
    }
    TriangleMesh readBack(const std::string& name) const
    {
        NoProgress reading;
        return *readMesh(at(name), reading);
    }

    std::filesystem::path folder;
    TriangleMesh mesh;
    UvMesh uvMesh;
    NoProgress progress;
};

/// The chunks of a .glb.
struct Glb
{
    nlohmann::json json;
    std::string bytes;

    explicit Glb(const std::string& file)
    {
        const auto number = [&](std::size_t at) {
            std::uint32_t value = 0;
            std::memcpy(&value, file.data() + at, 4);
            return value;
        };
        EXPECT_EQ(file.substr(0, 4), "glTF");
        EXPECT_EQ(number(4), 2U);
        EXPECT_EQ(number(8), file.size());
        EXPECT_EQ(file.substr(16, 4), "JSON");
        EXPECT_EQ(number(12) % 4, 0U);
        json = nlohmann::json::parse(file.substr(20, number(12)));
        const std::size_t chunk = 20 + number(12);
        EXPECT_EQ(file.substr(chunk + 4, 4), std::string("BIN\0", 4));
        bytes = file.substr(chunk + 8, number(chunk));
        EXPECT_EQ(chunk + 8 + bytes.size(), file.size());
    }

    /// Numbers of an accessor, one after the other.
    std::vector<float> numbers(std::size_t accessor) const
    {
        const auto& of = json["accessors"][accessor];
        const auto& view = json["bufferViews"][of["bufferView"].get<std::size_t>()];
        const std::size_t count = of["count"].get<std::size_t>() * (of["type"] == "VEC3" ? 3 : 2);
        EXPECT_EQ(view["byteLength"], count * sizeof(float));
        EXPECT_EQ(view["byteOffset"].get<std::size_t>() % 4, 0U);
        std::vector<float> values(count);
        std::memcpy(values.data(),
                    bytes.data() + view["byteOffset"].get<std::size_t>(),
                    count * sizeof(float));
        return values;
    }
};

TEST_F(MeshFiles, objKeepsVerticesAndFacesToTheBitAndHasUvsForEveryCorner)
{
    ASSERT_TRUE(writeObj(at("a.obj"), at("a.mtl"), uvMesh, progress));
    const TriangleMesh back = readBack("a.obj");
    EXPECT_EQ(back.positions, mesh.positions);
    EXPECT_EQ(back.triangles, mesh.triangles);
    std::istringstream lines(bytesOf(at("a.obj")));
    std::vector<glm::vec2> places;
    std::vector<std::string> materials;
    std::size_t corner = 0;
    std::size_t face = 0;
    for (std::string word; lines >> word;) {
        if (word == "vt") {
            glm::vec2 uv;
            lines >> uv.x >> uv.y;
            places.push_back(uv);
        } else if (word == "usemtl") {
            lines >> word;
            materials.push_back(word + "@" + std::to_string(face));
        } else if (word == "f") {
            for (std::size_t k = 0; k < 3; ++k, ++corner) {
                lines >> word;
                const std::size_t place = std::stoul(word.substr(word.find('/') + 1));
                EXPECT_EQ(places.at(place - 1), uvMesh.uvs[faceId(face)].corners[k]);
            }
            ++face;
        }
    }
    EXPECT_EQ(corner, 3 * mesh.faceCount());
    EXPECT_THAT(materials, testing::ElementsAre("texture0@0", "texture1@30"));
    EXPECT_THAT(bytesOf(at("a.mtl")), HasSubstr("newmtl texture1\n"));
    EXPECT_THAT(bytesOf(at("a.mtl")), HasSubstr("map_Kd two.png\n"));
    EXPECT_THAT(bytesOf(at("a.obj")), HasSubstr("mtllib a.mtl\n"));
}

TEST_F(MeshFiles, plyHasAVertexForEveryCornerWithItsUv)
{
    uvMesh.textures = {"one.png"};
    ASSERT_TRUE(writePly(at("a.ply"), uvMesh, progress));
    const TriangleMesh back = readBack("a.ply");
    ASSERT_EQ(back.faceCount(), mesh.faceCount());
    const std::string file = bytesOf(at("a.ply"));
    EXPECT_THAT(file, HasSubstr("comment TextureFile one.png\n"));
    const std::size_t begin = file.find("end_header\n") + 11;
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        EXPECT_EQ(back.corners(faceId(f)), mesh.corners(faceId(f)));
        for (std::size_t k = 0; k < 3; ++k) {
            glm::vec2 uv;
            std::memcpy(&uv, file.data() + begin + 20 * (3 * f + k) + 12, 8);
            EXPECT_EQ(uv, uvMesh.uvs[faceId(f)].corners[k]);
        }
    }
}

TEST_F(MeshFiles, glbHoldsEveryCornerItsNormalAndUvAndTheTextures)
{
    const std::vector<std::vector<std::byte>> pngs = {std::vector<std::byte>(5, std::byte{7}),
                                                      std::vector<std::byte>(11, std::byte{9})};
    ASSERT_TRUE(writeGlb(at("a.glb"), uvMesh, pngs, progress));
    const Glb glb(bytesOf(at("a.glb")));
    std::size_t face = 0;
    for (const auto& primitive : glb.json["meshes"][0]["primitives"]) {
        const auto& attributes = primitive["attributes"];
        const auto positions = glb.numbers(attributes["POSITION"]);
        const auto normals = glb.numbers(attributes["NORMAL"]);
        const auto uvs = glb.numbers(attributes["TEXCOORD_0"]);
        ASSERT_EQ(positions.size() % 9, 0U);
        for (std::size_t k = 0; k < positions.size() / 3; ++k) {
            const FaceUvs& expected = uvMesh.uvs[faceId(face + k / 3)];
            EXPECT_EQ(expected.texture, primitive["material"]);
            const glm::vec3 at(positions[3 * k], positions[3 * k + 1], positions[3 * k + 2]);
            EXPECT_EQ(at, mesh.corners(faceId(face + k / 3))[k % 3]);
            const glm::vec3 normal(normals[3 * k], normals[3 * k + 1], normals[3 * k + 2]);
            EXPECT_GT(glm::dot(normal, at), 0.98F); // a sphere's
            EXPECT_EQ(uvs[2 * k], expected.corners[k % 3].x);
            EXPECT_EQ(uvs[2 * k + 1], 1 - expected.corners[k % 3].y);
        }
        face += positions.size() / 9;
        const auto& accessor = glb.json["accessors"][attributes["POSITION"].get<std::size_t>()];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            float low = 2;
            for (std::size_t k = axis; k < positions.size(); k += 3) {
                low = std::min(low, positions[k]);
            }
            EXPECT_EQ(accessor["min"][axis].get<float>(), low);
        }
    }
    EXPECT_EQ(face, mesh.faceCount());
    for (std::size_t k = 0; k < 2; ++k) {
        const auto& view =
            glb.json["bufferViews"][glb.json["images"][k]["bufferView"].get<std::size_t>()];
        EXPECT_EQ(glb.bytes.substr(view["byteOffset"], view["byteLength"]),
                  std::string(pngs[k].size(), k == 0 ? '\7' : '\11'));
        EXPECT_EQ(glb.json["materials"][k]["pbrMetallicRoughness"]["baseColorTexture"]["index"], k);
        EXPECT_EQ(glb.json["textures"][k]["source"], k);
    }
    EXPECT_EQ(glb.json["buffers"][0]["byteLength"], glb.bytes.size());
}

TEST_F(MeshFiles, opacityIsDeclaredWhereThereIsSome)
{
    const std::vector<std::vector<std::byte>> pngs(2, std::vector<std::byte>(5));
    for (const bool has : {false, true}) {
        uvMesh.hasOpacity = has;
        uvMesh.textures[0] = "caf\xE9.png"; // a name that is no UTF-8
        ASSERT_TRUE(writeGlb(at("a.glb"), uvMesh, pngs, progress));
        const auto json = Glb(bytesOf(at("a.glb"))).json;
        EXPECT_EQ(json["materials"][1]["alphaMode"], has ? "BLEND" : "OPAQUE");
        ASSERT_TRUE(writeObj(at("a.obj"), at("a.mtl"), uvMesh, progress));
        EXPECT_EQ(bytesOf(at("a.mtl")).find("map_d") != std::string::npos, has);
    }
}

TEST_F(MeshFiles, glbIsWhatTheSpecificationAsksFor)
{
    if (std::system("python3 -c 'import jsonschema' 2>/dev/null") != 0) {
        GTEST_SKIP() << "python3-jsonschema is not installed";
    }
    const std::vector<std::vector<std::byte>> pngs(2, std::vector<std::byte>(5));
    ASSERT_TRUE(writeGlb(at("a.glb"), uvMesh, pngs, progress));
    const auto isValid = [this](const nlohmann::json& json) {
        std::ofstream(at("a.json")) << json;
        const std::string command = "python3 -c 'import json, jsonschema, sys; "
                                    "jsonschema.validate(json.load(open(sys.argv[1])), "
                                    "json.load(open(sys.argv[2])))' '" +
                                    at("a.json").string() +
                                    "' '" TRIXEL_GLTF_SCHEMA "' 2>/dev/null";
        return std::system(command.c_str()) == 0;
    };
    nlohmann::json json = Glb(bytesOf(at("a.glb"))).json;
    EXPECT_TRUE(isValid(json));
    json["accessors"][0]["componentType"] = "float";
    EXPECT_FALSE(isValid(json)); // the check can fail
}

/// A program that no one here wrote.
TEST_F(MeshFiles, glbAndObjOpenInAssimp)
{
    if (std::system("assimp version >/dev/null 2>&1") != 0) {
        GTEST_SKIP() << "assimp-utils is not installed";
    }
    const std::vector<std::vector<std::byte>> pngs(2, std::vector<std::byte>(8));
    ASSERT_TRUE(writeGlb(at("a.glb"), uvMesh, pngs, progress));
    ASSERT_TRUE(writeObj(at("a.obj"), at("a.mtl"), uvMesh, progress));
    for (const std::string name : {"a.glb", "a.obj"}) {
        const std::string command =
            "assimp info '" + at(name).string() + "' > '" + at("info").string() + "' 2>&1";
        EXPECT_EQ(std::system(command.c_str()), 0);
        const std::string info = bytesOf(at("info"));
        EXPECT_THAT(info, testing::ContainsRegex("Faces: +80\n")) << name;
        EXPECT_THAT(info, testing::ContainsRegex("Meshes: +2\n"));
    }
}

TEST_F(MeshFiles, cancellingLeavesWhatWasThere)
{
    uvMesh.textures = {"one.png"};
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        uvMesh.uvs[faceId(f)].texture = 0;
    }
    std::ofstream(at("a.ply")) << "before";
    std::ofstream(at("a.glb")) << "before";
    CancelAfter never(0);
    const Status ply = writePly(at("a.ply"), uvMesh, never);
    ASSERT_FALSE(ply);
    EXPECT_EQ(ply.error().kind, ErrorKind::Cancelled);
    const std::vector<std::vector<std::byte>> pngs(1);
    CancelAfter neverAgain(0);
    const Status glb = writeGlb(at("a.glb"), uvMesh, pngs, neverAgain);
    ASSERT_FALSE(glb);
    EXPECT_EQ(glb.error().kind, ErrorKind::Cancelled);
    EXPECT_EQ(bytesOf(at("a.ply")), "before");
    EXPECT_EQ(bytesOf(at("a.glb")), "before");
    EXPECT_EQ(fileCount(), 2U);
}

} // namespace
