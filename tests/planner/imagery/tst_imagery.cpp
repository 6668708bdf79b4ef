#include "planner/imagery/imagery.h"
#include "planner/imagery/tile_pixels.h"
#include "tests/planner/imagery/raster_samples.h"
#include "tests/support/large_data.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <thread>

using namespace furrow;
using namespace furrow::test;

namespace {

std::filesystem::path pathOf(const QString& path) {
    return path.toStdU16String();
}

std::array<int, 4> pixel(const TilePicture& tile, int x, int y) {
    const std::size_t at =
        (static_cast<std::size_t>(y) * static_cast<std::size_t>(tile.side) + static_cast<std::size_t>(x)) * 4;
    return {tile.rgba[at], tile.rgba[at + 1], tile.rgba[at + 2], tile.rgba[at + 3]};
}

/// Middle of what is red, weighted by how red it is.
TilePlace middleOfRed(const TilePicture& tile) {
    double sum = 0.0;
    TilePlace middle;
    for (int y = 0; y < tile.side; ++y) {
        for (int x = 0; x < tile.side; ++x) {
            const auto [red, green, blue, alpha] = pixel(tile, x, y);
            const double weight = std::max(0, red - green);
            middle.x += weight * (x + 0.5);
            middle.y += weight * (y + 0.5);
            sum += weight;
        }
    }
    return {middle.x / sum, middle.y / sum};
}

/// Grey with one red square of 5 cells around the cell in the middle.
double redInTheMiddle(int band, int x, int y, int side) {
    const bool inside = std::abs(x - side / 2) <= 2 && std::abs(y - side / 2) <= 2;
    return inside ? (band == 0 ? 255.0 : 0.0) : 100.0;
}

/// Where contour lines cross a row of pixels.
std::vector<double> brownLines(const TilePicture& tile, int row) {
    const auto brown = [&](int column) {
        const auto p = pixel(tile, column, row);
        return p[0] - p[2];
    };
    std::vector<double> lines;
    for (int x = 1; x + 1 < 256; ++x) {
        if (brown(x) > 25 && brown(x) >= brown(x - 1) && brown(x) > brown(x + 1)) {
            lines.push_back(x + 0.5);
        }
    }
    return lines;
}

}  // namespace

class TestImagery : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    QString in(const char* name) const { return folder_.filePath(QLatin1String{name}); }

