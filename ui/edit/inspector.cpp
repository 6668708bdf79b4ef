#include "ui/edit/inspector.h"

#include "planner/units/angle.h"
#include "ui/text/display.h"

#include <algorithm>

namespace furrow {

void Inspector::setEditor(FieldEditor* editor) {
    editor_ = editor;
    connect(editor_, &FieldEditor::selectionChanged, this, &Inspector::follow);
    connect(&Display::instance(), &Display::changed, this, &Inspector::follow);
    follow();
    emit editorChanged();
}

void Inspector::follow() {
    std::optional<InspectorText> text;
    if (editor_->document() != nullptr && editor_->shown() != nullptr) {
        const ProjectField* field = editor_->document()->project()->field();
        text =
            inspectorText(editor_->selection(), editor_->shape() ? &*editor_->shape() : nullptr,
                          field == nullptr ? nullptr : field->source.get(), editor_->shown()->plan().get());
    }
    askForOptions();
    if (text && options_) {
        addOptions(*text, *options_);
    }
    if (text == text_) {
        return;
    }
    // The same lines with other figures, as while something is dragged, keep what has the keyboard.
    const bool sameRows =
        text && text_ && std::ranges::equal(text->rows, text_->rows, [](const auto& a, const auto& b) {
            return a.label == b.label && a.field == b.field;
        });
    if (!sameRows) {
        beginResetModel();
    }
    text_ = std::move(text);
    if (!sameRows) {
        endResetModel();
    } else if (rowCount() > 0) {
        emit dataChanged(index(0), index(rowCount() - 1));
    }
    emit changed();
}

void Inspector::askForOptions() {
    const std::shared_ptr<const Plan> plan = editor_->shown() == nullptr ? nullptr : editor_->shown()->plan();
    const int segment = plan == nullptr ? -1 : editor_->selectedSegment();
    const bool isTurn = segment >= 0 && segment < static_cast<int>(plan->path.segments.size()) &&
                        plan->path.segments[static_cast<std::size_t>(segment)].kind == SegmentKind::Turn;
    const std::pair wanted{isTurn ? plan : nullptr, isTurn ? segment : -1};
    if (wanted == askedOf_) {
        return;
    }
    askedOf_ = wanted;
    options_.reset();
    optionsAsker_.cancel();
    if (!isTurn || plan->request.draft) {
        return;
    }
    optionsAsker_.submit([this, wanted](const JobContext& job) -> JobRunner::Delivery {
        auto options = turnOptions(*wanted.first, static_cast<std::size_t>(wanted.second), job);
        return [this, wanted, options = std::move(options)] {
            if (options && *options && wanted == askedOf_) {
                options_ = *options;
                follow();
            }
        };
    });
}

int Inspector::rowCount(const QModelIndex& parent) const {
    return parent.isValid() || !text_ ? 0 : static_cast<int>(text_->rows.size());
}

QVariant Inspector::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
        return {};
    }
    const InspectorRow& row = at(index.row());
    switch (role) {
        case Qt::DisplayRole:
        case LabelRole: return row.label;
        case TextRole: return row.text;
        case KindRole:
            return static_cast<int>(row.field == InspectorField::None   ? Kind::Figure
                                    : row.field == InspectorField::Name ? Kind::Text
                                                                        : Kind::Number);
        case NumberRole: return row.number;
        case QuantityRole: return row.quantity;
        case DecimalsRole: return row.decimals;
        case FromRole: return row.from;
        case ToRole: return row.to;
        default: return {};
    }
}

QHash<int, QByteArray> Inspector::roleNames() const {
    return {
        {LabelRole, "label"},       {TextRole, "text"},         {KindRole, "kind"}, {NumberRole, "number"},
        {QuantityRole, "quantity"}, {DecimalsRole, "decimals"}, {FromRole, "from"}, {ToRole, "to"}};
}

void Inspector::setNumber(int row, double number) {
    if (row < 0 || row >= rowCount()) {
        return;
    }
    const Selection& selection = editor_->selection();
    switch (at(row).field) {
        case InspectorField::Latitude:
        case InspectorField::Longitude: {
            GeoPoint place = editor_->shape()->find(selection.outline)->places[selection.index];
            (at(row).field == InspectorField::Latitude ? place.latDeg : place.lonDeg) = number;
            editor_->setVertex(place);
            break;
        }
        case InspectorField::EdgeLength: editor_->setEdgeLength(metres(number)); break;
        case InspectorField::EdgeBearing: editor_->setEdgeHeading(degrees(90.0 - number)); break;
        case InspectorField::EdgeHeadland: editor_->setEdgeHeadland(metres(number)); break;
        case InspectorField::EdgeOverhang: editor_->setEdgeOverhang(metres(number)); break;
        case InspectorField::Buffer: editor_->setBuffer(metres(number)); break;
        case InspectorField::ObstacleOverhang: editor_->setObstacleOverhang(metres(number)); break;
        case InspectorField::GateWidth: editor_->setGateWidth(metres(number)); break;
        case InspectorField::Name:
        case InspectorField::None: break;
    }
}

void Inspector::setText(int row, const QString& text) {
    if (row >= 0 && row < rowCount() && at(row).field == InspectorField::Name) {
        editor_->setName(text);
    }
}

void Inspector::setPassable(bool passable) {
    if (hasPassable() && passable != isPassable()) {
        editor_->setPassable(passable);
    }
}

}  // namespace furrow
