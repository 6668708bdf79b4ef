#pragma once

#include "planner/jobs/job.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

namespace furrow {

/// The calling thread, and those that it makes, give way to the window's: where the cores are few, frames go
/// on.
void giveWayToTheWindow();
/// Gives memory that is free by now back to the system: what a plan or a picture took for a moment would stay
/// with the threads that made it. Takes some milliseconds; for threads of work, when they have nothing to do.
void returnFreeMemory();
/// How long a thread of work is idle before it does so.
inline constexpr std::chrono::seconds kIdleBeforeReturning{2};

/// Runs one piece of work at a time on a thread of its own. Of the pieces that wait only the latest is kept.
class JobRunner : public QObject {
    Q_OBJECT

public:
    /// What is to be done in the GUI thread when the work has ended.
    using Delivery = std::function<void()>;
    using Work = std::function<Delivery(const JobContext&)>;

    enum class Replace {
        Now,       ///< the running piece is stopped and its result dropped
        WhenDone,  ///< the running piece ends first and is shown: while the user drags
    };

    explicit JobRunner(QObject* parent = nullptr);
    /// Stops what runs and waits for it. Says nothing of it.
    ~JobRunner() override;

    void submit(Work work, Replace replace = Replace::Now);
    /// For the running piece, from any thread of it: what is to be done in the GUI thread before it has
    /// ended. Nothing is, if the piece was stopped by then.
    void handOver(const JobContext& job, Delivery delivery);
    /// Stops what runs and forgets what waits.
    void cancel();

    /// Something runs or waits.
    bool isBusy() const { return busy_; }
    /// It has been so for long enough that the user should see it.
    bool isSlow() const { return slow_; }
    /// Share of the running piece, in [0, 1].
    double progress() const { return progress_.load(std::memory_order_relaxed); }

signals:
    void busyChanged();
    void slowChanged();
    void progressChanged();

private:
    void run(const std::stop_token& stop);
    void setBusy(bool busy);
    void setSlow(bool slow);

    std::mutex mutex_;
    std::condition_variable_any wake_;
    std::optional<Work> waiting_;
    /// Of the running piece.
    std::stop_source stopSource_;
    bool running_ = false;
    std::atomic<double> progress_ = 0.0;
    bool busy_ = false;
    bool slow_ = false;
    QTimer tick_;
    /// The last piece was delivered, or the first one submitted.
    QElapsedTimer since_;
    /// Last, so that it ends before anything it uses.
    std::jthread thread_;
};

}  // namespace furrow
