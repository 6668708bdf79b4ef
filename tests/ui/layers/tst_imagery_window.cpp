#include "tests/planner/imagery/raster_samples.h"
#include "tests/support/large_data.h"
#include "tests/support/patience.h"
#include "tests/support/test_program.h"
#include "tests/ui/window/next_frame.h"
#include "tests/ui/window/window_test.h"

#include <QFile>
#include <QSignalSpy>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTemporaryDir>

#include <algorithm>
#include <ctime>

using namespace furrow;
using namespace furrow::test;

/// Imagery in the whole window: opened, drawn at its place, changed, missing, kept in the project.
class TestImageryWindow : public WindowTest {
    Q_OBJECT

    /// Some 200 m of a meadow at the middle of zone 34, green, with a red square of 10 m in its middle.
    static bool writeMeadow(const QString& path) {
        constexpr double kNorthM = 6465000.0;
        const RasterShape shape{.width = 401,
                                .height = 401,
                                .epsg = 32634,
                                .affine = {500000.0 - 100.25, 0.5, 0.0, kNorthM + 100.25, 0.0, -0.5},
                                .options = {"TILED=YES"}};
        return writeTiff(path, shape, 3, [](int band, int x, int y) {
            const bool red = std::abs(x - 200) <= 10 && std::abs(y - 200) <= 10;
            return band == (red ? 0 : 1) ? 210.0 : 30.0;
        });
    }
    bool isDrawn() const { return session_->imagery()->store().isIdle(); }
    QColor colourAt(const QGeoCoordinate& place, QPoint beside = {}) const {
        return window_->grabWindow().pixelColor(onMap(place) + beside);
    }
    QVariant row(int role) const { return session_->imagery()->data(session_->imagery()->index(0), role); }
    ImageryModel::State state() const { return row(ImageryModel::StateRole).value<ImageryModel::State>(); }
    void addMeadow(const QTemporaryDir& folder) {
        QVERIFY(writeMeadow(folder.filePath(QStringLiteral("meadow.tif"))));
        session_->opener()->openUrls({QUrl::fromLocalFile(folder.filePath(QStringLiteral("meadow.tif")))});
        QTRY_COMPARE(session_->imagery()->count(), 1);
        QTRY_COMPARE(state(), ImageryModel::State::Ready);
    }
    /// By the middle of the red square, found in the picture of the window.
    QPointF middleOfRed() const {
        const QImage shot = window_->grabWindow();
        const QRectF area = map()->mapRectToScene(QRectF{0.0, 0.0, map()->width(), map()->height()});
        QPointF sum;
        int count = 0;
        for (int y = static_cast<int>(area.top()); y < static_cast<int>(area.bottom()); ++y) {
            for (int x = static_cast<int>(area.left()); x < static_cast<int>(area.right()); ++x) {
                const QColor colour = shot.pixelColor(x, y);
                if (colour.red() > 150 && colour.green() < 90 && colour.blue() < 90) {
                    sum += QPointF{x + 0.5, y + 0.5};
                    ++count;
                }
            }
        }
        return count > 0 ? sum / count : QPointF{-1.0, -1.0};
    }

