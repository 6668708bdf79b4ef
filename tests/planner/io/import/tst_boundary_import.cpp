#include "planner/io/import/boundary_import.h"
#include "tests/support/north_field.h"
#include "tests/support/result_check.h"
#include "tests/support/scratch.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <atomic>
#include <cmath>
#include <format>
#include <thread>

using namespace furrow;
using namespace furrow::test;

class TestBoundaryImport : public QObject {
    Q_OBJECT

private slots:
    void reads_data();
    void reads();
    void readsText_data();
    void readsText();
    void saysWhichRingsWereOpen_data();
    void saysWhichRingsWereOpen();
    void keepsPartsTogether();
    void readsOwnPlans();
    void takesIdsAndNames_data();
    void takesIdsAndNames();
    void curvesBecomeShortChords();
    void picksFields_data();
    void picksFields();
    void listsFieldsWhereOneMustBeChosen();
    void readsInSeveralThreads();
};

void TestBoundaryImport::reads_data() {
    QTest::addColumn<int>("fields");
    const auto row = [](const char* name, int fields = 1) { QTest::newRow(name) << fields; };
    row("geojson/field.geojson");
    row("geojson/two_fields.geojson", 2);
    row("shapefile/field_utm32.shp");
    row("shapefile/field_utm32.dbf");
    row("shapefile/prefixed_zm.shp");
    row("shapefile/wgs84_without_prj.shp");
    row("zip/shapefile_flat.zip");
    row("zip/shapefile in (a folder) [2026].zip");
    row("zip/geopackage.zip", 2);
    row("zip/gml.zip");
    row("kml/field.kml");
    row("kml/without_document.kmz");
    row("gpkg/two_layers.gpkg", 2);
    row("gml/field_mercator.gml");
    row("flatgeobuf/field_laea.fgb");
    row("filegdb/field.gdb.zip");
    row("wkt/field.wkt");
    row("csv/wkt.csv");
    row("csv/points_with_hole.csv");
}

void TestBoundaryImport::reads() {
    QFETCH(int, fields);
    const auto read = readBoundaries(dataFile(QString::fromUtf8(QTest::currentDataTag())));
    VERIFY_RESULT(read);
    QCOMPARE(static_cast<int>(read->size()), fields);
    QVERIFY(isNorthField(read->front()));
    QVERIFY(read->front().repairs.empty());
    // 205.96 m by 222.53 m of the ellipsoid there, a third by a half of it for the hole; by geod(1).
    QVERIFY(std::abs(areaOf(read->front()).si() - 38207.3) < 0.5);
}

void TestBoundaryImport::readsText_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("content");
    const QString ring = "9 52, 9.003 52, 9.003 52.002, 9 52.002, 9 52";
    const QString hole = "9.001 52.0005, 9.001 52.0015, 9.002 52.0015, 9.002 52.0005, 9.001 52.0005";
    QTest::newRow("well-known text in capitals with another extension")
        << "field.txt" << "POLYGON((" + ring + "),(" + hole + "))";
    QTest::newRow("several polygons, one a line")
        << "f.wkt" << "polygon ((" + ring + "), (" + hole + "))\n\nPOLYGON((1 1, 2 1, 2 2))\n";
    QTest::newRow("well-known text that says its system")
        << "f.wkt" << "SRID=4326;POLYGON((" + ring + "),(" + hole + "))";
    QTest::newRow("heights and measures")
        << "f.wkt"
        << "MULTIPOLYGON ZM (((9 52 1 2, 9.003 52 1 2, 9.003 52.002 1 2, 9 52.002 1 2, 9 52 1 2), "
           "(9.001 52.0005 1 2, 9.001 52.0015 1 2, 9.002 52.0015 1 2, 9.002 52.0005 1 2, 9.001 52.0005 1 "
           "2)))";
    const QString rings =
        "[[[9,52],[9.003,52],[9.003,52.002],[9,52.002],[9,52]],"
        "[[9.001,52.0005],[9.001,52.0015],[9.002,52.0015],[9.002,52.0005],[9.001,52.0005]]]";
    QTest::newRow("bare geometry") << "f.geojson" << R"({"type":"Polygon","coordinates":)" + rings + "}";
    QTest::newRow("GeoJSON with another extension")
        << "f.txt" << R"({"type":"Polygon","coordinates":)" + rings + "}";
    QTest::newRow("byte order mark") << "f.geojson"
                                     << QString::fromUtf8("\xEF\xBB\xBF") +
                                            R"({"type":"Polygon","coordinates":)" + rings + "}";
    QTest::newRow("collection of geometries")
        << "f.json"
        << R"({"type":"GeometryCollection","geometries":[{"type":"Point","coordinates":[9,52]},)"
           R"({"type":"Polygon","coordinates":)" +
               rings + "}]}";
    QTest::newRow("rings not closed")
        << "f.geojson"
        << R"({"type":"Polygon","coordinates":[[[9,52],[9.003,52],[9.003,52.002],[9,52.002]],)"
           "[[9.001,52.0005],[9.001,52.0015],[9.002,52.0015],[9.002,52.0005]]]}";
    QTest::newRow("old coordinate system member")
        << "f.geojson"
        << R"({"type":"Feature","properties":{},"crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:OGC:1.3:CRS84"}},)"
           R"("geometry":{"type":"Polygon","coordinates":)" +
               rings + "}}";
    QTest::newRow("points among the polygons")
        << "f.geojson"
        << R"({"type":"FeatureCollection","features":[)"
           R"({"type":"Feature","properties":{},"geometry":{"type":"Point","coordinates":[9,52]}},)"
           R"({"type":"Feature","properties":{},"geometry":null},)"
           R"({"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":)" +
               rings + "}}]}";
    QTest::newRow("kind that is none of ours")
        << "f.geojson"
        << R"({"type":"Feature","properties":{"kind":"arable"},"geometry":{"type":"Polygon","coordinates":)" +
               rings + "}}";
}

