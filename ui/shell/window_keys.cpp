#include "ui/shell/window_keys.h"

#include <QKeyEvent>
#include <QQuickItem>

namespace furrow {

namespace {

/// Menus and lists deal with Return themselves.
bool isPlainButton(const QQuickItem& item) {
    return item.inherits("QQuickAbstractButton") && !item.inherits("QQuickMenuItem") &&
           !item.inherits("QQuickMenuBarItem") && !item.inherits("QQuickItemDelegate");
}

/// A text field whose text is as it came. Our own fields say that themselves: to Qt, what was typed and taken
/// over can be taken back.
bool hasNothingToTakeBack(const QQuickItem& item, const QKeyEvent& key) {
    return (key.matches(QKeySequence::Undo) &&
            (item.property("canUndo") == QVariant{false} || item.property("edited") == QVariant{false})) ||
           (key.matches(QKeySequence::Redo) && item.property("canRedo") == QVariant{false});
}

}  // namespace

void WindowKeys::setWindow(QQuickWindow* window) {
    if (window == window_) {
        return;
    }
    if (window_) {
        window_->removeEventFilter(this);
    }
    window_ = window;
    if (window_) {
        window_->installEventFilter(this);
    }
    emit windowChanged();
}

bool WindowKeys::eventFilter(QObject* watched, QEvent* event) {
    // Nothing of a window that is going: it has no items any more.
    if (watched != window_ ||
        (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress)) {
        return false;
    }
    QQuickItem* focused = window_->activeFocusItem();
    if (focused == nullptr) {
        return false;
    }
    const auto& key = *static_cast<QKeyEvent*>(event);
    if (event->type() == QEvent::ShortcutOverride) {
        // A text field claims these keys even where it has no use for them.
        if (!hasNothingToTakeBack(*focused, key)) {
            return false;
        }
        event->ignore();
        return true;
    }
    const bool isReturn = key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter;
    return isReturn && !key.isAutoRepeat() && (key.modifiers() & ~Qt::KeypadModifier) == 0 &&
           isPlainButton(*focused) && focused->isEnabled() && QMetaObject::invokeMethod(focused, "click");
}

}  // namespace furrow
