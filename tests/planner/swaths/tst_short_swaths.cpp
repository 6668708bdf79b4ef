#include "planner/swaths/short_swaths.h"

#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/stages.h"
#include "tests/support/test_program.h"

using namespace furrow;

class ShortSwathsTest : public QObject {
    Q_OBJECT

private slots:
    void autoIsTheImplementsLength() {
        Settings settings;
        COMPARE_WITHIN(minSwathLength(settings, test::agbot()).si(),
                       test::agbot().spec().implement.length.si(), 0.0);
        settings.setText(kMinLength, "3.5").value();
        COMPARE_WITHIN(minSwathLength(settings, test::agbot()).si(), 3.5, 0.0);
    }

    // Four swaths of 100 m and, on a step of 0.5 m, one of that length: it goes, and with it 1.25 m².
    void aShortSwathIsLeftOut() {
        const MultiPolygon mainland{
            {.outer = {{0, 0}, {100, 0}, {100, 10}, {0.5, 10}, {0.5, 12.5}, {0, 12.5}}, .holes = {}}};
        SwathSet set = test::swathsOf(mainland, 2.5, 0.0);
        QCOMPARE(set.swaths.size(), std::size_t{5});
        COMPARE_WITHIN(set.coverage, 1.0, 1e-9);
        const std::vector<bool> areShort = shortOnes(set, metres(0.6));
        QCOMPARE(areShort, (std::vector<bool>{false, false, false, false, true}));
        VERIFY_RESULT(leaveOut(areShort, metres(0.6), mainland, set, {}));
        QCOMPARE(set.swaths.size(), std::size_t{4});
        COMPARE_WITHIN(set.totalLength.si(), 400.0, 1e-9);
        COMPARE_WITHIN(set.coverage, 1000.0 / 1001.25, 1e-9);
        QCOMPARE(set.notes.size(), std::size_t{1});
        QCOMPARE(set.notes.front().text, "1 swath shorter than 0.60 m is left out");
        QCOMPARE(set.notes.front().where, std::string{"swaths.min_length_m"});
    }

    // On 4 m two swaths of 2.5 m share 1 m: where one goes, nothing is worked twice and 1.5 m are missed.
    void whatWasWorkedTwiceIsWorkedOnce() {
        const MultiPolygon mainland{test::rectangle(1.0, 4.0)};
        SwathSet set = test::swathsOf(mainland, 2.5, 0.0);
        QCOMPARE(set.swaths.size(), std::size_t{2});
        COMPARE_WITHIN(set.overlap.si(), 1.0, 1e-9);
        VERIFY_RESULT(leaveOut({false, true}, metres(2.0), mainland, set, {}));
        COMPARE_WITHIN(set.coverage, 2.5 / 4.0, 1e-6);
        COMPARE_WITHIN(set.overlap.si(), 0.0, 1e-6);
    }

    // Nothing better exists than what there is.
    void whereAllAreShortAllStay() {
        const SwathSet set = test::swathsOf({test::rectangle(1.0, 4.0)}, 2.5, 0.0);
        QCOMPARE(shortOnes(set, metres(2.0)), (std::vector<bool>{false, false}));
    }
};

FURROW_TEST(ShortSwathsTest);
#include "tst_short_swaths.moc"
