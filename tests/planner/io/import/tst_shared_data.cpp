#include "planner/io/import/boundary_import.h"
#include "tests/support/large_data.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include <cmath>
#include <map>

using namespace furrow;

// Real files that nobody of this project made, where they lie beside it. The numbers of fields and the
// areas were counted by other programs (see the README there); the reasons are what a look into the
// files shows.

namespace {

QDir sharedData() {
    return QDir{test::largeData({})};
}

struct Expected {
    const char* file;
    int fields;          ///< 0: refused
    const char* reason;  ///< part of the message
};

constexpr Expected kExpected[] = {
    {"fields/parcel_registers/ai4sf/1_vietnam_areas.gpkg", 100, ""},
    {"fields/parcel_registers/at/inspire_schlaege_2025-1_polygon.gpkg.zip", 100, ""},
    {"fields/parcel_registers/be_vlg/"
     "Landbouwgebruikspercelen_2023_-_Definitief_(extractie_28-03-2024)_GPKG.zip",
     100, ""},
    // Ten parcels and, in a layer of its own, the extent of the data set.
    {"fields/parcel_registers/be_wal/LU_ExistingLandUse_SIGEC2022.gml.zip", 11, ""},
    {"fields/parcel_registers/bg/bg_arable_land_2024.zip", 100, ""},
    {"fields/parcel_registers/de_bb/antrag.zip", 100, ""},
    {"fields/parcel_registers/de_sh/Feldbloecke_2026_GPKG.zip", 100, ""},
    {"fields/parcel_registers/dk/Marker_2026.zip", 100, ""},
    {"fields/parcel_registers/fi/LandUse.ExistingLandUse.GSAAAgriculturalParcel.gpkg", 100, ""},
    {"fields/parcel_registers/ie/GSAA_2024.zip", 100, ""},
    {"fields/parcel_registers/india_10k/india_10k.zip", 100, ""},
    {"fields/parcel_registers/jecam/BD_JECAM_CIRAD_2023_feb.shp", 100, ""},
    {"fields/parcel_registers/nl/brpgewaspercelen_definitief_2023.gpkg", 100, ""},
    {"fields/parcel_registers/nz/irrigated-land-area-raw-2020-update.zip", 100, ""},
    {"fields/parcel_registers/se/se2023.zip", 10, ""},
    {"fields/parcel_registers/us_ca_scm/i15_crop_mapping_2023_provisional_20241127.gdb.zip", 100, ""},
    {"fields/parcel_registers/us_usda_cropland/NationalCSB_2017-2024_rev23.zip", 100, ""},
    {"formats/geojson/f2c_strips.geojson", 3, ""},
    {"formats/geojson/f2c_swaths.geojson", 0, "only 3 open lines"},
    {"formats/geojson/farmtrax_wur.geojson", 78, ""},
    {"formats/geojson/farmvibes_sensor_farm_boundary.geojson", 1, ""},
    {"formats/geojson/farmvibes_sensor_samples.geojson", 0, "only 104 points"},
    {"formats/geojson/fiboa_example.json", 2, ""},
    {"formats/geojson/isoxml-js_test.geojson", 2, ""},
    {"formats/geojson/josephinum_app_map_vector.geojson", 4, ""},
    {"formats/kml/agopengps_test.kml", 2, ""},
    {"formats/kml/agopengps_test_field.kml", 7, ""},
    {"formats/kml/libkml_kmlsamples.kml", 10, ""},
    {"formats/kml/togeojson_extended_data.kml", 0, "only 1 point"},
    {"formats/kml/togeojson_gxtrack.kml", 0, "only 1 open line"},
    {"formats/kml/togeojson_linestring.kml", 0, "only 2 open lines"},
    {"formats/kml/togeojson_multigeometry.kml", 0, "only 2 open lines"},
    {"formats/kml/togeojson_polygon.kml", 1, ""},
    {"formats/kml/togeojson_style_url.kml", 1, ""},
    {"formats/kmz/libkml_doc.kmz", 0, "no field boundary"},
    {"formats/kmz/libkml_hier.kmz", 0, "no field boundary"},
    {"formats/kmz/libkml_lc01.kmz", 2, ""},
    {"formats/kmz/libkml_multikml-doc.kmz", 0, "no field boundary"},
    {"formats/kmz/libkml_multikml-nodoc.kmz", 0, "no field boundary"},
    {"formats/kmz/libkml_screenoverlay-continents.kmz", 4, ""},
    {"formats/gml/f2c_envelope1.xml", 1, ""},
    {"formats/gml/f2c_test1.xml", 1, ""},
    {"formats/shapefile/isoxml_py_big_boundary/Boundary.shp", 1, ""},
    {"formats/shapefile/isoxml_py_small_boundary/Boundary.shp", 1, ""},
    {"formats/shapefile/pacu_boundary/boundary.shp", 1, ""},
    {"formats/shapefile/pacu_cobs_a_aoi/cobs_a_aoi.shp", 1, ""},
};

std::filesystem::path pathOf(const QString& file) {
    return sharedData().filePath(file).toStdString();
}

}  // namespace

