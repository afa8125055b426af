// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writing and reading a million faces of natural content against a plain loop over one reused zlib
// stream that does the same work. README.md has the figures and what each counter means.
#include "core/io/inflate.h"
#include "core/io/ptx.h"
#include "core/io/ptx_average.h"
#include "core/io/ptx_file.h"
#include "core/io/ptx_planar.h"
#include "core/io/ptx_reader.h"
#include "core/lattice/texel.h"
#include "core/texture/mips.h"

#include <benchmark/benchmark.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <sys/resource.h>
#include <unistd.h>
#include <zlib.h>

using namespace trixel;
namespace fs = std::filesystem;

namespace {

constexpr std::uint32_t kFaces = 1'000'000;
const TexelFormat kFormat; // uint8 RGB
const Level kLevel(3);
constexpr std::size_t kTexelBytes = 3;
const std::size_t kFaceBytes = kLevel.texelCount() * kTexelBytes;

double secondsSince(std::chrono::steady_clock::time_point start)
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// --- content -------------------------------------------------------------------------------------

float lattice(int x, int y, int period, unsigned seed)
{
    const auto wrap = [period](int k) { return static_cast<unsigned>(k % period); };
    unsigned h = wrap(x) * 374761393U + wrap(y) * 668265263U + seed * 2246822519U;
    h = (h ^ (h >> 13U)) * 1274126177U;
    return static_cast<float>((h ^ (h >> 16U)) & 0xFFFFU) / 65535.0F;
}

float smoothNoise(float x, float y, int period, unsigned seed)
{
    const int i = static_cast<int>(x);
    const int j = static_cast<int>(y);
    const auto ease = [](float t) { return t * t * (3 - 2 * t); };
    const float s = ease(x - static_cast<float>(i));
    const float t = ease(y - static_cast<float>(j));
    return std::lerp(
        std::lerp(lattice(i, j, period, seed), lattice(i + 1, j, period, seed), s),
        std::lerp(lattice(i, j + 1, period, seed), lattice(i + 1, j + 1, period, seed), s),
        t);
}

// A periodic picture of seven octaves, the coarse ones differing from channel to channel, with two
// samples a texel so that lower and upper texels have samples of their own.
class Picture
{
public:
    static constexpr int kSide = 2048;

    Picture()
        : m_samples(static_cast<std::size_t>(kSide) * kSide * kTexelBytes)
    {
        for (int y = 0; y < kSide; ++y) {
            for (int x = 0; x < kSide; ++x) {
                for (int c = 0; c < 3; ++c) {
                    at(x, y)[c] = sample(x, y, c);
                }
            }
        }
    }

    std::byte* at(int x, int y)
    {
        return &m_samples[(static_cast<std::size_t>(y % kSide) * kSide +
                           static_cast<std::size_t>(x % kSide)) *
                          kTexelBytes];
    }

private:
    static std::byte sample(int x, int y, int channel)
    {
        float value = 0;
        float amplitude = 0.5F;
        for (int octave = 0; octave < 7; ++octave) {
            const int cells = 8 << octave;
            const float scale = static_cast<float>(cells) / kSide;
            const auto seed = static_cast<unsigned>(octave * 3 + (octave < 3 ? channel : 0));
            value += amplitude *
                     smoothNoise(
                         static_cast<float>(x) * scale, static_cast<float>(y) * scale, cells, seed);
            amplitude *= 0.5F;
        }
        return static_cast<std::byte>(std::lround(value * 255));
    }

