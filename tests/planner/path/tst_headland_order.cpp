// Where headland passes start. The places follow from the ways there, worked out by hand.

#include "planner/path/headland_order.h"
#include "planner/turns/best_feasible.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/stages.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

using namespace furrow;

namespace {

constexpr double kWest = std::numbers::pi;

PassStretch straight(Point from, Point to) {
    const Point way = to - from;
    return {.line = {.type = {},
                     .start = {.position = from, .heading = radians(std::atan2(way.y, way.x))},
                     .pieces = {{.length = metres(norm(way)), .curvature = {}}}}};
}

HeadlandPass openPass(std::vector<PassStretch> stretches) {
    return {.ring = 0, .width = metres(3.0), .closed = false, .stretches = std::move(stretches)};
}

Machine cultivator() {
    return findMachine("cultivator").value();
}

Pose pose(double xM, double yM, double heading) {
    return {.position = {xM, yM}, .heading = radians(heading)};
}

std::vector<Leg> legsOf(const HeadlandPass& pass, const HeadlandDrive& drive) {
    return headlandLegs({pass}, drive, cultivator(), kBestFeasibleMethod.run);
}

}  // namespace

class TestHeadlandOrder : public QObject {
    Q_OBJECT

private slots:
    // From the eastern end of the pass a curve turns round to (70, 20), going west, but reaches beyond the
    // field; from the western end it leads twice round, 80 m farther.
    void severalMovesNearByMayBeQuicker_data() {
        QTest::addColumn<double>("takesS");  // 0: there are none
        QTest::addColumn<double>("startsAtM");
        QTest::newRow("quicker") << 50.0 << 0.0;
        QTest::newRow("slower") << 150.0 << 100.0;
        QTest::newRow("none") << 0.0 << 100.0;
    }
    void severalMovesNearByMayBeQuicker() {
        QFETCH(const double, takesS);
        QFETCH(const double, startsAtM);
        const HeadlandPass pass = openPass({straight({0, 0}, {100, 0})});
        const AllowedAreas field{MultiPolygon{test::rectangle(204, 160, {-100, -60})}};
        HeadlandDrive drive{.before = {}, .after = pose(70, 20, kWest), .drivable = field};
        QCOMPARE(legsOf(pass, drive).front().line.start.position.x, 100.0);
        int searches = 0;
        drive.searched = [&](const Pose& leaving, const Pose& arriving) -> std::optional<Duration> {
            ++searches;
            const bool isFromTheEast = leaving.position.x == 100.0 && arriving.position.x == 70.0;
            return isFromTheEast && takesS > 0.0 ? std::optional{seconds(takesS)} : std::nullopt;
        };
        QCOMPARE(legsOf(pass, drive).front().line.start.position.x, startsAtM);
        QCOMPARE(searches, 1);
    }
};

FURROW_TEST(TestHeadlandOrder);

#include "tst_headland_order.moc"
