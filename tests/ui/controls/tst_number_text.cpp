#include "ui/controls/number_text.h"

#include <QTest>

using namespace furrow;

class TestNumberText : public QObject {
    Q_OBJECT

private slots:
    void reads_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<bool>("ok");
        QTest::addColumn<double>("value");
        QTest::newRow("point") << "24.5" << true << 24.5;
        QTest::newRow("comma") << "24,5" << true << 24.5;
        QTest::newRow("spaces and unit") << "  12 m " << true << 12.0;
        QTest::newRow("unit of two letters") << "8,5km/h" << true << 8.5;
        QTest::newRow("negative") << "-3.25" << true << -3.25;
        QTest::newRow("no digit before the point") << ".5" << true << 0.5;
        QTest::newRow("no digit after the comma") << "7," << true << 7.0;
        QTest::newRow("two commas") << "1,000,5" << false << 0.0;
        QTest::newRow("word") << "wide" << false << 0.0;
        QTest::newRow("empty") << "" << false << 0.0;
        QTest::newRow("only a sign") << "-" << false << 0.0;
    }
    void reads() {
        QFETCH(QString, text);
        QFETCH(bool, ok);
        QFETCH(double, value);
        const std::optional<double> number = parsedNumber(text);
        QCOMPARE(number.has_value(), ok);
        QCOMPARE(number.value_or(0.0), value);
    }
};

QTEST_APPLESS_MAIN(TestNumberText)
#include "tst_number_text.moc"
