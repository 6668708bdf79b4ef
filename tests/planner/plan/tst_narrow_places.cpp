// Where a field is too narrow for its machine, findings say so.

#include "planner/machine/machine_library.h"
#include "planner/plan/advice.h"
#include "planner/plan/narrow_places.h"
#include "planner/project/field_tasks.h"
#include "tests/support/field_generator.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>

using namespace furrow;

class TestNarrowPlaces : public QObject {
    Q_OBJECT

    /// 200 m by 120 m, with an arm of this width that goes 100 m to the east.
    static FieldSource withArm(double widthM) {
        const Ring outline{{0.0, 0.0},
                           {200.0, 0.0},
                           {200.0, 60.0},
                           {300.0, 60.0},
                           {300.0, 60.0 + widthM},
                           {200.0, 60.0 + widthM},
                           {200.0, 120.0},
                           {0.0, 120.0}};
        return test::fieldSourceFromLocal({Polygon{.outer = outline, .holes = {}}},
                                          {.lonDeg = 9.0, .latDeg = 52.0});
    }
    static Machine cultivator() { return *std::ranges::find(machineLibrary(), "cultivator", &Machine::id); }
    static std::shared_ptr<const Plan> planOf(const FieldSource& source) {
        return planOfSource(source, cultivator(), {}, {}).value();
    }
    static Point at(const Plan& plan, double x, double y) {
        // The frame's middle is that of the field; its corner is known.
        Point low = plan.field().drivable().front().outer.front();
        for (const Point& point : plan.field().drivable().front().outer) {
            low = {std::min(low.x, point.x), std::min(low.y, point.y)};
        }
        return low + Point{x, y};
    }

private slots:
    void saysHowNarrowAPlaceIs_data() {
        QTest::addColumn<double>("armM");
        QTest::addColumn<QPointF>("place");
        QTest::addColumn<QString>("begins");
        QTest::newRow("middle") << 5.0 << QPointF{100.0, 60.0} << "";
        QTest::newRow("at an edge") << 5.0 << QPointF{100.0, 0.5} << "";
        QTest::newRow("in a corner") << 5.0 << QPointF{0.5, 0.5} << "";
        QTest::newRow("beside the field") << 5.0 << QPointF{100.0, -4.0} << "";
        QTest::newRow("arm narrower than the machine")
            << 5.0 << QPointF{260.0, 62.0}
            << "The field is narrower here than this machine, which takes 6.0 m";
        QTest::newRow("beside that arm")
            << 5.0 << QPointF{260.0, 58.0} << "The field is narrower here than this machine";
        QTest::newRow("arm narrower than a turn")
            << 12.0 << QPointF{260.0, 66.0} << "The field is narrower here than the 15.0 m in which";
        QTest::newRow("arm wider than a turn") << 18.0 << QPointF{260.0, 66.0} << "";
    }
    void saysHowNarrowAPlaceIs() {
        QFETCH(double, armM);
        QFETCH(QPointF, place);
        QFETCH(QString, begins);
        const auto plan = planOf(withArm(armM));
        const auto places = NarrowPlaces::of(*plan, {});
        QVERIFY(places);
        const Message said = places->reasonAt(at(*plan, place.x(), place.y()));
        QCOMPARE(said.empty(), begins.isEmpty());
        QVERIFY2(said.starts_with(begins.toStdString()), said.c_str());
    }

    /// Nobody is left with "leaves the field" alone where the reason is to be seen.
    void findingsOfANarrowArmSayWhy() {
        Plan blocked = *planOf(withArm(5.0));
        // No setting is given, and no further headland pass would fit: nothing is left to be tried.
        blocked.headland.narrowed = true;
        const auto leaves = [&blocked](double x, double y) {
            return Finding{.severity = Severity::Blocking,
                           .kind = FindingKind::Outside,
                           .place = at(blocked, x, y),
                           .text = "Headland pass 1 leaves the field by 0.48 m.",
                           .suggestion = {}};
        };
        blocked.findings = {leaves(260.0, 62.0), leaves(100.0, 60.0)};
        const auto advised = withAdvice(std::make_shared<const Plan>(blocked)).value();
        QVERIFY(advised->findings[0].suggestion.starts_with("The field is narrower here"));
        QVERIFY(advised->findings[1].suggestion.empty());
    }
};

FURROW_TEST(TestNarrowPlaces);
#include "tst_narrow_places.moc"
