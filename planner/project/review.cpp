#include "planner/project/review.h"

#include <algorithm>
#include <functional>
#include <iterator>

namespace furrow {

namespace {

/// Takes what is newer; whether that was anything.
bool update(ReviewComment& mine, const ReviewComment& theirs) {
    const ReviewComment before = mine;
    if (theirs.written > mine.written) {
        mine = theirs;
    }
    mine.settled = before.settled || theirs.settled;
    return mine != before;
}

}  // namespace

std::vector<ReviewComment> Review::openComments() const {
    std::vector<ReviewComment> open;
    std::ranges::copy_if(comments, std::back_inserter(open), std::logical_not{}, &ReviewComment::settled);
    return open;
}

MergedReview merged(const Review& mine, const Review& theirs) {
    MergedReview result{.review = mine};
    for (const ReviewComment& comment : theirs.comments) {
        auto& comments = result.review.comments;
        if (const auto same = std::ranges::find(comments, comment.id, &ReviewComment::id);
            same == comments.end()) {
            comments.push_back(comment);
            ++result.added;
        } else if (update(*same, comment)) {
            ++result.changed;
        }
    }
    if (theirs.verdict.verdict != Verdict::None && theirs.verdict.written > mine.verdict.written) {
        result.review.verdict = theirs.verdict;
        result.verdictChanged = true;
    }
    return result;
}

}  // namespace furrow
