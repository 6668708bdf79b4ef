#include "planner/project/project_edits.h"
#include "tests/support/patience.h"
#include "tests/support/test_program.h"
#include "tests/ui/shell/drawn_boundary.h"
#include "ui/shell/session.h"

#include <QAbstractItemModelTester>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace furrow;
using test::drawnRectangle;

namespace {

QString twoFields() {
    return QStringLiteral(R"({"type": "FeatureCollection", "features": [
        {"type": "Feature", "properties": {"id": "a", "name": "North"}, "geometry": {"type": "Polygon", "coordinates":
          [[[22.5, 58.25], [22.505, 58.25], [22.505, 58.252], [22.5, 58.252], [22.5, 58.25]]]}},
        {"type": "Feature", "properties": {"id": "b", "name": "South"}, "geometry": {"type": "Polygon", "coordinates":
          [[[22.5, 58.24], [22.503, 58.24], [22.503, 58.242], [22.5, 58.242], [22.5, 58.24]]]}}]})");
}

QString written(const QTemporaryDir& folder, const QString& name, const QString& text) {
    const QString path = folder.filePath(name);
    QFile file{path};
    if (!file.open(QIODevice::WriteOnly) || file.write(text.toUtf8()) < 0) {
        qFatal("the test file cannot be written");
    }
    return path;
}

}  // namespace

