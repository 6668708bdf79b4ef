#include "ui/export/stick_export.h"

#include "planner/io/content/plan_content.h"
#include "planner/io/delivery/farm_files.h"
#include "planner/io/delivery/stick_writer.h"
#include "planner/io/delivery/terminals.h"
#include "ui/files/sticks.h"
#include "ui/text/display.h"
#include "ui/text/message_text.h"
#include "ui/text/unit_text.h"

#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <QSettings>
#include <QStorageInfo>

#include <algorithm>
#include <ranges>
#include <utility>

namespace furrow {

namespace {

constexpr int kLookEveryMs = 1000;
constexpr auto kTerminalKey = "export/terminal";

/// Those that go on a stick.
const std::vector<const Terminal*>& stickTerminals() {
    static const std::vector<const Terminal*> all = [] {
        std::vector<const Terminal*> chosen;
        for (const Terminal& terminal : terminals()) {
            if (terminal.onStick) {
                chosen.push_back(&terminal);
            }
        }
        return chosen;
    }();
    return all;
}

/// As people call them: Linux says vfat to all kinds of FAT.
QString fileSystemName(const QByteArray& type) {
    if (type == "vfat" || type == "msdos") {
        return QStringLiteral("FAT32");
    }
    return type == "fuseblk" || type.startsWith("ntfs") ? QStringLiteral("NTFS")
           : type == "exfat"                            ? QStringLiteral("exFAT")
                                                        : QString::fromLatin1(type);
}

QString detailOf(const QString& place, const QStorageInfo& volume) {
    const QLocale locale;
    const QString room =
        StickExport::tr("%1 free of %2")
            .arg(locale.formattedDataSize(volume.bytesAvailable(), 1, QLocale::DataSizeSIFormat),
                 locale.formattedDataSize(volume.bytesTotal(), 1, QLocale::DataSizeSIFormat));
    return inOneLine({place, fileSystemName(volume.fileSystemType()), room});
}

std::vector<StickExport::Stick> sticks() {
    std::vector<StickExport::Stick> all;
    for (const QStorageInfo& volume : pluggedIn()) {
        all.push_back({volume.rootPath(), nameOf(volume), detailOf(volume.rootPath(), volume)});
    }
    return all;
}

QString joined(const std::vector<std::filesystem::path>& paths) {
    QStringList names;
    for (const std::filesystem::path& path : paths) {
        names << QString::fromStdU16String(path.u16string());
    }
    return names.join(QStringLiteral(", "));
}

/// The files of fields under their names, as far as they can be told before the fields are planned.
Result<FormatFiles> filesWithoutPlans(const Terminal& terminal, const std::vector<FieldToExport>& fields,
                                      const JobContext& job) {
    FarmOnStick farm{terminal};
    for (const FieldToExport& field : fields) {
        // One that cannot be written is told when the others are.
        (void)farm.add(*field.field->source, job);
    }
    return farm.files(job);
}

}  // namespace

QString stoppedText() {
    return StickExport::tr("Writing was stopped, because the plan was changed meanwhile.");
}

QString stoppedRemedy() {
    return StickExport::tr("Write it again when the plan is finished.");
}

StickExport::StickExport(QObject* parent) : QAbstractListModel{parent}, lister_{sticks} {
    timer_.setInterval(kLookEveryMs);
    connect(this, &StickExport::terminalChanged, this, &StickExport::textsChanged);
    connect(&Display::instance(), &Display::changed, this, [this] {
        emit textsChanged();
        emit examined();
        emit stateChanged();
        if (searching()) {
            refresh();
        }
    });
    connect(&timer_, &QTimer::timeout, this, &StickExport::refresh);
    connect(&runner_, &JobRunner::progressChanged, this, &StickExport::progressChanged);
    // The terminal of last time, or the one that most stand for.
    const QString last = QSettings{}.value(kTerminalKey, QStringLiteral("isobus")).toString();
    const auto& all = stickTerminals();
    const auto known = std::ranges::find(all, last.toStdString(),
                                         [](const Terminal* terminal) { return std::string{terminal->id}; });
    terminal_ = known == all.end() ? 0 : static_cast<int>(known - all.begin());
}

void StickExport::setPlan(const PlanTitle& title) {
    const bool otherPlan = title.plan != title_.plan;
    title_ = title;
    // Several fields go out as they were when they were asked for.
    if (!otherPlan || !fields_.empty()) {
        return;
    }
    // What was looked at on the stick, or written there, was for another plan.
    runner_.cancel();
    if (state_ == State::Writing) {
        setState(State::Failed, stoppedText, stoppedRemedy);
    } else if (state_ == State::Done) {
        clear();
    }
    if (searching()) {
        examine();
    }
}

void StickExport::setFields(std::vector<FieldToExport> fields) {
    if (state_ == State::Writing) {
        return;
    }
    fields_ = std::move(fields);
    clear();
    examine();
}

QString StickExport::writtenPlan() const {
    return writtenFields_.empty() ? writtenTitle_.whole() : namesOf(writtenFields_);
}

void StickExport::setSearching(bool searching) {
    if (searching == timer_.isActive()) {
        return;
    }
    if (searching) {
        refresh();
        timer_.start();
        examine();
    } else {
        timer_.stop();
    }
    emit searchingChanged();
}

QStringList StickExport::terminalNames() const {
    QStringList names;
    for (const Terminal* terminal : stickTerminals()) {
        names << shown(terminal->name);
    }
    return names;
}

void StickExport::setTerminal(int index) {
    if (index == terminal_ || index < 0 || index >= static_cast<int>(stickTerminals().size())) {
        return;
    }
    terminal_ = index;
    QSettings{}.setValue(kTerminalKey, fromStd(stickTerminals()[static_cast<std::size_t>(index)]->id));
    emit terminalChanged();
    clear();
    examine();
}

bool StickExport::hasTasks() const {
    return stickTerminals()[static_cast<std::size_t>(terminal_)]->hasTasks();
}

void StickExport::setTask(bool task) {
    if (task == task_) {
        return;
    }
    task_ = task;
    emit taskChanged();
    clear();
}

QString StickExport::shows() const {
    return shown(stickTerminals()[static_cast<std::size_t>(terminal_)]->shows);
}

void StickExport::setCurrent(int row) {
    if (row == current_ || row < -1 || row >= count()) {
        return;
    }
    current_ = row;
    emit currentChanged();
    clear();
    examine();
}

int StickExport::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : count();
}

