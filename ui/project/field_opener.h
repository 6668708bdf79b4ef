#pragma once

#include "ui/jobs/job_runner.h"
#include "ui/project/document.h"
#include "ui/project/field_choice_model.h"
#include "ui/project/file_reading.h"
#include "ui/project/problem.h"
#include "ui/project/project_files.h"
#include "ui/project/recent_files.h"
#include "ui/project/sample_fields.h"

#include <QtQml/qqmlregistration.h>
#include <QGeoCoordinate>
#include <QObject>
#include <QUrl>

namespace furrow {

/// Where fields come from: files, samples and what is drawn. A project takes the place of the one that is
/// open; a boundary becomes another field of it.
class FieldOpener : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("belongs to a session")
    /// The fields of a file with several, while the user picks.
    Q_PROPERTY(furrow::FieldChoiceModel* choices READ choices CONSTANT FINAL)
    Q_PROPERTY(QStringList sampleNames READ sampleNames NOTIFY textsChanged FINAL)

public:
    FieldOpener(Document& document, ProjectFiles& files, RecentFiles& recent, Problem& problem,
                QObject* parent = nullptr);

    FieldChoiceModel* choices() { return &choices_; }
    QStringList sampleNames() const;
    bool isReading() const { return reader_.isBusy(); }
    /// For long enough that the user should see it.
    bool isSlow() const { return reader_.isSlow(); }
    double progress() const { return reader_.progress(); }
    /// What is being read.
    const QString& readingName() const { return readingName_; }
    bool isChoosing() const { return choices_.count() > 0; }

    /// Reads a file. With several fields in a boundary file and no id, the user picks from `choices`.
    void open(const QString& path, const QString& fieldId = {});
    /// Reads several: a project among them first, then every field of the others; pictures become imagery.
    /// What a machine recorded is announced: it may be meant for a field, or for the plan.
    Q_INVOKABLE void openUrls(const QList<QUrl>& urls);
    Q_INVOKABLE void openSample(int index);
    /// Whether a file would take the place of the project that is open.
    Q_INVOKABLE bool isProjectFile(const QUrl& url) const;
    Q_INVOKABLE void chooseField(int row);
    Q_INVOKABLE void chooseAll();
    /// Goes back from the list of fields to what was there before.
    Q_INVOKABLE void dropChoices();
    /// Adds a field with this boundary.
    Q_INVOKABLE void addDrawn(const QList<QGeoCoordinate>& boundary);
    /// Adds fields to the farm: one step to undo.
    void addFields(std::vector<FieldSource> fields);
    /// Begins with an empty project.
    Q_INVOKABLE void startNew();
    void cancel() { reader_.cancel(); }

signals:
    void textsChanged();
    /// What is being read or chosen, or what came of it.
    void stateChanged();
    void progressChanged();
    /// Pictures among the files.
    void imageryFound(const QStringList& paths);
    /// A recording among the files; of several the name of the first stands for all.
    void driveFound(const QString& name, const std::shared_ptr<const TrackFile>& file);

private:
    void read(const QStringList& paths, const QString& fieldId);
    void take(Reading reading, bool choose);

    Document& document_;
    ProjectFiles& files_;
    RecentFiles& recent_;
    Problem& problem_;
    FieldChoiceModel choices_;
    QList<SampleField> samples_;
    QString readingName_;
    JobRunner reader_;
};

}  // namespace furrow
