#include "planner/units/time_message.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace furrow;

class TestTimeMessage : public QObject {
    Q_OBJECT
private slots:
    void asOneSaysIt_data() {
        QTest::addColumn<double>("s");
        QTest::addColumn<QString>("said");
        QTest::newRow("nothing") << 0.2 << "0 s";
        QTest::newRow("seconds") << 89.4 << "89 s";
        QTest::newRow("minutes") << 192.0 << "3 min";
        QTest::newRow("less") << -192.0 << "3 min";
        QTest::newRow("the last minutes") << 5399.0 << "90 min";
        QTest::newRow("hours") << 5400.0 << "1 h 30 min";
        QTest::newRow("no 60 minutes") << 7199.0 << "2 h 0 min";
    }
    void asOneSaysIt() {
        QFETCH(double, s);
        QFETCH(QString, said);
        QCOMPARE(QString::fromUtf8(timeMessage(seconds(s)).c_str()), said);
    }
};

FURROW_TEST(TestTimeMessage);
#include "tst_time_message.moc"
