#include "planner/geometry/geos_bridge.h"
#include "planner/geometry/prepared_area.h"
#include "planner/headland/corner_manoeuvres.h"
#include "planner/headland/pass_tracks.h"
#include "planner/headland/smooth_ring.h"
#include "planner/machine/machine_library.h"
#include "tests/planner/headland/pass_lines.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/stages.h"
#include "tests/support/test_program.h"
#include "tests/support/wkt.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stop_token>

using namespace furrow;
using test::agbot;
using test::apart;
using test::poseAt;
using test::sharpest;
using test::totalTurning;
using test::wideTractor;

namespace {

constexpr double kPi = std::numbers::pi;

}  // namespace

/// The lines of passes: rings that are rounded, and what of them can be driven.
class PassTracksTest : public QObject {
    Q_OBJECT

private slots:
    void smoothRectangle_data() {
        QTest::addColumn<double>("lengthM");
        QTest::addColumn<double>("widthM");
        QTest::addColumn<double>("radiusM");
        QTest::newRow("field") << 100.0 << 60.0 << 4.0;
        QTest::newRow("large radius") << 100.0 << 60.0 << 25.0;
        QTest::newRow("a little more than a circle") << 10.1 << 10.1 << 5.0;
        QTest::newRow("racetrack") << 80.0 << 12.01 << 6.0;
    }
    void smoothRectangle() {
        QFETCH(double, lengthM);
        QFETCH(double, widthM);
        QFETCH(double, radiusM);
        const auto line = smoothRing(test::rectangle(lengthM, widthM).outer, metres(radiusM), metres(0.01));
        QVERIFY(line.has_value());
        COMPARE_WITHIN(line->length().si(), 2.0 * (lengthM + widthM) - 8.0 * radiusM + 2.0 * kPi * radiusM,
                       1e-5);
        QVERIFY(apart(line->end(), line->start) < 1e-6);
        COMPARE_WITHIN(totalTurning(*line), 2.0 * kPi, 1e-9);
        QVERIFY(sharpest(*line) <= 1.0 / radiusM);
        // On the ring's first edge, along it.
        COMPARE_WITHIN(line->start.position.y, 0.0, 1e-9);
        COMPARE_WITHIN(line->start.heading.si(), 0.0, 1e-12);
    }

    void smoothRandomRings() {
        constexpr std::uint64_t kSeed = 51;
        std::mt19937_64 random{kSeed};
        int made = 0;
        for (int i = 0; i < 300; ++i) {
            const double radiusM = test::uniform(random, 1.0, 8.0);
            for (const Polygon& polygon :
                 test::randomPolygons(random, test::kShapes[static_cast<std::size_t>(i) % 5], 120.0)) {
                const auto line = smoothRing(polygon.outer, metres(radiusM), metres(0.25));
                if (!line) {
                    continue;
                }
                ++made;
                const QByteArray said = QStringLiteral("seed %1, ring %2").arg(kSeed).arg(i).toUtf8();
                VERIFY_TOLD(apart(line->end(), line->start) < 1e-6, said);
                VERIFY_TOLD(std::abs(totalTurning(*line) - 2.0 * kPi) < 1e-6, said);
                VERIFY_TOLD(sharpest(*line) <= (1.0 + 1e-9) / radiusM, said);
                for (const CurvePiece& piece : line->pieces) {
                    VERIFY_TOLD(piece.length.si() >= 0.0 && piece.gear == Gear::Forward, said);
                }
            }
        }
        QVERIFY2(made > 100, qPrintable(QString::number(made)));
    }

    void tooSmallToDrive_data() {
        QTest::addColumn<QString>("wkt");
        QTest::newRow("square of 7.9 m") << "POLYGON((0 0, 7.9 0, 7.9 7.9, 0 7.9, 0 0))";
        QTest::newRow("triangle of 3 m") << "POLYGON((0 0, 3 0, 0 3, 0 0))";
        QTest::newRow("strip of 4 m") << "POLYGON((0 0, 100 0, 100 4, 0 4, 0 0))";
        QTest::newRow("needle") << "POLYGON((0 0, 100 0, 0 2, 0 0))";
        QTest::newRow("points on each other") << "POLYGON((0 0, 50 0, 50 0.001, 0 0))";
    }
    void tooSmallToDrive() {
        QFETCH(QString, wkt);
        QVERIFY(
            !smoothRing(test::polygonsFromWkt(wkt.toStdString()).front().outer, metres(4.0), metres(0.1)));
    }

