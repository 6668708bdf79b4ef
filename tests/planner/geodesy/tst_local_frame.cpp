#include "planner/geodesy/local_frame.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <geodesic.h>
#include <proj.h>

#include <array>
#include <cmath>
#include <limits>
#include <thread>

using namespace furrow;

namespace {

// WGS84 as NIMA TR8350.2 defines it.
constexpr double kSemiMajorM = 6378137.0;
constexpr double kInverseFlattening = 298.257223563;

geod_geodesic wgs84() {
    geod_geodesic ellipsoid;
    geod_init(&ellipsoid, kSemiMajorM, 1.0 / kInverseFlattening);
    return ellipsoid;
}

double geodesicDistanceM(GeoPoint a, GeoPoint b) {
    const geod_geodesic ellipsoid = wgs84();
    double metresBetween = 0.0;
    geod_inverse(&ellipsoid, a.latDeg, a.lonDeg, b.latDeg, b.lonDeg, &metresBetween, nullptr, nullptr);
    return metresBetween;
}

/// The place at this geodesic distance and azimuth (clockwise from north).
GeoPoint placeAt(GeoPoint from, double azimuthDeg, double wayM) {
    const geod_geodesic ellipsoid = wgs84();
    GeoPoint place;
    geod_direct(&ellipsoid, from.latDeg, from.lonDeg, azimuthDeg, wayM, &place.latDeg, &place.lonDeg,
                nullptr);
    return place;
}

void addCentres() {
    QTest::addColumn<double>("lonDeg");
    QTest::addColumn<double>("latDeg");
    QTest::newRow("mid-latitude") << 9.2 << 51.3;
    QTest::newRow("equator") << 36.8 << 0.0;
    QTest::newRow("southern hemisphere") << -58.4 << -34.6;
    QTest::newRow("80 degrees north") << 15.6 << 80.0;
    QTest::newRow("80 degrees south") << -70.0 << -80.0;
    QTest::newRow("on the antimeridian") << 180.0 << -16.5;
    QTest::newRow("just west of the antimeridian") << 179.99 << 66.0;
    QTest::newRow("just east of the antimeridian") << -179.99 << 66.0;
    QTest::newRow("border of UTM zones 31 and 32") << 6.0 << 52.2;
    QTest::newRow("Greenwich") << 0.0 << 51.5;
}

}  // namespace

class LocalFrameTest : public QObject {
    Q_OBJECT

private slots:
    void distancesAreThoseOfTheGeodesic_data() { addCentres(); }
    void distancesAreThoseOfTheGeodesic() {
        QFETCH(double, lonDeg);
        QFETCH(double, latDeg);
        const GeoPoint centre{lonDeg, latDeg};
        const auto frame = LocalFrame::centredOn(centre);
        VERIFY_RESULT(frame);
        for (const double wayM : {10.0, 1000.0, 5000.0, 9500.0}) {
            for (double azimuthDeg = 0.0; azimuthDeg < 360.0; azimuthDeg += 15.0) {
                const GeoPoint place = placeAt(centre, azimuthDeg, wayM);
                // A field's worth away from there, in every direction.
                for (const double acrossDeg : {0.0, 60.0, 90.0, 135.0}) {
                    const GeoPoint other = placeAt(place, azimuthDeg + acrossDeg, 500.0);
                    const double planeM = distance(frame->toLocal(place), frame->toLocal(other));
                    const double groundM = geodesicDistanceM(place, other);
                    // Under 1.3 mm per km within 10 km of the centre.
                    QVERIFY2(std::abs(planeM - groundM) < 1.3e-6 * groundM,
                             qPrintable(QStringLiteral("%1 m instead of %2 m")
                                            .arg(planeM, 0, 'f', 6)
                                            .arg(groundM, 0, 'f', 6)));
                }
            }
        }
    }

    void northIsUp_data() { addCentres(); }
    void northIsUp() {
        QFETCH(double, lonDeg);
        QFETCH(double, latDeg);
        const GeoPoint centre{lonDeg, latDeg};
        const auto frame = LocalFrame::centredOn(centre);
        VERIFY_RESULT(frame);
        const Point middle = frame->toLocal(centre);
        COMPARE_WITHIN(norm(middle), 0.0, 1e-8);
        const Point north = frame->toLocal(placeAt(centre, 0.0, 1000.0));
        COMPARE_WITHIN(north.x, 0.0, 1e-4);
        COMPARE_WITHIN(north.y, 1000.0, 1e-3);
        const Point east = frame->toLocal(placeAt(centre, 90.0, 1000.0));
        COMPARE_WITHIN(east.x, 1000.0, 1e-3);
        // The geodesic bends away from the grid by s³ tan(lat) / (6 R²), some micrometres.
        COMPARE_WITHIN(east.y, 0.0, 1e-3);
    }

