#include "planner/project/project_edits.h"
#include "planner/project/project_file.h"
#include "planner/project/work_order.h"
#include "tests/planner/project/project_samples.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace furrow;
using namespace furrow::test;

namespace {

WorkOrder sampleOrder() {
    WorkOrder order;
    order.number = "2026-014";
    order.customer = "Hof Müller\n26506 Norden";
    order.address = "Deichweg";
    order.operatorName = "Jan";
    order.timeWindow = "3 April, 7:00 to 12:00";
    order.product = "Barley";
    order.ratePerHectare = 162.5;
    order.rateUnit = "kg";
    order.status = WorkOrderStatus::InProgress;
    order.actualArea = squareMetres(203000.0);
    order.actualTime = seconds(6300.0);
    order.remark = "Mind the pole";
    return order;
}

}  // namespace

class TestWorkOrder : public QObject {
    Q_OBJECT

private slots:
    void whatIsWrittenIsReadBack() {
        const auto read = parseWorkOrder(workOrderJson(sampleOrder()), "order.json");
        VERIFY_RESULT(read);
        QVERIFY(*read == sampleOrder());
        QCOMPARE(workOrderJson(WorkOrder{}), std::string{"{}"});
        QVERIFY(parseWorkOrder("{}", "order.json").value() == WorkOrder{});
    }

    void unknownMembersStay() {
        const auto read = parseWorkOrder(R"({"number": "7", "crew": ["Jan", "Piet"]})", "order.json");
        VERIFY_RESULT(read);
        QCOMPARE(workOrderJson(*read), std::string{R"({"number":"7","crew":["Jan","Piet"]})"});
    }

    void badOnesAreRefused_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("named");
        QTest::newRow("no JSON") << QByteArray{"{"} << QByteArray{"JSON"};
        QTest::newRow("a list") << QByteArray{"[]"} << QByteArray{"JSON"};
        QTest::newRow("a number as text") << QByteArray{R"({"number": 7})"} << QByteArray{"number"};
        QTest::newRow("a negative rate") << QByteArray{R"({"rate_per_ha": -1})"} << QByteArray{"rate_per_ha"};
        QTest::newRow("hours in words")
            << QByteArray{R"({"actual_time_s": "2 h"})"} << QByteArray{"actual_time_s"};
        QTest::newRow("no such status") << QByteArray{R"({"status": "lost"})"} << QByteArray{"in_progress"};
    }
    void badOnesAreRefused() {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, named);
        const auto read = parseWorkOrder(text.toStdString(), "order.json");
        QVERIFY(!read);
        QCOMPARE(read.error().code, ErrorCode::InputRefused);
        QVERIFY2(read.error().line().contains(named.toStdString()), read.error().line().c_str());
        QVERIFY(read.error().line().contains("order.json"));
    }

    void aProjectKeepsIt() {
        const Project project = withWorkOrder(sampleProject(), sampleOrder());
        QVERIFY(project.plan().order == sampleOrder());
        const auto read = parseProject(projectText(project), "farm.furrow");
        VERIFY_RESULT(read);
        QVERIFY(read->notes.empty());
        QVERIFY(read->project == project);
        // Plans of which nothing was said stay as they were.
        QVERIFY(!projectText(sampleProject()).contains("work_order"));
    }

    void oneThatCannotBeReadStaysInTheFile() {
        std::string text = projectText(withWorkOrder(sampleProject(), sampleOrder()));
        const std::string status = R"("status":"in_progress")";
        text.replace(text.find(status), status.size(), R"("status":"lost to us")");
        const auto read = parseProject(text, "farm.furrow");
        VERIFY_RESULT(read);
        QCOMPARE(read->notes.size(), std::size_t{1});
        QVERIFY(read->project.plan().order == WorkOrder{});
        QVERIFY(projectText(read->project).contains("lost to us"));
    }

    void theNextPlanHasItsCustomer() {
        const Project project = withPlanCopy(withWorkOrder(sampleProject(), sampleOrder()), "Again");
        const WorkOrder& next = project.plan().order;
        QCOMPARE(next.customer, sampleOrder().customer);
        QCOMPARE(next.ratePerHectare, sampleOrder().ratePerHectare);
        QVERIFY(next.number.empty());
        QVERIFY(next.status == WorkOrderStatus::Draft);
        QVERIFY(!next.actualArea);
    }

    void totalsByHand() {
        // 162.5 kg on each of 20.3 ha.
        QCOMPARE(totalAmount(sampleOrder(), squareMetres(203000.0)), std::optional{3298.75});
        QVERIFY(!totalAmount(WorkOrder{}, squareMetres(203000.0)));
    }
};

FURROW_TEST(TestWorkOrder);
#include "tst_work_order.moc"