class TestSharedData : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void readsEveryFile_data();
    void readsEveryFile();
    void knowsEveryFile();
    void readsEveryBenchmarkField();
    void areasAreThoseOfTheList();
    void readsTheWholeList();
};

void TestSharedData::initTestCase() {
    if (!sharedData().exists()) {
        QSKIP("needs the large test data");
    }
}

void TestSharedData::readsEveryFile_data() {
    QTest::addColumn<int>("fields");
    QTest::addColumn<QString>("reason");
    for (const Expected& expected : kExpected) {
        QTest::newRow(expected.file) << expected.fields << QString::fromUtf8(expected.reason);
    }
}

void TestSharedData::readsEveryFile() {
    QFETCH(int, fields);
    QFETCH(QString, reason);
    const auto read = readBoundaries(pathOf(QString::fromUtf8(QTest::currentDataTag())));
    if (fields == 0) {
        QVERIFY(!read);
        QVERIFY2(read.error().line().contains(reason.toStdString()), read.error().line().c_str());
        return;
    }
    QVERIFY2(read, read ? "" : read.error().line().c_str());
    QCOMPARE(static_cast<int>(read->size()), fields);
    for (const FieldSource& field : *read) {
        QVERIFY(!field.id.empty() && !field.name.empty() && !field.parts.empty());
        QVERIFY(std::isfinite(areaOf(field).si()));
    }
}

void TestSharedData::knowsEveryFile() {
    // A file that was added there has no row here yet.
    for (const char* folder : {"fields/parcel_registers", "formats/geojson", "formats/kml", "formats/kmz",
                               "formats/gml", "formats/shapefile"}) {
        const QDir dir{sharedData().filePath(QString::fromUtf8(folder))};
        for (const QString& sub : QStringList{"."} + dir.entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
            for (const QString& name : QDir{dir.filePath(sub)}.entryList(QDir::Files)) {
                if (name.endsWith(".dbf") || name.endsWith(".shx") || name.endsWith(".prj") ||
                    name.endsWith(".cpg")) {
                    continue;
                }
                const QString file = QDir::cleanPath(QString::fromUtf8(folder) + "/" + sub + "/" + name);
                QVERIFY2(std::ranges::any_of(
                             kExpected, [&file](const Expected& expected) { return file == expected.file; }),
                         qPrintable(file));
            }
        }
    }
}

void TestSharedData::readsEveryBenchmarkField() {
    const QDir dir{sharedData().filePath("fields/fields2benchmark")};
    const QStringList files = dir.entryList({"*.wkt"}, QDir::Files);
    QCOMPARE(files.size(), 158);
    double areaM2 = 0.0;
    for (const QString& file : files) {
        const auto read = readBoundaries(dir.filePath(file).toStdString());
        QVERIFY2(read, read ? "" : read.error().line().c_str());
        QCOMPARE(read->size(), 1U);
        areaM2 += areaOf(read->front()).si();
    }
    // 507.53 ha by the list in all_fields.geojson; f2b_nl_field_22 crosses itself, where areas are moot.
    QVERIFY2(std::abs(areaM2 / 1e4 - 507.53) < 0.5, std::to_string(areaM2).c_str());
}

