#include "planner/audit/findings.h"

#include "planner/audit/driven_passes.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <utility>

namespace furrow {

namespace {

/// A smaller excess may come from drawing.
constexpr double kOutsideM = kChordErrorM;
constexpr std::size_t kMostMissedPieces = 20;

Message areaText(Area area) {
    return area < squareMetres(1000.0) ? message("{:.0f} m²", area.si())
                                       : message("{:.2f} ha", inHectares(area));
}

Message segmentName(const AuditInput& input, std::size_t index) {
    const PathSegment& segment = input.segments[index];
    switch (segment.kind) {
        case SegmentKind::Swath:
        case SegmentKind::HeadlandPass: return passName(segment.kind, segment.number);
        case SegmentKind::Refill: return "the way to refill";
        default: break;
    }
    const bool transfer = segment.kind == SegmentKind::Transfer;
    for (std::size_t before = index; before > 0; --before) {
        const PathSegment& worked = input.segments[before - 1];
        if (worked.implementDown && worked.number > 0) {
            const Message pass = passName(worked.kind, worked.number);
            return transfer ? message("the transfer after {}", pass) : message("the turn after {}", pass);
        }
    }
    const double atM = segment.samples.front().sM;
    return transfer ? message("the transfer at {:.0f} m", atM) : message("the turn at {:.0f} m", atM);
}

/// A place inside: the middle of the longest cut at half height.
Point placeInside(const Polygon& polygon) {
    const Bounds box = bounds(polygon);
    const double y = 0.5 * (box.min.y + box.max.y);
    std::vector<double> crossings;
    forEachEdge({polygon}, [&](Point a, Point b) {
        if ((a.y > y) != (b.y > y)) {
            crossings.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
        }
    });
    std::ranges::sort(crossings);
    Point place = polygon.outer.front();
    double longest = 0.0;
    for (std::size_t i = 1; i < crossings.size(); i += 2) {
        if (crossings[i] - crossings[i - 1] > longest) {
            longest = crossings[i] - crossings[i - 1];
            place = {0.5 * (crossings[i] + crossings[i - 1]), y};
        }
    }
    return place;
}

class Reporter {
public:
    Reporter(const AuditInput& input, const Measurements& measured) : input_{input}, measured_{measured} {}

    std::vector<AuditFinding> report() {
        reportClearance();
        reportUndrivable();
        reportCurvature();
        reportSteering();
        reportFolding();
        reportTank();
        reportBreaks();
        reportReverse();
        reportDroppedPasses();
        reportMissed();
        reportNotes();
        std::ranges::stable_sort(findings_, {}, [](const AuditFinding& each) {
            return std::tuple{each.finding.severity == Severity::Note,
                              each.segment.value_or(static_cast<std::size_t>(-1))};
        });
        return std::move(findings_);
    }

private:
    void add(Severity severity, FindingKind kind, Point place, Message text, Message suggestion,
             std::optional<std::size_t> segment = std::nullopt) {
        findings_.push_back({{.severity = severity,
                              .kind = kind,
                              .place = place,
                              .text = std::move(text),
                              .suggestion = std::move(suggestion)},
                             segment});
    }

    Message named(std::size_t segment) const { return segmentName(input_, segment).capitalised(); }

    void reportClearance() {
        if (measured_.clearance == nullptr) {
            return;
        }
        Trouble allowed;
        for (std::size_t i = 0; i < measured_.clearance->segments.size(); ++i) {
            const SegmentClearance& at = measured_.clearance->segments[i];
            if (at.clearanceM >= -kOutsideM) {
                continue;
            }
            if (input_.mayLeaveField) {
                allowed.add(-at.clearanceM, at.place, i);
                continue;
            }
            found_.insert(i);
            if (at.beyondLand) {
                add(Severity::Blocking, FindingKind::Outside, at.place,
                    message("{} leaves the field by {:.2f} m.", named(i), -at.clearanceM), "", i);
            } else {
                add(Severity::Blocking, FindingKind::Obstacle, at.place,
                    message("{} crosses an obstacle, by {:.2f} m.", named(i), -at.clearanceM),
                    "Plan the sides of the obstacle apart.", i);
            }
        }
        noteOverhang();
        if (allowed.count > 0) {
            add(Severity::Note, FindingKind::Outside, allowed.place,
                allowed.count == 1
                    ? message(
                          "{} leaves the field or crosses an obstacle, by up to {:.2f} m, as this plan allows.",
                          named(allowed.segment), allowed.worst)
                    : message(
                          "{} swaths and turns leave the field or cross an obstacle, by up to {:.2f} m, as this "
                          "plan allows.",
                          allowed.count, allowed.worst),
                "");
        }
    }