QVariant StickExport::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
        return {};
    }
    const Stick& stick = sticks_[static_cast<std::size_t>(index.row())];
    switch (role) {
        case Qt::DisplayRole:
        case NameRole: return stick.name;
        case DetailRole: return stick.detail;
        default: return {};
    }
}

QHash<int, QByteArray> StickExport::roleNames() const {
    return {{NameRole, "name"}, {DetailRole, "detail"}};
}

std::vector<StickExport::Stick> StickExport::found() const {
    std::vector<Stick> all = lister_();
    for (const QString& folder : folders_) {
        if (QFileInfo{folder}.isDir()) {
            all.push_back({folder, QDir{folder}.dirName(), detailOf(folder, QStorageInfo{folder}), true});
        }
    }
    return all;
}

void StickExport::refresh() {
    std::vector<Stick> now = found();
    if (now == sticks_) {
        return;
    }
    const QString before = current_ < 0 ? QString{} : chosen().root;
    const auto rootsOf = [](const std::vector<Stick>& sticks) {
        QStringList roots;
        for (const Stick& stick : sticks) {
            roots << stick.root;
        }
        return roots;
    };
    if (rootsOf(now) == rootsOf(sticks_)) {
        sticks_ = std::move(now);
        emit dataChanged(index(0), index(count() - 1), {NameRole, DetailRole});
        return;
    }
    beginResetModel();
    sticks_ = std::move(now);
    const auto again = std::ranges::find(sticks_, before, &Stick::root);
    current_ = again != sticks_.end() ? static_cast<int>(again - sticks_.begin())
               : sticks_.size() == 1  ? 0
                                      : -1;
    endResetModel();
    emit countChanged();
    emit currentChanged();
    if (state_ != State::Writing) {
        examine();
    }
}

void StickExport::addFolder(const QUrl& folder) {
    const QString path = QDir::cleanPath(folder.toLocalFile());
    if (path.isEmpty()) {
        return;
    }
    if (!folders_.contains(path)) {
        folders_ << path;
    }
    refresh();
    const auto row = std::ranges::find(sticks_, path, &Stick::root);
    if (row != sticks_.end()) {
        setCurrent(static_cast<int>(row - sticks_.begin()));
    }
}

