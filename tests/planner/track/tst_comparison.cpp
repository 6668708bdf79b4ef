// Tracks made from a plan by known shifts: what comes out is what went in.

#include "planner/track/comparison.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <numbers>
#include <random>
#include <stop_token>

using namespace furrow;

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kSpeedMps = 2.0;

LocalFrame frame() {
    return LocalFrame::centredOn({.lonDeg = 5.66, .latDeg = 52.09}).value();
}

/// Builds a path piece by piece; every sample is `stepM` from the one before.
class PathMaker {
public:
    explicit PathMaker(Point start, double headingRad) : at_{start}, headingRad_{headingRad} {}

    PathMaker& straight(SegmentKind kind, double lengthM) {
        begin(kind);
        const auto steps = static_cast<int>(std::ceil(lengthM / stepM_));
        for (int i = 0; i < steps; ++i) {
            advance(lengthM / steps);
        }
        return *this;
    }
    PathMaker& arc(double radiusM, double turnRad) {
        begin(SegmentKind::Turn);
        constexpr int kSteps = 40;
        for (int i = 0; i < kSteps; ++i) {
            // The chord of an arc, so that samples are on the circle.
            const double half = 0.5 * turnRad / kSteps;
            headingRad_ += half;
            at_ = at_ + 2.0 * radiusM * std::sin(std::abs(half)) * direction(headingRad_);
            headingRad_ += half;
            sM_ += radiusM * std::abs(2.0 * half);
            add();
        }
        return *this;
    }
    Path done() const { return path_; }

private:
    void begin(SegmentKind kind) {
        path_.segments.push_back({.kind = kind});
        add();
    }
    void advance(double lengthM) {
        at_ = at_ + lengthM * direction(headingRad_);
        sM_ += lengthM;
        add();
    }
    void add() {
        path_.segments.back().samples.push_back({.sM = sM_,
                                                 .tS = sM_ / kSpeedMps,
                                                 .position = at_,
                                                 .headingRad = headingRad_,
                                                 .speedMps = kSpeedMps});
    }

    Path path_;
    Point at_;
    double headingRad_;
    double sM_ = 0.0;
    double stepM_ = 50.0;
};

/// Four swaths of 100 m, 2.5 m apart, joined by half circles.
Path meander() {
    constexpr double r = 1.25;
    return PathMaker{{0.0, 0.0}, 0.0}
        .straight(SegmentKind::Swath, 100.0)
        .arc(r, kPi)
        .straight(SegmentKind::Swath, 100.0)
        .arc(r, -kPi)
        .straight(SegmentKind::Swath, 100.0)
        .arc(r, kPi)
        .straight(SegmentKind::Swath, 100.0)
        .done();
}

/// The path sampled every `stepM`, shifted to the left by `leftM` (of the way along it) and by a vector.
template <class Left>
RecordedTrack driven(const Path& path, double stepM, Left left, Point by = {}, double speedMps = 4.0) {
    RecordedTrack track{.source = "made", .places = TrackPlaces::Local, .samples = {}};
    double next = 0.0;
    for (const PathSegment& segment : path.segments) {
        for (std::size_t i = 1; i < segment.samples.size(); ++i) {
            const PathSample& a = segment.samples[i - 1];
            const PathSample& b = segment.samples[i];
            const Point along = (1.0 / distance(a.position, b.position)) * (b.position - a.position);
            for (; next <= b.sM; next += stepM) {
                const double share = (next - a.sM) / (b.sM - a.sM);
                const Point on = a.position + share * (b.position - a.position);
                track.samples.push_back({.local = on + left(next) * Point{-along.y, along.x} + by,
                                         .timeS = 1e9 + next / speedMps});
            }
        }
    }
    return track;
}

RecordedTrack driven(const Path& path, double stepM, double leftM = 0.0, Point by = {}) {
    return driven(path, stepM, [leftM](double) { return leftM; }, by);
}

TrackComparison compared(const Path& path, const RecordedTrack& track, double radiusM = 5.0) {
    return compareWithPath(path, frame(), {&track, 1}, metres(radiusM)).value();
}

}  // namespace

