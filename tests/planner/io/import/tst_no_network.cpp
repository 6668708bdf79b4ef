#include "planner/field/field.h"
#include "planner/gdal/elevation.h"
#include "planner/gdal/zip.h"
#include "planner/imagery/imagery.h"
#include "planner/io/delivery/field_files.h"
#include "planner/io/import/boundary_import.h"
#include "planner/io/import/field_reader.h"
#include "planner/io/import/guide_import.h"
#include "planner/io/import/track_reader.h"
#include "planner/machine/machine_file.h"
#include "planner/project/project_file.h"
#include "tests/support/furrow_cli.h"
#include "tests/support/no_network.h"
#include "tests/support/result_check.h"
#include "tests/support/scratch.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <sqlite3.h>

#include <format>
#include <utility>
#include <vector>

using namespace furrow;
using namespace furrow::test;

namespace {

// Nobody listens there; whoever asks is seen before that matters.
constexpr std::string_view kAddress = "http://127.0.0.1:9/away";

constexpr std::string_view kRing = "[[5,52],[5.003,52],[5.003,52.002],[5,52.002],[5,52]]";

std::string polygon(std::string_view more = {}) {
    return std::format(R"({{"type":"Polygon",{}"coordinates":[{}]}})", more, kRing);
}

std::string feature(std::string_view more = {}, std::string_view moreOfGeometry = {}) {
    return std::format(R"({{"type":"Feature",{}"properties":{{}},"geometry":{}}})", more,
                       polygon(moreOfGeometry));
}

std::string collection(std::string_view more, const std::string& features) {
    return std::format(R"({{"type":"FeatureCollection",{}"features":[{}]}})", more, features);
}

std::string link(std::string_view type, std::string_view member) {
    return std::format(R"("crs":{{"type":"{}","properties":{{"{}":"{}"}}}},)", type, member, kAddress);
}

std::string gml(std::string_view encoding) {
    return std::format(
        R"(<?xml version="1.0" encoding="{1}"?><!DOCTYPE x SYSTEM "{0}.dtd" [<!ENTITY e SYSTEM "{0}.txt">]>)"
        R"(<ogr:FeatureCollection xmlns:ogr="http://ogr.maptools.org/" xmlns:gml="http://www.opengis.net/gml" )"
        R"(xmlns:xlink="http://www.w3.org/1999/xlink" xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" )"
        R"(xsi:schemaLocation="http://ogr.maptools.org/ {0}.xsd"><gml:featureMember><ogr:a fid="a">)"
        R"(<ogr:other xlink:href="{0}.gml#b"/><ogr:geometryProperty xlink:href="{0}.gml#c"><gml:Polygon srsName="{0}">)"
        R"(<gml:outerBoundaryIs><gml:LinearRing><gml:coordinates>5,52 5.003,52 5.003,52.002 5,52</gml:coordinates>)"
        R"(</gml:LinearRing></gml:outerBoundaryIs></gml:Polygon></ogr:geometryProperty></ogr:a></gml:featureMember>)"
        R"(</ogr:FeatureCollection>)",
        kAddress, encoding);
}

std::string kml() {
    return std::format(
        R"(<?xml version="1.0"?><!DOCTYPE kml SYSTEM "{0}.dtd"><kml xmlns="http://www.opengis.net/kml/2.2"><Document>)"
        R"(<Style id="s"><IconStyle><Icon><href>{0}.png</href></Icon></IconStyle></Style><Schema id="{0}#x"/>)"
        R"(<NetworkLink><Link><href>{0}.kml</href></Link></NetworkLink>)"
        R"(<GroundOverlay><Icon><href>{0}.png</href></Icon></GroundOverlay>)"
        R"(<Placemark><styleUrl>{0}.kml#s</styleUrl><Polygon><outerBoundaryIs><LinearRing><coordinates>)"
        R"(5,52 5.003,52 5.003,52.002 5,52</coordinates></LinearRing></outerBoundaryIs></Polygon></Placemark>)"
        R"(</Document></kml>)",
        kAddress);
}

std::string rasterVrt() {
    return std::format(
        R"(<VRTDataset rasterXSize="4" rasterYSize="4"><SRS>{0}</SRS><GeoTransform>5,0.001,0,52,0,-0.001</GeoTransform>)"
        R"(<VRTRasterBand dataType="Byte" band="1"><SimpleSource><SourceFilename>/vsicurl/{0}.tif</SourceFilename>)"
        R"(<SourceBand>1</SourceBand></SimpleSource></VRTRasterBand></VRTDataset>)",
        kAddress);
}

std::string vectorVrt() {
    return std::format(
        R"(<OGRVRTDataSource><OGRVRTLayer name="away"><SrcDataSource>/vsicurl/{0}.geojson</SrcDataSource>)"
        R"(<LayerSRS>{0}</LayerSRS></OGRVRTLayer></OGRVRTDataSource>)",
        kAddress);
}

std::string tileService() {
    return std::format(
        R"(<GDAL_WMS><Service name="TMS"><ServerUrl>{}/${{z}}/${{x}}/${{y}}.png</ServerUrl></Service>)"
        R"(<DataWindow><UpperLeftX>-2e7</UpperLeftX><UpperLeftY>2e7</UpperLeftY><LowerRightX>2e7</LowerRightX>)"
        R"(<LowerRightY>-2e7</LowerRightY><TileLevel>3</TileLevel><TileCountX>1</TileCountX>)"
        R"(<TileCountY>1</TileCountY></DataWindow><Projection>EPSG:3857</Projection><BandsCount>3</BandsCount></GDAL_WMS>)",
        kAddress);
}

std::string taskData() {
    return std::format(
        R"(<?xml version="1.0"?><!DOCTYPE x SYSTEM "{0}.dtd" [<!ENTITY e SYSTEM "{0}.txt">]>)"
        R"(<ISO11783_TaskData VersionMajor="4" VersionMinor="3" DataTransferOrigin="1"><XFR A="{0}" B="1"/>)"
        R"(<PFD A="PFD1" C="&e;" D="0"><PLN A="1"><LSG A="1"><PNT A="2" C="52" D="5"/><PNT A="2" C="52" D="5.003"/>)"
        R"(<PNT A="2" C="52.002" D="5.003"/></LSG></PLN></PFD></ISO11783_TaskData>)",
        kAddress);
}

/// Heights whose side files name what lies elsewhere.
void writeHeights(const Scratch& scratch) {
    scratch.write(
        "heights.asc",
        "ncols 2\nnrows 2\nxllcorner 5\nyllcorner 52\ncellsize 0.01\nNODATA_value -9999\n1 2\n3 4\n");
    scratch.write("heights.prj", std::format("Projection LATLONG\nParameters {}\n", kAddress));
    scratch.write(
        "heights.asc.aux.xml",
        std::format(
            R"(<PAMDataset><SRS>{0}</SRS><Metadata domain="OVERVIEWS"><MDI key="OVERVIEW_FILE">)"
            R"(/vsicurl/{0}.ovr</MDI></Metadata><Metadata><MDI key="OVERVIEW_FILE">{0}</MDI></Metadata>)"
            R"(</PAMDataset>)",
            kAddress));
}

void run(sqlite3* database, const std::string& sql) {
    char* why = nullptr;
    if (sqlite3_exec(database, sql.c_str(), nullptr, nullptr, &why) != SQLITE_OK) {
        qFatal("%s: %s", sql.c_str(), why);
    }
}

/// A GeoPackage whose coordinate system is an address, and with a view that calls a service for each row.
void writeGeoPackage(const Scratch& scratch) {
    FieldContent content;
    content.field.id = "1";
    content.field.name = "Away";
    content.field.parts = {{.outer = {{5.0, 52.0}, {5.003, 52.0}, {5.003, 52.002}}, .holes = {}}};
    const auto file = scratch.path("away.gpkg");
    if (const auto written = writeFields({&content, 1}, file, "geopackage", {}, {}); !written) {
        qFatal("%s", written.error().line().c_str());
    }
    sqlite3* database = nullptr;
    sqlite3_open(file.c_str(), &database);
    run(database,
        std::format("UPDATE gpkg_spatial_ref_sys SET definition='{0}', organization='{0}'", kAddress));
    run(database, "CREATE VIEW lookup AS SELECT 1 AS fid, ogr_geocode('Wageningen') AS geom");
    run(database,
        "INSERT INTO gpkg_contents(table_name,data_type,identifier,srs_id) VALUES('lookup','features','lookup',4326)");
    run(database, "INSERT INTO gpkg_geometry_columns VALUES('lookup','geom','GEOMETRY',4326,0,0)");
    sqlite3_close(database);
}

struct Trick {
    std::string file;
    std::string content;
};

std::vector<Trick> tricks() {
    const std::string object = link("link", "href");
    const std::string url{kAddress};
    return {
        {"link.geojson", collection(object, feature())},
        {"link_url.geojson", collection(link("link", "url"), feature())},
        {"url.geojson", collection(link("URL", "url"), feature())},
        {"link_of_feature.geojson", collection({}, feature(object))},
        {"link_of_geometry.geojson", collection({}, feature({}, object))},
        {"feature_with_link.geojson", feature(object)},
        {"geometry_with_link.geojson", polygon(object)},
        {"link_behind_comment.geojson", "/* lax */ " + collection(object, feature())},
        {"link_in_sequence.geojsonl", feature(object) + "\n" + feature(object) + "\n"},
        {"name.geojson",
         collection(R"("crs":{"type":"name","properties":{"name":")" + url + "\"}},", feature())},
        {"next.geojson", collection(R"("links":[{"rel":"next","href":")" + url + "\"}],", feature())},
        {"items.json",
         collection(R"("stac_version":"1.0.0","links":[{"rel":"next","href":")" + url + "\"}],", feature())},
        {"jsonfg.json",
         std::format(
             R"({{"type":"FeatureCollection","conformsTo":["http://www.opengis.net/spec/json-fg-1/0.2/conf/core"],)"
             R"("coordRefSys":"{}","features":[{{"type":"Feature","id":1,"time":null,"geometry":null,)"
             R"("place":{},"properties":{{}}}}]}})",
             url, polygon())},
        {"esri.json",
         std::format(R"({{"geometryType":"esriGeometryPolygon","spatialReference":{{"wkt":"{}"}},)"
                     R"("features":[{{"attributes":{{}},"geometry":{{"rings":[{}]}}}}]}})",
                     url, kRing)},
        {"away.kml", kml()},
        {"away.gml", gml("UTF-8")},
        {"latin.gml", gml("ISO-8859-15")},
        {"raster.vrt", rasterVrt()},
        {"raster.tif", rasterVrt()},
        {"vector.vrt", vectorVrt()},
        {"vector.geojson", vectorVrt()},
        {"service.xml", tileService()},
        {"service.png", tileService()},
        {"away.gpx",
         std::format(
             R"(<?xml version="1.0"?><!DOCTYPE gpx SYSTEM "{0}.dtd"><gpx version="1.1"><trk><link href="{0}"/>)"
             R"(<trkseg><trkpt lat="52" lon="5"/><trkpt lat="52" lon="5.001"/></trkseg></trk></gpx>)",
             url)},
        {"TASKDATA/TASKDATA.XML", taskData()},
        {"away.url", "[InternetShortcut]\nURL=" + url + "\n"},
        {"http:/127.0.0.1:9/f.geojson", collection({}, feature())},
        {"WFS:http.geojson", collection({}, feature())},
        {"away.csv", "WKT,name\n" + url + ",a\n/vsicurl/" + url + ",b\n"},
        {"away.wkt", "SRID=" + url + ";POLYGON((5 52,5.003 52,5.003 52.002,5 52))"},
        {"machine.json", R"({"name":")" + url + "\"}"},
        {"away.furrow",
         std::format(
             R"({{"type":"FeatureCollection",{0}"furrow_project":{{"format_version":1,"name":"Away","current":{{}},)"
             R"("imagery":[{{"path":"/vsicurl/{1}.tif","name":"a","visible":true,"opacity":1}},)"
             R"({{"path":"{1}/{{z}}/{{x}}/{{y}}.png","name":"b","visible":true,"opacity":1}}],"plans":[]}},"features":[]}})",
             object, url)},
    };
}

