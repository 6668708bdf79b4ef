// What blocks a plan says what of the settings or the field it comes from.

#include "planner/machine/machine_library.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/plan.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>

using namespace furrow;

namespace {

Result<std::shared_ptr<const Plan>> planned(Point size, const QString& machine, const QStringList& given) {
    Settings settings;
    for (const QString& setting : given) {
        const QStringList parts = setting.split(u'=');
        applySetting(settings, parts[0].toStdString(), parts[1].toStdString()).value();
    }
    const FieldSource source =
        test::fieldSourceFromLocal({test::centredRectangle(size.x, size.y)}, {9.5, 51.5});
    return makePlan({.field = std::make_shared<const Field>(Field::create(source).value()),
                     .machine = findMachine(machine.toStdString()).value(),
                     .settings = settings});
}

}  // namespace

class ReasonsTest : public QObject {
    Q_OBJECT

private slots:
    void ofWhatBlocks_data() {
        QTest::addColumn<double>("widthM");
        QTest::addColumn<QString>("machine");
        QTest::addColumn<QStringList>("given");
        QTest::addColumn<QString>("kind");
        QTest::addColumn<QStringList>("said");
        // A plough of 2.5 m with a turning radius of 6 m.
        QTest::newRow("no headland") << 250.0 << "plough" << QStringList{"headland.method=none"} << "outside"
                                     << QStringList{"headland.method"};
        QTest::newRow("a headland of no width") << 250.0 << "plough" << QStringList{"headland.width_m=0"}
                                                << "outside" << QStringList{"headland.width_m"};
        QTest::newRow("a narrow headland") << 250.0 << "plough" << QStringList{"headland.passes=1"}
                                           << "outside" << QStringList{"headland.passes", "2.5 m"};
        QTest::newRow("a narrow field")
            << 12.0 << "plough" << QStringList{} << "outside" << QStringList{"smaller machine"};
        QTest::newRow("swaths across a narrow field")
            << 12.0 << "plough" << QStringList{"swaths.method=fixed", "swaths.angle_deg=90"} << "outside"
            << QStringList{"smaller machine", "swaths."};
        QTest::newRow("a narrow field with a margin") << 12.0 << "plough" << QStringList{"field.margin_m=1"}
                                                      << "outside" << QStringList{"field.margin_m"};
    }
    void ofWhatBlocks() {
        QFETCH(double, widthM);
        QFETCH(QString, machine);
        QFETCH(QStringList, given);
        QFETCH(QString, kind);
        QFETCH(QStringList, said);
        const auto plan = planned({200.0, widthM}, machine, given);
        VERIFY_RESULT(plan);
        const auto found = std::ranges::find_if((*plan)->findings, [&](const Finding& finding) {
            return finding.severity == Severity::Blocking && kindId(finding) == kind.toStdString();
        });
        QVERIFY(found != (*plan)->findings.end());
        for (const QString& each : said) {
            QVERIFY2(found->suggestion.text().contains(each.toStdString()), found->suggestion.text().c_str());
        }
    }

    // A field that is wide enough but for its margin is refused for that.
    void nothingFitsBesideTheMargin() {
        const auto plan = planned({200.0, 5.0}, "plough", {"field.margin_m=2"});
        QVERIFY(!plan);
        QVERIFY2(plan.error().remedy.text().contains("field.margin_m"), plan.error().line().c_str());
    }
};

FURROW_TEST(ReasonsTest);
#include "tst_reasons.moc"
