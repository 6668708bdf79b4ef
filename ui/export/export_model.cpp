#include "ui/export/export_model.h"

#include "planner/io/delivery/plan_folder.h"
#include "planner/io/formats/registry.h"
#include "ui/text/display.h"
#include "ui/text/message_text.h"
#include "ui/text/unit_text.h"

#include <QDir>
#include <QRegularExpression>
#include <QStandardPaths>

#include <algorithm>

namespace furrow {

namespace {

std::vector<Format> planFormats() {
    std::vector<Format> written;
    std::ranges::copy_if(formats(), std::back_inserter(written), &Format::writes);
    return written;
}

const Format& formatAt(int row) {
    static const std::vector<Format> all = planFormats();
    return all[static_cast<std::size_t>(row)];
}

}  // namespace

ExportModel::ExportModel(QObject* parent) : QAbstractListModel{parent} {
    for (const Format& format : planFormats()) {
        const auto standard = standardPlanFormats();
        checked_.push_back(std::ranges::find(standard, format.id) != standard.end());
    }
    connect(&Display::instance(), &Display::changed, this, [this] {
        emit dataChanged(index(0), index(rowCount() - 1));
        emit planChanged();
        emit stateChanged();
    });
}

void ExportModel::setPlan(const PlanTitle& title, PlanState state) {
    const bool otherPlan = title.plan != title_.plan;
    title_ = title;
    planState_ = state;
    emit planChanged();
    stick_.setPlan(title);
    if (otherPlan && state_ == State::Writing) {
        runner_.cancel();
        setState(State::Failed, stoppedText, stoppedRemedy);
    } else if (otherPlan && state_ == State::Done) {
        clear();
    }
}

QString ExportModel::refusal() const {
    switch (planState_) {
        case PlanState::Ready:
        case PlanState::Problems: return {};
        case PlanState::Empty: return tr("There is no field yet, and no plan to export.");
        case PlanState::Reading:
        case PlanState::Choosing:
            return tr("A field is being opened. Its plan can be exported when it is finished.");
        case PlanState::Planning:
            return tr("The plan is still being made. It can be exported when it is finished.");
        case PlanState::OutOfDate:
            return tr(
                "The plan is out of date: the field, the machine or a setting was changed after it was made.");
        case PlanState::Failed: return tr("There is no plan to export. The message on the map says why.");
    }
    return {};
}

int ExportModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(checked_.size());
}

QVariant ExportModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
        return {};
    }
    switch (role) {
        case Qt::DisplayRole:
        case NameRole: return shown(formatAt(index.row()).name);
        case HintRole: return shown(formatAt(index.row()).carries);
        case CheckedRole: return static_cast<bool>(checked_[static_cast<std::size_t>(index.row())]);
        default: return {};
    }
}

QHash<int, QByteArray> ExportModel::roleNames() const {
    return {{NameRole, "name"}, {HintRole, "hint"}, {CheckedRole, "checked"}};
}

void ExportModel::setChecked(int row, bool checked) {
    if (row < 0 || row >= rowCount() || checked_[static_cast<std::size_t>(row)] == checked) {
        return;
    }
    checked_[static_cast<std::size_t>(row)] = checked;
    emit dataChanged(index(row), index(row), {CheckedRole});
}

QString ExportModel::suggestedFolder() const {
    QString name = title_ ? fromStd(title_.plan->field().name()).simplified() : QString{};
    static const QRegularExpression unsafe{QStringLiteral(R"([\\/:*?"<>|])")};
    name.replace(unsafe, QStringLiteral("_"));
    return QDir{QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)}.filePath(
        name.isEmpty() ? tr("Furrow plan") : tr("Furrow %1").arg(name));
}

void ExportModel::writeTo(const QString& folder) {
    if (!title_ || folder.trimmed().isEmpty() || state_ == State::Writing) {
        return;
    }
    std::vector<std::string_view> ids;
    for (int row = 0; row < rowCount(); ++row) {
        if (checked_[static_cast<std::size_t>(row)]) {
            ids.push_back(formatAt(row).id);
        }
    }
    setState(State::Writing, [] { return tr("Writing …"); });
    const std::filesystem::path path{QDir::cleanPath(folder.trimmed()).toStdU16String()};
    runner_.submit([this, title = title_, path, ids](const JobContext& job) -> JobRunner::Delivery {
        auto written = writePlanFolder(*title.plan, path, ids, job);
        return [this, title, written = std::move(written), path] {
            if (written) {
                written_ = title;
                notes_ = written->notes;
                checks_ = written->checks;
                setState(State::Done, [count = static_cast<int>(written->files.size()),
                                       place = QString::fromStdU16String(path.u16string())] {
                    return tr("%n file(s) written to %1", nullptr, count).arg(place);
                });
            } else {
                const Error& error = written.error();
                const Message what =
                    error.where.empty() ? error.what : furrow::message("{} ({})", error.what, error.where);
                setState(
                    State::Failed, [what] { return sentence(what); },
                    [remedy = error.remedy] { return sentence(remedy); });
            }
        };
    });
}

void ExportModel::clear() {
    written_ = {};
    notes_.clear();
    checks_ = {};
    setState(State::Idle);
}

void ExportModel::setState(State state, LazyText message, LazyText remedy) {
    state_ = state;
    message_ = std::move(message);
    remedy_ = std::move(remedy);
    emit stateChanged();
}

}  // namespace furrow