std::vector<std::filesystem::path> writeTricks(const Scratch& scratch) {
    std::vector<std::filesystem::path> files;
    for (const Trick& trick : tricks()) {
        files.push_back(scratch.write(trick.file, trick.content));
    }
    const std::vector<FileInMemory> inside{{"doc.kml", kml()}, {"link.geojson", tricks().front().content}};
    files.push_back(scratch.write("away.kmz", zipOf(inside).value()));
    files.push_back(scratch.write("away.zip", zipOf(inside).value()));
    files.push_back(scratch.path("TASKDATA"));
    files.push_back(scratch.path("http:"));
    writeHeights(scratch);
    files.push_back(scratch.path("heights.asc"));
    writeGeoPackage(scratch);
    files.push_back(scratch.path("away.gpkg"));
    // No files, but names that GDAL understands.
    for (const char* const prefix :
         {"", "/vsicurl/", "/vsicurl_streaming/", "/vsis3/", "/vsigs/", "/vsiaz/", "/vsiadls/", "/vsioss/",
          "/vsiswift/", "/vsihdfs/", "/vsiwebhdfs/", "WFS:", "WMS:", "OAPIF:"}) {
        files.emplace_back(prefix + std::string{kAddress} + ".geojson");
    }
    return files;
}

Field smallField() {
    return Field::create({.parts = {{.outer = {{5.0, 52.0}, {5.003, 52.0}, {5.003, 52.002}}, .holes = {}}}})
        .value();
}

