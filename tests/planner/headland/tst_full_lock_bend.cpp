// The bend that is driven once, against every bend driven by itself where it lies.

#include "planner/headland/full_lock_bend.h"
#include "planner/machine/machine_library.h"
#include "planner/units/angle.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <array>
#include <cmath>
#include <format>
#include <numbers>
#include <random>

using namespace furrow;

namespace {

constexpr double kRounds = 1.25;
constexpr Length kLook = metres(0.25);

bool isSame(const RigState& a, const RigState& b) {
    return distance(a.tractor.position, b.tractor.position) < 1e-6 &&
           std::abs(wrappedAngle(a.tractor.heading - b.tractor.heading).si()) < 1e-7 &&
           std::abs(wrappedAngle(a.implement - b.implement).si()) < 1e-7;
}

}  // namespace

class FullLockBendTest : public QObject {
    Q_OBJECT

private slots:
    void asDrivenByItself_data() {
        QTest::addColumn<QString>("machine");
        QTest::addColumn<double>("side");
        for (const char* machine : {"cultivator", "combine", "trailed-sprayer", "slurry-tanker"}) {
            QTest::addRow("%s, to the left", machine) << machine << 1.0;
            QTest::addRow("%s, to the right", machine) << machine << -1.0;
        }
    }
    void asDrivenByItself() {
        QFETCH(QString, machine);
        QFETCH(double, side);
        const Machine driven = findMachine(machine.toStdString()).value();
        const Rig rig{
            MultiPolygon{{.outer = {{-500, -500}, {500, -500}, {500, 500}, {-500, 500}}, .holes = {}}},
            driven, ImplementAt::Lowered};
        const auto trailer = Trailer::of(driven);
        const Length look = trailer ? std::min(kLook, trailer->longestStep()) : kLook;
        const FullLockBend bend{rig, side, kRounds, look};
        const double radiusM = driven.minTurningRadius().si();
        std::mt19937 random{20};
        std::uniform_real_distribution<double> anywhere{-1.0, 1.0};
        const double reachM = radiusM + driven.operatingWidth().si();
        int passedOver = 0;
        for (int round = 0; round < 5; ++round) {
            const Point middle{100.0 * anywhere(random), 100.0 * anywhere(random)};
            const Angle begin = radians(std::numbers::pi * anywhere(random));
            const RigState from = Rig::inLine({.position = middle + radiusM * direction(begin.si()),
                                               .heading = begin + radians(side * 0.5 * std::numbers::pi)});
            std::vector<RigState> states{from};
            const CurvePiece arc{.length = metres(kRounds * 2.0 * std::numbers::pi * radiusM),
                                 .curvature = Curvature::fromSi(side / radiusM)};
            static_cast<void>(rig.follow(from, arc, look, [&](const RigState& state) {
                states.push_back(state);
                return true;
            }));
            QCOMPARE(bend.stateCount(), states.size());
            for (std::size_t i = 0; i < states.size(); ++i) {
                QVERIFY2(isSame(bend.stateAt(i, middle, begin), states[i]),
                         std::format("state {}", i).c_str());
            }
            for (int i = 0; i < 400; ++i) {
                const Point away{reachM * anywhere(random), reachM * anywhere(random)};
                std::optional<std::size_t> first;
                for (std::size_t k = 1; k < states.size() && !first; ++k) {
                    const WorkingLine last = workingLine(states[k - 1], driven, trailer);
                    const WorkingLine now = workingLine(states[k], driven, trailer);
                    if (isInside(std::array{last.first, now.first, now.second, last.second}, middle + away)) {
                        first = k;
                    }
                }
                const Point ahead = direction(begin.si());
                QCOMPARE(bend.firstOver({dot(ahead, away), cross(ahead, away)}), first);
                passedOver += first ? 1 : 0;
            }
        }
        QVERIFY(passedOver > 200);
    }
};

FURROW_TEST(FullLockBendTest);
#include "tst_full_lock_bend.moc"