void TestBoundaryImport::readsText() {
    QFETCH(QString, file);
    QFETCH(QString, content);
    const Scratch scratch;
    const auto read = readBoundaries(scratch.write(file.toStdString(), content.toStdString()));
    VERIFY_RESULT(read);
    QVERIFY(isNorthField(read->front()));
}

void TestBoundaryImport::saysWhichRingsWereOpen_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("content");
    QTest::addColumn<QString>("said");
    QTest::addColumn<QString>("where");
    QTest::addColumn<double>("lonDeg");
    const QString one = "1 ring did not end where it began and was closed";
    const QString boundary = "the boundary";
    QTest::newRow("GeoJSON")
        << "f.geojson"
        << R"({"type":"Polygon","coordinates":[[[9,52],[9.003,52],[9.003,52.002],[9,52.002]]]})" << one
        << boundary << 9.0;
    QTest::newRow("hole") << "f.geojson"
                          << R"({"type":"Polygon","coordinates":[[[9,52],[9.003,52],[9.003,52.002],[9,52]],)"
                             R"([[9.002,52.0005],[9.0025,52.001],[9.0025,52.0005]]]})"
                          << one << boundary << 9.002;
    QTest::newRow("both rings of well-known text")
        << "f.wkt"
        << "POLYGON((9 52, 9.003 52, 9.003 52.002), (9.002 52.0005, 9.0025 52.001, 9.0025 52.0005))"
        << "2 rings did not end where they began and were closed" << boundary << 9.0;
    QTest::newRow("another system") << "f.wkt"
                                    << "SRID=25832;POLYGON((500000 5761000, 500200 5761000, 500200 5761100))"
                                    << one << boundary << 9.0;
    QTest::newRow("KML")
        << "f.kml"
        << R"(<kml xmlns="http://www.opengis.net/kml/2.2"><Document><Placemark><Polygon><outerBoundaryIs><LinearRing>)"
           "<coordinates>9,52 9.003,52 9.003,52.002</coordinates></LinearRing></outerBoundaryIs></Polygon>"
           "</Placemark></Document></kml>"
        << one << boundary << 9.0;
    QTest::newRow("obstacle")
        << "f.geojson"
        << R"({"type":"FeatureCollection","features":[)"
           R"({"type":"Feature","properties":{"kind":"field"},"geometry":{"type":"Polygon","coordinates":[[[9,52],[9.1,52],[9,52.1],[9,52]]]}},)"
           R"({"type":"Feature","properties":{"kind":"obstacle","name":"Pylon"},"geometry":{"type":"Polygon","coordinates":[[[9.01,52.01],[9.02,52.01],[9.01,52.02]]]}}]})"
        << one << "obstacle 'Pylon'" << 9.01;
    // A table of points has no closing point to miss; nor does a ring whose ends are under a millimetre
    // apart.
    QTest::newRow("points in a table") << "f.csv" << "lon,lat\n9,52\n9.003,52\n9.003,52.002\n"
                                       << "" << "" << 0.0;
    QTest::newRow("ends a hair apart")
        << "f.wkt" << "POLYGON((9 52, 9.003 52, 9.003 52.002, 9.000000001 52.000000001))" << "" << "" << 0.0;
}

