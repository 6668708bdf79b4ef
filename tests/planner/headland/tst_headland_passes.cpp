#include "planner/geometry/curve_sampling.h"
#include "planner/geometry/geos_bridge.h"
#include "planner/headland/corner_manoeuvres.h"
#include "planner/headland/headland_passes.h"
#include "planner/headland/methods.h"
#include "planner/headland/pass_tracks.h"
#include "planner/headland/smooth_ring.h"
#include "planner/machine/machine_library.h"
#include "planner/turns/dubins.h"
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

namespace {

constexpr double kPi = std::numbers::pi;
constexpr GeoPoint kCentre{9.2, 51.3};

// Tractor 3 m wide, implement 2.5 m: 0.25 m stays uncut on either side.
const Machine& wideTractor() {
    static const Machine machine = [] {
        MachineSpec spec = agbot().spec();
        spec.tractor.width = metres(3.0);
        spec.implement.operatingWidth = metres(2.5);
        return Machine::create(spec).value();
    }();
    return machine;
}

Field fieldFrom(const MultiPolygon& polygons) {
    return Field::create(test::fieldSourceFromLocal(polygons, kCentre)).value();
}

Result<Headland> headlandOf(const Field& field, const Machine& machine,
                            std::initializer_list<std::pair<const Parameter*, std::string_view>> given,
                            double marginM = 0.0) {
    Settings settings;
    for (const auto& [parameter, text] : given) {
        settings.setText(*parameter, text).value();
    }
    return test::headlandBy(kConstantWidthMethod, field, machine, settings, metres(marginM));
}

double totalTurning(const Curve& line) {
    double turned = 0.0;
    for (const CurvePiece& piece : line.pieces) {
        turned += 0.5 * (piece.curvature + piece.endCurvature).si() * piece.length.si();
    }
    return turned;
}

double sharpest(const Curve& line) {
    double most = 0.0;
    for (const CurvePiece& piece : line.pieces) {
        most = std::max({most, std::abs(piece.curvature.si()), std::abs(piece.endCurvature.si())});
    }
    return most;
}

double apart(const Pose& a, const Pose& b) {
    return std::max(distance(a.position, b.position),
                    std::abs(std::remainder(a.heading.si() - b.heading.si(), 2.0 * kPi)));
}

Pose poseAt(const Curve& line, double wayM) {
    Pose pose = line.start;
    for (const CurvePiece& piece : line.pieces) {
        if (wayM <= piece.length.si()) {
            return advanced(pose, piece, metres(wayM));
        }
        wayM -= piece.length.si();
        pose = advanced(pose, piece, piece.length);
    }
    return pose;
}

Polyline pointsOf(const Curve& line) {
    Polyline points;
    for (const CurveSample& sample : sampled(line, metres(0.001))) {
        points.push_back(sample.pose.position);
    }
    return points;
}

/// Of all stretches of a pass; where the implement works straight on past a corner, the corner is in them
/// twice.
std::vector<Polyline> linesOf(const HeadlandPass& pass) {
    std::vector<Polyline> lines;
    for (const PassStretch& stretch : pass.stretches) {
        lines.push_back(pointsOf(stretch.line));
    }
    return lines;
}

double angleBetween(const Pose& a, const Pose& b) {
    return std::remainder(b.heading.si() - a.heading.si(), 2.0 * kPi);
}

/// Once round: its bends, and the corners between one stretch and the next.
double totalTurning(const HeadlandPass& pass) {
    double turned = 0.0;
    for (std::size_t i = 0; i < pass.stretches.size(); ++i) {
        const Curve& line = pass.stretches[i].line;
        turned += totalTurning(line) +
                  angleBetween(line.end(), pass.stretches[(i + 1) % pass.stretches.size()].line.start);
    }
    return turned;
}

double distanceTo(const Polyline& line, Point point) {
    double nearest = 1e9;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Point way = line[i] - line[i - 1];
        const double square = dot(way, way);
        const double t = square > 0.0 ? std::clamp(dot(point - line[i - 1], way) / square, 0.0, 1.0) : 0.0;
        nearest = std::min(nearest, distance(point, line[i - 1] + t * way));
    }
    return nearest;
}