    /// Of a frame while the map is panned, in processor time of all threads.
    void printCost(const char* what) {
        constexpr int kFrames = 40;
        for (int i = 0; i < 4; ++i) {
            NextFrame frame{*window_};
            camera()->panBy(i % 2 == 0 ? 7.0 : -6.0, 3.0);
            QVERIFY(frame.wait());
        }
        const std::clock_t begin = std::clock();
        for (int i = 0; i < kFrames; ++i) {
            NextFrame frame{*window_};
            camera()->panBy(i % 2 == 0 ? 7.0 : -6.0, i % 4 < 2 ? 3.0 : -3.0);
            QVERIFY(frame.wait());
        }
        qInfo("%-28s %5.1f ms a frame", what,
              1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC / kFrames);
    }
    /// Of a plan, and what of it which layer.
    void planCosts() {
        session_->planning()->machine()->setNumber(0, 2.5);
        session_->opener()->addDrawn({{58.25, 22.5}, {58.25, 22.5136}, {58.2572, 22.5136}, {58.2572, 22.5}});
        QTRY_COMPARE_WITH_TIMEOUT(session_->planning()->state(), PlanState::Ready, kPatienceMs);
        QQuickItem* layers = item(QStringLiteral("layerSwitches"));
        printCost("64 ha, 2.5 m, everything");
        for (const char* layer :
             {"numbers", "directions", "findings", "turns", "swaths", "headland", "boundary"}) {
            layers->setProperty(layer, false);
            printCost(qPrintable(QStringLiteral("without %1 too").arg(QLatin1String{layer})));
        }
        for (const char* layer :
             {"numbers", "directions", "findings", "turns", "swaths", "headland", "boundary"}) {
            layers->setProperty(layer, true);
        }
        camera()->centreOn(camera()->center(), 18.5, false);
        printCost("close, everything");
    }
    void imageryCosts(const QString& small) {
        const QString naip = qEnvironmentVariable(
            "FURROW_IMAGERY",
            test::largeData(QStringLiteral("basemap/raster/naip_nd_20140720_5m_4band.tif")));
        const bool real = QFile::exists(naip);
        session_->opener()->startNew();
        session_->opener()->openUrls({QUrl::fromLocalFile(real ? naip : small)});
        QTRY_COMPARE(session_->imagery()->count(), 1);
        QTRY_COMPARE(state(), ImageryModel::State::Ready);
        camera()->centreOn(session_->imagery()->areaOf(0).center(), 15.0, false);
        QTRY_VERIFY(isDrawn());
        printCost("imagery alone");
        QQuickItem* layers = item(QStringLiteral("layerSwitches"));
        layers->setProperty("imagery", false);
        printCost("without imagery");
        layers->setProperty("imagery", true);
    }
    /// All of an image, at several zooms.
    void lookAtAll() {
        const QGeoRectangle area = session_->imagery()->areaOf(0);
        for (const double zoom : {15.0, 17.0, 19.0}) {
            constexpr int kAcross = 12;
            for (int i = 0; i < kAcross * kAcross; ++i) {
                const QGeoCoordinate corner = area.bottomLeft();
                const int row = i / kAcross;
                NextFrame frame{*window_};
                camera()->centreOn({corner.latitude() + area.height() * (row + 0.5) / kAcross,
                                    corner.longitude() + area.width() * (i % kAcross + 0.5) / kAcross},
                                   zoom, false);
                QVERIFY(frame.wait());
            }
            QTRY_VERIFY(isDrawn());
        }
    }
    static void printMemory() {
        QFile status{QStringLiteral("/proc/self/status")};
        if (status.open(QIODevice::ReadOnly)) {
            for (const QByteArray& line : status.readAll().split('\n')) {
                if (line.startsWith("VmRSS") || line.startsWith("VmHWM") || line.startsWith("Rss")) {
                    qInfo("%s", line.simplified().constData());
                }
            }
        }
    }

private slots:
    void aGeoTiffIsDrawnAtItsPlace() {
        const QTemporaryDir folder;
        addMeadow(folder);
        // 21 degrees east is the middle of the zone; the latitude of northing 6465 km by the series of the
        // meridian arc.
        double latDeg = 58.3;
        for (int i = 0; i < 20; ++i) {
            latDeg += (6465000.0 - northingOnMeridian(latDeg)) / 111400.0;
        }
        const QGeoCoordinate middle{latDeg, 21.0};
        // The camera went there.
        QTRY_VERIFY(camera()->center().distanceTo(middle) < 60.0 && camera()->zoomLevel() > 15.0);
        for (const double zoom : {17.0, 18.4, 20.0}) {
            camera()->centreOn(middle, zoom, false);
            QTRY_VERIFY(isDrawn());
            const QPointF place = map()->mapToScene(camera()->position(middle));
            QTRY_VERIFY2(QLineF(middleOfRed(), place).length() < 1.0,
                         qPrintable(QStringLiteral("%1 %2, not %3 %4")
                                        .arg(middleOfRed().x())
                                        .arg(middleOfRed().y())
                                        .arg(place.x())
                                        .arg(place.y())));
        }
        picture(QStringLiteral("imagery-close"));
    }
    void itIsHiddenMadeWeakerRemovedAndAllOfThatUndone() {
        const QTemporaryDir folder;
        addMeadow(folder);
        QVERIFY(session_->document()->canUndo());
        const QGeoCoordinate meadow =
            session_->imagery()->areaOf(0).center().atDistanceAndAzimuth(60.0, 90.0);
        QTRY_VERIFY(isDrawn() && colourAt(meadow) == QColor(30, 210, 30));
        click(QStringLiteral("layersTool"));
        QTRY_VERIFY(item(QStringLiteral("imagery.0.shown")) != nullptr &&
                    item(QStringLiteral("imagery.0.shown"))->isVisible());
        picture(QStringLiteral("layers"));
        session_->imagery()->setOpacity(0, 0.5, true);
        session_->imagery()->setOpacity(0, 0.4, true);
        session_->imagery()->setOpacity(0, 0.3, false);
        QTRY_VERIFY(colourAt(meadow).red() > 150);
        session_->document()->undo();
        QCOMPARE(row(ImageryModel::OpacityRole).toDouble(), 1.0);
        click(QStringLiteral("imagery.0.shown"));
        QTRY_VERIFY(colourAt(meadow).red() > 200);
        session_->document()->undo();
        QTRY_VERIFY(colourAt(meadow) == QColor(30, 210, 30));
        click(QStringLiteral("imagery.0.remove"));
        QTRY_COMPARE(session_->imagery()->count(), 0);
        session_->document()->undo();
        QTRY_COMPARE(session_->imagery()->count(), 1);
        QTRY_VERIFY(isDrawn() && colourAt(meadow) == QColor(30, 210, 30));
        // All of it at once is a layer, too.
        click(QStringLiteral("layer.imagery"));
        QTRY_VERIFY(colourAt(meadow).red() > 200);
        click(QStringLiteral("layer.imagery"));
    }
    void aFileThatGoesAndComesBackIsTold() {
        const QTemporaryDir folder;
        addMeadow(folder);
        QTRY_VERIFY(isDrawn());
        click(QStringLiteral("layersTool"));
        const QString path = folder.filePath(QStringLiteral("meadow.tif"));
        QVERIFY(QFile::rename(path, path + QStringLiteral(".away")));
        camera()->zoomAt({300.0, 300.0}, 1.0, false);
        QTRY_COMPARE(state(), ImageryModel::State::Failed);
        QTRY_VERIFY(item(QStringLiteral("imagery.0.problem"))->isVisible());
        QVERIFY(row(ImageryModel::ProblemRole).toString().contains(QStringLiteral("not there any more")));
        picture(QStringLiteral("imagery-missing"));
        QVERIFY(QFile::rename(path + QStringLiteral(".away"), path));
        QTRY_COMPARE_WITH_TIMEOUT(state(), ImageryModel::State::Ready, kPatienceMs);
    }
    void aPictureElsewhereIsTold() {
        openSample(QStringLiteral("Home Field"));
        const QTemporaryDir folder;
        addMeadow(folder);
        QTRY_VERIFY(item(QStringLiteral("farImagery"))->isVisible());
        QVERIFY(item(QStringLiteral("farImagery.text"))
                    ->property("text")
                    .toString()
                    .contains(QStringLiteral(" km away")));
        picture(QStringLiteral("imagery-far"));
        click(QStringLiteral("farImagery.go"));
        QTRY_VERIFY(!item(QStringLiteral("farImagery"))->isVisible());
        // The middle of zone 34, 6,465 km north of the equator.
        QTRY_VERIFY(camera()->center().distanceTo(QGeoCoordinate{58.32, 21.0}) < 3000.0);
    }
    void whatCannotBeAddedIsTold() {
        const QTemporaryDir folder;
        QFile file{folder.filePath(QStringLiteral("broken.mbtiles"))};
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("no tiles");
        file.close();
        session_->imagery()->addUrls({QUrl::fromLocalFile(file.fileName())});
        QTRY_VERIFY(item(QStringLiteral("imageryNotice"))->isVisible());
        QVERIFY(item(QStringLiteral("imageryNotice.text"))
                    ->property("text")
                    .toString()
                    .startsWith(QStringLiteral("broken.mbtiles: ")));
        QCOMPARE(session_->imagery()->count(), 0);
        picture(QStringLiteral("imagery-refused"));
        click(QStringLiteral("imageryNotice.close"));
        QTRY_VERIFY(!item(QStringLiteral("imageryNotice"))->isVisible());
    }
    void noCardCoversAnother() {
        QObject* const colours = engine_->singletonInstance<QObject*>("Furrow.Controls", "Theme");
        colours->setProperty("forced", 2);
        window_->resize(1000, 700);
        session_->opener()->openUrls(
            {QUrl::fromLocalFile(QStringLiteral(FURROW_SOURCE_DIR "/tests/data/stepped/one.geojson"))});
        QTRY_VERIFY(item(QStringLiteral("outlineSteps"))->isVisible());
        const QTemporaryDir folder;
        addMeadow(folder);
        QFile broken{folder.filePath(QStringLiteral("broken.mbtiles"))};
        QVERIFY(broken.open(QIODevice::WriteOnly));
        broken.close();
        session_->imagery()->addUrls({QUrl::fromLocalFile(broken.fileName())});
        const QStringList cards{QStringLiteral("imageryNotice"), QStringLiteral("farImagery"),
                                QStringLiteral("outlineSteps")};
        for (const QString& card : cards) {
            QTRY_VERIFY(item(card)->isVisible());
        }
        const auto place = [&](const QString& name) {
            return item(name)->mapRectToScene(QRectF{0.0, 0.0, item(name)->width(), item(name)->height()});
        };
        const auto liesFree = [&](const QString& card) {
            const bool isOnMap = map()
                                     ->mapRectToScene(QRectF{0.0, 0.0, map()->width(), map()->height()})
                                     .contains(place(card));
            return isOnMap && std::ranges::none_of(cards, [&](const QString& other) {
                       return other != card && item(other)->isVisible() &&
                              place(card).intersects(place(other));
                   });
        };
        for (const QString& card : cards) {
            QTRY_VERIFY(liesFree(card));
        }
        picture(QStringLiteral("cards-dark"));
        // Nor what to do while something is drawn.
        QTest::keyClick(window_, Qt::Key_B);
        QTRY_VERIFY(item(QStringLiteral("drawingHint"))->isVisible());
        QTRY_VERIFY(!item(cards.back())->isVisible());
        QTRY_VERIFY(liesFree(cards.front()) &&
                    !place(cards[1]).intersects(place(QStringLiteral("drawingHint"))));
        picture(QStringLiteral("cards-drawing-dark"));
        colours->setProperty("forced", 0);
    }
    void theProjectKeepsIt() {
        const QTemporaryDir folder;
        addMeadow(folder);
        session_->imagery()->setOpacity(0, 0.6, false);
        session_->files()->saveAs(QUrl::fromLocalFile(folder.filePath(QStringLiteral("farm.furrow"))));
        QTRY_VERIFY(!session_->document()->isModified());
        session_->opener()->startNew();
        QTRY_COMPARE(session_->imagery()->count(), 0);
        // The file is missing: the layer stays, says so, and is written again.
        QVERIFY(QFile::rename(folder.filePath(QStringLiteral("meadow.tif")),
                              folder.filePath(QStringLiteral("m.tif"))));
        session_->opener()->open(folder.filePath(QStringLiteral("farm.furrow")));
        QTRY_COMPARE(session_->imagery()->count(), 1);
        QTRY_COMPARE(state(), ImageryModel::State::Failed);
        QCOMPARE(row(ImageryModel::OpacityRole).toDouble(), 0.6);
        QVERIFY(!session_->document()->isModified());
        session_->imagery()->rename(0, QStringLiteral("Meadow 2026"));
        session_->files()->save();
        QTRY_VERIFY(!session_->document()->isModified());
        QFile file{folder.filePath(QStringLiteral("farm.furrow"))};
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(file.readAll().contains("\"path\":\"meadow.tif\",\"name\":\"Meadow 2026\""));
    }
    void nothingIsFetchedBeforeItIsTurnedOn() {
        // What an earlier run fetched would not be asked for again.
        QDir{QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation) +
             QStringLiteral("/QtLocation")}
            .removeRecursively();
        QTcpServer server;
        QVERIFY(server.listen(QHostAddress::LocalHost));
        QStringList asked;
        connect(&server, &QTcpServer::newConnection, this, [&] {
            QTcpSocket* socket = server.nextPendingConnection();
            connect(socket, &QTcpSocket::readyRead, socket, [socket, &asked] {
                asked << QString::fromLatin1(socket->readAll().split('\r').first());
            });
        });
        item(QStringLiteral("mapPage"))
            ->setProperty("onlineServer", QStringLiteral("http://127.0.0.1:%1/").arg(server.serverPort()));
        camera()->centreOn(QGeoCoordinate{58.2515, 22.5035}, 15.0, false);
        camera()->panBy(50.0, 20.0);
        QVERIFY(!window_->grabWindow().isNull());
        QVERIFY(item(QStringLiteral("onlineMap")) == nullptr);
        QVERIFY(asked.isEmpty());
        click(QStringLiteral("layersTool"));
        click(QStringLiteral("layer.online"));
        QTRY_VERIFY(item(QStringLiteral("onlineMap")) != nullptr);
        QTRY_VERIFY_WITH_TIMEOUT(!asked.isEmpty(), kPatienceMs);
        QVERIFY2(asked.first().contains(QStringLiteral("GET /15/")), qPrintable(asked.first()));
        QVERIFY(item(QStringLiteral("onlineMap.credit"))->isVisible());
        picture(QStringLiteral("online"));
        click(QStringLiteral("layer.online"));
        QTRY_VERIFY(item(QStringLiteral("onlineMap")) == nullptr);
    }
    /// Prints what a frame costs while the map is panned, in processor time of all threads, and what of it
    /// which layer; and the memory it takes to have seen all of an image (FURROW_IMAGERY names another).
    void whatPanningCosts() {
        const QTemporaryDir folder;
        const QString small = folder.filePath(QStringLiteral("meadow.tif"));
        QVERIFY(writeMeadow(small));
        planCosts();
        if (QTest::currentTestFailed()) {
            return;
        }
        imageryCosts(small);
        if (QTest::currentTestFailed()) {
            return;
        }
        lookAtAll();
        if (QTest::currentTestFailed()) {
            return;
        }
        printMemory();
    }
};

FURROW_TEST_WITH(TestImageryWindow, QGuiApplication);
#include "tst_imagery_window.moc"
