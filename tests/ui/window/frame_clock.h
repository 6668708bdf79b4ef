#pragma once

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QQuickWindow>
#include <QSignalSpy>
#include <QString>
#include <QTest>

#include <algorithm>
#include <mutex>
#include <vector>

namespace furrow::test {

/// How evenly frames come while something is dragged.
class FrameClock {
public:
    explicit FrameClock(QQuickWindow& window) : window_{window} {
        connection_ = QObject::connect(
            &window, &QQuickWindow::frameSwapped, &window,
            [this] {
                // The thread that draws tells it.
                const std::scoped_lock lock{mutex_};
                if (sinceLast_.isValid()) {
                    gapsMs_.push_back(static_cast<double>(sinceLast_.nsecsElapsed()) / 1e6);
                }
                sinceLast_.start();
            },
            Qt::DirectConnection);
        whole_.start();
    }
    ~FrameClock() { QObject::disconnect(connection_); }
    FrameClock(const FrameClock&) = delete;
    FrameClock& operator=(const FrameClock&) = delete;

    /// Moves the mouse and lets the window answer: a frame where one is due.
    void move(QPoint to) {
        QElapsedTimer own;
        own.start();
        QTest::mouseMove(&window_, to);
        handledMs_.push_back(static_cast<double>(own.nsecsElapsed()) / 1e6);
        QSignalSpy frame{&window_, &QQuickWindow::frameSwapped};
        QCoreApplication::processEvents(QEventLoop::AllEvents, 10);
        if (frame.isEmpty()) {
            frame.wait(50);
        }
    }
    std::size_t frames() const {
        const std::scoped_lock lock{mutex_};
        return gapsMs_.size();
    }
    QString text() const {
        const std::scoped_lock lock{mutex_};
        return QStringLiteral(
                   "%1 moves in %2 ms; a move takes the window %3 ms, at most %4 ms; %5 frames, between them %6 ms, 95 % in %7 ms, at most %8 ms")
            .arg(handledMs_.size())
            .arg(whole_.elapsed())
            .arg(share(handledMs_, 0.5), 0, 'f', 1)
            .arg(share(handledMs_, 1.0), 0, 'f', 1)
            .arg(gapsMs_.size())
            .arg(share(gapsMs_, 0.5), 0, 'f', 1)
            .arg(share(gapsMs_, 0.95), 0, 'f', 1)
            .arg(share(gapsMs_, 1.0), 0, 'f', 1);
    }

private:
    static double share(std::vector<double> values, double share) {
        if (values.empty()) {
            return 0.0;
        }
        std::ranges::sort(values);
        return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
    }

    QQuickWindow& window_;
    QMetaObject::Connection connection_;
    QElapsedTimer whole_;
    mutable std::mutex mutex_;  ///< of the next two
    QElapsedTimer sinceLast_;
    std::vector<double> gapsMs_;
    std::vector<double> handledMs_;
};

}  // namespace furrow::test
