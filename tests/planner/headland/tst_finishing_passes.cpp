// Short passes over what others leave: what they work is laid over the pieces in GEOS, where the machine is
// then too.

#include "planner/geometry/curve_sampling.h"
#include "planner/geometry/geos_bridge.h"
#include "planner/geometry/prepared_area.h"
#include "planner/headland/finishing_passes.h"
#include "planner/machine/machine_library.h"
#include "tests/planner/turns/turn_check.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"
#include "tests/support/wkt.h"

#include <QTest>

#include <cmath>
#include <random>
#include <stop_token>

using namespace furrow;

namespace {

const Machine& agbot() {
    static const Machine machine = findMachine("agbot").value();
    return machine;
}

Polygon squareAt(Point low, double side) {
    return {.outer = {low, low + Point{side, 0.0}, low + Point{side, side}, low + Point{0.0, side}},
            .holes = {}};
}

/// Needs a metre straight before it is lowered.
const Machine& cultivator() {
    static const Machine machine = findMachine("cultivator").value();
    return machine;
}

Polygon worked(const HeadlandPass& pass, const Machine& machine = agbot()) {
    const Curve& line = pass.stretches.front().line;
    const Point along = direction(line.start.heading.si());
    const Point back = machine.spec().implement.offset.si() * along;
    const Point from = line.start.position + back;
    const Point to = line.end().position + back;
    const Point side = 0.5 * pass.width.si() * Point{-along.y, along.x};
    return {.outer = {from - side, to - side, to + side, from + side}, .holes = {}};
}

Result<std::vector<HeadlandPass>> passesOver(const MultiPolygon& left, const MultiPolygon& field,
                                             Area mayStay, const JobContext& job = {},
                                             const Machine& machine = agbot(), bool untilTheLeast = false) {
    const Rig lowered{field, machine, ImplementAt::Lowered};
    return finishingPasses({.workable = field,
                            .left = left,
                            .mayStay = mayStay,
                            .mayStayInOnePiece = squareMetres(95.0),
                            .lowered = lowered,
                            .untilTheLeast = untilTheLeast},
                           job);
}

}  // namespace

class FinishingPassesTest : public QObject {
    Q_OBJECT

private slots:
    void nothingToDo() {
        const MultiPolygon field{test::rectangle(60.0, 40.0)};
        QVERIFY(passesOver({}, field, {}).value().empty());
        QVERIFY(passesOver({squareAt({20.0, 20.0}, 2.0)}, field, squareMetres(4.0)).value().empty());
        // Less than is worth lowering the implement for: 0.005 of 2.5 m squared where nothing may stay.
        QVERIFY(passesOver({squareAt({20.0, 20.0}, 0.17)}, field, {}).value().empty());
    }

    /// 15 pieces of 0.1225 m2, far apart. They are worth a pass each if a tenth of what may stay is less.
    void aPassIsWorthATenthOfWhatMayStay() {
        const MultiPolygon field{test::rectangle(60.0, 40.0)};
        MultiPolygon strewn;
        for (int i = 0; i < 15; ++i) {
            const int row = i / 5;
            strewn.push_back(squareAt({5.0 + 11.0 * (i % 5) + 3.0 * row, 5.0 + 13.0 * row}, 0.35));
        }
        QVERIFY(passesOver(strewn, field, squareMetres(1.3)).value().empty());
        QVERIFY(!passesOver(strewn, field, squareMetres(1.1)).value().empty());
        // Where the rest blocks the plan, they are worth it.
        const auto passes = passesOver(strewn, field, squareMetres(1.3), {}, agbot(), true);
        VERIFY_RESULT(passes);
        MultiPolygon swept;
        std::ranges::transform(*passes, std::back_inserter(swept),
                               [](const auto& pass) { return worked(pass); });
        QCOMPARE_LE(area(difference(strewn, unionOf(swept, {}).value(), {}).value()).si(), 1.3);
    }

    /// 150 pieces of 2.4 m, far apart, each worth a pass.
    void noMoreThanABound() {
        constexpr int kPieces = 150;
        constexpr std::size_t kMost = 128;
        const MultiPolygon field{test::rectangle(310.0, 210.0)};
        MultiPolygon strewn;
        for (int i = 0; i < kPieces; ++i) {
            const int row = i / 15;
            strewn.push_back(squareAt({10.0 + 20.0 * (i % 15), 10.0 + 20.0 * row}, 2.4));
        }
        const Rig lowered{field, agbot(), ImplementAt::Lowered};
        const auto passes = finishingPasses({.workable = field,
                                             .left = strewn,
                                             .mayStay = {},
                                             .mayStayInOnePiece = squareMetres(95.0),
                                             .lowered = lowered,
                                             .most = kMost},
                                            {});
        VERIFY_RESULT(passes);
        QCOMPARE(passes->size(), kMost);
        QVERIFY(passesOver(strewn, field, {}).value().size() >= std::size_t{kPieces});
    }