class ComparisonTest : public QObject {
    Q_OBJECT

private slots:
    void thePlanItselfHasNoError() {
        const TrackComparison result = compared(meander(), driven(meander(), 0.7));
        QCOMPARE(result.matched, result.samples);
        QCOMPARE(result.matchedShare(), 1.0);
        QVERIFY(result.overall.largest < metres(1e-9));
        // 100 + 3.927 m each: the share of turn samples is that of their length.
        COMPARE_WITHIN(
            static_cast<double>(result.of(SegmentKind::Turn)->samples) / static_cast<double>(result.samples),
            3.0 * 1.25 * kPi / (400.0 + 3.0 * 1.25 * kPi), 0.01);
        QVERIFY(result.of(SegmentKind::Transfer) == nullptr);
    }

    void wayAlongThePathIsFound() {
        const RecordedTrack track = driven(meander(), 0.7, 0.1);
        const TrackComparison result = compared(meander(), track);
        for (std::size_t i = 0; i < track.samples.size(); ++i) {
            COMPARE_WITHIN(result.matches[0][i]->sM, 0.7 * static_cast<double>(i), 0.06);
        }
    }

    void toTheLeftIsPositive_data() {
        QTest::addColumn<double>("leftM");
        QTest::newRow("0.10 m to the left") << 0.10;
        QTest::newRow("0.10 m to the right") << -0.10;
        QTest::newRow("nearer to the neighbour, which is driven the other way") << 1.4;
    }
    void toTheLeftIsPositive() {
        QFETCH(double, leftM);
        const TrackComparison result = compared(meander(), driven(meander(), 0.7, leftM));
        QVERIFY(result.matchedShare() > 0.99);
        const CrossTrackFigures* swaths = result.of(SegmentKind::Swath);
        COMPARE_WITHIN(swaths->median.si(), std::abs(leftM), 1e-9);
        COMPARE_WITHIN(swaths->mean.si(), leftM, 0.03);
        COMPARE_WITHIN(result.overall.median.si(), std::abs(leftM), 1e-9);
        if (std::abs(leftM) < 1.0) {
            COMPARE_WITHIN(swaths->p95.si(), 0.10, 1e-9);
            COMPARE_WITHIN(swaths->largest.si(), 0.10, 1e-3);
            COMPARE_WITHIN(result.of(SegmentKind::Turn)->median.si(), 0.10, 1e-3);
        }
    }

    // To the north: left of the swaths driven east, right of those driven west.
    void aShiftOfTheWholeTrackHasNoMean() {
        const TrackComparison result = compared(meander(), driven(meander(), 0.7, 0.0, {0.0, 0.10}));
        COMPARE_WITHIN(result.of(SegmentKind::Swath)->median.si(), 0.10, 1e-9);
        COMPARE_WITHIN(result.of(SegmentKind::Swath)->mean.si(), 0.0, 0.003);
        QVERIFY(result.of(SegmentKind::Turn)->largest <= metres(0.101));
    }

    // 0 to 1 m of shift in 101 steps: type 7 quantiles are the 51st and 96th of them.
    void quantilesByHand() {
        const Path path = PathMaker{{0.0, 0.0}, 0.5}.straight(SegmentKind::Swath, 100.0).done();
        const TrackComparison result = compared(path, driven(path, 1.0, [](double sM) { return 0.01 * sM; }));
        QCOMPARE(result.overall.samples, std::size_t{101});
        COMPARE_WITHIN(result.overall.median.si(), 0.50, 1e-9);
        COMPARE_WITHIN(result.overall.p95.si(), 0.95, 1e-9);
        COMPARE_WITHIN(result.overall.largest.si(), 1.00, 1e-9);
        COMPARE_WITHIN(result.overall.mean.si(), 0.50, 1e-9);
    }

