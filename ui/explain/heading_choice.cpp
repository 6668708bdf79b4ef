#include "ui/explain/heading_choice.h"

#include "planner/plan/method_registry.h"
#include "planner/project/project_edits.h"
#include "planner/swaths/methods.h"
#include "planner/units/angle.h"
#include "ui/text/display.h"
#include "ui/text/unit_text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ranges>
#include <utility>

namespace furrow {

namespace {

constexpr double kHalfTurnDeg = 180.0;

bool hasSwaths(const HeadingTrial& trial) {
    return trial.figures.count > 0;
}

double share(double value, double least, double most) {
    return most > least ? std::clamp((value - least) / (most - least), 0.0, 1.0) : 0.5;
}

}  // namespace

HeadingChoice::HeadingChoice(Document& document, QObject* parent) : QObject{parent}, document_{document} {
    connect(&Display::instance(), &Display::changed, this, &HeadingChoice::changed);
}

void HeadingChoice::show(std::shared_ptr<const Plan> plan, std::optional<HeadingCurve> curve) {
    plan_ = std::move(plan);
    curve_ = std::move(curve);
    leastS_ = std::numeric_limits<double>::infinity();
    mostS_ = 0.0;
    if (curve_) {
        for (const HeadingTrial& trial : curve_->trials | std::views::filter(hasSwaths)) {
            leastS_ = std::min(leastS_, trial.figures.time.si());
            mostS_ = std::max(mostS_, trial.figures.time.si());
        }
    }
    emit changed();
}

void HeadingChoice::setAcross(Across across) {
    if (across != across_) {
        across_ = across;
        emit changed();
    }
}

double HeadingChoice::valueOf(const HeadingTrial& trial) const {
    switch (across_) {
        case Bearing: return lineBearingDeg(trial.heading);
        case Overlap: return trial.figures.overlap.si();
        case Missed: return trial.missed.si();
        case Turning: break;
    }
    return trial.turning.si();
}

QList<QPointF> HeadingChoice::points() const {
    QList<QPointF> points;
    if (!curve_) {
        return points;
    }
    double least = 0.0;
    double most = kHalfTurnDeg;
    if (across_ != Bearing) {
        const auto [low, high] = std::ranges::minmax(
            curve_->trials | std::views::transform([this](const auto& trial) { return valueOf(trial); }));
        least = low;
        most = high;
    }
    points.reserve(static_cast<qsizetype>(curve_->trials.size()));
    for (const HeadingTrial& trial : curve_->trials) {
        const double time = hasSwaths(trial) ? trial.figures.time.si() : mostS_;
        points.append({share(valueOf(trial), least, most), share(time, leastS_, mostS_)});
    }
    return points;
}

QList<int> HeadingChoice::tradeOffs() const {
    QList<int> indices;
    for (std::size_t i = 0; curve_ && i < curve_->trials.size(); ++i) {
        if (curve_->trials[i].isTradeOff) {
            indices.append(static_cast<int>(i));
        }
    }
    return indices;
}

QString HeadingChoice::leastTime() const {
    return curve_ ? durationText(seconds(leastS_)) : QString{};
}

QString HeadingChoice::mostTime() const {
    return curve_ ? durationText(seconds(mostS_)) : QString{};
}

QString HeadingChoice::acrossText(double value) const {
    switch (across_) {
        case Bearing: return tr("%1°").arg(numberText(value, 0));
        case Overlap:
        case Missed: return squareMetresText(squareMetres(value), 0);
        case Turning: break;
    }
    return durationText(seconds(value));
}

QString HeadingChoice::leastAcross() const {
    if (!curve_) {
        return {};
    }
    return acrossText(across_ == Bearing ? 0.0
                                         : std::ranges::min(curve_->trials |
                                                            std::views::transform([this](const auto& trial) {
                                                                return valueOf(trial);
                                                            })));
}

QString HeadingChoice::mostAcross() const {
    if (!curve_) {
        return {};
    }
    return acrossText(across_ == Bearing ? kHalfTurnDeg
                                         : std::ranges::max(curve_->trials |
                                                            std::views::transform([this](const auto& trial) {
                                                                return valueOf(trial);
                                                            })));
}

bool HeadingChoice::isByHand() const {
    return document_.project()->plan().settings.choice(*stageMethod("swaths")) == kFixedHeadingMethod.info.id;
}

const HeadingTrial* HeadingChoice::trial(int point) const {
    return curve_ && point >= 0 && point < static_cast<int>(curve_->trials.size())
               ? &curve_->trials[static_cast<std::size_t>(point)]
               : nullptr;
}

int HeadingChoice::nearest(double x, double y) const {
    const QList<QPointF> all = points();
    int best = -1;
    double bestDistance = std::numeric_limits<double>::infinity();
    for (qsizetype i = 0; i < all.size(); ++i) {
        const double dx = all[i].x() - x;
        const double dy = across_ == Bearing ? 0.0 : all[i].y() - y;
        if (const double distance = std::hypot(dx, dy); distance < bestDistance) {
            bestDistance = distance;
            best = static_cast<int>(i);
        }
    }
    return best;
}

QString HeadingChoice::bearingOf(int point) const {
    const HeadingTrial* const shown = trial(point);
    return shown == nullptr ? QString{} : bearingText(shown->heading);
}

QString HeadingChoice::describe(int point) const {
    const HeadingTrial* const shown = trial(point);
    if (shown == nullptr) {
        return {};
    }
    if (!hasSwaths(*shown)) {
        return inOneLine({bearingText(shown->heading), tr("no swath fits")});
    }
    return inOneLine({bearingText(shown->heading), tr("%n swath(s)", nullptr, shown->figures.count),
                      durationText(shown->figures.time), tr("%1 turning").arg(durationText(shown->turning)),
                      tr("%1 twice").arg(squareMetresText(shown->figures.overlap, 0)),
                      tr("%1 missed").arg(squareMetresText(shown->missed, 0))});
}

void HeadingChoice::take(int point) {
    const HeadingTrial* const taken = trial(point);
    if (taken == nullptr || !hasSwaths(*taken)) {
        return;
    }
    Settings settings = document_.project()->plan().settings;
    settings.set(*stageMethod("swaths"), std::string{kFixedHeadingMethod.info.id}).value();
    settings.set(kAngle, inDegrees(taken->heading)).value();
    change([heading = taken->heading] { return tr("Swaths along %1").arg(bearingText(heading)); }, settings);
}

void HeadingChoice::search() {
    Settings settings = document_.project()->plan().settings;
    settings.clear(*stageMethod("swaths"));
    settings.clear(kAngle);
    change([] { return tr("Search the heading"); }, settings);
}

void HeadingChoice::change(const LazyText& text, const Settings& settings) {
    const Project& project = *document_.project();
    document_.change(text, withPlan(project, project.plan().machine, settings));
    emit changed();
}

}  // namespace furrow
