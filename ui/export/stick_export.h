#pragma once

#include "planner/io/content/export_job.h"
#include "ui/export/field_to_export.h"
#include "ui/export/plan_title.h"
#include "ui/jobs/job_runner.h"
#include "ui/text/message_text.h"

#include <QtQml/qqmlregistration.h>
#include <QAbstractListModel>
#include <QStringList>
#include <QTimer>
#include <QUrl>

#include <functional>
#include <vector>

namespace furrow {

/// LazyText of an export that was stopped because the plan became another one.
QString stoppedText();
QString stoppedRemedy();

/// Writes a plan, or the plans of several fields, for a terminal to a USB stick: the sticks that there are,
/// what stands in the way on the chosen one, and what became of it. The sticks are looked for while
/// `searching` is set.
class StickExport : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("belongs to a session")
    Q_PROPERTY(bool searching READ searching WRITE setSearching NOTIFY searchingChanged FINAL)
    Q_PROPERTY(int count READ count NOTIFY countChanged FINAL)
    Q_PROPERTY(QStringList terminalNames READ terminalNames NOTIFY textsChanged FINAL)
    Q_PROPERTY(int terminal READ terminal WRITE setTerminal NOTIFY terminalChanged FINAL)
    Q_PROPERTY(QString shows READ shows NOTIFY textsChanged FINAL)
    /// The terminal's files know tasks, and each field is put in one.
    Q_PROPERTY(bool hasTasks READ hasTasks NOTIFY textsChanged FINAL)
    Q_PROPERTY(bool task READ task WRITE setTask NOTIFY taskChanged FINAL)
    Q_PROPERTY(int current READ current WRITE setCurrent NOTIFY currentChanged FINAL)
    /// What terminals cannot read about the chosen stick.
    Q_PROPERTY(QStringList warnings READ warnings NOTIFY examined FINAL)
    /// What is on it already and would be kept as a backup; empty where nothing is in the way.
    Q_PROPERTY(QString replaces READ replaces NOTIFY examined FINAL)
    Q_PROPERTY(State state READ state NOTIFY stateChanged FINAL)
    Q_PROPERTY(QString message READ message NOTIFY stateChanged FINAL)
    Q_PROPERTY(QString remedy READ remedy NOTIFY stateChanged FINAL)
    /// Which plan was written and read back; empty for none.
    Q_PROPERTY(QString writtenPlan READ writtenPlan NOTIFY stateChanged FINAL)
    /// What was written, a line for each file, and what a driver should know.
    Q_PROPERTY(QStringList written READ written NOTIFY stateChanged FINAL)
    Q_PROPERTY(QStringList notes READ notes NOTIFY stateChanged FINAL)
    /// Of several fields those that could not be exported and why, one sentence each.
    Q_PROPERTY(QStringList failures READ failures NOTIFY stateChanged FINAL)
    /// What receivers would stumble over in the written files, and how much was looked at.
    Q_PROPERTY(QStringList problems READ problems NOTIFY stateChanged FINAL)
    Q_PROPERTY(int checks READ checks NOTIFY stateChanged FINAL)
    Q_PROPERTY(double progress READ progress NOTIFY progressChanged FINAL)

public:
    enum class State { Idle, Writing, Done, Failed };
    Q_ENUM(State)
    enum Role { NameRole = Qt::UserRole + 1, DetailRole };

    struct Stick {
        QString root;
        QString name;
        QString detail;         ///< place, file system, room
        bool isFolder = false;  ///< chosen in the place of a stick

        friend bool operator==(const Stick&, const Stick&) = default;
    };
    /// Which sticks are plugged in.
    using Lister = std::function<std::vector<Stick>()>;

    explicit StickExport(QObject* parent = nullptr);

    /// In the place of what the system has mounted.
    void setLister(Lister lister) { lister_ = std::move(lister); }
    /// What is to be written; null for nothing. What was being written of another plan is stopped.
    void setPlan(const PlanTitle& title);
    /// Several fields in the place of that plan; none for the plan.
    void setFields(std::vector<FieldToExport> fields);

    bool searching() const { return timer_.isActive(); }
    void setSearching(bool searching);
    int count() const { return static_cast<int>(sticks_.size()); }
    QStringList terminalNames() const;
    int terminal() const { return terminal_; }
    void setTerminal(int index);
    QString shows() const;
    bool hasTasks() const;
    bool task() const { return task_; }
    void setTask(bool task);
    int current() const { return current_; }
    void setCurrent(int row);
    QStringList warnings() const { return sentences(warnings_); }
    QString replaces() const { return replaces_; }
    State state() const { return state_; }
    QString message() const { return text(message_); }
    QString remedy() const { return text(remedy_); }
    QString writtenPlan() const;
    QStringList failures() const { return exported_.failureTexts(); }
    QStringList written() const { return written_; }
    QStringList notes() const;
    QStringList problems() const { return sentences(checks_.problems); }
    int checks() const { return static_cast<int>(checks_.made.size()); }
    double progress() const { return runner_.progress(); }

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QHash<int, QByteArray> roleNames() const override;

    /// A folder in the place of a stick, from which the files are carried on by other means.
    Q_INVOKABLE void addFolder(const QUrl& folder);
    /// Writes, reads back and compares in the background.
    /// @param replace  what is there may be renamed to a backup
    Q_INVOKABLE void write(bool replace);
    Q_INVOKABLE void cancel();
    /// Forgets the last result.
    Q_INVOKABLE void clear();

signals:
    void searchingChanged();
    void countChanged();
    void terminalChanged();
    /// Another terminal, or another language.
    void textsChanged();
    void taskChanged();
    void currentChanged();
    void examined();
    void stateChanged();
    void progressChanged();
    /// Fields were planned on the way out.
    void planned(const std::vector<furrow::FieldsExported::Made>& plans);

private:
    std::vector<Stick> found() const;
    const Stick& chosen() const { return sticks_[static_cast<std::size_t>(current_)]; }
    void refresh();
    bool hasContent() const { return title_ || !fields_.empty(); }
    /// What stands in the way, worked out in the background.
    void examine();
    void setState(State state, LazyText message = {}, LazyText remedy = {});

    PlanTitle title_;
    PlanTitle writtenTitle_;
    std::vector<FieldToExport> fields_;
    std::vector<FieldToExport> writtenFields_;
    FieldsExported exported_;
    std::vector<Stick> sticks_;
    QStringList folders_;
    Lister lister_;
    QTimer timer_;
    int terminal_ = 0;
    bool task_ = false;
    int current_ = -1;
    std::vector<Message> warnings_;
    QString replaces_;
    State state_ = State::Idle;
    LazyText message_;
    LazyText remedy_;
    QStringList written_;
    std::vector<Message> notes_;
    ExportChecks checks_;
    QString backups_;  ///< what was there before, under its new names
    JobRunner runner_;
};

}  // namespace furrow
