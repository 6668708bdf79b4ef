#pragma once

#include "planner/core/geo_point.h"

#include <optional>
#include <string>
#include <vector>

namespace furrow {

/// What somebody says of a plan, at a place of the map or of all of it.
struct ReviewComment {
    std::string id;       ///< not empty; the same in every file that the comment is in
    std::string author;   ///< may be empty
    std::string written;  ///< time in UTC, ISO 8601: "2026-11-25T10:56:00Z"
    std::string text;
    std::optional<GeoPoint> place;
    std::string planKey;  ///< of field and plan when it was written (planKey)
    bool settled = false;
    /// Members of a file that this version does not know, as a JSON object; empty for none.
    std::string others;

    friend bool operator==(const ReviewComment&, const ReviewComment&) = default;
};

enum class Verdict { None, Approved, ChangesWanted };

/// Whether somebody agrees with a plan.
struct ReviewVerdict {
    Verdict verdict = Verdict::None;
    std::string author;
    std::string written;  ///< as ReviewComment::written
    std::string planKey;  ///< of field and plan that it is about

    friend bool operator==(const ReviewVerdict&, const ReviewVerdict&) = default;
};

/// The review of one plan.
struct Review {
    /// Set when the plan is sent for review. What comes back belongs here if it has the same.
    std::string id;
    /// It came as a review file: whoever has it is asked, and sends it back.
    bool received = false;
    std::vector<ReviewComment> comments;  ///< in the order in which they came
    ReviewVerdict verdict;
    std::string others;

    bool empty() const { return id.empty() && comments.empty() && verdict.verdict == Verdict::None; }
    /// Comments that nobody has settled.
    std::vector<ReviewComment> openComments() const;
    friend bool operator==(const Review&, const Review&) = default;
};

/// What came with another copy of a review.
struct MergedReview {
    Review review;
    int added = 0;    ///< comments
    int changed = 0;  ///< comments that are newer there
    bool verdictChanged = false;
};

/// A review with what another copy of it has more, or newer. Comments are told apart by their ids: the same
/// copy twice adds nothing. What is settled on either side is settled. Of two texts and two verdicts the one
/// written later holds.
MergedReview merged(const Review& mine, const Review& theirs);

}  // namespace furrow
