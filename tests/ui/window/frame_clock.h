#pragma once

#include "tests/ui/window/next_frame.h"

#include <QElapsedTimer>
#include <QQuickWindow>
#include <QString>
#include <QTest>

#include <algorithm>
#include <memory>
#include <mutex>
#include <vector>

namespace furrow::test {

/// How evenly frames come while something is dragged.
class FrameClock {
public:
    explicit FrameClock(QQuickWindow& window) : window_{window} {
        connection_ = QObject::connect(
            &window, &QQuickWindow::frameSwapped, &window,
            [seen = seen_] {
                // The thread that draws tells it, perhaps once more while the clock goes away.
                const std::scoped_lock lock{seen->mutex};
                if (seen->sinceLast.isValid()) {
                    seen->gapsMs.push_back(static_cast<double>(seen->sinceLast.nsecsElapsed()) / 1e6);
                }
                seen->sinceLast.start();
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
        NextFrame{window_}.wait(60);
    }
    std::size_t frames() const {
        const std::scoped_lock lock{seen_->mutex};
        return seen_->gapsMs.size();
    }
    QString text() const {
        const std::scoped_lock lock{seen_->mutex};
        return QStringLiteral(
                   "%1 moves in %2 ms; a move takes the window %3 ms, at most %4 ms; %5 frames, between them %6 ms, 95 % in %7 ms, at most %8 ms")
            .arg(handledMs_.size())
            .arg(whole_.elapsed())
            .arg(share(handledMs_, 0.5), 0, 'f', 1)
            .arg(share(handledMs_, 1.0), 0, 'f', 1)
            .arg(seen_->gapsMs.size())
            .arg(share(seen_->gapsMs, 0.5), 0, 'f', 1)
            .arg(share(seen_->gapsMs, 0.95), 0, 'f', 1)
            .arg(share(seen_->gapsMs, 1.0), 0, 'f', 1);
    }

private:
    struct Seen {
        std::mutex mutex;  ///< of the next two
        QElapsedTimer sinceLast;
        std::vector<double> gapsMs;
    };

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
    std::shared_ptr<Seen> seen_ = std::make_shared<Seen>();
    std::vector<double> handledMs_;
};

}  // namespace furrow::test
