#include "planner/io/boundary_import.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <fcntl.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <thread>

using namespace furrow;

namespace {

// The field of tests/data/imports/README.md, by hand.
const GeoRing kOuter{{9.0, 52.0}, {9.003, 52.0}, {9.003, 52.002}, {9.0, 52.002}};
const GeoRing kHole{{9.001, 52.0005}, {9.001, 52.0015}, {9.002, 52.0015}, {9.002, 52.0005}};

// A millimetre on the ground.
constexpr double kToleranceDeg = 1e-8;

std::filesystem::path dataFile(const QString& name) {
    return std::filesystem::path{FURROW_TEST_DATA_DIR} / "imports" / name.toStdString();
}

/// The same points, wherever the ring begins and whichever way it runs.
bool sameRing(const GeoRing& actual, const GeoRing& expected) {
    return actual.size() == expected.size() &&
           std::ranges::all_of(expected, [&actual](const GeoPoint& wanted) {
               return std::ranges::any_of(actual, [&wanted](const GeoPoint& point) {
                   return std::abs(point.lonDeg - wanted.lonDeg) < kToleranceDeg &&
                          std::abs(point.latDeg - wanted.latDeg) < kToleranceDeg;
               });
           });
}

bool isNorthField(const FieldSource& field) {
    return field.parts.size() == 1 && sameRing(field.parts[0].outer, kOuter) &&
           field.parts[0].holes.size() == 1 && sameRing(field.parts[0].holes[0], kHole);
}

std::string bytesOf(const std::filesystem::path& path) {
    std::ifstream file{path, std::ios::binary};
    return {std::istreambuf_iterator<char>{file}, {}};
}

/// A folder with one file of this content.
class Scratch {
public:
    std::filesystem::path write(const std::string& name, const std::string& content) const {
        const std::filesystem::path path = std::filesystem::path{folder_.path().toStdString()} / name;
        std::ofstream{path, std::ios::binary} << content;
        return path;
    }

private:
    QTemporaryDir folder_;
};

const char* text(const auto& result) {
    static std::string line;
    line = result ? "" : result.error().line();
    return line.c_str();
}

}  // namespace

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
    void passesNotFiniteOn_data();
    void passesNotFiniteOn();
    void curvesBecomeShortChords();
    void refuses_data();
    void refuses();
    void refusesPlaces_data();
    void refusesPlaces();
    void truncatedFilesAreErrors_data();
    void truncatedFilesAreErrors();
    void picksFields_data();
    void picksFields();
    void listsFieldsWhereOneMustBeChosen();
    void stops();
    void leavesNoTraces();
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
    QVERIFY2(read, text(read));
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
    QVERIFY2(read, text(read));
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
    QTest::newRow("GeoJSON") << "f.geojson"
                             << R"({"type":"Polygon","coordinates":[[[9,52],[9.003,52],[9.003,52.002],[9,52.002]]]})"
                             << one << boundary << 9.0;
    QTest::newRow("hole") << "f.geojson"
                          << R"({"type":"Polygon","coordinates":[[[9,52],[9.003,52],[9.003,52.002],[9,52]],)"
                             R"([[9.002,52.0005],[9.0025,52.001],[9.0025,52.0005]]]})"
                          << one << boundary << 9.002;
    QTest::newRow("both rings of well-known text")
        << "f.wkt" << "POLYGON((9 52, 9.003 52, 9.003 52.002), (9.002 52.0005, 9.0025 52.001, 9.0025 52.0005))"
        << "2 rings did not end where they began and were closed" << boundary << 9.0;
    QTest::newRow("another system") << "f.wkt" << "SRID=25832;POLYGON((500000 5761000, 500200 5761000, 500200 5761100))"
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
    // A table of points has no closing point to miss; nor does a ring whose ends are under a millimetre apart.
    QTest::newRow("points in a table") << "f.csv" << "lon,lat\n9,52\n9.003,52\n9.003,52.002\n" << "" << "" << 0.0;
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
    QVERIFY2(read, text(read));
    const std::vector<Note>& repairs = read->front().repairs;
    QCOMPARE(repairs.size(), said.isEmpty() ? 0U : 1U);
    if (!said.isEmpty()) {
        QCOMPARE(QString::fromStdString(repairs.front().text), said);
        QCOMPARE(QString::fromStdString(repairs.front().where), where);
        QVERIFY(repairs.front().place && std::abs(repairs.front().place->lonDeg - lonDeg) < kToleranceDeg);
    }
}

