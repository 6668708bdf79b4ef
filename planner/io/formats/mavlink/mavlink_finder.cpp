#include "planner/io/formats/mavlink/mavlink.h"

#include "planner/core/json_text.h"
#include "planner/core/separated_text.h"
#include "planner/core/text.h"
#include "planner/io/files/json_values.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>

namespace furrow {

namespace {

using nlohmann::json;

// MAV_CMD that are written, and MAV_FRAME
constexpr std::int64_t kWaypointItem = 16;
constexpr std::array<std::int64_t, 4> kCommands = {kWaypointItem, 178, 181, 194};
constexpr double kAbsolute = 0.0;
constexpr double kRelative = 3.0;

void addMission(const json& mission, ReceivedContent& found) {
    ReceivedNumbers items{.first = 1, .numbers = {}};
    ReceivedPath path;
    const json& home = memberOf(mission, "plannedHomePosition");
    found.points.push_back({numberAt(home, 1), numberAt(home, 0)});
    for (const json& item : memberOf(mission, "items")) {
        const json& command = memberOf(item, "command");
        const json& parameters = memberOf(item, "params");
        const bool known =
            command.is_number_integer() && std::ranges::contains(kCommands, command.get<std::int64_t>());
        if (!known || parameters.size() != 7) {
            found.faults.push_back(badLine(items.numbers.size() + 1));
            break;
        }
        items.numbers.push_back(
            static_cast<std::int64_t>(numberAt(json::array({memberOf(item, "doJumpId")}), 0)));
        if (command.get<std::int64_t>() == kWaypointItem) {
            path.samples.push_back({.geo = {numberAt(parameters, 5), numberAt(parameters, 4)}});
        }
    }
    found.orders.push_back(std::move(items));
    found.paths.push_back(std::move(path));
}

/// Latitude first; an exclusion is an area of its own.
void addFences(const json& polygons, ReceivedContent& found) {
    for (const json& fence : polygons) {
        GeoRing ring;
        for (const json& position : memberOf(fence, "polygon")) {
            ring.push_back({numberAt(position, 1), numberAt(position, 0)});
        }
        const bool inside = memberOf(fence, "inclusion") == true;
        found.areas.push_back({.kind = inside ? ReceivedArea::Kind::Field : ReceivedArea::Kind::Obstacle,
                               .name = inside ? "inclusion" : "exclusion",
                               .rings = {.outer = std::move(ring), .holes = {}},
                               .statedM2 = std::nullopt});
    }
}

}  // namespace

std::vector<ReceivedContent> findWaypoints(std::span<const FileInMemory> files, const ExportJob&) {
    std::vector<ReceivedContent> all;
    for (const FileInMemory& file : files) {
        ReceivedContent& found = all.emplace_back(ReceivedContent{.file = file.path});
        std::string_view text = file.bytes;
        if (nextLine(text) != "QGC WPL 110") {
            found.faults.push_back(badLine(1));
            continue;
        }
        ReceivedNumbers rows;
        ReceivedPath path;
        for (std::size_t number = 2; !text.empty(); ++number) {
            const std::vector<std::string_view> cells = cellsOf(nextLine(text), '\t');
            std::vector<double> values;
            for (const std::string_view cell : cells) {
                if (const auto value = decimalIn(cell)) {
                    values.push_back(*value);
                }
            }
            constexpr std::size_t kColumns = 12;
            const bool isHome = number == 2;
            const bool good = cells.size() == kColumns && values.size() == kColumns &&
                              values[1] == (isHome ? 1.0 : 0.0) &&
                              values[2] == (isHome ? kAbsolute : kRelative) &&
                              std::ranges::contains(kCommands, static_cast<std::int64_t>(values[3]));
            if (!good) {
                found.faults.push_back(badLine(number));
                break;
            }
            rows.numbers.push_back(static_cast<std::int64_t>(values[0]));
            const GeoPoint place{values[9], values[8]};
            if (isHome) {
                found.points.push_back(place);
            } else if (static_cast<std::int64_t>(values[3]) == kWaypointItem) {
                path.samples.push_back({.geo = place});
            }
        }
        found.orders.push_back(std::move(rows));
        found.paths.push_back(std::move(path));
    }
    return all;
}

std::vector<ReceivedContent> findGroundStationPlan(std::span<const FileInMemory> files, const ExportJob&) {
    std::vector<ReceivedContent> all;
    for (const FileInMemory& file : files) {
        ReceivedContent& found = all.emplace_back(ReceivedContent{.file = file.path, .repeatsFirst = false});
        const json document = jsonOrDiscarded<json>(file.bytes);
        if (document.is_discarded() || textOf(memberOf(document, "fileType")) != "Plan") {
            found.faults.push_back(isNot("QGroundControl plan"));
            continue;
        }
        addMission(memberOf(document, "mission"), found);
        addFences(memberOf(memberOf(document, "geoFence"), "polygons"), found);
    }
    return all;
}

}  // namespace furrow
