#include "planner/swaths/guide_data.h"
#include "planner/swaths/left_on_purpose.h"
#include "planner/swaths/methods.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/stages.h"
#include "tests/support/test_program.h"

#include <string>

using namespace furrow;

namespace {

using Given = std::initializer_list<std::pair<const Parameter*, std::string>>;

Result<SwathSet> run(const Method<SwathGenerator>& method, const MultiPolygon& mainland, const Given& given,
                     const GuideData& guides = {}) {
    Settings settings;
    for (const auto& [parameter, text] : given) {
        settings.setText(*parameter, text).value();
    }
    return method.run({.field = test::anyField(),
                       .mainland = mainland,
                       .machine = test::agbot(),
                       .settings = settings,
                       .guides = &guides},
                      {});
}

GuideData rowsAt(std::initializer_list<double> northings, double fromX, double toX) {
    GuideData data;
    for (const double y : northings) {
        data.rows.push_back({{fromX, y}, {toX, y}});
    }
    return data;
}

}  // namespace

class LeftOnPurposeTest : public QObject {
    Q_OBJECT

private slots:
    // 31 m hold twelve widths of 2.5 m and 1 m, which stays along one edge or both.
    void theGapOfARectangle() {
        const auto set = run(kFixedHeadingMethod, {test::rectangle(100.0, 31.0)}, {{&kLastPass, "gap"}});
        VERIFY_RESULT(set);
        QCOMPARE(set->swaths.size(), std::size_t{12});
        COMPARE_WITHIN((set->restRight + set->restLeft).si(), 1.0, 1e-9);
        COMPARE_WITHIN(area(set->leftOnPurpose).si(), 100.0, 1e-6);
    }

    // A parallelogram that leans over by 45 degrees: its ends are missed, not left; the strip of 1 m is.
    void endsOfSwathsAreNoGap() {
        const MultiPolygon slanted{{.outer = {{0, 0}, {100, 0}, {131, 31}, {31, 31}}, .holes = {}}};
        const auto set = run(kFixedHeadingMethod, slanted, {{&kLastPass, "gap"}});
        VERIFY_RESULT(set);
        COMPARE_WITHIN(area(set->leftOnPurpose).si(), 100.0, 1e-6);
    }

    void otherLastPassesLeaveNothing() {
        for (const char* lastPass : {"overlap", "spread"}) {
            const auto set =
                run(kFixedHeadingMethod, {test::rectangle(100.0, 31.0)}, {{&kLastPass, lastPass}});
            VERIFY_RESULT(set);
            QVERIFY(set->leftOnPurpose.empty());
        }
    }

    // Rows 4 m apart, between which a robot of 2.5 m drives: 1.5 m stays beside each row, and what is beyond
    // its lanes at both edges: from 0 to 2.75 and from 17.25 to 20 m.
    void alleysOfRows() {
        const auto set = run(kRowsMethod, {test::rectangle(80.0, 20.0)}, {{&kRowsAt, "between"}},
                             rowsAt({2.0, 6.0, 10.0, 14.0, 18.0}, -10.0, 100.0));
        VERIFY_RESULT(set);
        QCOMPARE(set->swaths.size(), std::size_t{4});
        QCOMPARE(set->leftOnPurpose.size(), std::size_t{5});
        COMPARE_WITHIN(area(set->leftOnPurpose).si(), 80.0 * (20.0 - 4.0 * 2.5), 1e-3);
    }

    // A row that ends 30 m inside: its lane goes on, what lies ahead of it is not left on purpose. A notch
    // from above ends the lane of the upper row: what lies behind it is nobody's lane.
    void lanesGoOnUntilTheyLeaveTheMainland() {
        const auto set = run(kRowsMethod, {test::rectangle(80.0, 20.0)}, {}, rowsAt({5.0, 15.0}, 0.0, 50.0));
        VERIFY_RESULT(set);
        COMPARE_WITHIN(area(set->leftOnPurpose).si(), 80.0 * 15.0, 1e-3);
        const MultiPolygon notched{
            {.outer = {{0, 0}, {80, 0}, {80, 20}, {70, 20}, {70, 10}, {60, 10}, {60, 20}, {0, 20}},
             .holes = {}}};
        const auto cut = run(kRowsMethod, notched, {}, rowsAt({5.0, 15.0}, 0.0, 50.0));
        VERIFY_RESULT(cut);
        COMPARE_WITHIN(area(cut->leftOnPurpose).si(), 80.0 * 20.0 - 100.0 - 80.0 * 2.5 - 60.0 * 2.5, 1e-3);
    }

    // Skipped rows stay with their lanes.
    void skippedRows() {
        const auto set = run(kRowsMethod, {test::rectangle(80.0, 20.0)}, {{&kSkipRows, "2"}},
                             rowsAt({5.0, 10.0, 15.0}, -5.0, 90.0));
        VERIFY_RESULT(set);
        COMPARE_WITHIN(area(set->leftOnPurpose).si(), 80.0 * 15.0, 1e-3);
    }

    void noRowIsLeft() {
        const MultiPolygon mainland{test::rectangle(80.0, 20.0)};
        const auto allSkipped =
            run(kRowsMethod, mainland, {{&kSkipRows, "1,2"}}, rowsAt({5.0, 10.0}, -5.0, 90.0));
        QVERIFY(!allSkipped);
        QCOMPARE(allSkipped.error().where.text(), std::string{kSkipRows.key});
        const auto elsewhere = run(kRowsMethod, mainland, {}, rowsAt({500.0, 505.0}, -5.0, 90.0));
        QVERIFY(!elsewhere);
        QCOMPARE(elsewhere.error().where.text(), std::string{kRows.key});
    }

    // Beside a straight guide the parallels of a curve leave what straight ones do.
    void theGapBesideACurve() {
        const Field& field = test::anyField();
        const Point corner = field.frame().toLocal({5.0, 52.0});
        const auto at = [&](double x, double y) { return corner + Point{x, y}; };
        const MultiPolygon mainland{{.outer = {at(0, 0), at(100, 0), at(100, 31), at(0, 31)}, .holes = {}}};
        const auto geo = [&](Point point) {
            const GeoPoint place = field.frame().toGeo(point);
            return QStringLiteral("%1 %2")
                .arg(place.lonDeg, 0, 'f', 12)
                .arg(place.latDeg, 0, 'f', 12)
                .toStdString();
        };
        // One lane lies on 4.6 m, so that they reach from 0.85 m to 29.6 + 1.25 m.
        const std::string line = "LINESTRING (" + geo(at(-10, 4.6)) + ", " + geo(at(110, 4.6)) + ")";
        const auto set = run(kAbCurveMethod, mainland, {{&kLine, line}, {&kLastPass, "gap"}});
        VERIFY_RESULT(set);
        QCOMPARE(set->swaths.size(), std::size_t{12});
        COMPARE_WITHIN(area(set->leftOnPurpose).si(), 100.0 * (31.0 - 12 * 2.5), 0.1);
    }
};

FURROW_TEST(LeftOnPurposeTest);
#include "tst_left_on_purpose.moc"
