#include "planner/geometry/thin_tips.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace furrow {

namespace {

// Blunter corners are left alone: cutting them gains nothing. The cosine of 30 degrees.
constexpr double kSpikeCosine = 0.866;
// Sides of a spike whose lengths differ by less are equally long.
constexpr double kSameLengthM = 1e-9;
// A tip that ends at two points keeps them, where its width is reached. A shorter one stays as it is.
constexpr double kLeastWidths = 4.0;
// A ring of n points is done after some n cuts.
constexpr std::size_t kMostCutsPerPoint = 8;

class RingTips {
public:
    RingTips(const Ring& ring, double widthM) : widthM_{widthM} {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            corners_.push_back({ring[i], (i + ring.size() - 1) % ring.size(), (i + 1) % ring.size()});
            open_.push_back(ring.size() - 1 - i);
        }
        left_ = ring.size();
        cutsLeft_ = kMostCutsPerPoint * ring.size();
    }

    Ring run() {
        while (!open_.empty() && left_ > 3 && cutsLeft_ > 0) {
            const std::size_t i = open_.back();
            open_.pop_back();
            if (!corners_[i].isGone) {
                cutAt(i);
            }
        }
        Ring ring;
        std::size_t at = 0;
        while (corners_[at].isGone) {
            ++at;
        }
        for (std::size_t i = 0; i < left_; ++i) {
            ring.push_back(corners_[at].at);
            at = corners_[at].next;
        }
        return ring;
    }

private:
    struct Corner {
        Point at;
        std::size_t before = 0;
        std::size_t next = 0;
        bool isGone = false;
    };

    void cutAt(std::size_t i) {
        const auto [at, before, next, isGone] = corners_[i];
        const Point back = corners_[before].at - at;
        const Point onward = corners_[next].at - at;
        const double backM = norm(back);
        const double onwardM = norm(onward);
        const double cosine = dot(back, onward) / (backM * onwardM);
        const bool isTip = cross(back, onward) < 0.0 && cosine > kSpikeCosine;
        if (!isTip) {
            return;
        }
        --cutsLeft_;
        const double sine = std::sqrt(std::max(1e-18, 0.5 * (1.0 - cosine)));  // of half of the angle
        const double deepM = 0.5 * widthM_ / sine;
        const double shorterM = std::min(backM, onwardM);
        if (deepM < shorterM) {
            if (deepM > kLeastWidths * widthM_) {
                // Wide enough from here on.
                corners_[i].at = at + (deepM / backM) * back;
                insertAfter(i, at + (deepM / onwardM) * onward);
            }
            return;
        }
        if (std::abs(backM - onwardM) < kSameLengthM) {
            drop(i);
        } else {
            corners_[i].at = at + (backM < onwardM ? (backM / onwardM) * onward : (onwardM / backM) * back);
            open_.push_back(i);
        }
        open_.push_back(before);
        open_.push_back(next);
    }

    void insertAfter(std::size_t i, Point point) {
        const std::size_t next = corners_[i].next;
        corners_.push_back({point, i, next});
        corners_[next].before = corners_.size() - 1;
        corners_[i].next = corners_.size() - 1;
        ++left_;
    }

    void drop(std::size_t i) {
        corners_[corners_[i].before].next = corners_[i].next;
        corners_[corners_[i].next].before = corners_[i].before;
        corners_[i].isGone = true;
        --left_;
    }

    double widthM_;
    std::vector<Corner> corners_;
    std::vector<std::size_t> open_;  ///< to be looked at
    std::size_t left_ = 0;
    std::size_t cutsLeft_ = 0;
};

}  // namespace

Polygon withoutThinTips(const Polygon& polygon, Length width) {
    Polygon left{.outer = RingTips{polygon.outer, width.si()}.run(), .holes = {}};
    for (const Ring& hole : polygon.holes) {
        left.holes.push_back(RingTips{hole, width.si()}.run());
    }
    return left;
}

}  // namespace furrow
