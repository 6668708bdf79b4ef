#include "planner/jobs/parallel.h"
#include "planner/jobs/wide_registers.h"
#include "tests/support/test_program.h"
#include "tests/support/upper_halves.h"

#include <QTest>

#include <algorithm>
#include <atomic>
#include <stop_token>
#include <vector>

using namespace furrow;
using namespace furrow::test;

class TestParallel : public QObject {
    Q_OBJECT

    static void onThreads() {
        QTest::addColumn<int>("threads");
        for (const int threads : {0, 1, 2, 5}) {
            QTest::addRow("%d", threads) << threads;
        }
    }

private slots:
    void valuesAreInOrder_data() { onThreads(); }
    void valuesAreInOrder() {
        QFETCH(int, threads);
        const auto squares = parallelMap<std::size_t>(1000, [](std::size_t i) { return i * i; },
                                                      {.stop = {}, .progress = {}, .threads = threads});
        QVERIFY(squares);
        QCOMPARE(squares->size(), std::size_t{1000});
        for (std::size_t i = 0; i < squares->size(); ++i) {
            QCOMPARE((*squares)[i], i * i);
        }
    }
    void progressNeverGoesBack_data() { onThreads(); }
    void progressNeverGoesBack() {
        QFETCH(int, threads);
        std::vector<double> told;
        QVERIFY(parallelFor(
            357, [](std::size_t) {},
            {.stop = {}, .progress = [&told](double share) { told.push_back(share); }, .threads = threads}));
        QVERIFY(std::ranges::is_sorted(told));
        QCOMPARE(told.back(), 1.0);
        QVERIFY(told.size() <= 100);
    }
    void stopsWhenAsked_data() { onThreads(); }
    void stopsWhenAsked() {
        QFETCH(int, threads);
        std::stop_source source;
        std::atomic<std::size_t> run = 0;
        // More than there are threads.
        constexpr std::size_t kSome = 1000;
        const auto done = parallelFor(100'000,
                                      [&](std::size_t) {
                                          ++run;
                                          source.request_stop();
                                      },
                                      {.stop = source.get_token(), .progress = {}, .threads = threads});
        QVERIFY(!done);
        QCOMPARE(done.error().code, ErrorCode::Cancelled);
        QVERIFY(run.load() < kSome);
        QVERIFY(!parallelFor(1, [&](std::size_t) { run = kSome; },
                             {.stop = source.get_token(), .progress = {}, .threads = threads}));
        QVERIFY(run.load() < kSome);
    }
    void clearsWideRegisters() {
        if (!canTellUpperHalves()) {
            QSKIP("the processor does not tell what of its registers is in use");
        }
        useUpperHalves();
        const bool before = areUpperHalvesInUse();
        clearWideRegisters();
        const bool after = areUpperHalvesInUse();
        QVERIFY(before);
        QVERIFY(!after);
    }
    /// Whatever the threads that it is asked from and that it makes did before.
    void worksWithClearRegisters_data() { onThreads(); }
    void worksWithClearRegisters() {
        QFETCH(int, threads);
        if (!canTellUpperHalves()) {
            QSKIP("the processor does not tell what of its registers is in use");
        }
        std::atomic<int> inUse = 0;
        const auto first = [&](std::size_t) { inUse += areUpperHalvesInUse() ? 1 : 0; };
        useUpperHalves();
        QVERIFY(parallelFor(1000, first, {.stop = {}, .progress = {}, .threads = threads}));
        QCOMPARE(inUse.load(), 0);
    }
};

FURROW_TEST(TestParallel);
#include "tst_parallel.moc"