void StickExport::examine() {
    warnings_.clear();
    replaces_.clear();
    emit examined();
    if (!hasContent() || current_ < 0 || state_ == State::Writing) {
        return;
    }
    const std::filesystem::path root{chosen().root.toStdU16String()};
    const Terminal* terminal = stickTerminals()[static_cast<std::size_t>(terminal_)];
    // A folder is not what the terminal will read.
    const bool isFolder = chosen().isFolder;
    runner_.submit([this, plan = title_.plan, fields = fields_, root, terminal,
                    isFolder](const JobContext& job) -> JobRunner::Delivery {
        const auto stick = openStick(root);
        std::vector<Message> warnings;
        if (const auto info = stick->info(); info && !isFolder) {
            warnings = stickWarnings(*info);
        }
        const auto files =
            fields.empty() ? terminalFiles(*terminal, *plan, job) : filesWithoutPlans(*terminal, fields, job);
        const QString replaces = files ? joined(stickConflicts(*stick, *files)) : QString{};
        return [this, warnings, replaces] {
            warnings_ = warnings;
            replaces_ = replaces;
            emit examined();
        };
    });
}

void StickExport::write(bool replace) {
    if (!hasContent() || current_ < 0 || state_ == State::Writing) {
        return;
    }
    const std::filesystem::path root{chosen().root.toStdU16String()};
    const bool isFolder = chosen().isFolder;
    Terminal terminal = *stickTerminals()[static_cast<std::size_t>(terminal_)];
    terminal.options.task = task_;
    setState(State::Writing, [] { return tr("Writing …"); });
    runner_.submit([this, title = title_, fields = fields_, root, terminal, isFolder,
                    replace](const JobContext& job) -> JobRunner::Delivery {
        const auto stick = openStick(root);
        FieldsExported exported;
        Result<StickReport> report;
        if (fields.empty()) {
            const Plan* const plan = title.plan.get();
            const std::vector<FieldContent> meant{contentOf(*plan, terminal.options)};
            report = terminalFiles(terminal, *plan, job).and_then([&](const FormatFiles& files) {
                return writeToStick(*stick, files, meant, replace, job);
            });
        } else {
            FarmOnStick farm{terminal};
            const auto addTo = [&farm](const Plan& plan, const JobContext& part) {
                return farm.add(plan, part);
            };
            report = exportEach(fields, addTo, job.part(0.0, 0.7))
                         .and_then([&](const FieldsExported& each) -> Result<FormatFiles> {
                             exported = each;
                             return each.written.empty() ? std::unexpected(each.failures.front().error)
                                                         : farm.files(job);
                         })
                         .and_then([&](const FormatFiles& files) {
                             return writeToStick(*stick, files, farm.fields(), replace, job.part(0.7, 1.0));
                         });
        }
        return [this, title, exported, isFolder, report = std::move(report)] {
            exported_ = exported;
            emit planned(exported_.made);
            if (!report) {
                const Error& error = report.error();
                setState(
                    error.code == ErrorCode::Cancelled ? State::Idle : State::Failed,
                    [what = error.what] { return sentence(what); },
                    [remedy = error.remedy] { return sentence(remedy); });
                examine();
                return;
            }
            writtenTitle_ = title;
            writtenFields_ = exported.written;
            written_.clear();
            for (const std::filesystem::path& file : report->files) {
                written_ << QString::fromStdU16String(file.u16string());
            }
            notes_ = report->notes;
            checks_ = report->checks;
            backups_ = joined(report->backups);
            setState(State::Done, [isFolder, several = !writtenFields_.empty(),
                                   compared = report->contentCompared] {
                const QString checked =
                    compared
                        ? (several
                               ? tr("every byte was read back, and the fields read from there are these.")
                               : tr("every byte was read back, and the plan read from there is this plan."))
                        : tr("every byte was read back and is as written.");
                return (isFolder ? tr("Written: %1") : tr("Safe to unplug: %1")).arg(checked);
            });
        };
    });
}

void StickExport::cancel() {
    if (state_ == State::Writing) {
        runner_.cancel();
        setState(State::Idle);
        examine();
    }
}

void StickExport::clear() {
    writtenTitle_ = {};
    writtenFields_.clear();
    exported_ = {};
    written_.clear();
    notes_.clear();
    checks_ = {};
    backups_.clear();
    setState(State::Idle);
}

QStringList StickExport::notes() const {
    QStringList lines = exported_.problemTexts() + sentences(notes_);
    if (!backups_.isEmpty()) {
        lines << tr("What was there before is kept as %1.").arg(backups_);
    }
    return lines;
}

void StickExport::setState(State state, LazyText message, LazyText remedy) {
    state_ = state;
    message_ = std::move(message);
    remedy_ = std::move(remedy);
    emit stateChanged();
}

}  // namespace furrow