    void reversedLineDrivesBack() {
        const auto line = smoothRing(
            test::polygonsFromWkt("POLYGON((0 0, 90 -10, 110 50, 60 30, 10 70, 0 0))").front().outer,
            metres(4.0), metres(0.1));
        QVERIFY(line.has_value());
        const Curve back = reversedLine(*line);
        COMPARE_WITHIN(back.length().si(), line->length().si(), 1e-9);
        COMPARE_WITHIN(totalTurning(back), -2.0 * kPi, 1e-9);
        for (double wayM = 0.0; wayM <= line->length().si(); wayM += 1.7) {
            Pose there = poseAt(*line, wayM);
            there.heading = there.heading + degrees(180.0);
            QVERIFY(apart(poseAt(back, line->length().si() - wayM), there) < 1e-6);
        }
        QVERIFY(apart(reversedLine(back).start, line->start) < 1e-6);
    }

    void passTracksCanBeDriven_data() {
        QTest::addColumn<QString>("machine");
        QTest::addColumn<int>("shape");
        QTest::addColumn<int>("mostBad");  // rings where the footprint leaves the field by more than 1.5 cm
        QTest::addColumn<double>("worstM");
        for (const char* machine : {"agbot", "wide"}) {
            for (std::size_t shape = 0; shape < test::kShapes.size(); ++shape) {
                // Between the sides of a field that is hardly wider than the machine there is nowhere to move
                // to.
                const bool thin = test::kShapes[shape] == test::Shape::Thin;
                QTest::addRow("%s, %s", machine, std::string{test::shapeName(test::kShapes[shape])}.c_str())
                    << machine << static_cast<int>(shape) << (thin ? 11 : 0) << (thin ? 1.0 : 0.0);
            }
        }
    }
    void passTracksCanBeDriven() {
        QFETCH(QString, machine);
        QFETCH(int, shape);
        QFETCH(int, mostBad);
        QFETCH(double, worstM);
        const Machine& driven = machine == "wide" ? wideTractor() : agbot();
        const double curvature = 1.0 / driven.minTurningRadius().si();
        // Shrunk by what passes may touch.
        const auto footprint =
            eroded({{.outer = driven.workingFootprint(), .holes = {}}}, metres(0.015), metres(0.001), {});
        VERIFY_RESULT(footprint);
        constexpr std::uint64_t kSeed = 61;
        std::mt19937_64 random{kSeed};
        int rings = 0;
        double worstOfAllM = 0.0;
        QStringList bad;
        for (int i = 0; i < 16; ++i) {
            const MultiPolygon field =
                test::randomPolygons(random, test::kShapes[static_cast<std::size_t>(shape)], 100.0);
            const PreparedArea inside{field};
            for (int pass = 0; pass < 2; ++pass) {
                const auto tracks =
                    passTracks(field, 0.5 * driven.workingFootprintWidth() + pass * driven.operatingWidth(),
                               field, driven, {}, {});
                VERIFY_RESULT(tracks);
                for (const Curve& line : tracks->lines) {
                    const QString said =
                        QStringLiteral("seed %1, field %2, pass %3").arg(kSeed).arg(i).arg(pass);
                    ++rings;
                    VERIFY_TOLD(apart(line.end(), line.start) < 1e-5, said.toUtf8());
                    VERIFY_TOLD(sharpest(line) <= curvature * (1.0 + 1e-9), said.toUtf8());
                    VERIFY_TOLD(std::abs(std::abs(totalTurning(line)) - 2.0 * kPi) < 1e-5, said.toUtf8());
                    double worst = 0.0;
                    for (double wayM = 0.0; wayM < line.length().si(); wayM += 0.25) {
                        Ring here = placed(footprint->front().outer, poseAt(line, wayM));
                        here.push_back(here.front());
                        if (!inside.covers({here})) {
                            const auto out = inside.farthestOutside({here});
                            worst = std::max(worst, out ? out->distance.si() : 0.0);
                        }
                    }
                    if (worst > 0.0) {
                        worstOfAllM = std::max(worstOfAllM, worst);
                        bad << QStringLiteral("%1: %2 m").arg(said).arg(worst);
                    }
                }
            }
        }
        QVERIFY2(rings > 10, qPrintable(QString::number(rings)));
        const QString summary = QStringLiteral("%1 of %2: %3").arg(bad.size()).arg(rings).arg(bad.join("; "));
        QVERIFY2(bad.size() <= mostBad && worstOfAllM <= worstM, qPrintable(summary));
        if (!bad.empty()) {
            qInfo("%s", qPrintable(summary));
        }
    }

