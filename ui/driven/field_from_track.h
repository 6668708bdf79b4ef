#pragma once

#include "planner/track/track_outline.h"
#include "ui/driven/driven_track.h"
#include "ui/jobs/job_runner.h"
#include "ui/map/shown_plan.h"
#include "ui/project/field_opener.h"
#include "ui/text/message_text.h"

#include <QtQml/qqmlregistration.h>
#include <QGeoRectangle>
#include <QObject>
#include <QUrl>
#include <QVariantList>

#include <memory>

namespace furrow {

/// A field made from a recorded track: what the track encloses or covers is shown before it is taken. Where
/// there is a plan that the track could be laid over as well, it is asked first which of both is meant.
class FieldFromTrack : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("belongs to a session")
    /// A recording came without a word of what it is for.
    Q_PROPERTY(bool asking READ isAsking NOTIFY changed FINAL)
    /// A field is being made from a track.
    Q_PROPERTY(bool active READ isActive NOTIFY changed FINAL)
    /// There is an outline that can be taken.
    Q_PROPERTY(bool ready READ isReady NOTIFY changed FINAL)
    Q_PROPERTY(bool busy READ isBusy NOTIFY changed FINAL)
    Q_PROPERTY(double progress READ progress NOTIFY progressChanged FINAL)
    /// Of the file.
    Q_PROPERTY(QString name READ name NOTIFY changed FINAL)
    /// What is known of the recording: format, positions, tracks.
    Q_PROPERTY(QString recording READ recording NOTIFY changed FINAL)
    Q_PROPERTY(QString trouble READ trouble NOTIFY changed FINAL)
    Q_PROPERTY(QString remedy READ remedy NOTIFY changed FINAL)
    /// What was left out.
    Q_PROPERTY(QStringList notes READ notes NOTIFY changed FINAL)
    /// Of the outline, each with label and value.
    Q_PROPERTY(QVariantList figures READ figures NOTIFY changed FINAL)
    /// How the track was driven, and which of them is chosen: the first is what the track itself tells.
    Q_PROPERTY(QStringList kinds READ kinds NOTIFY changed FINAL)
    Q_PROPERTY(int kind READ kind WRITE setKind NOTIFY changed FINAL)
    /// It was driven around the field, as chosen or found.
    Q_PROPERTY(bool round READ isRound NOTIFY changed FINAL)
    Q_PROPERTY(double width READ width WRITE setWidth NOTIFY changed FINAL)
    Q_PROPERTY(double beyond READ beyond WRITE setBeyond NOTIFY changed FINAL)
    Q_PROPERTY(double gap READ gap WRITE setGap NOTIFY changed FINAL)

public:
    FieldFromTrack(Document& document, FieldOpener& opener, ShownPlan& shown, QObject* parent = nullptr);

    bool isAsking() const { return asking_; }
    bool isActive() const { return active_; }
    bool isReady() const { return outline_ != nullptr && !runner_.isBusy(); }
    bool isBusy() const { return runner_.isBusy(); }
    double progress() const { return runner_.progress(); }
    const QString& name() const { return name_; }
    QString recording() const;
    QString trouble() const { return text(trouble_); }
    QString remedy() const { return text(remedy_); }
    QStringList notes() const;
    QVariantList figures() const;
    QStringList kinds() const;
    int kind() const;
    void setKind(int kind);
    bool isRound() const;
    double width() const { return options_.width.si(); }
    void setWidth(double metres);
    double beyond() const { return options_.beyond.si(); }
    void setBeyond(double metres);
    double gap() const;
    void setGap(double metres);

    /// Reads a recording and makes a field from it. What cannot be read is told.
    Q_INVOKABLE void open(const QUrl& file);
    /// Makes a field from what was to be laid over a plan.
    Q_INVOKABLE void takeOver(furrow::DrivenTrack* track);
    /// What was asked is answered.
    Q_INVOKABLE void make();
    Q_INVOKABLE void layOver();
    /// Nothing is made of it.
    Q_INVOKABLE void close();
    /// Adds the outline to the farm, each piece as a field of its own: one step to undo.
    Q_INVOKABLE void take();

    /// The track and the outline on the map; null where there is none.
    const TrackOutline* outline() const { return outline_.get(); }

signals:
    void changed();
    void progressChanged();
    /// Another track is in view.
    void outlined(const QGeoRectangle& area);
    /// A recording is to be laid over the plan.
    void layRequested(const QString& name, const std::shared_ptr<const TrackFile>& file);

private:
    void find(const QString& name, const std::shared_ptr<const TrackFile>& file);
    void begin();
    void work();
    void change(TrackOutlineOptions options);

    Document& document_;
    FieldOpener& opener_;
    ShownPlan& shown_;
    QString name_;
    std::shared_ptr<const TrackFile> file_;
    /// Of the file that is still to be read.
    QString path_;
    bool asking_ = false;
    bool active_ = false;
    bool announced_ = false;
    TrackOutlineOptions options_;
    std::shared_ptr<const TrackOutline> outline_;
    LazyText trouble_;
    LazyText remedy_;
    JobRunner runner_;
};

}  // namespace furrow
