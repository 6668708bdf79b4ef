#include "planner/headland/methods.h"
#include "planner/io/import/boundary_import.h"
#include "planner/machine/machine_library.h"
#include "planner/project/migrations.h"
#include "planner/project/project_edits.h"
#include "planner/project/project_file.h"
#include "tests/planner/project/project_samples.h"
#include "tests/support/furrow_cli.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <sys/resource.h>

#include <csignal>

using namespace furrow;
using namespace furrow::test;

namespace {

/// Writes beyond this many bytes of a file fail, as on a full disk.
class FullDisk {
public:
    explicit FullDisk(rlim_t bytes) {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{bytes, before_.rlim_max};
        std::signal(SIGXFSZ, SIG_IGN);
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FullDisk() { ::setrlimit(RLIMIT_FSIZE, &before_); }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;

private:
    rlimit before_{};
};

std::filesystem::path pathIn(const QTemporaryDir& folder, const char* name) {
    return folder.filePath(QLatin1String{name}).toStdU16String();
}

}  // namespace

class TestProjectFile : public QObject {
    Q_OBJECT

private slots:
    void whatIsWrittenIsReadBack() {
        const Project project = sampleProject();
        const auto read = parseProject(projectText(project), "farm.furrow");
        VERIFY_RESULT(read);
        QVERIFY(read->notes.empty());
        QVERIFY(read->project == project);
        QCOMPARE(projectText(read->project), projectText(project));
        QVERIFY(isProject(projectText(project)));
    }
    void drawnLinesAreKept() {
        // Ends of numbers that need all their digits.
        const std::vector<GeoRing> splits{{{22.5, 58.251}, {22.507 + 1e-13, 58.251}},
                                          {{22.503, 58.25}, {22.5035, 58.252}, {22.503, 58.254}}};
        const Project project = withSplits(sampleProject(), splits);
        const auto read = parseProject(projectText(project), "farm.furrow");
        VERIFY_RESULT(read);
        QVERIFY(linesOf(read->project).splits == splits);
        QVERIFY(linesOf(read->project).guide == linesOf(project).guide);
        QVERIFY(!linesOf(project).guide.empty());
        QVERIFY(withSplits(read->project, {}) == sampleProject());
    }
    void imageryIsNamedFromTheProjectsFolder_data() {
        QTest::addColumn<QString>("place");
        QTest::addColumn<QString>("written");
        QTest::newRow("beside it") << "first/photo.tif"
                                   << "photo.tif";
        QTest::newRow("below it") << "first/pictures/2026/photo.tif"
                                  << "pictures/2026/photo.tif";
        QTest::newRow("in a neighbour") << "drone/photo.tif"
                                        << "../drone/photo.tif";
        QTest::newRow("on another disk") << "/mnt/disk/photo.tif"
                                         << "/mnt/disk/photo.tif";
    }
    void imageryIsNamedFromTheProjectsFolder() {
        QFETCH(QString, place);
        QFETCH(QString, written);
        const QTemporaryDir folder;
        QVERIFY(QDir{folder.path()}.mkpath(QStringLiteral("first")) &&
                QDir{folder.path()}.mkpath(QStringLiteral("moved")));
        Project project = sampleProject();
        const std::string path =
            (std::filesystem::path{folder.path().toStdString()} / place.toStdString()).string();
        project = withImagery(project, {{.path = path,
                                         .name = "Photo",
                                         .visible = false,
                                         .opacity = 0.4,
                                         .rowsFromSouth = true,
                                         .others = R"({"colour":"blue"})"}});
        VERIFY_RESULT(writeProject(project, pathIn(folder, "first/a.furrow")));
        const auto read = readProject(pathIn(folder, "first/a.furrow"));
        VERIFY_RESULT(read);
        QVERIFY(read->project == project);
        QFile file{folder.filePath(QStringLiteral("first/a.furrow"))};
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(file.readAll().contains("\"path\":\"" + written.toUtf8() + "\""));
        // Somewhere else the same words name what lies beside it there.
        QVERIFY(QDir{folder.path()}.mkpath(QStringLiteral("moved/first")));
        QVERIFY(QFile::copy(folder.filePath(QStringLiteral("first/a.furrow")),
                            folder.filePath(QStringLiteral("moved/first/a.furrow"))));
        const auto moved = readProject(pathIn(folder, "moved/first/a.furrow"));
        VERIFY_RESULT(moved);
        const std::filesystem::path there =
            place.startsWith('/')
                ? std::filesystem::path{place.toStdString()}
                : std::filesystem::path{folder.path().toStdString()} / "moved" / place.toStdString();
        QCOMPARE(moved->project.imagery.front().path, there.string());
    }
    void imageryIsAddedChangedMovedAndRemoved() {
        const ImageryLayer low{.path = "/a.tif", .name = "a", .rowsFromSouth = {}, .others = {}};
        const ImageryLayer high{.path = "/b.tif", .name = "b", .rowsFromSouth = {}, .others = {}};
        const Project project = withImagery(Project::empty(), {low, high});
        QVERIFY((project.imagery == std::vector{low, high}));
        QVERIFY((withImageryMoved(project, 0, 1).imagery == std::vector{high, low}));
        QVERIFY((withImageryMoved(project, 1, 0).imagery == std::vector{high, low}));
        QVERIFY(withImageryMoved(project, 5, 0) == project);
        QVERIFY((withoutImageryLayer(project, 0).imagery == std::vector{high}));
        QVERIFY(withoutImageryLayer(project, 2) == project);
        QVERIFY((withImageryLayer(project, 1, low).imagery == std::vector{low, low}));
    }
    void anEmptyProjectToo() {
        const auto read = parseProject(projectText(Project::empty()), "farm.furrow");
        VERIFY_RESULT(read);
        QVERIFY(read->project == Project::empty());
    }
    /// Another program says what is in it.
    void gisProgramsOpenIt() {
        const QTemporaryDir folder;
        const auto path = pathIn(folder, "farm.furrow");
        VERIFY_RESULT(writeProject(sampleProject(), path));
        QProcess ogrinfo;
        ogrinfo.start(QStringLiteral("ogrinfo"),
                      {QStringLiteral("-al"), QString::fromStdString(path.string())});
        QVERIFY(ogrinfo.waitForFinished());
        const QByteArray told = ogrinfo.readAllStandardOutput();
        QCOMPARE(ogrinfo.exitCode(), 0);
        QVERIFY(told.contains("using driver `GeoJSON' successful"));
        QVERIFY(told.contains("Feature Count: 6"));
        QVERIFY(told.contains("name (String) = Große Wiese"));
        QVERIFY(told.contains("buffer_m (Real) = 2.5"));
        QVERIFY(told.contains("POINT (22.5 58.251)"));
    }
    /// So the command line plans it as it is.
    void itIsABoundaryFileToo() {
        const QTemporaryDir folder;
        const auto path = pathIn(folder, "farm.furrow");
        VERIFY_RESULT(writeProject(sampleProject(), path));
        const auto fields = readBoundaries(path);
        VERIFY_RESULT(fields);
        QCOMPARE(fields->size(), std::size_t{2});
        QVERIFY(fields->front().parts == sampleSource().parts);
    }
    void whatIsNotKnownIsKept() {
        const std::string text = R"({"type": "FeatureCollection", "crs_note": [1, 2],
          "furrow_project": {"format_version": 1, "name": "Farm", "crop_rotation": {"2027": "oats"},
            "standard": {"id": "standard", "machine": {"operating_width_m": 4, "min_turning_radius_m": 5}},
            "plans": [{"id": "p", "field": "f", "name": "Drilling", "yield_t": 7.5,
              "machine": {"operating_width_m": 3, "min_turning_radius_m": 5, "flux_m": 4},
              "settings": {"headland.width_m": 20, "swaths.magic": 3, "route.method": "telepathy"}}]},
          "features": [
            {"type": "Feature", "id": 5, "properties": {"kind": "field", "field": "f", "name": "A", "soil": "clay"},
             "geometry": {"type": "Polygon", "coordinates": [[[22.5, 58.25], [22.507, 58.25], [22.507, 58.2535], [22.5, 58.25]]]}},
            {"type": "Feature", "properties": {"kind": "gate", "field": "f", "locked": true},
             "geometry": {"type": "Point", "coordinates": [22.5, 58.25]}},
            {"type": "Feature", "properties": {"kind": "drain"},
             "geometry": {"type": "LineString", "coordinates": [[22.5, 58.25], [22.507, 58.25]]}}]})";
        const auto read = parseProject(text, "farm.furrow");
        VERIFY_RESULT(read);
        QCOMPARE(read->notes.size(), std::size_t{2});
        QCOMPARE(read->project.plan().machine.operatingWidth().si(), 3.0);
        const std::string written = projectText(read->project);
        for (const char* kept : {R"("crs_note":)", R"("crop_rotation":{"2027":"oats"})", R"("yield_t":7.5)",
                                 R"("flux_m":4)", R"("swaths.magic":3)", R"("route.method":"telepathy")",
                                 R"("soil":"clay")", R"("id":5)", R"("locked":true)", R"("kind":"drain")"}) {
            QVERIFY2(QByteArray::fromStdString(written).contains(kept) ||
                         QByteArray::fromStdString(written).contains(QByteArray{kept}.replace(":", ": ")),
                     kept);
        }
        const auto again = parseProject(written, "farm.furrow");
        VERIFY_RESULT(again);
        QVERIFY(again->project == read->project);
    }
    /// Ranges of machines came later than projects: such a farm opens, and says what is to be corrected.
    void aMachineBeyondTheRangesIsTold_data() {
        QTest::addColumn<QByteArray>("member");
        QTest::addColumn<QByteArrayList>("told");
        QTest::newRow("width") << QByteArray{R"("raised_width_m": 10000)"}
                               << QByteArrayList{"raised_width_m", "10000 m is beyond", "did you mean 10 m?"};
        QTest::newRow("millimetres") << QByteArray{R"("vehicle_width_m": 2500)"}
                                     << QByteArrayList{"vehicle_width_m", "2500 m", "did you mean 2.5 m?"};
        QTest::newRow("negative radius")
            << QByteArray{R"("min_turning_radius_m": -3)"}
            << QByteArrayList{"min_turning_radius_m", "-3 m", "give a number from"};
        QTest::newRow("speed") << QByteArray{R"("working_speed_mps": 1e-9)"}
                               << QByteArrayList{"working_speed_mps", "1e-09 m/s", "from 0.01 to"};
    }
    void aMachineBeyondTheRangesIsTold() {
        QFETCH(QByteArray, member);
        QFETCH(QByteArrayList, told);
        const std::string text = R"({"type": "FeatureCollection",
          "furrow_project": {"format_version": 1, "name": "Farm",
            "plans": [{"id": "p", "field": "f", "name": "Drilling",
              "machine": {"operating_width_m": 3, "turning_speed_mps": 1, )" +
                                 member.toStdString() + R"(},
              "settings": {"headland.width_m": 20}}]},
          "features": [
            {"type": "Feature", "properties": {"kind": "field", "field": "f", "name": "A"},
             "geometry": {"type": "Polygon", "coordinates": [[[22.5, 58.25], [22.507, 58.25], [22.507, 58.2535], [22.5, 58.25]]]}}]})";
        const auto read = parseProject(text, "farm.furrow");
        VERIFY_RESULT(read);
        QCOMPARE(read->notes.size(), std::size_t{1});
        const QByteArray note = QByteArray::fromStdString(read->notes.front().text());
        for (const QByteArray& each : told + QByteArrayList{"Drilling", "the plan is made with"}) {
            QVERIFY2(note.contains(each), note);
        }
        // The rest of it is there.
        QCOMPARE(read->project.fields.size(), std::size_t{1});
        QCOMPARE(read->project.plan().settings.length(kHeadlandWidth).value().si(), 20.0);
        QVERIFY(read->project.plan().machine == machineLibrary().front());
        // What was given is not lost when the farm is saved.
        const QByteArray written = QByteArray::fromStdString(projectText(read->project));
        QVERIFY2(written.contains("refused_machine") && written.contains("\"turning_speed_mps\":1"), written);
    }
    /// As QGIS leaves them when somebody copies a field or draws one.
    void fieldsOfOtherProgramsGetIds() {
        std::string text = projectText(sampleProject());
        const std::string copy =
            R"({"type": "Feature", "properties": {"kind": "field", "field": "field-1", "name": "Copy"},
            "geometry": {"type": "Polygon", "coordinates": [[[22.5, 58.25], [22.507, 58.25], [22.507, 58.2535], [22.5, 58.25]]]}},)";
        text.insert(text.find('\n', text.find("\"features\"")) + 1, copy);
        const auto read = parseProject(text, "farm.furrow");
        VERIFY_RESULT(read);
        QCOMPARE(read->project.fields.size(), std::size_t{3});
        QVERIFY(read->project.fields[0]->id != read->project.fields[1]->id);
        QCOMPARE(read->project.fields[1]->plans.size(), std::size_t{1});
    }
    void badFilesAreRefused_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("what");
        QTest::newRow("no JSON") << QByteArray{"{\"type\": \"FeatureColl"} << QByteArray{"damaged"};
        QTest::newRow("200,000 brackets")
            << QByteArray{R"({"furrow_project": {"format_version": 1}, "features": [], "mine": )"} +
                   QByteArray(100'000, '[') + QByteArray(100'000, ']') + "}"
            << QByteArray{"too deep in one another here (line 1"};
        QTest::newRow("a boundary") << QByteArray{R"({"type": "FeatureCollection", "features": []})"}
                                    << QByteArray{"not a project"};
        QTest::newRow("newer")
            << QByteArray{R"({"type": "FeatureCollection", "furrow_project": {"format_version": 2}, "features": []})"}
            << QByteArray{"saved by a newer Furrow (format 2, this one knows 1)"};
        QTest::newRow("no version")
            << QByteArray{R"({"type": "FeatureCollection", "furrow_project": {}, "features": []})"}
            << QByteArray{"no project format 0"};
        QTest::newRow("features missing")
            << QByteArray{R"({"furrow_project": {"format_version": 1}})"} << QByteArray{"damaged"};
        QTest::newRow("a coordinate that is text")
            << QByteArray{R"({"furrow_project": {"format_version": 1}, "features": [{"type": "Feature", "properties": {"kind": "field"},
                 "geometry": {"type": "Polygon", "coordinates": [[["a", 1]]]}}]})"}
            << QByteArray{"damaged"};
    }
    void badFilesAreRefused() {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, what);
        const auto read = parseProject(text.toStdString(), "farm.furrow");
        QVERIFY(!read.has_value());
        QVERIFY2(read.error().line().contains(what.toStdString()), read.error().line().c_str());
        QVERIFY(!read.error().remedy.empty());
    }
    void olderVersionsAreBroughtUp() {
        const Migration steps[] = {[](OrderedJson& json) {
                                       json["b"] = json["a"];
                                       json.erase("a");
                                   },
                                   [](OrderedJson& json) { json["b"] = json["b"].get<int>() * 10; }};
        const OrderedJson first{{"a", 4}};
        QCOMPARE(textOf(*migrated(first, 1, steps, "x")), std::string{R"({"b":40})"});
        QCOMPARE(textOf(*migrated({{"b", 4}}, 2, steps, "x")), std::string{R"({"b":40})"});
        QCOMPARE(textOf(*migrated({{"b", 40}}, 3, steps, "x")), std::string{R"({"b":40})"});
        QVERIFY(!migrated({}, 4, steps, "x"));
    }
    // Headlands of its edges go with a hole; those of later holes stay with them.
    void aHoleTakesItsHeadlandsAndOverhangsAlong() {
        FieldSource source = sampleSource();
        const GeoRing hole{{22.5021, 58.2511}, {22.5022, 58.2511}, {22.5022, 58.2512}};
        source.parts.front().holes = {hole, hole, hole};
        source.edgeHeadlands.clear();
        for (const std::size_t ring : {0, 1, 2, 3}) {
            source.edgeHeadlands.push_back({.part = 0,
                                            .ring = ring,
                                            .edge = ring % 3,
                                            .width = metres(10.0 + static_cast<double>(ring))});
        }
        source.edgeOverhangs = source.edgeHeadlands;
        const Project project = withoutHole(withFields(Project::empty(), {source}), 0, 1);
        const std::vector<EdgeWidth> expected{{.part = 0, .ring = 0, .edge = 0, .width = metres(10.0)},
                                              {.part = 0, .ring = 1, .edge = 1, .width = metres(11.0)},
                                              {.part = 0, .ring = 2, .edge = 0, .width = metres(13.0)}};
        QVERIFY(project.field()->source->edgeHeadlands == expected);
        QVERIFY(project.field()->source->edgeOverhangs == expected);
    }
    /// Files that were saved by earlier versions, one folder for each format.
    void storedProjectsAreRead() {
        const auto read = readProject(FURROW_TEST_DATA_DIR "/projects/v1/farm.furrow");
        VERIFY_RESULT(read);
        QVERIFY(read->notes.empty());
        QCOMPARE(read->project.name, std::string{"Kuressaare farm"});
        QCOMPARE(read->project.fields.size(), std::size_t{2});
        QCOMPARE(read->project.field()->id, std::string{"field-2"});
        const ProjectField& field = *read->project.fields.front();
        FieldSource source = sampleSource();
        // Came later.
        source.edgeHeadlands.clear();
        source.edgeOverhangs.clear();
        source.obstacles.front().overhang = {};
        QVERIFY(*field.source == source);
        QCOMPARE(field.plans.size(), std::size_t{2});
        QCOMPARE(field.plans.front().name, std::string{"Spring drilling"});
        QVERIFY(field.plans.front().settings == sampleSettings());
        QCOMPARE(field.plans.front().machine.operatingWidth().si(), 2.5);
    }
    void aFullDiskLeavesWhatWasThere() {
        const QTemporaryDir folder;
        const auto path = pathIn(folder, "farm.furrow");
        VERIFY_RESULT(writeProject(Project::empty(), path));
        const auto before = fileFingerprint(path);
        {
            const FullDisk disk{1000};
            const auto written = writeProject(sampleProject(), path);
            QVERIFY(!written.has_value());
            QCOMPARE(written.error().code, ErrorCode::WriteFailed);
            QVERIFY(!written.error().what.empty());
        }
        QCOMPARE(fileFingerprint(path), before);
        QCOMPARE(QDir{folder.path()}.entryList(QDir::Files), QStringList{QStringLiteral("farm.furrow")});
        VERIFY_RESULT(writeProject(sampleProject(), path));
        QVERIFY(fileFingerprint(path) != before);
    }
    void aLinkIsFollowed() {
        const QTemporaryDir folder;
        QVERIFY(QDir{folder.path()}.mkdir(QStringLiteral("server")));
        const auto real = pathIn(folder, "server/farm.furrow");
        VERIFY_RESULT(writeProject(Project::empty(), real));
        const auto link = pathIn(folder, "farm.furrow");
        std::filesystem::create_symlink(real, link);
        VERIFY_RESULT(writeProject(sampleProject(), link));
        QVERIFY(std::filesystem::is_symlink(link));
        QVERIFY(readProject(real)->project == sampleProject());
    }
};

FURROW_TEST(TestProjectFile);
#include "tst_project_file.moc"
