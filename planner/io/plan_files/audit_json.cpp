#include "planner/io/plan_files/audit_json.h"

#include <nlohmann/json.hpp>

namespace furrow {

namespace {

using OrderedJson = nlohmann::ordered_json;

template <class Quantity>
OrderedJson orNull(const std::optional<Quantity>& quantity) {
    return quantity ? OrderedJson(quantity->si()) : OrderedJson();
}

OrderedJson orNull(const std::optional<double>& number) {
    return number ? OrderedJson(*number) : OrderedJson();
}

}  // namespace

std::string auditJson(const AuditReport& report, std::span<const Finding> findings, const LocalFrame& frame) {
    OrderedJson list = OrderedJson::array();
    for (const Finding& finding : findings) {
        const GeoPoint place = frame.toGeo(finding.place);
        OrderedJson said{{"severity", finding.severity == Severity::Blocking ? "blocking" : "note"},
                         {"kind", kindId(finding)},
                         {"lon_deg", place.lonDeg},
                         {"lat_deg", place.latDeg},
                         {"text", finding.text},
                         {"suggestion", finding.suggestion}};
        if (finding.change) {
            said["change"] = {{"key", finding.change->key}, {"value", finding.change->value}};
        }
        list.push_back(std::move(said));
    }
    OrderedJson all{{"workable_m2", report.workable.si()},
                    {"covered_m2", orNull(report.covered)},
                    {"covered", orNull(report.coveredShare)},
                    {"covered_of_reachable", orNull(report.coveredOfReachable)},
                    {"missed_m2", orNull(report.missed)},
                    {"left_on_purpose_m2", orNull(report.leftOnPurpose)},
                    {"overlap_m2", orNull(report.overlap)},
                    {"overlap_headland_m2", orNull(report.overlapHeadland)},
                    {"outside_m2", orNull(report.outside)},
                    {"min_clearance_m", orNull(report.minClearance)},
                    {"overhang_m2", report.overhangArea.si()},
                    {"overhang_m", report.overhang.si()},
                    {"max_curvature_1pm", orNull(report.maxCurvature)},
                    {"max_curvature_mismatch_1pm", orNull(report.maxCurvatureMismatch)},
                    {"max_curvature_rate_1pm2", orNull(report.maxCurvatureRate)},
                    {"max_position_jump_m", orNull(report.maxPositionJump)},
                    {"max_heading_jump_rad", orNull(report.maxHeadingJump)},
                    {"max_hitch_angle_rad", orNull(report.maxHitchAngle)},
                    {"reverse_length_m", report.reversed.si()},
                    {"driven_on_worked_m", report.drivenOnWorked.si()},
                    {"driven_on_unworked_m", report.drivenOnUnworked.si()},
                    {"max_wheel_passes", report.mostWheelPasses},
                    {"often_driven_share", report.oftenDrivenShare},
                    {"wheel_square_m", report.wheelSquare.si()},
                    {"area_error_m2", report.areaError.si()},
                    {"distance_error_m", report.distanceError.si()},
                    {"findings", std::move(list)}};
    // What does not exist is left out.
    for (auto member = all.begin(); member != all.end();) {
        member = member->is_null() ? all.erase(member) : std::next(member);
    }
    return all.dump(2, ' ', false, OrderedJson::error_handler_t::replace);
}

}  // namespace furrow