void TestBoundaryImport::keepsPartsTogether() {
    const auto read = readBoundaries(dataFile("geojson/two_fields.geojson"));
    QVERIFY2(read, text(read));
    const FieldSource& south = (*read)[1];
    QCOMPARE(south.parts.size(), 2U);
    QVERIFY(sameRing(south.parts[1].outer, {{9.01, 51.99}, {9.013, 51.99}, {9.013, 51.992}}));
    QCOMPARE(south.origin, std::string{"two_fields.geojson, feature 2"});
}

void TestBoundaryImport::readsOwnPlans() {
    const auto read = readBoundaries(dataFile("geojson/plan.geojson"));
    QVERIFY2(read, text(read));
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
                     {{9.0005, 52.0002}, {9.0006, 52.0002}, {9.0006, 52.0003}}));
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
    QVERIFY2(read, text(read));
    QCOMPARE(QString::fromStdString(read->front().id), id);
    QCOMPARE(QString::fromStdString(read->front().name), name);
    QCOMPARE(read->front().origin, std::string{"f.geojson"});
}

void TestBoundaryImport::passesNotFiniteOn_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("content");
    QTest::newRow("NaN in GeoJSON")
        << "f.geojson"
        << R"({"type":"Polygon","coordinates":[[[9,52],[NaN,52],[9,52.1],[9,52]]]})";
    QTest::newRow("infinity in GeoJSON")
        << "f.geojson" << R"({"type":"Polygon","coordinates":[[[9,52],[1e999,52],[9,52.1],[9,52]]]})";
    QTest::newRow("NaN in well-known text") << "f.wkt" << "POLYGON((9 52, nan 52, 9 52.1, 9 52))";
    QTest::newRow("NaN in another system")
        << "f.wkt" << "SRID=25832;POLYGON((500000 5761000, nan 5761000, 500000 5762000, 500000 5761000))";
    QTest::newRow("NaN in a table") << "f.csv" << "lon,lat\n9,52\nnan,52\n9,52.1\n";
}

void TestBoundaryImport::passesNotFiniteOn() {
    QFETCH(QString, file);
    QFETCH(QString, content);
    const Scratch scratch;
    const auto read = readBoundaries(scratch.write(file.toStdString(), content.toStdString()));
    QVERIFY2(read, text(read));
    const GeoRing& ring = read->front().parts.front().outer;
    QCOMPARE(ring.size(), 3U);
    QVERIFY(!std::isfinite(ring[1].lonDeg));
}

void TestBoundaryImport::curvesBecomeShortChords() {
    // A circle of 400 m radius about 500000, 5761000 in UTM 32N: each chord's middle is r (1 - cos(0.5°))
    // = 1.5 cm inside it at one degree a chord.
    const Scratch scratch;
    const auto read = readBoundaries(scratch.write(
        "pivot.wkt",
        "SRID=25832;CURVEPOLYGON(CIRCULARSTRING(499600 5761000, 500400 5761000, 499600 5761000))"));
    QVERIFY2(read, text(read));
    const GeoPolygon& circle = read->front().parts.front();
    QVERIFY2(circle.outer.size() >= 300 && circle.outer.size() <= 400,
             std::to_string(circle.outer.size()).c_str());
    // Grid scale at the central meridian is 0.9996.
    const double expectedM2 = 3.14159265 * 400.0 * 400.0 / (0.9996 * 0.9996);
    QVERIFY(std::abs(geodesicArea(circle).si() / expectedM2 - 1.0) < 2e-4);
}

