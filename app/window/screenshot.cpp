#include "app/window/screenshot.h"

#include "ui/shell/session.h"

#include <QCoreApplication>
#include <QImage>
#include <QQuickWindow>
#include <QTimer>

#include <cstdio>

namespace furrow {

void saveScreenshotWhenReady(QQuickWindow& window, Session& session, const QString& file) {
    // Frames in a row without work: motions and the world's outline have then settled.
    constexpr int kQuietTicks = 15;
    auto* timer = new QTimer{&window};
    timer->setInterval(40);
    QObject::connect(timer, &QTimer::timeout, &window, [&window, &session, file, timer, quiet = 0]() mutable {
        const PlanState state = session.planning()->state();
        const bool working = state == PlanState::Planning || state == PlanState::Reading ||
                             !session.imagery()->store().isIdle();
        quiet = working ? 0 : quiet + 1;
        if (quiet < kQuietTicks) {
            return;
        }
        timer->stop();
        const bool saved = window.grabWindow().save(file);
        if (!saved) {
            std::fprintf(stderr, "furrow: %s cannot be written\n", qPrintable(file));
        }
        QCoreApplication::exit(saved ? 0 : 1);
    });
    timer->start();
}

}  // namespace furrow