    void noteOverhang() {
        const ClearanceReport& clearance = *measured_.clearance;
        if (clearance.overhang.si() > kOutsideM) {
            add(Severity::Note, FindingKind::Overhang, clearance.overhangPlace,
                message(
                    "The implement stands over the edge of the field or an obstacle, by up to {:.2f} m, as "
                    "the overhang allows.",
                    clearance.overhang.si()),
                "");
        }
    }

    void reportUndrivable() {
        for (std::size_t i = 0; i < input_.segments.size(); ++i) {
            const PathSegment& segment = input_.segments[i];
            if (!segment.drivable && !found_.contains(i)) {
                add(Severity::Blocking, FindingKind::Undrivable,
                    segment.samples[segment.samples.size() / 2].position,
                    message("{} cannot be driven: {}.", named(i),
                            segment.reason.empty() ? Message{"the plan gives no reason"} : segment.reason),
                    "", i);
            }
        }
    }

    void reportCurvature() {
        for (const auto& [segment, tight] : measured_.kinematics.tooTight) {
            add(Severity::Blocking, FindingKind::Curvature, tight.place,
                message("{} bends with a radius of {:.2f} m; this machine needs {:.2f} m.", named(segment),
                        1.0 / tight.worst, input_.machine->minTurningRadius().si()),
                "Plan again with this machine's turning radius.", segment);
        }
    }

    void reportSteering() {
        const Trouble& steering = measured_.kinematics.steering;
        if (steering.count > 0) {
            add(Severity::Blocking, FindingKind::CurvatureRate, steering.place,
                message(
                    "The steering is too slow for the planned speed in {}; {} is the worst and would need "
                    "{:.2f} m/s.",
                    placesOf(steering.count), segmentName(input_, steering.segment),
                    measured_.kinematics.steerableMps),
                "Drive more slowly there, or plan again.", steering.segment);
        }
    }

    void reportFolding() {
        const Trouble& folding = measured_.kinematics.folding;
        if (folding.count > 0) {
            add(Severity::Blocking, FindingKind::Folded, folding.place,
                message(
                    "The machine has to stand for {:.0f} s to fold its implement or to unfold it, and does "
                    "not in {}.",
                    input_.machine->spec().implement.timeToFold.si(), placesOf(folding.count)),
                "Plan again; the times were changed.", folding.segment);
        }
    }

    void reportTank() {
        const TankReport& tank = measured_.tank;
        if (tank.beyond.count > 0) {
            add(Severity::Blocking, FindingKind::Refill, tank.beyond.place,
                message(input_.tank->gathers ? "The bunker is full in {}: {:.0f} m are worked beyond that."
                                             : "The tank is empty in {}: {:.0f} m are worked beyond that.",
                        segmentName(input_, tank.beyond.segment), tank.beyondM),
                "Give more refill points, or ones that are nearer.", tank.beyond.segment);
        }
        if (tank.away.count > 0) {
            add(Severity::Blocking, FindingKind::Refill, tank.away.place,
                message("The level changes {:.0f} m away from the refill points.", tank.away.worst),
                "Plan again; the levels were changed.", tank.away.segment);
        }
        if (tank.standing.count > 0) {
            add(Severity::Blocking, FindingKind::Refill, tank.standing.place,
                message("The machine has to stand for {:.0f} s at a refill point, and does not in {}.",
                        input_.machine->spec().tank->fillTime().si(), placesOf(tank.standing.count)),
                "Plan again; the times were changed.", tank.standing.segment);
        }
        if (tank.mismatch.count > 0) {
            add(Severity::Blocking, FindingKind::Refill, tank.mismatch.place,
                message("The stated level differs from the work that is done, by up to {:.0f} % of the tank.",
                        100.0 * tank.mismatch.worst),
                "Plan again; the levels were changed.", tank.mismatch.segment);
        }
    }

