// What inner passes work: rectangles drawn flat along their stretches, laid over the band between two offsets
// in GEOS.

#include "planner/field/drivable_area.h"
#include "planner/geometry/geos_bridge.h"
#include "planner/geometry/prepared_area.h"
#include "planner/headland/inner_passes.h"
#include "planner/machine/machine_library.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"
#include "tests/support/wkt.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stop_token>

using namespace furrow;

namespace {

constexpr double kPi = std::numbers::pi;

const Machine& agbot() {
    static const Machine machine = findMachine("agbot").value();
    return machine;
}

Field fieldFrom(const MultiPolygon& polygons) {
    return Field::create(test::fieldSourceFromLocal(polygons, {9.2, 51.3})).value();
}

/// What a task refers to.
struct Ground {
    Ground(const MultiPolygon& polygons, const Machine& driven)
        : field{fieldFrom(polygons)}, drivable{drivableArea(field, {}, {}).value()}, machine{driven} {}

    Field field;
    AllowedAreas drivable;
    Machine machine;
    Settings settings;
    PassTask task() const {
        return {.workable = field.workable(), .drivable = drivable, .machine = machine, .settings = settings};
    }
};

/// Of one straight stretch: from where the implement is at its start to where it is at its end.
Polygon worked(const Curve& line, const Machine& machine) {
    const Point along = direction(line.start.heading.si());
    const Point left{-along.y, along.x};
    const Point back = machine.spec().implement.offset.si() * along;
    const Point from = line.start.position + back;
    const Point to = line.end().position + back;
    const Point side = 0.5 * machine.operatingWidth().si() * left;
    return {.outer = {from - side, to - side, to + side, from + side}, .holes = {}};
}

Ring grown(const Bounds& box, double by) {
    return {{box.min.x - by, box.min.y - by},
            {box.max.x + by, box.min.y - by},
            {box.max.x + by, box.max.y + by},
            {box.min.x - by, box.max.y + by}};
}

/// Whether the lowered machine is inside at the ends of a line, to a centimetre.
bool endsInside(const Curve& line, const Ground& ground) {
    const PreparedArea area{dilated(ground.drivable.tractor(), metres(0.01), metres(0.001), {}).value()};
    for (const Pose& pose : {line.start, line.end()}) {
        const Point nose = direction(pose.heading.si());
        Polyline outline;
        for (const Point& corner : ground.machine.workingFootprint()) {
            outline.push_back(pose.position + corner.x * nose + corner.y * Point{-nose.y, nose.x});
        }
        outline.push_back(outline.front());
        if (!area.covers({outline})) {
            return false;
        }
    }
    return true;
}

}  // namespace

class InnerPassesTest : public QObject {
    Q_OBJECT

private slots:
    void stretchesCoverTheirBand_data() {
        QTest::addColumn<QString>("machine");
        QTest::addColumn<int>("ring");
        for (const char* machine : {"agbot", "mounted-drill"}) {
            for (const int ring : {1, 2, 3}) {
                QTest::addRow("%s, ring %d", machine, ring) << machine << ring;
            }
        }
    }
    void stretchesCoverTheirBand() {
        QFETCH(QString, machine);
        QFETCH(int, ring);
        const Ground ground{{test::centredRectangle(160.0, 110.0)},
                            findMachine(machine.toStdString()).value()};
        const double widthM = ground.machine.operatingWidth().si();
        const double insetM = 0.5 * ground.machine.workingFootprintWidth().si() + ring * widthM;
        const auto passes = innerPasses(ground.task(), metres(insetM), ring, {});
        VERIFY_RESULT(passes);
        QCOMPARE(passes->size(), std::size_t{1});
        const HeadlandPass& pass = passes->front();
        QCOMPARE(pass.ring, ring);
        QVERIFY(!pass.closed && pass.width == ground.machine.operatingWidth());
        QCOMPARE(pass.stretches.size(), std::size_t{4});
        MultiPolygon rectangles;
        for (std::size_t i = 0; i < 4; ++i) {
            const Curve& line = pass.stretches[i].line;
            const Curve& next = pass.stretches[(i + 1) % 4].line;
            QVERIFY(pass.stretches[i].working);
            COMPARE_WITHIN(std::remainder(next.start.heading.si() - line.end().heading.si(), 2.0 * kPi),
                           0.5 * kPi, 1e-6);
            for (const CurvePiece& piece : line.pieces) {
                QVERIFY(piece.gear == Gear::Forward && piece.curvature == Curvature{} &&
                        piece.endCurvature == Curvature{});
            }
            QVERIFY(endsInside(line, ground));
            rectangles.push_back(worked(line, ground.machine));
        }
        // The band half a width to either side of the inset.
        const Bounds box = bounds(ground.field.workable());
        const MultiPolygon outer{{.outer = grown(box, -(insetM - 0.5 * widthM)), .holes = {}}};
        const MultiPolygon inner{{.outer = grown(box, -(insetM + 0.5 * widthM)), .holes = {}}};
        const MultiPolygon band = difference(outer, inner, {}).value();
        COMPARE_WITHIN(area(band).si(), 2.0 * widthM * (box.width() + box.height() - 4.0 * insetM), 0.05);
        const MultiPolygon all = unionOf(rectangles, {}, kSnapGrid).value();
        const double missedM2 = area(difference(band, all, {}, kSnapGrid).value()).si();
        QVERIFY2(missedM2 < 0.005 * area(band).si(), qPrintable(QString::number(missedM2 / area(band).si())));
    }

