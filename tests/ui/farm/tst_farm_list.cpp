// The list of a farm's fields: sorted, filtered, selected, planned in the background.

#include "planner/machine/machine_library.h"
#include "planner/project/plan_key.h"
#include "tests/support/patience.h"
#include "tests/support/test_program.h"
#include "tests/ui/farm/farm_samples.h"
#include "ui/farm/farm_list.h"
#include "ui/text/display.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

using namespace furrow;
using namespace furrow::test;

class TestFarmList : public QObject {
    Q_OBJECT

    struct Farm {
        explicit Farm(Project project) {
            document.begin(History{.base = std::make_shared<const Project>(std::move(project))});
        }
        Document document;
        MadePlans made;
        FarmPlans plans{document, made};
        FarmList list{document, plans};
        QAbstractItemModelTester tester{&list};
    };
    static QStringList names(const FarmList& list) {
        QStringList names;
        for (int row = 0; row < list.count(); ++row) {
            names << list.index(row).data(FarmList::NameRole).toString();
        }
        return names;
    }

private slots:
    void initTestCase() { QStandardPaths::setTestModeEnabled(true); }
    void init() { furrow::Display::instance().force(QStringLiteral("en"), furrow::Display::Metric); }

    void sortedWithNumbersAsNumbers() {
        Farm farm{farmOf(11)};
        QVERIFY(!farm.list.isSorted());
        farm.list.sortBy(FarmList::Name);
        QCOMPARE(names(farm.list)[1], QStringLiteral("Field 2"));
        QCOMPARE(names(farm.list)[10], QStringLiteral("Field 11"));
        farm.list.sortBy(FarmList::Name);
        QVERIFY(farm.list.isDescending());
        QCOMPARE(names(farm.list)[0], QStringLiteral("Field 11"));
        farm.list.sortBy(FarmList::Area);
        QVERIFY(!farm.list.isDescending());
        QCOMPARE(names(farm.list)[0], QStringLiteral("Field 1"));
        for (const auto column : {FarmList::Machine, FarmList::Time, FarmList::Way, FarmList::State}) {
            farm.list.sortBy(column);
            QCOMPARE(farm.list.count(), 11);
        }
    }

    void filteredByWords() {
        Farm farm{farmOf(12)};
        farm.list.setFilter("FIELD 1");
        QCOMPARE(names(farm.list), (QStringList{"Field 1", "Field 10", "Field 11", "Field 12"}));
        farm.list.setFilter("field nothing");
        QCOMPARE(farm.list.count(), 0);
        farm.list.setFilter("not planned 12");
        QCOMPARE(names(farm.list), QStringList{"Field 12"});
    }

    void selectedAsInAnyList() {
        Farm farm{farmOf(6)};
        // Without a selection the totals are of all: 1 + 1.1 + 1.2 + 1.3 + 1.4 + 1.5 ha.
        QVERIFY2(farm.list.totals().contains("7.5 ha"), qPrintable(farm.list.totals()));
        farm.list.pick(1, FarmList::Only);
        farm.list.pick(3, FarmList::UpTo);
        QCOMPARE(farm.list.selectedCount(), 3);
        QVERIFY2(farm.list.totals().contains("3.6 ha"), qPrintable(farm.list.totals()));
        farm.list.pick(2, FarmList::Toggle);
        QCOMPARE(farm.list.chosenIds().size(), 2);
        farm.list.pick(5, FarmList::Toggle);
        QCOMPARE(farm.list.selectedCount(), 3);
        farm.list.pick(5, FarmList::Only);
        QCOMPARE(farm.list.chosen(), std::vector<std::size_t>{5});
        farm.list.pick(17, FarmList::Only);
        QCOMPARE(farm.list.chosen(), std::vector<std::size_t>{5});
        farm.list.selectAll();
        QCOMPARE(farm.list.selectedCount(), 6);
        // A field that is gone is not selected.
        farm.document.change([] { return QString{}; }, withoutField(*farm.document.project()));
        QCOMPARE(farm.list.selectedCount(), 5);
        farm.list.selectNone();
        QCOMPARE(farm.list.selectedCount(), 0);
    }