    void reportBreaks() {
        std::set<std::pair<std::size_t, Break::Kind>> told;
        Trouble onTheSpot;
        for (const Break& each : measured_.kinematics.breaks) {
            if (each.kind == Break::Kind::HeadingJump) {
                onTheSpot.add(each.size, each.place, each.segment);
                continue;
            }
            if (!told.insert({each.segment, each.kind}).second) {
                continue;
            }
            switch (each.kind) {
                case Break::Kind::Gap:
                    add(Severity::Blocking, FindingKind::MissingTurn, each.place,
                        message("Nothing leads to the start of {}, {:.1f} m away.",
                                segmentName(input_, each.segment), each.size),
                        "Plan the turn that is missing here.", each.segment);
                    break;
                case Break::Kind::Jump:
                    add(Severity::Blocking, FindingKind::Jump, each.place,
                        message("{} jumps by {:.2f} m.", named(each.segment), each.size),
                        "Plan again; the path was changed or cut here.", each.segment);
                    break;
                default:
                    add(Severity::Blocking, FindingKind::Heading, each.place,
                        message("{} moves {:.0f} degrees off where the machine points.", named(each.segment),
                                inDegrees(radians(each.size))),
                        "Plan again; the heading or the gear is wrong here.", each.segment);
            }
        }
        if (onTheSpot.count > 0) {
            const bool can = measured_.shape.turnsOnTheSpot;
            add(can ? Severity::Note : Severity::Blocking, FindingKind::HeadingJump, onTheSpot.place,
                message(can ? "The machine turns on the spot in {}, by up to {:.0f} degrees."
                            : "The machine turns on the spot in {}, by up to {:.0f} degrees; it cannot.",
                        placesOf(onTheSpot.count), inDegrees(radians(onTheSpot.worst))),
                can ? "" : "Take a machine that can.", can ? std::nullopt : std::optional{onTheSpot.segment});
        }
    }

    void reportReverse() {
        if (!input_.machine || measured_.kinematics.reversedM <= 0.0) {
            return;
        }
        const bool tractorCan = input_.machine->spec().tractor.canReverse;
        const bool implementCan = !measured_.shape.trailingM || input_.machine->spec().implement.canReverse;
        if (!tractorCan || !implementCan) {
            add(Severity::Blocking, FindingKind::Reverse, measured_.kinematics.reversedPlace,
                message(tractorCan ? "{:.0f} m are driven in reverse; the trailed implement cannot."
                                   : "{:.0f} m are driven in reverse; this machine cannot.",
                        measured_.kinematics.reversedM),
                "");
        }
    }

    void reportDroppedPasses() {
        const std::vector<double> shares = drivenShares(input_, measured_.motions);
        for (std::size_t i = 0; i < shares.size(); ++i) {
            if (shares[i] >= 0.5) {
                continue;
            }
            const PlannedPass& pass = input_.passes[i];
            add(Severity::Blocking,
                pass.kind == SegmentKind::HeadlandPass ? FindingKind::DroppedPass : FindingKind::DroppedSwath,
                pass.line[pass.line.size() / 2],
                shares[i] == 0.0
                    ? message("{} is planned, but nothing of it is driven with the implement down.",
                              passName(pass.kind, pass.number).capitalised())
                    : message("{} is planned, but only {:.0f} % of it is driven with the implement down.",
                              passName(pass.kind, pass.number).capitalised(), 100.0 * shares[i]),
                "Plan again; the path lacks this pass.");
        }
    }

    void reportMissed() {
        const SweptArea& swept = measured_.area;
        noteStrip();
        noteBeyondReach();
        const bool tooMuch = swept.droppedArea > kMissedShare * area(input_.workable);
        std::size_t told = 0;
        for (const Polygon& piece : swept.dropped) {
            if (area(piece) <= kMissedPiece || told == kMostMissedPieces) {
                break;
            }
            ++told;
            add(Severity::Blocking, FindingKind::Missed, placeInside(piece),
                message("{} in one piece are not worked.", areaText(area(piece))), "");
        }
        if (told == 0 && tooMuch && !swept.dropped.empty()) {
            add(Severity::Blocking, FindingKind::Missed, placeInside(swept.dropped.front()),
                message("{} are not worked, {:.1f} % of the field, in {}; this is the largest.",
                        areaText(swept.droppedArea), 100.0 * (swept.droppedArea / area(input_.workable)),
                        counted("{} piece", "{} pieces", swept.dropped.size())),
                "");
        }
    }

