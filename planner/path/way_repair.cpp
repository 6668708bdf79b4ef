#include "planner/path/way_repair.h"

#include "planner/geometry/curve_parts.h"
#include "planner/geometry/tolerances.h"
#include "planner/headland/smooth_ring.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>
#include <utility>

namespace furrow {

namespace {

constexpr double kSameWayHeadingRad = 1e-6;
// Number of starts tried for a closed pass.
constexpr int kStarts = 12;
// Number of pairs between which a pass is tried, shortest detour first.
constexpr std::size_t kMostPairsTried = 8;

bool isSame(const Pose& a, const Pose& b) {
    return distance(a.position, b.position) < kMeetM &&
           std::abs(std::remainder((a.heading - b.heading).si(), 2.0 * std::numbers::pi)) <
               kSameWayHeadingRad;
}

class WayRepair {
public:
    WayRepair(std::vector<Leg> legs, RememberedWays& ways, const Rig& lowered, const DrivenParts& parts,
              const JobContext& job)
        : legs_{std::move(legs)}, ways_{ways}, lowered_{lowered}, parts_{parts}, job_{job} {}

    std::vector<Leg> run() {
        for (std::size_t i = 0; i + 1 < legs_.size() && !job_.stopRequested(); ++i) {
            const bool apart =
                parts_.separate(legs_[i].line.end().position, legs_[i + 1].line.start.position);
            if (!apart && !leads(legs_[i], legs_[i + 1], SearchEffort::Thorough)) {
                static_cast<void>(turnRound(i + 1) || turnRound(i) || turnBothRound(i) || moveAway(i + 1) ||
                                  moveAway(i));
            }
        }
        return std::move(legs_);
    }

private:
    bool leads(const Leg& from, const Leg& to, SearchEffort effort = SearchEffort::Quick) {
        const Pose leaving = from.line.end();
        return isSame(leaving, to.line.start) || ways_(leaving, to.line.start, job_, effort).has_value();
    }

    bool leadsTo(const Leg& leg, std::size_t place) { return place == 0 || leads(legs_[place - 1], leg); }
    bool leadsFrom(const Leg& leg, std::size_t place) {
        return place + 1 >= legs_.size() || leads(leg, legs_[place + 1]);
    }

    /// The same work with another start or in the other direction.
    std::vector<Leg> others(const Leg& leg) const {
        std::vector<Leg> found;
        if (leg.kind != SegmentKind::HeadlandPass) {
            return found;
        }
        const Length length = leg.line.length();
        if (isSame(leg.line.start, leg.line.end())) {
            for (int i = 1; i < kStarts; ++i) {
                const Length way = (static_cast<double>(i) / kStarts) * length;
                Leg other = leg;
                other.line = partOf(leg.line, way, length);
                std::ranges::copy(partOf(leg.line, Length{}, way).pieces,
                                  std::back_inserter(other.line.pieces));
                found.push_back(std::move(other));
            }
            return found;
        }
        Leg back = leg;
        back.line = reversedLine(leg.line);
        // The nose is at the place of the tail, so it must be tested.
        if (lowered_.driven(Rig::inLine(back.line.start), back.line)) {
            found.push_back(std::move(back));
        }
        return found;
    }

    bool turnRound(std::size_t place) {
        for (Leg& other : others(legs_[place])) {
            if (leadsTo(other, place) && leadsFrom(other, place)) {
                legs_[place] = std::move(other);
                return true;
            }
        }
        return false;
    }

    bool turnBothRound(std::size_t place) {
        for (Leg& first : others(legs_[place])) {
            if (!leadsTo(first, place)) {
                continue;
            }
            for (Leg& second : others(legs_[place + 1])) {
                if (leads(first, second) && leadsFrom(second, place + 1)) {
                    legs_[place] = std::move(first);
                    legs_[place + 1] = std::move(second);
                    return true;
                }
            }
        }
        return false;
    }

    /// Moves a leg between two other legs, if a way closes its old place.
    bool moveAway(std::size_t place) {
        if (legs_[place].kind != SegmentKind::HeadlandPass || place == 0 || place + 1 >= legs_.size() ||
            !leads(legs_[place - 1], legs_[place + 1])) {
            return false;
        }
        std::vector<Leg> candidates = others(legs_[place]);
        candidates.insert(candidates.begin(), legs_[place]);
        std::vector<Leg> rest = legs_;
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(place));
        std::vector<std::pair<double, std::size_t>> detours;  // and the leg that follows
        for (std::size_t i = 1; i < rest.size(); ++i) {
            const Point before = rest[i - 1].line.end().position;
            const Point after = rest[i].line.start.position;
            if (i != place && distance(before, after) > kMeetM) {
                detours.emplace_back(distance(before, candidates.front().line.start.position) +
                                         distance(candidates.front().line.end().position, after) -
                                         distance(before, after),
                                     i);
            }
        }
        std::ranges::sort(detours);
        detours.resize(std::min(detours.size(), kMostPairsTried));
        for (const auto& [detour, before] : detours) {
            for (Leg& leg : candidates) {
                if (!job_.stopRequested() && leads(rest[before - 1], leg) && leads(leg, rest[before])) {
                    rest.insert(rest.begin() + static_cast<std::ptrdiff_t>(before), std::move(leg));
                    legs_ = std::move(rest);
                    return true;
                }
            }
        }
        return false;
    }

    std::vector<Leg> legs_;
    RememberedWays& ways_;
    const Rig& lowered_;
    const DrivenParts& parts_;
    const JobContext& job_;
};

}  // namespace

std::vector<Leg> withWaysBetween(std::vector<Leg> legs, RememberedWays& ways, const Rig& lowered,
                                 const DrivenParts& parts, const JobContext& job) {
    return WayRepair{std::move(legs), ways, lowered, parts, job}.run();
}

std::vector<Leg> partByPart(std::vector<Leg> legs, const DrivenParts& parts) {
    std::vector<std::size_t> partOfLeg;
    std::vector<std::size_t> order;
    for (const Leg& leg : legs) {
        partOfLeg.push_back(parts.partAt(leg.line.start.position));
        if (!std::ranges::contains(order, partOfLeg.back())) {
            order.push_back(partOfLeg.back());
        }
    }
    if (order.size() < 2) {
        return legs;
    }
    if (partOfLeg.back() != order.front()) {
        const auto last = std::ranges::find(order, partOfLeg.back());
        std::rotate(last, last + 1, order.end());
    }
    std::vector<Leg> sorted;
    for (const std::size_t part : order) {
        for (std::size_t i = 0; i < legs.size(); ++i) {
            if (partOfLeg[i] == part) {
                sorted.push_back(std::move(legs[i]));
            }
        }
    }
    return sorted;
}

}  // namespace furrow
