#pragma once

#include "planner/project/history.h"
#include "planner/project/project_file.h"
#include "ui/jobs/job_runner.h"
#include "ui/project/document.h"
#include "ui/text/message_text.h"

#include <QtQml/qqmlregistration.h>
#include <QObject>
#include <QTimer>
#include <QUrl>

#include <memory>
#include <mutex>
#include <optional>

namespace furrow {

/// Where the project lies: opens and saves it, and keeps every change in a journal so that a crash loses
/// nothing and undo goes on after reopening. Files are written away from the GUI thread.
class ProjectFiles : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("made by the application")
    /// Of the project file; empty while it was never saved.
    Q_PROPERTY(QString path READ path NOTIFY pathChanged FINAL)
    /// "Home farm", without folder and extension; empty while it was never saved.
    Q_PROPERTY(QString name READ name NOTIFY pathChanged FINAL)
    Q_PROPERTY(bool saving READ isSaving NOTIFY savingChanged FINAL)
    Q_PROPERTY(Trouble trouble READ trouble NOTIFY messageChanged FINAL)
    Q_PROPERTY(QString message READ message NOTIFY messageChanged FINAL)
    Q_PROPERTY(QString remedy READ remedy NOTIFY messageChanged FINAL)

public:
    /// What the message is about, and so what the user can do about it.
    enum class Trouble {
        None,
        Restored,       ///< changes that were not saved are there again: keep or discard them
        ChangedOnDisk,  ///< another program wrote the file: overwrite it, or save under another name
        NotSaved,       ///< try again, or save under another name
        Notes,          ///< something in the file could not be used
        NotKept,        ///< the journal cannot be written
    };
    Q_ENUM(Trouble)

    explicit ProjectFiles(Document& document, QObject* parent = nullptr);
    /// Writes what the journal does not have yet.
    ~ProjectFiles() override;

    QString path() const { return path_; }
    QString name() const;
    bool isSaving() const { return saver_.isBusy(); }
    Trouble trouble() const { return trouble_; }
    QString message() const { return text(message_); }
    QString remedy() const { return text(remedy_); }

    /// Journals go to this folder; without one, none is kept.
    void keepIn(const QString& folder);
    /// Shows again what a crash left behind, the latest first. False where there is nothing.
    bool recover();

    /// Begins with a project that was read from this file. With its journal undo goes on where it was, and
    /// what was not saved is there again. False, with the message, where another window has it open.
    bool open(const QString& path, OpenedProject opened);
    /// An empty project.
    Q_INVOKABLE void begin();
    /// Saves where the project lies; does nothing while it was never saved.
    Q_INVOKABLE void save() { write(path_, false); }
    /// Also over what another program wrote.
    Q_INVOKABLE void overwrite() { write(path_, true); }
    /// Saves under another name; the extension is added.
    Q_INVOKABLE void saveAs(const QUrl& file);
    /// Goes back to what was saved last.
    Q_INVOKABLE void discardChanges();
    /// What is not saved is not wanted: the journal forgets it. Call when the window closes.
    Q_INVOKABLE void abandonChanges();
    Q_INVOKABLE void dismiss() { tell(Trouble::None); }
    Q_INVOKABLE QUrl urlOf(const QString& path) const { return QUrl::fromLocalFile(path); }
    Q_INVOKABLE QString pathOf(const QUrl& url) const { return url.toLocalFile(); }
    /// A name to save under, in the user's documents.
    Q_INVOKABLE QUrl suggestedFile() const;

    /// Writes the journal now. For the end and for tests; otherwise it is written when nothing happens.
    void flush();

signals:
    void pathChanged();
    void savingChanged();
    void messageChanged();
    /// The project is in this file now.
    void saved(const QString& path);

private:
    void write(const QString& path, bool overwrite);
    void take(const QString& path, const std::shared_ptr<const Project>& project, Result<std::string> written,
              bool changedOnDisk);
    void tell(Trouble trouble, LazyText message = {}, LazyText remedy = {});
    void tell(Trouble trouble, const Error& error);
    void setPath(const QString& path, const std::string& fingerprint);
    /// Of a project file, or of none; nothing, with the message, where it cannot be had.
    std::optional<HistoryJournal> journalOf(const QString& path);
    void useJournal(std::optional<HistoryJournal> journal);
    History history() const;
    void keep();

    Document& document_;
    QString folder_;
    QString path_;
    std::string fingerprint_;
    Trouble trouble_ = Trouble::None;
    LazyText message_;
    LazyText remedy_;
    /// Written by the keeper's thread, and by this one at the end.
    struct Journal {
        std::mutex mutex;
        std::optional<HistoryJournal> file;
    };
    std::shared_ptr<Journal> journal_;
    QTimer idle_;
    JobRunner saver_;
    JobRunner keeper_;
};

}  // namespace furrow