double distanceTo(const std::vector<Polyline>& lines, Point point) {
    double nearest = 1e9;
    for (const Polyline& line : lines) {
        nearest = std::min(nearest, distanceTo(line, point));
    }
    return nearest;
}

}  // namespace

class HeadlandPassesTest : public QObject {
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
        const auto parts = partsInside(line, {test::rectangle(60.0, 40.0)}, machine, {});
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

    void passesLieSideBySide_data() {
        QTest::addColumn<bool>("wide");
        QTest::addColumn<double>("marginM");
        QTest::addColumn<QList<double>>("insetsM");
        QTest::newRow("three passes") << false << 0.0 << QList<double>{1.25, 3.75, 6.25};
        QTest::newRow("with a margin") << false << 0.5 << QList<double>{1.75, 4.25, 6.75};
        QTest::newRow("tractor wider than the implement") << true << 0.0 << QList<double>{1.5, 4.0, 6.5};
    }
    void passesLieSideBySide() {
        QFETCH(bool, wide);
        QFETCH(double, marginM);
        QFETCH(QList<double>, insetsM);
        // Large enough that rounding the outermost pass leaves little of it.
        const Field field = fieldFrom({test::centredRectangle(200.0, 120.0)});
        const auto headland =
            headlandOf(field, wide ? wideTractor() : agbot(), {{&kHeadlandPasses, "3"}}, marginM);
        VERIFY_RESULT(headland);
        QCOMPARE(headland->drivenPasses.size(), static_cast<std::size_t>(insetsM.size()));
        const Bounds box = bounds(field.boundary());
        const Point middle = 0.5 * (box.min + box.max);
        for (std::size_t i = 0; i < headland->drivenPasses.size(); ++i) {
            const HeadlandPass& pass = headland->drivenPasses[i];
            QCOMPARE(pass.ring, static_cast<int>(i));
            QCOMPARE(pass.width.si(), 2.5);
            // The outermost is one rounded line; those inside of it, sides that meet at sharp corners.
            QCOMPARE(pass.closed, i == 0);
            QCOMPARE(pass.stretches.size(), std::size_t{i == 0 ? 1U : 4U});
            for (const PassStretch& stretch : pass.stretches) {
                QVERIFY(stretch.working);
                QVERIFY(i == 0 || sharpest(stretch.line) == 0.0);
            }
            const std::vector<Polyline> points = linesOf(pass);
            for (const Point side : {Point{middle.x, box.min.y}, Point{middle.x, box.max.y},
                                     Point{box.min.x, middle.y}, Point{box.max.x, middle.y}}) {
                COMPARE_WITHIN(distanceTo(points, side), insetsM[static_cast<qsizetype>(i)], 2e-3);
            }
            COMPARE_WITHIN(totalTurning(pass), 2.0 * kPi, 1e-5);
        }
        // The mainland begins half an operating width inside the innermost pass.
        COMPARE_WITHIN(headland->width.si(), insetsM.back() + 1.25, 1e-9);
    }

    /// As an outline traced from squares of 2 m is, where it runs across them: each tooth would cut the
    /// passes inside of the outermost one in two. What these work, beside each other, is nearly all between
    /// it and the mainland.
    void edgesOfTeethDoNotCutPasses() {
        constexpr double kTooth = 2.0 * std::numbers::sqrt2;
        constexpr int kAlong = 32;
        constexpr int kAcross = 18;
        Ring ring;
        const auto side = [&](Point from, Point along, int teeth) {
            for (int i = 0; i < teeth; ++i) {
                ring.push_back(from + (i * kTooth) * along);
                ring.push_back(from + ((i + 0.5) * kTooth) * along + 0.5 * kTooth * Point{along.y, -along.x});
            }
        };
        const Point far{kAlong * kTooth, kAcross * kTooth};
        side({}, {1.0, 0.0}, kAlong);
        side({far.x, 0.0}, {0.0, 1.0}, kAcross);
        side(far, {-1.0, 0.0}, kAlong);
        side({0.0, far.y}, {0.0, -1.0}, kAcross);
        const Field field = fieldFrom({{.outer = ring, .holes = {}}});
        const auto headland = headlandOf(field, agbot(), {{&kHeadlandPasses, "4"}});
        VERIFY_RESULT(headland);
        MultiPolygon lanes;
        for (const HeadlandPass& pass : headland->drivenPasses) {
            QVERIFY2(pass.stretches.size() <= 8,
                     QByteArray::number(static_cast<qsizetype>(pass.stretches.size())).constData());
            const auto lane = aroundLines(linesOf(pass), 0.5 * pass.width, kArcTolerance, {});
            VERIFY_RESULT(lane);
            lanes.insert(lanes.end(), lane->begin(), lane->end());
        }
        QCOMPARE(headland->drivenPasses.size(), std::size_t{4});
        const auto toothless = eroded(field.boundary(), metres(1.25), kArcTolerance, {});
        VERIFY_RESULT(toothless);
        const auto inside = difference(*toothless, headland->mainland, {});
        VERIFY_RESULT(inside);
        const auto left = unionOf(lanes, {}).and_then(
            [&](const MultiPolygon& all) { return difference(*inside, all, {}); });
        VERIFY_RESULT(left);
        QCOMPARE_LT(area(*left) / area(*inside), 0.04);
    }

