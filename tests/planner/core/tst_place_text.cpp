#include "planner/core/place_text.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <string>

using namespace furrow;

class PlaceTextTest : public QObject {
    Q_OBJECT

private slots:
    void names_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<double>("latDeg");
        QTest::addColumn<double>("lonDeg");
        // 48° 8' 13.6" = 48 + 8 / 60 + 13.6 / 3600 = 48.137111; 11° 34' 31" = 11.575278.
        const auto row = [](const char* text, double latDeg, double lonDeg) {
            QTest::newRow(text) << QString::fromUtf8(text) << latDeg << lonDeg;
        };
        row("48.1371, 11.5754", 48.1371, 11.5754);
        row("48.1371,11.5754", 48.1371, 11.5754);
        row("  48.1371 11.5754\n", 48.1371, 11.5754);
        row("48.1371; 11.5754", 48.1371, 11.5754);
        row("48,1371 11,5754", 48.1371, 11.5754);
        row("48,1371; 11,5754", 48.1371, 11.5754);
        row("48,1371, 11,5754", 48.1371, 11.5754);
        row("48,1371,11,5754", 48.1371, 11.5754);
        row("48, 11", 48.0, 11.0);
        row("48,11", 48.0, 11.0);
        row("-33.9249, 18.4241", -33.9249, 18.4241);
        row("−33.9249, +18.4241", -33.9249, 18.4241);
        row("48.1371N 11.5754E", 48.1371, 11.5754);
        row("48.1371° n, 11.5754° e", 48.1371, 11.5754);
        row("N 48.1371 E 11.5754", 48.1371, 11.5754);
        row("N48.1371, E11.5754", 48.1371, 11.5754);
        row("E 11.5754 N 48.1371", 48.1371, 11.5754);
        row("33.9249 S 18.4241 E", -33.9249, 18.4241);
        row("12.5 S, 45.25 W", -12.5, -45.25);
        row("48° 8' 13.6\" N, 11° 34' 31\" E", 48.1371111, 11.5752778);
        row("48°8′13.6″N 11°34′31″E", 48.1371111, 11.5752778);
        row("48°08'13.6''N 11°34'31''E", 48.1371111, 11.5752778);
        row("48° 8' 13.6\", 11° 34' 31\"", 48.1371111, 11.5752778);
        row("48° 8' 13.6\" 11° 34' 31\"", 48.1371111, 11.5752778);
        row("48° 8' 13,6\" N 11° 34' 31\" E", 48.1371111, 11.5752778);
        row("N 48 08.226 E 11 34.524", 48.1371, 11.5754);
        row("48 08.226 N 11 34.524 E", 48.1371, 11.5754);
        row("48 8 13.6 N, 11 34 31 E", 48.1371111, 11.5752778);
        row("48 N 8 12 E", 48.0, 8.2);
        row("geo:48.1371,11.5754", 48.1371, 11.5754);
        row("GEO:48.1371,11.5754;u=35?z=17", 48.1371, 11.5754);
        row("90, -180", 90.0, -180.0);
        row("0, 0", 0.0, 0.0);
    }
    void names() {
        QFETCH(QString, text);
        QFETCH(double, latDeg);
        QFETCH(double, lonDeg);
        const auto place = placeNamedBy(text.toStdString());
        QVERIFY(place);
        COMPARE_WITHIN(place->latDeg, latDeg, 1e-6);
        COMPARE_WITHIN(place->lonDeg, lonDeg, 1e-6);
    }

    void isNone_data() {
        QTest::addColumn<QString>("text");
        for (const char* text : {
                 "",
                 " ",
                 "48.1371",
                 "N",
                 "seeds",
                 "d d",
                 "Feld 3",
                 "2.5 m",
                 "12'6\"",
                 "12 m, 24 m",
                 "48.1, 11.5, 520",
                 "1,234,567",
                 "90.1, 11",
                 "48, 180.5",
                 "48 N, 11",
                 "48 N, 11 N",
                 "48 E 11 E",
                 "48 8 13",
                 "-48 S, 11 E",
                 "48° 60' N, 11° E",
                 "48.5° 8' N, 11° E",
                 "48' N, 11' E",
                 "48° 8\" N, 11° E",
                 "48 N E 11 E",
                 "1e5, 2",
                 "nan, nan",
                 "inf, 0",
                 "geo:",
                 "geo:48",
                 "https://example.org/48,11",
                 ", 48, 11",
                 "48.1.2, 11",
                 "N S",
                 "48,, 11",
                 "- 48, 11",
             }) {
            QTest::newRow(text) << QString::fromUtf8(text);
        }
        QTest::newRow("long") << QString(250, u'1') + QStringLiteral(", 2");
    }
    void isNone() {
        QFETCH(QString, text);
        QVERIFY(!placeNamedBy(text.toStdString()));
    }
};

FURROW_TEST(PlaceTextTest);
#include "tst_place_text.moc"
