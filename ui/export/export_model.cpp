#include "ui/export/export_model.h"

#include "planner/io/delivery/farm_files.h"
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

ExportModel::ExportModel(Document& document, const MadePlans& made, QObject* parent)
    : QAbstractListModel{parent}, document_{document}, made_{made} {
    for (const Format& format : planFormats()) {
        const auto standard = standardPlanFormats();
        checked_.push_back(std::ranges::find(standard, format.id) != standard.end());
    }
    connect(&runner_, &JobRunner::progressChanged, this, &ExportModel::progressChanged);
    connect(&stick_, &StickExport::planned, this, &ExportModel::planned);
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
    if (isSeveral()) {
        // They go out as they were when they were asked for.
        return;
    }
    if (otherPlan && state_ == State::Writing) {
        runner_.cancel();
        setState(State::Failed, stoppedText, stoppedRemedy);
    } else if (otherPlan && state_ == State::Done) {
        clear();
    }
}

void ExportModel::setChosen(const QStringList& chosen) {
    if (state_ == State::Writing) {
        return;
    }
    if (chosen != chosen_) {
        chosen_ = chosen;
        clear();
    }
    stick_.setFields(fields());
    emit planChanged();
}

std::vector<FieldToExport> ExportModel::fields() const {
    return fieldsToExport(*document_.project(), chosen_, title_.plan, made_);
}

QString ExportModel::heading() const {
    return isSeveral() ? tr("%n field(s)", nullptr, static_cast<int>(chosen_.size())) : title_.heading();
}

QString ExportModel::details() const {
    return isSeveral() ? namesOf(fields()) : title_.details();
}

QString ExportModel::refusal() const {
    if (isSeveral()) {
        return {};
    }
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
    QString name = isSeveral() ? fromStd(document_.project()->name).simplified()
                   : title_    ? fromStd(title_.plan->field().name()).simplified()
                               : QString{};
    static const QRegularExpression unsafe{QStringLiteral(R"([\\/:*?"<>|])")};
    name.replace(unsafe, QStringLiteral("_"));
    return QDir{QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)}.filePath(
        !name.isEmpty() ? tr("Furrow %1").arg(name)
        : isSeveral()   ? tr("Furrow plans")
                        : tr("Furrow plan"));
}

void ExportModel::writeTo(const QString& folder) {
    if ((!title_ && !isSeveral()) || folder.trimmed().isEmpty() || state_ == State::Writing) {
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
    if (isSeveral()) {
        writeSeveral(path, ids);
        return;
    }
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
                fail(written.error());
            }
        };
    });
}

void ExportModel::writeSeveral(const std::filesystem::path& folder,
                               const std::vector<std::string_view>& ids) {
    struct Outcome {
        FieldsExported exported;
        int files = 0;
        std::vector<Message> notes;
        ExportChecks checks;

        void add(const WrittenFiles& written) {
            files += static_cast<int>(written.files.size());
            for (const Message& note : written.notes) {
                if (!std::ranges::contains(notes, note)) {
                    notes.push_back(note);
                }
            }
            checks.add(written.checks);
        }
    };
    runner_.submit([this, folder, ids, fields = fields()](const JobContext& job) -> JobRunner::Delivery {
        Outcome outcome;
        const auto written = FarmFolder::at(folder, ids)
                                 .and_then([&](FarmFolder farm) {
                                     return exportEach(
                                                fields,
                                                [&](const Plan& plan, const JobContext& part) {
                                                    return farm.add(plan, part)
                                                        .transform([&outcome](const WrittenFiles& files) {
                                                            outcome.add(files);
                                                        });
                                                },
                                                job.part(0.0, 0.95))
                                         .and_then([&](const FieldsExported& exported) {
                                             outcome.exported = exported;
                                             return farm.finish(job.part(0.95, 1.0));
                                         });
                                 })
                                 .transform([&outcome](const WrittenFiles& files) { outcome.add(files); });
        return [this, written, outcome, place = QString::fromStdU16String(folder.u16string())] {
            exported_ = outcome.exported;
            emit planned(exported_.made);
            notes_ = outcome.notes;
            checks_ = outcome.checks;
            if (!written) {
                fail(written.error());
            } else if (outcome.exported.written.empty()) {
                setState(State::Failed, [] { return tr("None of the fields could be exported."); });
            } else {
                setState(State::Done, [place, done = static_cast<int>(outcome.exported.written.size()),
                                       files = outcome.files] {
                    return tr("%n field(s) written to %1", nullptr, done).arg(place) + QStringLiteral(": ") +
                           tr("%n file(s)", nullptr, files);
                });
            }
        };
    });
}

void ExportModel::fail(const Error& error) {
    const Message what =
        error.where.empty() ? error.what : furrow::message("{} ({})", error.what, error.where);
    setState(
        State::Failed, [what] { return sentence(what); },
        [remedy = error.remedy] { return sentence(remedy); });
}

void ExportModel::cancel() {
    if (state_ == State::Writing) {
        runner_.cancel();
        setState(
            State::Failed, [] { return tr("Writing was stopped."); },
            [several = isSeveral()] {
                return several ? tr("Fields that were written before stay in the folder.") : QString{};
            });
    }
}

void ExportModel::clear() {
    written_ = {};
    notes_.clear();
    checks_ = {};
    exported_ = {};
    setState(State::Idle);
}

void ExportModel::setState(State state, LazyText message, LazyText remedy) {
    state_ = state;
    message_ = std::move(message);
    remedy_ = std::move(remedy);
    emit stateChanged();
}

}  // namespace furrow