    // A transfer back across all swaths, recorded 0.3 m beside: where it crosses them, they are nearer.
    void crossingOtherSwathsStaysOnTheTransfer() {
        const Path path = PathMaker{{0.0, 0.0}, 0.0}
                              .straight(SegmentKind::Swath, 100.0)
                              .arc(1.25, kPi)
                              .straight(SegmentKind::Swath, 50.0)
                              .arc(5.0, 1.5 * kPi)
                              .straight(SegmentKind::Swath, 0.1)
                              .done();
        Path crossing = path;
        const PathSample from = path.segments.back().samples.back();
        const Path transfer =
            PathMaker{from.position, from.headingRad}.straight(SegmentKind::Transfer, 20.0).done();
        crossing.segments.push_back(transfer.segments.front());
        for (PathSample& sample : crossing.segments.back().samples) {
            sample.sM += from.sM;
        }
        // Points up, across both swaths.
        COMPARE_WITHIN(std::sin(from.headingRad), 1.0, 1e-9);
        const RecordedTrack track = driven(crossing, 0.5, 0.3);
        const TrackComparison result = compared(crossing, track);
        for (std::size_t i = 0; i < track.samples.size(); ++i) {
            QVERIFY(result.matches[0][i].has_value());
            QVERIFY(std::abs(result.matches[0][i]->sM - 0.5 * static_cast<double>(i)) < 1.0);
        }
        COMPARE_WITHIN(result.of(SegmentKind::Transfer)->median.si(), 0.3, 1e-9);
        QVERIFY(result.overall.largest < metres(0.35));
    }

    // Last swath first, each the other way round: everything still finds its place; left becomes right.
    // Forwards to a corner, back beside its own line and on forwards: the way between the samples before and
    // after a change of gear is nobody's course.
    void changesOfGearAreFound() {
        Path path;
        double wayM = 0.0;
        const auto drive = [&](SegmentKind kind, Gear gear, const Polyline& line) {
            path.segments.push_back({.kind = kind, .gear = gear});
            for (std::size_t i = 0; i < line.size(); ++i) {
                wayM += i == 0 ? 0.0 : distance(line[i - 1], line[i]);
                path.segments.back().samples.push_back(
                    {.sM = wayM, .tS = wayM, .position = line[i], .headingRad = 0.0, .speedMps = 1.0});
            }
        };
        drive(SegmentKind::Swath, Gear::Forward, {{0, 0}, {18, 0}, {19.7, 0}, {20, 0}});
        drive(SegmentKind::Turn, Gear::Reverse, {{20, 0}, {19.8, 0.03}, {19.4, 0.1}});
        drive(SegmentKind::HeadlandPass, Gear::Forward, {{19.4, 0.1}, {21.5, 0.3}, {40, 0.3}});
        RecordedTrack track{.source = "made", .places = TrackPlaces::Local, .samples = {}};
        std::vector<double> ways;
        for (const PathSegment& segment : path.segments) {
            for (const PathSample& sample : segment.samples) {
                track.samples.push_back({.local = sample.position});
                ways.push_back(sample.sM);
            }
        }
        const TrackComparison comparison = compared(path, track);
        QCOMPARE(comparison.matched, track.samples.size());
        for (std::size_t i = 0; i < ways.size(); ++i) {
            COMPARE_WITHIN(comparison.matches[0][i]->sM, ways[i], 1e-6);
        }
        COMPARE_WITHIN(comparison.overall.largest.si(), 0.0, 1e-9);
    }

    void anotherOrderAndDirection() {
        RecordedTrack track = driven(meander(), 0.7, 0.10);
        std::ranges::reverse(track.samples);
        const TrackComparison result = compared(meander(), track);
        QCOMPARE(result.matched, result.samples);
        COMPARE_WITHIN(result.of(SegmentKind::Swath)->median.si(), 0.10, 1e-9);
        QVERIFY(result.of(SegmentKind::Swath)->p95 < metres(0.11));
    }

    void farFromThePathIsNotMatched() {
        const TrackComparison away = compared(meander(), driven(meander(), 0.7, 0.0, {0.0, 50.0}));
        QCOMPARE(away.matched, std::size_t{0});
        QCOMPARE(away.overall.samples, std::size_t{0});
        QVERIFY(away.kinds.empty());
        RecordedTrack track = driven(meander(), 0.7);
        // From the yard and back to it, straight on at both ends.
        track.samples.insert(track.samples.begin(), {.local = {-30.0, 0.0}});
        track.samples.insert(track.samples.begin() + 1, {.local = {-3.0, 0.0}});
        track.samples.push_back({.local = {-3.0, 7.5}});
        const TrackComparison result = compared(meander(), track, 1.5);
        QCOMPARE(result.matched + 3, result.samples);
        QVERIFY(!result.matches[0][0] && !result.matches[0][1] && !result.matches[0].back());
        QVERIFY(result.overall.largest < metres(1e-9));
    }

