#include "planner/project/project_edits.h"
#include "planner/units/unit_system.h"
#include "tests/planner/project/project_samples.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"
#include "ui/report/order_model.h"
#include "ui/text/display.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTest>

#include <cmath>

using namespace furrow;
using namespace furrow::test;

class TestOrderModel : public QObject {
    Q_OBJECT

    static int rowOf(const OrderModel& model, const QString& key) {
        for (int row = 0; row < model.rowCount(); ++row) {
            if (model.index(row).data(OrderModel::KeyRole).toString() == key) {
                return row;
            }
        }
        qFatal("no line %s", qPrintable(key));
    }
    static QString textOf(const OrderModel& model, const QString& key) {
        return model.index(rowOf(model, key)).data(OrderModel::TextRole).toString();
    }
    static void begin(Document& document) { document.look(showing(sampleProject(), 0, 0)); }

private slots:
    void initTestCase() { QStandardPaths::setTestModeEnabled(true); }
    void init() { furrow::Display::instance().force(QStringLiteral("en"), furrow::Display::Metric); }

    void whatIsTypedIsInTheProject() {
        Document document;
        begin(document);
        OrderModel model{document};
        const QAbstractItemModelTester tester{&model};
        const QSignalSpy changes{&model, &QAbstractItemModel::dataChanged};
        model.setText(rowOf(model, "customer"), "  Hof Müller ");
        model.setText(rowOf(model, "rate"), "162,5");
        model.setText(rowOf(model, "actual_area"), "20.3");
        model.setText(rowOf(model, "actual_time"), "1.5");
        model.setStatus(2);
        const WorkOrder& order = document.project()->plan().order;
        QCOMPARE(order.customer, std::string{"Hof Müller"});
        QCOMPARE(order.ratePerHectare, std::optional{162.5});
        COMPARE_WITHIN(order.actualArea.value().si(), 203000.0, 1e-6);
        QCOMPARE(order.actualTime.value().si(), 5400.0);
        QVERIFY(order.status == WorkOrderStatus::InProgress);
        QCOMPARE(textOf(model, "rate"), QStringLiteral("162.5"));
        QVERIFY(changes.size() >= 5);
        // Each line is one step.
        for (int i = 0; i < 5; ++i) {
            QVERIFY(document.canUndo());
            document.undo();
        }
        QVERIFY(document.project()->plan().order == WorkOrder{});
        QCOMPARE(textOf(model, "customer"), QString{});
    }

    void amountsAreNumbers() {
        Document document;
        begin(document);
        OrderModel model{document};
        for (const char* key : {"rate", "actual_area", "actual_time"}) {
            const int row = rowOf(model, QLatin1String{key});
            QVERIFY(model.accepts(row, "12"));
            QVERIFY(model.accepts(row, ""));
            QVERIFY(!model.accepts(row, "many"));
            QVERIFY(!model.accepts(row, "-1"));
            model.setText(row, "many");
            QVERIFY(!document.canUndo());
        }
        QVERIFY(model.accepts(rowOf(model, "customer"), "12"));
    }

    void emptyTakesAnAmountBack() {
        Document document;
        begin(document);
        OrderModel model{document};
        model.setText(rowOf(model, "rate"), "100");
        model.setText(rowOf(model, "rate"), "");
        QVERIFY(!document.project()->plan().order.ratePerHectare);
    }

    void ratesArePerAcreForWhoMeasuresInAcres() {
        furrow::Display::instance().force(QStringLiteral("en"), furrow::Display::Imperial);
        Document document;
        begin(document);
        OrderModel model{document};
        QVERIFY(model.index(rowOf(model, "rate")).data(OrderModel::NameRole).toString().contains("acre"));
        model.setText(rowOf(model, "rate"), "100");
        // A hectare is 2.4711 acres.
        COMPARE_WITHIN(document.project()->plan().order.ratePerHectare.value(), 247.105, 0.001);
        QCOMPARE(textOf(model, "rate"), QStringLiteral("100"));
        model.setText(rowOf(model, "actual_area"), "10");
        COMPARE_WITHIN(document.project()->plan().order.actualArea.value().si(), 40468.56, 0.01);
    }
};

FURROW_TEST_WITH(TestOrderModel, QGuiApplication);
#include "tst_order_model.moc"
