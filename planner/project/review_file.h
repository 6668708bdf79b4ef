#pragma once

#include "planner/plan/plan.h"
#include "planner/project/project.h"

#include <filesystem>
#include <string>

namespace furrow {

// A review file is a project with one field, one plan and its review, and with the plan drawn: another
// program, which knows no projects, shows swaths, path and comments as features. They have the property
// `drawn_only`; whoever reads the project leaves them out, since they are made anew.

/// The current field and plan alone, as they are sent. Comments and verdict stay with them.
Project forReview(const Project& project);

/// The text of a review file. `plan` is of the current field and plan.
std::string reviewText(const Project& project, const Plan& plan);

/// Writes it, as writeProject does. WriteFailed: with the system's reason.
Result<void> writeReview(const Project& project, const Plan& plan, const std::filesystem::path& path);

/// What came back, taken into a project.
struct TakenReview {
    Project project;  ///< the field and plan of the review are current
    int added = 0;    ///< comments
    int changed = 0;
    bool verdictChanged = false;
    /// Field, machine or settings are others here than in the file.
    bool planDiffers = false;
};

/// A project with the comments of a review file. InputRefused: no plan of this project was sent with this
/// review.
Result<TakenReview> takenReview(const Project& mine, const Project& sent);

}  // namespace furrow
