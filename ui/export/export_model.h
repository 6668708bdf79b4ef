#pragma once

#include "planner/io/content/export_job.h"
#include "ui/export/field_to_export.h"
#include "ui/export/plan_title.h"
#include "ui/export/stick_export.h"
#include "ui/jobs/job_runner.h"
#include "ui/plan/plan_state.h"
#include "ui/project/document.h"
#include "ui/text/message_text.h"

#include <QtQml/qqmlregistration.h>
#include <QAbstractListModel>
#include <QUrl>

#include <filesystem>
#include <string_view>
#include <vector>

namespace furrow {

/// Writes a plan to a folder, in the formats that are ticked; or the plans of several fields, those that
/// there are not yet made on the way.
class ExportModel : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("belongs to a session")
    /// Which plan would be written; empty for none.
    Q_PROPERTY(QString heading READ heading NOTIFY planChanged FINAL)
    Q_PROPERTY(QString details READ details NOTIFY planChanged FINAL)
    /// Why nothing can be written; empty where it can.
    Q_PROPERTY(QString refusal READ refusal NOTIFY planChanged FINAL)
    /// Ids of fields that are exported together; empty for the plan that is shown. Set anew each time it is
    /// opened.
    Q_PROPERTY(QStringList chosen READ chosen WRITE setChosen NOTIFY planChanged FINAL)
    Q_PROPERTY(bool several READ isSeveral NOTIFY planChanged FINAL)
    /// Of several fields.
    Q_PROPERTY(double progress READ progress NOTIFY progressChanged FINAL)
    /// Fields that could not be exported and why, one sentence each.
    Q_PROPERTY(QStringList failures READ failures NOTIFY stateChanged FINAL)
    Q_PROPERTY(State state READ state NOTIFY stateChanged FINAL)
    Q_PROPERTY(QString message READ message NOTIFY stateChanged FINAL)
    Q_PROPERTY(QString remedy READ remedy NOTIFY stateChanged FINAL)
    /// Which plan was written.
    Q_PROPERTY(QString written READ written NOTIFY stateChanged FINAL)
    /// What the receivers of the written files should know.
    Q_PROPERTY(QStringList notes READ notes NOTIFY stateChanged FINAL)
    /// What receivers would stumble over in the written files, and how much was looked at.
    Q_PROPERTY(QStringList problems READ problems NOTIFY stateChanged FINAL)
    Q_PROPERTY(int checks READ checks NOTIFY stateChanged FINAL)
    /// The same plan for a terminal, on a stick.
    Q_PROPERTY(furrow::StickExport* stick READ stick CONSTANT FINAL)

public:
    enum class State { Idle, Writing, Done, Failed };
    Q_ENUM(State)
    enum Role { NameRole = Qt::UserRole + 1, HintRole, CheckedRole };

    ExportModel(Document& document, const MadePlans& made, QObject* parent = nullptr);

    /// What is to be written; null for nothing, and the state says why. What was being written of another
    /// plan is stopped.
    void setPlan(const PlanTitle& title, PlanState state);

    QStringList chosen() const { return chosen_; }
    void setChosen(const QStringList& chosen);
    bool isSeveral() const { return !chosen_.isEmpty(); }
    QString heading() const;
    QString details() const;
    QString refusal() const;
    State state() const { return state_; }
    QString message() const { return text(message_); }
    QString remedy() const { return text(remedy_); }
    QString written() const { return written_.whole(); }
    double progress() const { return runner_.progress(); }
    QStringList failures() const { return exported_.failureTexts(); }
    QStringList notes() const { return exported_.problemTexts() + sentences(notes_); }
    QStringList problems() const { return sentences(checks_.problems); }
    int checks() const { return static_cast<int>(checks_.made.size()); }
    StickExport* stick() { return &stick_; }

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QHash<int, QByteArray> roleNames() const override;

    Q_INVOKABLE void setChecked(int row, bool checked);
    /// A folder that suits the plan, in the user's documents.
    Q_INVOKABLE QString suggestedFolder() const;
    Q_INVOKABLE QString pathOf(const QUrl& url) const { return url.toLocalFile(); }
    /// Writes in the background; the folder is made where it does not exist. Nothing where `refusal` says
    /// why.
    Q_INVOKABLE void writeTo(const QString& folder);
    /// Stops writing. Fields that are written by then stay.
    Q_INVOKABLE void cancel();
    /// Forgets the last result.
    Q_INVOKABLE void clear();

signals:
    void planChanged();
    void stateChanged();
    void progressChanged();
    /// Fields were planned on the way out, or got advice.
    void planned(const std::vector<furrow::FieldsExported::Made>& plans);

private:
    void writeSeveral(const std::filesystem::path& folder, const std::vector<std::string_view>& ids);
    std::vector<FieldToExport> fields() const;
    void fail(const Error& error);
    void setState(State state, LazyText message = {}, LazyText remedy = {});

    Document& document_;
    const MadePlans& made_;
    PlanTitle title_;
    QStringList chosen_;
    PlanState planState_ = PlanState::Empty;
    PlanTitle written_;
    std::vector<bool> checked_;
    State state_ = State::Idle;
    LazyText message_;
    LazyText remedy_;
    std::vector<Message> notes_;
    FieldsExported exported_;
    ExportChecks checks_;
    StickExport stick_;
    JobRunner runner_;
};

}  // namespace furrow