    void aWidthThatHoldsNoWholeNumberOfPasses() {
        // 9 m: passes at 1.25, 3.75 and 6.25 m; one more would drive 1 m over what is worked.
        const Field field = fieldFrom({test::centredRectangle(100.0, 60.0)});
        const auto headland = headlandOf(field, agbot(), {{&kHeadlandWidth, "9"}});
        VERIFY_RESULT(headland);
        QCOMPARE(headland->drivenPasses.size(), std::size_t{3});
        const Bounds box = bounds(field.boundary());
        const std::vector<Polyline> points = linesOf(headland->drivenPasses.back());
        COMPARE_WITHIN(distanceTo(points, {0.5 * (box.min.x + box.max.x), box.min.y}), 6.25, 2e-3);
    }

    void clockwiseIsTheOtherWayRound() {
        const Field field = fieldFrom(test::polygonsFromWkt(
            "POLYGON((-60 -60, 60 -60, 60 60, -60 60, -60 -60), (-15 -15, -15 15, 15 15, 15 -15, -15 -15))"));
        const auto left = headlandOf(field, agbot(), {{&kHeadlandPasses, "2"}});
        const auto right =
            headlandOf(field, agbot(), {{&kHeadlandPasses, "2"}, {&kHeadlandDirection, "clockwise"}});
        VERIFY_RESULT(left);
        VERIFY_RESULT(right);
        // Two passes round the boundary, two round the hole.
        QCOMPARE(left->drivenPasses.size(), std::size_t{4});
        QCOMPARE(right->drivenPasses.size(), std::size_t{4});
        int outer = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            const HeadlandPass& there = left->drivenPasses[i];
            const HeadlandPass& back = right->drivenPasses[i];
            QCOMPARE(there.stretches.size(), back.stretches.size());
            COMPARE_WITHIN(totalTurning(there) + totalTurning(back), 0.0, 1e-9);
            // Each moves in where it begins, which is at another corner.
            COMPARE_WITHIN(there.length().si(), back.length().si(), 0.01 * there.length().si());
            outer += totalTurning(there) > 0.0 ? 1 : 0;
        }
        QCOMPARE(outer, 2);
    }

    // A triangle of 500 m, two passes of 24 m. The sides of the inner one, 36 m from the edges, are 500 - 72
    // / tan(30°) m long; what pulls its boom drives past the points where they meet and comes back in a loop,
    // the boom up.
    void innerPassesOfWhatCannotReverseLoop() {
        const Machine sprayer = findMachine("trailed-sprayer").value();
        const Field field = fieldFrom(test::polygonsFromWkt("POLYGON((0 0, 500 0, 250 433.0127, 0 0))"));
        const auto headland = headlandOf(field, sprayer, {{&kHeadlandPasses, "2"}});
        VERIFY_RESULT(headland);
        double workedM = 0.0;
        int loops = 0;
        for (const HeadlandPass& pass : headland->drivenPasses) {
            for (const PassStretch& stretch : pass.stretches) {
                if (pass.ring == 1) {
                    workedM += stretch.working ? stretch.line.length().si() : 0.0;
                    loops += stretch.working ? 0 : 1;
                }
            }
        }
        QCOMPARE(loops, 3);
        const double sideM = 500.0 - 72.0 / std::tan(kPi / 6.0);
        // Where they end the boom has left what lies between both passes: at least a quarter of the way to
        // where the outer edges meet, 12 m * tan(60°).
        QVERIFY2(workedM > 3.0 * (sideM + 2.0 * 0.25 * 12.0 * std::tan(kPi / 3.0)),
                 qPrintable(QString::number(workedM)));
        QVERIFY2(workedM < 3.0 * (sideM + 2.0 * (12.0 * std::tan(kPi / 3.0) + 10.0)),
                 qPrintable(QString::number(workedM)));
    }

    void notDriven() {
        const Field field = fieldFrom({test::centredRectangle(100.0, 60.0)});
        const auto headland =
            headlandOf(field, agbot(), {{&kHeadlandPasses, "3"}, {&kHeadlandDriven, "false"}});
        VERIFY_RESULT(headland);
        QVERIFY(headland->drivenPasses.empty());
        QCOMPARE(headland->passes, 3);
        COMPARE_WITHIN(headland->width.si(), 7.5, 1e-9);
        const auto none = headlandOf(field, agbot(), {{&kHeadlandPasses, "0"}});
        VERIFY_RESULT(none);
        QVERIFY(none->drivenPasses.empty());
    }

    void intoTheCorners_data() {
        QTest::addColumn<QString>("corner");
        QTest::addColumn<QString>("direction");
        for (const char* corner : {"loop", "reverse"}) {
            for (const char* direction : {"counter-clockwise", "clockwise"}) {
                QTest::addRow("%s, %s", corner, direction) << corner << direction;
            }
        }
    }
    void intoTheCorners() {
        QFETCH(QString, corner);
        QFETCH(QString, direction);
        // Large enough that the rounded pass, which the others are compared with, leaves its corners.
        const Field field = fieldFrom({test::centredRectangle(200.0, 120.0)});
        const std::string kind = corner.toStdString();
        const std::string way = direction.toStdString();
        const auto rounded =
            headlandOf(field, agbot(), {{&kHeadlandPasses, "8"}, {&kHeadlandDirection, way}});
        const auto headland = headlandOf(
            field, agbot(), {{&kHeadlandPasses, "8"}, {&kHeadlandDirection, way}, {&kHeadlandCorner, kind}});
        VERIFY_RESULT(rounded);
        VERIFY_RESULT(headland);
        QCOMPARE(headland->drivenPasses.size(), std::size_t{8});
        int manoeuvres = 0;
        for (const HeadlandPass& pass : headland->drivenPasses) {
            const std::size_t size = pass.stretches.size();
            double lengthM = 0.0;
            for (std::size_t i = 0; i < size; ++i) {
                const PassStretch& stretch = pass.stretches[i];
                const PassStretch& next = pass.stretches[(i + 1) % size];
                QVERIFY(apart(stretch.line.end(), next.line.start) < 1e-5);
                lengthM += stretch.line.length().si();
                QVERIFY(sharpest(stretch.line) <= (1.0 + 1e-9) / agbot().minTurningRadius().si());
                // The implement is up between two worked stretches, never twice in a row.
                QVERIFY(stretch.working || next.working);
                manoeuvres += stretch.working ? 0 : 1;
                if (stretch.working || kind == "loop") {
                    for (const CurvePiece& piece : stretch.line.pieces) {
                        QVERIFY(piece.gear == Gear::Forward);
                    }
                }
            }
            COMPARE_WITHIN(pass.length().si(), lengthM, 1e-9);
        }
        // Far enough inside all four corners of a pass are driven into, whichever way round: four sides, four
        // manoeuvres.
        QCOMPARE(headland->drivenPasses.back().stretches.size(), std::size_t{8});
        QVERIFY2(manoeuvres >= 4, qPrintable(QString::number(manoeuvres)));
        QVERIFY2(headland->uncutCorners <= rounded->uncutCorners,
                 qPrintable(QString::number(headland->uncutCorners.si()) + " " +
                            QString::number(rounded->uncutCorners.si())));
    }

    // An implement that folds to the tractor's width has room to turn even along the boundary.
    void reverseLeavesLess() {
        MachineSpec spec = agbot().spec();
        spec.implement.operatingWidth = metres(6.0);
        spec.implement.raisedWidth = metres(2.5);
        const Machine machine = Machine::create(spec).value();
        const Field field = fieldFrom({test::centredRectangle(200.0, 120.0)});
        const auto rounded = headlandOf(field, machine, {{&kHeadlandPasses, "2"}});
        const auto reverse =
            headlandOf(field, machine, {{&kHeadlandPasses, "2"}, {&kHeadlandCorner, "reverse"}});
        VERIFY_RESULT(rounded);
        VERIFY_RESULT(reverse);
        QVERIFY2(reverse->uncutCorners < rounded->uncutCorners,
                 qPrintable(QString::number(reverse->uncutCorners.si())));
    }

    // Where rounding would leave more than 0.4 % of the field, what can reverse drives into the corners.
    void intoTheCornersOfASmallField() {
        const Field field = fieldFrom({test::centredRectangle(40.0, 30.0)});
        const auto driven = headlandOf(field, agbot(), {{&kHeadlandPasses, "2"}});
        VERIFY_RESULT(driven);
        const HeadlandPass& outermost = driven->drivenPasses.front();
        QVERIFY(outermost.closed);
        QCOMPARE(std::ranges::count(outermost.stretches, false, &PassStretch::working), std::ptrdiff_t{4});
        COMPARE_WITHIN(driven->uncutCorners.si(), 0.0, 1e-12);
        for (std::size_t i = 0; i < outermost.stretches.size(); ++i) {
            const Curve& line = outermost.stretches[i].line;
            QVERIFY(apart(line.end(), outermost.stretches[(i + 1) % outermost.stretches.size()].line.start) <
                    1e-5);
            QVERIFY(sharpest(line) <= (1.0 + 1e-9) / agbot().minTurningRadius().si());
        }
        // Two centimetres farther in than a pass that goes round: it has to get free from beside the edge.
        const Bounds box = bounds(field.boundary());
        COMPARE_WITHIN(distanceTo(linesOf(outermost), {0.5 * (box.min.x + box.max.x), box.min.y}), 1.27,
                       2e-3);

        MachineSpec spec = agbot().spec();
        spec.tractor.canReverse = false;
        const auto rounded = headlandOf(field, Machine::create(spec).value(), {{&kHeadlandPasses, "2"}});
        VERIFY_RESULT(rounded);
        QCOMPARE(rounded->drivenPasses.front().stretches.size(), std::size_t{1});
        const double besideM = agbot().minTurningRadius().si() + 0.5 * agbot().operatingWidth().si();
        QCOMPARE_GE(rounded->uncutCorners.si(), 4.0 * (1.0 - kPi / 4.0) * besideM * besideM - 1e-6);
    }

    // Half-way round a corner is no place to begin: all four are found from there too.
    void aLineThatBeginsWithACorner() {
        const auto line =
            smoothRing(test::rectangle(60.0, 40.0, {20.0, 10.0}).outer, metres(4.0), metres(0.1));
        QVERIFY(line.has_value());
        const MultiPolygon drivable{test::rectangle(100.0, 60.0)};
        for (const CornerMethod method : {CornerMethod::Loop, CornerMethod::Reverse}) {
            for (const Curve& way : {*line, reversedLine(*line)}) {
                std::vector<RoundedCorner> left;
                CornerWays ways;
                const auto stretches = withCorners(way, method, drivable, agbot(),
                                                   [](const RoundedCorner&) { return true; }, ways, left, {});
                QVERIFY(left.empty());
                QCOMPARE(std::ranges::count(stretches, false, &PassStretch::working), std::ptrdiff_t{4});
                for (std::size_t i = 0; i < stretches.size(); ++i) {
                    QVERIFY(apart(stretches[i].line.end(), stretches[(i + 1) % stretches.size()].line.start) <
                            1e-6);
                }
            }
        }
    }
};

FURROW_TEST(HeadlandPassesTest);
#include "tst_headland_passes.moc"
