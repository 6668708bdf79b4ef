#include "ui/drive/drive_through.h"

#include "planner/path/tank_levels.h"
#include "planner/path/turn_shape.h"
#include "ui/text/display.h"
#include "ui/text/message_text.h"
#include "ui/text/unit_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace furrow {

namespace {

constexpr std::array kPaces{1, 2, 4, 8, 16, 32, 64};
// Straighter wheels are not worth a number.
constexpr double kStraightDeg = 0.5;

QString clockText(double seconds) {
    const auto whole = static_cast<qint64>(std::floor(seconds + 1e-6));
    return QStringLiteral("%1:%2:%3")
        .arg(whole / 3600)
        .arg(whole / 60 % 60, 2, 10, QLatin1Char('0'))
        .arg(whole % 60, 2, 10, QLatin1Char('0'));
}

/// How many stretches of a kind there are up to a segment, that one included, and in all.
std::pair<int, int> countOf(const Path& path, std::size_t segment) {
    std::pair<int, int> count{0, 0};
    for (std::size_t i = 0; i < path.segments.size(); ++i) {
        if (path.segments[i].kind == path.segments[segment].kind) {
            ++count.second;
            count.first += i <= segment ? 1 : 0;
        }
    }
    return count;
}

}  // namespace

DriveThrough::DriveThrough(ShownPlan& shown, QObject* parent) : QObject{parent}, shown_{shown} {
    connect(&shown_, &ShownPlan::planChanged, this, &DriveThrough::follow);
    connect(&Display::instance(), &Display::changed, this, [this] {
        emit courseChanged();
        emit moved();
    });
}

void DriveThrough::follow() {
    const auto& plan = shown_.plan();
    if (plan == asked_) {
        return;
    }
    // The machine of another plan is never shown over this one.
    setPlaying(false);
    if (plan == nullptr || plan->request.draft) {
        runner_.cancel();
        asked_.reset();
        if (course_ != nullptr) {
            take(nullptr, nullptr, nullptr);
        }
        return;
    }
    asked_ = plan;
    runner_.submit([this, plan](const JobContext& job) -> JobRunner::Delivery {
        auto course = DriveCourse::of(*plan, job);
        if (!course) {
            return [this, plan] {
                if (plan == asked_) {
                    take(nullptr, nullptr, nullptr);
                }
            };
        }
        auto whole = std::make_shared<const DriveCourse>(*std::move(course));
        auto strips = std::make_shared<const WorkedStrips>(*whole, plan->request.machine.operatingWidth(),
                                                           MapFrame{plan->field().frame()});
        return [this, plan, whole = std::move(whole), strips = std::move(strips)]() mutable {
            if (plan == asked_) {
                take(plan, std::move(whole), std::move(strips));
            }
        };
    });
}

void DriveThrough::take(std::shared_ptr<const Plan> plan, std::shared_ptr<const DriveCourse> course,
                        std::shared_ptr<const WorkedStrips> strips) {
    plan_ = std::move(plan);
    course_ = std::move(course);
    strips_ = std::move(strips);
    timeS_ = 0.0;
    emit courseChanged();
    show();
}

void DriveThrough::show() {
    state_ = course_ != nullptr ? course_->at(seconds(timeS_)) : DriveState{};
    emit moved();
}

void DriveThrough::setPlaying(bool playing) {
    playing = playing && course_ != nullptr;
    if (playing == playing_) {
        return;
    }
    if (playing && timeS_ >= duration()) {
        setTime(0.0);
    }
    playing_ = playing;
    emit playingChanged();
}

void DriveThrough::setPace(int pace) {
    if (pace != pace_ && std::ranges::contains(kPaces, pace)) {
        pace_ = pace;
        emit paceChanged();
    }
}

void DriveThrough::faster() {
    const auto next = std::ranges::upper_bound(kPaces, pace_);
    setPace(next == kPaces.end() ? kPaces.back() : *next);
}

void DriveThrough::slower() {
    const auto same = std::ranges::lower_bound(kPaces, pace_);
    setPace(same == kPaces.begin() ? kPaces.front() : *(same - 1));
}

void DriveThrough::setTime(double seconds) {
    const double time = std::clamp(seconds, 0.0, duration());
    if (course_ != nullptr && time != timeS_) {
        timeS_ = time;
        show();
    }
}

