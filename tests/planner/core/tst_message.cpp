#include "planner/core/message.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cstdint>

using namespace furrow;

class TestMessage : public QObject {
    Q_OBJECT

private slots:
    void english_data() {
        QTest::addColumn<QString>("made");
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("key");
        const auto row = [](const char* name, const Message& made, const char* text, const char* key) {
            QTest::newRow(name) << QString::fromStdString(made.text()) << QString::fromUtf8(text)
                                << QString::fromUtf8(key);
            QCOMPARE(QString::fromStdString(made.key()), QString::fromUtf8(key));
        };
        row("a sentence", "draw it again", "draw it again", "draw it again");
        row("a length", message("{} jumps by {:.2f} m.", "swath 3", 1.005), "swath 3 jumps by 1.00 m.",
            "%1 jumps by %2.");
        row("an area", message("a sliver of {:.2f} m² was left out", 0.5), "a sliver of 0.50 m² was left out",
            "a sliver of %1 was left out");
        row("hectares", message("{} ({:.2f} ha)", 1, 5.4), "1 (5.40 ha)", "%1 (%2)");
        row("a speed is no length", message("up to {:.2f} m/s above", 1.0), "up to 1.00 m/s above",
            "up to %1 above");
        row("an acceleration", message("with {:.1f} m/s² sideways", 1.5), "with 1.5 m/s² sideways",
            "with %1 sideways");
        row("an angle", message("bends by {:.0f} degrees in", 45.0), "bends by 45 degrees in",
            "bends by %1 in");
        row("a share", message("{:.1f} % of the field", 2.25), "2.2 % of the field", "%1 of the field");
        row("megabytes are no metres", message("has {:.1f} MB free", 3.0), "has 3.0 MB free",
            "has %1 MB free");
        row("shortest", message("{} m of margin", 2.5), "2.5 m of margin", "%1 of margin");
        row("braces", message("{{}} of {}", 1), "{} of 1", "{} of %1");
        row("one", counted("{} pass", "{} passes", 1), "1 pass", "%n passes");
        row("many", counted("{} pass", "{} passes", 2), "2 passes", "%n passes");
        row("none", counted("{} pass", "{} passes", 0), "0 passes", "%n passes");
        row("one in another", message("it is {:.1f} m with {}", 12.0, counted("{} pass", "{} passes", 4)),
            "it is 12.0 m with 4 passes", "it is %1 with %2");
        row("a capital", message("the turn after {}", message("swath {}", 2)).capitalised(),
            "The turn after swath 2", "the turn after %1");
        row("one after the other", Message{"farm.kml"} + ", " + message("part {}", 2), "farm.kml, part 2",
            "%1%2");
    }
    void english() {
        QFETCH(QString, made);
        QTEST(made, "text");
    }

    // Found by feeding a rosbag reader nonsense.
    void countsMayBeHuge() {
        QCOMPARE(message("{} bytes", std::uint64_t{1} << 63).text(),
                 std::string{"9223372036854775808 bytes"});
        QCOMPARE(message("{} bytes", -3).text(), std::string{"-3 bytes"});
    }
    void valuesAreTyped() {
        const Message made =
            message("{} leaves the field by {:.2f} m in {} of {} places", message("swath {}", 3), 1.5, 2, 7);
        QCOMPARE(made.arguments().size(), std::size_t{4});
        QCOMPARE(made.arguments()[0].kind, MessageArgument::Kind::Message);
        QCOMPARE(made.arguments()[1].unit, MessageUnit::Metres);
        QCOMPARE(made.arguments()[1].decimals, 2);
        QCOMPARE(made.arguments()[1].number, 1.5);
        QVERIFY(made.arguments()[2].isWhole);
        QVERIFY(!made.count());
        QCOMPARE(counted("{} pass", "{} passes", 4).count(), std::optional<std::int64_t>{4});
    }

    void equalWhereEverythingIs() {
        QCOMPARE(message("{:.0f} m", 1.2), message("{:.0f} m", 1.2));
        // The same in English, not in feet.
        QVERIFY(!(message("{:.0f} m", 1.2) == message("{:.0f} m", 1.4)));
        QVERIFY(message("{:.0f} m", 1.2) == "1 m");
    }
};

FURROW_TEST(TestMessage);
#include "tst_message.moc"
