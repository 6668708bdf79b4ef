// Fields, machines and settings that nobody chose: whatever comes of them, it is a plan that holds together,
// or a refusal that says what to do. `tst_drawn_plans --minutes 60 [--from SEED]` goes on for an hour, names
// each seed before it is planned, so that a crash tells its own, and ends with 1 where something is wrong.
// `--only SEED` shows one of them, `--chosen FILE` what the bytes of a file choose
// (tests/fuzz/fuzz_planner.cpp).

#include "tests/corpus/plan_invariants.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QFile>
#include <QTest>

#include <array>
#include <cstdio>
#include <optional>

using namespace furrow;

namespace {

constexpr std::uint64_t kFirstSeed = 1;
// Of small fields, about twenty seconds of one core. However slow it is, they are the same everywhere.
constexpr std::uint64_t kEverydaySeeds = 40;
constexpr double kSlowS = 60.0;

/// What follows a word of the command line.
std::optional<std::uint64_t> numberAfter(const QStringList& line, const QString& word) {
    const qsizetype at = line.indexOf(word);
    return at < 0 || at + 1 >= line.size() ? std::nullopt : std::optional{line[at + 1].toULongLong()};
}

bool runChosen(const QString& path) {
    QFile file{path};
    if (!file.open(QIODevice::ReadOnly)) {
        std::printf("%s cannot be read\n", qPrintable(path));
        return false;
    }
    const QByteArray bytes = file.readAll();
    const test::DrawnRequest drawn = test::chosenRequest(
        {reinterpret_cast<const std::uint8_t*>(bytes.constData()), static_cast<std::size_t>(bytes.size())});
    std::printf("%s\n", drawn.told.c_str());
    for (const GeoPolygon& part : drawn.field.parts) {
        for (const GeoPoint& point : part.outer) {
            std::printf("%.9f %.9f\n", point.lonDeg, point.latDeg);
        }
    }
    std::fflush(stdout);
    const test::DrawnVerdict verdict = test::verdictOn(drawn);
    std::printf("%.1f s: %s\n", verdict.seconds, verdict.fault.empty() ? "no fault" : verdict.fault.c_str());
    return verdict.fault.empty();
}

bool runSeed(std::uint64_t seed, std::array<int, 3>& outcomes) {
    std::fprintf(stderr, "seed %llu\r", static_cast<unsigned long long>(seed));
    std::fflush(stderr);
    const test::DrawnVerdict verdict = test::verdictOn(seed);
    ++outcomes[static_cast<std::size_t>(verdict.outcome)];
    if (!verdict.fault.empty() || verdict.seconds > kSlowS || verdict.stopSeconds > 1.0) {
        std::printf("seed %llu: %s, %.1f s, stopped within %.1f s: %s\n",
                    static_cast<unsigned long long>(seed),
                    verdict.fault.empty() ? "slow" : verdict.fault.c_str(), verdict.seconds,
                    verdict.stopSeconds, test::drawnRequest(seed).told.c_str());
        std::fflush(stdout);
    }
    return verdict.fault.empty();
}

int runFor(std::uint64_t minutes, std::uint64_t from) {
    QElapsedTimer timer;
    timer.start();
    std::array<int, 3> outcomes{};
    int faults = 0;
    std::uint64_t seed = from;
    for (; timer.elapsed() < static_cast<qint64>(minutes) * 60'000; ++seed) {
        faults += runSeed(seed, outcomes) ? 0 : 1;
    }
    std::printf("seeds %llu to %llu: %d refused, %d planned, %d drivable, %d faults\n",
                static_cast<unsigned long long>(from), static_cast<unsigned long long>(seed - 1), outcomes[0],
                outcomes[1], outcomes[2], faults);
    return faults == 0 ? 0 : 1;
}

}  // namespace

class TestDrawnPlans : public QObject {
    Q_OBJECT

private slots:
    void theSameSeedDrawsTheSame() {
        const test::DrawnRequest one = test::drawnRequest(7);
        const test::DrawnRequest again = test::drawnRequest(7);
        QVERIFY(one.field == again.field && one.machine == again.machine && one.settings == again.settings);
        QVERIFY(one.field != test::drawnRequest(8).field);
    }
    void everyPlanHoldsTogether() {
        std::array<int, 3> outcomes{};
        for (std::uint64_t seed = kFirstSeed; seed < kFirstSeed + kEverydaySeeds; ++seed) {
            const test::DrawnVerdict verdict = test::verdictOn(seed, test::DrawnSize::Small);
            ++outcomes[static_cast<std::size_t>(verdict.outcome)];
            QVERIFY2(verdict.fault.empty(),
                     qPrintable(
                         QStringLiteral("seed %1: %2").arg(seed).arg(QString::fromStdString(verdict.fault))));
        }
        qInfo("%d refused, %d planned, %d drivable", outcomes[0], outcomes[1], outcomes[2]);
        // A generator whose fields are all refused would find nothing.
        QVERIFY(outcomes[1] + outcomes[2] > static_cast<int>(kEverydaySeeds / 4));
    }
};

int main(int argc, char** argv) {
    const QCoreApplication application{argc, argv};
    const QStringList line = QCoreApplication::arguments();
    if (const auto seed = numberAfter(line, "--only")) {
        std::array<int, 3> outcomes{};
        std::printf("%s\n", test::drawnRequest(*seed).told.c_str());
        return runSeed(*seed, outcomes) ? 0 : 1;
    }
    if (const qsizetype at = line.indexOf("--chosen"); at >= 0 && at + 1 < line.size()) {
        return runChosen(line[at + 1]) ? 0 : 1;
    }
    if (const auto minutes = numberAfter(line, "--minutes")) {
        return runFor(*minutes, numberAfter(line, "--from").value_or(kFirstSeed));
    }
    TestDrawnPlans everyday;
    return QTest::qExec(&everyday, argc, argv);
}

#include "tst_drawn_plans.moc"
