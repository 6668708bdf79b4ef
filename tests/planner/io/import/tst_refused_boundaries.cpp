#include "planner/io/import/boundary_import.h"
#include "tests/support/north_field.h"
#include "tests/support/result_check.h"
#include "tests/support/scratch.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>
#include <QTest>

#include <fcntl.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <format>
#include <fstream>

using namespace furrow;
using namespace furrow::test;

class TestRefusedBoundaries : public QObject {
    Q_OBJECT

private slots:
    void passesNotFiniteOn_data();
    void passesNotFiniteOn();
    void refuses_data();
    void refuses();
    void refusesSystems_data();
    void refusesSystems();
    void takesSystems_data();
    void takesSystems();
    void refusesPlaces_data();
    void refusesPlaces();
    void truncatedFilesAreErrors_data();
    void truncatedFilesAreErrors();
    void stops();
    void leavesNoTraces();
};

void TestRefusedBoundaries::passesNotFiniteOn_data() {
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

void TestRefusedBoundaries::passesNotFiniteOn() {
    QFETCH(QString, file);
    QFETCH(QString, content);
    const Scratch scratch;
    const auto read = readBoundaries(scratch.write(file.toStdString(), content.toStdString()));
    VERIFY_RESULT(read);
    const GeoRing& ring = read->front().parts.front().outer;
    QCOMPARE(ring.size(), 3U);
    QVERIFY(!std::isfinite(ring[1].lonDeg));
}

namespace {

void row(const char* name, const char* file, const QByteArray& content, bool unreadable,
         const char* message) {
    QTest::newRow(name) << QString::fromUtf8(file) << content << unreadable << QString::fromUtf8(message);
}

void addWhatIsNoBoundaryFile() {
    row("empty file", "f.geojson", "", false, "f.geojson: the file is empty");
    row("blanks only", "f.geojson", "   \n", true, "no boundary");
    // GDAL 3.10 would wait for the rest of these lines for ever.
    row("drawing cut off within a line end", "f_EPSG32632.dxf",
        "  0\r\nSECTION\r\n  2\r\nHEADER\r\n  9\r\n$ACADVER\r\n  1\r\nAC1009\r", true, "the file is damaged");
    row("the same under another name", "f_EPSG32632.txt",
        "  0\nSECTION\n  2\nHEADER\n  9\n$ACADVER\n  1\nAC1009\r", true, "the file is damaged");
    row("drawing with a zero within a line end", "f_EPSG32632.dxf",
        QByteArray{"  0\nSECTION\n  2\nENTITIES\n  0\nPOLYLINE\n  8\nA\r"} + QByteArray(1, '\0') + "\nB\n",
        true, "the file is damaged");
    row("picture", "f.geojson", QByteArray{"\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16}, true,
        "the picture cannot be read");
    row("shapefile in name only", "f.shp", "POINT and nothing else", true, "f.shp");
    row("zip of nothing", "f.zip", QByteArray{"PK\x05\x06\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0", 22}, true,
        "f.zip");
}

void addGeoJson() {
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
}

void addTexts() {
    row("broken well-known text", "f.wkt", "POLYGON((9 52, 9.1 52, 9 52.1, 9 52))\nPOLYGON((9 52, 9.1", false,
        "f.wkt, line 2, column 1: this is not well-known text");
    row("metres without a system", "f.wkt", "POLYGON((500000 5761000, 500100 5761000, 500000 5761100))",
        false, "500000.000, 5761000.000 is no longitude and latitude");
    row("unknown system of a GML", "f.gml",
        R"(<?xml version="1.0"?><gml:FeatureCollection xmlns:gml="http://www.opengis.net/gml" xmlns:x="x">)"
        R"(<gml:featureMember><x:f><x:geom><gml:Polygon srsName="EPSG:99999"><gml:outerBoundaryIs>)"
        R"(<gml:LinearRing><gml:coordinates>9,51 9.003,51 9.003,51.003 9,51.003 9,51</gml:coordinates>)"
        R"(</gml:LinearRing></gml:outerBoundaryIs></gml:Polygon></x:geom></x:f></gml:featureMember>)"
        R"(</gml:FeatureCollection>)",
        false, "the coordinate system that it names is not known");
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
}

}  // namespace

void TestRefusedBoundaries::refuses_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<bool>("unreadable");
    QTest::addColumn<QString>("message");
    addWhatIsNoBoundaryFile();
    addGeoJson();
    addTexts();
}

void TestRefusedBoundaries::refuses() {
    QFETCH(QString, file);
    QFETCH(QByteArray, content);
    QFETCH(bool, unreadable);
    QFETCH(QString, message);
    const Scratch scratch;
    const auto read = readBoundaries(scratch.write(file.toStdString(), content.toStdString()));
    QVERIFY(!read);
    QVERIFY2(read.error().line().contains(message.toStdString()), read.error().line().c_str());
    QVERIFY2((read.error().code == ErrorCode::ReadFailed) == unreadable, read.error().line().c_str());
    QVERIFY2((read.error().code == ErrorCode::InputRefused) == !unreadable, read.error().line().c_str());
    QVERIFY2(!read.error().remedy.empty(), read.error().line().c_str());
}

namespace {

constexpr const char* kCollection =
    R"({"type":"FeatureCollection",%1"features":[)"
    R"({"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":[[[9,52],[9.1,52],[9,52.1],[9,52]]]}},)"
    R"({"type":"Feature",%2"properties":{},"geometry":{"type":"Polygon",%3"coordinates":[[[9,53],[9.1,53],[9,53.1],[9,53]]]}}]})";

Result<std::vector<FieldSource>> readCollection(const QString& ofFile, const QString& ofFeature,
                                                const QString& ofGeometry) {
    const auto member = [](const QString& crs) {
        return crs.isEmpty() ? crs : QStringLiteral("\"crs\":%1,").arg(crs);
    };
    const Scratch scratch;
    return readBoundaries(
        scratch.write("f.geojson", QString::fromUtf8(kCollection)
                                       .arg(member(ofFile), member(ofFeature), member(ofGeometry))
                                       .toStdString()));
}

}  // namespace

void TestRefusedBoundaries::refusesSystems_data() {
    QTest::addColumn<QString>("ofFile");
    QTest::addColumn<QString>("ofFeature");
    QTest::addColumn<QString>("ofGeometry");
    QTest::addColumn<QString>("message");
    const QString link = R"({"type":"link","properties":{"href":"http://example.org/25832"}})";
    const QString fetched = "its coordinate system would have to be fetched from 'http://example.org/25832'";
    QTest::newRow("link") << link << "" << "" << "f.geojson: " + fetched;
    QTest::newRow("link, of 2008's draft")
        << R"({"type":"URL","properties":{"url":"http://example.org/25832"}})" << "" << ""
        << "f.geojson: " + fetched;
    QTest::newRow("link of a feature") << "" << link << "" << "f.geojson, feature 2: " + fetched;
    QTest::newRow("link of a geometry") << "" << "" << link << "f.geojson, feature 2: " + fetched;
    QTest::newRow("unknown name") << R"({"type":"name","properties":{"name":"Gauss"}})" << "" << ""
                                  << "f.geojson: its coordinate system 'Gauss' is not known";
    QTest::newRow("name that is a file")
        << R"({"type":"name","properties":{"name":"/etc/hostname"}})" << "" << ""
        << "'/etc/hostname' is not known";
    QTest::newRow("another one in a feature")
        << "" << R"({"type":"name","properties":{"name":"EPSG:3857"}})" << ""
        << "f.geojson, feature 2: it has another coordinate system than the file";
}

void TestRefusedBoundaries::refusesSystems() {
    QFETCH(QString, ofFile);
    QFETCH(QString, ofFeature);
    QFETCH(QString, ofGeometry);
    QFETCH(QString, message);
    const auto read = readCollection(ofFile, ofFeature, ofGeometry);
    QVERIFY(!read);
    QVERIFY2(read.error().line().contains(message.toStdString()), read.error().line().c_str());
    QVERIFY2(read.error().code == ErrorCode::InputRefused, read.error().line().c_str());
    QVERIFY2(!read.error().remedy.empty(), read.error().line().c_str());
}

void TestRefusedBoundaries::takesSystems_data() {
    QTest::addColumn<QString>("ofFile");
    QTest::addColumn<QString>("ofFeature");
    QTest::newRow("none") << "" << "";
    QTest::newRow("null") << "null" << "";
    QTest::newRow("OGC's name") << R"({"type":"name","properties":{"name":"urn:ogc:def:crs:OGC:1.3:CRS84"}})"
                                << "";
    QTest::newRow("OGC's address, which is a name")
        << R"({"type":"name","properties":{"name":"http://www.opengis.net/def/crs/OGC/1.3/CRS84"}})" << "";
    QTest::newRow("code") << R"({"type":"EPSG","properties":{"code":4326}})" << "";
    QTest::newRow("the file's own in a feature")
        << R"({"type":"name","properties":{"name":"EPSG:4326"}})"
        << R"({"type":"name","properties":{"name":"urn:ogc:def:crs:OGC:1.3:CRS84"}})";
}

void TestRefusedBoundaries::takesSystems() {
    QFETCH(QString, ofFile);
    QFETCH(QString, ofFeature);
    const auto read = readCollection(ofFile, ofFeature, {});
    VERIFY_RESULT(read);
    QCOMPARE(read->size(), 2U);
    QCOMPARE(read->front().parts.front().outer.front().lonDeg, 9.0);
}

void TestRefusedBoundaries::refusesPlaces_data() {
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

void TestRefusedBoundaries::refusesPlaces() {
    QFETCH(QString, path);
    QFETCH(QString, message);
    const Scratch scratch;
    std::filesystem::path file{path.toStdString()};
    if (path.isEmpty()) {
        file = scratch.write("lonely.shp", bytesOf(dataFile("shapefile/field_utm32.shp")));
    }
    const auto read = readBoundaries(file);
    QVERIFY(!read);
    QVERIFY2(read.error().line().contains(message.toStdString()), read.error().line().c_str());
    QVERIFY(read.error().code == ErrorCode::ReadFailed);
}

void TestRefusedBoundaries::truncatedFilesAreErrors_data() {
    QTest::addColumn<QString>("file");
    for (const char* file :
         {"geojson/field.geojson", "shapefile/field_utm32.shp", "zip/shapefile_flat.zip",
          "zip/geopackage.zip", "kml/field.kml", "kml/without_document.kmz", "gpkg/two_layers.gpkg",
          "gml/field_mercator.gml", "flatgeobuf/field_laea.fgb", "filegdb/field.gdb.zip", "wkt/field.wkt"}) {
        QTest::newRow(file) << QString::fromUtf8(file);
    }
}

void TestRefusedBoundaries::truncatedFilesAreErrors() {
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
                read.error().line().c_str());
        }
    }
}

void TestRefusedBoundaries::stops() {
    std::stop_source source;
    source.request_stop();
    const auto read = readBoundaries(dataFile("geojson/two_fields.geojson"), {.stop = source.get_token()});
    QVERIFY(!read && read.error().code == ErrorCode::Cancelled);
}

void TestRefusedBoundaries::leavesNoTraces() {
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

FURROW_TEST(TestRefusedBoundaries);
#include "tst_refused_boundaries.moc"
