#include "planner/settings/settings.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <array>
#include <cmath>
#include <limits>

using namespace furrow;

namespace {

constexpr Choice kColours[] = {{"red", "Red", "Like a tractor."}, {"green", "Green", "Like another."}};

const Parameter kWidth{.key = "test.width_m",
                       .name = "Width",
                       .description = "A length.",
                       .kind = ParameterKind::Length,
                       .standard = {},
                       .canBeAuto = true,
                       .min = 0.0,
                       .max = 50.0,
                       .choices = {}};
const Parameter kTurn{.key = "test.turn_deg",
                      .name = "Turn",
                      .description = "An angle.",
                      .kind = ParameterKind::Angle,
                      .standard = 90.0,
                      .min = -360.0,
                      .max = 360.0,
                      .choices = {}};
const Parameter kPasses{.key = "test.passes",
                        .name = "Passes",
                        .description = "A count.",
                        .kind = ParameterKind::Count,
                        .standard = 3.0,
                        .min = 1.0,
                        .max = 9.0,
                        .choices = {}};
const Parameter kColour{.key = "test.colour",
                        .name = "Colour",
                        .description = "A choice.",
                        .kind = ParameterKind::Choice,
                        .standard = 1.0,
                        .choices = kColours};
const Parameter kWet{.key = "test.wet",
                     .name = "Wet",
                     .description = "A flag.",
                     .kind = ParameterKind::Flag,
                     .standard = 1.0,
                     .choices = {}};
const Parameter kWay{.key = "test.way",
                     .name = "Way",
                     .description = "A line.",
                     .kind = ParameterKind::Line,
                     .standard = {},
                     .choices = {}};
const Parameter kRow{.key = "test.row",
                     .name = "Row",
                     .description = "Numbers.",
                     .kind = ParameterKind::Numbers,
                     .standard = {},
                     .choices = {}};

const Parameter* parameterNamed(const QString& key) {
    for (const Parameter* parameter : {&kWidth, &kTurn, &kPasses, &kColour, &kWet, &kWay, &kRow}) {
        if (key.toStdString() == parameter->key) {
            return parameter;
        }
    }
    return nullptr;
}

}  // namespace

class SettingsTest : public QObject {
    Q_OBJECT

private slots:
    void acceptsText_data() {
        QTest::addColumn<QString>("key");
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("kept");
        QTest::newRow("a length") << "test.width_m" << "12.5" << "12.5";
        QTest::newRow("smallest length") << "test.width_m" << "0" << "0";
        QTest::newRow("largest length") << "test.width_m" << "50" << "50";
        QTest::newRow("auto") << "test.width_m" << "auto" << "auto";
        QTest::newRow("exponent") << "test.width_m" << "1e1" << "10";
        QTest::newRow("negative angle") << "test.turn_deg" << "-30.25" << "-30.25";
        QTest::newRow("a count") << "test.passes" << "7" << "7";
        QTest::newRow("a count written as a decimal") << "test.passes" << "7.0" << "7";
        QTest::newRow("a choice") << "test.colour" << "red" << "red";
        QTest::newRow("a flag") << "test.wet" << "false" << "false";
        QTest::newRow("a line") << "test.way" << "LINESTRING (4.1 52.0, 4.2 52.0)"
                                << "LINESTRING (4.1 52.0, 4.2 52.0)";
        QTest::newRow("a point") << "test.way" << "POINT(4.1 52)" << "POINT(4.1 52)";
        QTest::newRow("no line") << "test.way" << "" << "";
        QTest::newRow("numbers") << "test.row" << "3,-1,2" << "3,-1,2";
        QTest::newRow("numbers with blanks") << "test.row" << " 3 , -1,2 " << " 3 , -1,2 ";
        QTest::newRow("one number") << "test.row" << "7" << "7";
        QTest::newRow("no numbers") << "test.row" << "" << "";
    }
    void acceptsText() {
        QFETCH(QString, key);
        QFETCH(QString, text);
        QFETCH(QString, kept);
        const Parameter& parameter = *parameterNamed(key);
        Settings settings;
        const auto done = settings.setText(parameter, text.toStdString());
        VERIFY_RESULT(done);
        QCOMPARE(settingText(settings.value(parameter)), kept.toStdString());
        // What a plan writes out can be read in again.
        Settings again;
        VERIFY_RESULT(again.setText(parameter, settingText(settings.value(parameter))));
        QVERIFY(again == settings);
    }

