#include "ui/order/swath_order.h"

#include "planner/plan/method_registry.h"
#include "planner/project/project_edits.h"
#include "planner/route/methods.h"
#include "planner/route/order_edits.h"
#include "planner/units/angle.h"
#include "ui/text/display.h"
#include "ui/text/unit_text.h"

#include <algorithm>
#include <utility>

namespace furrow {

namespace {

std::string ownOrderId() {
    return std::string{kCustomMethod.info.id};
}

/// Without what is said of the order of all swaths.
Settings withoutOrder(Settings settings) {
    settings.clear(*stageMethod("route"));
    for (const Parameter* const parameter : {&kOrder, &kLocked, &kFirstSwath, &kLastSwath}) {
        settings.clear(*parameter);
    }
    return settings;
}

}  // namespace

SwathOrder::SwathOrder(Document& document, ShownPlan& shown, QObject* parent)
    : QAbstractListModel{parent}, document_{document}, shown_{shown} {
    connect(&shown_, &ShownPlan::planChanged, this, &SwathOrder::show);
    connect(&Display::instance(), &Display::changed, this, [this] {
        if (!steps_.empty()) {
            emit dataChanged(index(0), index(rowCount() - 1));
        }
    });
}

bool SwathOrder::isByHand() const {
    return document_.project()->plan().settings.choice(*stageMethod("route")) == ownOrderId();
}

void SwathOrder::setPointing(bool pointing) {
    if (pointing != pointing_) {
        pointing_ = pointing;
        pointed_.clear();
        current_ = -1;
        emit pointingChanged();
        emit currentChanged();
    }
}

void SwathOrder::setCurrent(int row) {
    if (row != current_) {
        current_ = row;
        emit currentChanged();
    }
}

int SwathOrder::rowOf(std::size_t swath) const {
    const auto at = std::ranges::find(steps_, swath, &RouteStep::swath);
    return at == steps_.end() ? -1 : static_cast<int>(at - steps_.begin());
}

void SwathOrder::show() {
    // A draft of another order comes and goes.
    if (shown_.isDraft() || shown_.plan() == plan_) {
        return;
    }
    const auto before = std::exchange(plan_, shown_.plan());
    std::vector<RouteStep> steps = plan_ ? plan_->route.steps : std::vector<RouteStep>{};
    // Numbers of other swaths mean nothing here.
    if (!before || !plan_ || before->swaths.swaths.size() != plan_->swaths.swaths.size()) {
        pointed_.clear();
        emit currentChanged();
    }
    const std::size_t swath = current_ >= 0 && current_ < rowCount()
                                  ? steps_[static_cast<std::size_t>(current_)].swath
                                  : steps.size();
    if (steps != steps_) {
        beginResetModel();
        steps_ = std::move(steps);
        endResetModel();
    }
    setCurrent(rowOf(swath));
    emit orderChanged();
}

int SwathOrder::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(steps_.size());
}

QVariant SwathOrder::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid) || plan_ == nullptr) {
        return {};
    }
    const RouteStep& step = steps_[static_cast<std::size_t>(index.row())];
    const Swath& swath = plan_->swaths.swaths[step.swath];
    switch (role) {
        case Qt::DisplayRole:
        case NumberRole: return swath.number;
        case LengthRole: return lengthText(swath.length());
        case BearingRole: return bearingDeg(startPose(step, plan_->swaths).heading);
        default: return {};
    }
}

QHash<int, QByteArray> SwathOrder::roleNames() const {
    return {{NumberRole, "number"}, {LengthRole, "lengthText"}, {BearingRole, "bearing"}};
}

void SwathOrder::move(int from, int to) {
    if (plan_ == nullptr || from < 0 || from >= rowCount() || from == to) {
        return;
    }
    to = std::clamp(to, 0, rowCount() - 1);
    take(withStepMoved(steps_, static_cast<std::size_t>(from), static_cast<std::size_t>(to), plan_->swaths));
    setCurrent(to);
}

void SwathOrder::turn(int row) {
    if (plan_ != nullptr && row >= 0 && row < rowCount()) {
        take(withStepTurned(steps_, static_cast<std::size_t>(row), plan_->swaths));
        setCurrent(row);
    }
}

void SwathOrder::point(int segment) {
    if (!pointing_ || plan_ == nullptr || shown_.plan() == nullptr || segment < 0 ||
        segment >= static_cast<int>(shown_.plan()->path.segments.size())) {
        return;
    }
    const PathSegment& clicked = shown_.plan()->path.segments[static_cast<std::size_t>(segment)];
    if (clicked.kind != SegmentKind::Swath) {
        return;
    }
    const int row = rowOf(static_cast<std::size_t>(clicked.number - 1));
    if (row < 0 || row == current_) {
        return;
    }
    const std::size_t swath = steps_[static_cast<std::size_t>(row)].swath;
    std::erase(pointed_, swath);
    pointed_.push_back(swath);
    if (pointed_.size() == 1) {
        setCurrent(row);
    } else {
        move(row, row < current_ ? current_ : current_ + 1);
    }
    emit currentChanged();
}

int SwathOrder::segmentOf(int row) const {
    if (plan_ == nullptr || shown_.plan() != plan_ || row < 0 || row >= rowCount()) {
        return -1;
    }
    const int number = plan_->swaths.swaths[steps_[static_cast<std::size_t>(row)].swath].number;
    const auto& segments = plan_->path.segments;
    const auto at = std::ranges::find_if(segments, [number](const PathSegment& segment) {
        return segment.kind == SegmentKind::Swath && segment.number == number;
    });
    return at == segments.end() ? -1 : static_cast<int>(at - segments.begin());
}

void SwathOrder::searchOthers() {
    std::vector<RouteStep> locked;
    locked.reserve(pointed_.size());
    for (const std::size_t swath : pointed_) {
        locked.push_back(steps_[static_cast<std::size_t>(rowOf(swath))]);
    }
    Settings settings = withoutOrder(document_.project()->plan().settings);
    settings.set(kLocked, orderText(locked)).value();
    change([] { return tr("Search the order of the other swaths"); }, settings);
}

void SwathOrder::searchAll() {
    change([] { return tr("Search the order"); }, withoutOrder(document_.project()->plan().settings));
}

void SwathOrder::take(std::vector<RouteStep> steps) {
    beginResetModel();
    steps_ = std::move(steps);
    endResetModel();
    Settings settings = withoutOrder(document_.project()->plan().settings);
    settings.set(*stageMethod("route"), ownOrderId()).value();
    settings.set(kOrder, orderText(steps_)).value();
    change([] { return tr("Change the order of swaths"); }, settings);
}

void SwathOrder::change(const LazyText& text, const Settings& settings) {
    const Project& project = *document_.project();
    document_.change(text, withPlan(project, project.plan().machine, settings));
    emit orderChanged();
}

}  // namespace furrow
