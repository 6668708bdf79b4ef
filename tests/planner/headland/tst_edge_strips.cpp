#include "planner/geometry/segment.h"
#include "planner/headland/headland_passes.h"
#include "planner/headland/methods.h"
#include "planner/headland/turning_room.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/stages.h"
#include "tests/support/test_program.h"
#include "tests/support/wkt.h"

#include <numbers>
#include <random>

using namespace furrow;
using test::agbot;

namespace {

constexpr GeoPoint kCentre{9.2, 51.3};

/// A U turn of the machine with half a circle from one swath to the next; its front corners, 1 m beside and 6
/// m ahead of the axle, get sqrt((3 + 1)² + 6²) = 7.2 m ahead of where it began.
Machine uTurner() {
    MachineSpec spec;
    spec.tractor.width = metres(2.0);
    spec.tractor.length = metres(7.0);
    spec.tractor.rearOverhang = metres(1.0);
    spec.tractor.minTurningRadius = metres(3.0);
    spec.implement.operatingWidth = metres(6.0);
    spec.implement.raisedWidth = metres(2.0);
    spec.implement.offset = metres(0.0);
    spec.implement.length = metres(1.0);
    return Machine::create(spec).value();
}

SwathEnds endsAt(double headingDeg, const Machine& machine) {
    return [headingDeg, widthM = machine.operatingWidth().si()](
               const MultiPolygon& mainland) -> Result<std::vector<Pose>> {
        std::vector<Pose> ends;
        for (const Swath& swath : test::swathsOf(mainland, widthM, headingDeg).swaths) {
            const Point way = swath.end - swath.start;
            ends.push_back({.position = swath.end, .heading = radians(std::atan2(way.y, way.x))});
            ends.push_back({.position = swath.start, .heading = radians(std::atan2(-way.y, -way.x))});
        }
        return ends;
    };
}

Result<Headland> headlandOf(const Method<HeadlandGenerator>& method, const Field& field,
                            const Machine& machine, const Settings& settings, double headingDeg,
                            Length margin = {}) {
    return drivableArea(field, margin, {}).and_then([&](const MultiPolygon& drivable) {
        return method.run({.field = field,
                           .drivable = drivable,
                           .machine = machine,
                           .turn = kDubinsMethod.run,
                           .settings = settings,
                           .margin = margin,
                           .drawsOutEnds = false,
                           .swathEnds = endsAt(headingDeg, machine)},
                          {});
    });
}

Settings drivenIs(bool driven) {
    Settings settings;
    settings.set(kHeadlandDriven, driven).value();
    return settings;
}

FieldSource withEdge(FieldSource source, std::size_t edge, double widthM, std::size_t ring = 0) {
    source.edgeHeadlands.push_back({.part = 0, .ring = ring, .edge = edge, .width = metres(widthM)});
    return source;
}

}  // namespace

class EdgeStripsTest : public QObject {
    Q_OBJECT

private slots:
    // 200 m from west to east, 96 m from south to north.
    void ofARectangle_data() {
        QTest::addColumn<double>("headingDeg");
        QTest::addColumn<bool>("driven");
        QTest::addColumn<double>("marginM");
        QTest::addColumn<double>("mainlandM2");
        // Two passes where it turns, one along the sides so that the outermost goes all round.
        QTest::newRow("along, worked") << 0.0 << true << 0.0 << (200.0 - 24.0) * (96.0 - 12.0);
        QTest::newRow("along, for turning only") << 0.0 << false << 0.0 << (200.0 - 24.0) * 96.0;
        QTest::newRow("along, with a margin") << 0.0 << false << 0.5 << (200.0 - 25.0) * 95.0;
        QTest::newRow("across, worked") << 90.0 << true << 0.0 << (200.0 - 12.0) * (96.0 - 24.0);
        QTest::newRow("across, for turning only") << 90.0 << false << 0.0 << 200.0 * (96.0 - 24.0);
    }
    void ofARectangle() {
        QFETCH(double, headingDeg);
        QFETCH(bool, driven);
        QFETCH(double, marginM);
        QFETCH(double, mainlandM2);
        const Field field =
            Field::create(test::fieldSourceFromLocal({test::centredRectangle(200.0, 96.0)}, kCentre)).value();
        const auto headland =
            headlandOf(kPerEdgeMethod, field, uTurner(), drivenIs(driven), headingDeg, metres(marginM));
        VERIFY_RESULT(headland);
        COMPARE_WITHIN(area(headland->mainland).si(), mainlandM2, 0.5);
        QCOMPARE(headland->passes, 2);
        QCOMPARE(headland->drivenPasses.empty(), !driven);
    }

