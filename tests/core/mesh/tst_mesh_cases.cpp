// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh_reader.h"
#include "core/mesh/surface.h"
#include "tests/core/mesh/test_data.h"

#include <gmock/gmock.h>
#include <map>

namespace trixel {
namespace {

struct Verdict
{
    std::size_t faces = 0; // 0: refused
    std::size_t vertices = 0;
    std::string error; // without the file's name
};

const std::string kNumber = "expected a finite number that fits a float, found ";

// What is right for each file of tests/data/mesh-cases.
const std::map<std::string, Verdict> kVerdicts{
    {"obj_1e39.obj", {0, 0, "line 1: " + kNumber + "'1e39'"}},
    {"obj_2vert_face.obj", {0, 0, "line 5: expected a face of at least 3 corners, found 2"}},
    {"obj_bowtie.obj", {2, 5, ""}},
    {"obj_comma_locale.obj", {0, 0, "line 1: " + kNumber + "'0,5'"}},
    {"obj_degenerate.obj", {2, 4, ""}},
    {"obj_dupface.obj", {2, 4, ""}},
    {"obj_face_before_vertex.obj", {1, 3, ""}},
    {"obj_flipped_winding.obj", {2, 4, ""}},
    {"obj_idx_-2^31.obj",
     {0, 0, "line 5: expected a vertex number in -4 to -1, found -2147483648"}},
    {"obj_idx_2^31-1.obj", {0, 0, "line 5: expected a vertex number in 1 to 4, found 2147483647"}},
    {"obj_idx_neg_oob.obj", {0, 0, "line 5: expected a vertex number in -4 to -1, found -99"}},
    {"obj_idx_negative_ok.obj", {1, 4, ""}},
    {"obj_idx_zero.obj", {0, 0, "line 5: expected a vertex number in 1 to 4, found 0"}},
    {"obj_nonmanifold_edge.obj", {3, 5, ""}},
    {"obj_quad.obj", {2, 4, ""}},
    {"obj_vidx_oob_with_vt_vn.obj",
     {0, 0, "line 8: expected a vertex number in 1 to 3, found 900000"}},
    {"obj_vn_oob.obj", {0, 0, "line 6: expected a normal number in 1 to 1, found 5"}},
    {"off_1e9_v.off",
     {0, 0, "line 2: expected at most 8 vertices in the bytes that follow, found 1000000000"}},
    {"off_comment.off", {1, 3, ""}},
    {"off_huge_f.off",
     {0, 0, "line 2: expected at most 6 faces in the bytes that follow, found 2147483647"}},
    {"off_huge_v.off",
     {0, 0, "line 2: expected at most 8 vertices in the bytes that follow, found 4294967295"}},
    {"off_idx_oob.off", {0, 0, "line 6: expected a vertex number below 3, found '77'"}},
    {"off_list_huge.off",
     {0,
      0,
      "line 6: expected a number of corners that fits the rest of the file, found "
      "'2147483647'"}},
    {"off_neg_v.off", {0, 0, "line 2: expected the number of vertices, found '-1'"}},
    {"off_trunc.off",
     {0, 0, "line 7: expected a face of at least 3 corners, found the end of the file"}},
    {"offb_trunc.off",
     {0,
      0,
      "byte 11: expected counts that fit the 52 bytes that follow, found 3 vertices and 2 "
      "faces"}},
    {"order_nm.obj", {4, 8, ""}},
    {"ply_crlf.ply", {1, 3, ""}},
    {"ply_double.ply", {1, 3, ""}},
    {"ply_f_huge.ply",
     {0,
      0,
      "line 7: expected at most 3 elements 'face' in the data that follow, found "
      "4294967295"}},
    {"ply_f_neg.ply", {0, 0, "line 7: expected the number of 'face' elements, found '-1'"}},
    {"ply_idx_oob.ply", {0, 0, "line 13: expected a vertex number below 3, found '77'"}},
    {"ply_list_huge.ply",
     {0,
      0,
      "line 13: expected a number of corners that fits the rest of the file, found "
      "'4294967295'"}},
    {"ply_nan.ply", {0, 0, "line 10: " + kNumber + "'nan'"}},
    {"ply_no_end_header.ply",
     {0, 0, "line 9: expected 'element', 'property', 'comment' or 'end_header', found '0'"}},
    {"ply_obj_info.ply", {1, 3, ""}},
    {"ply_only_magic.ply", {0, 0, "line 2: expected 'format', found the end of the file"}},
    {"ply_trunc2.ply",
     {0,
      0,
      "line 3: expected 'element', 'property', 'comment' or 'end_header', found the end of "
      "the file"}},
    {"ply_trunc_after_prop.ply",
     {0, 0, "line 4: expected a type such as 'float' or 'int', found the end of the file"}},
    {"ply_trunc_header.ply",
     {0, 0, "line 3: expected the number of 'ver' elements, found the end of the file"}},
    {"ply_trunc_vertices.ply",
     {0, 0, "line 3: expected at most 1 elements 'vertex' in the data that follow, found 3"}},
    {"ply_unknown_type.ply",
     {0, 0, "line 4: expected a type such as 'float' or 'int', found 'quux'"}},
    {"ply_v_1e9.ply",
     {0,
      0,
      "line 3: expected at most 4 elements 'vertex' in the data that follow, found "
      "1000000000"}},
    {"ply_v_neg.ply", {0, 0, "line 3: expected the number of 'vertex' elements, found '-1'"}},
    {"ply_vertex_index_name.ply", {1, 3, ""}},
    {"plyb_idx_oob.ply", {0, 0, "byte 214: expected a vertex number below 3, found 77"}},
    {"plyb_list_float.ply",
     {0, 0, "line 8: expected an integer type for the list's length, found 'float'"}},
    {"plyb_nan.ply", {0, 0, "byte 169: " + kNumber + "nan"}},
    {"plyb_ok.ply", {1, 3, ""}},
    {"plyb_v_1e9.ply",
     {0,
      0,
      "line 3: expected at most 4 elements 'vertex' in the data that follow, found "
      "1000000000"}},
    {"stl_empty.stl", {0, 0, "the file is empty"}},
    {"stla_empty_solid.stl", {0, 0, "expected at least one facet, found none"}},
    {"stla_nan.stl", {0, 0, "line 4: " + kNumber + "'nan'"}},
    {"stla_upper.stl", {1, 3, ""}},
    {"stlb_count_1e8.stl",
     {0,
      0,
      "byte 80: expected a number of facets that matches the file's 134 bytes (84 and 50 a "
      "facet), found 100000000"}},
    {"stlb_degenerate.stl", {2, 3, ""}},
    {"stlb_nan.stl", {0, 0, "byte 96: expected a finite number, found nan"}},
    {"stlb_short_hdr.stl",
     {0,
      0,
      "byte 50: expected the word 'solid' at the start or a header of 84 bytes, found the "
      "end of the file"}},
    {"stlb_solid_header.stl", {1, 3, ""}}};

std::shared_ptr<const Surface> surfaceOf(const std::string& name)
{
    NoProgress progress;
    auto mesh = readMesh(test::dataPath("mesh-cases/" + name), progress);
    return mesh ? *Surface::build(*mesh, progress) : nullptr;
}

TEST(MeshCasesTest, everyFileGetsItsVerdict)
{
    std::size_t files = 0;
    for (const auto& path : test::filesIn("mesh-cases")) {
        const std::string name = path.filename().string();
        SCOPED_TRACE(name);
        ASSERT_TRUE(kVerdicts.contains(name));
        const Verdict& verdict = kVerdicts.at(name);
        NoProgress progress;
        const auto mesh = readMesh(path, progress);
        EXPECT_EQ(mesh ? mesh->faceCount() : 0, verdict.faces);
        EXPECT_EQ(mesh ? mesh->positions.size() : 0, verdict.vertices);
        EXPECT_EQ(mesh ? "" : mesh.error().message,
                  verdict.error.empty() ? "" : path.string() + ": " + verdict.error);
        ++files;
    }
    EXPECT_EQ(files, kVerdicts.size());
}

// Faces keep the file's order and number, whatever is wrong with them; the report names them.
TEST(MeshCasesTest, oddFacesKeepTheirNumberAndAreReported)
{
    using testing::ElementsAre;
    const auto degenerate = surfaceOf("obj_degenerate.obj");
    ASSERT_TRUE(degenerate);
    EXPECT_THAT(degenerate->mesh().triangles, ElementsAre(Triangle{0, 0, 1}, Triangle{0, 1, 2}));
    EXPECT_THAT(degenerate->report().degenerateFaces, ElementsAre(faceId(0)));
    EXPECT_THAT(degenerate->report().halfEdgeRefusedFaces, ElementsAre(faceId(0)));
    EXPECT_EQ(degenerate->report().unusedVertices, 1U);

    EXPECT_THAT(surfaceOf("obj_dupface.obj")->report().duplicateFaces, ElementsAre(faceId(1)));
    EXPECT_THAT(surfaceOf("obj_flipped_winding.obj")->report().flippedFaces,
                ElementsAre(faceId(1)));
    EXPECT_THAT(surfaceOf("obj_bowtie.obj")->report().isolatedFaces,
                ElementsAre(faceId(0), faceId(1)));
    EXPECT_EQ(surfaceOf("obj_quad.obj")->report().polygonsCut, 1U);
    EXPECT_THAT(surfaceOf("stlb_degenerate.stl")->report().degenerateFaces, ElementsAre(faceId(1)));

    const auto order = surfaceOf("order_nm.obj");
    EXPECT_THAT(
        order->mesh().triangles,
        ElementsAre(Triangle{0, 1, 2}, Triangle{1, 0, 3}, Triangle{0, 1, 4}, Triangle{5, 6, 7}));
    EXPECT_THAT(order->report().nonManifoldEdges,
                ElementsAre(MeshReport::Edge{faceId(0), LocalEdge::E0},
                            MeshReport::Edge{faceId(1), LocalEdge::E0},
                            MeshReport::Edge{faceId(2), LocalEdge::E0}));
}

} // namespace
} // namespace trixel
