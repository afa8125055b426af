// SPDX-License-Identifier: GPL-3.0-or-later
#include <QSignalSpy>
#include <QTest>

#include "core/io/project_metadata.h"
#include "core/io/ptx_metadata.h"
#include "core/study/views/project_views.h"
#include "tests/ui/fixtures.h"
#include "tests/ui/sample_views.h"
#include "ui/document/document.h"
#include "ui/document/view_bookmarks.h"

#include <array>
#include <cmath>
#include <functional>
#include <memory>

namespace trixel::ui {

class ViewBookmarksTest : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        m_document = std::make_unique<Document>();
        m_document->open(gridProject(), {}, "grid");
    }
    void cleanup() { m_document.reset(); }

    void everyChangeIsOneUndoStep_data()
    {
        using Edit = std::function<void(ViewBookmarks&)>;
        QTest::addColumn<Edit>("change");
        const auto row = [](const char* name, const Edit& change) {
            QTest::newRow(name) << change;
        };
        row("add", [](ViewBookmarks& views) { views.add(camera("c", 3)); });
        row("add distant", [](ViewBookmarks& views) { views.addDistant(distant("e", 3)); });
        row("add all", [](ViewBookmarks& views) {
            views.addAll({{camera("c", 3), camera("d", 4)}, {distant("e", 3)}});
        });
        row("replace all", [](ViewBookmarks& views) { views.replaceAll({{camera("c", 3)}, {}}); });
        row("rename", [](ViewBookmarks& views) { views.rename(1, "other"); });
        row("rename distant", [](ViewBookmarks& views) { views.rename(2, "other"); });
        row("update", [](ViewBookmarks& views) { views.update(0, camera("", 9)); });
        row("update distant", [](ViewBookmarks& views) { views.update(2, distant("", 9)); });
        row("remove", [](ViewBookmarks& views) { views.remove(0); });
        row("remove distant", [](ViewBookmarks& views) { views.remove(2); });
    }
    void everyChangeIsOneUndoStep()
    {
        QFETCH(std::function<void(ViewBookmarks&)>, change);
        const SceneViews before = fill();
        QUndoStack& stack = m_document->undoStack();
        const int steps = stack.count();
        m_document->markSaved("/tmp/grid.trixel", m_document->state());
        QSignalSpy changed(&views(), &ViewBookmarks::changed);
        change(views());
        QCOMPARE(stack.count(), steps + 1);
        QCOMPARE(changed.count(), 1);
        QVERIFY(m_document->isModified());
        const SceneViews after = views().views();
        QVERIFY(after != before);
        QVERIFY(viewsOf(m_document->snapshot()).value() == after);
        stack.undo();
        QVERIFY(views().views() == before);
        QVERIFY(!m_document->isModified());
        QVERIFY(viewsOf(m_document->snapshot()).value() == before);
        stack.redo();
        QVERIFY(views().views() == after);
        QVERIFY(m_document->isModified());
        QCOMPARE(changed.count(), 3);
    }

    void camerasAreNumberedBeforeDistantViews()
    {
        views().addDistant(distant("far", 3));
        views().add(camera("near", 1));
        QCOMPARE(views().count(), 2);
        QCOMPARE(views().name(0), QString("near"));
        QVERIFY(!views().isDistant(0));
        QCOMPARE(views().name(1), QString("far"));
        QVERIFY(views().isDistant(1));
    }

    void aViewWithoutANameGetsAFreeOne()
    {
        views().add(camera("", 1));
        views().add(camera("View 3", 2));
        views().addDistant(distant(" \n", 3));
        views().add(camera("", 4));
        QCOMPARE(views().name(0), QString("View 1"));
        QCOMPARE(views().name(2), QString("View 2"));
        QCOMPARE(views().name(3), QString("Any view 1"));
    }

    void namesAreOneLineOfBoundedLength()
    {
        views().add(camera("a\nb\t c", 1));
        QCOMPARE(views().name(0), QString("a b c"));
        views().rename(0, QString(5000, 'x'));
        QCOMPARE(views().name(0).size(), qsizetype(ViewBookmarks::kLongestName));
    }

    void whatChangesNothingIsNoStep()
    {
        fill();
        const int steps = m_document->undoStack().count();
        views().rename(0, "a");
        views().rename(0, "  ");
        views().update(0, views().views().cameras[0]);
        views().addAll(views().views());
        views().replaceAll(views().views());
        QCOMPARE(m_document->undoStack().count(), steps);
    }

    void unusableViewsAreRefusedWithASentence()
    {
        const SceneViews before = fill();
        QSignalSpy notice(m_document.get(), &Document::notice);
        ViewCamera nowhere = camera("nowhere", 1);
        nowhere.target = nowhere.position;
        QVERIFY(!views().add(nowhere));
        ViewCamera tooFar = camera("too far", 1e19); // could not be read back
        QVERIFY(!views().update(0, tooFar));
        QVERIFY(!views().addDistant(distant("none", std::nan(""))));
        QVERIFY(!views().addAll({{nowhere}, {}}));
        SceneViews many;
        many.distant.resize(kMostProjectViews + 1);
        QVERIFY(!views().replaceAll(many));
        QCOMPARE(notice.count(), 5);
        for (const QList<QVariant>& call : notice) {
            QVERIFY(call.at(0).toString().endsWith('.'));
        }
        QVERIFY(views().views() == before);
        Document closed;
        QVERIFY(!closed.bookmarks().add(camera("a", 1)));
    }

    void viewsDoNotChangeWhatTexelsWereMadeFor()
    {
        const StateId state = m_document->state();
        TexelStore texels = m_document->texels();
        const std::vector<std::byte> red{std::byte{255}, std::byte{0}, std::byte{0}};
        TexelPatch patch = trixel::fillFaces(texels, std::array{FaceId{0}}, red);
        patch.swap(texels); // now it holds the texels to come
        views().add(camera("meanwhile", 1));
        QVERIFY(m_document->state() != state);
        QVERIFY(m_document->applyPatch(std::move(patch), state, "Fill"));
        QCOMPARE(int(m_document->texels().face(FaceId{0}).texel(0)[0]), 255);
    }

    void paintingAndBookmarkingShareOneHistory()
    {
        const StateId opened = m_document->state();
        views().add(camera("a", 1));
        const StateId bookmarked = m_document->state();
        m_document->fillFaces(std::array{FaceId{3}}, {1, 0, 0, 1});
        const StateId painted = m_document->state();
        views().add(camera("b", 2));
        QVERIFY(opened != bookmarked && bookmarked != painted && painted != m_document->state());
        QCOMPARE(m_document->state().texels, painted.texels);
        QUndoStack& stack = m_document->undoStack();
        stack.undo();
        QVERIFY(m_document->state() == painted);
        stack.undo();
        QVERIFY(m_document->state() == bookmarked);
        QCOMPARE(views().count(), 1);
        stack.undo();
        QVERIFY(m_document->state() == opened);
        QVERIFY(views().isEmpty());
        QVERIFY(!m_document->isModified());
    }

    void aStrokeInProgressEndsBeforeABookmark()
    {
        Brush brush;
        brush.radius = 0.1F;
        brush.color = {1, 0, 0, 1};
        m_document->beginStroke(brush);
        m_document->extendStroke({FaceId{0}, {0.3F, 0.3F}, 1.0F, 0.0});
        views().add(camera("a", 1));
        QVERIFY(!m_document->hasStroke());
        QCOMPARE(m_document->undoStack().count(), 2);
    }

    void anotherProjectBringsItsOwn()
    {
        fill();
        Project other = gridProject();
        const SceneViews kept{{camera("kept", 7)}, {}};
        keepViews(other, kept);
        QSignalSpy changed(&views(), &ViewBookmarks::changed);
        m_document->open(other, {}, "other");
        QVERIFY(views().views() == kept);
        QVERIFY(!m_document->isModified());
        m_document->open(gridProject(), {}, "none");
        QVERIFY(views().isEmpty());
        QCOMPARE(changed.count(), 2);
    }

    void viewsThatCannotBeReadAreLeftOutWithAWarning()
    {
        Project damaged = gridProject();
        putMetadata(damaged.metadata, {kViewsKey, std::string("{\"version\":1,")});
        QSignalSpy notice(m_document.get(), &Document::notice);
        m_document->open(damaged, {}, "damaged");
        QVERIFY(m_document->isOpen());
        QVERIFY(views().isEmpty());
        QCOMPARE(notice.count(), 1);
        QVERIFY(notice.at(0).at(0).toString().contains("damaged"));
        // They stay in the file as they are until views are bookmarked.
        QVERIFY(!viewsOf(m_document->snapshot()).has_value());
        QVERIFY(views().add(camera("new", 1)));
        QVERIFY(viewsOf(m_document->snapshot()).value() == views().views());
    }

private:
    ViewBookmarks& views() { return m_document->bookmarks(); }

    SceneViews fill()
    {
        views().replaceAll({{camera("a", 1), camera("b", 2)}, {distant("far", 5)}});
        return views().views();
    }

    std::unique_ptr<Document> m_document;
};

} // namespace trixel::ui

QTEST_MAIN(trixel::ui::ViewBookmarksTest)
#include "tst_view_bookmarks.moc"
