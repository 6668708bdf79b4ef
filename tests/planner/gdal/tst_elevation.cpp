// Heights from rasters on the disk: planes whose heights are worked by hand.

#include "planner/gdal/elevation.h"
#include "tests/planner/imagery/raster_samples.h"
#include "tests/support/scratch.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <filesystem>
#include <format>
#include <string>

using namespace furrow;

namespace {

constexpr GeoPoint kPlace{9.0, 49.0};
constexpr Bounds kBox{{-200.0, -150.0}, {200.0, 150.0}};
// a (1 - e²) / (1 - e² sin² 49°)^1.5 pi / 180 on the ellipsoid of WGS 84.
constexpr double kMetresPerDegree = 111'209.7;
constexpr double kCellDeg = 0.0005;
constexpr int kSide = 30;
constexpr double kHalfSideDeg = 0.5 * kSide * kCellDeg;

/// 100 m at 49° north, and a metre more for every 0.001°.
double heightAt(double latitude) {
    return 100.0 + 1000.0 * (latitude - kPlace.latDeg);
}

double northOf(int row) {
    return kPlace.latDeg + (0.5 * kSide - row - 0.5) * kCellDeg;
}

/// The plane in geographic coordinates.
std::string asciiPlane() {
    std::string text =
        std::format("ncols {}\nnrows {}\nxllcorner {}\nyllcorner {}\ncellsize {}\n", kSide, kSide,
                    kPlace.lonDeg - kHalfSideDeg, kPlace.latDeg - kHalfSideDeg, kCellDeg);
    for (int row = 0; row < kSide; ++row) {
        for (int column = 0; column < kSide; ++column) {
            text += std::format("{:.6f} ", heightAt(northOf(row)));
        }
        text += '\n';
    }
    return text;
}

/// The plane in the first band of a GeoTIFF; zero in the others.
bool writePlane(const std::filesystem::path& path, int bands, int epsg = 4326) {
    const test::RasterShape shape{
        .width = kSide,
        .height = kSide,
        .epsg = epsg,
        .affine = {kPlace.lonDeg - kHalfSideDeg, kCellDeg, 0.0, kPlace.latDeg + kHalfSideDeg, 0.0, -kCellDeg},
        .type = GDT_Float32,
        .options = {"INTERLEAVE=BAND"}};
    return test::writeTiff(QString::fromStdString(path.string()), shape, bands,
                           [](int band, int, int row) { return band == 0 ? heightAt(northOf(row)) : 0.0; });
}

Result<ElevationGrid> read(const std::filesystem::path& path, GeoPoint place = kPlace) {
    return readElevation(path, LocalFrame::centredOn(place).value(), kBox, {});
}

void compareWithPlane(const Result<ElevationGrid>& grid) {
    QVERIFY2(grid, grid ? "" : grid.error().line().c_str());
    for (const double northM : {-140.0, -60.0, 0.0, 100.0, 140.0}) {
        for (const double eastM : {-190.0, 0.0, 190.0}) {
            const auto column = static_cast<std::size_t>((eastM - grid->origin.x) / grid->cellM);
            const auto row = static_cast<std::size_t>((northM - grid->origin.y) / grid->cellM);
            const double cellNorthM = grid->origin.y + static_cast<double>(row) * grid->cellM;
            const double expected = 100.0 + 1000.0 * cellNorthM / kMetresPerDegree;
            const double found = grid->heightsM[row * grid->columns + column];
            QVERIFY2(std::abs(found - expected) < 0.002,
                     std::format("{} m north: {} m instead of {} m", cellNorthM, found, expected).c_str());
        }
    }
}

}  // namespace

class TestElevation : public QObject {
    Q_OBJECT

private slots:
    void heightsLieWhereTheyAre_data() {
        QTest::addColumn<int>("bands");
        QTest::newRow("ASCII grid") << 0;
        QTest::newRow("GeoTIFF") << 1;
        QTest::newRow("heights and their quality") << 2;
        // If all of them were warped, this would take 3 GB.
        QTest::newRow("3,000 bands") << 3'000;
    }
    void heightsLieWhereTheyAre() {
        QFETCH(const int, bands);
        const test::Scratch folder;
        const auto path = folder.path(bands == 0 ? "heights.asc" : "heights.tif");
        if (bands == 0) {
            folder.write("heights.asc", asciiPlane());
            folder.write("heights.prj", R"(GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,)"
                                        R"(298.257223563]],PRIMEM["Greenwich",0],)"
                                        R"(UNIT["degree",0.0174532925199433]])");
        } else {
            QVERIFY(writePlane(path, bands));
        }
        compareWithPlane(read(path));
    }

    void whatHasNoHeightsHereIsRefused() {
        const test::Scratch folder;
        QVERIFY(writePlane(folder.path("plane.tif"), 1));
        const auto elsewhere = read(folder.path("plane.tif"), {12.0, 49.0});
        QVERIFY(!elsewhere);
        QCOMPARE(elsewhere.error().code, ErrorCode::InputRefused);
        QVERIFY(writePlane(folder.path("no_system.tif"), 1, 0));
        const auto noSystem = read(folder.path("no_system.tif"));
        QVERIFY(!noSystem);
        QCOMPARE(noSystem.error().code, ErrorCode::InputRefused);
        const auto noRaster = read(folder.write("text.tif", "no heights"));
        QVERIFY(!noRaster);
        QCOMPARE(noRaster.error().code, ErrorCode::ReadFailed);
        const auto nothing = read(folder.path("nothing.tif"));
        QVERIFY(!nothing);
        QCOMPARE(nothing.error().code, ErrorCode::ReadFailed);
    }
};

FURROW_TEST(TestElevation);
#include "tst_elevation.moc"