    std::vector<std::byte> m_samples;
};

PtxContents naturalContents()
{
    Picture picture;
    PtxContents contents;
    contents.texels = TexelStore(kFaces, kFormat, kLevel, std::vector<std::byte>(kTexelBytes));
    contents.adjacency = Adjacency(kFaces);
    std::vector<std::byte> texels(kFaceBytes);
    const int resolution = static_cast<int>(kLevel.resolution());
    for (std::uint32_t face = 0; face < kFaces; ++face) {
        // Squares of two triangles in rows of 500; each wrap around the picture meets other
        // samples.
        const int square = static_cast<int>(face / 2);
        const int left = square % 500 * 2 * resolution + static_cast<int>(face / 100'000) * 7;
        const int top = square / 500 * 2 * resolution + static_cast<int>(face / 100'000) * 5;
        const bool mirrored = face % 2 == 1;
        for (std::uint32_t t = 0; t < kLevel.texelCount(); ++t) {
            const TexelCoord texel = texelAt(kLevel, TexelIndex{t});
            const int upper = texel.half == TexelHalf::Upper ? 1 : 0;
            const int u = 2 * texel.i + upper;
            const int v = 2 * texel.j + upper;
            const int last = 2 * resolution - 1;
            const std::byte* sample = mirrored ? picture.at(left + last - u, top + last - v)
                                               : picture.at(left + u, top + v);
            std::copy_n(sample, kTexelBytes, &texels[t * kTexelBytes]);
        }
        contents.texels.exchange(faceId(face), FaceTexels::full(kLevel, kTexelBytes, texels));
        if (face % 2 == 1) {
            contents.adjacency.connect(
                faceId(face - 1), LocalEdge::E1, faceId(face), LocalEdge::E1);
        }
    }
    return contents;
}

// --- the plain loop ------------------------------------------------------------------------------

class ReusedDeflate
{
public:
    ReusedDeflate() { deflateInit(&m_stream, 6); }
    ReusedDeflate(const ReusedDeflate&) = delete;
    ReusedDeflate& operator=(const ReusedDeflate&) = delete;
    ~ReusedDeflate() { deflateEnd(&m_stream); }

    /// Appends the stream; returns its size.
    std::uint32_t zip(std::span<const std::byte> bytes, std::vector<std::byte>& to)
    {
        deflateReset(&m_stream);
        const std::size_t begin = to.size();
        to.resize(begin + deflateBound(&m_stream, bytes.size()));
        m_stream.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(bytes.data()));
        m_stream.avail_in = static_cast<uInt>(bytes.size());
        m_stream.next_out = reinterpret_cast<Bytef*>(to.data() + begin);
        m_stream.avail_out = static_cast<uInt>(to.size() - begin);
        deflate(&m_stream, Z_FINISH);
        to.resize(begin + m_stream.total_out);
        return static_cast<std::uint32_t>(m_stream.total_out);
    }

private:
    z_stream m_stream{};
};

// Level 0, one reduction, averages, tables; as plain as it can be, through one stream.
void writePlainly(const fs::path& path, const PtxContents& contents)
{
    ReusedDeflate deflater;
    std::vector<std::byte> planar(kFaceBytes);
    std::vector<std::byte> reduced(kFaceBytes / 4);
    std::vector<std::byte> blocks[2];
    std::vector<PtxBlockHeader> headers[2];
    std::vector<PtxFaceInfo> infos(kFaces);
    std::vector<std::byte> constants(kFaces * kTexelBytes);
    blocks[0].reserve(kFaces * kFaceBytes);
    blocks[1].reserve(kFaces * kFaceBytes / 4);
    const auto put = [&](int k, Level level, std::span<const std::byte> texels) {
        const std::span<std::byte> out = std::span(planar).first(texels.size());
        toPlanar(kFormat,
                 {texels.data(),
                  level.resolution(),
                  level.resolution(),
                  level.resolution() * kTexelBytes},
                 true,
                 out);
        headers[k].emplace_back(PtxEncoding::DiffZipped, deflater.zip(out, blocks[k]));
    };
    for (std::uint32_t f = 0; f < kFaces; ++f) {
        const std::span<const std::byte> texels = contents.texels.face(faceId(f)).bytes();
        infos[f].uLog2 = infos[f].vLog2 = static_cast<std::int8_t>(kLevel.log2());
        for (const LocalEdge edge : kLocalEdges) {
            if (const auto neighbour = contents.adjacency.neighbour(faceId(f), edge)) {
                infos[f].adjacentFaces[indexOf(edge)] = static_cast<std::int32_t>(neighbour->face);
                infos[f].adjacentEdges |=
                    static_cast<std::uint8_t>(indexOf(neighbour->edge) << (2 * indexOf(edge)));
            }
        }
        put(0, kLevel, texels);
        averageTexel(kFormat, texels, std::span(constants).subspan(f * kTexelBytes, kTexelBytes));
        reduceTexels(kFormat, kLevel, texels, reduced);
        put(1, kLevel.coarser(), reduced);
    }
    std::vector<std::byte> tables[4];
    deflater.zip(std::as_bytes(std::span(infos)), tables[0]);
    deflater.zip(constants, tables[1]);
    deflater.zip(std::as_bytes(std::span(headers[0])), tables[2]);
    deflater.zip(std::as_bytes(std::span(headers[1])), tables[3]);
    PtxHeader header;
    header.channels = kTexelBytes;
    header.levels = 2;
    header.faces = kFaces;
    header.faceInfoBytes = static_cast<std::uint32_t>(tables[0].size());
    header.constantBytes = static_cast<std::uint32_t>(tables[1].size());
    header.levelInfoBytes = 32;
    const PtxLevelInfo levels[2] = {
        {tables[2].size() + blocks[0].size(), static_cast<std::uint32_t>(tables[2].size()), kFaces},
        {tables[3].size() + blocks[1].size(),
         static_cast<std::uint32_t>(tables[3].size()),
         kFaces}};
    header.levelDataBytes = levels[0].dataBytes + levels[1].dataBytes;
    header.editOffset = 104 + std::uint64_t{header.faceInfoBytes} + header.constantBytes + 32 +
                        header.levelDataBytes + 8;
    std::FILE* file = std::fopen(path.c_str(), "wb");
    const auto write = [file](std::span<const std::byte> bytes) {
        std::fwrite(bytes.data(), 1, bytes.size(), file);
    };
    write(bytesOf(header));
    write(tables[0]);
    write(tables[1]);
    write(std::as_bytes(std::span(levels)));
    write(tables[2]);
    write(blocks[0]);
    write(tables[3]);
    write(blocks[1]);
    write(std::vector<std::byte>(8));
    std::fflush(file);
    ::fsync(fileno(file));
    std::fclose(file);
}

// Every face of level 0 through one reused inflate stream, into a store of the same kind.
TexelStore readPlainly(const fs::path& path)
{
    MemoryBudget budget;
    const PtxFile file = openPtxFile(path, budget).value();
    TexelStore store(kFaces, kFormat, kLevel, std::vector<std::byte>(kTexelBytes));
    z_stream stream{};
    inflateInit(&stream);
    ReadAhead ahead;
    std::vector<std::byte> planar(kFaceBytes);
    std::vector<std::byte> texels(kFaceBytes);
    for (std::uint32_t f = 0; f < kFaces; ++f) {
        const PtxBlock block = file.block(faceId(f), 0).value();
        const auto zipped = ahead.view(file.source(), block.offset, block.header.size()).value();
        inflateReset(&stream);
        stream.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(zipped.data()));
        stream.avail_in = static_cast<uInt>(zipped.size());
        stream.next_out = reinterpret_cast<Bytef*>(planar.data());
        stream.avail_out = static_cast<uInt>(planar.size());
        inflate(&stream, Z_FINISH);
        const std::size_t side = kLevel.resolution();
        fromPlanar(kFormat, planar, true, {texels.data(), side, side, side * kTexelBytes});
        store.exchange(faceId(f), FaceTexels::full(kLevel, kTexelBytes, texels));
    }
    inflateEnd(&stream);
    return store;
}

struct Files
{
    Files() { fs::create_directories(folder); }
    Files(const Files&) = delete;
    Files& operator=(const Files&) = delete;
    ~Files() { fs::remove_all(folder); }

