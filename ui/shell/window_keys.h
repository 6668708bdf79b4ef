#pragma once

#include <QtQml/qqmlregistration.h>
#include <QObject>
#include <QPointer>
#include <QQuickWindow>

namespace furrow {

/// Keys that mean the same everywhere in a window: Return presses the button that has the keyboard, as Space
/// does, and undo and redo go to the work where the text field that has it has nothing to take back.
class WindowKeys : public QObject {
    Q_OBJECT
    QML_ELEMENT
    Q_PROPERTY(QQuickWindow* window READ window WRITE setWindow NOTIFY windowChanged REQUIRED FINAL)

public:
    explicit WindowKeys(QObject* parent = nullptr) : QObject{parent} {}

    QQuickWindow* window() const { return window_; }
    void setWindow(QQuickWindow* window);

signals:
    void windowChanged();

private:
    bool eventFilter(QObject* watched, QEvent* event) override;

    QPointer<QQuickWindow> window_;
};

}  // namespace furrow
