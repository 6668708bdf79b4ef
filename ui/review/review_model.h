#pragma once

#include "planner/plan/plan.h"
#include "planner/project/project.h"
#include "ui/jobs/job_runner.h"
#include "ui/project/document.h"
#include "ui/text/message_text.h"

#include <QtQml/qqmlregistration.h>
#include <QAbstractListModel>
#include <QGeoCoordinate>
#include <QUrl>

#include <memory>

namespace furrow {

/// What people say of the current plan: comments on places of the map or on all of it, and whether they
/// agree. It goes away and comes back as a review file.
class ReviewModel : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("belongs to a session")
    Q_PROPERTY(int count READ rowCount NOTIFY reviewChanged FINAL)
    /// Comments that are not settled.
    Q_PROPERTY(int openCount READ openCount NOTIFY reviewChanged FINAL)
    Q_PROPERTY(State verdict READ verdict NOTIFY reviewChanged FINAL)
    /// "Approved by Ann, 2 Nov 2026"; empty for none.
    Q_PROPERTY(QString verdictText READ verdictText NOTIFY reviewChanged FINAL)
    /// Field, machine or settings have changed since the verdict.
    Q_PROPERTY(bool verdictIsOld READ verdictIsOld NOTIFY reviewChanged FINAL)
    /// It was sent for review, or is one that was sent.
    Q_PROPERTY(bool sent READ isSent NOTIFY reviewChanged FINAL)
    /// What sending is called: on the way there, or back.
    Q_PROPERTY(QString sendText READ sendText NOTIFY reviewChanged FINAL)
    /// Who writes here; remembered.
    Q_PROPERTY(QString author READ author WRITE setAuthor NOTIFY authorChanged FINAL)
    /// Why nothing can be sent; empty where it can.
    Q_PROPERTY(QString refusal READ refusal NOTIFY planChanged FINAL)
    /// What became of sending or of taking in; empty for nothing.
    Q_PROPERTY(QString message READ message NOTIFY messageChanged FINAL)
    Q_PROPERTY(bool failed READ hasFailed NOTIFY messageChanged FINAL)
    Q_PROPERTY(bool busy READ isBusy NOTIFY busyChanged FINAL)

public:
    enum class State { None, Approved, ChangesWanted };
    Q_ENUM(State)
    enum Role {
        NumberRole = Qt::UserRole + 1,
        ByRole,  ///< "Ann, 2 Nov 2026"
        TextRole,
        PlaceRole,
        HasPlaceRole,
        OldRole,  ///< the plan has changed since
        SettledRole,
        OwnRole,
    };

    explicit ReviewModel(Document& document, QObject* parent = nullptr);

    /// The finished plan of what the panels show; null for none.
    void setPlan(std::shared_ptr<const Plan> plan);

    int openCount() const;
    State verdict() const;
    QString verdictText() const;
    QString sendText() const;
    bool verdictIsOld() const;
    bool isSent() const { return !review().id.empty(); }
    bool isReceived() const { return review().received; }
    QString author() const { return author_; }
    void setAuthor(const QString& author);
    QString refusal() const;
    QString message() const { return text(message_); }
    bool hasFailed() const { return failed_; }
    bool isBusy() const { return runner_.isBusy(); }

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QHash<int, QByteArray> roleNames() const override;

    /// On a place of the map, or on the whole plan where that is not valid. A text of spaces is none.
    Q_INVOKABLE void add(const QString& text, const QGeoCoordinate& place);
    Q_INVOKABLE void remove(int row);
    Q_INVOKABLE void setSettled(int row, bool settled);
    /// Another text for a comment, of now and of the plan as it is now. Nothing for an empty text.
    Q_INVOKABLE void setText(int row, const QString& text);
    Q_INVOKABLE QGeoCoordinate placeOf(int row) const;
    /// None takes the verdict back.
    Q_INVOKABLE void setVerdict(furrow::ReviewModel::State verdict);
    /// A name that suits field and plan, in the user's documents.
    Q_INVOKABLE QUrl suggestedFile() const;
    /// Writes the review file in the background.
    Q_INVOKABLE void send(const QUrl& file);
    /// Takes in what came back, in the background.
    Q_INVOKABLE void takeIn(const QUrl& file);
    /// Something of this project was sent for review.
    Q_INVOKABLE bool expectsReviews() const;
    /// Reads a file in the background and says whether it is a review of a plan of this project (`lookedAt`).
    Q_INVOKABLE void look(const QUrl& file);
    Q_INVOKABLE void dismiss();

signals:
    void reviewChanged();
    void authorChanged();
    void planChanged();
    void messageChanged();
    void busyChanged();
    void lookedAt(bool isReviewOfThis);
    /// What came back is of this plan, which is current now.
    void takenIn();

private:
    const Review& review() const { return document_.project()->plan().review; }
    void follow();
    void change(const LazyText& text, Review review);
    void tell(LazyText message, bool failed);
    void tell(const Error& error);
    void take(const Project& sent);
    std::string currentKey() const;

    Document& document_;
    std::shared_ptr<const Plan> plan_;
    Review shown_;
    std::string key_;  ///< of field and plan as they are
    QString author_;
    LazyText message_;
    bool failed_ = false;
    JobRunner runner_;
};

}  // namespace furrow