void TestBoundaryImport::saysWhichRingsWereOpen() {
    QFETCH(QString, file);
    QFETCH(QString, content);
    QFETCH(QString, said);
    QFETCH(QString, where);
    QFETCH(double, lonDeg);
    const Scratch scratch;
    const auto read = readBoundaries(scratch.write(file.toStdString(), content.toStdString()));
    VERIFY_RESULT(read);
    const std::vector<Note>& repairs = read->front().repairs;
    QCOMPARE(repairs.size(), said.isEmpty() ? 0U : 1U);
    if (!said.isEmpty()) {
        QCOMPARE(QString::fromStdString(repairs.front().text), said);
        QCOMPARE(QString::fromStdString(repairs.front().where), where);
        QVERIFY(repairs.front().place && std::abs(repairs.front().place->lonDeg - lonDeg) < 1e-8);
    }
}

void TestBoundaryImport::keepsPartsTogether() {
    const auto read = readBoundaries(dataFile("geojson/two_fields.geojson"));
    VERIFY_RESULT(read);
    const FieldSource& south = (*read)[1];
    QCOMPARE(south.parts.size(), 2U);
    QVERIFY(sameRing(south.parts[1].outer, {{9.01, 51.99}, {9.013, 51.99}, {9.013, 51.992}}, kToleranceM));
    QCOMPARE(south.origin, std::string{"two_fields.geojson, feature 2"});
}

void TestBoundaryImport::readsOwnPlans() {
    const auto read = readBoundaries(dataFile("geojson/plan.geojson"));
    VERIFY_RESULT(read);
    QCOMPARE(read->size(), 2U);
    const FieldSource& north = (*read)[0];
    const FieldSource& south = (*read)[1];
    QVERIFY(isNorthField(north));
    QCOMPARE(north.boundaryAccuracy.si(), 0.5);
    QCOMPARE(north.obstacles.size(), 1U);
    QCOMPARE(north.obstacles[0].name, std::string{"Pylon"});
    QVERIFY(!north.obstacles[0].passable);
    QCOMPARE(north.obstacles[0].buffer.si(), 1.5);
    QVERIFY(sameRing(north.obstacles[0].outline.outer,
                     {{9.0005, 52.0002}, {9.0006, 52.0002}, {9.0006, 52.0003}}, kToleranceM));
    QVERIFY(north.gates.empty());
    QCOMPARE(south.obstacles.size(), 1U);
    QVERIFY(south.obstacles[0].passable);
    QCOMPARE(south.gates.size(), 1U);
    const Gate expected{.name = "Lane", .position = {9.003, 51.991}, .width = metres(6.0)};
    QVERIFY(south.gates[0] == expected);
}

void TestBoundaryImport::takesIdsAndNames_data() {
    QTest::addColumn<QString>("feature");
    QTest::addColumn<QString>("id");
    QTest::addColumn<QString>("name");
    QTest::newRow("properties") << R"("properties":{"id":"a7","name":"Long Acre"})" << "a7" << "Long Acre";
    QTest::newRow("capitals") << R"("properties":{"ID":"a7","NAME":"Long Acre"})" << "a7" << "Long Acre";
    QTest::newRow("field name before name")
        << R"("properties":{"FIELD_NAME":"Long Acre","name":"x"})" << "1" << "Long Acre";
    QTest::newRow("id of the feature") << R"("id":"a7","properties":{})" << "a7" << "a7";
    QTest::newRow("number as id of the feature") << R"("id":4711,"properties":{})" << "4711" << "4711";
    QTest::newRow("number as id") << R"("properties":{"id":4711})" << "4711" << "4711";
    QTest::newRow("umlauts") << R"("properties":{"name":"Großes Stück"})" << "1" << "Großes Stück";
    QTest::newRow("neither") << R"("properties":{})" << "1" << "1";
    QTest::newRow("null") << R"("properties":{"id":null,"name":null})" << "1" << "1";
}

void TestBoundaryImport::takesIdsAndNames() {
    QFETCH(QString, feature);
    QFETCH(QString, id);
    QFETCH(QString, name);
    const Scratch scratch;
    const QString content =
        R"({"type":"FeatureCollection","features":[{"type":"Feature",)" + feature +
        R"(,"geometry":{"type":"Polygon","coordinates":[[[9,52],[9.1,52],[9,52.1],[9,52]]]}}]})";
    const auto read = readBoundaries(scratch.write("f.geojson", content.toStdString()));
    VERIFY_RESULT(read);
    QCOMPARE(QString::fromStdString(read->front().id), id);
    QCOMPARE(QString::fromStdString(read->front().name), name);
    QCOMPARE(read->front().origin, std::string{"f.geojson"});
}

