// Rows of findings: many of a kind share one.

#include "tests/support/test_program.h"
#include "ui/results/findings_model.h"

#include <QAbstractItemModelTester>
#include <QTest>

using namespace furrow;

namespace {

Finding finding(FindingKind kind, Severity severity, int number) {
    return {.severity = severity,
            .kind = kind,
            .place = {},
            .text = std::to_string(number),
            .suggestion = {},
            .change = {},
            .setting = {}};
}

/// One that is outside, then `missed` pieces that are missed, then two gates.
std::vector<Finding> findings(int missed) {
    std::vector<Finding> all{finding(FindingKind::Outside, Severity::Blocking, 0)};
    for (int i = 1; i <= missed; ++i) {
        all.push_back(finding(FindingKind::Missed, Severity::Blocking, i));
    }
    all.push_back(finding(FindingKind::Gate, Severity::Note, missed + 1));
    all.push_back(finding(FindingKind::Gate, Severity::Note, missed + 2));
    return all;
}

}  // namespace

class TestFindingsModel : public QObject {
    Q_OBJECT

private slots:
    void manyShareARow() {
        FindingsModel model;
        const QAbstractItemModelTester tester{&model, QAbstractItemModelTester::FailureReportingMode::QtTest};
        model.setAll(true);
        model.show(findings(407), {});
        QCOMPARE(model.count(), 410);
        // Outside, missed, and the two gates, which are no crowd.
        QCOMPARE(model.rowCount(), 4);
        const auto at = [&model](int row, int role) { return model.index(row).data(role).toInt(); };
        QCOMPARE(at(0, FindingsModel::KindCountRole), 1);
        QCOMPARE(at(1, FindingsModel::KindCountRole), 407);
        QCOMPARE(at(1, FindingsModel::PlaceInKindRole), 1);
        QCOMPARE(at(1, FindingsModel::FindingRole), 1);
        // The numbers of the map stay.
        QCOMPARE(at(2, FindingsModel::NumberRole), 409);
        model.bringForward(3);
        QCOMPARE(at(1, FindingsModel::PlaceInKindRole), 3);
        QCOMPARE(model.index(1).data(FindingsModel::TextRole).toString(), QStringLiteral("3"));
        QCOMPARE(model.rowOf(300), 1);
        QCOMPARE(model.rowOf(409), 3);
        QCOMPARE(model.rowOf(410), -1);
        // What is planned again keeps the place, as far as it is there.
        model.show(findings(200), {});
        QCOMPARE(at(1, FindingsModel::PlaceInKindRole), 3);
        model.show(findings(3), {});
        QCOMPARE(model.rowCount(), 6);
        model.show({}, {});
        QCOMPARE(model.rowCount(), 0);
        QCOMPARE(model.nextOfKind(-1, 1), -1);
    }

    void stepsWithinTheKind() {
        FindingsModel model;
        model.show(findings(5), {});
        QCOMPARE(model.nextOfKind(1, 1), 2);
        QCOMPARE(model.nextOfKind(5, 1), 1);
        QCOMPARE(model.nextOfKind(1, -1), 5);
        // Alone of its kind.
        QCOMPARE(model.nextOfKind(0, 1), 0);
        // Nothing selected: the first, or the last.
        QCOMPARE(model.nextOfKind(-1, 1), 0);
        QCOMPARE(model.nextOfKind(-1, -1), 7);
    }

    // The name of a setting alone does not say what it is of: passes, width and method are in several steps.
    void saysWhatBecameOfAChange() {
        FindingsModel model;
        std::vector<Finding> all = findings(1);
        all[0].change = SettingChange{.key = "headland.passes", .value = "3"};
        all[1].change = SettingChange{.key = "no.setting", .value = "3"};
        model.show(all, {});
        model.apply(0);
        QCOMPARE(model.outcome(), QString{});
        model.show({}, {});
        QVERIFY2(model.outcome().startsWith(QStringLiteral("Headland: Passes \u2192 3. Before: 2 ")),
                 qPrintable(model.outcome()));
        QVERIFY2(model.outcome().endsWith(QStringLiteral("Now: no problems.")), qPrintable(model.outcome()));
        // What cannot be read is not told.
        model.show(all, {});
        model.apply(1);
        model.show({}, {});
        QCOMPARE(model.outcome(), QString{});
    }
};

FURROW_TEST(TestFindingsModel);
#include "tst_findings_model.moc"
