#include "planner/swaths/contour_lines.h"
#include "planner/swaths/guide_data.h"
#include "planner/swaths/methods.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/stages.h"
#include "tests/support/test_program.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

using namespace furrow;

namespace {

using Given = std::initializer_list<std::pair<const Parameter*, std::string>>;

Result<SwathSet> run(const Method<SwathGenerator>& method, const MultiPolygon& mainland,
                     const GuideData& guides, const Given& given) {
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

/// Six rows 3 m apart along x, from y = 0 to 15 and the fifth and sixth 6 m farther: a track lies between.
GuideData rows() {
    GuideData data;
    for (const double y : {0.0, 3.0, 6.0, 9.0, 18.0, 21.0}) {
        data.rows.push_back({{0.0, y}, {100.0, y}});
    }
    // As surveyed: out and back.
    std::ranges::reverse(data.rows[1]);
    std::ranges::reverse(data.rows[3]);
    return data;
}

std::multiset<double> northings(const SwathSet& set) {
    std::multiset<double> places;
    for (const Swath& swath : set.swaths) {
        places.insert(std::round(swath.start.y * 1e6) / 1e6);
    }
    return places;
}

ElevationGrid gridOf(Bounds box, double cellM, const std::function<double(Point)>& height) {
    ElevationGrid grid{.origin = box.min,
                       .cellM = cellM,
                       .columns = static_cast<std::size_t>(box.width() / cellM) + 2,
                       .rows = static_cast<std::size_t>(box.height() / cellM) + 2,
                       .heightsM = {}};
    for (std::size_t row = 0; row < grid.rows; ++row) {
        for (std::size_t column = 0; column < grid.columns; ++column) {
            grid.heightsM.push_back(
                height(grid.origin + cellM * Point{static_cast<double>(column), static_cast<double>(row)}));
        }
    }
    return grid;
}

}  // namespace

class RowsAndContoursTest : public QObject {
    Q_OBJECT

private slots:
    void rowsAreDriven_data() {
        QTest::addColumn<QString>("at");
        QTest::addColumn<QString>("skip");
        QTest::addColumn<QList<double>>("places");
        QTest::newRow("on them") << "on" << "" << QList<double>{0, 3, 6, 9, 18, 21};
        QTest::newRow("on them, but for two") << "on" << "2,5" << QList<double>{0, 6, 9, 21};
        // The track between the fourth and the fifth is no place to drive between two rows.
        QTest::newRow("between them") << "between" << "" << QList<double>{1.5, 4.5, 7.5, 19.5};
        QTest::newRow("between them, not left of the second")
            << "between" << "2" << QList<double>{1.5, 7.5, 19.5};
    }
    void rowsAreDriven() {
        QFETCH(QString, at);
        QFETCH(QString, skip);
        QFETCH(QList<double>, places);
        const auto set = run(kRowsMethod, {test::rectangle(80.0, 40.0, {10.0, -10.0})}, rows(),
                             {{&kRowsAt, at.toStdString()}, {&kSkipRows, skip.toStdString()}});
        VERIFY_RESULT(set);
        QCOMPARE(northings(*set), (std::multiset<double>{places.begin(), places.end()}));
        for (const Swath& swath : set->swaths) {
            // Cut to the mainland, and all the same way.
            COMPARE_WITHIN(swath.start.x, 10.0, 1e-6);
            COMPARE_WITHIN(swath.end.x, 90.0, 1e-6);
        }
        COMPARE_WITHIN(inDegrees(set->heading), 0.0, 1e-6);
    }

    void rowsNeedAFile() {
        const auto set = run(kRowsMethod, {test::rectangle(80.0, 40.0)}, {}, {});
        QVERIFY(!set);
        QCOMPARE(set.error().code, ErrorCode::Usage);
        QCOMPARE(set.error().where, std::string{"swaths.rows"});
    }

    void rowsOutsideAreRefused() {
        const auto set = run(kRowsMethod, {test::rectangle(80.0, 40.0, {1000.0, 1000.0})}, rows(), {});
        QVERIFY(!set);
        QCOMPARE(set.error().code, ErrorCode::InputRefused);
    }

    // On a cone the line of height h is a circle of radius 100 - h, uphill to its left: counter-clockwise.
    void contoursOfACone() {
        const ElevationGrid cone =
            gridOf({{-60.0, -60.0}, {60.0, 60.0}}, 1.0, [](Point p) { return 100.0 - norm(p); });
        const auto lines = contourLines(cone, 60.0);
        QCOMPARE(lines.size(), std::size_t{1});
        QCOMPARE(lines.front().front(), lines.front().back());
        for (const Point& point : lines.front()) {
            COMPARE_WITHIN(norm(point), 40.0, 0.01);
        }
        QVERIFY(signedAreaM2(lines.front()) > 0.0);
        COMPARE_WITHIN(heightAt(cone, {30.0, 0.0}).value(), 70.0, 1e-9);
        QVERIFY(!heightAt(cone, {61.5, 0.0}));
    }

