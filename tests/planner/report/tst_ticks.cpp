#include "planner/report/ticks.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <random>

using namespace furrow;

class TicksTest : public QObject {
    Q_OBJECT

private slots:
    void byHand_data() {
        QTest::addColumn<double>("min");
        QTest::addColumn<double>("max");
        QTest::addColumn<int>("count");
        QTest::addColumn<QStringList>("labels");
        QTest::newRow("0 to 10") << 0.0 << 10.0 << 5 << QStringList{"0", "2", "4", "6", "8", "10"};
        QTest::newRow("0.13 to 0.91")
            << 0.13 << 0.91 << 5 << QStringList{"0.0", "0.2", "0.4", "0.6", "0.8", "1.0"};
        QTest::newRow("below zero") << -3.0 << 3.0 << 3 << QStringList{"\u22124", "\u22122", "0", "2", "4"};
        QTest::newRow("thousands") << 0.0 << 40000.0 << 4
                                   << QStringList{"0", "10\u202f000", "20\u202f000", "30\u202f000",
                                                  "40\u202f000"};
        QTest::newRow("one value") << 5.0 << 5.0 << 2 << QStringList{"4.5", "5.0", "5.5"};
    }
    void byHand() {
        QFETCH(double, min);
        QFETCH(double, max);
        QFETCH(int, count);
        QFETCH(QStringList, labels);
        QStringList found;
        for (const std::string& label : linearTicks(min, max, count).labels) {
            found << QString::fromStdString(label);
        }
        // A zero needs no decimals.
        labels.replaceInStrings("0.0", "0", Qt::CaseSensitive);
        QCOMPARE(found.size(), labels.size());
        for (qsizetype i = 0; i < found.size(); ++i) {
            QCOMPARE(found[i], labels[i]);
        }
    }

    void powersOfTen() {
        const Ticks ticks = logTicks(0.02, 300.0);
        QCOMPARE(ticks.labels, (std::vector<std::string>{"0.1", "1", "10", "100"}));
        const Ticks fine = logTicks(1.0, 40.0);
        QCOMPARE(fine.labels, (std::vector<std::string>{"1", "2", "5", "10", "20"}));
    }

    // Whatever the range: it holds the values, and there are neither too few nor too many marks.
    void anyRange() {
        std::mt19937 random{3};
        std::uniform_real_distribution<double> exponent{-6.0, 8.0};
        std::uniform_real_distribution<double> share{-1.0, 1.0};
        for (int i = 0; i < 2000; ++i) {
            const double size = std::pow(10.0, exponent(random));
            const double a = size * share(random);
            const double b = size * share(random);
            const int count = 2 + i % 9;
            const Ticks ticks = linearTicks(std::min(a, b), std::max(a, b), count);
            QVERIFY(ticks.min <= std::min(a, b) + 1e-9 * size && ticks.max >= std::max(a, b) - 1e-9 * size);
            QVERIFY(ticks.values.size() >= 2 && ticks.values.size() <= static_cast<std::size_t>(count) + 3);
            QCOMPARE(ticks.values.size(), ticks.labels.size());
            for (std::size_t k = 1; k < ticks.labels.size(); ++k) {
                QVERIFY(ticks.labels[k] != ticks.labels[k - 1]);
            }
        }
    }
};

FURROW_TEST(TicksTest);
#include "tst_ticks.moc"