void TestBoundaryImport::curvesBecomeShortChords() {
    // A circle of 400 m radius about 500000, 5761000 in UTM 32N: each chord's middle is r (1 - cos(0.5°))
    // = 1.5 cm inside it at one degree a chord.
    const Scratch scratch;
    const auto read = readBoundaries(scratch.write(
        "pivot.wkt",
        "SRID=25832;CURVEPOLYGON(CIRCULARSTRING(499600 5761000, 500400 5761000, 499600 5761000))"));
    VERIFY_RESULT(read);
    const GeoPolygon& circle = read->front().parts.front();
    QVERIFY2(circle.outer.size() >= 300 && circle.outer.size() <= 400,
             std::to_string(circle.outer.size()).c_str());
    // Grid scale at the central meridian is 0.9996.
    const double expectedM2 = 3.14159265 * 400.0 * 400.0 / (0.9996 * 0.9996);
    QVERIFY(std::abs(geodesicArea(circle).si() / expectedM2 - 1.0) < 2e-4);
}

void TestBoundaryImport::picksFields_data() {
    QTest::addColumn<QString>("wanted");
    QTest::addColumn<int>("index");
    QTest::addColumn<QString>("message");
    QTest::newRow("id") << "b" << 1 << "";
    QTest::newRow("name") << "Hill" << 0 << "";
    QTest::newRow("number") << "3" << 2 << "";
    QTest::newRow("id before number") << "2" << 3 << "";
    QTest::newRow("name of two fields")
        << "Twin" << -1 << "several fields are called 'Twin'; choose one by its number in the file: 2, 3";
    QTest::newRow("near an id") << "Hil" << -1 << "did you mean 'Hill'?";
    QTest::newRow("near nothing")
        << "somewhere else entirely" << -1
        << "there is no field 'somewhere else entirely' in the file; it has 4 fields: 1 a 'Hill'";
    QTest::newRow("number too large") << "99999" << -1 << "there is no field '99999'";
    QTest::newRow("zero") << "0" << -1 << "there is no field '0'";
}

void TestBoundaryImport::picksFields() {
    QFETCH(QString, wanted);
    QFETCH(int, index);
    QFETCH(QString, message);
    const GeoPolygon ground{.outer = kNorthField.outer, .holes = {}};
    std::vector<FieldSource> fields(4);
    const char* const names[][2] = {{"a", "Hill"}, {"b", "Twin"}, {"c", "Twin"}, {"2", "Brook"}};
    for (std::size_t i = 0; i < fields.size(); ++i) {
        fields[i].id = names[i][0];
        fields[i].name = names[i][1];
        fields[i].parts = {ground};
    }
    const std::string asked = wanted.toStdString();
    const auto picked = pickField(fields, asked);
    if (index >= 0) {
        VERIFY_RESULT(picked);
        QVERIFY(*picked == fields[static_cast<std::size_t>(index)]);
    } else {
        QVERIFY(!picked && picked.error().code == ErrorCode::Usage);
        QVERIFY2(picked.error().line().contains(message.toStdString()), picked.error().line().c_str());
    }
}

void TestBoundaryImport::listsFieldsWhereOneMustBeChosen() {
    std::vector<FieldSource> fields(23);
    for (std::size_t i = 0; i < fields.size(); ++i) {
        fields[i].id = std::format("f{}", i + 1);
        fields[i].parts = {kNorthField};
    }
    const auto picked = pickField(fields, std::nullopt);
    QVERIFY(!picked && picked.error().code == ErrorCode::Usage);
    const std::string line = picked.error().line();
    QVERIFY2(line.contains("the file has 23 fields: 1 f1 (3.82 ha), 2 f2"), line.c_str());
    QVERIFY2(line.contains("20 f20 (3.82 ha) and 3 more") && !line.contains("f21"), line.c_str());
    fields.resize(1);
    QVERIFY(pickField(fields, std::nullopt));
}

void TestBoundaryImport::readsInSeveralThreads() {
    std::atomic<int> good = 0;
    std::vector<std::jthread> threads;
    for (int i = 0; i < 4; ++i) {
        threads.emplace_back([&good] {
            for (const char* name : {"gpkg/two_layers.gpkg", "shapefile/field_utm32.shp", "kml/field.kml"}) {
                const auto read = readBoundaries(dataFile(name));
                good += read && isNorthField(read->front()) ? 1 : 0;
            }
        });
    }
    threads.clear();
    QCOMPARE(good.load(), 12);
}

FURROW_TEST(TestBoundaryImport);
#include "tst_boundary_import.moc"