    void refusesText_data() {
        QTest::addColumn<QString>("key");
        QTest::addColumn<QString>("text");
        QTest::addColumn<ErrorCode>("code");
        QTest::addColumn<QString>("part");
        const ErrorCode refused = ErrorCode::InputRefused;
        QTest::newRow("length below its range") << "test.width_m" << "-0.1" << refused << "from 0 to 50 m";
        QTest::newRow("length above its range") << "test.width_m" << "50.01" << refused << "from 0 to 50 m";
        QTest::newRow("not a number") << "test.width_m" << "nan" << refused << "from 0 to 50 m";
        QTest::newRow("infinite") << "test.width_m" << "inf" << refused << "from 0 to 50 m";
        QTest::newRow("a word") << "test.width_m" << "wide" << refused << "'wide' is not a number";
        QTest::newRow("number with a unit") << "test.width_m" << "12m" << refused << "'12m' is not a number";
        QTest::newRow("decimal comma") << "test.width_m" << "12,5" << refused << "'12,5' is not a number";
        QTest::newRow("nothing") << "test.width_m" << "" << refused << "is not a number";
        QTest::newRow("angle above its range") << "test.turn_deg" << "361" << refused << "degrees";
        QTest::newRow("auto where there is none") << "test.turn_deg" << "auto" << refused << "auto";
        QTest::newRow("half a pass") << "test.passes" << "2.5" << refused << "not a whole number";
        QTest::newRow("too many passes") << "test.passes" << "10" << refused << "from 1 to 9";
        QTest::newRow("an unknown choice lists those there are")
            << "test.colour" << "blue" << ErrorCode::Usage << "red, green";
        QTest::newRow("a choice in capitals") << "test.colour" << "Red" << ErrorCode::Usage << "red, green";
        QTest::newRow("no choice is auto") << "test.colour" << "auto" << ErrorCode::Usage << "red, green";
        QTest::newRow("a flag as a number") << "test.wet" << "1" << refused << "true or false";
        QTest::newRow("a flag as yes") << "test.wet" << "yes" << refused << "true or false";
        QTest::newRow("a line that is no WKT")
            << "test.way" << "4.1 52.0, 4.2 52.0" << refused << "LINESTRING";
        QTest::newRow("a line that is an area")
            << "test.way" << "POLYGON ((4 52, 5 52, 5 53, 4 52))" << refused << "LINESTRING";
        QTest::newRow("a line that breaks off")
            << "test.way" << "LINESTRING (4.1 52.0, 4.2" << refused << "LINESTRING";
        QTest::newRow("a line of one point")
            << "test.way" << "LINESTRING (4.1 52.0)" << refused << "LINESTRING";
        QTest::newRow("a line off the globe in the north")
            << "test.way" << "LINESTRING (4 52, 4 90.1)" << refused << "WGS84";
        QTest::newRow("a line off the globe in the west")
            << "test.way" << "LINESTRING (4 52, -180.1 52)" << refused << "WGS84";
        QTest::newRow("a line in metres")
            << "test.way" << "LINESTRING (431000 5766000, 431100 5766000)" << refused << "WGS84";
        QTest::newRow("a line that is not a number") << "test.way" << "POINT (nan 52)" << refused << "WGS84";
        QTest::newRow("a word for a line") << "test.way" << "auto" << refused << "'auto' is not";
        QTest::newRow("numbers that are fractions") << "test.row" << "1,2.5" << refused << "whole numbers";
        QTest::newRow("numbers without commas") << "test.row" << "1 2" << refused << "whole numbers";
        QTest::newRow("numbers divided otherwise") << "test.row" << "1;2" << refused << "whole numbers";
        QTest::newRow("numbers with a comma too many") << "test.row" << "1,,2" << refused << "whole numbers";
        QTest::newRow("numbers that begin with a comma") << "test.row" << ",1" << refused << "whole numbers";
        QTest::newRow("numbers that end with a comma") << "test.row" << "1,2," << refused << "whole numbers";
        QTest::newRow("words for numbers") << "test.row" << "one" << refused << "whole numbers";
        QTest::newRow("too large a number") << "test.row" << "1,99999999999" << refused << "whole numbers";
    }
    void refusesText() {
        QFETCH(QString, key);
        QFETCH(QString, text);
        QFETCH(ErrorCode, code);
        QFETCH(QString, part);
        const Parameter& parameter = *parameterNamed(key);
        Settings settings;
        const auto done = settings.setText(parameter, text.toStdString());
        QVERIFY(!done);
        QCOMPARE(done.error().code, code);
        QCOMPARE(done.error().where, std::string{parameter.key});
        QVERIFY2(QString::fromStdString(done.error().line()).contains(part), done.error().line().c_str());
        QVERIFY(settings == Settings{});
    }

