#pragma once

#include "planner/field/field.h"
#include "planner/jobs/job.h"
#include "planner/project/project_file.h"
#include "planner/track/recorded_track.h"

#include <QString>
#include <QStringList>

#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace furrow {

/// What a reading job hands over.
struct Reading {
    std::optional<std::pair<QString, OpenedProject>> project;
    std::vector<FieldSource> fields;
    QStringList imagery;
    /// Recordings: which of their tracks is a boundary, if any, the user has to say.
    QStringList drives;
    std::shared_ptr<TrackFile> drive;  ///< all of them in one; null where there is none
    std::optional<Error> error;
};

/// Reads files of any kind, in their order, up to the first that cannot be read.
Reading readFiles(const QStringList& paths, const QString& fieldId, const JobContext& job);

}  // namespace furrow
