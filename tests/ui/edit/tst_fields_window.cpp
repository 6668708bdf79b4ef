#include "tests/support/patience.h"
#include "tests/support/test_program.h"
#include "tests/ui/window/editor_window_test.h"

#include <algorithm>

using namespace furrow;
using namespace furrow::test;

/// Fields and choices of the panels: what is refused, what is taken back, and where the keys are.
class TestFieldsWindow : public EditorWindowTest {
    Q_OBJECT

private slots:
    /// In a field with a number: first what was typed goes, then what was done.
    void undoInAFieldIsThatOfTheWork() {
        DRAW_FIELD();
        click(QStringLiteral("step.headland"));
        const QString field = QStringLiteral("headland.passes");
        const auto text = [this, &field] { return item(field)->property("text").toString(); };
        const std::size_t begun = steps();
        enter(field, QStringLiteral("3"));
        QTRY_COMPARE(steps(), begun + 1);
        key(Qt::Key_A, Qt::ControlModifier);
        type(QStringLiteral("4"));
        key(Qt::Key_Return);
        QTRY_COMPARE(steps(), begun + 2);
        QVERIFY(item(field)->hasActiveFocus());
        key(Qt::Key_Z, Qt::ControlModifier);
        QTRY_COMPARE(text(), QStringLiteral("3"));
        QCOMPARE(session_->document()->history().done, begun + 1);
        // What is not taken over yet goes alone.
        key(Qt::Key_A, Qt::ControlModifier);
        type(QStringLiteral("17"));
        key(Qt::Key_Z, Qt::ControlModifier);
        QTRY_COMPARE(text(), QStringLiteral("3"));
        QCOMPARE(session_->document()->history().done, begun + 1);
        key(Qt::Key_Z, Qt::ControlModifier);
        QTRY_COMPARE(session_->document()->history().done, begun);
        QTRY_COMPARE(text(), QString{});
        // Leaving the field changes nothing.
        key(Qt::Key_Tab);
        QTRY_VERIFY(!item(field)->hasActiveFocus());
        QCOMPARE(session_->document()->history().done, begun);
        QCOMPARE(steps(), begun + 2);
    }
    void aCardWithoutButtonsEndsWithItsText() {
        DRAW_FIELD();
        click(QStringLiteral("step.route"));
        enter(QStringLiteral("route.first"), QStringLiteral("999"));
        QTRY_VERIFY(shows(QStringLiteral("problemCard")));
        waitForRest(*item(QStringLiteral("problemCard")));
        picture(QStringLiteral("problem_without_buttons"));
        const QQuickItem& card = *item(QStringLiteral("problemCard"));
        const QQuickItem& remedy = *item(QStringLiteral("problemRemedy"));
        QVERIFY(remedy.isVisible());
        QCOMPARE(card.height() - remedy.mapToItem(&card, {0.0, remedy.height()}).y(), 16.0);
    }
    void whatIsRefusedCanBeRead_data() {
        QTest::addColumn<QString>("step");
        QTest::addColumn<QString>("field");
        QTest::addColumn<QString>("typed");
        QTest::newRow("machine") << "step.machine" << "machine.operating_width_m" << "abc";
        QTest::newRow("the last one") << "step.machine" << "machine.turning_speed_mps" << "-3";
        QTest::newRow("headland") << "step.headland" << "headland.passes" << "99999";
        QTest::newRow("part of a pass") << "step.headland" << "headland.passes" << "2.7";
        QTest::newRow("inspector") << "" << "inspector.number.0" << "abc";
    }
    void whatIsRefusedCanBeRead() {
        QFETCH(QString, step);
        QFETCH(QString, field);
        QFETCH(QString, typed);
        DRAW_FIELD();
        if (!step.isEmpty()) {
            click(step);
        } else {
            map()->forceActiveFocus();
            key(Qt::Key_E);
            QTRY_VERIFY(shows(QStringLiteral("inspector")));
        }
        click(field);
        QTRY_VERIFY(item(field)->hasActiveFocus());
        key(Qt::Key_A, Qt::ControlModifier);
        type(typed);
        const QString bubble = field + QStringLiteral(".complaint");
        QTRY_VERIFY(shows(bubble));
        waitForRest(*item(bubble));
        picture(QStringLiteral("refused_%1").arg(QString::fromUtf8(QTest::currentDataTag())));
        const QRectF place = item(bubble)->mapRectToScene({{}, item(bubble)->size()});
        QVERIFY(QRectF(0.0, 0.0, window_->width(), window_->height()).contains(place));
        QVERIFY(!place.intersects(item(field)->mapRectToScene({{}, item(field)->size()})));
        // Nothing lies over it.
        const QImage seen = window_->grabWindow();
        const auto left = static_cast<int>(place.left()) + 4;
        for (auto y = static_cast<int>(place.top()) + 8; y < static_cast<int>(place.bottom()) - 8; ++y) {
            QCOMPARE(seen.pixelColor(left, y), QColor(0xFD, 0xEC, 0xEA));
        }
        const std::size_t before = steps();
        key(Qt::Key_Return);
        QTRY_VERIFY(!shows(bubble));
        QCOMPARE(steps(), before);
    }
    void choosingKeepsTheKeys_data() {
        QTest::addColumn<QString>("step");
        QTest::addColumn<QString>("field");
        QTest::newRow("machine") << "step.machine" << "machine.library";
        QTest::newRow("headland") << "step.headland" << "headland.method";
        QTest::newRow("heading") << "step.swaths" << "swaths.method";
        QTest::newRow("blocks") << "step.decomposition" << "decomposition.method";
        QTest::newRow("order") << "step.route" << "route.method";
        QTest::newRow("turns") << "step.path" << "path.method";
    }
    void choosingKeepsTheKeys() {
        QFETCH(QString, step);
        QFETCH(QString, field);
        DRAW_FIELD();
        click(step);
        bringIntoView(field);
        item(field)->forceActiveFocus(Qt::TabFocusReason);
        const int first = item(field)->property("currentIndex").toInt();
        const int count = item(field)->property("count").toInt();
        for (int chosen = first + 1; chosen < std::min(first + 3, count); ++chosen) {
            key(Qt::Key_Down);
            QTRY_COMPARE(item(field)->property("currentIndex").toInt(), chosen);
            QVERIFY(item(field)->hasActiveFocus());
            QTRY_VERIFY(session_->planning()->state() != PlanState::Planning);
            nextFrame();
            QVERIFY(item(field)->hasActiveFocus());
            QCOMPARE(item(field)->property("currentIndex").toInt(), chosen);
        }
    }
};

FURROW_TEST_WITH(TestFieldsWindow, QGuiApplication);
#include "tst_fields_window.moc"
