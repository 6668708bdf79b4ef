#pragma once

#include "planner/track/driven_area.h"
#include "ui/jobs/job_runner.h"
#include "ui/map/shown_plan.h"
#include "ui/text/message_text.h"

#include <QtQml/qqmlregistration.h>
#include <QGeoCoordinate>
#include <QList>
#include <QObject>
#include <QPointF>
#include <QUrl>
#include <QVariantList>

#include <array>
#include <memory>
#include <vector>

namespace furrow {

/// A recorded track laid over the plan that is shown: how far beside it was driven, where, and what was
/// worked. With another plan of the field it is laid over that one.
class DrivenTrack : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("belongs to a session")
    /// A track was opened, or is being read.
    Q_PROPERTY(bool active READ isActive NOTIFY changed FINAL)
    /// There are figures.
    Q_PROPERTY(bool ready READ isReady NOTIFY changed FINAL)
    Q_PROPERTY(bool busy READ isBusy NOTIFY changed FINAL)
    Q_PROPERTY(double progress READ progress NOTIFY progressChanged FINAL)
    /// Of the file.
    Q_PROPERTY(QString name READ name NOTIFY changed FINAL)
    Q_PROPERTY(QString trouble READ trouble NOTIFY changed FINAL)
    Q_PROPERTY(QString remedy READ remedy NOTIFY changed FINAL)
    /// The file was read, whatever came of it.
    Q_PROPERTY(bool readable READ isReadable NOTIFY changed FINAL)
    /// What was passed over while it was read.
    Q_PROPERTY(QStringList notes READ notes NOTIFY changed FINAL)
    /// Each with label, value, hint.
    Q_PROPERTY(QVariantList figures READ figures NOTIFY changed FINAL)
    /// Steps of the colours, from on the line to off the plan.
    Q_PROPERTY(QStringList steps READ steps NOTIFY changed FINAL)
    /// The error along the drive in the unit square, left of the plan upwards.
    Q_PROPERTY(QList<QPointF> course READ course NOTIFY changed FINAL)
    /// What the upper edge of the course means.
    Q_PROPERTY(QString courseTop READ courseTop NOTIFY changed FINAL)

public:
    /// Of the colours, m: within the first is on the line.
    static constexpr std::array kStepsM{0.1, 0.3, 1.0};
    static constexpr std::size_t kClasses = kStepsM.size() + 2;  ///< the last is off the plan

    explicit DrivenTrack(ShownPlan& shown, QObject* parent = nullptr);

    bool isActive() const { return !file_.isEmpty(); }
    bool isReady() const { return laid_ != nullptr; }
    bool isReadable() const { return read_ != nullptr; }
    const std::shared_ptr<const TrackFile>& file() const { return read_; }
    bool isBusy() const { return runner_.isBusy(); }
    double progress() const { return runner_.progress(); }
    QString name() const;
    QString trouble() const { return text(trouble_); }
    QString remedy() const { return text(remedy_); }
    QStringList notes() const;
    QVariantList figures() const;
    QStringList steps() const;
    QList<QPointF> course() const;
    QString courseTop() const;

    Q_INVOKABLE void open(const QUrl& file);
    /// A recording that was read already.
    void layRecording(const QString& name, const std::shared_ptr<const TrackFile>& file);
    Q_INVOKABLE void close();
    /// Where the machine was at this share of the recording; not valid where there is none.
    Q_INVOKABLE QGeoCoordinate placeAt(double share) const;
    /// Where it was farthest from the plan.
    Q_INVOKABLE QGeoCoordinate farthest() const;

    /// Lines of each class for the map, in the frame of the plan.
    struct Line {
        std::size_t step = 0;
        Ring points;
    };
    std::vector<Line> lines() const;
    const Plan* plan() const;
    /// Pieces of land that were missed.
    const MultiPolygon& missed() const;

signals:
    void changed();
    void progressChanged();

private:
    /// A recording beside a plan. Immutable.
    struct Laid {
        std::shared_ptr<const Plan> plan;
        LaidTracks recorded;
        std::vector<Ring> places;
        DrivenArea area;
    };
    static Result<Laid> laidOverPlan(const std::shared_ptr<const Plan>& plan, const TrackFile& file,
                                     const JobContext& job);
    void lay();

    ShownPlan& shown_;
    QString file_;
    /// As it was read; null until then.
    std::shared_ptr<const TrackFile> read_;
    std::shared_ptr<const Laid> laid_;
    LazyText trouble_;
    LazyText remedy_;
    JobRunner runner_;
};

}  // namespace furrow
