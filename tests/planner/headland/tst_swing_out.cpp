// Corners that are driven too far and back: where they lead, and how far the implement gets, followed in
// small steps of its hitch's own (the tractrix by Euler's method), apart from the code under test.

#include "planner/headland/smooth_ring.h"
#include "planner/headland/swing_out.h"
#include "planner/machine/machine_library.h"
#include "tests/planner/turns/turn_check.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace furrow;

namespace {

constexpr double kPi = std::numbers::pi;

const Machine& sprayer() {
    static const Machine machine = findMachine("trailed-sprayer").value();
    return machine;
}

/// Round a rectangle, a boom's half and a little away from its edges.
Curve round(double width, double height, bool clockwise = false) {
    const double in = 12.02;
    const Ring ring{{in, in}, {width - in, in}, {width - in, height - in}, {in, height - in}};
    const Curve line = smoothRing(ring, metres(7.0), metres(0.1)).value();
    return clockwise ? reversedLine(line) : line;
}

/// Where the boom's tips get to over two rounds, the second one told.
std::vector<Point> tips(const Curve& line) {
    const Implement& implement = sprayer().spec().implement;
    const double trailing = (implement.hitchOffset - implement.offset).si();
    double heading = line.start.heading.si();
    std::vector<Point> found;
    for (int round = 0; round < 2; ++round) {
        Pose pose = line.start;
        for (const CurvePiece& piece : line.pieces) {
            const int steps = static_cast<int>(std::ceil(piece.length.si() / 0.005));
            for (int i = 0; i < steps; ++i) {
                const Pose at = advanced(pose, piece, piece.length * (static_cast<double>(i) / steps));
                heading +=
                    (piece.length.si() / steps) / trailing *
                    (std::sin(at.heading.si() - heading) +
                     implement.hitchOffset.si() * piece.curvature.si() * std::cos(at.heading.si() - heading));
                if (round == 1) {
                    const Point hitch = at.position + implement.hitchOffset.si() * direction(at.heading.si());
                    const Point middle = hitch - trailing * direction(heading);
                    const Point side = 12.0 * Point{-std::sin(heading), std::cos(heading)};
                    found.push_back(middle + side);
                    found.push_back(middle - side);
                }
            }
            pose = advanced(pose, piece, piece.length);
        }
    }
    return found;
}

double nearest(const std::vector<Point>& points, Point corner) {
    double least = 1e9;
    for (const Point& point : points) {
        least = std::min(least, distance(point, corner));
    }
    return least;
}

}  // namespace

class SwingOutTest : public QObject {
    Q_OBJECT

private slots:
    void roundARectangle_data() {
        QTest::addColumn<bool>("clockwise");
        QTest::newRow("to the left") << false;
        QTest::newRow("to the right") << true;
    }
    void roundARectangle() {
        QFETCH(bool, clockwise);
        const MultiPolygon field{test::rectangle(300.0, 200.0)};
        const Curve line = round(300.0, 200.0, clockwise);
        const Curve swung = swungOut(line, Rig{field, sprayer(), ImplementAt::Lowered});
        // Closed, as tight as it may be, and all corners are another shape now: 4 straights, one cut in two,
        // 8 arcs.
        COMPARE_WITHIN(distance(swung.end().position, swung.start.position), 0.0, 1e-9);
        QVERIFY(std::ranges::all_of(swung.pieces, [](const CurvePiece& piece) {
            return std::abs(piece.curvature.si()) < 1.0 / 7.0 + 1e-12 && piece.length > metres(0.0);
        }));
        QCOMPARE(swung.pieces.size(), std::size_t{13});
        double turned = 0.0;
        for (const CurvePiece& piece : swung.pieces) {
            turned += piece.length.si() * piece.curvature.si();
        }
        COMPARE_WITHIN(std::abs(turned), 2.0 * kPi, 1e-9);
        const std::vector<Point> before = tips(line);
        const std::vector<Point> after = tips(swung);
        for (const Point& tip : after) {
            QVERIFY(tip.x > -0.01 && tip.x < 300.01 && tip.y > -0.01 && tip.y < 200.01);
        }
        for (const Point corner : {Point{0.0, 0.0}, {300.0, 0.0}, {300.0, 200.0}, {0.0, 200.0}}) {
            QCOMPARE_LT(nearest(after, corner), nearest(before, corner) - 0.5);
        }
    }

    /// No room to come back to the line: as it was, but begun in the middle of a straight.
    void noRoom() {
        const MultiPolygon field{test::rectangle(40.0, 40.0)};
        const Curve line = round(40.0, 40.0);
        const Curve swung = swungOut(line, Rig{field, sprayer(), ImplementAt::Lowered});
        QCOMPARE(swung.pieces.size(), line.pieces.size() + 1);
        COMPARE_WITHIN(swung.length().si(), line.length().si(), 1e-9);
    }
};

FURROW_TEST(SwingOutTest);
#include "tst_swing_out.moc"