    // A field of 60 m by 60 m with an arm to the east. Inside the outermost pass, 2.5 m wide, the arm is
    // narrower than another pass, or it is not.
    void anArmOneWidthWide_data() {
        QTest::addColumn<double>("armM");
        QTest::addColumn<int>("passes");
        QTest::newRow("2 m are left of it") << 7.0 << 1;
        QTest::newRow("1 m is left of it") << 6.0 << 1;
        QTest::newRow("nothing is left") << 5.0 << 0;
        QTest::newRow("room for a ring") << 8.5 << 0;
    }
    void anArmOneWidthWide() {
        QFETCH(double, armM);
        QFETCH(int, passes);
        const double top = 20.0 + armM;
        const MultiPolygon land{
            {.outer = {{0, 0}, {60, 0}, {60, 20}, {120, 20}, {120, top}, {60, top}, {60, 60}, {0, 60}},
             .holes = {}}};
        const Ground ground{land, agbot()};
        const auto strips = passesAlongStrips(ground.task(), agbot().operatingWidth(), 1, {});
        VERIFY_RESULT(strips);
        QCOMPARE(static_cast<int>(strips->size()), passes);
        if (passes == 0) {
            return;
        }
        const HeadlandPass& pass = strips->front();
        QVERIFY(!pass.closed && pass.ring == 1);
        QCOMPARE(pass.stretches.size(), std::size_t{1});
        const Curve& line = pass.stretches.front().line;
        // The field's frame is centred on its own bounds.
        const Bounds box = bounds(ground.field.workable());
        const double middleY = box.min.y + 20.0 + 0.5 * armM;
        COMPARE_WITHIN(line.start.position.y, middleY, 0.05);
        COMPARE_WITHIN(line.end().position.y, middleY, 0.05);
        QVERIFY(endsInside(line, ground));
        // The implement works all that the outermost pass leaves of the arm: from its mouth to 2.5 m before
        // its end.
        const double leftM = box.min.x + 60.0;
        const double rightM = box.min.x + 120.0 - 2.5;
        const MultiPolygon left{{.outer = {{leftM, middleY - 0.5 * armM + 2.5},
                                           {rightM, middleY - 0.5 * armM + 2.5},
                                           {rightM, middleY + 0.5 * armM - 2.5},
                                           {leftM, middleY + 0.5 * armM - 2.5}},
                                 .holes = {}}};
        const MultiPolygon missed = difference(left, {worked(line, agbot())}, {}, kSnapGrid).value();
        QVERIFY2(area(missed).si() < 0.05 * area(left).si(),
                 qPrintable(QString::number(area(missed) / area(left))));
    }

    void aStoppedJobIsCancelled() {
        std::stop_source stop;
        stop.request_stop();
        const Ground ground{{test::centredRectangle(100.0, 60.0)}, agbot()};
        const auto passes = innerPasses(ground.task(), metres(3.75), 1, {.stop = stop.get_token()});
        QVERIFY(!passes);
        QCOMPARE(passes.error().code, ErrorCode::Cancelled);
        const auto strips = passesAlongStrips(ground.task(), metres(2.5), 1, {.stop = stop.get_token()});
        QVERIFY(!strips);
        QCOMPARE(strips.error().code, ErrorCode::Cancelled);
    }

    void nothingOfAFieldThatIsTooSmall() {
        const Ground ground{{test::centredRectangle(30.0, 10.0)}, agbot()};
        const auto passes = innerPasses(ground.task(), metres(6.25), 2, {});
        VERIFY_RESULT(passes);
        QVERIFY(passes->empty());
    }
};

FURROW_TEST(InnerPassesTest);
#include "tst_inner_passes.moc"