void TestSharedData::areasAreThoseOfTheList() {
    // Sums of area_ha of all_fields.geojson by source: computed from the same files by another program.
    const struct {
        const char* file;
        double areaHa;
    } sums[] = {
        {"fields/parcel_registers/at/inspire_schlaege_2025-1_polygon.gpkg.zip", 58.00},
        {"fields/parcel_registers/bg/bg_arable_land_2024.zip", 2863.55},
        {"fields/parcel_registers/de_sh/Feldbloecke_2026_GPKG.zip", 502.76},
        {"fields/parcel_registers/dk/Marker_2026.zip", 264.15},
        {"fields/parcel_registers/fi/LandUse.ExistingLandUse.GSAAAgriculturalParcel.gpkg", 231.89},
        {"fields/parcel_registers/ie/GSAA_2024.zip", 320.37},
        {"fields/parcel_registers/jecam/BD_JECAM_CIRAD_2023_feb.shp", 56.38},
        {"fields/parcel_registers/nz/irrigated-land-area-raw-2020-update.zip", 904.60},
        {"fields/parcel_registers/us_ca_scm/i15_crop_mapping_2023_provisional_20241127.gdb.zip", 305.77},
        {"fields/parcel_registers/us_usda_cropland/NationalCSB_2017-2024_rev23.zip", 676.95},
    };
    for (const auto& sum : sums) {
        const auto read = readBoundaries(pathOf(QString::fromUtf8(sum.file)));
        QVERIFY2(read, read ? "" : read.error().line().c_str());
        double areaHa = 0.0;
        for (const FieldSource& field : *read) {
            areaHa += inHectares(areaOf(field));
        }
        // Each of the hundred was rounded to 1 m².
        QVERIFY2(std::abs(areaHa - sum.areaHa) < 0.02, std::format("{}: {}", sum.file, areaHa).c_str());
    }
}

void TestSharedData::readsTheWholeList() {
    const std::filesystem::path path = pathOf("fields/all_fields.geojson");
    const auto read = readBoundaries(path);
    QVERIFY2(read, read ? "" : read.error().line().c_str());
    QFile file{QString::fromStdString(path.string())};
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QJsonArray features = QJsonDocument::fromJson(file.readAll()).object()["features"].toArray();
    QCOMPARE(static_cast<qsizetype>(read->size()), features.size());
    for (qsizetype i = 0; i < features.size(); ++i) {
        const QJsonValue properties = features[i]["properties"];
        const FieldSource& field = (*read)[static_cast<std::size_t>(i)];
        QCOMPARE(QString::fromStdString(field.id), properties["id"].toString());
        std::size_t holes = 0;
        for (const GeoPolygon& part : field.parts) {
            holes += part.holes.size();
        }
        QCOMPARE(static_cast<int>(holes), properties["n_holes"].toInt());
        QCOMPARE(static_cast<int>(field.parts.size()), properties["n_parts"].toInt());
        // The list adds the holes of these three, which run the same way as their outer rings, instead of
        // taking them out. Their areas here are by the plane formula with the radii of the ellipsoid.
        static const std::map<std::string, double> corrected{
            {"isoxml_dev4agriculture_Partfields_TASKDATA_XML_13", 41.7787},
            {"isoxml_dev4agriculture_AllFieldsMoved_Or_Simplified_Out_02", 6.5276},
            {"isoxml_dev4agriculture_MultiFields_zip_04", 3.3188}};
        if (const auto found = corrected.find(field.id); found != corrected.end()) {
            QVERIFY(std::abs(inHectares(areaOf(field)) - found->second) < 5e-4);
        } else if (properties["valid"].toBool()) {
            const double listedHa = properties["area_ha"].toDouble();
            QVERIFY2(std::abs(inHectares(areaOf(field)) - listedHa) < 1e-4 + 1e-6 * listedHa,
                     field.id.c_str());
        }
    }
}

FURROW_TEST(TestSharedData);
#include "tst_shared_data.moc"
