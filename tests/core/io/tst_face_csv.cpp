// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/read_file.h"
#include "core/io/face_csv.h"
#include "tests/core/test_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <numeric>

using namespace trixel;

namespace {

class FaceCsv : public testing::Test
{
protected:
    void SetUp() override
    {
        m_folder =
            std::filesystem::temp_directory_path() /
            ("trixel-face-csv-" + std::to_string(testing::UnitTest::GetInstance()->random_seed()) +
             testing::UnitTest::GetInstance()->current_test_info()->name());
        std::filesystem::create_directories(m_folder);
    }
    void TearDown() override { std::filesystem::remove_all(m_folder); }

    static FaceFigures figuresOf(const TriangleMesh& mesh)
    {
        const std::array<std::byte, 3> fill{std::byte{51}, std::byte{102}, std::byte{153}};
        TexelStore store(static_cast<std::uint32_t>(mesh.faceCount()), {}, Level(1), fill);
        store.writable(faceId(1))[0] = std::byte{255};
        NoProgress progress;
        return FaceFigures::measure(mesh, store, {}, Threads{1}, progress).value();
    }

    std::filesystem::path m_folder;
};

/// Stops at a share of the work.
class Impatient final : public Progress
{
public:
    bool report(double fraction) override { return fraction < 0.5; }
};

} // namespace

TEST_F(FaceCsv, rowsStandInTheOrderAskedFor)
{
    const TriangleMesh mesh = test::gridMesh(1);
    const FaceFigures figures = figuresOf(mesh);
    const std::array jumps{0.25F, std::numeric_limits<float>::quiet_NaN()};
    const std::array faces{faceId(1), faceId(0)};
    NoProgress progress;
    const auto path = m_folder / "faces.csv";
    ASSERT_TRUE(writeFaceCsv({figures, jumps, {}}, faces, path, progress));
    EXPECT_EQ(readFile(path).value(),
              "face,level,texels,bytes,constant,density,min,max,mean,jump\n"
              "1,1,4,12,0,1.7320508,0.2,1,0.46666667,\n"
              "0,1,4,3,1,1.7320508,0.2,0.6,0.4,0.25\n");
    std::string row;
    appendFaceRow(row, {figures, {}, {}}, faceId(0), '\t');
    EXPECT_EQ(row, "0\t1\t4\t3\t1\t1.7320508\t0.2\t0.6\t0.4\t\n");
}

TEST_F(FaceCsv, manyRowsAreAllThere)
{
    const TriangleMesh mesh = test::gridMesh(150); // 45,000 faces: several parts
    const FaceFigures figures = figuresOf(mesh);
    std::vector<FaceId> faces(mesh.faceCount());
    for (std::size_t k = 0; k < faces.size(); ++k) {
        faces[k] = faceId(k);
    }
    NoProgress progress;
    const auto path = m_folder / "faces.csv";
    ASSERT_TRUE(writeFaceCsv({figures, {}, {}}, faces, path, progress));
    const std::string text = readFile(path).value();
    EXPECT_EQ(std::ranges::count(text, '\n'), 45'001);
    EXPECT_NE(text.find("\n44999,1,4,3,1,"), std::string::npos);
    ASSERT_TRUE(writeFaceCsv({figures, {}, {}}, {}, path, progress));
    EXPECT_EQ(readFile(path).value(), faceTableHeader(','));
}

TEST_F(FaceCsv, whatFailsLeavesWhatWasThere)
{
    const TriangleMesh mesh = test::gridMesh(150);
    const FaceFigures figures = figuresOf(mesh);
    std::vector<FaceId> faces(mesh.faceCount(), faceId(0));
    Impatient impatient;
    const auto path = m_folder / "faces.csv";
    const Status stopped = writeFaceCsv({figures, {}, {}}, faces, path, impatient);
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.error().kind, ErrorKind::Cancelled);
    EXPECT_TRUE(std::filesystem::is_empty(m_folder));
    NoProgress progress;
    const Status nowhere =
        writeFaceCsv({figures, {}, {}}, faces, m_folder / "none" / "faces.csv", progress);
    ASSERT_FALSE(nowhere);
    EXPECT_EQ(nowhere.error().kind, ErrorKind::Path);
}
