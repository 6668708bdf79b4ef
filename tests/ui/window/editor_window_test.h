#pragma once

#include "tests/support/patience.h"
#include "tests/ui/window/window_test.h"

namespace furrow::test {

/// Begins with a field that is drawn. Goes on only with one: what follows looks at it.
#define DRAW_FIELD()                                                   \
    drawField();                                                       \
    if (QTest::currentTestFailed() || !session_->shown()->hasPlan()) { \
        return;                                                        \
    }

/// Drawing and changing a field in the whole window.
class EditorWindowTest : public WindowTest {
    Q_OBJECT

protected:
    const FieldSource& source() const { return *session_->document()->project()->field()->source; }
    /// What there is now is planned, and drawn.
    void ready() const {
        QTRY_VERIFY_WITH_TIMEOUT(
            session_->shown()->plan() && !session_->shown()->isDraft() && !session_->shown()->isBehind() &&
                session_->shown()->plan()->request.settings == session_->planning()->settings() &&
                session_->shown()->plan()->request.machine == session_->planning()->machine()->machine() &&
                isFinished(session_->planning()->state()),
            kPatienceMs);
    }
    std::size_t steps() const { return session_->document()->history().steps.size(); }
    QPoint middle() const { return middleOf(*map()); }
    /// 400 by 300 pixels around the middle of the map.
    void drawField(double zoom = 16.0) {
        camera()->centreOn(QGeoCoordinate{58.2515, 22.5035}, zoom, false);
        key(Qt::Key_B);
        QTRY_VERIFY(item(QStringLiteral("drawingHint"))->isVisible());
        for (const QPoint corner :
             {QPoint{-200, -150}, QPoint{200, -150}, QPoint{200, 150}, QPoint{-200, 150}}) {
            clickAt(middle() + corner);
        }
        key(Qt::Key_Return);
        QTRY_VERIFY(session_->farm()->hasField());
        ready();
    }
    QPoint cornerOnMap(std::size_t vertex) const {
        const GeoPoint place = source().parts.front().outer[vertex];
        return onMap(QGeoCoordinate{place.latDeg, place.lonDeg});
    }
    /// Types into a field over all that is there.
    void enter(const QString& field, const QString& text) {
        click(field);
        QTRY_VERIFY(item(field)->hasActiveFocus());
        key(Qt::Key_A, Qt::ControlModifier);
        type(text);
        key(Qt::Key_Return);
    }
    /// The next point of what is drawn, by numbers.
    void enterWay(const QString& length, const QString& bearing) {
        const int before = editor()->sketchCount();
        item(QStringLiteral("sketch.length"))->forceActiveFocus(Qt::TabFocusReason);
        key(Qt::Key_A, Qt::ControlModifier);
        type(length);
        key(Qt::Key_Tab);
        QTRY_VERIFY(item(QStringLiteral("sketch.bearing"))->hasActiveFocus());
        key(Qt::Key_A, Qt::ControlModifier);
        type(bearing);
        key(Qt::Key_Return);
        QTRY_COMPARE(editor()->sketchCount(), before + 1);
    }
    bool shows(const QString& name) const { return item(name) != nullptr && item(name)->isVisible(); }
};

}  // namespace furrow::test
