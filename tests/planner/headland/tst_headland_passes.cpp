#include "planner/geometry/curve_sampling.h"
#include "planner/geometry/geos_bridge.h"
#include "planner/headland/corner_manoeuvres.h"
#include "planner/headland/headland_passes.h"
#include "planner/headland/methods.h"
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

using namespace furrow;
using test::agbot;
using test::apart;
using test::sharpest;
using test::wideTractor;

namespace {

using test::totalTurning;

constexpr double kPi = std::numbers::pi;
constexpr GeoPoint kCentre{9.2, 51.3};

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

/// The passes of a headland: side by side, one way round or the other, into the corners.
class HeadlandPassesTest : public QObject {
    Q_OBJECT

private slots:
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