    // 80 by 80 m with a pond of 40 by 40 m that leaves a lane of 9 m on its right, narrower than twice the
    // radius: both shores keep their line. Piers on both make the rings too sharp to be rounded corner by
    // corner.
    void aLaneNarrowerThanATurnKeepsItsPasses() {
        MachineSpec spec = agbot().spec();
        spec.tractor.minTurningRadius = metres(6.0);
        const Machine machine = Machine::create(spec).value();
        const MultiPolygon field = test::polygonsFromWkt(
            "POLYGON((0 0, 40 0, 40 2, 41 2, 41 0, 80 0, 80 80, 0 80, 0 0), (31 20, 31 60, 71 60, 71 20, 52 20, 52 18, 51 18, 51 20, 31 20))");
        const auto rings = eroded(field, metres(1.5), metres(0.01), {});
        VERIFY_RESULT(rings);
        QVERIFY(!smoothRing(rings->front().outer, metres(6.0), metres(0.25)));
        QVERIFY(!smoothRing(rings->front().holes.front(), metres(6.0), metres(0.25)));
        const auto tracks = passTracks(field, metres(1.5), field, machine, {}, {});
        VERIFY_RESULT(tracks);
        QCOMPARE(tracks->givenUp, 0);
        QCOMPARE(tracks->lines.size(), std::size_t{2});
        for (const Curve& line : tracks->lines) {
            QVERIFY(sharpest(line) <= (1.0 + 1e-9) / 6.0);
            // Both go along the lane: 4.5 m from its middle at most.
            double nearest = 1e9;
            for (double wayM = 0.0; wayM < line.length().si(); wayM += 0.5) {
                nearest = std::min(nearest, distance(poseAt(line, wayM).position, {75.5, 40.0}));
            }
            QVERIFY2(nearest < 4.5, qPrintable(QString::number(nearest)));
        }
    }

    // Half of a circle of 15 m lies in the yard, half as much outside. What was farther outside than the
    // machine is long counted as inside.
    void aLineIsCutWhereItLeavesForLong() {
        const Machine& machine = agbot();
        const Curvature bend = Curvature::fromSi(1.0 / 15.0);
        const Curve line{
            .type = {},
            .start = {.position = {30.0, 15.0}, .heading = degrees(180.0)},
            .pieces = {{.length = metres(30.0 * std::numbers::pi), .curvature = bend, .endCurvature = bend}}};
        const auto parts = partsInside(line, MultiPolygon{test::rectangle(60.0, 40.0)}, machine, {});
        QCOMPARE(parts.size(), std::size_t{1});
        const double leftM = parts.front().length().si();
        QVERIFY2(leftM > 38.0 && leftM < 15.0 * std::numbers::pi, qPrintable(QString::number(leftM)));
        for (double wayM = 0.0; wayM < leftM; wayM += 0.1) {
            for (const Point& corner : placed(machine.workingFootprint(), poseAt(parts.front(), wayM))) {
                QVERIFY(corner.y > -0.01);
            }
        }
    }

