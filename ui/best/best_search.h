#pragma once

#include "ui/best/choice_list_model.h"
#include "ui/best/choice_table_model.h"
#include "ui/jobs/job_runner.h"
#include "ui/project/document.h"
#include "ui/text/message_text.h"

#include <QtQml/qqmlregistration.h>
#include <QElapsedTimer>
#include <QList>
#include <QObject>
#include <QPointF>

#include <optional>
#include <vector>

namespace furrow {

/// Searches the best plan for the current field in the background. What it found is taken into the project
/// only when the user says so.
class BestSearch : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("belongs to a session")
    Q_PROPERTY(State state READ state NOTIFY stateChanged FINAL)
    Q_PROPERTY(double progress READ progress NOTIFY progressChanged FINAL)
    /// The time of the plan as asked, and of the best so far; empty before there is one.
    Q_PROPERTY(QString askedTime READ askedTime NOTIFY betterFound FINAL)
    Q_PROPERTY(QString bestTime READ bestTime NOTIFY betterFound FINAL)
    Q_PROPERTY(QString savedTime READ savedTime NOTIFY betterFound FINAL)
    /// There is a plan other than the one as asked.
    Q_PROPERTY(bool isBetter READ isBetter NOTIFY betterFound FINAL)
    /// The best time over the time of the search: both in [0, 1], from the left to the right, the plan as
    /// asked at 0.
    Q_PROPERTY(QList<QPointF> course READ course NOTIFY courseChanged FINAL)
    Q_PROPERTY(int alternatives READ alternatives NOTIFY stateChanged FINAL)
    /// Why the search failed.
    Q_PROPERTY(QString message READ message NOTIFY stateChanged FINAL)
    Q_PROPERTY(furrow::ChoiceListModel* choices READ choices CONSTANT FINAL)
    Q_PROPERTY(furrow::ChoiceTableModel* table READ table CONSTANT FINAL)

public:
    enum class State { Idle, Searching, Done, Failed };
    Q_ENUM(State)

    explicit BestSearch(Document& document, QObject* parent = nullptr);

    State state() const { return state_; }
    double progress() const { return runner_.progress(); }
    QString askedTime() const;
    QString bestTime() const;
    QString savedTime() const;
    bool isBetter() const;
    QList<QPointF> course() const;
    int alternatives() const { return alternatives_; }
    QString message() const { return text(message_); }
    ChoiceListModel* choices() { return &choices_; }
    ChoiceTableModel* table() { return &table_; }

    /// For the field and the plan that are current.
    Q_INVOKABLE void begin();
    Q_INVOKABLE void start();
    /// Nothing is taken.
    Q_INVOKABLE void cancel();
    /// Ends the search and takes the best plan so far into the project, as one change.
    Q_INVOKABLE void take();

signals:
    void stateChanged();
    void progressChanged();
    void betterFound();
    void courseChanged();

private:
    struct Found {
        Settings settings;
        Duration time;
        qint64 afterMs = 0;
    };

    void setState(State state, LazyText message = {});
    void addFound(int search, const Settings& settings, Duration time);
    void finish(const Result<std::shared_ptr<const Plan>>& best);

    Document& document_;
    State state_ = State::Idle;
    LazyText message_;
    int search_ = 0;  ///< counts searches: what an earlier one found late is dropped
    QElapsedTimer since_;
    qint64 tookMs_ = 0;
    std::vector<Found> found_;
    std::optional<Settings> last_;  ///< of the plan that the search ended with
    int alternatives_ = 0;
    ChoiceListModel choices_;
    ChoiceTableModel table_;
    JobRunner runner_;
};

}  // namespace furrow
