#include "planner/io/content/plan_content.h"
#include "planner/io/delivery/plan_folder.h"
#include "planner/io/delivery/terminals.h"
#include "planner/io/formats/registry.h"
#include "planner/io/import/track_reader.h"
#include "tests/planner/io/format_cases.h"
#include "tests/support/geo_rings.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include "path_message.pb.h"
#include "tests/support/large_data.h"

#include <QDirIterator>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include <set>

using namespace furrow;
using namespace furrow::test;

namespace {

/// The same written once in every format.
class Written {
public:
    Written() {
        std::vector<std::string_view> ids;
        for (const Format& format : formats()) {
            if (format.writes()) {
                ids.push_back(format.id);
            }
        }
        result = writePlanFolder(planWithEverything(), folder.path().toStdString(), ids);
    }
    QString file(const QString& name) const { return folder.filePath(name); }
    QByteArray text(const QString& name) const {
        return QByteArray::fromStdString(bytesOf(file(name).toStdString()));
    }

    QTemporaryDir folder;
    Result<WrittenFiles> result;
};

const Written& written() {
    static const Written all;
    return all;
}

GeoPoint firstPlace() {
    return planWithEverything().field().frame().toGeo(
        planWithEverything().path.segments.front().samples.front().position);
}
GeoPoint lastPlace() {
    return planWithEverything().field().frame().toGeo(
        planWithEverything().path.segments.back().samples.back().position);
}

GeoPoint pointOf(const QJsonValue& position) {
    return {position[0].toDouble(), position[1].toDouble()};
}

bool reverses() {
    return std::ranges::any_of(planWithEverything().path.segments,
                               [](const PathSegment& s) { return s.gear == Gear::Reverse; });
}

}  // namespace

