// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/speed/peers/ptex_peer.h"

#include "core/io/ptx.h"
#include "core/study/speed/peers/peer_files.h"
#include "core/study/speed/peers/peer_module.h"

#include <array>
#include <system_error>

namespace trixel {
namespace {

using peers::FaceTexture;

struct Textures
{
    std::shared_ptr<const TemporaryFolder> folder; // goes last
    std::vector<std::unique_ptr<const FaceTexture>> textures;
};

class PreparedFaces final : public PreparedQueries
{
public:
    /// \param patch  whose faces become those of the tile; of 0 tiles: faces stay
    PreparedFaces(const FaceTexture& texture,
                  int channels,
                  const FilterQueries& queries,
                  const TestPatch& patch)
        : m_texture(texture)
        , m_channels(channels)
        , m_queries(queries)
    {
        for (const FaceId face : queries.face) {
            m_faces.push_back(
                static_cast<int>(indexOf(patch.tiles > 0 ? tileFace(face, patch) : face)));
        }
    }

    void run(const FilterResults& results) const override
    {
        m_texture.sample({m_faces.size(),
                          m_faces.data(),
                          m_queries.u.data(),
                          m_queries.v.data(),
                          m_queries.uw1.data(),
                          m_queries.vw1.data(),
                          m_queries.uw2.data(),
                          m_queries.vw2.data()},
                         m_channels,
                         results.values.data(),
                         results.stride);
    }

private:
    const FaceTexture& m_texture;
    int m_channels;
    FilterQueries m_queries;
    std::vector<int> m_faces;
};

class PtexPeer final : public Contestant
{
public:
    PtexPeer(std::shared_ptr<const Textures> textures, const std::vector<StudySubject>& subjects)
        : Contestant("Ptex library", "", std::nullopt)
        , m_textures(std::move(textures))
        , m_subjects(subjects)
    {
    }

    std::unique_ptr<PreparedQueries> prepare(std::size_t subject,
                                             const FilterQueries& queries) const override
    {
        return std::make_unique<PreparedFaces>(*m_textures->textures[subject],
                                               m_subjects[subject].scene->channels(),
                                               queries,
                                               m_subjects[subject].patch);
    }

private:
    std::shared_ptr<const Textures> m_textures;
    const std::vector<StudySubject>& m_subjects;
};

/// What the filters read, as a store of floats.
TexelStore storeOf(const FilterScene& scene)
{
    const auto channels = static_cast<std::size_t>(scene.channels());
    const TexelFormat format{TexelType::Float, static_cast<std::uint16_t>(channels), std::nullopt};
    FaceMap<Level> levels(scene.faceCount());
    for (std::size_t f = 0; f < scene.faceCount(); ++f) {
        levels[faceId(f)] = scene.level(faceId(f));
    }
    TexelStore store(format, levels, std::vector<std::byte>(format.texelBytes()));
    std::vector<float> texel(channels);
    for (std::size_t f = 0; f < scene.faceCount(); ++f) {
        const Level level = levels[faceId(f)];
        const std::span<std::byte> bytes = store.writable(faceId(f));
        for (std::uint32_t t = 0; t < level.texelCount(); ++t) {
            for (std::size_t c = 0; c < channels; ++c) {
                const int group = static_cast<int>(c) / kGroupChannels;
                texel[c] = scene.mips()
                               .texels(faceId(f), level, group)
                               .texel(static_cast<TexelIndex>(t))[c % kGroupChannels];
            }
            encode(TexelType::Float,
                   texel,
                   bytes.subspan(t * format.texelBytes(), format.texelBytes()));
        }
    }
    return store;
}

Status writeFor(const StudySubject& subject,
                const TestData* data,
                const std::filesystem::path& path,
                Progress& progress)
{
    PtxContents contents;
    if (subject.content && data != nullptr) {
        contents.texels = tileOf(*data, *subject.content, subject.patch.faces);
        contents.adjacency = tileAdjacency(subject.patch.faces);
    } else {
        contents.texels = storeOf(*subject.scene);
        contents.adjacency = subject.scene->surface().adjacency();
    }
    return writePtx(path, contents, PtxWriteOptions{}, progress);
}

Result<std::shared_ptr<const Textures>>
makeTextures(const std::vector<StudySubject>& subjects, void* symbol, Progress& progress)
{
    const auto open = reinterpret_cast<peers::OpenFaceTexture>(symbol);
    const auto folder = TemporaryFolder::make();
    if (!folder) {
        return tl::unexpected(folder.error());
    }
    const auto data = parseTestData(storedTestFiles());
    auto textures = std::make_shared<Textures>();
    textures->folder = *folder;
    for (const StudySubject& subject : subjects) {
        const auto path = (*folder)->path() / (std::to_string(textures->textures.size()) + ".ptx");
        if (const Status written = writeFor(subject, data ? &*data : nullptr, path, progress);
            !written) {
            return tl::unexpected(written.error());
        }
        std::array<char, 256> error{};
        std::unique_ptr<const FaceTexture> texture(open(path.c_str(), error.data()));
        if (!texture) {
            return contentsError(error.data());
        }
        textures->textures.push_back(std::move(texture));
    }
    return textures;
}

} // namespace

Status addPtexPeer(const std::vector<StudySubject>& subjects,
                   const std::filesystem::path& modules,
                   Progress& progress,
                   Peers& peers)
{
    const auto module = modules / "trixel_peer_ptex.so";
    std::error_code unreadable;
    if (!std::filesystem::exists(module, unreadable)) {
        peers.notes.emplace_back(
            "The reference Ptex library was not measured: it was not there when this program was "
            "built.");
        return {};
    }
    const auto symbol = moduleSymbol(module, "trixelOpenFaceTexture");
    const auto textures =
        symbol ? makeTextures(subjects, *symbol, progress) : tl::unexpected(symbol.error());
    if (textures) {
        peers.contestants.push_back(std::make_unique<PtexPeer>(*textures, subjects));
        return {};
    }
    if (textures.error().kind == ErrorKind::Cancelled) {
        return tl::unexpected(textures.error());
    }
    peers.notes.push_back("The reference Ptex library was not measured: " +
                          textures.error().message);
    return {};
}

} // namespace trixel
