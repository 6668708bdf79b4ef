#include "planner/core/separated_text.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace furrow;

using Cells = std::vector<std::string>;
using Parts = std::vector<std::string_view>;

class SeparatedTextTest : public QObject {
    Q_OBJECT

private slots:
    void linesOfBothKinds() {
        std::string_view text = "a\r\nb\n\nc";
        QCOMPARE(nextLine(text), std::string_view{"a"});
        QCOMPARE(nextLine(text), std::string_view{"b"});
        QCOMPARE(nextLine(text), std::string_view{});
        QCOMPARE(nextLine(text), std::string_view{"c"});
        QVERIFY(text.empty());
    }

    void cellsBetweenSeparators() {
        QCOMPARE(cellsOf("", ','), (Parts{""}));
        QCOMPARE(cellsOf("1,,2,", ','), (Parts{"1", "", "2", ""}));
        QCOMPARE(cellsOf("1,2;3", ';'), (Parts{"1,2", "3"}));
    }

    // RFC 4180, section 2: rules 5 to 7.
    void quotesHoldTogether() {
        QCOMPARE(quotedCellsOf("1,\"a, b\",c", ','), (Cells{"1", "a, b", "c"}));
        QCOMPARE(quotedCellsOf("\"the \"\"long\"\" field\",2", ','), (Cells{"the \"long\" field", "2"}));
        QCOMPARE(quotedCellsOf("\"open, to the end", ','), (Cells{"open, to the end"}));
        QCOMPARE(quotedCellsOf("\"\"", ','), (Cells{""}));
        QCOMPARE(quotedCellsOf("1,2,3,4", ',', 2), (Cells{"1", "2"}));
    }
};

FURROW_TEST(SeparatedTextTest);
#include "tst_separated_text.moc"