    void ofTheFieldsThatAreShown() {
        Farm farm{farmOf(12)};
        QSignalSpy totals{&farm.list, &FarmList::totalsChanged};
        farm.list.setFilter("Field 1");
        QCOMPARE(totals.size(), 1);
        QCOMPARE(farm.list.chosen(), (std::vector<std::size_t>{0, 9, 10, 11}));
        QCOMPARE(farm.list.toPlan(), 4);
        // 1 + 1.9 + 2 + 2.1 ha.
        QVERIFY2(farm.list.totals().startsWith("4 of 12 fields · 7.0 ha"), qPrintable(farm.list.totals()));
        farm.list.sortBy(FarmList::Area);
        farm.list.sortBy(FarmList::Area);
        QCOMPARE(farm.list.chosenIds(), (QStringList{"field-1", "field-10", "field-11", "field-12"}));
        // What is selected is meant, whether it is shown or not.
        farm.list.pick(0, FarmList::Only);
        farm.list.setFilter("Field 3");
        QCOMPARE(farm.list.chosenIds(), QStringList{"field-12"});
        farm.list.selectNone();
        QCOMPARE(farm.list.chosenIds(), QStringList{"field-3"});
        farm.list.setFilter({});
        QCOMPARE(farm.list.toPlan(), 12);
    }

    /// What was planned is there for paper and files, as long as it has room and nothing changed.
    void plansAreKept() {
        Farm farm{farmOf(3)};
        farm.list.planSelected();
        QTRY_VERIFY_WITH_TIMEOUT(!farm.plans.isBusy(), kPatienceMs);
        const auto project = farm.document.project();
        const MadePlan first = farm.made.find(*project->fields[0], project->planOf(0));
        QVERIFY(first && first.advised);
        FieldPlan other = project->planOf(0);
        other.machine = machineLibrary().back();
        QVERIFY(!farm.made.find(*project->fields[0], other));
        QVERIFY(!farm.made.find(*project->fields[1], project->planOf(0)) ||
                farm.made.find(*project->fields[1], project->planOf(0)).plan != first.plan);
        std::size_t samples = 0;
        for (const PathSegment& segment : first.plan->path.segments) {
            samples += segment.samples.size();
        }
        MadePlans few{2 * samples};
        few.keep("a", first);
        few.keep("b", first);
        few.keep("a", first);
        QCOMPARE(few.size(), std::size_t{2});
        few.keep("c", first);
        QCOMPARE(few.size(), std::size_t{2});
        MadePlans none{1};
        none.keep("a", first);
        QCOMPARE(none.size(), std::size_t{0});
    }

    void foundOnTheMap() {
        Farm farm{farmOf(4)};
        QCOMPARE(farm.list.rowAt(farm.list.bounds().center()), -1);
        const auto bounds = farm.list.index(2).data(FarmList::BoundsRole).value<QGeoRectangle>();
        QCOMPARE(farm.list.rowAt(bounds.center()), 2);
    }

    /// The same figures as a plan that is made by itself; those of fields that did not change are kept.
    void plannedInTheBackground() {
        Farm farm{farmOf(5)};
        for (const int row : {0, 2, 4}) {
            farm.list.pick(row, FarmList::Toggle);
        }
        QCOMPARE(farm.list.toPlan(), 3);
        farm.list.planSelected();
        QVERIFY(farm.plans.isBusy());
        QCOMPARE(farm.list.stateOf(0), FarmList::Planning);
        QVERIFY2(farm.plans.status().startsWith("1 of 3: Field"), qPrintable(farm.plans.status()));
        QTRY_VERIFY_WITH_TIMEOUT(!farm.plans.isBusy(), kPatienceMs);
        QCOMPARE(farm.list.stateOf(0), FarmList::Drivable);
        QCOMPARE(farm.list.stateOf(1), FarmList::NoPlan);
        QCOMPARE(farm.list.toPlan(), 0);
        QVERIFY(!farm.document.canUndo());
        const Project& project = *farm.document.project();
        const auto plan =
            makePlan(
                {.field = std::make_shared<const Field>(Field::create(*project.fields[4]->source).value()),
                 .machine = project.planOf(4).machine,
                 .settings = project.planOf(4).settings})
                .value();
        const PlanResult* const result =
            farm.plans.resultOf(planKey(*project.fields[4]->source, project.planOf(4)));
        QVERIFY(result != nullptr && *result == resultOf(*plan));
        // Another machine: out of date, and undone it is known again.
        farm.document.change([] { return QString{}; },
                             withPlan(project, machineLibrary().back(), project.plan().settings));
        QCOMPARE(farm.list.stateOf(0), FarmList::OutOfDate);
        QCOMPARE(farm.list.stateOf(2), FarmList::Drivable);
        farm.document.undo();
        QCOMPARE(farm.list.stateOf(0), FarmList::Drivable);
    }

