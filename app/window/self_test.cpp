#include "app/window/self_test.h"

#include "ui/shell/session.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QImage>
#include <QQuickItem>
#include <QQuickWindow>
#include <QTimer>

#include <atomic>
#include <cstdio>
#include <deque>
#include <functional>

namespace furrow {

namespace {

std::atomic<int> warningCount = 0;
QtMessageHandler earlierHandler = nullptr;

/// Qt's platform without a screen says this of every window.
bool isOfPlatform(const QString& message) {
    return message.contains(QLatin1String{"propagateSizeHints"});
}

void countingHandler(QtMsgType type, const QMessageLogContext& context, const QString& message) {
    if ((type == QtWarningMsg || type == QtCriticalMsg) && !isOfPlatform(message)) {
        ++warningCount;
    }
    earlierHandler(type, context, message);
}

/// Steps, each with a condition that must come true in time before the next one.
class SelfTest : public QObject {
public:
    SelfTest(QQuickWindow& window, Session& session) : QObject{&window}, window_{window}, session_{session} {
        timer_.setInterval(20);
        connect(&timer_, &QTimer::timeout, this, [this] { tick(); });
    }
    void add(const char* name, std::function<void()> act, std::function<bool()> reached) {
        steps_.push_back({name, std::move(act), std::move(reached)});
    }
    void start() {
        timer_.start();
        begin();
    }

private:
    struct Step {
        const char* name;
        std::function<void()> act;
        std::function<bool()> reached;
    };
    void begin() {
        waited_.start();
        steps_.front().act();
    }
    void tick() {
        // Of a busy computer: a plan takes seconds on an idle one.
        constexpr int kLongestMs = 300'000;
        if (!steps_.front().reached()) {
            if (waited_.elapsed() > kLongestMs) {
                std::printf("self-test: %s: NOT reached\n", steps_.front().name);
                end(1);
            }
            return;
        }
        if (window_.grabWindow().isNull()) {
            std::printf("self-test: %s: nothing was drawn\n", steps_.front().name);
            end(1);
            return;
        }
        std::printf("self-test: %s: ok, %lld ms\n", steps_.front().name,
                    static_cast<long long>(waited_.elapsed()));
        steps_.pop_front();
        if (!steps_.empty()) {
            begin();
            return;
        }
        if (warningCount > 0) {
            std::printf("self-test: %d warnings\n", warningCount.load());
        }
        end(warningCount > 0 ? 1 : 0);
    }
    void end(int status) {
        timer_.stop();
        std::fflush(stdout);
        QCoreApplication::exit(status);
    }

    QQuickWindow& window_;
    Session& session_;
    std::deque<Step> steps_;
    QTimer timer_;
    QElapsedTimer waited_;
};

QList<QGeoCoordinate> corners(std::initializer_list<std::pair<double, double>> lonLat) {
    QList<QGeoCoordinate> points;
    for (const auto& [lon, lat] : lonLat) {
        points << QGeoCoordinate{lat, lon};
    }
    return points;
}

}  // namespace

void countMessages() {
    earlierHandler = qInstallMessageHandler(countingHandler);
}

void runSelfTest(QQuickWindow& window, Session& session) {
    auto* test = new SelfTest{window, session};
    const auto item = [&window](const char* name) {
        return window.findChild<QQuickItem*>(QLatin1String{name});
    };
    const auto shown = [item](const char* name) {
        return [item, name] { return item(name) != nullptr && item(name)->isVisible(); };
    };
    const auto in = [&session](PlanState state) {
        return [&session, state] { return session.planning()->state() == state; };
    };
    const auto press = [item](const char* name) {
        return [item, name] { QMetaObject::invokeMethod(item(name), "click"); };
    };
    const auto open = [item](const QString& step) {
        return [item, step] { item("stepsPanel")->setProperty("openStep", step); };
    };

    test->add("empty", [] {}, shown("emptyState"));
    test->add("drawing", press("drawTool"), shown("drawingHint"));
    test->add("drawing given up", press("cancelDrawing"), shown("emptyState"));
    test->add(
        "a field is planned",
        [&session] {
            session.opener()->addDrawn(
                corners({{22.50, 58.25}, {22.507, 58.25}, {22.507, 58.2535}, {22.50, 58.2535}}));
        },
        in(PlanState::Ready));
    for (int row = 0; row < session.planning()->steps()->rowCount(); ++row) {
        const QString step = session.planning()
                                 ->steps()
                                 ->data(session.planning()->steps()->index(row), StepsModel::StepIdRole)
                                 .toString();
        test->add("a step opens", open(step),
                  [item, step] { return item("stepsPanel")->property("openStep").toString() == step; });
    }
    test->add("other colours", press("themeSwitch"), [] { return true; });
    test->add("other colours", press("themeSwitch"), [] { return true; });
    test->add("other colours", press("themeSwitch"), [] { return true; });
    test->add("export opens", press("exportButton"), shown("export.write"));
    test->add("export closes", press("export.close"), [shown] { return !shown("export.write")(); });
    test->add(
        "a boundary that crosses itself",
        [&session] {
            session.opener()->addDrawn(
                corners({{22.50, 58.25}, {22.507, 58.2535}, {22.507, 58.25}, {22.50, 58.2535}}));
        },
        in(PlanState::Failed));
    test->add("the problem is told", [] {}, shown("problemCard"));
    test->add("no field again", [&session] { session.opener()->startNew(); }, shown("emptyState"));
    for (int sample = 0; sample < session.opener()->sampleNames().size(); ++sample) {
        test->add(
            "a sample field is planned", [&session, sample] { session.opener()->openSample(sample); },
            [&session] { return isFinished(session.planning()->state()); });
    }
    QTimer::singleShot(0, test, [test] { test->start(); });
}

}  // namespace furrow