/// A plan in every format, read by programs that share nothing with ours.
class PlanFormatsTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        VERIFY_RESULT(written().result);
        QVERIFY(reverses());  // or less is tested than meant
    }

    void everyFileIsThereOnce() {
        std::set<std::filesystem::path> files;
        for (const auto& file : written().result->files) {
            QVERIFY2(std::filesystem::is_regular_file(file), file.c_str());
            QVERIFY2(files.insert(file).second, file.c_str());
        }
        QDirIterator left{written().folder.path(), {"*.part"}, QDir::Files, QDirIterator::Subdirectories};
        QVERIFY(!left.hasNext());
    }

    void taskDataFitsItsSchema_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("schema");
        QTest::newRow("4.3") << "TASKDATA/TASKDATA.XML" << "V4-3";
        QTest::newRow("3.3") << "isoxml-v3/TASKDATA/TASKDATA.XML" << "V3-3";
    }
    void taskDataFitsItsSchema() {
        QFETCH(QString, file);
        QFETCH(QString, schema);
        const QString path = test::largeData(QStringLiteral("schemas/ISO11783_TaskFile_%1.xsd").arg(schema));
        if (!QFileInfo::exists(path)) {
            QSKIP("needs the schemas of the large test data");
        }
        const Printed lint = run("xmllint", {"--noout", "--nonet", "--schema", path, written().file(file)});
        QVERIFY2(lint.status == 0, lint.error.constData());
        const Printed strict = run("xmlschema-validate", {"--schema", path, written().file(file)});
        if (strict.status != -1) {
            QVERIFY2(strict.status == 0, (strict.out + strict.error).constData());
        }
    }

    void isoxmlReaderFindsTheSame_data() {
        QTest::addColumn<QString>("folder");
        QTest::addColumn<int>("version");
        QTest::newRow("4.3") << "TASKDATA" << 4;
        QTest::newRow("3.3") << "isoxml-v3/TASKDATA" << 3;
    }
    void isoxmlReaderFindsTheSame() {
        QFETCH(QString, folder);
        QFETCH(int, version);
        const Printed read = runNode("isoxml_check.js", {written().file(folder)});
        if (read.status == -1) {
            QSKIP("needs node and the packages of tests/validators");
        }
        QVERIFY2(read.status == 0, (read.out + read.error).constData());
        const QJsonObject all = QJsonDocument::fromJson(read.out).object();
        QCOMPARE(all["version"].toInt(), version);
        const QJsonArray polygons = all["fields"][0]["polygons"].toArray();
        const QJsonArray rings = polygons[0]["rings"].toArray();
        const GeoPolygon& part = planWithEverything().field().source().parts.front();
        QCOMPARE(static_cast<std::size_t>(rings.size()), 1 + part.holes.size());
        QCOMPARE(static_cast<std::size_t>(rings[0]["points"].toArray().size()), part.outer.size() + 1);
        const QJsonValue first = rings[0]["points"][0];
        QVERIFY(metresBetween({first["lon"].toDouble(), first["lat"].toDouble()}, part.outer.front()) < 1e-3);
        QCOMPARE(all["fields"][0]["gates"].toArray().size(), 1);
    }

    void mapProgramsReadTheShapefiles() {
        const Printed read = runNode("read_map.js", {written().file("shapefile/boundary.shp")});
        if (read.status == -1) {
            QSKIP("needs node and the packages of tests/validators");
        }
        QVERIFY2(read.status == 0, read.error.constData());
        const QJsonObject feature = QJsonDocument::fromJson(read.out).object()["features"][0].toObject();
        QCOMPARE(feature["properties"]["name"].toString(), QString::fromUtf8("Höhe & Senke"));
        const QJsonArray rings = feature["geometry"]["coordinates"].toArray();
        QCOMPARE(rings.size(), 2);
        QCOMPARE(rings[0].toArray().size(), 5);
        QVERIFY(metresBetween(pointOf(rings[0][0]), {9.0, 52.0}) < 500.0);
        const QJsonArray swaths =
            QJsonDocument::fromJson(runNode("read_map.js", {written().file("shapefile/swaths.shp")}).out)
                .object()["features"]
                .toArray();
        QCOMPARE(static_cast<std::size_t>(swaths.size()), planWithEverything().route.steps.size());
        const GeoPoint start = planWithEverything().field().frame().toGeo(
            startPose(planWithEverything().route.steps[0], planWithEverything().swaths).position);
        QVERIFY(metresBetween(pointOf(swaths[0]["geometry"]["coordinates"][0]), start) < 1e-6);
    }

    void mapProgramsReadKmlAndGpx() {
        const Printed kml = runNode("read_map.js", {written().file("plan.kml")});
        if (kml.status == -1) {
            QSKIP("needs node and the packages of tests/validators");
        }
        const QJsonArray features = QJsonDocument::fromJson(kml.out).object()["features"].toArray();
        QCOMPARE(features[0]["properties"]["kind"].toString(), "field");
        QCOMPARE(features[0]["geometry"]["coordinates"].toArray().size(), 2);
        QVERIFY(metresBetween(pointOf(features[0]["geometry"]["coordinates"][0][0]), {9.0, 52.0}) < 1e-3);
        const QJsonArray tracks =
            QJsonDocument::fromJson(runNode("read_map.js", {written().file("path.gpx")}).out)
                .object()["features"]
                .toArray();
        const auto track = std::ranges::find_if(
            tracks, [](const QJsonValue& f) { return f["geometry"]["type"] == "MultiLineString"; });
        QVERIFY(track != tracks.end());
        const QJsonValue geometry = QJsonValue{*track}["geometry"];
        QVERIFY(metresBetween(pointOf(geometry["coordinates"][0][0]), firstPlace()) < 1e-3);
        const QJsonArray last = geometry["coordinates"].toArray().last().toArray();
        QVERIFY(metresBetween(pointOf(last.last()), lastPlace()) < 1e-3);
    }

    void mapProgramsReadWhatIsZipped() {
        const Printed kmz = runNode("read_map.js", {written().file("plan.kmz")});
        if (kmz.status == -1) {
            QSKIP("needs node and the packages of tests/validators");
        }
        QVERIFY2(kmz.status == 0, kmz.error.constData());
        QCOMPARE(kmz.out, runNode("read_map.js", {written().file("plan.kml")}).out);
        const Printed zip = runNode("read_map.js", {written().file("boundary.zip")});
        QVERIFY2(zip.status == 0, zip.error.constData());
        const QJsonObject all = QJsonDocument::fromJson(zip.out).object();
        // Flat, as operations centres want it.
        for (const QJsonValue& name : all["names"].toArray()) {
            QVERIFY2(!name.toString().contains('/'), qPrintable(name.toString()));
        }
        QCOMPARE(all["features"].toArray().size(), 1);
        QCOMPARE(all["features"][0]["properties"]["FIELD_NAME"].toString(),
                 QString::fromUtf8("Höhe & Senke"));
        QCOMPARE(all["features"][0]["geometry"]["coordinates"].toArray().size(), 2);
    }

    void geoJsonIsGood() {
        const Printed read = runNode("read_map.js", {written().file("plan.geojson")});
        if (read.status == -1) {
            QSKIP("needs node and the packages of tests/validators");
        }
        QVERIFY2(read.status == 0, read.error.constData());
    }

    void gpsbabelReadsTheTrack() {
        const Printed read =
            run("gpsbabel", {"-t", "-i", "gpx", "-f", written().file("path.gpx"), "-o", "unicsv", "-F", "-"});
        if (read.status == -1) {
            QSKIP("needs gpsbabel");
        }
        QCOMPARE(read.status, 0);
        std::size_t samples = 0;
        for (std::size_t i = 0; i < planWithEverything().path.segments.size(); ++i) {
            const bool goesOn = i > 0 && planWithEverything().path.segments[i].gear ==
                                             planWithEverything().path.segments[i - 1].gear;
            samples += planWithEverything().path.segments[i].samples.size() - (goesOn ? 1 : 0);
        }
        QCOMPARE(static_cast<std::size_t>(read.out.trimmed().count('\n')), samples);  // and a line of names
    }

    void gdalReadsTheDrawing() {
        const QStringList names = QDir{written().folder.path()}.entryList({"*.dxf"});
        QCOMPARE(names, QStringList{"plan_EPSG32632.dxf"});
        const Printed info = run("ogrinfo", {"-ro", "-al", "-geom=SUMMARY", written().file(names.first())});
        if (info.status == -1) {
            QSKIP("needs ogrinfo");
        }
        // 52.0 N 9.0 E is the middle of zone 32: 500,000 m east, and 5,761,038 m north by GeographicLib's
        // GeoConvert.
        static const QRegularExpression extent{QStringLiteral(R"(Extent: \((\d+\.\d+), (\d+\.\d+)\))")};
        const auto match = extent.match(QString::fromUtf8(info.out));
        QVERIFY2(match.hasMatch(), info.out.left(400).constData());
        COMPARE_WITHIN(match.captured(1).toDouble(), 500'000.0, 0.01);
        COMPARE_WITHIN(match.captured(2).toDouble(), 5'761'038.21, 0.5);
        const auto count = info.out.count("Layer (String) = BOUNDARY");
        QCOMPARE(count, 1);
        QCOMPARE(info.out.count("Layer (String) = HOLE"), 1);
        QCOMPARE(static_cast<std::size_t>(info.out.count("Layer (String) = SWATH")),
                 planWithEverything().route.steps.size());
        QCOMPARE(static_cast<std::size_t>(info.out.count("Layer (String) = PATH")),
                 planWithEverything().path.segments.size());
    }

    void rosbagsReadThePath_data() {
        QTest::addColumn<QString>("folder");
        QTest::newRow("sqlite3") << "ros/rosbag2_sqlite3";
        QTest::newRow("MCAP") << "ros/rosbag2_mcap";
    }
    void rosbagsReadThePath() {
        QFETCH(QString, folder);
        // Our own reader first.
        const auto tracks = readTracks(written().file(folder).toStdString());
        VERIFY_RESULT(tracks);
        const Printed read = run(
            "python3",
            {QStringLiteral(FURROW_SOURCE_DIR "/tests/validators/read_rosbag.py"), written().file(folder)});
        if (read.status != 0 && read.error.contains("No module")) {
            QSKIP("needs python3-rosbags");
        }
        QVERIFY2(read.status == 0, read.error.constData());
        const QJsonArray messages = QJsonDocument::fromJson(read.out).array();
        const auto whole = std::ranges::find_if(
            messages, [](const QJsonValue& m) { return m["topic"] == "/coverage_path"; });
        QVERIFY(whole != messages.end());
        const QJsonValue message{*whole};
        QCOMPARE(message["frame"].toString(), "map");
        const QJsonArray poses = message["poses"].toArray();
        const PathSample& first = planWithEverything().path.segments.front().samples.front();
        const PathSample& last = planWithEverything().path.segments.back().samples.back();
        COMPARE_WITHIN(poses[0][0].toDouble(), first.position.x, 1e-12);
        COMPARE_WITHIN(poses[0][1].toDouble(), first.position.y, 1e-12);
        COMPARE_WITHIN(std::remainder(2.0 * std::atan2(poses[0][2].toDouble(), poses[0][3].toDouble()) -
                                          first.headingRad,
                                      2.0 * M_PI),
                       0.0, 1e-9);
        const QJsonValue end = poses[poses.size() - 1];
        COMPARE_WITHIN(end[0].toDouble(), last.position.x, 1e-12);
        COMPARE_WITHIN(end[4].toDouble() + 1e-9 * end[5].toDouble(), last.tS, 1e-6);
        // The stretches in one gear are the whole path again.
        qsizetype stretches = 0;
        for (const QJsonValue& each : messages) {
            stretches += each["topic"] == "/coverage_path" ? 0 : 1;
        }
        QVERIFY(stretches >= 3);
    }

    void mcapIsIndexed() {
        const Printed read = runNode("read_mcap.js", {written().file("ros/rosbag2_mcap/path_0.mcap")});
        if (read.status == -1) {
            QSKIP("needs node and the packages of tests/validators");
        }
        QVERIFY2(read.status == 0, read.error.constData());
        const QJsonObject all = QJsonDocument::fromJson(read.out).object();
        QCOMPARE(all["profile"].toString(), "ros2");
        QCOMPARE(all["messages"][0]["schema"].toString(), "nav_msgs/msg/Path");
        QCOMPARE(all["messages"][0]["encoding"].toString(), "cdr");
    }

    void missionFollowsThePath() {
        const QList<QByteArray> lines = written().text("plan.waypoints").split('\n');
        QCOMPARE(lines[0], "QGC WPL 110");
        int reversed = 0;
        GeoPoint lastSeen;
        for (qsizetype i = 1; i + 1 < lines.size(); ++i) {
            const QList<QByteArray> columns = lines[i].split('\t');
            QCOMPARE(columns.size(), 12);
            QCOMPARE(columns[0].toInt(), static_cast<int>(i - 1));
            QCOMPARE(columns[2].toInt(), i == 1 ? 0 : 3);
            reversed += columns[3] == "194" && columns[4].toDouble() == 1.0 ? 1 : 0;
            if (columns[3] == "16") {
                lastSeen = {columns[9].toDouble(), columns[8].toDouble()};
                if (i == 1) {
                    QVERIFY(metresBetween(lastSeen, firstPlace()) < 0.002);
                }
            }
        }
        QVERIFY(metresBetween(lastSeen, lastPlace()) < 0.002);
        QVERIFY(reversed > 0);
        const QJsonObject file = QJsonDocument::fromJson(written().text("plan.plan")).object();
        QCOMPARE(file["fileType"].toString(), "Plan");
        QCOMPARE(file["mission"]["items"].toArray().size() + 3,
                 lines.size());  // header, home, and what follows the last end
        const QJsonArray fences = file["geoFence"]["polygons"].toArray();
        QCOMPARE(fences.size(), 3);
        QVERIFY(fences[0]["inclusion"].toBool() && !fences[1]["inclusion"].toBool() &&
                !fences[2]["inclusion"].toBool());
        COMPARE_WITHIN(fences[0]["polygon"][0][0].toDouble(), 52.0, 0.01);  // latitude first
    }

    void messageHoldsThePath() {
        v1::PathMessage message;
        QVERIFY(message.ParseFromString(bytesOf(written().file("path.pb").toStdString())));
        QCOMPARE(message.format_version(), 1U);
        QCOMPARE(message.fence_size(), 1);
        QCOMPARE(message.fence(0).holes_size(), 1);
        QCOMPARE(message.keep_out_size(), 1);
        QCOMPARE(message.keep_out(0).name(), "Pylon");
        QCOMPARE(static_cast<std::size_t>(message.segments_size()),
                 planWithEverything().path.segments.size());
        for (int i = 0; i < message.segments_size(); ++i) {
            const PathSegment& segment = planWithEverything().path.segments[static_cast<std::size_t>(i)];
            QCOMPARE(message.segments(i).reverse(), segment.gear == Gear::Reverse);
            QCOMPARE(message.segments(i).implement_down(), segment.implementDown);
            QCOMPARE(static_cast<std::size_t>(message.segments(i).samples_size()), segment.samples.size());
            const v1::Sample& sample = message.segments(i).samples(1);
            const v1::Sample& next = message.segments(i).samples(0);
            QCOMPARE(sample.x_m(), segment.samples[1].position.x);
            QCOMPARE(sample.time_s(), segment.samples[1].tS);
            // The velocity points the way it moves, also in reverse.
            const double forwards = (sample.x_m() - next.x_m()) * sample.velocity_x_mps() +
                                    (sample.y_m() - next.y_m()) * sample.velocity_y_mps();
            QVERIFY(forwards >= -1e-6);
        }
    }

    void goalHoldsField() {
        const QByteArray goal = written().text("ros/compute_coverage_path_goal.yaml");
        const auto rings = goal.count("- coordinates:");
        // The outline, the hole and the obstacle; an obstacle without a clearance stays as it is drawn.
        QCOMPARE(rings, 3);
        QVERIFY(goal.contains("mode: SET_ANGLE, best_angle: " +
                              QByteArray::number(planWithEverything().swaths.heading.si(), 'f', 9)));
        QVERIFY(goal.contains("route_mode: {mode: CUSTOM"));
        QVERIFY(written().text("ros/map_frame.yaml").contains("proj: \"+proj=tmerc"));
    }

    void pathOfAgOpenGpsIsThePath() {
        const QString folder = QString::fromUtf8("agopengps/Höhe & Senke/");
        const QList<QByteArray> field = written().text(folder + "Field.txt").split('\n');
        QCOMPARE(field[7], "StartFix\r");
        // Stretches between changes of gear; together every metre that is driven forwards.
        double forwards = 0.0;
        for (const PathSegment& segment : planWithEverything().path.segments) {
            forwards += segment.gear == Gear::Forward ? segment.length().si() : 0.0;
        }
        double recorded = 0.0;
        const QStringList parts = QDir{written().file(folder)}.entryList({"*.rec"}, QDir::Files, QDir::Name);
        QVERIFY(parts.size() > 1);
        for (const QString& part : parts) {
            const QList<QByteArray> lines = written().text(folder + part).split('\n');
            QCOMPARE(lines[0], "$RecPath\r");
            QCOMPARE(lines[1].trimmed().toInt(), static_cast<int>(lines.size()) - 3);
            for (qsizetype i = 3; i + 1 < lines.size(); ++i) {
                const QList<QByteArray> from = lines[i - 1].trimmed().split(',');
                const QList<QByteArray> to = lines[i].trimmed().split(',');
                QCOMPARE(to.size(), 5);
                const double east = to[0].toDouble() - from[0].toDouble();
                const double north = to[1].toDouble() - from[1].toDouble();
                recorded += std::hypot(east, north);
                // Straights have points, too: AgOpenGPS steers from one to the next.
                QVERIFY2(std::hypot(east, north) < 2.0, lines[i].constData());
                // Clockwise from north; nothing goes sideways.
                const double bearing = std::atan2(east, north);
                QVERIFY2(std::abs(std::remainder(from[2].toDouble() - bearing, 2.0 * M_PI)) < 0.02 ||
                             std::hypot(east, north) < 0.1,
                         lines[i].constData());
            }
        }
        QVERIFY2(recorded > 0.95 * forwards && recorded < 1.001 * forwards,
                 qPrintable(QStringLiteral("%1 of %2 m").arg(recorded).arg(forwards)));
    }

    // As short as cells and last passes may leave them: 27 cm, and 30 cm of a headland pass.
    void shortStretchesAreNoFault() {
        Plan shortened = planWithEverything();
        for (Swath& swath : shortened.swaths.swaths) {
            if (!swath.isCurved()) {
                const Point along = swath.end - swath.start;
                swath.end = swath.start + (0.27 / norm(along)) * along;
            }
        }
        PathSegment stretch =
            *std::ranges::find(shortened.path.segments, SegmentKind::HeadlandPass, &PathSegment::kind);
        stretch.samples.resize(2);
        stretch.samples[1] = stretch.samples[0];
        stretch.samples[1].position = stretch.samples[0].position + Point{0.3, 0.0};
        stretch.samples[1].sM = stretch.samples[0].sM + 0.3;
        stretch.number = 99;
        shortened.path.segments.push_back(stretch);
        std::vector<std::string_view> ids;
        for (const Format& format : formats()) {
            if (format.writes()) {
                ids.push_back(format.id);
            }
        }
        const QTemporaryDir folder;
        const auto files =
            writePlanFolder(shortened, folder.path().toStdString(), ids, {}, {.headlandLines = true});
        VERIFY_RESULT(files);
        for (const std::string& problem : files->checks.problems) {
            QVERIFY2(!problem.contains("same place"), problem.c_str());
        }
        // What a terminal steers by keeps its bearing.
        const auto lines = contentOf(shortened, {.headlandLines = true}).lines;
        const auto ab = std::ranges::find(lines, GuidanceKind::AbLine, &GuidanceLine::kind);
        QVERIFY(ab != lines.end());
        COMPARE_WITHIN(metresBetween(ab->points[0], ab->points[1]), 20.0, 0.1);
        const auto before = contentOf(planWithEverything(), {}).lines;
        QCOMPARE(ab->name, std::ranges::find(before, GuidanceKind::AbLine, &GuidanceLine::kind)->name);
        QVERIFY(
            std::ranges::none_of(lines, [](const GuidanceLine& line) { return line.name == "Headland 99"; }));
    }

    // A ring of missed land whose inner side was traced 4 cm beyond its outer one.
    void missedLandIsWrittenWithoutCrossings() {
        Plan traced = planWithEverything();
        const Point at = traced.path.segments.front().samples.front().position;
        const auto ring = [at](std::initializer_list<Point> points) {
            Ring moved;
            for (const Point& point : points) {
                moved.push_back(at + point);
            }
            return moved;
        };
        traced.audit.missedAreas = {{.outer = ring({{0.0, 0.0}, {20.0, 0.0}, {20.0, 10.0}, {0.0, 10.0}}),
                                     .holes = {ring({{2.0, 2.0}, {2.0, 8.0}, {20.04, 5.0}})}}};
        const QTemporaryDir folder;
        const std::vector<std::string_view> formats{"geojson"};
        const auto files = writePlanFolder(traced, folder.path().toStdString(), formats);
        VERIFY_RESULT(files);
        QVERIFY2(files->checks.problems.empty(),
                 files->checks.problems.empty() ? "" : files->checks.problems.front().c_str());
        double missedM2 = 0.0;
        const QJsonDocument json = QJsonDocument::fromJson(
            QByteArray::fromStdString(bytesOf(folder.filePath("plan.geojson").toStdString())));
        for (const QJsonValue& feature : json["features"].toArray()) {
            const QJsonObject properties = feature["properties"].toObject();
            missedM2 += properties["kind"].toString() == "missed" ? properties["area_m2"].toDouble() : 0.0;
        }
        // 200 m² less a triangle of 6 by 18 m.
        COMPARE_WITHIN(missedM2, 200.0 - 54.12, 0.1);
    }

    void everyTerminalGetsFiles() {
        std::set<std::string_view> ids;
        for (const Terminal& terminal : terminals()) {
            QVERIFY2(ids.insert(terminal.id).second, terminal.id.data());
            const QTemporaryDir folder;
            const auto files = writeForTerminal(planWithEverything(), folder.path().toStdString(), terminal);
            VERIFY_RESULT(files);
            QVERIFY2(files->files.size() > 1, terminal.id.data());
            const bool isIsoxml = terminal.format.starts_with("isoxml");
            QCOMPARE(QFileInfo::exists(folder.filePath("TASKDATA/TASKDATA.XML")), isIsoxml);
            QVERIFY(terminal.shows.size() > 40);
        }
        QVERIFY(!findTerminal("fent"));
        QVERIFY(findTerminal("fent").error().remedy.contains("fendt"));
    }

    void holesBecomeObstaclesForThoseThatOverlookThem() {
        const QTemporaryDir folder;
        VERIFY_RESULT(writeForTerminal(planWithEverything(), folder.path().toStdString(),
                                       **findTerminal("agopengps-isoxml")));
        const QByteArray xml =
            QByteArray::fromStdString(bytesOf(folder.filePath("TASKDATA/TASKDATA.XML").toStdString()));
        QCOMPARE(xml.count("<PLN A=\"6\""), 2);  // the hole and the pylon
        const qsizetype boundary = xml.indexOf("<PLN A=\"1\"");
        QVERIFY(!xml.mid(boundary, xml.indexOf("</PLN>", boundary) - boundary).contains("LSG A=\"2\""));
    }
};

FURROW_TEST(PlanFormatsTest);
#include "tst_plan_formats.moc"
