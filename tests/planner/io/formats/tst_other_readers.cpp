#include "planner/io/import/track_reader.h"
#include "tests/planner/io/format_cases.h"
#include "tests/planner/io/formats/written_plan.h"
#include "tests/support/geo_rings.h"
#include "tests/support/large_data.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTest>

using namespace furrow;
using namespace furrow::test;

namespace {

GeoPoint pointOf(const QJsonValue& position) {
    return {position[0].toDouble(), position[1].toDouble()};
}

}  // namespace

/// A plan in every format, read by programs that share nothing with ours.
class OtherReadersTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        VERIFY_RESULT(writtenPlan().result);
        QVERIFY(pathReverses());
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
        const Printed lint =
            run("xmllint", {"--noout", "--nonet", "--schema", path, writtenPlan().file(file)});
        QVERIFY2(lint.status == 0, lint.error.constData());
        const Printed strict = run("xmlschema-validate", {"--schema", path, writtenPlan().file(file)});
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
        const Printed read = runNode("isoxml_check.js", {writtenPlan().file(folder)});
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
        const Printed read = runNode("read_map.js", {writtenPlan().file("shapefile/boundary.shp")});
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
        const Printed lines = runNode("read_map.js", {writtenPlan().file("shapefile/swaths.shp")});
        QVERIFY2(lines.status == 0, lines.error.constData());
        const QJsonArray swaths = QJsonDocument::fromJson(lines.out).object()["features"].toArray();
        QCOMPARE(static_cast<std::size_t>(swaths.size()), planWithEverything().route.steps.size());
        const GeoPoint start = planWithEverything().field().frame().toGeo(
            startPose(planWithEverything().route.steps[0], planWithEverything().swaths).position);
        QVERIFY(metresBetween(pointOf(swaths[0]["geometry"]["coordinates"][0]), start) < 1e-6);
    }

    void mapProgramsReadKmlAndGpx() {
        const Printed kml = runNode("read_map.js", {writtenPlan().file("plan.kml")});
        if (kml.status == -1) {
            QSKIP("needs node and the packages of tests/validators");
        }
        QVERIFY2(kml.status == 0, kml.error.constData());
        const QJsonArray features = QJsonDocument::fromJson(kml.out).object()["features"].toArray();
        QCOMPARE(features[0]["properties"]["kind"].toString(), "field");
        QCOMPARE(features[0]["geometry"]["coordinates"].toArray().size(), 2);
        QVERIFY(metresBetween(pointOf(features[0]["geometry"]["coordinates"][0][0]), {9.0, 52.0}) < 1e-3);
        const Printed gpx = runNode("read_map.js", {writtenPlan().file("path.gpx")});
        QVERIFY2(gpx.status == 0, gpx.error.constData());
        const QJsonArray tracks = QJsonDocument::fromJson(gpx.out).object()["features"].toArray();
        const auto track = std::ranges::find_if(
            tracks, [](const QJsonValue& f) { return f["geometry"]["type"] == "MultiLineString"; });
        QVERIFY(track != tracks.end());
        const QJsonValue geometry = QJsonValue{*track}["geometry"];
        QVERIFY(metresBetween(pointOf(geometry["coordinates"][0][0]), firstPlace()) < 1e-3);
        const QJsonArray last = geometry["coordinates"].toArray().last().toArray();
        QVERIFY(metresBetween(pointOf(last.last()), lastPlace()) < 1e-3);
    }

    void mapProgramsReadWhatIsZipped() {
        const Printed kmz = runNode("read_map.js", {writtenPlan().file("plan.kmz")});
        if (kmz.status == -1) {
            QSKIP("needs node and the packages of tests/validators");
        }
        QVERIFY2(kmz.status == 0, kmz.error.constData());
        QCOMPARE(kmz.out, runNode("read_map.js", {writtenPlan().file("plan.kml")}).out);
        const Printed zip = runNode("read_map.js", {writtenPlan().file("boundary.zip")});
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
        const Printed read = runNode("read_map.js", {writtenPlan().file("plan.geojson")});
        if (read.status == -1) {
            QSKIP("needs node and the packages of tests/validators");
        }
        QVERIFY2(read.status == 0, read.error.constData());
    }

    void gpsbabelReadsTheTrack() {
        const Printed read = run(
            "gpsbabel", {"-t", "-i", "gpx", "-f", writtenPlan().file("path.gpx"), "-o", "unicsv", "-F", "-"});
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
        const QStringList names = QDir{writtenPlan().folder.path()}.entryList({"*.dxf"});
        QCOMPARE(names, QStringList{"plan_EPSG32632.dxf"});
        const Printed info =
            run("ogrinfo", {"-ro", "-al", "-geom=SUMMARY", writtenPlan().file(names.first())});
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
        const auto tracks = readTracks(writtenPlan().file(folder).toStdString());
        VERIFY_RESULT(tracks);
        const Printed read =
            run("python3", {QStringLiteral(FURROW_SOURCE_DIR "/tests/validators/read_rosbag.py"),
                            writtenPlan().file(folder)});
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
        const Printed read = runNode("read_mcap.js", {writtenPlan().file("ros/rosbag2_mcap/path_0.mcap")});
        if (read.status == -1) {
            QSKIP("needs node and the packages of tests/validators");
        }
        QVERIFY2(read.status == 0, read.error.constData());
        const QJsonObject all = QJsonDocument::fromJson(read.out).object();
        QCOMPARE(all["profile"].toString(), "ros2");
        QCOMPARE(all["messages"][0]["schema"].toString(), "nav_msgs/msg/Path");
        QCOMPARE(all["messages"][0]["encoding"].toString(), "cdr");
    }
};

FURROW_TEST(OtherReadersTest);
#include "tst_other_readers.moc"
