#include "planner/core/message.h"
#include "planner/core/place_message.h"
#include "planner/core/place_text.h"
#include "planner/units/time_message.h"
#include "tests/support/test_program.h"
#include "ui/text/display.h"
#include "ui/text/message_text.h"
#include "ui/text/unit_text.h"

#include <QStandardPaths>
#include <QTest>

using namespace furrow;

class TestMessageText : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        QStandardPaths::setTestModeEnabled(true);
        QCoreApplication::setOrganizationName(QStringLiteral("Furrow"));
    }

    void noLineBreakDividesAnAmount() {
        Display::instance().force(QStringLiteral("en"), Display::Metric);
        const auto told = [](Duration time) {
            return shown(message("it is {} quicker than that", timeMessage(time)));
        };
        QVERIFY2(told(seconds(180.0)).contains(QStringLiteral("3\u00a0min")),
                 qPrintable(told(seconds(180.0))));
        QVERIFY(told(seconds(7200.0)).contains(QStringLiteral("2\u00a0h\u00a00\u00a0min")));
        // A sentence with a number in it may be divided.
        const QString whole =
            shown(message("{}: {}", "a", message("Headland pass {} leaves the field by {:.1f} m.", 4, 3.5)));
        QCOMPARE(whole.count(QChar{QChar::Nbsp}), 1);
    }

    void shows_data() {
        QTest::addColumn<QString>("language");
        QTest::addColumn<bool>("imperial");
        QTest::addColumn<QString>("outside");
        QTest::addColumn<QString>("rings");
        QTest::addColumn<QString>("ring");
        // 3.5 m are 11.48 ft.
        QTest::newRow("English") << "en" << false << "Headland pass 4 leaves the field by 3.5 m."
                                 << "2 rings ran the wrong way round and were turned"
                                 << "1 ring ran the wrong way round and was turned";
        QTest::newRow("English, imperial") << "en" << true << "Headland pass 4 leaves the field by 11.5 ft."
                                           << "2 rings ran the wrong way round and were turned"
                                           << "1 ring ran the wrong way round and was turned";
        QTest::newRow("German") << "de" << false << "Vorgewendespur 4 verlässt den Schlag um 3,5 m."
                                << "2 Ringe liefen falsch herum und wurden umgedreht"
                                << "1 Ring lief falsch herum und wurde umgedreht";
        QTest::newRow("Dutch, imperial")
            << "nl" << true << "Kopakkergang 4 komt 11,5 ft buiten het perceel."
            << "2 ringen liepen verkeerd om en zijn omgekeerd" << "1 ring liep verkeerd om en is omgekeerd";
        QTest::newRow("French") << "fr" << false << "Tour de fourrière 4 sort de la parcelle de 3,5 m."
                                << "2 contours tournaient à l'envers et ont été retournés"
                                << "1 contour tournait à l'envers et a été retourné";
        QTest::newRow("Spanish") << "es" << false << "Pasada de cabecera 4 sale 3,5 m de la parcela."
                                 << "2 anillos iban al revés y se han invertido"
                                 << "1 anillo iba al revés y se ha invertido";
        QTest::newRow("Portuguese of Brazil")
            << "pt_BR" << false << "Passada de cabeceira 4 sai 3,5 m do talhão."
            << "2 anéis estavam ao contrário e foram invertidos"
            << "1 anel estava ao contrário e foi invertido";
        QTest::newRow("Portuguese of Portugal")
            << "pt_PT" << false << "Passada de cabeceira 4 sai 3,5 m do talhão."
            << "2 anéis estavam ao contrário e foram invertidos"
            << "1 anel estava ao contrário e foi invertido";
    }
    void shows() {
        QFETCH(QString, language);
        QFETCH(bool, imperial);
        Display::instance().force(language, imperial ? Display::Imperial : Display::Metric);
        QString outside = shown(
            message("{} leaves the field by {:.1f} m.", message("headland pass {}", 4).capitalised(), 3.5));
        // The number and its unit do not part at the end of a line.
        QCOMPARE(outside.count(QChar{QChar::Nbsp}), 1);
        QTEST(outside.replace(QChar{QChar::Nbsp}, QLatin1Char(' ')), "outside");
        const auto rings = [](int count) {
            return shown(counted("{} ring ran the wrong way round and was turned",
                                 "{} rings ran the wrong way round and were turned", count));
        };
        QTEST(rings(2), "rings");
        QTEST(rings(1), "ring");
    }

    void wordsStayAsTheyAre() {
        Display::instance().force(QStringLiteral("de"), Display::Metric);
        // A field that somebody called "%1 swath" is neither filled in nor translated.
        QCOMPARE(shown(message("several fields are called '{}'", "%1 swath")),
                 QStringLiteral("mehrere Schläge heißen „%1 swath“"));
        QCOMPARE(shown(message("the field has no boundary")),
                 QStringLiteral("der Schlag hat keine Feldgrenze"));
        QCOMPARE(shown(Message{"fields/West.shp"}), QStringLiteral("fields/West.shp"));
    }

    void keysAreForTheCommandLine() {
        Display::instance().force(QStringLiteral("en"), Display::Metric);
        QCOMPARE(shown(message("split line {} does not lie inside the headland and cuts nothing "
                               "(decomposition.split)",
                               2)),
                 QStringLiteral("split line 2 does not lie inside the headland and cuts nothing"));
        // What a user called so stays.
        QCOMPARE(shown(message("several fields are called '{}'", "West (path.method)")),
                 QStringLiteral("several fields are called 'West (path.method)'"));
    }

    /// As maps and paper have it, not as files; and so that it can be typed again.
    void placesBeginWithTheLatitude() {
        const Message crosses =
            message("the line crosses itself at {}", placeMessage({.lonDeg = 5.0015, .latDeg = 52.0015001}));
        QCOMPARE(crosses.text(), "the line crosses itself at 5.0015000, 52.0015001");
        Display::instance().force(QStringLiteral("en"), Display::Metric);
        QCOMPARE(sentence(crosses), QStringLiteral("The line crosses itself at 52.001500° N, 5.001500° E"));
        Display::instance().force(QStringLiteral("de"), Display::Metric);
        QCOMPARE(sentence(crosses),
                 QStringLiteral("Die Linie kreuzt sich selbst bei 52,001500° N, 5,001500° E"));
        const QString south = placeText({.lonDeg = -58.5, .latDeg = -34.25});
        QCOMPARE(south, QStringLiteral("34,250000° S, 58,500000° W"));
        const auto read = placeNamedBy(south.toStdString());
        QVERIFY(read && *read == (GeoPoint{.lonDeg = -58.5, .latDeg = -34.25}));
    }

    void portugalHasItsOwnWords() {
        Display::instance().force(QStringLiteral("pt_PT"), Display::Metric);
        QCOMPARE(shown("Implement can reverse"), QStringLiteral("A alfaia aceita ré"));
        Display::instance().force(QStringLiteral("pt_BR"), Display::Metric);
        QCOMPARE(shown("Implement can reverse"), QStringLiteral("O implemento aceita ré"));
    }

    void whatIsKeptFollowsTheLanguage() {
        const LazyText said = [] { return shown("Headland"); };
        Display::instance().force(QStringLiteral("en"), Display::Metric);
        QCOMPARE(text(said), QStringLiteral("Headland"));
        Display::instance().force(QStringLiteral("de"), Display::Metric);
        QCOMPARE(text(said), QStringLiteral("Vorgewende"));
        QVERIFY(text({}).isEmpty());
    }
};

FURROW_TEST(TestMessageText);
#include "tst_message_text.moc"
