// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/speed/peers/picture_peer.h"

#include "core/study/speed/peers/atlas.h"
#include "core/study/speed/peers/peer_files.h"

#include <array>
#include <string>

namespace trixel {
namespace {

/// A box has the variance of the Gaussian that the filters mean by a footprint when it is √12 / 2
/// times as wide: what suits the library best.
constexpr float kKernelWidth = 1.7320508F;

using peers::PictureFilter;
using peers::PictureTexture;

/// What all contestants of the library read.
struct Pictures
{
    std::shared_ptr<const TemporaryFolder> folder; // goes last
    std::vector<std::unique_ptr<const Atlas>> atlases;
    std::vector<std::unique_ptr<const PictureTexture>> textures;
};

class PreparedSamples final : public PreparedQueries
{
public:
    PreparedSamples(const PictureTexture& texture,
                    const PictureFilter& filter,
                    AtlasSamples samples)
        : m_texture(texture)
        , m_filter(filter)
        , m_samples(std::move(samples))
    {
    }

    void run(const FilterResults& results) const override
    {
        m_texture.sample(m_samples.samples(), m_filter, results.values.data(), results.stride);
    }

private:
    const PictureTexture& m_texture;
    const PictureFilter& m_filter;
    AtlasSamples m_samples;
};

class PicturePeer final : public Contestant
{
public:
    PicturePeer(std::string series,
                std::string variant,
                const PictureFilter& filter,
                std::shared_ptr<const Pictures> pictures,
                const std::vector<StudySubject>& subjects)
        : Contestant(std::move(series), std::move(variant), std::nullopt)
        , m_filter(filter)
        , m_pictures(std::move(pictures))
        , m_subjects(subjects)
    {
    }

    std::unique_ptr<PreparedQueries> prepare(std::size_t subject,
                                             const FilterQueries& queries) const override
    {
        return std::make_unique<PreparedSamples>(
            *m_pictures->textures[subject],
            m_filter,
            m_pictures->atlases[subject]->samples(*m_subjects[subject].scene, queries));
    }

private:
    PictureFilter m_filter;
    std::shared_ptr<const Pictures> m_pictures;
    const std::vector<StudySubject>& m_subjects;
};

std::unique_ptr<const Atlas> atlasOf(const StudySubject& subject, const TestData* data)
{
    return subject.content && data != nullptr
               ? makePlanarAtlas(*data, *subject.content, subject.patch)
               : makeFaceAtlas(*subject.scene);
}

/// Fails with the reason why there are none.
Result<std::shared_ptr<const Pictures>> makePictures(const std::vector<StudySubject>& subjects,
                                                     const std::filesystem::path& modules,
                                                     Progress& progress)
{
    const auto symbol = moduleSymbol(modules / "trixel_peer_oiio.so", "trixelMakePictureTexture");
    if (!symbol) {
        return tl::unexpected(symbol.error());
    }
    const auto make = reinterpret_cast<peers::MakePictureTexture>(*symbol);
    const auto folder = TemporaryFolder::make();
    if (!folder) {
        return tl::unexpected(folder.error());
    }
    const auto data = parseTestData(storedTestFiles());
    auto pictures = std::make_shared<Pictures>();
    pictures->folder = *folder;
    for (const StudySubject& subject : subjects) {
        const std::size_t number = pictures->atlases.size();
        if (!progress.report(static_cast<double>(number) / static_cast<double>(subjects.size()))) {
            return cancelled();
        }
        auto atlas = atlasOf(subject, data ? &*data : nullptr);
        if (!atlas) {
            return contentsError("the atlas would be too large");
        }
        if (atlas->picture().channels < subject.scene->channels()) {
            return contentsError("more than four channels are not put into its atlas");
        }
        const auto own = (*folder)->path() / std::to_string(number);
        std::error_code failed;
        std::filesystem::create_directory(own, failed);
        std::array<char, 256> error{};
        std::unique_ptr<const PictureTexture> texture(
            failed ? nullptr : make(atlas->picture(), own.c_str(), error.data()));
        if (!texture) {
            return contentsError(failed ? failed.message() : error.data());
        }
        pictures->atlases.push_back(std::move(atlas));
        pictures->textures.push_back(std::move(texture));
    }
    return pictures;
}

} // namespace

Status addPicturePeer(const std::vector<StudySubject>& subjects,
                      const std::filesystem::path& modules,
                      Progress& progress,
                      Peers& peers)
{
    const auto pictures = makePictures(subjects, modules, progress);
    if (!pictures) {
        if (pictures.error().kind == ErrorKind::Cancelled) {
            return tl::unexpected(pictures.error());
        }
        peers.notes.push_back("OpenImageIO was not measured: " + pictures.error().message + ".");
        return {};
    }
    peers.notes.push_back("OpenImageIO reads " + (*pictures)->atlases.front()->about() + ".");
    for (const bool widened : {false, true}) {
        for (const int anisotropy : {1, 4, 16, 64}) {
            peers.contestants.push_back(std::make_unique<PicturePeer>(
                widened ? "OpenImageIO, widened" : "OpenImageIO",
                "anisotropy " + std::to_string(anisotropy),
                PictureFilter{anisotropy, widened ? kKernelWidth : 1.0F, false},
                *pictures,
                subjects));
        }
    }
    return {};
}

} // namespace trixel