void DriveThrough::advance(double seconds) {
    if (!playing_) {
        return;
    }
    setTime(timeS_ + seconds * pace_);
    if (timeS_ >= duration()) {
        setPlaying(false);
    }
}

void DriveThrough::stepSegment(int by) {
    if (course_ == nullptr) {
        return;
    }
    const int last = static_cast<int>(course_->segmentCount()) - 1;
    goTo(std::clamp(static_cast<int>(state_.segment) + by, 0, last));
}

void DriveThrough::goTo(int segment) {
    if (course_ != nullptr && segment >= 0 && segment < static_cast<int>(course_->segmentCount())) {
        // A moment into it: at its very beginning the one before ends.
        constexpr double kMomentS = 0.01;
        setTime(course_->startOf(static_cast<std::size_t>(segment)).si() + kMomentS);
    }
}

double DriveThrough::duration() const {
    return course_ != nullptr ? course_->duration().si() : 0.0;
}

QString DriveThrough::timeText() const {
    return clockText(timeS_);
}

QString DriveThrough::wholeText() const {
    return clockText(duration());
}

int DriveThrough::segment() const {
    return course_ != nullptr ? static_cast<int>(state_.segment) : -1;
}

Carried DriveThrough::carried() const {
    if (plan_ == nullptr) {
        return Carried::Up;
    }
    const PathSegment& segment = plan_->path.segments[state_.segment];
    return segment.implementDown                                                  ? Carried::Down
           : segment.folded || isWayInOrOut(plan_->path.segments, state_.segment) ? Carried::Folded
                                                                                  : Carried::Up;
}

QString DriveThrough::stateText() const {
    if (course_ == nullptr) {
        return {};
    }
    const PathSegment& segment = plan_->path.segments[state_.segment];
    QStringList parts;
    if (segment.kind == SegmentKind::Swath) {
        const auto [count, all] = countOf(plan_->path, state_.segment);
        parts << tr("Swath %1, %2 of %3").arg(segment.number).arg(count).arg(all);
    } else if (segment.kind == SegmentKind::Turn) {
        parts << sentence(nameOf(turnShape(std::span{&segment, 1})));
    } else if (segment.kind == SegmentKind::Refill) {
        const bool unloads = plan_->refill && plan_->refill->work.gathers;
        parts << sentence(tripName(plan_->path.segments, state_.segment, unloads));
    } else {
        parts << (segment.implementDown ? sentence(nameOf(segment)) : tr("Way without work"));
    }
    if (segment.gear == Gear::Reverse) {
        parts << tr("backwards");
    }
    parts << (segment.implementDown          ? tr("implement down")
              : carried() == Carried::Folded ? tr("implement folded")
                                             : tr("implement up"));
    return inOneLine(parts);
}

QString DriveThrough::figuresText() const {
    if (course_ == nullptr) {
        return {};
    }
    // Land that is worked twice is spread over the drive.
    const double share = course_->workedLength().si() > 0.0 ? state_.worked / course_->workedLength() : 0.0;
    QStringList parts{tr("%1 done").arg(areaText(share * plan_->audit.covered.value_or(Area{}))),
                      speedText(state_.speed)};
    const double deg = inDegrees(steeringAngle(plan_->request.machine, state_.curvature));
    parts << (std::abs(deg) < kStraightDeg ? tr("wheels straight")
              : deg > 0.0                  ? tr("%1° left").arg(numberText(deg, 0))
                                           : tr("%1° right").arg(numberText(-deg, 0)));
    parts << lengthText(state_.driven);
    if (const auto& tank = plan_->request.machine.spec().tank; tank && tank->capacity > 0.0) {
        if (state_.level) {
            const QString held = percentText(*state_.level / tank->capacity);
            parts << (plan_->refill && plan_->refill->work.gathers ? tr("bunker %1").arg(held)
                                                                   : tr("tank %1").arg(held));
            return inOneLine(parts);
        }
        const double used =
            tank->ratePerM2 * (state_.worked.si() * plan_->request.machine.operatingWidth().si());
        parts << (used < tank->capacity ? tr("tank %1").arg(percentText(1.0 - used / tank->capacity))
                                        : tr("tank empty"));
    }
    return inOneLine(parts);
}

QGeoCoordinate DriveThrough::place() const {
    return plan_ != nullptr ? coordinate(plan_->field().frame().toGeo(state_.position)) : QGeoCoordinate{};
}

}  // namespace furrow
