// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>
#include <QSignalSpy>
#include <QTest>

#include "tests/ui/fixtures.h"
#include "ui/document/document.h"
#include "ui/document/face_selection.h"

#include <algorithm>
#include <memory>
#include <random>
#include <set>

namespace trixel::ui {

namespace {

using Faces = std::set<FaceId>;

/// The same as `FaceSelection::grow`, face by face.
Faces grown(const Adjacency& adjacency, const Faces& faces)
{
    Faces all = faces;
    for (const FaceId face : faces) {
        for (const LocalEdge edge : kLocalEdges) {
            if (const auto across = adjacency.neighbour(face, edge)) {
                all.insert(across->face);
            }
        }
    }
    return all;
}

} // namespace

class FaceSelectionTest : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        m_document = std::make_unique<Document>();
        m_document->open(gridProject(11, 0), {}, "grid"); // 242 faces: no multiple of a word's bits
        m_selection = std::make_unique<FaceSelection>(*m_document);
    }
    void cleanup()
    {
        m_selection.reset();
        m_document.reset();
    }

    void everyCommandDoesWhatSetsOfFacesDo()
    {
        const Adjacency& adjacency = m_document->surface()->adjacency();
        std::mt19937 random(5);
        for (const double share : {0.0, 0.01, 0.1, 0.2, 0.5, 0.9, 0.99, 1.0}) {
            for (int round = 0; round < 20; ++round) {
                const Faces faces = some(random, share);
                const Faces others = some(random, 0.1);
                set(faces);
                QVERIFY(selected() == faces);
                m_selection->grow();
                QVERIFY(selected() == grown(adjacency, faces));

                set(faces);
                m_selection->invert();
                Faces rest = all();
                std::erase_if(rest, [&](FaceId face) { return faces.contains(face); });
                QVERIFY(selected() == rest);
                m_selection->invert();
                QVERIFY(selected() == faces);

                m_selection->add({others.begin(), others.end()});
                Faces both = faces;
                both.insert(others.begin(), others.end());
                QVERIFY(selected() == both);
                m_selection->remove({others.begin(), others.end()});
                std::erase_if(both, [&](FaceId face) { return others.contains(face); });
                QVERIFY(selected() == both);
            }
        }
        m_selection->selectAll();
        QVERIFY(selected() == all());
    }

    void facesThatDoNotExistAreLeftOut()
    {
        const std::vector<FaceId> odd{FaceId{241}, FaceId{242}, FaceId{7}, FaceId{7}, FaceId{~0U}};
        m_selection->set(odd);
        QVERIFY(selected() == (Faces{FaceId{7}, FaceId{241}}));
        m_selection->remove({FaceId{7}, FaceId{5000}});
        m_selection->add(odd);
        QVERIFY(selected() == (Faces{FaceId{7}, FaceId{241}}));
    }

    void onlyChangesAreToldOf()
    {
        QSignalSpy changed(m_selection.get(), &FaceSelection::changed);
        m_selection->clear();
        m_selection->grow();
        m_selection->remove({FaceId{3}});
        m_selection->add(std::vector<FaceId>());
        QCOMPARE(changed.count(), 0);
        m_selection->selectAll();
        m_selection->selectAll();
        m_selection->grow();
        QCOMPARE(changed.count(), 1);
    }

    void aSnapshotStaysAsItWas()
    {
        m_selection->set({FaceId{3}, FaceId{9}});
        const auto before = m_selection->snapshot();
        m_selection->selectAll();
        QVERIFY(*before == (std::vector{FaceId{3}, FaceId{9}}));
    }

    void withoutADocumentThereIsNothingToSelect()
    {
        Document closed;
        FaceSelection nothing(closed);
        nothing.selectAll();
        nothing.invert();
        nothing.grow();
        nothing.add({FaceId{0}});
        QVERIFY(nothing.isEmpty());
    }

private:
    void set(const Faces& faces) { m_selection->set({faces.begin(), faces.end()}); }
    /// Checked to be in order.
    Faces selected() const
    {
        const auto faces = m_selection->faces();
        Faces found(faces.begin(), faces.end());
        return std::ranges::equal(found, faces) ? found : Faces{FaceId{~0U}};
    }
    Faces all() const
    {
        Faces faces;
        for (std::size_t k = 0; k < m_document->texels().faceCount(); ++k) {
            faces.insert(faceId(k));
        }
        return faces;
    }
    Faces some(std::mt19937& random, double share) const
    {
        std::bernoulli_distribution chosen(share);
        Faces faces = all();
        std::erase_if(faces, [&](FaceId) { return !chosen(random); });
        return faces;
    }

    std::unique_ptr<Document> m_document;
    std::unique_ptr<FaceSelection> m_selection;
};

} // namespace trixel::ui

QTEST_MAIN(trixel::ui::FaceSelectionTest)
#include "tst_face_selection.moc"