    /// Reports land out of reach.
    void noteBeyondReach() {
        const SweptArea& swept = measured_.area;
        if (swept.beyondReach.empty() || area(swept.beyondReach.front()) <= kMissedPiece) {
            return;
        }
        const Polygon& largest = swept.beyondReach.front();
        add(Severity::Note, FindingKind::OutOfReach, placeInside(largest),
            message("{} are out of this machine's reach; the largest piece, {}, lies here.",
                    areaText(swept.beyondReachArea), areaText(area(largest))),
            "");
    }

    void noteStrip() {
        const SweptArea& swept = measured_.area;
        if (swept.strip.empty()) {
            return;
        }
        add(Severity::Note, FindingKind::HeadlandNotWorked, placeInside(swept.strip.front()),
            swept.laneEnds > squareMetres(0.5)
                ? message(
                      "The headland strip, {}, is not worked by this plan, nor are {} at the ends of the swaths "
                      "beside it.",
                      areaText(swept.stripArea), areaText(swept.laneEnds))
                : message("The headland strip, {}, is not worked by this plan.", areaText(swept.stripArea)),
            "Work it along the boundary, before or after the swaths.");
    }

    static Message placesOf(std::size_t count) { return counted("{} place", "{} places", count); }

    void noteTrouble(const Trouble& trouble, FindingKind kind, Message text, Message suggestion) {
        if (trouble.count > 0) {
            add(Severity::Note, kind, trouble.place, std::move(text), std::move(suggestion));
        }
    }

    void reportNotes() {
        const Kinematics& found = measured_.kinematics;
        noteTrouble(found.mismatch, FindingKind::StatedCurvature,
                    message("The stated curvature differs from the path in {}, by up to {:.3f} 1/m.",
                            placesOf(found.mismatch.count), found.mismatch.worst),
                    "Plan again, or trust the positions.");
        noteTrouble(found.speed, FindingKind::Speed,
                    message("The stated speed is up to {:.2f} m/s above the machine's.", found.speed.worst),
                    "Lower the speeds, or correct the machine's.");
        noteTrouble(found.lateral, FindingKind::LateralAcceleration,
                    message("Curves are driven with up to {:.1f} m/s² sideways; the machine's limit is less.",
                            found.lateral.worst),
                    "Drive the curves more slowly.");
        if (found.time.count > 0) {
            // Rounding in files is far below a second in all. Without times nothing else is known of them.
            constexpr double kMissingS = 1.0;
            add(found.missingTimeS > kMissingS ? Severity::Blocking : Severity::Note, FindingKind::Time,
                found.time.place,
                message("Time and way do not fit the speed in {}.", placesOf(found.time.count)),
                "Plan again; the times were changed.");
        }
        noteCrossedLanes();
        noteHitchAngle();
    }

    void noteCrossedLanes() {
        const Traffic& traffic = measured_.traffic;
        // The machine may drive over one lane at its end.
        if (traffic.onWorkedM + traffic.onUnworkedM > 1.5 * measured_.shape.operatingWidthM) {
            add(Severity::Note, FindingKind::LanesCrossed, traffic.longestPlace,
                message("{:.0f} m are driven over the field with the implement up; longest: {}.",
                        traffic.onWorkedM + traffic.onUnworkedM, segmentName(input_, traffic.longestSegment)),
                "", traffic.longestSegment);
        }
    }

    void noteHitchAngle() {
        if (input_.machine && input_.machine->spec().implement.maxHitchAngle) {
            Trouble angle;
            const double limit = input_.machine->spec().implement.maxHitchAngle->si();
            for (std::size_t i = 0; i < measured_.motions.size(); ++i) {
                const SegmentMotion& motion = measured_.motions[i];
                if (motion.largestHitchAngleRad > limit) {
                    angle.add(motion.largestHitchAngleRad, motion.largestHitchAnglePlace, i);
                }
            }
            noteTrouble(angle, FindingKind::HitchAngle,
                        message("The hitch bends by {:.0f} degrees in {}; {:.0f} are allowed.",
                                inDegrees(radians(angle.worst)), counted("{} turn", "{} turns", angle.count),
                                inDegrees(radians(limit))),
                        "");
        }
    }

    const AuditInput& input_;
    const Measurements& measured_;
    std::vector<AuditFinding> findings_;
    std::set<std::size_t> found_;  ///< segments reported as outside
};

}  // namespace

std::vector<AuditFinding> findingsOf(const AuditInput& input, const Measurements& measured) {
    return Reporter{input, measured}.report();
}

}  // namespace furrow
