// SPDX-License-Identifier: GPL-3.0-or-later
// Import of a million triangles: Trixel's readers with adjacency and half-edges, OpenMesh's own
// readers (which build half-edges too), and the parts of a Surface alone.
#include "core/mesh/mesh_reader.h"
#include "core/mesh/surface.h"

#include <benchmark/benchmark.h>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>

namespace {

using namespace trixel;
using OpenMeshMesh = OpenMesh::TriMesh_ArrayKernelT<>;

// A wavy torus of 1000 × 500 squares, each cut in two: closed, a million triangles.
TriangleMesh torus()
{
    constexpr std::uint32_t kRound = 1000;
    constexpr std::uint32_t kTube = 500;
    TriangleMesh mesh;
    for (std::uint32_t i = 0; i < kRound; ++i) {
        for (std::uint32_t k = 0; k < kTube; ++k) {
            const double a = 2 * M_PI * i / kRound;
            const double b = 2 * M_PI * k / kTube;
            const double r = 0.4 + 0.02 * std::sin(37 * a + 11 * b);
            mesh.positions.emplace_back((1 + r * std::cos(b)) * std::cos(a),
                                        (1 + r * std::cos(b)) * std::sin(a),
                                        r * std::sin(b));
            const std::uint32_t p = i * kTube + k;
            const std::uint32_t q = i * kTube + (k + 1) % kTube;
            const std::uint32_t s = (i + 1) % kRound * kTube + k;
            const std::uint32_t t = (i + 1) % kRound * kTube + (k + 1) % kTube;
            mesh.triangles.push_back({p, s, q});
            mesh.triangles.push_back({q, s, t});
        }
    }
    return mesh;
}

void add(std::string& text, float number)
{
    char digits[32];
    text.append(digits, std::to_chars(digits, digits + sizeof digits, number).ptr);
}

void add(std::string& text, const char* before, const glm::vec3& p)
{
    text += before;
    for (int axis = 0; axis < 3; ++axis) {
        text += axis > 0 ? " " : "";
        add(text, p[axis]);
    }
    text += '\n';
}

void add(std::string& text, const char* before, const Triangle& t, std::uint32_t first)
{
    text += before;
    for (std::size_t i = 0; i < 3; ++i) {
        text += ' ';
        text += std::to_string(t[i] + first);
    }
    text += '\n';
}

template <class T>
void addBytes(std::string& file, const T& value)
{
    file.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::string objFile(const TriangleMesh& mesh)
{
    std::string file;
    for (const glm::vec3& p : mesh.positions) {
        add(file, "v ", p);
    }
    for (const Triangle& t : mesh.triangles) {
        add(file, "f", t, 1);
    }
    return file;
}

std::string indexedText(const TriangleMesh& mesh, std::string header)
{
    for (const glm::vec3& p : mesh.positions) {
        add(header, "", p);
    }
    for (const Triangle& t : mesh.triangles) {
        add(header, "3", t, 0);
    }
    return header;
}

std::string plyHeader(const TriangleMesh& mesh, const std::string& format)
{
    return "ply\nformat " + format + " 1.0\nelement vertex " +
           std::to_string(mesh.positions.size()) +
           "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
           std::to_string(mesh.faceCount()) +
           "\nproperty list uchar int vertex_indices\nend_header\n";
}

std::string asciiPly(const TriangleMesh& mesh)
{
    return indexedText(mesh, plyHeader(mesh, "ascii"));
}

std::string offFile(const TriangleMesh& mesh)
{
    return indexedText(mesh,
                       "OFF\n" + std::to_string(mesh.positions.size()) + ' ' +
                           std::to_string(mesh.faceCount()) + " 0\n");
}

std::string binaryPly(const TriangleMesh& mesh)
{
    std::string file = plyHeader(mesh, "binary_little_endian");
    for (const glm::vec3& p : mesh.positions) {
        addBytes(file, p);
    }
    for (const Triangle& t : mesh.triangles) {
        file += '\3';
        addBytes(file, t);
    }
    return file;
}

std::string binaryStl(const TriangleMesh& mesh)
{
    std::string file(80, ' ');
    addBytes(file, static_cast<std::uint32_t>(mesh.faceCount()));
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        addBytes(file, glm::vec3(0, 0, 1));
        addBytes(file, mesh.corners(faceId(f)));
        addBytes(file, std::uint16_t{0});
    }
    return file;
}

std::string asciiStl(const TriangleMesh& mesh)
{
    std::string file = "solid torus\n";
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        file += "facet normal 0 0 1\nouter loop\n";
        for (const glm::vec3& corner : mesh.corners(faceId(f))) {
            add(file, "vertex ", corner);
        }
        file += "endloop\nendfacet\n";
    }
    return file + "endsolid torus\n";
}

struct Kind
{
    const char* name;
    OpenMesh::IO::Options options;
    std::string (*write)(const TriangleMesh&);
};

const Kind kKinds[] = {{"torus.obj", OpenMesh::IO::Options::Default, objFile},
                       {"binary.ply", OpenMesh::IO::Options::Binary, binaryPly},
                       {"ascii.ply", OpenMesh::IO::Options::Default, asciiPly},
                       {"binary.stl", OpenMesh::IO::Options::Binary, binaryStl},
                       {"ascii.stl", OpenMesh::IO::Options::Default, asciiStl},
                       {"torus.off", OpenMesh::IO::Options::Default, offFile}};

// A folder for the files, which goes with the program; each file is written when first asked for.
class Files
{
public:
    Files()
        : m_folder(std::filesystem::temp_directory_path() /
                   ("trixel_bench_import_" + std::to_string(::getpid())))
    {
        std::filesystem::create_directory(m_folder);
    }
    ~Files() { std::filesystem::remove_all(m_folder); }
    Files(const Files&) = delete;
    Files& operator=(const Files&) = delete;