    // The second pass runs along both ends and nowhere else: twice the height of the field less its outermost
    // passes, shorter by what the machine is longer than its room, and as far as where the outermost pass has
    // worked.
    void innerPassesGoWhereTheyAreNeeded() {
        const Field field =
            Field::create(test::fieldSourceFromLocal({test::centredRectangle(200.0, 96.0)}, kCentre)).value();
        const auto headland = headlandOf(kPerEdgeMethod, field, uTurner(), drivenIs(true), 0.0);
        VERIFY_RESULT(headland);
        double lengthM = 0.0;
        for (const HeadlandPass& pass : headland->drivenPasses) {
            for (const PassStretch& stretch : pass.stretches) {
                if (pass.ring == 1) {
                    lengthM += stretch.line.length().si();
                    COMPARE_WITHIN(std::abs(stretch.line.start.position.x), 100.0 - 9.0, 0.05);
                    COMPARE_WITHIN(std::abs(stretch.line.end().position.x), 100.0 - 9.0, 0.05);
                }
            }
        }
        COMPARE_WITHIN(lengthM, 2.0 * (96.0 - 12.0), 1.0);
    }

    // A common width of 5 m and 12.5 m along the eastern edge: only that side of the mainland is farther in.
    void anEdgeMayHaveAWidthOfItsOwn_data() {
        QTest::addColumn<double>("widthM");
        QTest::addColumn<double>("laidM");
        QTest::newRow("wider") << 12.5 << 12.5;
        QTest::newRow("narrower") << 2.5 << 2.5;
        QTest::newRow("none") << 0.0 << 0.0;
        // Three passes of 2.5 m.
        QTest::newRow("no whole number of passes") << 9.0 << 7.5;
    }
    void anEdgeMayHaveAWidthOfItsOwn() {
        QFETCH(double, widthM);
        QFETCH(double, laidM);
        const double mainlandM2 = (200.0 - 5.0 - laidM) * (96.0 - 10.0);
        // Counter-clockwise from the south-west: the second edge lies in the east.
        const FieldSource source =
            test::fieldSourceFromLocal({test::rectangle(200.0, 96.0, {0.0, 0.0})}, kCentre);
        const Field field = Field::create(withEdge(source, 1, widthM)).value();
        QVERIFY(field.edgeHeadlands().front().from.x > 50.0 && field.edgeHeadlands().front().to.x > 50.0);
        Settings settings;
        settings.set(kHeadlandPasses, 2.0).value();
        const auto headland = test::headlandBy(kConstantWidthMethod, field, agbot(), settings);
        VERIFY_RESULT(headland);
        COMPARE_WITHIN(area(headland->mainland).si(), mainlandM2, 1.0);
        COMPARE_WITHIN(bounds(headland->mainland).max.x, bounds(field.workable()).max.x - laidM, 0.02);
        COMPARE_WITHIN(bounds(headland->mainland).min.x, bounds(field.workable()).min.x + 5.0, 0.02);
        QCOMPARE(headland->strips.size(), std::size_t{4});
    }

    void aHoleMayHaveAWidthOfItsOwn() {
        const FieldSource source = test::fieldSourceFromLocal(
            test::polygonsFromWkt(
                "POLYGON((-50 -50, 50 -50, 50 50, -50 50, -50 -50), (-10 -10, -10 10, 10 10, 10 -10, -10 -10))"),
            kCentre);
        const Field plain = Field::create(source).value();
        const Field wide = Field::create(withEdge(source, 0, 10.0, 1)).value();
        Settings settings;
        settings.set(kHeadlandWidth, 5.0).value();
        settings.set(kHeadlandDriven, false).value();
        const auto before = test::headlandBy(kConstantWidthMethod, plain, agbot(), settings);
        const auto after = test::headlandBy(kConstantWidthMethod, wide, agbot(), settings);
        VERIFY_RESULT(before);
        VERIFY_RESULT(after);
        // 20 m of edge 5 m wider, and at both its ends half of the ring between the circles of 5 and 10 m, of
        // which the strips of 5 m along the neighbouring edges take away what reaches past the corner: worked
        // by hand as quarter disc (25 pi) less quarter disc of 5 m, and the part of the disc of 10 m beyond
        // the neighbour's strip.
        const double grownM2 = area(before->mainland).si() - area(after->mainland).si();
        const double beyondStrip = 100.0 * std::numbers::pi / 6.0 - 0.5 * 5.0 * std::sqrt(75.0);
        const double quarters = 25.0 * std::numbers::pi - 6.25 * std::numbers::pi;
        COMPARE_WITHIN(grownM2, 100.0 + 2.0 * (quarters + beyondStrip), 1.0);
    }

