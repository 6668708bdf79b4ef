#include "ui/results/plan_change.h"

#include "ui/text/display.h"
#include "ui/text/unit_text.h"

#include <cmath>
#include <utility>

namespace furrow {

namespace {

// Smaller changes would read as zero.
constexpr double kLeastS = 1.0;
constexpr double kLeastM = 1.0;
constexpr double kLeastM2 = 1.0;

/// "+4 min", which no line break divides; empty for a change that is none.
template <class Quantity, class Text>
QString signedText(Quantity before, Quantity now, double least, const Text& text) {
    const double difference = now.si() - before.si();
    if (std::abs(difference) < least) {
        return {};
    }
    QString changed = (difference > 0.0 ? QStringLiteral("+") : QStringLiteral("\u2212")) +
                      text(Quantity::fromSi(std::abs(difference)));
    return changed.replace(QLatin1Char{' '}, QChar::Nbsp);
}

}  // namespace

PlanChange::PlanChange(QObject* parent) : QObject{parent} {
    connect(&Display::instance(), &Display::changed, this, &PlanChange::changed);
}

void PlanChange::show(const std::string& field, const std::shared_ptr<const Plan>& plan) {
    if (plan == plan_ && field == field_) {
        return;
    }
    before_ = field == field_ ? std::exchange(plan_, plan) : nullptr;
    plan_ = plan;
    field_ = field;
    emit changed();
}

QString PlanChange::text() const {
    if (before_ == nullptr || plan_ == nullptr) {
        return {};
    }
    const auto noArea = [](const std::optional<Area>& area) { return area.value_or(Area{}); };
    QStringList parts;
    const auto add = [&parts](const QString& pattern, const QString& difference) {
        if (!difference.isEmpty()) {
            parts << pattern.arg(difference);
        }
    };
    add(tr("time %1"),
        signedText(before_->path.duration(), plan_->path.duration(), kLeastS, exactDurationText));
    add(tr("path %1"), signedText(before_->path.length(), plan_->path.length(), kLeastM, lengthText));
    const auto areas = [](Area area) { return squareMetresText(area, 0); };
    add(tr("covered %1"),
        signedText(noArea(before_->audit.covered), noArea(plan_->audit.covered), kLeastM2, areas));
    add(tr("worked twice %1"),
        signedText(noArea(before_->audit.overlap), noArea(plan_->audit.overlap), kLeastM2, areas));
    return parts.isEmpty() ? tr("With the last change: the same time, length and area.")
                           : tr("With the last change: %1").arg(inOneLine(parts));
}

}  // namespace furrow