    void roundTripIsExact_data() { addCentres(); }
    void roundTripIsExact() {
        QFETCH(double, lonDeg);
        QFETCH(double, latDeg);
        const GeoPoint centre{lonDeg, latDeg};
        const auto frame = LocalFrame::centredOn(centre);
        VERIFY_RESULT(frame);
        for (const double wayM : {0.0, 1.0, 300.0, 10'000.0, 49'000.0}) {
            for (double azimuthDeg = 0.0; azimuthDeg < 360.0; azimuthDeg += 30.0) {
                const GeoPoint place = placeAt(centre, azimuthDeg, wayM);
                const GeoPoint back = frame->toGeo(frame->toLocal(place));
                // On the antimeridian 180 and -180 are one place.
                COMPARE_WITHIN(std::remainder(back.lonDeg - place.lonDeg, 360.0), 0.0, 1e-9);
                COMPARE_WITHIN(back.latDeg, place.latDeg, 1e-9);
                QVERIFY(std::abs(back.lonDeg) <= 180.0);
            }
        }
    }

    // What files state about the frame rebuilds it in another program.
    void projStringRebuildsIt_data() { addCentres(); }
    void projStringRebuildsIt() {
        QFETCH(double, lonDeg);
        QFETCH(double, latDeg);
        const auto frame =
            LocalFrame::centredOn({lonDeg + (lonDeg < 0 ? 1.0 / 3.0 : -1.0 / 3.0), latDeg / 1.1});
        VERIFY_RESULT(frame);
        PJ* rebuilt = proj_create(nullptr, frame->projString().c_str());
        QVERIFY(rebuilt != nullptr);
        const GeoPoint place = placeAt(frame->centre(), 33.0, 2500.0);
        const PJ_COORD there = proj_trans(
            rebuilt, PJ_FWD, proj_coord(proj_torad(place.lonDeg), proj_torad(place.latDeg), 0.0, 0.0));
        proj_destroy(rebuilt);
        const Point ours = frame->toLocal(place);
        COMPARE_WITHIN(there.xy.x, ours.x, 1e-9);
        COMPARE_WITHIN(there.xy.y, ours.y, 1e-9);
    }

    void refusesCentres_data() {
        QTest::addColumn<double>("lonDeg");
        QTest::addColumn<double>("latDeg");
        QTest::newRow("too far east") << 180.1 << 0.0;
        QTest::newRow("too far south") << 0.0 << -90.5;
        QTest::newRow("not a number") << std::numeric_limits<double>::quiet_NaN() << 50.0;
        QTest::newRow("infinite") << 9.0 << std::numeric_limits<double>::infinity();
    }
    void refusesCentres() {
        QFETCH(double, lonDeg);
        QFETCH(double, latDeg);
        const auto frame = LocalFrame::centredOn({lonDeg, latDeg});
        QVERIFY(!frame);
        QCOMPARE(frame.error().code, ErrorCode::InputRefused);
    }