    fs::path folder =
        fs::temp_directory_path() / ("trixel-bench-ptx-" + std::to_string(::getpid()));
    fs::path plain = folder / "plain.ptx";
    fs::path own = folder / "own.ptx";
};

// Wall and processor seconds since it was made.
class Stopwatch
{
public:
    double wall() const { return secondsSince(m_start); }
    double cpu() const { return cpuNow() - m_cpu; }

private:
    static double cpuNow()
    {
        rusage usage{};
        ::getrusage(RUSAGE_SELF, &usage);
        const auto seconds = [](const timeval& t) {
            return static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_usec) * 1e-6;
        };
        return seconds(usage.ru_utime) + seconds(usage.ru_stime);
    }

    std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
    double m_cpu = cpuNow();
};

// Tells when the file was packed and written, before it is synced and verified.
class WrittenTime final : public Progress
{
public:
    bool report(double fraction) override
    {
        if (fraction <= 0.6) {
            wall = m_watch.wall();
            cpu = m_watch.cpu();
        }
        return true;
    }

    double wall = 0;
    double cpu = 0;

private:
    Stopwatch m_watch;
};

void million8x8(benchmark::State& state)
{
    const PtxContents contents = naturalContents();
    const Files files;
    const auto set = [&state](const char* name, double value) { state.counters[name] = value; };
    for (auto _ : state) {
        const Stopwatch plainWrite;
        writePlainly(files.plain, contents);
        const double plainWriteWall = plainWrite.wall();
        const double plainWriteCpu = plainWrite.cpu();
        set("plain_write_s", plainWriteWall);
        set("plain_write_cpu_s", plainWriteCpu);

        const Stopwatch write;
        WrittenTime written;
        const Status status = writePtx(files.own, contents, {}, written);
        set("write_s", written.wall);
        set("write_cpu_s", written.cpu);
        set("write_ratio", plainWriteWall / written.wall);
        set("verified_s", write.wall());
        set("verified_cpu_s", write.cpu());
        set("verified_ratio", plainWriteWall / write.wall());
        if (!status) {
            state.SkipWithError(status.error().message.c_str());
            return;
        }
        set("size_ratio",
            static_cast<double>(fs::file_size(files.own)) /
                static_cast<double>(fs::file_size(files.plain)));
        set("MB", static_cast<double>(fs::file_size(files.own)) / 1e6);

        const Stopwatch plainRead;
        benchmark::DoNotOptimize(readPlainly(files.plain));
        const double plainReadWall = plainRead.wall();
        set("plain_read_s", plainReadWall);
        set("plain_read_cpu_s", plainRead.cpu());

        const Stopwatch read;
        NoProgress progress;
        const auto back = readPtx(files.own, progress);
        set("read_s", read.wall());
        set("read_cpu_s", read.cpu());
        set("read_ratio", plainReadWall / read.wall());
        benchmark::DoNotOptimize(back);
    }
}

} // namespace

BENCHMARK(million8x8)->Iterations(1)->UseRealTime()->Unit(benchmark::kSecond);