    // A line round a yard of 60 by 40 m, 2 m from its walls; a pillar stands on it in the middle of the lower
    // side.
    void aLineIsCutWhereItDoesNotFit() {
        const Machine& machine = agbot();
        const MultiPolygon yard{test::rectangle(60.0, 40.0)};
        const Ring round{{5.0, 5.0}, {55.0, 5.0}, {55.0, 35.0}, {5.0, 35.0}};
        const Curve line = smoothRing(round, machine.minTurningRadius(), metres(0.01)).value();
        const auto whole = partsInside(line, yard, machine, {});
        QCOMPARE(whole.size(), std::size_t{1});
        QCOMPARE(whole.front(), line);
        const auto pillared = difference(yard, {test::rectangle(0.5, 0.5, {29.75, 4.75})}, {});
        VERIFY_RESULT(pillared);
        const auto parts = partsInside(line, *pillared, machine, {});
        double leftM = 0.0;
        for (const Curve& part : parts) {
            leftM += part.length().si();
            for (double wayM = 0.0; wayM < part.length().si(); wayM += 0.1) {
                // Nose and tail keep clear of the pillar.
                for (const Point& corner : placed(machine.workingFootprint(), poseAt(part, wayM))) {
                    QVERIFY(std::abs(corner.x - 30.0) > 0.25 || std::abs(corner.y - 5.0) > 0.25);
                }
            }
        }
        // What is lost is the pillar, the machine's length and a little.
        const Ring footprint = machine.workingFootprint();
        const auto [tail, nose] = std::ranges::minmax(footprint, {}, &Point::x);
        const double lengthM = nose.x - tail.x;
        const double lostM = line.length().si() - leftM;
        QVERIFY2(lostM > lengthM + 0.5 && lostM < lengthM + 0.5 + 2.0, qPrintable(QString::number(lostM)));
        QCOMPARE(parts.size(), std::size_t{1});
    }

    /// The corner of a step passes through a corner of the footprint between two places that are looked at.
    void aStepInTheEdgeDoesNotCutThePass_data() {
        QTest::addColumn<double>("height");
        for (const double height : {0.8, 1.5, 2.0, 3.0}) {
            QTest::addRow("%.1f m", height) << height;
        }
    }
    void aStepInTheEdgeDoesNotCutThePass() {
        QFETCH(double, height);
        const Machine machine = findMachine("cultivator").value();
        const MultiPolygon field{
            {.outer = {{0, 0}, {76, 1}, {75, 71}, {56, 71}, {56, 71 + height}, {0, 71 + height}},
             .holes = {}}};
        const auto tracks = passTracks(field, metres(3.0), field, machine, {}, {});
        VERIFY_RESULT(tracks);
        QCOMPARE(tracks->lines.size(), std::size_t{1});
        QCOMPARE(tracks->givenUp, 0);
        const std::vector<Curve> parts = partsInside(tracks->lines.front(), field, machine, {});
        QCOMPARE(parts.size(), std::size_t{1});
        QCOMPARE(parts.front(), tracks->lines.front());
    }
    void aStoppedJobIsCancelled() {
        std::stop_source stop;
        stop.request_stop();
        const MultiPolygon field{test::rectangle(100.0, 60.0)};
        const auto tracks = passTracks(field, metres(2.0), field, agbot(), {}, {.stop = stop.get_token()});
        QVERIFY(!tracks);
        QCOMPARE(tracks.error().code, ErrorCode::Cancelled);
    }

    void uncutCornerByHand() {
        const auto at = [](double deg) {
            return uncutCorner({.firstPiece = 0, .lastPiece = 0, .turn = degrees(deg), .radius = metres(4.0)},
                               metres(3.0))
                .si();
        };
        // A square of R + w/2 less its quarter circle.
        COMPARE_WITHIN(at(90.0), (1.0 - kPi / 4.0) * 5.5 * 5.5, 1e-9);
        COMPARE_WITHIN(at(-90.0), at(90.0), 1e-12);
        // At 60 degrees: two right triangles with legs r and r tan(30 degrees) less a sixth of the circle.
        COMPARE_WITHIN(at(60.0), 5.5 * 5.5 * (1.0 / std::sqrt(3.0) - kPi / 6.0), 1e-9);
    }

    void cornersOfARectangle() {
        const auto line = smoothRing(test::rectangle(100.0, 60.0).outer, metres(4.0), metres(0.1));
        QVERIFY(line.has_value());
        const auto corners = roundedCorners(*line, metres(4.0));
        QCOMPARE(corners.size(), std::size_t{4});
        for (const RoundedCorner& corner : corners) {
            COMPARE_WITHIN(inDegrees(corner.turn), 90.0, 1e-6);
            COMPARE_WITHIN(corner.radius.si(), 4.0, 1e-6);
        }
        const auto back = roundedCorners(reversedLine(*line), metres(4.0));
        QCOMPARE(back.size(), std::size_t{4});
        COMPARE_WITHIN(inDegrees(back.front().turn), -90.0, 1e-6);
    }
};

FURROW_TEST(PassTracksTest);
#include "tst_pass_tracks.moc"