    // On a plane every contour is a straight line; a saddle has two.
    void contoursOfAPlaneAndASaddle() {
        const ElevationGrid plane =
            gridOf({{-50.0, -50.0}, {50.0, 50.0}}, 2.0, [](Point p) { return 0.1 * p.y; });
        const auto level = contourLines(plane, 0.11);
        QCOMPARE(level.size(), std::size_t{1});
        for (const Point& point : level.front()) {
            COMPARE_WITHIN(point.y, 1.1, 1e-9);
        }
        QVERIFY(level.front().front().x < level.front().back().x);
        const ElevationGrid saddle =
            gridOf({{-50.0, -50.0}, {50.0, 50.0}}, 2.0, [](Point p) { return p.x * p.y; });
        QCOMPARE(contourLines(saddle, 1.0).size(), std::size_t{2});
    }

    void unknownHeightsStayUnknown() {
        ElevationGrid grid =
            gridOf({{0.0, 0.0}, {40.0, 40.0}}, 1.0, [](Point p) { return p.x < 10.0 ? std::nan("") : 5.0; });
        const ElevationGrid even = smoothed(grid, metres(4.0));
        for (std::size_t i = 0; i < grid.heightsM.size(); ++i) {
            QCOMPARE(std::isfinite(even.heightsM[i]), std::isfinite(grid.heightsM[i]));
            if (std::isfinite(even.heightsM[i])) {
                COMPARE_WITHIN(even.heightsM[i], 5.0, 1e-9);
            }
        }
    }

    // On a plane all of them are straight, level, and an operating width apart; on the slope of a cone they
    // bend with it.
    void swathsFollowTheContours() {
        GuideData guides;
        guides.elevation =
            gridOf({{-210.0, -110.0}, {210.0, 110.0}}, 5.0, [](Point p) { return 0.05 * (p.y + 0.2 * p.x); });
        const MultiPolygon mainland{test::centredRectangle(400.0, 200.0)};
        const auto plane = run(kContourMethod, mainland, guides, {});
        VERIFY_RESULT(plane);
        COMPARE_WITHIN(inDegrees(plane->heading), 180.0 - inDegrees(radians(std::atan(0.2))), 0.1);
        QVERIFY2(plane->coverage > 0.99, qPrintable(QString::number(plane->coverage)));
        QVERIFY2(plane->overlap < 0.02 * area(mainland), qPrintable(QString::number(plane->overlap.si())));

        guides.elevation = gridOf({{-210.0, -110.0}, {210.0, 110.0}}, 5.0,
                                  [](Point p) { return -0.05 * distance(p, {0.0, -600.0}); });
        const auto cone = run(kContourMethod, mainland, guides, {});
        VERIFY_RESULT(cone);
        QVERIFY2(cone->coverage > 0.985, qPrintable(QString::number(cone->coverage)));
        QVERIFY2(cone->overlap < 0.03 * area(mainland), qPrintable(QString::number(cone->overlap.si())));
        for (const Swath& swath : cone->swaths) {
            // Swaths run within 1 m of one height: 5 cm for each metre of the slope.
            const double ends =
                std::abs(distance(swath.start, {0.0, -600.0}) - distance(swath.end, {0.0, -600.0}));
            QVERIFY2(ends < 2.0 * 2.5, qPrintable(QString::number(ends)));
        }
    }

    // Two slopes that meet in a hollow: no one family of lines follows both, and still nothing is left
    // between them.
    void hollowsGetContoursOfTheirOwn() {
        GuideData guides;
        guides.elevation = gridOf({{-210.0, -160.0}, {210.0, 160.0}}, 5.0,
                                  [](Point p) { return 0.08 * std::abs(p.x - 0.5 * p.y) + 0.04 * p.y; });
        const MultiPolygon mainland{test::centredRectangle(400.0, 300.0)};
        const auto set = run(kContourMethod, mainland, guides, {});
        VERIFY_RESULT(set);
        QVERIFY2(set->coverage > 0.95, qPrintable(QString::number(set->coverage)));
        QVERIFY2(set->overlap < 0.1 * area(mainland), qPrintable(QString::number(set->overlap.si())));
    }

    void contoursNeedHeights() {
        const auto set = run(kContourMethod, {test::rectangle(80.0, 40.0)}, {}, {});
        QVERIFY(!set);
        QCOMPARE(set.error().code, ErrorCode::Usage);
        QCOMPARE(set.error().where, std::string{"swaths.elevation"});
    }
};

FURROW_TEST(RowsAndContoursTest);
#include "tst_rows_and_contours.moc"
