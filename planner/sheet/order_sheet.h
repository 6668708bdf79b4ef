#pragma once

#include "planner/core/result.h"
#include "planner/field/field.h"
#include "planner/machine/machine.h"
#include "planner/path/finding.h"
#include "planner/path/path.h"
#include "planner/plan/plan.h"
#include "planner/settings/parameter.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace furrow {

/// A stretch that is worked, in driving direction.
struct SheetPass {
    SegmentKind kind = SegmentKind::Swath;  ///< a swath or a headland pass
    int number = 0;                         ///< of the swath, or of the headland pass from the outside
    Polyline line;                          ///< at least two points; of the vehicle's reference point
    Length length;
    Duration time;
    /// Degrees clockwise from north, from its first to its last point. Empty for headland passes, which bend.
    std::optional<double> bearingDeg;
};

/// A stretch between two that are worked.
struct SheetWay {
    Polyline line;
    bool reverse = false;
    bool drivable = true;
};

/// How often one kind of turn is driven.
struct SheetTurns {
    std::string type;  ///< of PathSegment::turnType
    int count = 0;

    friend bool operator==(const SheetTurns&, const SheetTurns&) = default;
};

struct SheetObstacle {
    std::string name;
    MultiPolygon outline;  ///< as drawn
    bool passable = false;
};

struct SheetGate {
    std::string name;
    Point place;
    GeoPoint geo;
};

/// A setting that is not what it would be by itself.
struct SheetSetting {
    const Parameter* parameter = nullptr;
    SettingValue value;

    friend bool operator==(const SheetSetting&, const SheetSetting&) = default;
};

/// Figures of a plan. Empty where nothing has measured them.
struct SheetFigures {
    Area field;                   ///< without holes and obstacles
    std::optional<Area> covered;  ///< worked at least once
    std::optional<double> coveredShare;
    std::optional<double> overlapShare;  ///< of the land to be worked
    std::optional<Area> missed;
    std::optional<Area> outside;
    Length path;
    Length working;  ///< with the implement down
    Length reverse;
    Duration time;
    Duration workingTime;
    std::optional<double> gap;         ///< of the route: turning above the least that is possible
    std::optional<double> fuelLitres;  ///< where the machine says what it burns
    Length headlandWidth;
    int headlandPasses = 0;
    Length margin;
    int swaths = 0;
    int refills = 0;   ///< stops to fill the tank or to empty the bunker
    Length refillWay;  ///< to the refill points and back
};

/// What stands on the work order of one plan.
struct OrderSheet {
    std::string fieldId;
    std::string fieldName;
    std::string version;  ///< of Furrow, that made the plan
    Machine machine;
    std::string operation;  ///< of kOperationKind
    std::vector<SheetSetting> settings;
    MultiPolygon field;  ///< as drawn, in metres
    MultiPolygon mainland;
    std::vector<SheetObstacle> obstacles;
    std::vector<SheetGate> gates;
    std::vector<SheetPass> passes;  ///< in driving order
    std::vector<SheetWay> ways;
    std::vector<SheetTurns> turns;  ///< the most frequent first
    Point start;
    Point end;
    GeoPoint startGeo;
    std::optional<LocalFrame> frame;  ///< of all places
    SheetFigures figures;
    std::vector<Finding> findings;
    std::vector<GeoPoint> findingPlaces;  ///< of each
    /// The bytes of path.csv: what the plan's hash is made of.
    std::string pathFile;

    std::ptrdiff_t blockingCount() const;
};

/// Where to meet the field: the gate nearest to the first place of the path; that place where there is none.
GeoPoint meetingPlace(const OrderSheet& sheet);

/// What the machine burns on a path; empty where it does not say.
std::optional<double> fuelLitres(const Machine& machine, Duration working, Duration whole);

/// The sheet of a written plan, from its folder (summary.json, path.csv, plan.geojson). Texts of findings are
/// English, as they were written.
///
/// @return ReadFailed: the folder or one of the three files is missing or cannot be read. InputRefused,
///         naming the file: damaged. Cost: linear in the files.
Result<OrderSheet> readOrderSheet(const std::filesystem::path& folder);

/// The sheet of a plan: what its files would hold, with findings that can still be translated.
Result<OrderSheet> orderSheet(const Plan& plan);

}  // namespace furrow
