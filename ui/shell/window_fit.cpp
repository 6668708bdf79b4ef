#include "ui/shell/window_fit.h"

#include <QEvent>
#include <QGuiApplication>
#include <QScreen>

#include <algorithm>

namespace furrow {

namespace {

/// The one with most of the place, or the first.
const QScreen* screenOf(const QRect& place) {
    const QScreen* best = QGuiApplication::primaryScreen();
    qint64 most = 0;
    for (const QScreen* screen : QGuiApplication::screens()) {
        const QRect seen = screen->availableGeometry().intersected(place);
        const qint64 area = seen.isEmpty() ? 0 : qint64{seen.width()} * seen.height();
        if (area > most) {
            most = area;
            best = screen;
        }
    }
    return best;
}

}  // namespace

QRect fitted(const QRect& wanted, const QRect& available, const QMargins& frame) {
    const QRect room = available.marginsRemoved(frame);
    const QSize size = wanted.size().boundedTo(room.size());
    return {std::clamp(wanted.x(), room.x(), room.x() + room.width() - size.width()),
            std::clamp(wanted.y(), room.y(), room.y() + room.height() - size.height()), size.width(),
            size.height()};
}

void WindowFit::setWindow(QWindow* window) {
    window_ = window;
    connect(window, &QWindow::screenChanged, this, &WindowFit::followScreen);
    followScreen();
    emit windowChanged();
}

QSize WindowFit::room() const {
    const QScreen* screen = window_ ? window_->screen() : nullptr;
    return screen == nullptr ? QSize{0, 0}
                             : screen->availableGeometry().marginsRemoved(window_->frameMargins()).size();
}

void WindowFit::begin() {
    begun_ = true;
    fit();
    window_->installEventFilter(this);
}

bool WindowFit::eventFilter(QObject* watched, QEvent* event) {
    // The system says how wide the frame is when the window is there.
    if (event->type() == QEvent::Expose && window_ && window_->isExposed() && !frameKnown_) {
        frameKnown_ = true;
        emit roomChanged();
        if (window_->geometry() == fitted_) {
            fit();
        }
    }
    return QObject::eventFilter(watched, event);
}

void WindowFit::followScreen() {
    disconnect(screen_);
    if (const QScreen* screen = window_ ? window_->screen() : nullptr) {
        screen_ = connect(screen, &QScreen::availableGeometryChanged, this, [this] {
            emit roomChanged();
            if (begun_) {
                fit();
            }
        });
    }
    emit roomChanged();
}

void WindowFit::fit() {
    if ((window_->windowStates() & (Qt::WindowMaximized | Qt::WindowFullScreen)) != 0) {
        return;
    }
    const QRect place = window_->geometry();
    fitted_ = fitted(place, screenOf(place)->availableGeometry(), window_->frameMargins());
    if (fitted_ != place) {
        window_->setGeometry(fitted_);
    }
}

}  // namespace furrow