void TestBoundaryImport::refuses_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<bool>("unreadable");
    QTest::addColumn<QString>("message");
    const auto row = [](const char* name, const char* file, const QByteArray& content, bool unreadable,
                        const char* message) {
        QTest::newRow(name) << QString::fromUtf8(file) << content << unreadable << QString::fromUtf8(message);
    };
    row("empty file", "f.geojson", "", false, "f.geojson: the file is empty");
    row("blanks only", "f.geojson", "   \n", true, "no boundary");
    row("picture", "f.geojson", QByteArray{"\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16}, true, "the picture cannot be read");
    row("shapefile in name only", "f.shp", "POINT and nothing else", true, "f.shp");
    row("GeoJSON cut off", "f.geojson",
        R"({"type":"Polygon",)"
        "\n"
        R"("coordinates":[[[9,52],[9.1,)",
        true, "f.geojson, line 2, column 29: this is not JSON from here on");
    row("null as a coordinate", "f.geojson",
        R"({"type":"FeatureCollection","features":[)"
        R"({"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":[[[9,52],[9.1,52],[9,52.1],[9,52]]]}},)"
        R"({"type":"Feature","properties":{},"geometry":{"type":"MultiPolygon","coordinates":[[[[9,52],[9.1,52],[9,null],[9,52]]]]}}]})",
        false, "f.geojson, feature 2, part 1, ring 1, vertex 3: a coordinate is not a number");
    row("text as a coordinate", "f.geojson",
        R"({"type":"Polygon","coordinates":[[[9,52],["9.1",52],[9,52.1],[9,52]]]})", false,
        "ring 1, vertex 2: a coordinate is not a number");
    row("coordinate without latitude", "f.geojson",
        R"({"type":"Polygon","coordinates":[[[9,52],[9.1],[9,52.1],[9,52]]]})", false, "ring 1, vertex 2");
    row("lines only", "f.geojson", R"({"type":"LineString","coordinates":[[9,52],[9.1,52],[9,52.1]]})", false,
        "there is no field boundary in it, only 1 open line");
    row("points only", "f.geojson", R"({"type":"MultiPoint","coordinates":[[9,52],[9.1,52],[9,52.1]]})",
        false, "only 3 points");
    row("no features", "f.geojson", R"({"type":"FeatureCollection","features":[]})", false,
        "there is no field boundary in it;");
    row("broken well-known text", "f.wkt", "POLYGON((9 52, 9.1 52, 9 52.1, 9 52))\nPOLYGON((9 52, 9.1", false,
        "f.wkt, line 2, column 1: this is not well-known text");
    row("metres without a system", "f.wkt", "POLYGON((500000 5761000, 500100 5761000, 500000 5761100))",
        false, "500000.000, 5761000.000 is no longitude and latitude");
    row("unknown system", "f.wkt", "SRID=999999;POLYGON((9 52, 9.1 52, 9 52.1))", false, "SRID=");
    row("table without coordinates", "f.csv", "name,area\nA,5\nB,6\n", false,
        "neither a column WKT nor columns lon and lat");
    row("table with a word for a number", "f.csv", "lon,lat\n9,52\nabc,52\n9,52.1\n", false,
        "f.csv, row 2: 'abc', '52' is no longitude and latitude");
    row("table with a gap", "f.csv", "lon,lat\n9,52\n,52\n9,52.1\n", false, "f.csv, row 2");
    row("table in metres", "f.csv", "x,y\n500000,5761000\n500100,5761000\n500000,5761100\n", false,
        "f.csv, row 1");
    row("table with broken well-known text", "f.csv",
        "WKT,name\n\"POLYGON((9 52, 9.1 52, 9 52.1, 9 52))\",A\nPOLYGON(9),B\n", false, "f.csv, row 2");
    row("obstacle far from every field", "f.geojson",
        R"({"type":"FeatureCollection","features":[)"
        R"({"type":"Feature","properties":{"kind":"field"},"geometry":{"type":"Polygon","coordinates":[[[9,52],[9.1,52],[9,52.1],[9,52]]]}},)"
        R"({"type":"Feature","properties":{"kind":"field"},"geometry":{"type":"Polygon","coordinates":[[[8,52],[8.1,52],[8,52.1],[8,52]]]}},)"
        R"({"type":"Feature","properties":{"kind":"obstacle","name":"Pylon"},"geometry":{"type":"Polygon","coordinates":[[[1,52],[1.1,52],[1,52.1],[1,52]]]}}]})",
        false, "obstacle Pylon: it lies in none of the 2 fields");
    row("buffer that is no length", "f.geojson",
        R"({"type":"FeatureCollection","features":[)"
        R"({"type":"Feature","properties":{"kind":"field"},"geometry":{"type":"Polygon","coordinates":[[[9,52],[9.1,52],[9,52.1],[9,52]]]}},)"
        R"({"type":"Feature","properties":{"kind":"obstacle","name":"Pylon","buffer_m":-1},"geometry":{"type":"Polygon","coordinates":[[[9.01,52.01],[9.02,52.01],[9.01,52.02],[9.01,52.01]]]}}]})",
        false, "buffer_m: '-1' is no length");
    row("zip of nothing", "f.zip", QByteArray{"PK\x05\x06\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0", 22}, true,
        "f.zip");
}

void TestBoundaryImport::refuses() {
    QFETCH(QString, file);
    QFETCH(QByteArray, content);
    QFETCH(bool, unreadable);
    QFETCH(QString, message);
    const Scratch scratch;
    const auto read = readBoundaries(scratch.write(file.toStdString(), content.toStdString()));
    QVERIFY(!read);
    QVERIFY2(read.error().line().contains(message.toStdString()), text(read));
    QVERIFY2((read.error().code == ErrorCode::ReadFailed) == unreadable, text(read));
    QVERIFY2((read.error().code == ErrorCode::InputRefused) == !unreadable, text(read));
    QVERIFY2(!read.error().remedy.empty(), text(read));
}

void TestBoundaryImport::refusesPlaces_data() {
    QTest::addColumn<QString>("path");
    QTest::addColumn<QString>("message");
    QTest::newRow("missing") << "/no/such/file.geojson" << "/no/such/file.geojson: there is no such file";
    QTest::newRow("folder") << FURROW_TEST_DATA_DIR "/imports/geojson" << "this folder holds no TASKDATA.XML";
    QTest::newRow("device") << "/dev/null" << "this is no ordinary file";
    QTest::newRow("web address") << "https://example.org/field.geojson" << "only files on this computer";
    QTest::newRow("file system of GDAL's")
        << "/vsicurl/https://example.org/field.geojson" << "only files on this computer";
    QTest::newRow("shapefile without its index") << "" << "the .shx file that belongs to it is missing";
    QTest::newRow("zip without boundaries")
        << QString::fromStdString(dataFile("zip/nothing_of_use.zip").string())
        << "no boundary file in this zip";
}

void TestBoundaryImport::refusesPlaces() {
    QFETCH(QString, path);
    QFETCH(QString, message);
    const Scratch scratch;
    std::filesystem::path file{path.toStdString()};
    if (path.isEmpty()) {
        file = scratch.write("lonely.shp", bytesOf(dataFile("shapefile/field_utm32.shp")));
    }
    const auto read = readBoundaries(file);
    QVERIFY(!read);
    QVERIFY2(read.error().line().contains(message.toStdString()), text(read));
    QVERIFY(read.error().code == ErrorCode::ReadFailed);
}

void TestBoundaryImport::truncatedFilesAreErrors_data() {
    QTest::addColumn<QString>("file");
    for (const char* file :
         {"geojson/field.geojson", "shapefile/field_utm32.shp", "zip/shapefile_flat.zip",
          "zip/geopackage.zip", "kml/field.kml", "kml/without_document.kmz", "gpkg/two_layers.gpkg",
          "gml/field_mercator.gml", "flatgeobuf/field_laea.fgb", "filegdb/field.gdb.zip", "wkt/field.wkt"}) {
        QTest::newRow(file) << QString::fromUtf8(file);
    }
}

void TestBoundaryImport::truncatedFilesAreErrors() {
    QFETCH(QString, file);
    const std::filesystem::path whole = dataFile(file);
    const std::string bytes = bytesOf(whole);
    for (const double share : {0.02, 0.2, 0.5, 0.8, 0.95}) {
        const Scratch scratch;
        const auto size = static_cast<std::size_t>(share * static_cast<double>(bytes.size()));
        for (const char* companion : {".shx", ".dbf", ".prj", ".xsd"}) {
            std::filesystem::path beside = whole;
            beside.replace_extension(companion);
            if (std::filesystem::exists(beside)) {
                scratch.write(beside.filename().string(), bytesOf(beside));
            }
        }
        const auto read = readBoundaries(scratch.write(whole.filename().string(), bytes.substr(0, size)));
        if (read) {
            // What lies behind the end of the boundary in the file may be cut off without harm.
            QVERIFY2(isNorthField(read->front()), std::format("cut to {}", share).c_str());
        } else {
            QVERIFY2(
                read.error().code == ErrorCode::ReadFailed || read.error().code == ErrorCode::InputRefused,
                text(read));
        }
    }
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
    const GeoPolygon ground{.outer = kOuter, .holes = {}};
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
        QVERIFY2(picked, text(picked));
        QVERIFY(*picked == fields[static_cast<std::size_t>(index)]);
    } else {
        QVERIFY(!picked && picked.error().code == ErrorCode::Usage);
        QVERIFY2(picked.error().line().contains(message.toStdString()), text(picked));
    }
}

