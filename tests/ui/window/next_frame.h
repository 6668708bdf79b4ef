#pragma once

#include <QEventLoop>
#include <QQuickWindow>
#include <QTimer>

namespace furrow::test {

/// Waits for a frame that is drawn after this was made. The thread that draws tells of frames, so they are
/// handed on to this thread: a QSignalSpy would be called by that one while it goes away.
class NextFrame {
public:
    explicit NextFrame(QQuickWindow& window) {
        QObject::connect(
            &window, &QQuickWindow::frameSwapped, &loop_,
            [this] {
                came_ = true;
                loop_.quit();
            },
            Qt::QueuedConnection);
    }

    /// False if none came in this time.
    bool wait(int mostMs = 5000) {
        if (!came_) {
            QTimer::singleShot(mostMs, &loop_, &QEventLoop::quit);
            loop_.exec();
        }
        return came_;
    }

private:
    QEventLoop loop_;
    bool came_ = false;
};

}  // namespace furrow::test