    void stoppedHalfWay() {
        Farm farm{farmOf(8)};
        farm.list.planSelected();
        QTRY_VERIFY_WITH_TIMEOUT(farm.list.toPlan() < 8 && farm.list.stateOf(0) == FarmList::Drivable,
                                 kPatienceMs);
        farm.plans.cancel();
        QVERIFY(!farm.plans.isBusy());
        QVERIFY(farm.plans.status().startsWith("Stopped"));
        QCOMPARE(farm.list.stateOf(7), FarmList::NoPlan);
        // It goes on where it stopped.
        const int left = farm.list.toPlan();
        QVERIFY(left > 0 && left < 8);
        farm.list.planSelected();
        QVERIFY(farm.plans.status().startsWith(QStringLiteral("1 of %1").arg(left)));
        QTRY_VERIFY_WITH_TIMEOUT(!farm.plans.isBusy(), kPatienceMs);
        QCOMPARE(farm.list.toPlan(), 0);
    }

    void whatCannotBePlannedSaysWhy() {
        FieldSource cross = *farmOf(1).field()->source;
        cross.name = "Bow";
        std::swap(cross.parts.front().outer[1], cross.parts.front().outer[2]);
        FieldSource small = fieldSourceFromLocal({rectangle(3.0, 3.0)}, {.lonDeg = 22.4, .latDeg = 58.25});
        small.name = "Small";
        Farm farm{withFields(farmOf(2), {cross, small})};
        farm.list.planSelected();
        QTRY_VERIFY_WITH_TIMEOUT(!farm.plans.isBusy(), kPatienceMs);
        QCOMPARE(farm.list.stateOf(0), FarmList::Drivable);
        QCOMPARE(farm.list.stateOf(3), FarmList::Failed);
        QVERIFY(!farm.list.index(3).data(FarmList::HintRole).toString().isEmpty());
        QVERIFY2(farm.plans.status().contains("without a plan"), qPrintable(farm.plans.status()));
    }

    void anotherProjectEndsIt() {
        Farm farm{farmOf(6)};
        farm.list.planSelected();
        farm.document.begin(History{.base = std::make_shared<const Project>(farmOf(2))});
        QVERIFY(!farm.plans.isBusy());
        QCOMPARE(farm.list.count(), 2);
        QVERIFY(farm.plans.status().isEmpty());
    }

    void keptInAFile() {
        const QTemporaryDir folder;
        const QString file = folder.filePath("below/plans.json");
        {
            Farm farm{farmOf(2)};
            farm.plans.keepIn(file);
            farm.list.planSelected();
            QTRY_VERIFY_WITH_TIMEOUT(!farm.plans.isBusy(), kPatienceMs);
            QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(file), kPatienceMs);
            QTRY_VERIFY_WITH_TIMEOUT(
                [&] {
                    QFile kept{file};
                    return kept.open(QIODevice::ReadOnly) &&
                           PlanResults::fromJson(kept.readAll().toStdString()).size() == 2;
                }(),
                kPatienceMs);
        }
        Farm again{farmOf(3)};
        again.plans.keepIn(file);
        QCOMPARE(again.list.stateOf(0), FarmList::Drivable);
        QCOMPARE(again.list.stateOf(1), FarmList::Drivable);
        QCOMPARE(again.list.stateOf(2), FarmList::NoPlan);
        // Changed since, one is out of date; one that was never planned is still that.
        const Project& project = *again.document.project();
        FieldPlan other = project.plan();
        other.machine = machineLibrary().back();
        again.document.change([] { return QString{}; },
                              withPlansLike(project, std::vector<std::size_t>{1, 2}, other));
        QCOMPARE(again.list.stateOf(0), FarmList::Drivable);
        QCOMPARE(again.list.stateOf(1), FarmList::OutOfDate);
        QCOMPARE(again.list.stateOf(2), FarmList::NoPlan);
    }

    void manyFieldsInOneStep() {
        Farm farm{farmOf(4)};
        farm.document.change([] { return QString{}; },
                             withPlan(*farm.document.project(), machineLibrary().back(), {}));
        farm.list.pick(1, FarmList::Toggle);
        farm.list.pick(3, FarmList::Toggle);
        farm.list.planLikeCurrent();
        const auto machineOf = [&farm](std::size_t i) {
            return farm.document.project()->planOf(i).machine == machineLibrary().back();
        };
        QVERIFY(machineOf(1) && !machineOf(2) && machineOf(3));
        farm.list.addPlans(" Drilling ", "2027");
        QCOMPARE(farm.list.index(3).data(FarmList::PlanRole).toString(), QStringLiteral("Drilling · 2027"));
        QCOMPARE(farm.list.index(2).data(FarmList::PlanRole).toString(), QString{});
        farm.document.undo();
        farm.document.undo();
        QVERIFY(!machineOf(1) && !machineOf(3));
    }
};

FURROW_TEST_WITH(TestFarmList, QGuiApplication);
#include "tst_farm_list.moc"
