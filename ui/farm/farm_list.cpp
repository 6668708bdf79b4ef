#include "ui/farm/farm_list.h"

#include "planner/io/import/boundary_import.h"
#include "planner/project/plan_key.h"
#include "planner/project/project_edits.h"
#include "ui/map/map_frame.h"
#include "ui/project/field_outline.h"
#include "ui/text/display.h"
#include "ui/text/unit_text.h"

#include <QCollator>

#include <algorithm>
#include <numeric>
#include <utility>

namespace furrow {

namespace {

QGeoRectangle boundsOf(const FieldSource& source) {
    QGeoRectangle bounds;
    for (const GeoPolygon& part : source.parts) {
        for (const GeoPoint& point : part.outer) {
            const QGeoCoordinate place = coordinate(point);
            if (!place.isValid()) {
                continue;
            }
            if (bounds.isValid()) {
                bounds.extendRectangle(place);
            } else {
                bounds = QGeoRectangle{place, place};
            }
        }
    }
    return bounds;
}

bool holds(const FieldSource& source, GeoPoint place) {
    const auto holds = [place](const GeoRing& outline) {
        Ring ring;
        for (const GeoPoint& point : outline) {
            ring.push_back({point.lonDeg, point.latDeg});
        }
        return isInside(ring, Point{place.lonDeg, place.latDeg});
    };
    return std::ranges::any_of(source.parts, [&](const GeoPolygon& part) {
        return holds(part.outer) && std::ranges::none_of(part.holes, holds);
    });
}

}  // namespace

FarmList::FarmList(Document& document, FarmPlans& plans, QObject* parent)
    : QAbstractListModel{parent}, document_{document}, plans_{plans} {
    connect(&document_, &Document::begun, this, [this] {
        selected_.clear();
        anchor_.clear();
        filter_.clear();
    });
    connect(&document_, &Document::projectChanged, this, &FarmList::follow);
    connect(&document_, &Document::dragEnded, this, &FarmList::follow);
    connect(&plans_, &FarmPlans::resultsChanged, this, &FarmList::refresh);
    connect(&Display::instance(), &Display::changed, this, &FarmList::refresh);
    follow();
}

void FarmList::follow() {
    if (document_.isDragging()) {
        return;
    }
    const Project& project = *document_.project();
    std::vector<Entry> entries;
    for (std::size_t i = 0; i < project.fields.size(); ++i) {
        const auto& field = project.fields[i];
        const FieldPlan& shown = project.planOf(i);
        const auto plan = static_cast<std::size_t>(&shown - field->plans.data());
        const auto known = std::ranges::find_if(
            entries_, [&](const Entry& old) { return old.field == field && old.plan == plan; });
        entries.push_back(known != entries_.end() ? *known
                                                  : Entry{.field = field,
                                                          .plan = plan,
                                                          .key = planKey(*field->source, shown),
                                                          .area = areaOf(*field->source),
                                                          .bounds = boundsOf(*field->source)});
    }
    const bool sameRows = std::ranges::equal(
        entries, entries_, [](const Entry& a, const Entry& b) { return a.field->id == b.field->id; });
    std::erase_if(selected_, [&entries](const std::string& id) {
        return std::ranges::none_of(entries, [&id](const Entry& entry) { return entry.field->id == id; });
    });
    if (sameRows) {
        entries_ = std::move(entries);
        refresh();
        return;
    }
    beginResetModel();
    entries_ = std::move(entries);
    arrange();
    endResetModel();
    emit rowsChanged();
    emit totalsChanged();
}

void FarmList::refresh() {
    if (count() > 0) {
        emit dataChanged(index(0), index(count() - 1));
    }
    emit totalsChanged();
}

bool FarmList::matches(const Entry& entry) const {
    const FieldPlan& plan = planOf(entry);
    const QString all = fromStd(entry.field->source->name) + u' ' + fromStd(plan.name) + u' ' +
                        fromStd(plan.season) + u' ' + shown(plan.machine.name()) + u' ' + stateText(entry);
    return std::ranges::all_of(filter_.split(u' ', Qt::SkipEmptyParts), [&all](const QString& word) {
        return all.contains(word, Qt::CaseInsensitive);
    });
}

bool FarmList::comesBefore(std::size_t a, std::size_t b) const {
    const Entry& left = entries_[a];
    const Entry& right = entries_[b];
    const PlanResult* const mine = plans_.resultOf(left.key);
    const PlanResult* const its = plans_.resultOf(right.key);
    switch (column_) {
        case Area: return left.area < right.area;
        // Those without a plan have none of these.
        case Time:
            return (mine != nullptr ? mine->duration : Duration{}) <
                   (its != nullptr ? its->duration : Duration{});
        case Way:
            return (mine != nullptr ? mine->length : Length{}) < (its != nullptr ? its->length : Length{});
        case State: return stateOf(left) < stateOf(right);
        case Name:
        case Machine: break;
    }
    // "Field 9" before "Field 10".
    QCollator collator;
    collator.setNumericMode(true);
    collator.setCaseSensitivity(Qt::CaseInsensitive);
    const auto text = [this](const Entry& entry) {
        return column_ == Name ? fromStd(entry.field->source->name) : shown(planOf(entry).machine.name());
    };
    return collator.compare(text(left), text(right)) < 0;
}

void FarmList::arrange() {
    order_.resize(entries_.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::erase_if(order_, [this](std::size_t i) { return !matches(entries_[i]); });
    if (!inProjectOrder_) {
        std::ranges::stable_sort(order_, [this](std::size_t a, std::size_t b) {
            return descending_ ? comesBefore(b, a) : comesBefore(a, b);
        });
    }
}

void FarmList::setFilter(const QString& filter) {
    if (filter == filter_) {
        return;
    }
    beginResetModel();
    filter_ = filter;
    arrange();
    endResetModel();
    emit rowsChanged();
    emit totalsChanged();
}

void FarmList::sortBy(Column column) {
    beginResetModel();
    descending_ = !inProjectOrder_ && column == column_ && !descending_;
    column_ = column;
    inProjectOrder_ = false;
    arrange();
    endResetModel();
    emit rowsChanged();
}

void FarmList::pick(int row, Pick how) {
    if (row < 0 || row >= count()) {
        return;
    }
    const std::string& id = field(row).id;
    if (how == Toggle) {
        if (selected_.erase(id) == 0) {
            selected_.insert(id);
        }
    } else {
        selected_.clear();
        int from = row;
        for (int i = 0; how == UpTo && i < count(); ++i) {
            from = field(i).id == anchor_ ? i : from;
        }
        for (int i = std::min(from, row); i <= std::max(from, row); ++i) {
            selected_.insert(field(i).id);
        }
    }
    if (how != UpTo) {
        anchor_ = id;
    }
    refresh();
}

void FarmList::selectAll() {
    for (int row = 0; row < count(); ++row) {
        selected_.insert(field(row).id);
    }
    refresh();
}

void FarmList::selectNone() {
    selected_.clear();
    refresh();
}

void FarmList::open(int row) {
    if (row >= 0 && row < count() && row != rowOfCurrent()) {
        document_.look(showing(*document_.project(), order_[static_cast<std::size_t>(row)], 0));
    }
}

int FarmList::rowOfCurrent() const {
    const auto found = std::ranges::find(order_, document_.project()->currentField);
    return found == order_.end() ? -1 : static_cast<int>(found - order_.begin());
}

std::vector<std::size_t> FarmList::chosen() const {
    if (selected_.empty()) {
        std::vector<std::size_t> fields = order_;
        std::ranges::sort(fields);
        return fields;
    }
    std::vector<std::size_t> fields;
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        if (selected_.contains(entries_[i].field->id)) {
            fields.push_back(i);
        }
    }
    return fields;
}

QStringList FarmList::chosenIds() const {
    QStringList ids;
    for (const std::size_t i : chosen()) {
        ids << fromStd(entries_[i].field->id);
    }
    return ids;
}

void FarmList::planSelected() {
    plans_.plan(chosen());
}

void FarmList::planLikeCurrent() {
    const Project& project = *document_.project();
    document_.change(
        [count = static_cast<int>(chosen().size())] { return tr("Plan %n field(s) alike", nullptr, count); },
        withPlansLike(project, chosen(), project.plan()));
}

void FarmList::addPlans(const QString& name, const QString& season) {
    document_.change([count = static_cast<int>(
                          chosen().size())] { return tr("Add a plan to %n field(s)", nullptr, count); },
                     withPlansAdded(*document_.project(), chosen(), name.trimmed().toStdString(),
                                    season.trimmed().toStdString()));
}

QGeoRectangle FarmList::bounds() const {
    QGeoRectangle all;
    for (const Entry& entry : entries_) {
        if (entry.bounds.isValid()) {
            all = all.isValid() ? all.united(entry.bounds) : entry.bounds;
        }
    }
    return all;
}

int FarmList::rowAt(const QGeoCoordinate& place) const {
    for (int row = 0; row < count(); ++row) {
        if (entry(row).bounds.contains(place) && holds(*field(row).source, geoPoint(place))) {
            return row;
        }
    }
    return -1;
}

const ProjectField& FarmList::field(int row) const {
    return *entry(row).field;
}

bool FarmList::isSelected(int row) const {
    return selected_.contains(field(row).id);
}

FarmList::PlanState FarmList::stateOf(int row) const {
    return stateOf(entry(row));
}

FarmList::PlanState FarmList::stateOf(const Entry& entry) const {
    if (plans_.isUnderWay(*entry.field)) {
        return Planning;
    }
    if (plans_.isWaiting(*entry.field)) {
        return Waiting;
    }
    if (const PlanResult* result = plans_.resultOf(entry.key)) {
        return result->drivable() ? Drivable : Problems;
    }
    if (plans_.errorOf(entry.key) != nullptr) {
        return Failed;
    }
    return plans_.wasPlanned(*entry.field, planOf(entry)) ? OutOfDate : NoPlan;
}

QString FarmList::stateText(const Entry& entry) const {
    switch (stateOf(entry)) {
        case NoPlan: return tr("Not planned yet");
        case OutOfDate: return tr("Out of date");
        case Waiting: return tr("Waits");
        case Planning: return tr("Planning …");
        case Drivable: return tr("Drivable");
        case Problems: return tr("%n problem(s)", nullptr, plans_.resultOf(entry.key)->blocking);
        case Failed: break;
    }
    return tr("No plan");
}

QString FarmList::hint(const Entry& entry) const {
    const Error* const error = stateOf(entry) == Failed ? plans_.errorOf(entry.key) : nullptr;
    return error == nullptr ? QString{} : sentence(error->what);
}

QString FarmList::totals() const {
    furrow::Area area;
    Duration duration;
    int drivable = 0;
    int all = 0;
    for (const std::size_t i : chosen()) {
        const Entry& entry = entries_[i];
        area = area + entry.area;
        ++all;
        if (const PlanResult* result = plans_.resultOf(entry.key)) {
            duration = duration + result->duration;
            drivable += result->drivable() ? 1 : 0;
        }
    }
    if (all == 0) {
        return {};
    }
    QStringList parts{selected_.empty() && filter_.trimmed().isEmpty()
                          ? tr("%n field(s)", nullptr, all)
                          : tr("%1 of %n field(s)", nullptr, static_cast<int>(entries_.size())).arg(all),
                      areaText(area)};
    if (duration > Duration{}) {
        parts << durationText(duration);
    }
    parts << tr("%1 drivable").arg(drivable);
    return inOneLine(parts);
}

int FarmList::toPlan() const {
    return static_cast<int>(std::ranges::count_if(chosen(), [this](std::size_t i) {
        const PlanState state = stateOf(entries_[i]);
        return state == NoPlan || state == OutOfDate || state == Failed;
    }));
}

int FarmList::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : count();
}

