// What a frame of the window costs while a plan of 64 or 200 ha is driven through, panned and zoomed. Told
// and never judged; as many frames as the environment asks for with FURROW_BENCH_FRAMES.

#include "planner/machine/machine_library.h"
#include "planner/project/project_edits.h"
#include "tests/support/test_program.h"
#include "tests/ui/window/next_frame.h"
#include "tests/ui/window/window_test.h"

#include <QElapsedTimer>

#include <cmath>
#include <ctime>
#include <functional>

using namespace furrow;

namespace {

/// Processor time of all threads so far.
double processorMs() {
    timespec now{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

int framesWanted() {
    bool isThere = false;
    const int frames = qEnvironmentVariableIntValue("FURROW_BENCH_FRAMES", &isThere);
    return isThere ? frames : 10;
}

}  // namespace

class FramesBenchmark : public test::WindowTest {
    Q_OBJECT

private slots:
    void init() { begin({1280, 800}); }
    void cleanup() { end(); }
    void frames_data();
    void frames();

private:
    void plan(double hectares, const char* machine);
    /// `next` is called before each frame; empty where the window moves by itself.
    void time(const char* what, const std::function<void()>& next);
};

void FramesBenchmark::plan(double hectares, const char* machine) {
    // A square in the north, where a degree of longitude is half as long as one of latitude.
    const double sideM = std::sqrt(1e4 * hectares);
    const double lat = sideM / 111'400.0;
    const double lon = sideM / (111'300.0 * std::cos(58.25 * M_PI / 180.0));
    session_->opener()->addDrawn(
        {{58.25, 22.5}, {58.25, 22.5 + lon}, {58.25 + lat, 22.5 + lon}, {58.25 + lat, 22.5}});
    const Project& project = *session_->document()->project();
    session_->document()->change([] { return QString{}; },
                                 withPlan(project, findMachine(machine).value(), project.plan().settings));
    QTRY_VERIFY_WITH_TIMEOUT(isFinished(session_->planning()->state()), kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(session_->drive()->isAvailable(), kPatienceMs);
}

void FramesBenchmark::time(const char* what, const std::function<void()>& next) {
    const int wanted = framesWanted();
    // The first ones make what stays.
    int count = -3;
    double begun = 0.0;
    QElapsedTimer watch;
    for (; count < wanted; ++count) {
        if (count == 0) {
            begun = processorMs();
            watch.start();
        }
        if (next) {
            next();
        }
        test::NextFrame frame{*window_};
        QVERIFY(frame.wait(kPatienceMs));
    }
    const auto tookMs = static_cast<double>(watch.nsecsElapsed()) / 1e6;
    qInfo("%s, %s: %.1f ms of processor time for a frame, %.0f frames per second", QTest::currentDataTag(),
          what, (processorMs() - begun) / wanted, 1e3 * wanted / tookMs);
}

void FramesBenchmark::frames_data() {
    QTest::addColumn<double>("hectares");
    QTest::addColumn<QByteArray>("machine");
    if (framesWanted() <= 10) {
        QTest::newRow("4 ha, 6 m") << 4.0 << QByteArray{"cultivator"};
        return;
    }
    QTest::newRow("64 ha, 2.5 m") << 64.0 << QByteArray{"agbot"};
    QTest::newRow("64 ha, 6 m") << 64.0 << QByteArray{"cultivator"};
    QTest::newRow("64 ha, 24 m") << 64.0 << QByteArray{"trailed-sprayer"};
    QTest::newRow("200 ha, 6 m") << 200.0 << QByteArray{"cultivator"};
}

void FramesBenchmark::frames() {
    QFETCH(double, hectares);
    QFETCH(QByteArray, machine);
    plan(hectares, machine.constData());
    DriveThrough& drive = *session_->drive();
    int turn = 0;
    const auto pan = [&] {
        const double way = ++turn % 60 < 30 ? 4.0 : -4.0;
        camera()->panBy(way, 0.5 * way);
    };
    const auto zoom = [&] { camera()->zoomBy(++turn % 40 < 20 ? 0.05 : -0.05); };
    time("panned", pan);
    time("zoomed", zoom);
    for (const int pace : {16, 64}) {
        drive.setPace(pace);
        drive.setTime(0.5 * drive.duration());
        drive.setPlaying(true);
        time(pace == 16 ? "driven at 16x" : "driven at 64x", {});
        drive.setPlaying(false);
    }
    picture(QStringLiteral("frames_%1").arg(QLatin1String{QTest::currentDataTag()}));
    // Near, and followed.
    click(QStringLiteral("drive.follow"));
    camera()->zoomBy(2.0);
    drive.setTime(0.25 * drive.duration());
    drive.setPlaying(true);
    time("followed at 64x", {});
    drive.setPlaying(false);
}

FURROW_TEST_WITH(FramesBenchmark, QGuiApplication);
#include "bench_frames_window.moc"