    // Snyder 1987, Map Projections, p. 12-16: the zone from the equator to latitude phi on an ellipsoid has
    // area 2 pi b² [sin phi / (2 (1 - e² sin² phi)) + atanh(e sin phi) / (2 e)]; a cell's share of it is
    // its longitudes over 360 degrees. Its parallels are followed by many points, since edges are geodesics.
    void areaOfADegreeCell_data() {
        QTest::addColumn<double>("southDeg");
        QTest::addColumn<double>("westDeg");
        QTest::newRow("at the equator") << 0.0 << 10.0;
        QTest::newRow("mid-latitude") << 51.0 << 9.0;
        QTest::newRow("southern hemisphere") << -35.0 << -59.0;
        QTest::newRow("far north") << 80.0 << 15.0;
        QTest::newRow("across the antimeridian") << 66.0 << 179.5;
    }
    void areaOfADegreeCell() {
        QFETCH(double, southDeg);
        QFETCH(double, westDeg);
        const double f = 1.0 / kInverseFlattening;
        const double b = kSemiMajorM * (1.0 - f);
        const double e = std::sqrt(f * (2.0 - f));
        const auto zoneM2 = [&](double latDeg) {
            const double s = std::sin(latDeg * std::numbers::pi / 180.0);
            return 2.0 * std::numbers::pi * b * b *
                   (s / (2.0 * (1.0 - e * e * s * s)) + std::atanh(e * s) / (2.0 * e));
        };
        const double expectedM2 = (zoneM2(southDeg + 1.0) - zoneM2(southDeg)) / 360.0;
        constexpr int kSteps = 2000;
        GeoPolygon cell;
        const auto wrapped = [](double lon) { return lon > 180.0 ? lon - 360.0 : lon; };
        for (int i = 0; i < kSteps; ++i) {
            cell.outer.push_back({wrapped(westDeg + static_cast<double>(i) / kSteps), southDeg});
        }
        cell.outer.push_back({wrapped(westDeg + 1.0), southDeg});
        for (int i = 0; i < kSteps; ++i) {
            cell.outer.push_back({wrapped(westDeg + 1.0 - static_cast<double>(i) / kSteps), southDeg + 1.0});
        }
        cell.outer.push_back({westDeg, southDeg + 1.0});
        COMPARE_WITHIN(geodesicArea(cell).si() / expectedM2, 1.0, 1e-8);
        // The direction does not matter.
        std::ranges::reverse(cell.outer);
        COMPARE_WITHIN(geodesicArea(cell).si() / expectedM2, 1.0, 1e-8);
    }

    // At the centre the plane has scale 1, so a hectare drawn there is a hectare on the ground.
    void areaOfAHectare_data() { addCentres(); }
    void areaOfAHectare() {
        QFETCH(double, lonDeg);
        QFETCH(double, latDeg);
        const auto frame = LocalFrame::centredOn({lonDeg, latDeg});
        VERIFY_RESULT(frame);
        const Polygon square{.outer = {{-50, -50}, {50, -50}, {50, 50}, {-50, 50}},
                             .holes = {{{-10, -10}, {-10, 10}, {10, 10}, {10, -10}}}};
        COMPARE_WITHIN(geodesicArea(frame->toGeo(square)).si(), 10'000.0 - 400.0, 1e-3);
    }

    void middleOfABox_data() {
        QTest::addColumn<double>("westDeg");
        QTest::addColumn<double>("eastDeg");
        QTest::addColumn<double>("expectedDeg");
        QTest::newRow("in the east") << 9.0 << 9.5 << 9.25;
        QTest::newRow("across Greenwich") << -0.5 << 0.25 << -0.125;
        QTest::newRow("across the antimeridian, more in the east") << 179.5 << -179.75 << 179.875;
        QTest::newRow("across the antimeridian, more in the west") << 179.75 << -179.5 << -179.875;
        QTest::newRow("the antimeridian as its western edge") << -180.0 << -179.5 << -179.75;
        QTest::newRow("the antimeridian as its eastern edge") << 179.5 << -180.0 << 179.75;
    }
    void middleOfABox() {
        QFETCH(double, westDeg);
        QFETCH(double, eastDeg);
        QFETCH(double, expectedDeg);
        const std::array boxes{GeoPolygon{
            .outer = {{westDeg, 50.0}, {eastDeg, 50.0}, {eastDeg, 50.5}, {westDeg, 50.5}}, .holes = {}}};
        const GeoPoint middle = middleOf(boxes);
        COMPARE_WITHIN(middle.lonDeg, expectedDeg, 1e-12);
        COMPARE_WITHIN(middle.latDeg, 50.25, 1e-12);
    }

    void severalThreadsAtOnce() {
        const auto first = LocalFrame::centredOn({9.2, 51.3});
        const auto second = LocalFrame::centredOn({-58.4, -34.6});
        const GeoPoint near{9.21, 51.31};
        const GeoPoint far{-58.41, -34.61};
        const Point firstLocal = first->toLocal(near);
        const Point secondLocal = second->toLocal(far);
        std::array<bool, 4> same{};
        {
            std::vector<std::jthread> threads;
            for (bool& result : same) {
                threads.emplace_back([&] {
                    result = true;
                    for (int i = 0; i < 200; ++i) {
                        result = result && first->toLocal(near) == firstLocal &&
                                 second->toLocal(far) == secondLocal;
                    }
                });
            }
        }
        for (const bool result : same) {
            QVERIFY(result);
        }
    }
};

FURROW_TEST(LocalFrameTest);
#include "tst_local_frame.moc"
