#pragma once

#include "planner/core/result.h"
#include "planner/jobs/job.h"
#include "planner/project/project.h"
#include "ui/plan/made_plans.h"

#include <QStringList>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace furrow {

/// A field that goes out with others: what its plan is made from, and the plan where there is one of that.
struct FieldToExport {
    std::shared_ptr<const ProjectField> field;
    FieldPlan wanted;
    MadePlan made;

    const std::string& name() const { return field->source->name; }
};

/// Fields of a project by their ids, in its order, with the plans that are worked on now.
///
/// @param plan  of the current field and plan, if it is finished
/// @param made  plans that were made before
std::vector<FieldToExport> fieldsToExport(const Project& project, const QStringList& ids,
                                          const std::shared_ptr<const Plan>& plan, const MadePlans& made);

/// "Home Field, Long Acre and 3 more"
QString namesOf(const std::vector<FieldToExport>& fields);

/// What became of several fields on their way out.
struct FieldsExported {
    struct Failure {
        std::string field;
        Error error;
    };

    /// A plan that was made on the way, with advice.
    struct Made {
        FieldToExport of;
        std::shared_ptr<const Plan> plan;
    };

    /// Those that are in the files.
    std::vector<FieldToExport> written;
    std::vector<Made> made;
    std::vector<Failure> failures;
    /// Names of fields that are exported with a plan that cannot be driven.
    std::vector<std::string> withProblems;

    /// One sentence for each of both, in the language of the window.
    QStringList failureTexts() const;
    QStringList problemTexts() const;
};

/// Plans each field that has no plan and hands it on. What cannot be planned or handed on is told, and the
/// others go on; where nothing can be written any more (WriteFailed), the rest is not tried.
///
/// @param handOn  takes a plan, and its share of the progress
/// @return Cancelled
Result<FieldsExported> exportEach(
    const std::vector<FieldToExport>& fields,
    const std::function<Result<void>(const Plan& plan, const JobContext& job)>& handOn,
    const JobContext& job);

}  // namespace furrow