    void speedsAreWayByTime() {
        const TrackComparison result = compared(meander(), driven(meander(), 0.5));  // at 4 m/s
        COMPARE_WITHIN(result.of(SegmentKind::Swath)->recordedSpeed->si(), 4.0, 1e-3);
        COMPARE_WITHIN(result.of(SegmentKind::Swath)->plannedSpeed->si(), kSpeedMps, 1e-9);
        RecordedTrack untimed = driven(meander(), 0.5);
        for (TrackSample& sample : untimed.samples) {
            sample.timeS.reset();
        }
        QVERIFY(!compared(meander(), untimed).overall.recordedSpeed);
    }

    void wgs84AndLocalAreTheSame() {
        RecordedTrack local = driven(meander(), 0.7, 0.2);
        RecordedTrack geo = local;
        geo.places = TrackPlaces::Wgs84;
        for (TrackSample& sample : geo.samples) {
            sample.geo = frame().toGeo(sample.local);
            sample.local = {};
        }
        COMPARE_WITHIN(compared(meander(), geo).overall.median.si(),
                       compared(meander(), local).overall.median.si(), 1e-6);
    }

    void otherContinentsAndNothingAtAll() {
        RecordedTrack far{.source = "far", .places = TrackPlaces::Wgs84, .samples = {}};
        for (int i = 0; i < 100; ++i) {
            far.samples.push_back({.geo = {.lonDeg = -180.0 + 3.6 * i, .latDeg = -90.0 + 1.8 * i}});
        }
        QCOMPARE(compared(meander(), far).samples, std::size_t{100});
        const RecordedTrack none;
        QCOMPARE(compared(meander(), none).matchedShare(), 0.0);
        QCOMPARE(compared(Path{}, driven(meander(), 5.0)).matched, std::size_t{0});
    }

    // Random tracks over random paths: matched exactly where some edge is within the radius, never nearer
    // than the nearest.
    void asBruteForceSays() {
        std::mt19937 random{7};
        std::uniform_real_distribution<double> coordinate{-40.0, 40.0};
        for (int round = 0; round < 20; ++round) {
            Path path;
            path.segments.push_back({.kind = SegmentKind::Swath});
            double sM = 0.0;
            for (int i = 0; i < 30; ++i) {
                auto& samples = path.segments.back().samples;
                const Point at{coordinate(random), coordinate(random)};
                sM += samples.empty() ? 0.0 : distance(samples.back().position, at);
                samples.push_back({.sM = sM, .position = at});
            }
            RecordedTrack track{.source = "random", .places = TrackPlaces::Local, .samples = {}};
            for (int i = 0; i < 200; ++i) {
                track.samples.push_back({.local = {1.2 * coordinate(random), 1.2 * coordinate(random)}});
            }
            const double radiusM = 3.0;
            const TrackComparison result = compared(path, track, radiusM);
            const auto& samples = path.segments.front().samples;
            for (std::size_t i = 0; i < track.samples.size(); ++i) {
                const Point p = track.samples[i].local;
                double nearest = 1e9;
                double nearestInner = 1e9;  // without the first and last edge, whose ends do not count
                for (std::size_t k = 1; k < samples.size(); ++k) {
                    const Point a = samples[k - 1].position;
                    const Point d = samples[k].position - a;
                    const double t = std::clamp(dot(p - a, d) / dot(d, d), 0.0, 1.0);
                    const double off = distance(p, a + t * d);
                    nearest = std::min(nearest, off);
                    if (k > 1 && k + 1 < samples.size()) {
                        nearestInner = std::min(nearestInner, off);
                    }
                }
                const auto& match = result.matches[0][i];
                QVERIFY(match || nearestInner > radiusM);
                if (match) {
                    QVERIFY(nearest <= radiusM);
                    QVERIFY(std::abs(match->crossTrackM) >= nearest - 1e-9);
                    COMPARE_WITHIN(distance(p, match->foot), std::abs(match->crossTrackM), 1e-9);
                }
            }
        }
    }

    void cancelled() {
        std::stop_source stop;
        stop.request_stop();
        const RecordedTrack track = driven(meander(), 0.7);
        const auto result =
            compareWithPath(meander(), frame(), {&track, 1}, metres(5.0), {.stop = stop.get_token()});
        QVERIFY(!result);
        QCOMPARE(result.error().code, ErrorCode::Cancelled);
    }
};

FURROW_TEST(ComparisonTest);
#include "tst_comparison.moc"
