// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "core/io/ptx.h"
#include "tests/ui/fixtures.h"
#include "ui/document/background_job.h"
#include "ui/document/document.h"
#include "ui/document/project_files.h"

namespace trixel::ui {

namespace {

void writeFile(const QString& path, const QByteArray& bytes)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(bytes), bytes.size());
}

/// Two triangles that share an edge.
const QByteArray kSquareObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 4 3 2\n";

} // namespace

class ProjectFilesTest : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_document = std::make_unique<Document>();
        m_jobs = std::make_unique<BackgroundJobs>();
        m_files = std::make_unique<ProjectFiles>(*m_document, *m_jobs);
    }
    void cleanup()
    {
        m_files.reset();
        m_jobs.reset();
        m_document.reset();
    }

    void meshOpensWithDefaultTexelsAtOnce()
    {
        writeFile(path("square.obj"), kSquareObj);
        QSignalSpy opened(m_files.get(), &ProjectFiles::meshOpened);
        m_files->open(path("square.obj"));
        QTRY_COMPARE(opened.count(), 1);
        QCOMPARE(m_document->texels().faceCount(), 2U);
        QVERIFY(m_document->texels().texelCount() <= 4'000'000);
        QVERIFY(m_document->texels().texelCount() >= 500'000);
        QCOMPARE(m_document->title(), QString("square"));
        QVERIFY(!m_document->isModified());
    }

    void savedProjectReopensEqual()
    {
        m_document->open(gridProject(), {}, "grid");
        m_document->fillFaces(std::array{FaceId{3}, FaceId{9}}, {1, 0, 0.5F, 1});
        const std::vector<std::byte> painted = allTexels(m_document->texels());
        save("grid.trixel");
        QVERIFY(!m_document->isModified());
        QCOMPARE(m_document->path(), path("grid.trixel"));

        m_document->open(gridProject(2, 1), {}, "other");
        QSignalSpy opened(m_files.get(), &ProjectFiles::opened);
        m_files->open(path("grid.trixel"));
        QTRY_COMPARE(opened.count(), 1);
        QVERIFY(allTexels(m_document->texels()) == painted);
        QCOMPARE(m_document->title(), QString("grid.trixel"));
    }

    void saveKeepsWhatWasThereWhenItBegan()
    {
        m_document->open(gridProject(), {}, "grid");
        const std::vector<std::byte> then = allTexels(m_document->texels());
        QSignalSpy ended(m_files.get(), &ProjectFiles::saveEnded);
        m_files->save(path("grid.trixel"));
        m_document->fillFaces(std::array{FaceId{1}}, {0, 0, 0, 1}); // while it is being written
        QTRY_COMPARE(ended.count(), 1);
        QVERIFY(m_document->isModified());

        NoProgress progress;
        const Result<Project> saved = openProject(path("grid.trixel").toStdString(), progress);
        QVERIFY(saved.has_value());
        QVERIFY(allTexels(saved->texels) == then);
    }

    void saveOfAProjectThatGaveWayNamesNotItsSuccessor()
    {
        m_document->open(gridProject(), {}, "first");
        QSignalSpy ended(m_files.get(), &ProjectFiles::saveEnded);
        m_files->save(path("first.trixel"));
        m_document->open(gridProject(2, 1), {}, "second");
        QTRY_COMPARE(ended.count(), 1);
        QCOMPARE(m_document->path(), QString());
        QCOMPARE(m_document->title(), QString("second"));
    }

    void exportReadsBackEqual_data()
    {
        QTest::addColumn<int>("type");
        QTest::newRow("uint8") << 0;
        QTest::newRow("uint16") << 1;
        QTest::newRow("half") << 2;
        QTest::newRow("float") << 3;
    }
    void exportReadsBackEqual()
    {
        QFETCH(int, type);
        m_document->open(gridProject(), {}, "grid");
        m_document->fillFaces(std::array{FaceId{3}}, {1, 0, 0.5F, 1});
        QSignalSpy exported(m_files.get(), &ProjectFiles::exported);
        m_files->exportAs(
            {path("grid.ptx").toStdString(), PtxExportOptions{TexelType(type), true}, {}});
        QTRY_COMPARE(exported.count(), 1);

        NoProgress progress;
        const Result<PtxContents> contents = readPtx(path("grid.ptx").toStdString(), progress);
        QVERIFY(contents.has_value());
        QCOMPARE(int(contents->texels.format().type), type);
        QCOMPARE(contents->texels.texelCount(), m_document->texels().texelCount());
        std::array<float, 3> color{};
        decode(TexelType(type), contents->texels.face(FaceId{3}).texel(5), color);
        QCOMPARE(color[0], 1.0F);
        QCOMPARE(color[1], 0.0F);
        QVERIFY(std::abs(color[2] - 0.5F) < 0.003F);
    }

    void exportedFileOpensWithItsMesh()
    {
        m_document->open(gridProject(), {}, "grid");
        m_document->fillFaces(std::array{FaceId{3}}, {1, 0, 0, 1});
        const std::vector<std::byte> painted = allTexels(m_document->texels());
        QSignalSpy exported(m_files.get(), &ProjectFiles::exported);
        m_files->exportAs({path("grid.ptx").toStdString(), PtxExportOptions{}, {}});
        QTRY_COMPARE(exported.count(), 1);
        QSignalSpy opened(m_files.get(), &ProjectFiles::opened);
        m_files->open(path("grid.ptx"));
        QTRY_COMPARE(opened.count(), 1);
        QVERIFY(allTexels(m_document->texels()) == painted);
        QCOMPARE(m_document->surface()->mesh().faceCount(), 128U);
    }

    void ptxWithoutItsMeshAsksForIt()
    {
        const Project grid = gridProject();
        NoProgress progress;
        const PtxContents bare{grid.texels, grid.surface->adjacency(), {}, true};
        QVERIFY(writePtx(path("bare.ptx").toStdString(), bare, {}, progress).has_value());
        m_document->open(gridProject(2, 1), {}, "before");
        QSignalSpy wanted(m_files.get(), &ProjectFiles::meshWanted);
        QSignalSpy failed(m_files.get(), &ProjectFiles::failed);
        m_files->open(path("bare.ptx"));
        QTRY_COMPARE(wanted.count(), 1);
        QCOMPARE(failed.count(), 0);
        QCOMPARE(m_document->title(), QString("before"));

        // A mesh with other faces is refused with a sentence.
        writeFile(path("square.obj"), kSquareObj);
        m_files->openPtxOn(path("bare.ptx"), path("square.obj"));
        QTRY_COMPARE(failed.count(), 1);
        QCOMPARE(m_document->title(), QString("before"));

        // The right one is taken.
        QByteArray obj;
        for (const glm::vec3& p : grid.surface->mesh().positions) {
            obj += QString("v %1 %2 %3\n").arg(p.x).arg(p.y).arg(p.z).toLatin1();
        }
        for (const Triangle& t : grid.surface->mesh().triangles) {
            obj += QString("f %1 %2 %3\n").arg(t[0] + 1).arg(t[1] + 1).arg(t[2] + 1).toLatin1();
        }
        writeFile(path("grid.obj"), obj);
        QSignalSpy opened(m_files.get(), &ProjectFiles::opened);
        m_files->openPtxOn(path("bare.ptx"), path("grid.obj"));
        QTRY_COMPARE(opened.count(), 1);
        QVERIFY(allTexels(m_document->texels()) == allTexels(grid.texels));
    }

    void brokenFileLeavesTheDocumentAndSaysWhy_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("bytes");
        QTest::newRow("obj") << "bad.obj" << QByteArray("v 0 0 0\nv 1 x 0\n");
        QTest::newRow("ptx") << "bad.ptx" << QByteArray("Ptex\x01\0\0\0", 8);
        QTest::newRow("project") << "bad.trixel" << QByteArray("nonsense");
        QTest::newRow("empty") << "bad.stl" << QByteArray();
        QTest::newRow("unknown") << "bad.png" << QByteArray("\x89PNG");
        QTest::newRow("missing") << "missing.obj" << QByteArray();
    }
    void brokenFileLeavesTheDocumentAndSaysWhy()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, bytes);
        if (name != "missing.obj") {
            writeFile(path(name), bytes);
        }
        m_document->open(gridProject(), {}, "before");
        m_document->fillFaces(std::array{FaceId{3}}, {1, 0, 0, 1});
        const std::vector<std::byte> texels = allTexels(m_document->texels());
        QSignalSpy failed(m_files.get(), &ProjectFiles::failed);
        m_files->open(path(name));
        QTRY_COMPARE(failed.count(), 1);
        const QString sentence = failed.at(0).at(0).toString();
        QVERIFY2(sentence.contains(name), qPrintable(sentence));
        QVERIFY2(!sentence.contains('\n') && sentence.endsWith('.'), qPrintable(sentence));
        QVERIFY2(!sentence.contains(m_folder->path()), qPrintable(sentence));
        QCOMPARE(m_document->title(), QString("before"));
        QCOMPARE(m_document->undoStack().count(), 1);
        QVERIFY(allTexels(m_document->texels()) == texels);
    }

    void saveIntoAMissingFolderFailsAndStaysModified()
    {
        m_document->open(gridProject(), {}, "grid");
        m_document->fillFaces(std::array{FaceId{3}}, {1, 0, 0, 1});
        QSignalSpy failed(m_files.get(), &ProjectFiles::failed);
        m_files->save(path("nowhere/grid.trixel"));
        QTRY_COMPARE(failed.count(), 1);
        QVERIFY(m_document->isModified());
        QVERIFY(m_document->path().isEmpty());
    }

    void latestOfTwoOpensWins()
    {
        writeFile(path("square.obj"), kSquareObj);
        writeFile(path("one.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        QSignalSpy opened(m_files.get(), &ProjectFiles::opened);
        m_files->open(path("square.obj"));
        m_files->open(path("one.obj"));
        QTRY_VERIFY(m_jobs->isIdle());
        QCOMPARE(opened.count(), 1);
        QCOMPARE(m_document->title(), QString("one"));
    }

private:
    QString path(const QString& name) const { return m_folder->filePath(name); }
    void save(const QString& name)
    {
        QSignalSpy saved(m_files.get(), &ProjectFiles::saved);
        m_files->save(path(name));
        QTRY_COMPARE(saved.count(), 1);
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Document> m_document;
    std::unique_ptr<BackgroundJobs> m_jobs;
    std::unique_ptr<ProjectFiles> m_files;
};

} // namespace trixel::ui

QTEST_MAIN(trixel::ui::ProjectFilesTest)
#include "tst_project_files.moc"