    std::filesystem::path path(const Kind& kind) const
    {
        const std::filesystem::path path = m_folder / kind.name;
        if (!std::filesystem::exists(path)) {
            std::ofstream(path, std::ios::binary) << kind.write(torus());
        }
        return path;
    }

private:
    std::filesystem::path m_folder;
};

const Files& files()
{
    static const Files written;
    return written;
}

void readByOpenMesh(benchmark::State& state, const Kind& kind)
{
    const std::string path = files().path(kind).string();
    for (auto _ : state) {
        OpenMeshMesh mesh;
        OpenMesh::IO::Options options = kind.options;
        if (!OpenMesh::IO::read_mesh(mesh, path, options) || mesh.n_faces() != 1'000'000) {
            state.SkipWithError("OpenMesh did not read the file");
            return;
        }
        benchmark::DoNotOptimize(mesh.n_halfedges());
    }
}

void readByTrixel(benchmark::State& state, const Kind& kind, bool withParts)
{
    const std::filesystem::path path = files().path(kind);
    for (auto _ : state) {
        NoProgress progress;
        const auto mesh = readMesh(path, progress);
        if (!mesh || mesh->faceCount() != 1'000'000) {
            state.SkipWithError("Trixel did not read the file");
            return;
        }
        if (withParts) {
            const Adjacency adjacency = buildAdjacency(mesh->triangles);
            const HalfEdges halfEdges(mesh->triangles, mesh->positions.size(), adjacency);
            benchmark::DoNotOptimize(halfEdges.memoryBytes());
        }
    }
}

void adjacencyAlone(benchmark::State& state)
{
    const TriangleMesh mesh = torus();
    for (auto _ : state) {
        benchmark::DoNotOptimize(buildAdjacency(mesh.triangles));
    }
}

void halfEdgesAlone(benchmark::State& state)
{
    const TriangleMesh mesh = torus();
    const Adjacency adjacency = buildAdjacency(mesh.triangles);
    for (auto _ : state) {
        benchmark::DoNotOptimize(
            HalfEdges(mesh.triangles, mesh.positions.size(), adjacency).memoryBytes());
    }
}

void halfEdgesByAddFace(benchmark::State& state)
{
    const TriangleMesh mesh = torus();
    for (auto _ : state) {
        OpenMesh::TriConnectivity built;
        built.reserve(mesh.positions.size(), mesh.faceCount() * 3 / 2, mesh.faceCount());
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            built.new_vertex();
        }
        for (const Triangle& t : mesh.triangles) {
            built.add_face(OpenMesh::VertexHandle(static_cast<int>(t[0])),
                           OpenMesh::VertexHandle(static_cast<int>(t[1])),
                           OpenMesh::VertexHandle(static_cast<int>(t[2])));
        }
        benchmark::DoNotOptimize(built.n_halfedges());
    }
}

void reportAlone(benchmark::State& state)
{
    const TriangleMesh mesh = torus();
    const Adjacency adjacency = buildAdjacency(mesh.triangles);
    for (auto _ : state) {
        benchmark::DoNotOptimize(inspectMesh(mesh, adjacency));
    }
}

// Everything, with the hierarchy; the counters are bytes a face beyond positions and indices.
void wholeSurface(benchmark::State& state)
{
    const TriangleMesh mesh = torus();
    std::shared_ptr<const Surface> surface;
    for (auto _ : state) {
        NoProgress progress;
        surface = *Surface::build(mesh, progress);
    }
    const auto faces = static_cast<double>(mesh.faceCount());
    const double adjacency = 3 * sizeof(std::uint32_t);
    const double halfEdges = static_cast<double>(surface->halfEdges().memoryBytes()) / faces;
    const double hierarchy = static_cast<double>(surface->bvh().memoryBytes()) / faces;
    state.counters["adjacency_B"] = adjacency;
    state.counters["half_edges_B"] = halfEdges;
    state.counters["hierarchy_B"] = hierarchy;
    state.counters["all_B"] = adjacency + halfEdges + hierarchy;
}

} // namespace

int main(int argc, char** argv)
{
    for (const Kind& kind : kKinds) {
        const std::string name = kind.name;
        benchmark::RegisterBenchmark((name + "/openmesh").c_str(), readByOpenMesh, kind)
            ->Unit(benchmark::kMillisecond)
            ->UseRealTime()
            ->MeasureProcessCPUTime();
        benchmark::RegisterBenchmark(
            (name + "/trixel_with_half_edges").c_str(), readByTrixel, kind, true)
            ->Unit(benchmark::kMillisecond)
            ->UseRealTime()
            ->MeasureProcessCPUTime();
        benchmark::RegisterBenchmark(
            (name + "/trixel_reader_alone").c_str(), readByTrixel, kind, false)
            ->Unit(benchmark::kMillisecond)
            ->UseRealTime()
            ->MeasureProcessCPUTime();
    }
    benchmark::RegisterBenchmark("part/adjacency", adjacencyAlone)
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime()
        ->MeasureProcessCPUTime();
    benchmark::RegisterBenchmark("part/half_edges", halfEdgesAlone)
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime()
        ->MeasureProcessCPUTime();
    benchmark::RegisterBenchmark("part/half_edges_by_add_face", halfEdgesByAddFace)
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime()
        ->MeasureProcessCPUTime();
    benchmark::RegisterBenchmark("part/report", reportAlone)
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime()
        ->MeasureProcessCPUTime();
    benchmark::RegisterBenchmark("part/whole_surface_with_hierarchy", wholeSurface)
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime()
        ->MeasureProcessCPUTime();
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
