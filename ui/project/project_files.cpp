#include "ui/project/project_files.h"

#include "ui/project/last_machine.h"
#include "ui/text/display.h"

#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QUuid>

#include <algorithm>
#include <utility>

namespace furrow {

namespace {

/// How long a change waits to be written: many come at once while something is dragged.
constexpr int kKeepAfterMs = 500;

const QString kJournals = QStringLiteral("*.history");
/// How the journals of projects without a file begin.
const QString kUntitled = QStringLiteral("untitled-");

std::filesystem::path toPath(const QString& path) {
    return path.toStdU16String();
}

QString fromPath(const std::filesystem::path& path) {
    return QString::fromStdU16String(path.u16string());
}

QString nameOf(const QString& path) {
    return QFileInfo{path}.completeBaseName();
}

bool isUntitled(const HistoryJournal& journal) {
    return nameOf(fromPath(journal.path())).startsWith(kUntitled);
}

}  // namespace

ProjectFiles::ProjectFiles(Document& document, QObject* parent)
    : QObject{parent}, document_{document}, journal_{std::make_shared<Journal>()} {
    idle_.setSingleShot(true);
    idle_.setInterval(kKeepAfterMs);
    connect(&idle_, &QTimer::timeout, this, &ProjectFiles::keep);
    const auto wait = [this] {
        if (!idle_.isActive()) {
            idle_.start();
        }
    };
    connect(&document_, &Document::projectChanged, this, wait);
    connect(&document_, &Document::historyChanged, this, wait);
    connect(&saver_, &JobRunner::busyChanged, this, &ProjectFiles::savingChanged);
    connect(&Display::instance(), &Display::changed, this, &ProjectFiles::messageChanged);
}

ProjectFiles::~ProjectFiles() {
    disconnect(&document_, nullptr, this, nullptr);
    flush();
    if (path_.isEmpty() && document_.history().steps.empty()) {
        useJournal(std::nullopt);
    }
}

QString ProjectFiles::name() const {
    return nameOf(path_);
}

void ProjectFiles::keepIn(const QString& folder) {
    folder_ = folder;
    useJournal(journalOf(path_));
}

std::optional<HistoryJournal> ProjectFiles::journalOf(const QString& path) {
    if (folder_.isEmpty()) {
        return std::nullopt;
    }
    const QString name =
        path.isEmpty()
            ? kUntitled + QUuid::createUuid().toString(QUuid::WithoutBraces)
            : QString::fromStdString(fingerprint(QFileInfo{path}.absoluteFilePath().toStdString()));
    auto journal = HistoryJournal::open(toPath(QDir{folder_}.filePath(name + QStringLiteral(".history"))));
    if (!journal) {
        tell(Trouble::NotKept, journal.error());
        return std::nullopt;
    }
    return std::move(*journal);
}

void ProjectFiles::useJournal(std::optional<HistoryJournal> journal) {
    const std::scoped_lock lock{journal_->mutex};
    if (journal_->file && isUntitled(*journal_->file)) {
        // Nothing of what was never saved is left behind when something else begins.
        journal_->file->remove();
    }
    journal_->file = std::move(journal);
}

bool ProjectFiles::recover() {
    for (const QFileInfo& info : QDir{folder_}.entryInfoList({kJournals}, QDir::Files, QDir::Time)) {
        auto journal = HistoryJournal::open(toPath(info.filePath()));
        if (!journal) {
            continue;
        }
        std::optional<History> history = journal->read();
        if (history && !history->file.empty()) {
            if (const auto file = readProject(history->file)) {
                recogniseSaved(*history, file->project, file->fingerprint);
            }
        }
        if (!history || !history->isUnsaved() ||
            (history->file.empty() && history->current()->fields.empty())) {
            if (!history || history->file.empty()) {
                journal->remove();
            }
            continue;
        }
        useJournal(std::move(*journal));
        setPath(fromPath(history->file), history->savedFingerprint);
        document_.begin(*history);
        tell(Trouble::Restored, [unnamed = path_.isEmpty(), name = name()] {
            return unnamed ? tr("Your last work was not saved. Here it is again.")
                           : tr("Changes of “%1” were not saved. Here they are again.").arg(name);
        });
        return true;
    }
    return false;
}

bool ProjectFiles::open(const QString& path, OpenedProject opened) {
    const QString whole = QFileInfo{path}.absoluteFilePath();
    flush();
    if (whole == path_) {
        // Read again: the lock on its journal would keep even this window out.
        useJournal(std::nullopt);
    }
    std::optional<HistoryJournal> journal = journalOf(whole);
    if (!journal && !folder_.isEmpty()) {
        // Whoever has it open would be written over.
        return false;
    }
    std::optional<History> kept = journal ? journal->read() : std::nullopt;
    useJournal(std::move(journal));
    setPath(whole, opened.fingerprint);
    tell(Trouble::None);
    if (kept && recogniseSaved(*kept, opened.project, opened.fingerprint)) {
        kept->file = toPath(whole);
        document_.begin(*kept);
        if (kept->isUnsaved()) {
            tell(Trouble::Restored, [name = name()] {
                return tr("Changes of “%1” were not saved. Here they are again.").arg(name);
            });
        }
        return true;
    }
    History history;
    history.base = std::make_shared<const Project>(std::move(opened.project));
    history.saved = 0;
    document_.begin(history);
    if (!opened.notes.empty()) {
        tell(
            Trouble::Notes, [notes = opened.notes] { return sentences(notes).join(QLatin1Char('\n')); },
            [] { return tr("It is kept in the file all the same."); });
    }
    if (kept && kept->isUnsaved()) {
        // The file is another one by now. What was not saved becomes a change of it, to be undone or kept.
        document_.change([] { return tr("Restore changes that were not saved"); }, Project{*kept->current()});
        tell(Trouble::Restored, [name = name()] {
            return tr("Another program changed “%1” while changes of yours were not saved. Yours are "
                      "shown; undo shows the file.")
                .arg(name);
        });
    }
    return true;
}

void ProjectFiles::begin() {
    flush();
    useJournal(journalOf({}));
    setPath({}, {});
    tell(Trouble::None);
    History history;
    history.base = std::make_shared<const Project>(freshProject());
    history.saved = 0;
    document_.begin(history);
}

void ProjectFiles::saveAs(const QUrl& file) {
    QString path = file.isLocalFile() ? file.toLocalFile() : file.toString();
    if (path.isEmpty()) {
        return;
    }
    if (QFileInfo{path}.suffix().isEmpty()) {
        path += QString::fromUtf8(kProjectExtension.data(), static_cast<qsizetype>(kProjectExtension.size()));
    }
    write(QFileInfo{path}.absoluteFilePath(), true);
}

void ProjectFiles::write(const QString& path, bool overwrite) {
    if (path.isEmpty()) {
        return;
    }
    document_.endDrag();
    saver_.submit(
        [this, path, overwrite, project = document_.project(),
         known = fingerprint_](const JobContext&) -> JobRunner::Delivery {
            const auto there = fileFingerprint(toPath(path));
            const bool changed = !overwrite && there && *there != known;
            Result<std::string> written =
                changed ? Result<std::string>{*there} : writeProject(*project, toPath(path));
            return [this, path, project, written = std::move(written), changed] {
                take(path, project, written, changed);
            };
        },
        JobRunner::Replace::WhenDone);
    emit savingChanged();
}

void ProjectFiles::take(const QString& path, const std::shared_ptr<const Project>& project,
                        Result<std::string> written, bool changedOnDisk) {
    if (!written) {
        tell(Trouble::NotSaved, written.error());
        return;
    }
    if (changedOnDisk) {
        tell(
            Trouble::ChangedOnDisk,
            [name = nameOf(path)] {
                return tr("Another program has changed “%1” since it was opened here.").arg(name);
            },
            [] { return tr("Save over it, or save yours under another name."); });
        return;
    }
    const bool moved = path != path_;
    auto journal = moved ? journalOf(path) : std::nullopt;
    setPath(path, *written);
    if (document_.project() == project) {
        document_.markSaved();
    }
    if (!moved || journal || folder_.isEmpty()) {
        tell(Trouble::None);
    }
    if (moved) {
        // What was done since is in the new journal before the old one goes; flush() says what cannot be
        // written.
        if (journal) {
            static_cast<void>(journal->write(history()));
        }
        useJournal(std::move(journal));
    }
    flush();
    emit saved(path);
}

void ProjectFiles::discardChanges() {
    if (!document_.revert()) {
        // What was saved is no longer among the states that can be gone back to: the file has it.
        if (auto opened = path_.isEmpty() ? std::unexpected(Error{}) : readProject(toPath(path_))) {
            History history;
            history.base = std::make_shared<const Project>(std::move(opened->project));
            history.saved = 0;
            setPath(path_, opened->fingerprint);
            document_.begin(history);
        } else {
            begin();
        }
    }
    tell(Trouble::None);
}

void ProjectFiles::abandonChanges() {
    disconnect(&document_, nullptr, this, nullptr);
    idle_.stop();
    keeper_.cancel();
    const bool reverted = !path_.isEmpty() && document_.revert();
    if (reverted) {
        flush();
    }
    const std::scoped_lock lock{journal_->mutex};
    if (!reverted && journal_->file) {
        journal_->file->remove();
    }
    journal_->file.reset();
}

QUrl ProjectFiles::suggestedFile() const {
    QString name = QString::fromStdString(document_.project()->name).simplified();
    if (name.isEmpty() && document_.project()->field() != nullptr) {
        name = QString::fromStdString(document_.project()->field()->source->name).simplified();
    }
    static const QRegularExpression unsafe{QStringLiteral(R"([\\/:*?"<>|])")};
    name.replace(unsafe, QStringLiteral("_"));
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    // A dialog that begins in a folder that is not there proposes nothing.
    const QDir folder{!path_.isEmpty()           ? QFileInfo{path_}.path()
                      : QDir{documents}.exists() ? documents
                                                 : QDir::homePath()};
    return QUrl::fromLocalFile(
        folder.filePath((name.isEmpty() ? tr("Farm") : name) + QStringLiteral(".furrow")));
}

History ProjectFiles::history() const {
    History history = document_.history();
    history.file = toPath(path_);
    history.savedFingerprint = fingerprint_;
    return history;
}

void ProjectFiles::keep() {
    if (folder_.isEmpty()) {
        return;
    }
    keeper_.submit(
        [this, journal = journal_, history = history()](const JobContext&) -> JobRunner::Delivery {
            const std::scoped_lock lock{journal->mutex};
            const Result<void> kept = journal->file ? journal->file->write(history) : Result<void>{};
            return [this, kept] {
                if (!kept) {
                    tell(Trouble::NotKept, kept.error());
                } else if (trouble_ == Trouble::NotKept) {
                    tell(Trouble::None);
                }
            };
        },
        JobRunner::Replace::WhenDone);
}

void ProjectFiles::flush() {
    idle_.stop();
    keeper_.cancel();
    const std::scoped_lock lock{journal_->mutex};
    if (!journal_->file) {
        return;
    }
    const History all = history();
    const bool untouched = all.file.empty() && all.steps.empty();
    if (const auto kept = untouched ? Result<void>{} : journal_->file->write(all); !kept) {
        tell(Trouble::NotKept, kept.error());
    }
}

void ProjectFiles::setPath(const QString& path, const std::string& fingerprint) {
    path_ = path;
    fingerprint_ = fingerprint;
    emit pathChanged();
}

void ProjectFiles::tell(Trouble trouble, LazyText message, LazyText remedy) {
    if (trouble == trouble_ && text(message) == text(message_) && text(remedy) == text(remedy_)) {
        return;
    }
    trouble_ = trouble;
    message_ = std::move(message);
    remedy_ = std::move(remedy);
    emit messageChanged();
}

void ProjectFiles::tell(Trouble trouble, const Error& error) {
    tell(
        trouble,
        [error] {
            const QString where = shown(error.where);
            return where.isEmpty() ? sentence(error.what)
                                   : tr("%1: %2").arg(QFileInfo{where}.fileName(), sentence(error.what));
        },
        [remedy = error.remedy] { return sentence(remedy); });
}

}  // namespace furrow
