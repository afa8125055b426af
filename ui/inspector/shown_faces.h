// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QThreadPool>

#include "core/texture/coarser_levels.h"
#include "core/texture/texel_store.h"
#include "ui/inspector/face_painter.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace trixel::ui {

struct Change;
class Document;
class Inspection;
class ViewSettings;

/// Which texels are shown, and each face at which level, at most its own.
struct FaceSource
{
    std::function<const TexelStore&()> texels;
    std::function<Level(FaceId)> level;
};

/// The document's faces as a panel draws them: at the level shown, with the look of the view, at
/// any scale. Keeps colours and coarser levels of the few faces that were drawn last and follows
/// what is painted on them. Levels of large faces are reduced in the background; until they are
/// there a face drawn small shows some of its texels instead of the mean of all.
class ShownFaces : public QObject
{
    Q_OBJECT

public:
    ShownFaces(const Document& document,
               const ViewSettings& settings,
               const Inspection& inspection,
               QObject* parent = nullptr);
    /// Of other texels of the same surface, or of other levels.
    ShownFaces(const Document& document,
               const ViewSettings& settings,
               FaceSource source,
               QObject* parent = nullptr);
    ~ShownFaces() override;

    /// Of a face as shown, levels dropped included.
    Level level(FaceId face) const;

    /// As `paintTexels`, of a level that suits the layout's size.
    void paint(QImage& image,
               const QRect& clip,
               const FaceLayout& layout,
               FaceId face,
               const TexelPaint& paint = {});

    /// Texels at the level shown; null while they are being reduced. Until the next call.
    const FaceTexels* texels(FaceId face);
    /// Premultiplied colour of a texel at the level shown; nothing while that is being reduced.
    std::optional<QRgb> color(FaceId face, TexelCoord texel);

    /// Reduces here and now what else would come from the background: for pictures.
    void complete(FaceId face);
    /// Nobody looks: forgets all, and follows nothing until the next call.
    void rest();

signals:
    /// Faces look different from when they were drawn.
    void changed();

private:
    struct Entry
    {
        FaceId face{};
        Level base;
        std::uint64_t lastUsed = 0;
        std::optional<CoarserLevels> coarser;
        /// Of the levels that are drawn instead of coarser ones still to come.
        std::optional<FaceTexels> sampled;
        std::shared_ptr<std::atomic<bool>> wanted; ///< set while they are reduced elsewhere
        std::vector<TouchedRect> since;            ///< what changed meanwhile
        std::array<std::unique_ptr<ShadedTexels>, Level::kMax + 1> shades;
    };

    Entry& entry(FaceId face);
    bool haveCoarser(Entry& entry, bool now);
    void reduceElsewhere(Entry& entry);
    void takeCoarser(FaceId face, const std::atomic<bool>* job, CoarserLevels levels);
    const FaceTexels& texelsToDraw(Entry& entry, Level level);
    ShadedTexels& shades(Entry& entry, Level level);
    void takeChange(const Change& change);
    bool touch(Entry& entry, const TouchedRect& rect);
    static void forgetCoarserShades(Entry& entry);
    static void forget(Entry& entry);
    void forgetAll();
    void forgetLook();

    FaceSource m_source;
    const ViewSettings& m_settings;
    std::vector<std::unique_ptr<Entry>> m_entries;
    std::uint64_t m_uses = 0;
    QThreadPool m_pool;
};

} // namespace trixel::ui
