// SPDX-License-Identifier: GPL-3.0-or-later
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "core/io/ptx_reader.h"
#include "tests/ui/document/layered_fixture.h"
#include "ui/document/document.h"
#include "ui/document/stored_faces_watch.h"

#include <fstream>
#include <random>

namespace trixel::ui {

namespace {

constexpr std::uint64_t kFaceBytes = 64 * 3;

/// A .ptx of noise on the square's mesh.
std::filesystem::path noisyPtx(const QTemporaryDir& folder)
{
    NoProgress progress;
    Project project = gridProject();
    std::mt19937 random(1);
    for (std::uint32_t f = 0; f < project.texels.faceCount(); ++f) {
        for (std::byte& b : project.texels.writable(faceId(f))) {
            b = static_cast<std::byte>(random());
        }
    }
    const std::filesystem::path path = folder.filePath("noisy.ptx").toStdString();
    const Status written = exportPtx(path, project, {}, progress);
    return written ? path : std::filesystem::path();
}

void damageFace(const std::filesystem::path& path, FaceId face)
{
    MemoryBudget budget;
    const PtxBlock block = openPtxFile(path, budget)->block(face, 0).value();
    std::fstream out(path, std::ios::in | std::ios::out | std::ios::binary);
    out.seekp(static_cast<std::streamoff>(block.offset));
    out.write("damaged", 7);
}

} // namespace

class StoredFacesWatchTest : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_path = noisyPtx(*m_folder);
        m_document = std::make_unique<Document>();
    }

    void aFaceThatCannotBeReadIsToldOnce()
    {
        damageFace(m_path, faceId(7));
        damageFace(m_path, faceId(8));
        open({.wholeBytes = 0});
        QSignalSpy notices(m_document.get(), &Document::notice);
        m_watch->look();
        QCOMPARE(notices.count(), 0); // nobody asked for it
        QVERIFY(m_document->texels().face(faceId(7)).pinned().isDamaged());
        m_watch->look();
        m_watch->look();
        QCOMPARE(notices.count(), 1);
        const QString sentence = notices.at(0).at(0).toString();
        QVERIFY2(sentence.contains("Face 7 cannot be read"), qPrintable(sentence));
        QVERIFY2(sentence.contains("noisy.ptx"), qPrintable(sentence));
        QVERIFY(!sentence.contains(m_folder->path()));
        QVERIFY(m_document->texels().face(faceId(8)).pinned().isDamaged());
        QTRY_COMPARE(notices.count(), 2); // by the timer
    }

    void aLayerLeavesTheBaseInTheFileButUnderPaint()
    {
        open({.wholeBytes = 0, .cacheBytes = 4 * kFaceBytes});
        const StoredFaces& faces = *m_document->storedFaces();
        const LayerId layer = addLayer(*m_document, "Layer 1");
        QCOMPARE(faces.readBytes(), std::uint64_t{0});
        Brush brush;
        brush.radius = 0.02F;
        m_document->beginStroke(brush);
        m_document->extendStroke({faceId(20), {0.3F, 0.3F}, 1, 0});
        m_document->endStroke();
        QVERIFY(faces.readBytes() > 0);
        QVERIFY(faces.readBytes() <= 3 * kFaceBytes);
        QVERIFY(setOpacity(*m_document, layer, 0.5F));
        QVERIFY(faces.readBytes() <= 6 * kFaceBytes); // under paint alone, once more
        QVERIFY(m_document->layers().base().face(faceId(20)).isStored());
        const TexelStore& shown = m_document->texels();
        for (std::uint32_t f = 0; f < shown.faceCount(); ++f) {
            QCOMPARE(shown.face(faceId(f)).bytes().size(), kFaceBytes);
        }
        m_watch->look();
        QVERIFY(faces.heldBytes() <= 4 * kFaceBytes);
        QVERIFY(shown.face(faceId(3)).sharesBytesWith(
            m_document->layers().base().face(faceId(3)))); // one face still
        QVERIFY(isShown(*m_document));
    }

    void whatIsHeldBeyondTheCachesBudgetIsGivenBack()
    {
        open({.wholeBytes = 0, .cacheBytes = 10 * kFaceBytes});
        const StoredFaces& faces = *m_document->storedFaces();
        const TexelStore& texels = m_document->texels();
        for (std::uint32_t f = 0; f < 10; ++f) {
            QCOMPARE(texels.face(faceId(f)).bytes().size(), kFaceBytes);
        }
        m_watch->look();
        QCOMPARE(faces.heldBytes(), 10 * kFaceBytes);
        QCOMPARE(texels.face(faceId(10)).bytes().size(), kFaceBytes);
        Brush brush;
        m_document->beginStroke(brush);
        m_watch->look(); // a stroke looks at what was there before it
        QCOMPARE(faces.heldBytes(), 11 * kFaceBytes);
        m_document->endStroke();
        m_watch->look();
        QCOMPARE(faces.heldBytes(), std::uint64_t{0});
    }

    void ofFilesReadAtOnceThereIsNothingToWatch()
    {
        open({});
        QCOMPARE(m_document->storedFaces(), nullptr);
        m_watch->look();
    }

    void aFaceIsPaintedAndThePaintIsTakenBack()
    {
        open({.wholeBytes = 0});
        const auto before = allTexels(m_document->texels());
        Brush brush;
        brush.radius = 0.2F;
        brush.color = {1, 0, 0, 1};
        m_document->beginStroke(brush);
        m_document->extendStroke({faceId(20), {0.3F, 0.3F}, 1.0F, 0});
        m_document->endStroke();
        QVERIFY(!m_document->texels().face(faceId(20)).isStored());
        QVERIFY(m_document->texels().face(faceId(100)).isStored());
        QVERIFY(allTexels(m_document->texels()) != before);
        m_document->undoStack().undo();
        QVERIFY(allTexels(m_document->texels()) == before);
    }

private:
    void open(const OpenOptions& options)
    {
        NoProgress progress;
        m_document->open(openPtx(m_path, progress, options).value(), {}, "noisy");
        m_watch = m_document->findChild<StoredFacesWatch*>();
        QVERIFY(m_watch != nullptr);
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::filesystem::path m_path;
    std::unique_ptr<Document> m_document;
    StoredFacesWatch* m_watch = nullptr;
};

} // namespace trixel::ui

QTEST_MAIN(trixel::ui::StoredFacesWatchTest)
#include "tst_stored_faces_watch.moc"
