#include "tests/support/test_program.h"
#include "ui/map/finding_marks.h"

#include <QTest>

using namespace furrow;

namespace {

/// One pixel for each unit, the origin in the upper left corner.
PlanView view() {
    return {.matrix = {},
            .visible = QRectF{0.0, 0.0, 500.0, 500.0},
            .size = {500.0, 500.0},
            .pixelsPerUnit = 1.0,
            .devicePixelRatio = 1.0};
}

PlanGeometry with(std::initializer_list<FindingPlace> findings) {
    PlanGeometry geometry;
    geometry.findings = findings;
    return geometry;
}

}  // namespace

class TestFindingMarks : public QObject {
    Q_OBJECT

private slots:
    void neighboursShareAMark() {
        const PlanGeometry geometry = with({{{100.0F, 100.0F}, Weight::Blocks},
                                            {{110.0F, 100.0F}, Weight::Look},
                                            {{105.0F, 108.0F}, Weight::Look},
                                            {{300.0F, 100.0F}, Weight::Look}});
        const auto marks = findingMarks(geometry, view(), -1);
        QCOMPARE(marks.size(), std::size_t{2});
        QCOMPARE(marks[0].finding, 0);
        QCOMPARE(marks[0].more, 2);
        QCOMPARE(marks[1].finding, 3);
        QCOMPARE(marks[1].more, 0);
        // Closer, each has its own.
        PlanView near = view();
        near.pixelsPerUnit = 4.0;
        near.visible = {0.0, 0.0, 125.0, 125.0};
        QCOMPARE(findingMarks(geometry, near, -1).size(), std::size_t{3});
    }
    void theSelectedOneStandsForItsNeighbours() {
        const PlanGeometry geometry =
            with({{{100.0F, 100.0F}, Weight::Blocks}, {{110.0F, 100.0F}, Weight::Look}});
        const auto marks = findingMarks(geometry, view(), 1);
        QCOMPARE(marks.size(), std::size_t{1});
        QCOMPARE(marks[0].finding, 1);
        QCOMPARE(marks[0].more, 1);
        QCOMPARE(marks[0].middle, QPointF(110.0, 100.0));
    }
    void startAndEndAreNotHidden() {
        PlanGeometry geometry = with({{{200.0F, 200.0F}, Weight::Look}});
        geometry.start = MapPoint{203.0F, 201.0F};
        const auto marks = findingMarks(geometry, view(), -1);
        QCOMPARE(marks.size(), std::size_t{1});
        QCOMPARE(marks[0].middle, QPointF(203.0, 201.0 - 23.0));
        // It is pressed where it is seen.
        QCOMPARE(findingAt(marks, {203.0, 178.0}), 0);
        QCOMPARE(findingAt(marks, {203.0, 201.0}), -1);
    }
    void whatIsJustSoIsMarkedOnlyWhileSelected() {
        const PlanGeometry geometry =
            with({{{100.0F, 100.0F}, Weight::Look}, {{300.0F, 300.0F}, Weight::Information}});
        QCOMPARE(findingMarks(geometry, view(), -1).size(), std::size_t{1});
        QCOMPARE(findingMarks(geometry, view(), 1).size(), std::size_t{2});
    }
    void whatIsOutOfViewHasNone() {
        QVERIFY(findingMarks(with({{{700.0F, 100.0F}, Weight::Blocks}}), view(), 0).empty());
    }
};

FURROW_TEST(TestFindingMarks);
#include "tst_finding_marks.moc"