/// Every way in which the planner reads a file that a user names.
void openEveryWay(const std::filesystem::path& path) {
    static const Field field = smallField();
    (void)readFields(path);
    (void)readTracks(path);
    (void)readRows(path, field, {});
    (void)readElevation(path, field.frame(), bounds(field.workable()), {});
    if (const auto opened = readProject(path)) {
        for (const ImageryLayer& layer : opened->project.imagery) {
            (void)openImagery(layer.path);
        }
    }
    (void)readMachineFile(path);
    (void)isImagery(path);
    if (const auto imagery = openImagery(path)) {
        (void)(*imagery)->tile({10, 526, 337}, {});
    }
}

}  // namespace

/// What is read never makes the program ask another computer.
class TestNoNetwork : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void theWatchSees();
    void readersAskNobody();
    void theProgramAsksNobody();

private:
    Scratch scratch_;
    std::vector<std::filesystem::path> files_;
};

void TestNoNetwork::initTestCase() {
    files_ = writeTricks(scratch_);
    if (!watchSockets()) {
        QSKIP("sockets cannot be watched here");
    }
}

void TestNoNetwork::theWatchSees() {
    QVERIFY(socket(AF_INET, SOCK_STREAM, 0) < 0);
    QVERIFY(socket(AF_INET6, SOCK_DGRAM, 0) < 0);
    QCOMPARE(static_cast<int>(outsideSockets), 2);
    QVERIFY(socket(AF_UNIX, SOCK_STREAM, 0) >= 0);
    QCOMPARE(static_cast<int>(outsideSockets), 2);
}

void TestNoNetwork::readersAskNobody() {
    for (const std::filesystem::path& file : files_) {
        outsideSockets = 0;
        openEveryWay(file);
        VERIFY_TOLD(outsideSockets == 0, QByteArray::fromStdString(file.string()));
    }
}

void TestNoNetwork::theProgramAsksNobody() {
    for (const std::filesystem::path& file : files_) {
        const Answer answer = furrowCli({"list", "fields", QString::fromStdString(file.string())});
        VERIFY_TOLD(answer.status >= 0, QByteArray::fromStdString(file.string()));
    }
    for (const char* const setting :
         {"swaths.method=rows,swaths.rows", "swaths.method=contour,swaths.elevation"}) {
        const QStringList words = QString::fromLatin1(setting).split(',');
        const Answer answer =
            furrowCli({"plan", sampleField("slanted_field"), "--quiet", "--set", words[0], "--set",
                       words[1] + "=/vsicurl/" + QString::fromUtf8(kAddress.data()), "--out",
                       QString::fromStdString(scratch_.path("plan").string())});
        VERIFY_TOLD(answer.status == 4, answer.all());
    }
}

FURROW_TEST(TestNoNetwork);
#include "tst_no_network.moc"
