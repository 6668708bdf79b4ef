// No file holds a number that is none, whatever the planner made.

#include "planner/io/content/plan_content.h"
#include "planner/io/delivery/checked_files.h"
#include "planner/io/formats/registry.h"
#include "planner/plan/plan.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/stages.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <limits>
#include <memory>

using namespace furrow;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

const Plan& soundPlan() {
    static const std::shared_ptr<const Plan> plan = [] {
        const FieldSource source =
            test::fieldSourceFromLocal({test::centredRectangle(60.0, 40.0)}, {9.2, 51.3});
        const auto field = std::make_shared<const Field>(Field::create(source).value());
        return makePlan({.field = field, .machine = test::agbot(), .settings = {}}).value();
    }();
    return *plan;
}

}  // namespace

class TestFiniteNumbers : public QObject {
    Q_OBJECT
private slots:
    void areRefusedInEveryFormat_data() {
        QTest::addColumn<int>("change");
        QTest::addColumn<QByteArray>("told");
        QTest::newRow("speed") << 0 << QByteArray{"the speed on swath"};
        QTest::newRow("place") << 1 << QByteArray{"a place on"};
        QTest::newRow("time") << 2 << QByteArray{"the time on"};
        QTest::newRow("swath") << 3 << QByteArray{"a place of swath 1"};
    }
    void areRefusedInEveryFormat() {
        QFETCH(int, change);
        QFETCH(QByteArray, told);
        Plan plan = soundPlan();
        const auto swath = std::ranges::find(plan.path.segments, SegmentKind::Swath, &PathSegment::kind);
        QVERIFY(swath != plan.path.segments.end());
        switch (change) {
            case 0: swath->samples[1].speedMps = kNan; break;
            case 1: swath->samples[1].position.x = kInfinity; break;
            case 2: swath->samples[1].tS = -kInfinity; break;
            default: plan.swaths.swaths.front().start.y = kNan; break;
        }
        // Of what was sound: the contents of files are worked out before.
        const FieldContent content = contentOf(soundPlan());
        for (const Format& format : formats()) {
            if (!format.writes()) {
                continue;
            }
            const auto sound = checkedFiles(
                format, {.fields = {&content, 1}, .plan = &soundPlan(), .options = {}, .job = {}});
            VERIFY_RESULT(sound);
            const auto made =
                checkedFiles(format, {.fields = {&content, 1}, .plan = &plan, .options = {}, .job = {}});
            QVERIFY2(!made && made.error().code == ErrorCode::InputRefused, format.id.data());
            const QByteArray what = QByteArray::fromStdString(made.error().what.text());
            QVERIFY2(what.startsWith(told) && what.contains("is no number"), what);
        }
    }
};

FURROW_TEST(TestFiniteNumbers);
#include "tst_finite_numbers.moc"