/// Files that are opened, remembered, and written.
class TestSessionFiles : public QObject {
    Q_OBJECT

private slots:
    void aFileWithSeveralFieldsAsks() {
        const QTemporaryDir folder;
        Session session;
        session.opener()->open(written(folder, QStringLiteral("two.geojson"), twoFields()));
        QTRY_COMPARE_WITH_TIMEOUT(session.planning()->state(), PlanState::Choosing, kPatienceMs);
        QCOMPARE(session.opener()->choices()->rowCount(), 2);
        session.opener()->chooseField(1);
        QTRY_COMPARE_WITH_TIMEOUT(session.planning()->state(), PlanState::Ready, kPatienceMs);
        QCOMPARE(session.farm()->fieldName(), QStringLiteral("South"));
        session.opener()->open(written(folder, QStringLiteral("two.geojson"), twoFields()),
                               QStringLiteral("a"));
        QTRY_COMPARE_WITH_TIMEOUT(session.farm()->fieldName(), QStringLiteral("North"), kPatienceMs);
    }
    void allOfThemCanBeOpened() {
        const QTemporaryDir folder;
        Session session;
        session.opener()->open(written(folder, QStringLiteral("two.geojson"), twoFields()));
        QTRY_COMPARE_WITH_TIMEOUT(session.planning()->state(), PlanState::Choosing, kPatienceMs);
        session.opener()->chooseAll();
        QTRY_COMPARE_WITH_TIMEOUT(session.planning()->state(), PlanState::Ready, kPatienceMs);
        QCOMPARE(session.farm()->fields().size(), 2);
        QCOMPARE(session.farm()->fieldName(), QStringLiteral("North"));
        QSignalSpy opened{session.planning(), &Planning::fieldOpened};
        session.farm()->setCurrentField(1);
        QCOMPARE(session.farm()->fieldName(), QStringLiteral("South"));
        QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, kPatienceMs);
        session.document()->undo();
        QVERIFY(!session.farm()->hasField());
    }
    void severalFilesAreOpenedAtOnce() {
        const QTemporaryDir folder;
        Session session;
        Project farm = withFields(
            Project::empty(),
            {FieldSource{
                .id = "1",
                .name = "Barn",
                .origin = {},
                .parts = {{.outer = {{22.5, 58.25}, {22.507, 58.25}, {22.507, 58.2535}}, .holes = {}}},
                .obstacles = {},
                .gates = {},
                .boundaryAccuracy = {},
                .repairs = {}}});
        const QString project = folder.filePath(QStringLiteral("farm.furrow"));
        QVERIFY(writeProject(farm, project.toStdU16String()).has_value());
        const QUrl boundaries =
            QUrl::fromLocalFile(written(folder, QStringLiteral("two.geojson"), twoFields()));
        QVERIFY(session.opener()->isProjectFile(QUrl::fromLocalFile(project)));
        QVERIFY(!session.opener()->isProjectFile(boundaries));
        session.opener()->openUrls({boundaries, QUrl::fromLocalFile(project)});
        QTRY_COMPARE_WITH_TIMEOUT(session.farm()->fields().size(), 3, kPatienceMs);
        QTRY_COMPARE_WITH_TIMEOUT(session.planning()->state(), PlanState::Ready, kPatienceMs);
        QCOMPARE(session.files()->name(), QStringLiteral("farm"));
        QCOMPARE(session.recent()->count(), 1);
        QVERIFY2(session.document()->isModified(), "the boundaries are not in the file yet");
        QVERIFY(session.farm()->fields().front().startsWith(QStringLiteral("Barn")));
    }
    void recentFilesAreKept() {
        const QTemporaryDir folder;
        const QString list = folder.filePath(QStringLiteral("recent.json"));
        {
            RecentFiles recent;
            QAbstractItemModelTester tester{&recent};
            recent.keepIn(list);
            for (int i = 0; i < 12; ++i) {
                recent.add(written(folder, QStringLiteral("%1.furrow").arg(i), QStringLiteral("x")),
                           Project::empty());
            }
            recent.add(folder.filePath(QStringLiteral("5.furrow")), Project::empty());
            QCOMPARE(recent.count(), 10);
        }
        QVERIFY(QFile::remove(folder.filePath(QStringLiteral("11.furrow"))));
        RecentFiles recent;
        recent.keepIn(list);
        QCOMPARE(recent.count(), 9);
        QCOMPARE(recent.data(recent.index(0), RecentFiles::NameRole).toString(), QStringLiteral("5"));
    }
    void anUnreadableFileIsTold() {
        Session session;
        session.opener()->open(QStringLiteral("/nowhere/field.geojson"));
        QTRY_COMPARE_WITH_TIMEOUT(session.planning()->state(), PlanState::Failed, kPatienceMs);
        QVERIFY(!session.problem()->text().isEmpty());
        QVERIFY(!session.farm()->hasField());
    }
    void sampleFieldsOpen_data() {
        QTest::addColumn<int>("index");
        Session session;
        for (int i = 0; i < session.opener()->sampleNames().size(); ++i) {
            QTest::newRow(qPrintable(session.opener()->sampleNames().at(i))) << i;
        }
    }
    void sampleFieldsOpen() {
        QFETCH(int, index);
        Session session;
        session.opener()->openSample(index);
        QTRY_VERIFY_WITH_TIMEOUT(isFinished(session.planning()->state()), kPatienceMs);
        QCOMPARE(session.farm()->fieldName(), session.opener()->sampleNames().at(index));
        session.findings()->setAll(true);
        int shown = 0;
        for (int row = 0; row < session.findings()->rowCount(); ++row) {
            shown += session.findings()->index(row).data(FindingsModel::KindCountRole).toInt();
        }
        QCOMPARE(shown, static_cast<int>(session.shown()->plan()->findings.size()));
        session.findings()->setAll(false);
        QVERIFY(session.findings()->rowCount() <= session.findings()->few());
    }
    void exportWritesAFolder() {
        const QTemporaryDir folder;
        Session session;
        session.opener()->addDrawn(drawnRectangle());
        QTRY_COMPARE_WITH_TIMEOUT(session.planning()->state(), PlanState::Ready, kPatienceMs);
        const QString target = folder.filePath(QStringLiteral("plan one"));
        session.exporter()->writeTo(target);
        QTRY_COMPARE_WITH_TIMEOUT(session.exporter()->state(), ExportModel::State::Done, kPatienceMs);
        QVERIFY(QFile::exists(target + QStringLiteral("/summary.json")));
        QVERIFY(QFile::exists(target + QStringLiteral("/plan.geojson")));
        // A folder cannot be made below a file.
        session.exporter()->writeTo(target + QStringLiteral("/summary.json/below"));
        QTRY_COMPARE_WITH_TIMEOUT(session.exporter()->state(), ExportModel::State::Failed, kPatienceMs);
        QVERIFY(!session.exporter()->message().isEmpty());
    }
    void aFileThatCannotBeReadLeavesThePlan() {
        Session session;
        session.opener()->addDrawn(drawnRectangle());
        QTRY_COMPARE_WITH_TIMEOUT(session.planning()->state(), PlanState::Ready, kPatienceMs);
        session.opener()->open(QStringLiteral("/nowhere/field.geojson"));
        QCOMPARE(session.planning()->state(), PlanState::Reading);
        QVERIFY(!session.exporter()->refusal().isEmpty());
        QTRY_COMPARE_WITH_TIMEOUT(session.planning()->state(), PlanState::Ready, kPatienceMs);
        QVERIFY(!session.problem()->text().isEmpty());
        QVERIFY(session.exporter()->refusal().isEmpty());
        session.problem()->dismiss();
        QVERIFY(session.problem()->text().isEmpty());
    }
    void aWriteOfAPlanThatBecameAnotherIsStopped() {
        const QTemporaryDir folder;
        Session session;
        session.opener()->addDrawn(drawnRectangle());
        QTRY_COMPARE_WITH_TIMEOUT(session.planning()->state(), PlanState::Ready, kPatienceMs);
        session.exporter()->writeTo(folder.filePath(QStringLiteral("out")));
        QCOMPARE(session.exporter()->state(), ExportModel::State::Writing);
        session.planning()->machine()->setLibraryIndex(3);
        QCOMPARE(session.exporter()->state(), ExportModel::State::Failed);
        QVERIFY(!session.exporter()->message().isEmpty());
        QTRY_VERIFY_WITH_TIMEOUT(isFinished(session.planning()->state()), kPatienceMs);
        QCOMPARE(session.exporter()->state(), ExportModel::State::Failed);
    }
};

FURROW_TEST(TestSessionFiles);
#include "tst_session_files.moc"
