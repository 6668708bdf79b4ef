#pragma once

#include "ui/drive/machine_shape_drawing.h"
#include "ui/drive/worked_strips.h"
#include "ui/jobs/job_runner.h"
#include "ui/map/shown_plan.h"

#include <QtQml/qqmlregistration.h>
#include <QGeoCoordinate>
#include <QObject>

#include <memory>

namespace furrow {

/// The plan that is shown, driven through: played at any speed, or looked at at any moment.
class DriveThrough : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("belongs to a session")
    /// There is a whole plan to drive.
    Q_PROPERTY(bool available READ isAvailable NOTIFY courseChanged FINAL)
    Q_PROPERTY(bool playing READ isPlaying WRITE setPlaying NOTIFY playingChanged FINAL)
    /// It has left its start: machine and worked land are shown.
    Q_PROPERTY(bool underWay READ isUnderWay NOTIFY moved FINAL)
    /// Times as fast as in the field.
    Q_PROPERTY(int pace READ pace WRITE setPace NOTIFY paceChanged FINAL)
    /// Seconds since the start of the drive.
    Q_PROPERTY(double time READ time WRITE setTime NOTIFY moved FINAL)
    Q_PROPERTY(double duration READ duration NOTIFY courseChanged FINAL)
    Q_PROPERTY(QString timeText READ timeText NOTIFY moved FINAL)
    Q_PROPERTY(QString durationText READ wholeText NOTIFY courseChanged FINAL)
    /// "Swath 12, 15 of 36 · implement down"
    Q_PROPERTY(QString stateText READ stateText NOTIFY moved FINAL)
    /// "8.1 ha done · 6.0 km/h · 12° left · 4.31 km"
    Q_PROPERTY(QString figuresText READ figuresText NOTIFY moved FINAL)
    Q_PROPERTY(QGeoCoordinate place READ place NOTIFY moved FINAL)
    /// Of the path; -1 for none.
    Q_PROPERTY(int segment READ segment NOTIFY moved FINAL)

public:
    explicit DriveThrough(ShownPlan& shown, QObject* parent = nullptr);

    bool isAvailable() const { return course_ != nullptr; }
    bool isPlaying() const { return playing_; }
    void setPlaying(bool playing);
    bool isUnderWay() const { return course_ != nullptr && timeS_ > 0.0; }
    int pace() const { return pace_; }
    void setPace(int pace);
    double time() const { return timeS_; }
    void setTime(double seconds);
    double duration() const;
    QString timeText() const;
    QString wholeText() const;
    QString stateText() const;
    QString figuresText() const;
    QGeoCoordinate place() const;
    int segment() const;

    /// So many seconds of the clock have gone by.
    Q_INVOKABLE void advance(double seconds);
    Q_INVOKABLE void faster();
    Q_INVOKABLE void slower();
    /// To the beginning of the segment before or behind the one that is driven.
    Q_INVOKABLE void stepSegment(int by);
    /// To the beginning of a segment of the path.
    Q_INVOKABLE void goTo(int segment);

    /// For the layer that draws it; null without a plan.
    const std::shared_ptr<const DriveCourse>& course() const { return course_; }
    const std::shared_ptr<const WorkedStrips>& strips() const { return strips_; }
    const std::shared_ptr<const Plan>& plan() const { return plan_; }
    const DriveState& state() const { return state_; }
    Carried carried() const;

signals:
    void courseChanged();
    void playingChanged();
    void paceChanged();
    void moved();

private:
    void follow();
    void take(std::shared_ptr<const Plan> plan, std::shared_ptr<const DriveCourse> course,
              std::shared_ptr<const WorkedStrips> strips);
    void show();

    ShownPlan& shown_;
    std::shared_ptr<const Plan> asked_;
    std::shared_ptr<const Plan> plan_;
    std::shared_ptr<const DriveCourse> course_;
    std::shared_ptr<const WorkedStrips> strips_;
    DriveState state_;
    double timeS_ = 0.0;
    int pace_ = 8;
    bool playing_ = false;
    JobRunner runner_;
};

}  // namespace furrow