QVariant FarmList::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
        return {};
    }
    const Entry& shownEntry = entry(index.row());
    const FieldPlan& plan = planOf(shownEntry);
    const PlanResult* const result = plans_.resultOf(shownEntry.key);
    switch (role) {
        case Qt::DisplayRole:
        case NameRole: return fromStd(shownEntry.field->source->name);
        case PlanRole: {
            QStringList parts{fromStd(plan.name), fromStd(plan.season)};
            parts.removeAll(QString{});
            return inOneLine(parts);
        }
        case MachineRole: return shown(plan.machine.name());
        case AreaRole: return areaText(shownEntry.area);
        case TimeRole: return result == nullptr ? QString{} : durationText(result->duration);
        case WayRole: return result == nullptr ? QString{} : lengthText(result->length);
        case StateRole: return stateOf(shownEntry);
        case StateTextRole: return stateText(shownEntry);
        case HintRole: return hint(shownEntry);
        case OutlineRole: return QVariant::fromValue(fieldOutline(*shownEntry.field->source));
        case SelectedRole: return isSelected(index.row());
        case CurrentRole: return index.row() == rowOfCurrent();
        case BoundsRole: return QVariant::fromValue(shownEntry.bounds);
        default: return {};
    }
}

QHash<int, QByteArray> FarmList::roleNames() const {
    return {{NameRole, "name"},       {PlanRole, "plan"},           {MachineRole, "machine"},
            {AreaRole, "area"},       {TimeRole, "time"},           {WayRole, "way"},
            {StateRole, "planState"}, {StateTextRole, "stateText"}, {HintRole, "hint"},
            {OutlineRole, "outline"}, {SelectedRole, "selected"},   {CurrentRole, "current"},
            {BoundsRole, "bounds"}};
}

}  // namespace furrow
