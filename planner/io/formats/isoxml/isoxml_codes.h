#pragma once

// What the numbers of ISO 11783-10 mean that are read and written here (Annex D; xs:enumeration of the
// schemas).

namespace furrow::isoxml {

// PLN A, kinds of polygons
inline constexpr const char* kFieldBoundary = "1";
inline constexpr const char* kWater = "3";
inline constexpr const char* kBuilding = "4";
inline constexpr const char* kRoad = "5";
inline constexpr const char* kObstacleArea = "6";
inline constexpr const char* kOtherArea = "8";
inline constexpr const char* kMainField = "9";
inline constexpr const char* kHeadlandArea = "10";
inline constexpr const char* kWindbreak = "12";

// LSG A, kinds of line strings
inline constexpr const char* kOuterRing = "1";
inline constexpr const char* kInnerRing = "2";
inline constexpr const char* kGuidanceLine = "5";
inline constexpr const char* kObstacleLine = "9";

// PNT A, kinds of points; 3 and above only in version 4
inline constexpr const char* kFlag = "1";
inline constexpr const char* kOtherPoint = "2";
inline constexpr const char* kFieldAccess = "3";
inline constexpr const char* kObstaclePoint = "5";
inline constexpr const char* kReferenceA = "6";
inline constexpr const char* kReferenceB = "7";
inline constexpr const char* kCentre = "8";
inline constexpr const char* kGuidancePoint = "9";

// GPN C, kinds of guidance patterns
inline constexpr const char* kAb = "1";
inline constexpr const char* kAPlus = "2";
inline constexpr const char* kCurve = "3";
inline constexpr const char* kPivot = "4";
inline constexpr const char* kSpiral = "5";

// GPN D, arcs of a pivot
inline constexpr const char* kClockwise = "1";
inline constexpr const char* kCounterClockwise = "2";
inline constexpr const char* kFullCircle = "3";

// GPN E and F, where others are laid beside the line, and which of its ends are drawn out
inline constexpr const char* kBothSides = "1";
inline constexpr const char* kBothEnds = "1";
inline constexpr const char* kNone = "4";

// TSK G
inline constexpr const char* kPlanned = "1";

// AFE D, kinds of files beside the task data
inline constexpr const char* kLinkList = "1";

// GPN I
inline constexpr const char* kMadeOnDesktop = "16";

}  // namespace furrow::isoxml
