#include "tests/support/patience.h"
#include "tests/support/test_program.h"
#include "ui/map/map_camera.h"
#include "ui/map/simplify.h"

#include <QLineF>
#include <QSignalSpy>
#include <QTest>

#include <cmath>

using namespace furrow;

class TestMapCamera : public QObject {
    Q_OBJECT

private slots:
    void goesThereAndBack_data() {
        QTest::addColumn<double>("lon");
        QTest::addColumn<double>("lat");
        QTest::newRow("Saaremaa") << 22.5 << 58.25;
        QTest::newRow("south of the equator") << 150.2 << -33.7;
        QTest::newRow("at the antimeridian") << 179.999 << 66.0;
        QTest::newRow("80 degrees north") << 20.0 << 80.0;
    }
    void goesThereAndBack() {
        QFETCH(double, lon);
        QFETCH(double, lat);
        MapCamera camera;
        camera.setViewport({1000.0, 700.0});
        camera.centreOn(QGeoCoordinate{lat, lon}, 19.0, false);
        const QPointF pixel{123.0, 456.0};
        QVERIFY(QLineF(camera.position(camera.coordinateAt(pixel)), pixel).length() < 1e-3);
        QVERIFY(QLineF(camera.position(QGeoCoordinate{lat, lon}), QPointF(500.0, 350.0)).length() < 1e-3);
    }
    void zoomKeepsThePlaceUnderThePointer() {
        MapCamera camera;
        camera.setViewport({1000.0, 700.0});
        camera.centreOn(QGeoCoordinate{58.25, 22.5}, 15.0, false);
        const QPointF pixel{830.0, 90.0};
        const QGeoCoordinate before = camera.coordinateAt(pixel);
        QSignalSpy spy{&camera, &MapCamera::changed};
        camera.zoomAt(pixel, 1.3, true);
        QTRY_COMPARE(camera.zoomLevel(), 16.3);
        QVERIFY(spy.count() >= 1);
        QVERIFY(before.distanceTo(camera.coordinateAt(pixel)) < 0.01);
    }
    void notchesInARowAddUp() {
        MapCamera camera;
        camera.setViewport({1000.0, 700.0});
        camera.centreOn(QGeoCoordinate{58.25, 22.5}, 12.0, false);
        for (int i = 0; i < 4; ++i) {
            camera.zoomAt({500.0, 350.0}, 0.5, true);
        }
        QTRY_COMPARE(camera.zoomLevel(), 14.0);
    }
    void fitsInsideTheMargins() {
        MapCamera camera;
        camera.setViewport({1000.0, 700.0});
        const QGeoRectangle area{QGeoCoordinate{58.26, 22.49}, QGeoCoordinate{58.25, 22.51}};
        camera.fit(area, 100.0, 60.0, 40.0, 20.0, false);
        const QPointF corner = camera.position(area.topLeft());
        const QPointF opposite = camera.position(area.bottomRight());
        QVERIFY(corner.x() >= 99.9 && corner.y() >= 59.9);
        QVERIFY(opposite.x() <= 960.1 && opposite.y() <= 680.1);
        // One of the two directions is filled.
        QVERIFY(std::abs(opposite.x() - corner.x() - 860.0) < 0.5 ||
                std::abs(opposite.y() - corner.y() - 620.0) < 0.5);
    }
    void whatIsFittedStaysWholeInASmallerItem_data() {
        QTest::addColumn<bool>("isMoved");
        QTest::newRow("untouched") << false;
        QTest::newRow("moved meanwhile") << true;
    }
    void whatIsFittedStaysWholeInASmallerItem() {
        QFETCH(const bool, isMoved);
        MapCamera camera;
        camera.setViewport({1000.0, 700.0});
        const QGeoRectangle area{QGeoCoordinate{58.26, 22.49}, QGeoCoordinate{58.25, 22.51}};
        camera.fit(area, 100.0, 60.0, 40.0, 20.0, false);
        if (isMoved) {
            camera.panBy(-5.0, 0.0);
        }
        const double before = camera.zoomLevel();
        camera.setViewport({500.0, 350.0});
        if (isMoved) {
            QCOMPARE(camera.zoomLevel(), before);
            return;
        }
        const QPointF corner = camera.position(area.topLeft());
        const QPointF opposite = camera.position(area.bottomRight());
        QVERIFY(corner.x() >= 99.9 && corner.y() >= 59.9);
        QVERIFY(opposite.x() <= 460.1 && opposite.y() <= 330.1);
        camera.setViewport({1000.0, 700.0});
        QCOMPARE(camera.zoomLevel(), before);
    }
    void fitsAcrossTheAntimeridian() {
        MapCamera camera;
        camera.setViewport({1000.0, 700.0});
        const QGeoRectangle area{QGeoCoordinate{66.01, 179.99}, QGeoCoordinate{66.0, -179.99}};
        camera.fit(area, 50.0, 50.0, 50.0, 50.0, false);
        QVERIFY(camera.zoomLevel() > 10.0);
        QVERIFY(camera.position(area.topLeft()).x() < camera.position(area.bottomRight()).x());
    }
    void staysInTheWorld() {
        MapCamera camera;
        camera.setViewport({1000.0, 700.0});
        camera.zoomAt({500.0, 350.0}, -30.0, false);
        camera.panBy(0.0, 1e6);
        QVERIFY(camera.toWorld({0.0, 0.0}).y >= -1e-9);
        camera.zoomAt({500.0, 350.0}, 60.0, false);
        QCOMPARE(camera.zoomLevel(), MapCamera::kMaxZoom);
    }
    void simplifiedLinesStayNear() {
        std::vector<MapPoint> arc;
        for (int i = 0; i <= 900; ++i) {
            const double angle = i * 0.1 * 3.14159265 / 180.0;
            arc.push_back(
                {static_cast<float>(1000.0 * std::cos(angle)), static_cast<float>(1000.0 * std::sin(angle))});
        }
        const std::vector<MapPoint> fewer = simplified(arc, 1.0F);
        QVERIFY(fewer.size() >= 8 && fewer.size() < 40);
        QCOMPARE(fewer.front(), arc.front());
        QCOMPARE(fewer.back(), arc.back());
        // The middle of a chord of a circle is as far off as it gets.
        for (std::size_t i = 0; i + 1 < fewer.size(); ++i) {
            const double x = (fewer[i].x + fewer[i + 1].x) / 2.0;
            const double y = (fewer[i].y + fewer[i + 1].y) / 2.0;
            QVERIFY(1000.0 - std::hypot(x, y) <= 1.01);
        }
    }
};

FURROW_TEST(TestMapCamera);
#include "tst_map_camera.moc"
