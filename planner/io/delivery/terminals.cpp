#include "planner/io/delivery/terminals.h"

#include "planner/io/content/plan_content.h"
#include "planner/io/delivery/checked_files.h"
#include "planner/io/formats/registry.h"
#include "planner/plan/plan.h"
#include "planner/settings/settings.h"

#include <string>
#include <utility>
#include <vector>

namespace furrow {

namespace {

// Which terminal reads what follows the model list of an exporter that advisers use (chamber of agriculture
// of Lower Austria, 2026). None of it was tried on a machine by us, and the words say so.
constexpr std::string_view kLinesV4 =
    "Shows the boundary with holes and obstacles, the headland where the terminal knows it, and the guidance lines; it "
    "plans turns and order itself. The import may have to be unlocked. Not tested on the machine by us.";
constexpr std::string_view kLinesV3 =
    "Shows the boundary with holes and obstacles and the guidance lines; it plans turns and order itself. The import "
    "may have to be unlocked. Not tested on the machine by us.";
constexpr std::string_view kAgGps =
    "Shows the boundary and the guidance lines; it plans turns and order itself. Not tested on the machine by us.";
constexpr ExportOptions kAscii{.asciiNames = true};

constexpr Terminal kTerminals[] = {
    {"agopengps",
     "AgOpenGPS 6",
     "agopengps",
     "Drives the whole path, turns included, as a recorded path; stretches in reverse gear are left to the driver. "
     "Shows boundary, headland and guidance lines. Copy the field's folder to Documents/AgOpenGPS/Fields.",
     {},
     "AgOpenGPS/Fields"},
    {"agopengps-isoxml",
     "AgOpenGPS 6, import of ISOXML",
     "isoxml",
     "Shows the boundary, its holes, the headland and the guidance lines, not the path. Holes are written as "
     "obstacles, since it overlooks others.",
     {.holesAsObstacles = true}},
    {"ardupilot-rover",
     "ArduPilot Rover, Mission Planner",
     "waypoints",
     "Drives the path from waypoint to waypoint, rounding corners its own way; relay 1 is on where the implement "
     "works. Not tested on the machine by us.",
     {},
     {},
     false},
    {"case-afs-pro-700", "Case IH and Steyr AFS Pro 700", "isoxml-v3", kLinesV3, kAscii},
    {"case-afs-pro-1200", "Case IH and Steyr AFS Pro 1200, S-Fleet Pro", "isoxml", kLinesV4},
    {"cci", "CCI 800, CCI 1200", "isoxml", kLinesV4},
    {"chcnav", "CHC Navigation", "isoxml", kLinesV4},
    {"claas-cemis-1200", "Claas Cemis 1200", "isoxml", kLinesV4},
    {"claas-s10", "Claas S10", "isoxml-v3", kLinesV3},
    {"deutz-imonitor-3", "Deutz-Fahr iMonitor 3", "isoxml", kLinesV4},
    {"fendt", "Fendt One, Vario terminal", "isoxml", kLinesV4},
    {"fjdynamics", "FJ Dynamics", "isoxml", kLinesV4},
    {"isobus", "Another ISOBUS terminal", "isoxml", kLinesV4},
    {"isobus-old", "An older ISOBUS terminal", "isoxml-v3", kLinesV3, kAscii},
    {"john-deere-operations-center",
     "John Deere Operations Center",
     "shapefile-zip",
     "Takes the boundary only, as an upload from a computer; no guidance lines, no path.",
     {},
     {},
     false},
    {"massey-ferguson", "Massey Ferguson Datatronic 5, Fieldstar 5", "isoxml", kLinesV4},
    {"mueller-touch", "M\u00fcller-Elektronik TOUCH800, TOUCH1200", "isoxml", kLinesV4},
    {"new-holland-intelliview-4", "New Holland IntelliView 4", "isoxml-v3", kLinesV3, kAscii},
    {"qgroundcontrol",
     "QGroundControl",
     "qgc-plan",
     "Shows the path as a mission, and the boundary and obstacles as fences. Not tested on the machine by us.",
     {},
     {},
     false},
    {"raven", "Raven CR7, CR12, Viper 4, Viper 4+", "isoxml", kLinesV4},
    {"ros2",
     "A robot with ROS 2",
     "rosbag2-mcap",
     "Gets the whole path as nav_msgs/Path, and stretches in one gear each where it reverses.",
     {},
     "ros",
     false},
    {"sveaverken", "Sveaverken", "isoxml", kLinesV4},
    {"topcon", "Topcon X25, X35, XD, XD+", "isoxml", kLinesV4},
    {"trimble", "Trimble CFX-750, FM-750, FM-1000, FMX, GFX-750, TMX-2050", "aggps", kAgGps, kAscii},
    {"valtra-smarttouch", "Valtra SmartTouch", "isoxml", kLinesV4},
};

}  // namespace

std::span<const Terminal> terminals() {
    return kTerminals;
}

Result<const Terminal*> findTerminal(std::string_view id) {
    std::vector<std::string_view> ids;
    std::string listed;
    for (const Terminal& terminal : kTerminals) {
        if (terminal.id == id) {
            return &terminal;
        }
        ids.push_back(terminal.id);
        listed += (listed.empty() ? "" : ", ") + std::string{terminal.id};
    }
    const std::string nearest = nearestName(id, ids);
    return std::unexpected(Error{.code = ErrorCode::Usage,
                                 .what = message("there is no terminal '{}'", id),
                                 .where = "--terminal",
                                 .remedy = nearest.empty() ? message("use one of: {}", listed)
                                                           : message("did you mean '{}'?", nearest)});
}

Result<FormatFiles> terminalFiles(const Terminal& terminal, const Plan& plan, const JobContext& job) {
    const Format* format = *findPlanFormat(terminal.format);
    const FieldContent content = contentOf(plan, terminal.options);
    auto made = checkedFiles(
        *format, {.fields = {&content, 1}, .plan = &plan, .options = terminal.options, .job = job});
    if (made) {
        for (FileToWrite& file : made->files) {
            file.path = std::filesystem::path{terminal.folder} / file.path;
        }
    }
    return made;
}

}  // namespace furrow