void TestBoundaryImport::listsFieldsWhereOneMustBeChosen() {
    std::vector<FieldSource> fields(23);
    for (std::size_t i = 0; i < fields.size(); ++i) {
        fields[i].id = std::format("f{}", i + 1);
        fields[i].parts = {{.outer = kOuter, .holes = {kHole}}};
    }
    const auto picked = pickField(fields, std::nullopt);
    QVERIFY(!picked && picked.error().code == ErrorCode::Usage);
    const std::string line = picked.error().line();
    QVERIFY2(line.contains("the file has 23 fields: 1 f1 (3.82 ha), 2 f2"), line.c_str());
    QVERIFY2(line.contains("20 f20 (3.82 ha) and 3 more") && !line.contains("f21"), line.c_str());
    fields.resize(1);
    QVERIFY(pickField(fields, std::nullopt));
}

void TestBoundaryImport::stops() {
    std::stop_source source;
    source.request_stop();
    const auto read = readBoundaries(dataFile("geojson/two_fields.geojson"), {.stop = source.get_token()});
    QVERIFY(!read && read.error().code == ErrorCode::Cancelled);
}

void TestBoundaryImport::leavesNoTraces() {
    // Neither files beside the one that is read nor words on standard error.
    const QTemporaryDir folder;
    const std::filesystem::path target{folder.path().toStdString()};
    std::filesystem::copy(dataFile(""), target, std::filesystem::copy_options::recursive);
    std::ofstream{target / "broken.gpkg"} << "SQLite format 3";
    const auto listing = [&target] {
        std::vector<std::filesystem::path> files;
        for (const auto& entry : std::filesystem::recursive_directory_iterator{target}) {
            files.push_back(entry.path());
        }
        std::ranges::sort(files);
        return files;
    };
    const auto before = listing();
    const std::filesystem::path caught =
        std::filesystem::temp_directory_path() / std::format("furrow-stderr-{}", getpid());
    std::fflush(stderr);
    const int terminal = dup(STDERR_FILENO);
    const int file = open(caught.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600);
    dup2(file, STDERR_FILENO);
    for (const std::filesystem::path& path : before) {
        [[maybe_unused]] const auto read = readBoundaries(path);
    }
    std::fflush(stderr);
    dup2(terminal, STDERR_FILENO);
    close(file);
    close(terminal);
    const std::string words = bytesOf(caught);
    std::filesystem::remove(caught);
    QVERIFY2(words.empty(), words.c_str());
    QVERIFY(listing() == before);
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

QTEST_APPLESS_MAIN(TestBoundaryImport)
#include "tst_boundary_import.moc"
