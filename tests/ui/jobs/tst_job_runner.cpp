#include "tests/support/patience.h"
#include "tests/support/test_program.h"
#include "tests/support/upper_halves.h"
#include "ui/jobs/job_runner.h"

#include <QSignalSpy>
#include <QTest>

#include <atomic>
#include <chrono>

using namespace furrow;
using namespace std::chrono_literals;

namespace {

/// Works until it is told to stop, or until `release` is set.
JobRunner::Work blocking(std::atomic<bool>& release, std::atomic<int>& started, std::atomic<int>& delivered) {
    return [&](const JobContext& job) -> JobRunner::Delivery {
        ++started;
        while (!release && !job.stopRequested()) {
            std::this_thread::sleep_for(1ms);
        }
        return [&delivered] { ++delivered; };
    };
}

}  // namespace

class TestJobRunner : public QObject {
    Q_OBJECT

private slots:
    void deliversInTheGuiThread() {
        JobRunner runner;
        const QThread* gui = QThread::currentThread();
        const QThread* worker = nullptr;
        const QThread* delivered = nullptr;
        runner.submit([&](const JobContext&) -> JobRunner::Delivery {
            worker = QThread::currentThread();
            return [&] { delivered = QThread::currentThread(); };
        });
        QVERIFY(runner.isBusy());
        QTRY_VERIFY(delivered != nullptr);
        QCOMPARE(delivered, gui);
        QVERIFY(worker != gui);
        QTRY_VERIFY(!runner.isBusy());
    }
    // Objects that listen are taken down in any order.
    void endsWithoutASignal() {
        std::atomic<bool> release = false;
        std::atomic<int> started = 0;
        std::atomic<int> delivered = 0;
        int told = 0;
        {
            JobRunner runner;
            runner.submit(blocking(release, started, delivered));
            QTRY_COMPARE(started.load(), 1);
            for (const auto signal :
                 {&JobRunner::busyChanged, &JobRunner::slowChanged, &JobRunner::progressChanged}) {
                connect(&runner, signal, this, [&told] { ++told; });
            }
        }
        QCOMPARE(told, 0);
        QCOMPARE(delivered.load(), 0);
    }
    void latestWins() {
        JobRunner runner;
        std::atomic<bool> release = false;
        std::atomic<int> started = 0;
        std::atomic<int> dropped = 0;
        runner.submit(blocking(release, started, dropped));
        QTRY_COMPARE(started.load(), 1);
        int last = 0;
        for (int i = 1; i <= 20; ++i) {
            runner.submit(
                [&last, i](const JobContext&) -> JobRunner::Delivery { return [&last, i] { last = i; }; });
        }
        QTRY_COMPARE(last, 20);
        QCOMPARE(dropped.load(), 0);
    }
    void whileDraggingTheRunningOneIsShownFirst() {
        JobRunner runner;
        std::atomic<bool> release = false;
        std::atomic<int> started = 0;
        std::atomic<int> delivered = 0;
        int later = 0;
        runner.submit(blocking(release, started, delivered));
        QTRY_COMPARE(started.load(), 1);
        for (int i = 0; i < 5; ++i) {
            runner.submit(
                [&later](const JobContext&) -> JobRunner::Delivery { return [&later] { ++later; }; },
                JobRunner::Replace::WhenDone);
        }
        release = true;
        QTRY_COMPARE(later, 1);
        QCOMPARE(delivered.load(), 1);
    }
    void cancelAnswersAtOnce() {
        JobRunner runner;
        QSignalSpy busy{&runner, &JobRunner::busyChanged};
        std::atomic<bool> release = false;
        std::atomic<int> started = 0;
        std::atomic<int> delivered = 0;
        runner.submit(blocking(release, started, delivered));
        QTRY_COMPARE(started.load(), 1);
        runner.cancel();
        QVERIFY(!runner.isBusy());
        QCOMPARE(busy.count(), 2);
        // The next piece runs after the stopped one, whose result is dropped.
        bool done = false;
        runner.submit([&done](const JobContext&) -> JobRunner::Delivery { return [&done] { done = true; }; });
        QTRY_VERIFY(done);
        QCOMPARE(delivered.load(), 0);
    }
    void longWorkShowsItsProgress() {
        JobRunner runner;
        std::atomic<bool> release = false;
        runner.submit([&release](const JobContext& job) -> JobRunner::Delivery {
            job.report(0.4);
            while (!release && !job.stopRequested()) {
                std::this_thread::sleep_for(1ms);
            }
            return {};
        });
        QVERIFY(!runner.isSlow());
        QTRY_VERIFY(runner.isSlow());
        QCOMPARE(runner.progress(), 0.4);
        release = true;
        QTRY_VERIFY(!runner.isSlow());
        QVERIFY(!runner.isBusy());
    }
    /// Whatever the piece before, or the thread that made this one, left in them.
    void worksWithClearRegisters() {
        if (!test::canTellUpperHalves()) {
            QSKIP("the processor does not tell what of its registers is in use");
        }
        JobRunner runner;
        std::atomic<int> inUse = 0;
        int done = 0;
        const auto work = [&](const JobContext&) -> JobRunner::Delivery {
            inUse += test::areUpperHalvesInUse() ? 1 : 0;
            test::useUpperHalves();
            return [&done] { ++done; };
        };
        for (int i = 1; i <= 3; ++i) {
            runner.submit(work);
            QTRY_COMPARE(done, i);
        }
        QCOMPARE(inUse.load(), 0);
    }
    void endsWhileSomethingRuns() {
        std::atomic<bool> release = false;
        std::atomic<int> started = 0;
        std::atomic<int> delivered = 0;
        {
            JobRunner runner;
            runner.submit(blocking(release, started, delivered));
            QTRY_COMPARE(started.load(), 1);
        }
        QCoreApplication::processEvents();
        QCOMPARE(delivered.load(), 0);
    }
};

FURROW_TEST(TestJobRunner);
#include "tst_job_runner.moc"
