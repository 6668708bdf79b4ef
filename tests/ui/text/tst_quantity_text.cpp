#include "tests/support/test_program.h"
#include "ui/text/display.h"
#include "ui/text/quantity_text.h"
#include "ui/text/unit_text.h"

#include <QStandardPaths>
#include <QTest>

using namespace furrow;

class TestQuantityText : public QObject {
    Q_OBJECT

    static void use(const char* language, bool imperial) {
        Display::instance().force(QString::fromLatin1(language),
                                  imperial ? Display::Imperial : Display::Metric);
    }

private slots:
    void initTestCase() {
        QStandardPaths::setTestModeEnabled(true);
        QCoreApplication::setOrganizationName(QStringLiteral("Furrow"));
    }

    void reads_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QuantityText::Kind>("kind");
        QTest::addColumn<bool>("imperial");
        QTest::addColumn<bool>("ok");
        QTest::addColumn<double>(
            "value");  // in SI units; a foot is 0.3048 m, a mile 1609.344 m, an acre 4046.8564224 m²
        const auto row = [](const char* name, const char* text, QuantityText::Kind kind, bool imperial,
                            double value) {
            QTest::newRow(name) << QString::fromUtf8(text) << kind << imperial << true << value;
        };
        const auto refused = [](const char* name, const char* text, QuantityText::Kind kind) {
            QTest::newRow(name) << QString::fromUtf8(text) << kind << false << false << 0.0;
        };
        row("point", "24.5", QuantityText::Length, false, 24.5);
        row("comma", "24,5", QuantityText::Length, false, 24.5);
        row("in the user's feet", "100", QuantityText::Length, true, 30.48);
        row("metres for one who reads feet", "7,3 m", QuantityText::Length, true, 7.3);
        row("feet for one who reads metres", "24 ft", QuantityText::Length, false, 7.3152);
        row("no space before the unit", "24ft", QuantityText::Length, false, 7.3152);
        row("capitals", "24 FT", QuantityText::Length, false, 7.3152);
        row("feet and inches", "10'6\"", QuantityText::Length, false, 3.2004);
        row("feet and inches as typeset", "10′ 6″", QuantityText::Length, false, 3.2004);
        row("feet and inches without the last mark", "10' 6", QuantityText::Length, false, 3.2004);
        row("feet and inches in words", "10 ft 6 in", QuantityText::Length, false, 3.2004);
        row("half an inch", "0'0,5\"", QuantityText::Length, false, 0.0127);
        row("negative feet and inches", "-10'6\"", QuantityText::Length, false, -3.2004);
        row("inches", "30 in", QuantityText::Length, false, 0.762);
        row("yards", "100 yd", QuantityText::Length, false, 91.44);
        row("miles", "0.5 mi", QuantityText::Length, false, 804.672);
        row("centimetres", "30 cm", QuantityText::Length, false, 0.3);
        row("kilometres", "1,2 km", QuantityText::Length, false, 1200.0);
        row("no digit before the point", ".5", QuantityText::Length, false, 0.5);
        row("no digit after the comma", "7,", QuantityText::Length, false, 7.0);
        row("acres", "3 ac", QuantityText::Area, false, 12140.5692672);
        row("hectares", "2,5", QuantityText::Area, false, 25000.0);
        row("square metres", "500 m²", QuantityText::Area, true, 500.0);
        row("miles an hour", "5 mph", QuantityText::Speed, false, 2.2352);
        row("km/h", "9", QuantityText::Speed, false, 2.5);
        row("km/h for one who reads mph", "9 km/h", QuantityText::Speed, true, 2.5);
        row("metres a second", "2 m/s", QuantityText::Speed, false, 2.0);
        row("seconds", "45 s", QuantityText::Duration, true, 45.0);
        row("minutes", "1,5 min", QuantityText::Duration, false, 90.0);
        refused("seconds of length", "45 m", QuantityText::Duration);
        row("degrees", "87,5°", QuantityText::Angle, true, 87.5);
        row("a plain number", "4", QuantityText::Number, true, 4.0);
        row("a whole number", "4", QuantityText::Count, true, 4.0);
        row("a whole number with a comma", "4,0", QuantityText::Count, false, 4.0);
        refused("part of a pass", "2.7", QuantityText::Count);
        refused("a speed where a length is wanted", "5 mph", QuantityText::Length);
        refused("a length where a speed is wanted", "5 m", QuantityText::Speed);
        refused("a unit where a plain number is wanted", "4 m", QuantityText::Number);
        refused("twelve inches are a foot", "10'12\"", QuantityText::Length);
        refused("two commas", "1,000,5", QuantityText::Length);
        refused("a word", "wide", QuantityText::Length);
        refused("an unknown unit", "5 furlongs", QuantityText::Length);
        refused("empty", "", QuantityText::Length);
        refused("only a sign", "-", QuantityText::Length);
    }
    void reads() {
        QFETCH(QString, text);
        QFETCH(QuantityText::Kind, kind);
        QFETCH(bool, imperial);
        QFETCH(bool, ok);
        QFETCH(double, value);
        use("en", imperial);
        const std::optional<double> read = QuantityText::parsed(text, kind);
        QCOMPARE(read.has_value(), ok);
        if (ok) {
            QVERIFY2(std::abs(*read - value) < 1e-9 * std::max(1.0, std::abs(value)),
                     qPrintable(QString::number(*read, 'g', 17)));
        }
    }

    void shows_data() {
        QTest::addColumn<QString>("language");
        QTest::addColumn<bool>("imperial");
        QTest::addColumn<QString>("length");
        QTest::addColumn<QString>("area");
        QTest::addColumn<QString>("speed");
        // 1234.5 m are 0.767 mi; 12.34 ha are 30.49 acres; 2.5 m/s are 9 km/h or 5.59 mph.
        QTest::newRow("English, metric") << "en" << false << "1.2 km" << "12.3 ha" << "9 km/h";
        QTest::newRow("English, imperial") << "en" << true << "4,050 ft" << "30.5 ac" << "5.6 mph";
        QTest::newRow("German") << "de" << false << "1,2 km" << "12,3 ha" << "9 km/h";
        QTest::newRow("German, imperial") << "de" << true << "4.050 ft" << "30,5 ac" << "5,6 mph";
    }
    void shows() {
        QFETCH(QString, language);
        QFETCH(bool, imperial);
        use(qPrintable(language), imperial);
        QTEST(lengthText(metres(1234.5)), "length");
        QTEST(areaText(squareMetres(123400.0)), "area");
        QTEST(speedText(metresPerSecond(2.5)), "speed");
    }

    void typedTextComesBack() {
        const QuantityText fields;
        for (const bool imperial : {false, true}) {
            for (const char* language : {"en", "de", "fr"}) {
                use(language, imperial);
                for (const auto kind : {QuantityText::Number, QuantityText::Length, QuantityText::Area,
                                        QuantityText::Speed, QuantityText::Angle, QuantityText::Duration}) {
                    const double value = 1234.5 * fields.unitSize(kind);
                    const QString text = fields.text(value, kind, 2);
                    const auto read = QuantityText::parsed(text, kind);
                    QVERIFY2(read && std::abs(*read - value) < 1e-9 * value, qPrintable(text));
                    const QString withUnit = text + QLatin1Char(' ') + fields.unit(kind);
                    QVERIFY2(QuantityText::parsed(withUnit, kind), qPrintable(withUnit));
                }
            }
        }
    }

    void saysWhatIsWrong() {
        const QuantityText fields;
        use("en", false);
        QVERIFY(fields.complaint(QStringLiteral("12"), QuantityText::Length, 0.0, 20.0, 1).isEmpty());
        QVERIFY(fields.complaint(QStringLiteral("wide"), QuantityText::Length, 0.0, 20.0, 1)
                    .contains(QStringLiteral("7.3 m")));
        QCOMPARE(fields.complaint(QStringLiteral("21"), QuantityText::Length, 0.0, 20.0, 1),
                 QStringLiteral("Type something from 0 m to 20 m."));
        QCOMPARE(fields.complaint(QStringLiteral("2.7"), QuantityText::Count, 0.0, 50.0, 0),
                 QStringLiteral("This is not a whole number."));
        QCOMPARE(fields.complaint(QStringLiteral("100"), QuantityText::Count, 0.0, 50.0, 0),
                 QStringLiteral("Type something from 0 to 50."));
        use("de", true);
        // 20 m are 65.6 ft.
        QCOMPARE(fields.complaint(QStringLiteral("66"), QuantityText::Length, 0.0, 20.0, 1),
                 QStringLiteral("Einen Wert von 0 ft bis 65,6 ft eintippen."));
        QVERIFY(fields.complaint(QStringLiteral("65,6"), QuantityText::Length, 0.0, 20.0, 1).isEmpty());
    }

    void unitsStandOnceInRanges() {
        use("en", false);
        QCOMPARE(metresText(metres(20.0), metres(32.5)), QStringLiteral("20 – 32.5 m"));
        QCOMPARE(metresText(metres(20.01), metres(20.04)), QStringLiteral("20.0 m"));
        use("de", true);
        QCOMPARE(metresText(metres(6.25), metres(9.144)), QStringLiteral("20,5 – 30 ft"));
    }

    void scaleBarsAreRound_data() {
        QTest::addColumn<bool>("imperial");
        QTest::addColumn<double>("room");
        QTest::addColumn<QString>("text");
        QTest::newRow("metres") << false << 130.0 << "100 m";
        QTest::newRow("kilometres") << false << 2400.0 << "2 km";
        QTest::newRow("centimetres") << false << 0.07 << "0.05 m";
        QTest::newRow("feet") << true << 130.0 << "200 ft";  // 426 ft
        QTest::newRow("just below a mile") << true << 1600.0 << "5000 ft";
        QTest::newRow("miles") << true << 4000.0 << "2 mi";  // 2.49 mi
    }
    void scaleBarsAreRound() {
        QFETCH(bool, imperial);
        QFETCH(double, room);
        use("en", imperial);
        const QuantityText bar;
        const double length = bar.roundLengthBelow(room);
        QVERIFY(length <= room && length >= room / 2.51);
        QTEST(bar.scaleText(length), "text");
    }

    void scaleBarsFillTheirRoom() {
        const QuantityText bar;
        for (const bool imperial : {false, true}) {
            use("en", imperial);
            for (double room = 0.01; room < 1e7; room *= 1.37) {
                const double length = bar.roundLengthBelow(room);
                // From one mile down to 5000 feet the steps are not those of either unit.
                QVERIFY2(length <= room * (1.0 + 1e-9) && length >= room / 2.51,
                         qPrintable(QString::number(room)));
            }
        }
    }
};

FURROW_TEST(TestQuantityText);
#include "tst_quantity_text.moc"