    /// 2.4 m square in the open: one pass of 2.5 m works it all.
    void inTheOpen() {
        const MultiPolygon field{test::rectangle(60.0, 40.0)};
        const Polygon piece = squareAt({20.0, 20.0}, 2.4);
        const auto passes = passesOver({piece}, field, squareMetres(0.4));
        VERIFY_RESULT(passes);
        QCOMPARE(passes->size(), std::size_t{1});
        QCOMPARE_LT(area(difference({piece}, {worked(passes->front())}, {}).value()).si(), 0.4);
        // 20 to 22.4 m from the edges is the eighth or ninth ring.
        QVERIFY(passes->front().ring == 7 || passes->front().ring == 8);
    }

    /// Along the last 6 m before a corner: out of reach is what lies under tail and nose, 0.6 m at least.
    void intoACorner() {
        const MultiPolygon field{test::rectangle(60.0, 40.0)};
        const Polygon piece{.outer = {{54.0, 0.0}, {60.0, 0.0}, {60.0, 2.0}, {54.0, 2.0}}, .holes = {}};
        const auto passes = passesOver({piece}, field, squareMetres(1.4));
        VERIFY_RESULT(passes);
        QCOMPARE(passes->size(), std::size_t{1});
        QCOMPARE_LT(area(difference({piece}, {worked(passes->front())}, {}).value()).si(), 1.4);
    }

    void randomPiecesInRandomFields_data() {
        QTest::addColumn<Machine>("machine");
        QTest::newRow("robot") << agbot();
        // What it passes over in its run-in was counted as worked, and the same pass proposed over and over.
        QTest::newRow("with a run-in") << cultivator();
    }
    void randomPiecesInRandomFields() {
        QFETCH(Machine, machine);
        const double widthM = machine.operatingWidth().si();
        constexpr std::uint64_t kSeed = 814;
        std::mt19937_64 random{kSeed};
        std::uniform_real_distribution<double> any{0.0, 1.0};
        int all = 0;
        for (int i = 0; i < 40; ++i) {
            const MultiPolygon field = test::randomPolygons(
                random, test::kShapes[static_cast<std::size_t>(i) % std::size(test::kShapes)], 60.0);
            const Bounds box = bounds(field);
            MultiPolygon strewn;
            for (int k = 0; k < 6; ++k) {
                const Point at = box.min + Point{any(random) * box.width(), any(random) * box.height()};
                const auto part = intersection({squareAt(at, (0.4 + 1.6 * any(random)) * widthM)}, field, {});
                VERIFY_RESULT(part);
                const auto apart = difference(*part, strewn, {});
                VERIFY_RESULT(apart);
                strewn.insert(strewn.end(), apart->begin(), apart->end());
            }
            const auto passes = passesOver(strewn, field, {}, {}, machine);
            VERIFY_RESULT(passes);
            const QByteArray said = QStringLiteral("seed %1, field %2").arg(kSeed).arg(i).toUtf8();
            const PreparedArea inside{dilated(field, metres(0.01), metres(0.001), {}).value()};
            MultiPolygon open = strewn;
            for (const HeadlandPass& pass : *passes) {
                ++all;
                const Curve& line = pass.stretches.front().line;
                std::vector<Polyline> outlines;
                for (const Pose& pose : {line.start, line.end()}) {
                    outlines.push_back(placed(machine.workingFootprint(), pose));
                    outlines.back().push_back(outlines.back().front());
                }
                const auto out = inside.farthestOutside(outlines);
                VERIFY_TOLD(!out, said + " " + QByteArray::number(out ? out->distance.si() : 0.0));
                const auto rest = difference(open, {worked(pass, machine)}, {});
                VERIFY_RESULT(rest);
                // 0.005 of the width squared, but for slivers that GEOS drops.
                VERIFY_TOLD((area(open) - area(*rest)).si() > 0.0045 * widthM * widthM, said);
                open = *rest;
            }
        }
        QVERIFY(all > 40);
    }

    void cancels() {
        std::stop_source stop;
        stop.request_stop();
        const MultiPolygon field{test::rectangle(60.0, 40.0)};
        const auto passes = passesOver({squareAt({20.0, 20.0}, 2.4)}, field, {}, {.stop = stop.get_token()});
        QVERIFY(!passes);
        QCOMPARE(passes.error().code, ErrorCode::Cancelled);
    }
};

FURROW_TEST(FinishingPassesTest);
#include "tst_finishing_passes.moc"