    void refusesValuesOfAnotherKind() {
        Settings settings;
        QVERIFY(!settings.set(kWidth, true));
        QVERIFY(!settings.set(kWidth, std::string{"12"}));
        QVERIFY(!settings.set(kColour, 1.0));
        QVERIFY(!settings.set(kWay, 1.0));
        QVERIFY(!settings.set(kWay, Auto{}));
        QVERIFY(!settings.set(kRow, 1.0));
        QVERIFY(!settings.set(kRow, true));
        QVERIFY(!settings.set(kWet, 1.0));
        QVERIFY(!settings.set(kWet, Auto{}));
        QVERIFY(!settings.set(kColour, Auto{}));
        QVERIFY(!settings.set(kWidth, std::numeric_limits<double>::quiet_NaN()));
        QVERIFY(settings == Settings{});
    }

    void linesAndNumbersAreRead() {
        Settings settings;
        QVERIFY(settings.line(kWay).empty());
        QVERIFY(settings.numbers(kRow).empty());
        VERIFY_RESULT(settings.setText(kWay, "LINESTRING (4.25 52.5, -4.5 -52)"));
        QCOMPARE(settings.line(kWay), (std::vector<GeoPoint>{{.lonDeg = 4.25, .latDeg = 52.5},
                                                             {.lonDeg = -4.5, .latDeg = -52.0}}));
        VERIFY_RESULT(settings.setText(kWay, "POINT (180 -90)"));
        QCOMPARE(settings.line(kWay), (std::vector<GeoPoint>{{.lonDeg = 180.0, .latDeg = -90.0}}));
        VERIFY_RESULT(settings.setText(kRow, "3, -1 ,2"));
        QCOMPARE(settings.numbers(kRow), (std::vector<int>{3, -1, 2}));
        VERIFY_RESULT(settings.setText(kWay, ""));
        VERIFY_RESULT(settings.setText(kRow, ""));
        QVERIFY(settings == Settings{});
    }

    void defaultsCount() {
        const Settings settings;
        QVERIFY(!settings.length(kWidth).has_value());
        QCOMPARE(inDegrees(*settings.angle(kTurn)), 90.0);
        QCOMPARE(*settings.count(kPasses), 3);
        QCOMPARE(settings.choice(kColour), std::string{"green"});
        QCOMPARE(settings.flag(kWet), true);
        QVERIFY(!settings.isSet(kPasses));
    }

    void settingTheDefaultChangesNothing() {
        Settings settings;
        VERIFY_RESULT(settings.setText(kPasses, "5"));
        QVERIFY(settings.isSet(kPasses));
        QVERIFY(settings != Settings{});
        VERIFY_RESULT(settings.setText(kPasses, "3"));
        VERIFY_RESULT(settings.setText(kColour, "green"));
        VERIFY_RESULT(settings.setText(kWidth, "auto"));
        VERIFY_RESULT(settings.setText(kWet, "true"));
        QVERIFY(!settings.isSet(kPasses));
        QVERIFY(settings == Settings{});
    }

    void aRefusedValueLeavesTheOldOne() {
        Settings settings;
        VERIFY_RESULT(settings.setText(kPasses, "5"));
        QVERIFY(!settings.setText(kPasses, "50"));
        QCOMPARE(*settings.count(kPasses), 5);
        settings.clear(kPasses);
        QCOMPARE(*settings.count(kPasses), 3);
    }

    void nearestName_data() {
        QTest::addColumn<QString>("given");
        QTest::addColumn<QString>("expected");
        QTest::newRow("one letter left out") << "headland.with_m" << "headland.width_m";
        QTest::newRow("two letters swapped") << "swaths.stpe_deg" << "swaths.step_deg";
        QTest::newRow("one letter too many") << "routte.corner" << "route.corner";
        QTest::newRow("exact") << "route.corner" << "route.corner";
        QTest::newRow("nothing near") << "x" << "";
    }
    void nearestName() {
        QFETCH(QString, given);
        QFETCH(QString, expected);
        constexpr std::array<std::string_view, 4> names{"headland.width_m", "headland.passes",
                                                        "swaths.step_deg", "route.corner"};
        QCOMPARE(furrow::nearestName(given.toStdString(), names), expected.toStdString());
    }
};

FURROW_TEST(SettingsTest);
#include "tst_settings.moc"