    // Wherever the mainland is, it keeps from every edge what that edge asks for, and nothing that does is
    // left out.
    void stripsKeepTheirDistance() {
        constexpr std::uint64_t kSeed = 4100;
        std::mt19937_64 random{kSeed};
        int seen = 0;
        for (int i = 0; i < 40; ++i) {
            const MultiPolygon drawn = test::randomPolygons(
                random, test::kShapes[static_cast<std::size_t>(i) % test::kShapes.size()], 150.0);
            FieldSource source = test::fieldSourceFromLocal(drawn, kCentre);
            std::uniform_real_distribution<double> width{0.0, 15.0};
            for (std::size_t edge = 0; edge < source.parts.front().outer.size(); edge += 3) {
                source = withEdge(std::move(source), edge, width(random));
            }
            const auto field = Field::create(source);
            if (!field) {
                continue;
            }
            Settings settings;
            settings.set(kHeadlandWidth, 6.0).value();
            settings.set(kHeadlandDriven, false).value();
            const auto headland = test::headlandBy(kConstantWidthMethod, *field, agbot(), settings);
            VERIFY_RESULT(headland);
            if (!headland->notes.empty()) {
                continue;
            }
            const auto keeps = [&](Point place, double slackM) {
                return std::ranges::all_of(headland->strips, [&](const EdgeStrip& strip) {
                    return distanceToSegment(place, strip.from, strip.to) >= strip.width.si() - slackM;
                });
            };
            forEachEdge(headland->mainland, [&](Point from, Point) {
                ++seen;
                QVERIFY2(keeps(from, 0.02),
                         qPrintable(QStringLiteral("seed %1, field %2").arg(kSeed).arg(i)));
                QVERIFY2(!keeps(from, -0.02),
                         qPrintable(QStringLiteral("seed %1, field %2").arg(kSeed).arg(i)));
            });
        }
        QVERIFY(seen > 500);
    }

    void aNarrowFieldHasLess() {
        const FieldSource source =
            test::fieldSourceFromLocal({test::rectangle(200.0, 20.0, {0.0, 0.0})}, kCentre);
        const auto headland =
            headlandOf(kPerEdgeMethod, Field::create(source).value(), uTurner(), drivenIs(true), 90.0);
        VERIFY_RESULT(headland);
        QCOMPARE(headland->passes, 1);
        COMPARE_WITHIN(area(headland->mainland).si(), 188.0 * 8.0, 0.5);
        QVERIFY(!headland->notes.empty());
    }

    void flatterEdgesNeedOtherRoom() {
        const Machine machine = uTurner();
        COMPARE_WITHIN(roomForTurnsAt(degrees(90.0), machine, kDubinsMethod.run, false).si(),
                       std::hypot(4.0, 6.0), 0.01);
        COMPARE_WITHIN(roomForTurnsAt(degrees(60.0), machine, kDubinsMethod.run, false).si(),
                       roomForTurnsAt(degrees(120.0), machine, kDubinsMethod.run, false).si(), 1e-9);
    }

    void whatAnEdgeCannotHaveIsRefused_data() {
        QTest::addColumn<int>("edge");
        QTest::addColumn<double>("widthM");
        QTest::newRow("no such edge") << 4 << 5.0;
        QTest::newRow("negative") << 1 << -1.0;
        QTest::newRow("not a number") << 1 << std::nan("");
    }
    void whatAnEdgeCannotHaveIsRefused() {
        QFETCH(int, edge);
        QFETCH(double, widthM);
        const FieldSource source =
            test::fieldSourceFromLocal({test::rectangle(200.0, 96.0, {0.0, 0.0})}, kCentre);
        const auto field = Field::create(withEdge(source, static_cast<std::size_t>(edge), widthM));
        QVERIFY(!field);
        QCOMPARE(field.error().code, ErrorCode::InputRefused);
        QVERIFY2(field.error().line().contains("the headland of edge"), field.error().line().c_str());
    }
};

FURROW_TEST(EdgeStripsTest);
#include "tst_edge_strips.moc"
