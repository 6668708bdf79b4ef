#include "tests/support/patience.h"
#include "tests/support/test_program.h"
#include "tests/ui/window/editor_window_test.h"
#include "ui/text/display.h"

#include <QColor>

#include <QSet>

#include <memory>
#include <vector>

using namespace furrow;

/// What is selected stands out on the map, and what the map shows of the rest.
class TestSelectionWindow : public test::EditorWindowTest {
    Q_OBJECT

private:
    QPoint onMap(const Plan& plan, Point place) const {
        const GeoPoint geo = plan.field().frame().toGeo(place);
        return EditorWindowTest::onMap(QGeoCoordinate{geo.latDeg, geo.lonDeg});
    }
    /// How far a colour is from grey: of lines, not of the ground.
    static int strength(const QColor& color) {
        return std::max({color.red(), color.green(), color.blue()}) -
               std::min({color.red(), color.green(), color.blue()});
    }
    /// The strongest colour around a place.
    int strongestAt(const QImage& image, QPoint place) const {
        int most = 0;
        for (int dx = -2; dx <= 2; ++dx) {
            for (int dy = -2; dy <= 2; ++dy) {
                most = std::max(most, strength(image.pixelColor(place + QPoint{dx, dy})));
            }
        }
        return most;
    }

private slots:
    void aSelectedSwathStandsOut() {
        drawField(18.0);
        QVERIFY(session_->shown()->hasPlan());
        const std::shared_ptr<const Plan> held = session_->shown()->plan();
        const Plan& plan = *held;
        const auto isSwath = [](const PathSegment& each) { return each.kind == SegmentKind::Swath; };
        std::vector<const PathSegment*> swaths;
        for (const PathSegment& each : plan.path.segments) {
            if (isSwath(each)) {
                swaths.push_back(&each);
            }
        }
        const PathSegment& chosen = *swaths[swaths.size() / 3];
        const PathSegment& other = *swaths[swaths.size() * 2 / 3];
        const auto middleOf = [&](const PathSegment& each) {
            // Away from the numbers and the arrows.
            const Point from = each.samples.front().position;
            const Point to = each.samples.back().position;
            return onMap(plan, from + 0.37 * (to - from));
        };
        const QImage before = window_->grabWindow();
        clickAt(middleOf(chosen));
        QTRY_VERIFY(editor()->selectedSegment() >= 0);
        QCOMPARE(plan.path.segments[static_cast<std::size_t>(editor()->selectedSegment())].number,
                 chosen.number);
        QTest::mouseMove(window_, middle() + QPoint{0, 260});
        QTRY_VERIFY_WITH_TIMEOUT(strongestAt(window_->grabWindow(), middleOf(other)) <
                                     strongestAt(before, middleOf(other)) * 2 / 3,
                                 5000);
        const QImage after = window_->grabWindow();
        QVERIFY(strongestAt(after, middleOf(chosen)) >= strongestAt(before, middleOf(chosen)));
        // 4 pixels of it and a halo on both sides.
        int wide = 0;
        for (int d = -8; d <= 8; ++d) {
            const Point way = chosen.samples.back().position - chosen.samples.front().position;
            const bool steep = std::abs(way.y) > std::abs(way.x);
            const QPoint at = middleOf(chosen) + (steep ? QPoint{d, 0} : QPoint{0, d});
            wide += strength(after.pixelColor(at)) > 90 ? 1 : 0;
        }
        QVERIFY2(wide >= 3 && wide <= 7, qPrintable(QString::number(wide)));
        picture(QStringLiteral("selected_swath"));
        key(Qt::Key_Escape);
        QCOMPARE(editor()->selectedSegment(), -1);
        QTRY_VERIFY(strongestAt(window_->grabWindow(), middleOf(other)) >=
                    strongestAt(before, middleOf(other)) - 12);
    }
    // Zoomed out, swaths are an area without a pattern: what lies on a line is as strong as what lies beside.
    void farAwaySwathsAreAnArea() {
        DRAW_FIELD();
        const QPoint at = middle();
        camera()->centreOn(QGeoCoordinate{58.2515, 22.5035}, 13.2, false);
        camera()->zoomBy(-3);
        QTRY_VERIFY(camera()->zoomLevel() < 13.5);
        QTest::mouseMove(window_, at + QPoint{0, 200});
        const auto spread = [&] {
            const QImage image = window_->grabWindow();
            int least = 255;
            int most = 0;
            for (int d = -6; d <= 6; ++d) {
                const int blue = image.pixelColor(at + QPoint{d, d / 2}).red();
                least = std::min(least, blue);
                most = std::max(most, blue);
            }
            return most - least;
        };
        QTRY_VERIFY2_WITH_TIMEOUT(spread() < 12, qPrintable(QString::number(spread())), 5000);
        picture(QStringLiteral("far_away"));
    }
    void keysWorkEverywhere() {
        DRAW_FIELD();
        const std::size_t before = steps();
        // Return presses the button that has the keyboard.
        QQuickItem* button = item(QStringLiteral("stepsSwitch"));
        button->forceActiveFocus(Qt::TabFocusReason);
        QVERIFY(item(QStringLiteral("stepsPanel"))->isVisible());
        key(Qt::Key_Return);
        QTRY_VERIFY(!item(QStringLiteral("stepsPanel"))->isVisible());
        key(Qt::Key_Return);
        QTRY_VERIFY(item(QStringLiteral("stepsPanel"))->isVisible());
        // Undo is the work's while a number has the keyboard and nothing was typed.
        click(QStringLiteral("step.machine"));
        QTRY_VERIFY(shows(QStringLiteral("machine.library")));
        QQuickItem* number = item(QStringLiteral("machine.operating_width_m"));
        QVERIFY(number != nullptr);
        number->forceActiveFocus(Qt::TabFocusReason);
        QVERIFY(number->hasActiveFocus());
        key(Qt::Key_Z, Qt::ControlModifier);
        QTRY_COMPARE(session_->document()->history().steps.size(), before);
        QTRY_VERIFY(!session_->farm()->hasField());
        key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_VERIFY(session_->farm()->hasField());
    }
    void menusByKeys() {
        key(Qt::Key_F10);
        QTRY_VERIFY(shows(QStringLiteral("command.new.item")));
        picture(QStringLiteral("menu_by_keys"));
        key(Qt::Key_Escape);
        QTRY_VERIFY(!shows(QStringLiteral("command.new.item")));
        key(Qt::Key_V, Qt::AltModifier);
        QTRY_VERIFY(shows(QStringLiteral("command.preferences.item")));
        // The layers stand in a menu of their own.
        QVERIFY(!shows(QStringLiteral("command.layer.swaths.item")));
        key(Qt::Key_Escape);
    }
    /// An entry's letter is its own, in every language; groups stand apart.
    void menusByLetters() {
        DRAW_FIELD();
        key(Qt::Key_H, Qt::AltModifier);
        QTRY_VERIFY(shows(QStringLiteral("command.guide.item")));
        QCOMPARE(item(QStringLiteral("command.guide.item"))->property("letter").toString(),
                 QStringLiteral("g"));
        QVERIFY(item(QStringLiteral("command.trouble.item"))->property("ruled").toBool());
        QVERIFY(item(QStringLiteral("command.trouble.item"))->height() >
                item(QStringLiteral("command.keys.item"))->height());
        waitForRest(*item(QStringLiteral("command.trouble.item")));
        QTest::qWait(300);
        picture(QStringLiteral("menu_letters"));
        key(Qt::Key_G);
        QTRY_VERIFY(shows(QStringLiteral("guidePanel")));
        QVERIFY(!shows(QStringLiteral("command.guide.item")));
        key(Qt::Key_Escape);
        QTRY_VERIFY(!shows(QStringLiteral("guidePanel")));
        // Into a menu of a menu, and its first entry.
        key(Qt::Key_V, Qt::AltModifier);
        QTRY_VERIFY(shows(QStringLiteral("command.preferences.item")));
        key(Qt::Key_W);
        QTRY_VERIFY(shows(QStringLiteral("command.layer.imagery.item")));
        picture(QStringLiteral("menu_of_a_menu"));
        key(Qt::Key_Escape);
        key(Qt::Key_Escape);
        QTRY_VERIFY(!shows(QStringLiteral("command.preferences.item")));
        for (const char* language : {"en", "de", "fr"}) {
            furrow::Display::instance().force(QString::fromLatin1(language), furrow::Display::Metric);
            key(Qt::Key_F10);
            QTRY_VERIFY(shows(QStringLiteral("command.new.item")));
            for (const char* first : {"new", "undo", "draw", "addPlan", "fit", "guide"}) {
                const QString name = QStringLiteral("command.%1.item").arg(QLatin1String{first});
                QTRY_VERIFY(shows(name));
                QSet<QString> letters;
                int entries = 0;
                int without = 0;
                for (const QQuickItem* entry : item(name)->parentItem()->childItems()) {
                    if (const QVariant letter = entry->property("letter"); letter.isValid()) {
                        ++entries;
                        without += letter.toString().isEmpty() ? 1 : 0;
                        letters << letter.toString();
                    }
                }
                QVERIFY(entries > 3);
                // In a long menu the letters may run out for the last ones.
                letters.remove(QString{});
                QVERIFY2(letters.size() + without == entries && without <= 4, language);
                key(Qt::Key_Right);
            }
            key(Qt::Key_Escape);
            QTRY_VERIFY(!shows(QStringLiteral("command.new.item")));
        }
        furrow::Display::instance().force(QStringLiteral("en"), furrow::Display::Metric);
    }
};

FURROW_TEST_WITH(TestSelectionWindow, QGuiApplication);
#include "tst_selection_window.moc"
