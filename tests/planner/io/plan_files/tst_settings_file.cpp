#include "planner/io/plan_files/settings_file.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace furrow;

class TestSettingsFile : public QObject {
    Q_OBJECT
private slots:
    void badFilesAreRefused_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("what");
        QTest::newRow("a list") << QByteArray{"[1]"} << QByteArray{"not a JSON object"};
        QTest::newRow("cut off") << QByteArray{"{\"headland.width_m\": 12"}
                                 << QByteArray{"s.json, line 1, column 24: this is not JSON"};
        QTest::newRow("200,000 brackets")
            << QByteArray{"{\"route.order\": "} + QByteArray(100'000, '[') + QByteArray(100'000, ']') + "}"
            << QByteArray{"s.json, line 1, column 116: lists and objects lie too deep"};
        QTest::newRow("200,000 objects")
            << QByteArray("{\"route\": ").repeated(100'000) + "1" + QByteArray(100'000, '}')
            << QByteArray{"too deep"};
        QTest::newRow("the same key twice")
            << QByteArray{R"({"headland.passes": 2, "headland.passes": 3})"} << QByteArray{"twice"};
        QTest::newRow("text of a list that is no UTF-8")
            << QByteArray{"{\"route.order\": [\"\\ud800\"]}"} << QByteArray{"not JSON"};
    }
    void badFilesAreRefused() {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, what);
        Settings settings;
        const auto applied = applySettingsJson(settings, text.toStdString(), "s.json");
        QVERIFY(!applied.has_value());
        QVERIFY(applied.error().code == ErrorCode::InputRefused);
        QVERIFY2(applied.error().line().contains(what.toStdString()), applied.error().line().c_str());
    }
    // Brackets in a text are no lists.
    void bracketsInTextsAreText() {
        Settings settings;
        const std::string text = "{\"swaths.rows\": \"" + std::string(1000, '[') + "\\\"{{{\"}";
        VERIFY_RESULT(applySettingsJson(settings, text, "s.json"));
    }
};

FURROW_TEST(TestSettingsFile);
#include "tst_settings_file.moc"
