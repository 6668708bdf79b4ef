#include "ui/jobs/job_runner.h"

#include "planner/jobs/wide_registers.h"

#include <QSignalBlocker>

#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <utility>

namespace furrow {

namespace {
/// What takes longer shows its progress.
constexpr int kSlowMs = 100;
/// Without a graphics card each frame takes time from the work whose progress it shows.
constexpr int kTickMs = 200;
}  // namespace

void giveWayToTheWindow() {
    constexpr int kNiceness = 10;
    // Linux counts niceness by thread. Where it is refused, work goes on as before.
    static_cast<void>(::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), kNiceness));
}

void returnFreeMemory() {
#ifdef __GLIBC__
    ::malloc_trim(0);
#endif
}

JobRunner::JobRunner(QObject* parent) : QObject{parent} {
    connect(&tick_, &QTimer::timeout, this, [this] {
        tick_.setInterval(kTickMs);
        if (since_.elapsed() >= kSlowMs) {
            setSlow(true);
        }
        emit progressChanged();
    });
    thread_ = std::jthread{[this](const std::stop_token& stop) { run(stop); }};
}

JobRunner::~JobRunner() {
    // Whoever listens may be half gone.
    const QSignalBlocker quiet{this};
    cancel();
    thread_.request_stop();
    wake_.notify_all();
}

void JobRunner::submit(Work work, Replace replace) {
    {
        const std::scoped_lock lock{mutex_};
        waiting_ = std::move(work);
        if (replace == Replace::Now) {
            stopSource_.request_stop();
        }
    }
    setBusy(true);
    wake_.notify_all();
}

void JobRunner::handOver(const JobContext& job, Delivery delivery) {
    QMetaObject::invokeMethod(
        this,
        [stop = job.stop, delivery = std::move(delivery)] {
            if (!stop.stop_requested()) {
                delivery();
            }
        },
        Qt::QueuedConnection);
}

void JobRunner::cancel() {
    {
        const std::scoped_lock lock{mutex_};
        waiting_.reset();
        stopSource_.request_stop();
    }
    setBusy(false);
}

void JobRunner::run(const std::stop_token& stop) {
    giveWayToTheWindow();
    bool worked = false;
    while (true) {
        Work work;
        std::stop_token jobStop;
        {
            std::unique_lock lock{mutex_};
            const auto isWaiting = [this] { return waiting_.has_value(); };
            if (std::exchange(worked, false) &&
                !wake_.wait_for(lock, stop, kIdleBeforeReturning, isWaiting)) {
                lock.unlock();
                returnFreeMemory();
                lock.lock();
            }
            if (!wake_.wait(lock, stop, isWaiting)) {
                return;
            }
            worked = true;
            work = std::move(*waiting_);
            waiting_.reset();
            running_ = true;
            stopSource_ = {};
            jobStop = stopSource_.get_token();
        }
        clearWideRegisters();
        progress_.store(0.0, std::memory_order_relaxed);
        // One core stays free for the window.
        const int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1);
        Delivery delivery =
            work({.stop = jobStop,
                  .progress = [this](double share) { progress_.store(share, std::memory_order_relaxed); },
                  .threads = threads});
        {
            const std::scoped_lock lock{mutex_};
            running_ = false;
        }
        QMetaObject::invokeMethod(
            this,
            [this, jobStop, delivery = std::move(delivery)] {
                // Checked here: the work may have been stopped after it had ended.
                if (!jobStop.stop_requested() && delivery) {
                    delivery();
                }
                since_.restart();
                setSlow(false);
                setBusy(false);
            },
            Qt::QueuedConnection);
    }
}

void JobRunner::setBusy(bool busy) {
    if (busy && !busy_) {
        since_.start();
        tick_.start(kSlowMs);
    }
    if (!busy) {
        const std::scoped_lock lock{mutex_};
        if (waiting_ || (running_ && !stopSource_.stop_requested())) {
            return;
        }
        tick_.stop();
    }
    if (busy != busy_) {
        busy_ = busy;
        if (!busy) {
            setSlow(false);
        }
        emit busyChanged();
    }
}

void JobRunner::setSlow(bool slow) {
    if (slow != slow_) {
        slow_ = slow;
        emit slowChanged();
    }
}

}  // namespace furrow
