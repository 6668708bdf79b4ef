#include "planner/path/finding.h"

namespace furrow {

std::string_view kindId(FindingKind kind) {
    switch (kind) {
        case FindingKind::Outside: return "outside";
        case FindingKind::Obstacle: return "obstacle";
        case FindingKind::Undrivable: return "undrivable";
        case FindingKind::Curvature: return "curvature";
        case FindingKind::MissingTurn: return "missing-turn";
        case FindingKind::Jump: return "jump";
        case FindingKind::Heading: return "heading";
        case FindingKind::HeadingJump: return "heading-jump";
        case FindingKind::Reverse: return "reverse";
        case FindingKind::DroppedPass: return "dropped-pass";
        case FindingKind::DroppedSwath: return "dropped-swath";
        case FindingKind::Missed: return "missed";
        case FindingKind::OutOfReach: return "out-of-reach";
        case FindingKind::Overhang: return "overhang";
        case FindingKind::HeadlandNotWorked: return "headland-not-worked";
        case FindingKind::CurvatureRate: return "curvature-rate";
        case FindingKind::StatedCurvature: return "stated-curvature";
        case FindingKind::Speed: return "speed";
        case FindingKind::LateralAcceleration: return "lateral-acceleration";
        case FindingKind::Time: return "time";
        case FindingKind::LanesCrossed: return "lanes-crossed";
        case FindingKind::HitchAngle: return "hitch-angle";
        case FindingKind::Gate: return "gate";
        case FindingKind::TurnKind: return "turn-kind";
        case FindingKind::Folded: return "folded";
        case FindingKind::Refill: return "refill";
        case FindingKind::Repair: return "repair";
        case FindingKind::Instead: return "instead";
        case FindingKind::Setting: return "setting";
    }
    return {};
}

Weight weightOf(const Finding& finding) {
    if (finding.severity == Severity::Blocking) {
        return Weight::Blocks;
    }
    if (finding.change) {
        return Weight::Look;
    }
    switch (finding.kind) {
        case FindingKind::LanesCrossed:
        case FindingKind::Overhang:
        case FindingKind::TurnKind:
        case FindingKind::Folded:
        case FindingKind::Repair:
        case FindingKind::Instead:
        case FindingKind::Setting: return Weight::Information;
        default: return Weight::Look;
    }
}

std::string_view kindId(const Finding& finding) {
    return finding.kind == FindingKind::Setting ? std::string_view{finding.setting} : kindId(finding.kind);
}

}  // namespace furrow