private slots:
    void aPlaceOfAGeoTiffInDegreesIsRightToAPixel() {
        // Cells of 1e-5 degrees; the middle of the red one is at 5.43215, 52.12345.
        constexpr double kCell = 1e-5;
        const RasterShape shape{
            .width = 101,
            .height = 101,
            .epsg = 4326,
            .affine = {5.43215 - 50.5 * kCell, kCell, 0.0, 52.12345 + 50.5 * kCell, 0.0, -kCell}};
        QVERIFY(writeTiff(in("degrees.tif"), shape, 3,
                          [](int band, int x, int y) { return redInTheMiddle(band, x, y, 101); }));
        const auto imagery = openImagery(pathOf(in("degrees.tif")));
        VERIFY_RESULT(imagery);
        QCOMPARE((*imagery)->facts().kind, ImageryKind::Picture);
        COMPARE_WITHIN((*imagery)->facts().southWest.lonDeg, 5.43215 - 50.5 * kCell, 1e-7);
        COMPARE_WITHIN((*imagery)->facts().northEast.latDeg, 52.12345 + 50.5 * kCell, 1e-6);
        // 1e-5 degrees of latitude are 1.11 m; zoom 18 has 0.367 m a pixel here.
        for (const int zoom : {17, 18, 19}) {
            const TilePlace place = tilePlace(5.43215, 52.12345, zoom);
            const auto tile = (*imagery)->tile({zoom, place.column(), place.row()}, {});
            VERIFY_RESULT(tile);
            QVERIFY(tile->has_value());
            const TilePlace red = middleOfRed(**tile);
            COMPARE_WITHIN(red.x, place.x - 256.0 * place.column(), 0.5);
            COMPARE_WITHIN(red.y, place.y - 256.0 * place.row(), 0.5);
        }
    }
    void aPlaceOfAGeoTiffInUtmIsRightToAPixel() {
        // Two centimetres a pixel, on the central meridian of zone 31: easting 500 km, northing by the
        // series.
        constexpr double kCell = 0.02;
        const double north = northingOnMeridian(51.9);
        const RasterShape shape{
            .width = 601,
            .height = 601,
            .epsg = 32631,
            .affine = {500000.0 - 300.5 * kCell, kCell, 0.0, north + 300.5 * kCell, 0.0, -kCell},
            .options = {"TILED=YES", "COMPRESS=DEFLATE"}};
        QVERIFY(writeTiff(in("utm.tif"), shape, 3,
                          [](int band, int x, int y) { return redInTheMiddle(band, x, y, 601); }));
        const auto imagery = openImagery(pathOf(in("utm.tif")));
        VERIFY_RESULT(imagery);
        // 0.02 m on the ground at 51.9 degrees are 0.0324 m of web Mercator: between zoom 22 and 23.
        QCOMPARE((*imagery)->facts().finestZoom, 23);
        const TilePlace place = tilePlace(3.0, 51.9, 23);
        const auto tile = (*imagery)->tile({23, place.column(), place.row()}, {});
        VERIFY_RESULT(tile);
        const TilePlace red = middleOfRed(**tile);
        COMPARE_WITHIN(red.x, place.x - 256.0 * place.column(), 0.7);
        COMPARE_WITHIN(red.y, place.y - 256.0 * place.row(), 0.7);
    }
    void outsideOfTheRasterThereIsNothing() {
        const auto imagery = openImagery(pathOf(in("utm.tif")));
        VERIFY_RESULT(imagery);
        const TilePlace place = tilePlace(3.001, 51.9, 22);
        const auto beside = (*imagery)->tile({22, place.column() + 8, place.row()}, {});
        VERIFY_RESULT(beside);
        QVERIFY(!beside->has_value());
        // A tile that it fills in part is transparent elsewhere.
        const TilePlace middle = tilePlace(3.0, 51.9, 16);
        const auto around = (*imagery)->tile({16, middle.column(), middle.row()}, {});
        VERIFY_RESULT(around);
        QCOMPARE(pixel(**around, 0, 0), (std::array{0, 0, 0, 0}));
    }
    void noDataAndPalettesAndSixteenBitsAreDrawnAsPeopleExpect_data() {
        QTest::addColumn<int>("kind");
        QTest::newRow("no data is transparent") << 0;
        QTest::newRow("sixteen bits are spread from dark to light") << 1;
        QTest::newRow("one band is grey") << 2;
    }
    void noDataAndPalettesAndSixteenBitsAreDrawnAsPeopleExpect() {
        QFETCH(int, kind);
        constexpr double kCell = 1e-5;
        const QString path = in("kinds.tif");
        RasterShape shape{
            .width = 200, .height = 200, .epsg = 4326, .affine = {5.0, kCell, 0.0, 52.0, 0.0, -kCell}};
        shape.type = kind == 1 ? GDT_UInt16 : GDT_Byte;
        // The western half dark, the eastern light.
        const double dark = kind == 1 ? 3000.0 : 40.0;
        const double light = kind == 1 ? 9000.0 : 200.0;
        QVERIFY(writeTiff(path, shape, 1, [&](int, int x, int) { return x < 100 ? dark : light; }));
        if (kind == 0) {
            GDALDataset* dataset =
                GDALDataset::Open(path.toUtf8().constData(), GDAL_OF_RASTER | GDAL_OF_UPDATE);
            dataset->GetRasterBand(1)->SetNoDataValue(40.0);
            GDALClose(dataset);
        }
        const auto imagery = openImagery(pathOf(path));
        VERIFY_RESULT(imagery);
        const auto at = [&](double lonDeg) {
            const TilePlace place = tilePlace(lonDeg, 51.999, 18);
            const auto tile = (*imagery)->tile({18, place.column(), place.row()}, {});
            return pixel(**tile, static_cast<int>(place.x) % 256, static_cast<int>(place.y) % 256);
        };
        const auto west = at(5.0005);
        const auto east = at(5.0015);
        QCOMPARE(west, (kind == 0   ? std::array{0, 0, 0, 0}
                        : kind == 1 ? std::array{0, 0, 0, 255}
                                    : std::array{40, 40, 40, 255}));
        QCOMPARE(east, (kind == 1 ? std::array{255, 255, 255, 255} : std::array{200, 200, 200, 255}));
    }
    void heightsBecomeShadeAndContourLines() {
        // A plane that rises one metre in ten to the east, 1 m a cell: from 0 m at easting 499900.
        const double north = northingOnMeridian(51.9);
        const RasterShape shape{.width = 200,
                                .height = 200,
                                .epsg = 32631,
                                .affine = {499900.0, 1.0, 0.0, north + 100.0, 0.0, -1.0},
                                .type = GDT_Float32};
        QVERIFY(writeTiff(in("heights.tif"), shape, 1, [](int, int x, int) { return 0.1 * (x + 0.5); }));
        QVERIFY(isImagery(pathOf(in("heights.tif"))));
        const auto imagery = openImagery(pathOf(in("heights.tif")));
        VERIFY_RESULT(imagery);
        QCOMPARE((*imagery)->facts().kind, ImageryKind::Heights);
        // At zoom 20 0.092 m a pixel: 30 pixels are 2.8 m and rise 0.28 m.
        COMPARE_WITHIN((*imagery)->contourStepM(20), 0.5, 1e-9);
        const TilePlace place = tilePlace(3.0, 51.9, 20);
        const auto tile = (*imagery)->tile({20, place.column(), place.row()}, {});
        VERIFY_RESULT(tile);
        QVERIFY(tile->has_value());
        // The height is 10 m on the meridian: a contour line, and wide ones lie 2.5 m of height apart. Along
        // a row the lines are 5 m, 54.1 pixels apart: metres of web Mercator are 1/0.61704 of those on the
        // ground here, and 0.14929 a pixel.
        const int row = 128;
        const std::vector<double> lines = brownLines(**tile, row);
        QVERIFY2(lines.size() >= 4, qPrintable(QString::number(lines.size())));
        const double pixelM = 40075016.685578488 / (256.0 * (1 << 20)) * 0.61704;
        const double meridian = place.x - 256.0 * place.column();
        for (const double line : lines) {
            const double metres = (line - meridian) * pixelM / 0.9996;
            COMPARE_WITHIN(std::remainder(metres, 5.0), 0.0, 0.15);
        }
        // Where no height is known nothing is drawn, the edge of the raster neither: 100 m west of the
        // meridian, 50 m beyond it.
        const TilePlace edge = tilePlace(3.0 - 100.0 / 0.9996 / (111319.49 * 0.61704), 51.9, 20);
        const auto western = (*imagery)->tile({20, edge.column(), edge.row()}, {});
        VERIFY_RESULT(western);
        const int edgeX = static_cast<int>(edge.x) - 256 * edge.column();
        for (int x = 0; x < 256; ++x) {
            const auto [red, green, blue, alpha] = pixel(**western, x, 128);
            if (x < edgeX - 12) {
                QCOMPARE(alpha, 0);
            } else if (x < edgeX + 8) {
                // The first line is 10 m, 100 pixels, further east but for the one of 0 m, the edge itself.
                QVERIFY2(red - blue <= 100, qPrintable(QString::number(x)));
            }
        }
        // Lambert's law: the light comes from the north-west, so a slope that faces west is lighter than
        // level ground. cos(incidence) = (sin 45 + 0.1 * cos 45 * sin 45) / sqrt(1 + 0.01) = 0.7533, level:
        // 0.7071.
        const double shade = 1.0 + 254.0 * 0.7533;
        const double levelShade = 1.0 + 254.0 * 0.70711;
        const double expected = 255.0 * 0.85 * (shade - levelShade) / (255.0 - levelShade);
        const auto between = pixel(**tile, static_cast<int>(lines[1] + 27.0), row);
        COMPARE_WITHIN(between[3], expected, 6.0);
        QCOMPARE(between[0], between[3]);
    }
    void tilesOfAFolderAreThemselves_data() {
        QTest::addColumn<bool>("tms");
        QTest::newRow("rows from the north") << false;
        QTest::newRow("rows from the south") << true;
    }
    void tilesOfAFolderAreThemselves() {
        QFETCH(bool, tms);
        const QTemporaryDir place;
        const TilePlace tile = tilePlace(5.4, 52.1, 14);
        const int row = tms ? (1 << 14) - 1 - tile.row() : tile.row();
        QVERIFY(QDir{place.path()}.mkpath(QStringLiteral("14/%1").arg(tile.column())));
        QVERIFY(writePng(place.filePath(QStringLiteral("14/%1/%2.png").arg(tile.column()).arg(row)), 256,
                         {200, 100, 50, 255}));
        if (tms) {
            QFile xml{place.filePath(QStringLiteral("tilemapresource.xml"))};
            QVERIFY(xml.open(QIODevice::WriteOnly));
            xml.write("<TileMap><TileSets profile=\"mercator\"/></TileMap>");
        }
        QVERIFY(isImagery(pathOf(place.path())));
        const auto imagery = openImagery(pathOf(place.path()));
        VERIFY_RESULT(imagery);
        QCOMPARE((*imagery)->facts().rowsFromSouth, tms);
        QVERIFY((*imagery)->facts().southWest.lonDeg < 5.4 && (*imagery)->facts().northEast.lonDeg > 5.4);
        QVERIFY((*imagery)->facts().southWest.latDeg < 52.1 && (*imagery)->facts().northEast.latDeg > 52.1);
        const auto read = (*imagery)->tile({14, tile.column(), tile.row()}, {});
        VERIFY_RESULT(read);
        QCOMPARE(pixel(**read, 128, 128), (std::array{200, 100, 50, 255}));
        const auto beside = (*imagery)->tile({14, tile.column() + 1, tile.row()}, {});
        VERIFY_RESULT(beside);
        QVERIFY(!beside->has_value());
        // Who knows better may say so.
        const auto other = openImagery(pathOf(place.path()), !tms);
        VERIFY_RESULT(other);
        QCOMPARE((*other)->facts().rowsFromSouth, !tms);
        QVERIFY(!(*other)->tile({14, tile.column(), tile.row()}, {})->has_value());
    }
    void mbtilesAreRead() {
        // One world at zoom 1 from a raster of GDAL's own making: the north half green, the south half blue.
        const RasterShape shape{
            .width = 512,
            .height = 512,
            .epsg = 3857,
            .affine = {-20037508.342789244, 78271.516964, 0.0, 20037508.342789244, 0.0, -78271.516964}};
        QVERIFY(writeTiff(in("world.tif"), shape, 3,
                          [](int band, int, int y) { return band == (y < 256 ? 1 : 2) ? 250.0 : 10.0; }));
        GDALDataset* source = GDALDataset::Open(in("world.tif").toUtf8().constData());
        char* options[] = {const_cast<char*>("TILE_FORMAT=PNG"), nullptr};
        GDALDataset* made = GetGDALDriverManager()->GetDriverByName("MBTiles")->CreateCopy(
            in("world.mbtiles").toUtf8().constData(), source, FALSE, options, nullptr, nullptr);
        QVERIFY(made != nullptr);
        GDALClose(made);
        GDALClose(source);
        const auto imagery = openImagery(pathOf(in("world.mbtiles")));
        VERIFY_RESULT(imagery);
        QVERIFY(isImagery(pathOf(in("world.mbtiles"))));
        const auto north = (*imagery)->tile({1, 0, 0}, {});
        VERIFY_RESULT(north);
        QCOMPARE(pixel(**north, 100, 100), (std::array{10, 250, 10, 255}));
        QCOMPARE(pixel(**(*imagery)->tile({1, 1, 1}, {}), 100, 100), (std::array{10, 10, 250, 255}));
    }
    void whatCannotBeShownIsRefusedWithItsReason_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("said");
        QTest::newRow("not there") << "nowhere.tif" << "there is no such file or folder";
        QTest::newRow("empty") << "empty.tif" << "the file is empty";
        QTest::newRow("text") << "text.tif" << "it is damaged, or not a picture";
        QTest::newRow("no place") << "nowhere-placed.tif" << "does not say where it lies";
        QTest::newRow("a folder without tiles") << "folder" << "no tiles in this folder";
        QTest::newRow("vast without overviews") << "vast.tif" << "too large to be shown without overviews";
    }
    void whatCannotBeShownIsRefusedWithItsReason() {
        QFETCH(QString, name);
        QFETCH(QString, said);
        const QString path = folder_.filePath(name);
        QFile file{path};
        if (name == "empty.tif" || name == "text.tif") {
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(name == "empty.tif" ? "" : "this is no picture at all");
            file.close();
        } else if (name == "nowhere-placed.tif") {
            QVERIFY(writeTiff(path, {.width = 50, .height = 50}, 3, [](int, int x, int) { return x; }));
        } else if (name == "folder") {
            QVERIFY(QDir{folder_.path()}.mkpath(name));
        } else if (name == "vast.tif") {
            // Ten billion pixels, of which none is written: a sparse file.
            GDALAllRegister();
            char* options[] = {const_cast<char*>("TILED=YES"), const_cast<char*>("SPARSE_OK=TRUE"), nullptr};
            GDALDataset* vast = GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
                path.toUtf8().constData(), 100000, 100000, 3, GDT_Byte, options);
            OGRSpatialReference system;
            system.importFromEPSG(32631);
            vast->SetSpatialRef(&system);
            std::array affine{500000.0, 0.02, 0.0, 5750000.0, 0.0, -0.02};
            vast->SetGeoTransform(affine.data());
            GDALClose(vast);
        }
        const auto imagery = openImagery(pathOf(path));
        QVERIFY(!imagery.has_value());
        QVERIFY2(QString::fromStdString(imagery.error().what).contains(said), imagery.error().what.c_str());
        QVERIFY(!imagery.error().remedy.empty());
        QCOMPARE(imagery.error().where, path.toStdString());
        const bool isRaster = name == "vast.tif" || name == "nowhere-placed.tif";
        QCOMPARE(isImagery(pathOf(path)), isRaster);
    }
    void aTruncatedFileSaysThatItIsDamaged() {
        const RasterShape shape{
            .width = 600, .height = 600, .epsg = 32631, .affine = {500000.0, 0.5, 0.0, 5750000.0, 0.0, -0.5}};
        QVERIFY(writeTiff(in("cut.tif"), shape, 3,
                          [](int band, int x, int y) { return (x * 7 + y * 13 + band * 50) % 256; }));
        QVERIFY(QFile::resize(in("cut.tif"), QFileInfo{in("cut.tif")}.size() / 3));
        const auto imagery = openImagery(pathOf(in("cut.tif")));
        if (!imagery) {
            QCOMPARE(imagery.error().code, ErrorCode::ReadFailed);
            return;
        }
        const GeoPoint south = (*imagery)->facts().southWest;
        const TilePlace place = tilePlace(south.lonDeg + 0.0005, south.latDeg + 0.0001, 18);
        const auto tile = (*imagery)->tile({18, place.column(), place.row()}, {});
        QVERIFY(!tile.has_value());
        QCOMPARE(tile.error().code, ErrorCode::ReadFailed);
    }
    void aFileThatIsRemovedOrChangedWhileItIsOpenIsTold() {
        QVERIFY(QFile::copy(in("utm.tif"), in("going.tif")));
        const auto imagery = openImagery(pathOf(in("going.tif")));
        VERIFY_RESULT(imagery);
        const TilePlace place = tilePlace(3.0, 51.9, 22);
        const TileId id{22, place.column(), place.row()};
        VERIFY_RESULT((*imagery)->tile(id, {}));
        QFile file{in("going.tif")};
        QVERIFY(file.open(QIODevice::Append));
        file.write("more");
        file.close();
        QVERIFY(QString::fromStdString((*imagery)->tile(id, {}).error().what)
                    .contains("changed while it was open"));
        QVERIFY(QFile::remove(in("going.tif")));
        QVERIFY(QString::fromStdString((*imagery)->tile(id, {}).error().what).contains("not there any more"));
    }
    void aStopIsFollowedAndLeavesNothingBehind() {
        const auto imagery = openImagery(pathOf(in("utm.tif")));
        VERIFY_RESULT(imagery);
        std::stop_source stop;
        stop.request_stop();
        const TilePlace place = tilePlace(3.0, 51.9, 22);
        const TileId id{22, place.column(), place.row()};
        QCOMPARE((*imagery)->tile(id, {.stop = stop.get_token()}).error().code, ErrorCode::Cancelled);
        VERIFY_RESULT((*imagery)->tile(id, {}));
    }
    void aLargeRasterWithoutOverviewsIsReducedForCoarseTiles() {
        // 6000 pixels of 0.1 m; its western half red, its eastern green.
        const double north = northingOnMeridian(51.9);
        const RasterShape shape{.width = 6000,
                                .height = 6000,
                                .epsg = 32631,
                                .affine = {500000.0 - 300.0, 0.1, 0.0, north + 300.0, 0.0, -0.1},
                                .options = {"TILED=YES", "COMPRESS=DEFLATE"}};
        QVERIFY(writeTiff(in("large.tif"), shape, 3,
                          [](int band, int x, int) { return band == (x < 3000 ? 0 : 1) ? 220.0 : 20.0; }));
        const auto imagery = openImagery(pathOf(in("large.tif")));
        VERIFY_RESULT(imagery);
        for (const int zoom : {14, 16, 18, 20}) {
            // A tenth of the field to each side of the meridian.
            for (const double side : {-1.0, 1.0}) {
                const TilePlace place = tilePlace(3.0 + side * 0.0009, 51.9, zoom);
                const auto tile = (*imagery)->tile({zoom, place.column(), place.row()}, {});
                VERIFY_RESULT(tile);
                const auto colour =
                    pixel(**tile, static_cast<int>(place.x) % 256, static_cast<int>(place.y) % 256);
                QCOMPARE(colour, (side < 0.0 ? std::array{220, 20, 20, 255} : std::array{20, 220, 20, 255}));
            }
        }
    }
    void severalThreadsGetTheSameTiles() {
        const auto imagery = openImagery(pathOf(in("large.tif")));
        VERIFY_RESULT(imagery);
        const TilePlace place = tilePlace(3.0, 51.9, 19);
        std::array<std::vector<TilePicture>, 4> read;
        {
            std::vector<std::jthread> threads;
            for (auto& mine : read) {
                threads.emplace_back([&mine, &imagery, &place] {
                    for (int i = 0; i < 6; ++i) {
                        mine.push_back((*imagery)
                                           ->tile({19, place.column() - 1 + i % 3, place.row() + i / 3}, {})
                                           ->value());
                    }
                });
            }
        }
        for (const auto& other : read) {
            for (std::size_t i = 0; i < 6; ++i) {
                QVERIFY(other[i].rgba == read[0][i].rgba);
            }
        }
    }
    void masksAreNoImagery() {
        const RasterShape shape{
            .width = 100, .height = 100, .epsg = 32631, .affine = {500000.0, 1.0, 0.0, 5750000.0, 0.0, -1.0}};
        QVERIFY(writeTiff(in("mask.tif"), shape, 1,
                          [](int, int x, int y) { return x > 10 && y > 10 ? 1.0 : 0.0; }));
        QVERIFY(!isImagery(pathOf(in("mask.tif"))));
        QVERIFY(writeTiff(in("photo.tif"), shape, 1, [](int, int x, int y) { return (x * y) % 251; }));
        QVERIFY(isImagery(pathOf(in("photo.tif"))));
    }
    /// Real rasters of several kinds, where they are at hand.
    void realRasters_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<double>("lonDeg");
        QTest::addColumn<double>("latDeg");
        QTest::addColumn<bool>("heights");
        // Middles as gdalinfo prints them.
        QTest::newRow("NAIP, four bands, UTM 14")
            << "raster/naip_nd_20140720_5m_4band.tif" << -99.1547 << 47.0211 << false;
        QTest::newRow("world in degrees") << "raster/world_512x256_rgb.tif" << 0.0 << 0.0 << false;
        QTest::newRow("MBTiles of JPEG") << "mbtiles/geography-class-jpg.mbtiles" << 0.0 << 0.0 << false;
        QTest::newRow("MBTiles of PNG") << "mbtiles/geography-class-png.mbtiles" << 0.0 << 0.0 << false;
        QTest::newRow("lidar, 1 m, UTM 15") << "dem/lidar_dem_1m_utm15.tif" << -93.9189 << 46.5060 << true;
        QTest::newRow("SRTM in degrees") << "dem/srtm_90m_texas.tif" << -97.332 << 32.672 << true;
        QTest::newRow("whole metres in degrees") << "dem/elev_luxembourg.tif" << 6.1375 << 49.8167 << true;
    }
    void realRasters() {
        QFETCH(QString, file);
        QFETCH(double, lonDeg);
        QFETCH(double, latDeg);
        QFETCH(bool, heights);
        const QString path = test::largeData(QStringLiteral("basemap/") + file);
        if (!QFile::exists(path)) {
            QSKIP("the shared data is not here");
        }
        QVERIFY(isImagery(pathOf(path)));
        const auto imagery = openImagery(pathOf(path));
        VERIFY_RESULT(imagery);
        const ImageryFacts& facts = (*imagery)->facts();
        QCOMPARE(facts.kind == ImageryKind::Heights, heights);
        QVERIFY(facts.southWest.lonDeg < lonDeg && lonDeg < facts.northEast.lonDeg);
        QVERIFY(facts.southWest.latDeg < latDeg && latDeg < facts.northEast.latDeg);
        for (int zoom = std::max(facts.coarsestZoom, facts.finestZoom - 6); zoom <= facts.finestZoom;
             ++zoom) {
            const TilePlace place = tilePlace(lonDeg, latDeg, zoom);
            const auto tile = (*imagery)->tile({zoom, place.column(), place.row()}, {});
            VERIFY_RESULT(tile);
            QVERIFY(tile->has_value());
            int seen = 0;
            for (std::size_t i = 3; i < (*tile)->rgba.size(); i += 4) {
                seen += (*tile)->rgba[i] > 0 ? 1 : 0;
            }
            QVERIFY2(seen > 0, qPrintable(QString::number(zoom)));
        }
    }
    void howLongATileTakes() {
        const QString path = test::largeData(QStringLiteral("basemap/raster/naip_nd_20140720_5m_4band.tif"));
        if (!QFile::exists(path)) {
            QSKIP("the shared data is not here");
        }
        const auto imagery = openImagery(pathOf(path));
        VERIFY_RESULT(imagery);
        const TilePlace place = tilePlace(-99.1547, 47.0211, 14);
        QBENCHMARK {
            VERIFY_RESULT((*imagery)->tile({14, place.column(), place.row()}, {}));
        }
    }
};

FURROW_TEST(TestImagery);
#include "tst_imagery.moc"
