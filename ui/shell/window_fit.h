#pragma once

#include <QtQml/qqmlregistration.h>
#include <QMargins>
#include <QObject>
#include <QPointer>
#include <QRect>
#include <QWindow>

namespace furrow {

/// A window's contents where they are wanted if the window then lies on the screen with its frame, otherwise
/// smaller and moved as far as needed.
QRect fitted(const QRect& wanted, const QRect& available, const QMargins& frame);

/// Keeps a window on the screen that it starts on, whatever it was on before: a larger one, one that is gone,
/// or the same one when everything was drawn smaller.
class WindowFit : public QObject {
    Q_OBJECT
    QML_ELEMENT
    Q_PROPERTY(QWindow* window READ window WRITE setWindow NOTIFY windowChanged REQUIRED FINAL)
    /// What there is for the window's contents: the screen without bars of the desktop and the frame.
    Q_PROPERTY(QSize room READ room NOTIFY roomChanged FINAL)

public:
    explicit WindowFit(QObject* parent = nullptr) : QObject{parent} {}

    QWindow* window() const { return window_; }
    void setWindow(QWindow* window);
    QSize room() const;

    /// Puts the window where it fits, now and when its frame is known or the screen becomes another.
    Q_INVOKABLE void begin();

signals:
    void windowChanged();
    void roomChanged();

private:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void followScreen();
    void fit();

    QPointer<QWindow> window_;
    /// As fitted last: what differs from it was chosen since.
    QRect fitted_;
    bool begun_ = false;
    bool frameKnown_ = false;
    QMetaObject::Connection screen_;
};

}  // namespace furrow
