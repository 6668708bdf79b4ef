#include "planner/io/formats/isoxml/isoxml.h"

#include "planner/core/text.h"
#include "planner/geodesy/local_frame.h"

#include <pugixml.hpp>

#include <algorithm>
#include <format>
#include <limits>
#include <numbers>
#include <set>
#include <utility>

namespace furrow {

namespace {

constexpr std::size_t kLongestName = 32;
constexpr std::size_t kMostDecimals = 9;
constexpr std::string_view kNotKnown = "{} is not known before version 4";

class TaskDataContent {
public:
    TaskDataContent(const ExportJob& job, std::span<const FileInMemory> files) : job_{job}, files_{files} {}

    ReceivedContent of(const FileInMemory& file) {
        found_.file = file.path;
        pugi::xml_document document;
        if (!document.load_buffer(file.bytes.data(), file.bytes.size())) {
            found_.faults.push_back(isNot("XML"));
            return std::move(found_);
        }
        const pugi::xml_node root = document.child("ISO11783_TaskData");
        if (!root) {
            found_.faults.push_back(isNot("ISO11783_TaskData"));
            return std::move(found_);
        }
        isV4_ = std::string_view{root.attribute("VersionMajor").value()} == "4";
        checkIds(root);
        ReceivedNames fields = list();
        std::size_t number = 0;
        for (const pugi::xml_node field : root.children("PFD")) {
            fields.names.emplace_back(field.attribute("C").value());
            addField(field, number);
            ++number;
        }
        found_.names.push_back(std::move(fields));
        if (number != job_.fields.size()) {
            found_.faults.push_back(message("{} fields are in it, not {}", number, job_.fields.size()));
        }
        checkLinks(root, file.path);
        return std::move(found_);
    }

private:
    template <class... Values>
    void fault(std::string_view pattern, const Values&... values) {
        found_.faults.push_back(message(pattern, values...));
    }

    ReceivedNames list() const {
        const auto longest = static_cast<std::size_t>(std::max(job_.options.longestName, 8));
        return {.names = {}, .longest = std::min(kLongestName, longest), .ascii = job_.options.asciiNames};
    }

    void checkIds(pugi::xml_node root) {
        std::set<std::string> ids;
        for (const char* path :
             {"//CTR/@A", "//FRM/@A", "//PFD/@A", "//GGP/@A", "//GPN/@A", "//TSK/@A", "//LGP/@A"}) {
            for (const pugi::xpath_node& each : root.select_nodes(path)) {
                const std::string id = each.attribute().value();
                if (!ids.insert(id).second) {
                    fault("the id {} is there twice", id);
                }
            }
        }
        for (const char* path :
             {"//PFD/@E", "//PFD/@F", "//FRM/@I", "//GAN/@A", "//TSK/@C", "//TSK/@D", "//TSK/@E"}) {
            for (const pugi::xpath_node& each : root.select_nodes(path)) {
                if (!ids.contains(each.attribute().value())) {
                    fault("{} is referred to and not there", each.attribute().value());
                }
            }
        }
    }

    /// The list of links beside it is named in it, and links each field once, to something else each time.
    void checkLinks(pugi::xml_node root, const std::string& path) {
        const std::string listPath =
            path.substr(0, path.size() - std::string_view{"TASKDATA.XML"}.size()) + "LINKLIST.XML";
        const auto list = std::ranges::find(files_, listPath, &FileInMemory::path);
        const bool isNamed = std::ranges::any_of(root.children("AFE"), [](pugi::xml_node file) {
            return std::string_view{file.attribute("A").value()} == "LINKLIST.XML";
        });
        if (isNamed != (list != files_.end())) {
            found_.faults.push_back(isMissing(isNamed ? listPath : "AFE"));
        }
        if (list == files_.end()) {
            return;
        }
        if (!isV4_) {
            fault(kNotKnown, "LINKLIST.XML");
        }
        std::set<std::string> fields;
        for (const pugi::xml_node field : root.children("PFD")) {
            fields.insert(field.attribute("A").value());
        }
        pugi::xml_document document;
        std::set<std::string> used;
        document.load_buffer(list->bytes.data(), list->bytes.size());
        for (const pugi::xpath_node& each : document.select_nodes("/ISO11783LinkList/LGP/LNK")) {
            const std::string target = each.node().attribute("A").value();
            if (fields.erase(target) == 0) {
                fault("{} is referred to and not there", target);
            }
            if (!used.insert(each.node().attribute("B").value()).second) {
                fault("the id {} is there twice", each.node().attribute("B").value());
            }
        }
        if (!fields.empty()) {
            found_.faults.push_back(isMissing("LNK " + *fields.begin()));
        }
    }

    /// A plain decimal with at most nine digits behind the point; not a number for anything else.
    static double degrees(std::string_view text) {
        const std::size_t point = text.find('.');
        const bool plain = text.find_first_not_of("-0123456789.") == std::string_view::npos &&
                           (point == std::string_view::npos || text.size() - point - 1 <= kMostDecimals);
        return plain ? decimalIn(text).value_or(std::numeric_limits<double>::quiet_NaN())
                     : std::numeric_limits<double>::quiet_NaN();
    }

    GeoRing pointsOf(pugi::xml_node line) {
        GeoRing points;
        for (const pugi::xml_node node : line.children("PNT")) {
            points.push_back({degrees(node.attribute("D").value()), degrees(node.attribute("C").value())});
        }
        return points;
    }

    void addArea(pugi::xml_node node) {
        const std::string_view type = node.attribute("A").value();
        ReceivedArea area{.kind = type == "1"   ? ReceivedArea::Kind::Field
                                  : type == "6" ? ReceivedArea::Kind::Obstacle
                                                : ReceivedArea::Kind::Other,
                          .name = node.attribute("B").value(),
                          .rings = {},
                          .statedM2 = node.attribute("C").as_double()};
        if (!isV4_ && node.attribute("A").as_int() > 8) {
            fault(kNotKnown, std::format("PLN A={}", type));
        }
        for (const pugi::xml_node line : node.children("LSG")) {
            const std::string_view ring = line.attribute("A").value();
            if (ring == "1" && area.rings.outer.empty()) {
                area.rings.outer = pointsOf(line);
            } else if (ring == "2") {
                area.rings.holes.push_back(pointsOf(line));
            } else {
                fault("'{}' holds a line of kind {}", area.name, ring);
            }
        }
        found_.areas.push_back(std::move(area));
    }

    static std::optional<double> widthM(pugi::xml_node line) {
        const pugi::xml_attribute width = line.attribute("C");
        return width ? std::optional{width.as_double() / 1000.0} : std::nullopt;
    }

    void addPattern(pugi::xml_node pattern) {
        const std::string name = pattern.attribute("B").value();
        const std::string_view kind = pattern.attribute("C").value();
        int lines = 0;
        for (const pugi::xml_node line : pattern.children("LSG")) {
            ++lines;
            std::string kinds;
            for (const pugi::xml_node point : line.children("PNT")) {
                kinds += point.attribute("A").value();
            }
            const auto isCurve = [&kinds] {
                return kinds.size() >= 2 && kinds.starts_with('6') && kinds.ends_with('7') &&
                       kinds.find_first_not_of('9', 1) == kinds.size() - 1;
            };
            const bool right = kind == "1"   ? kinds == "67"
                               : kind == "2" ? kinds == "6" && !pattern.attribute("G").empty()
                               : kind == "3" ? isCurve()
                               : kind == "4"
                                   ? (kinds == "8" && !pattern.attribute("H").empty()) || kinds == "867"
                                   : false;
            if (!right) {
                fault("'{}' is of kind {} and its points are of kinds {}", name, kind, kinds.substr(0, 20));
            }
            found_.lines.push_back({.name = name,
                                    .points = pointsOf(line),
                                    .widthM = widthM(line),
                                    .fewestPoints = kind == "2" || kind == "4" ? 1U : 2U});
        }
        if (lines != 1) {
            fault("'{}' has {} lines", name, lines);
        }
    }

    void addField(pugi::xml_node field, std::size_t number) {
        ReceivedNames areas = list();
        ReceivedNames lines = list();
        ReceivedNames patterns = list();
        const std::size_t before = found_.areas.size();
        for (const pugi::xml_node polygon : field.children("PLN")) {
            areas.names.emplace_back(polygon.attribute("B").value());
            addArea(polygon);
        }
        checkArea(field, before, number);
        for (const pugi::xml_node point : field.children("PNT")) {
            found_.points.push_back(
                {degrees(point.attribute("D").value()), degrees(point.attribute("C").value())});
        }
        for (const pugi::xml_node line : field.children("LSG")) {
            lines.names.emplace_back(line.attribute("B").value());
            found_.lines.push_back(
                {.name = lines.names.back(), .points = pointsOf(line), .widthM = widthM(line)});
        }
        for (const pugi::xml_node group : field.children("GGP")) {
            if (!isV4_) {
                fault(kNotKnown, "GGP");
            }
            for (const pugi::xml_node pattern : group.children("GPN")) {
                patterns.names.emplace_back(pattern.attribute("B").value());
                addPattern(pattern);
            }
        }
        for (ReceivedNames* each : {&areas, &lines, &patterns}) {
            found_.names.push_back(std::move(*each));
        }
    }

    /// What is left free round the obstacles of a field, at most: they stand in the file without it.
    double buffersM2(std::size_t field) const {
        double sum = 0.0;
        if (field >= job_.fields.size()) {
            return sum;
        }
        for (const Obstacle& obstacle : job_.fields[field].field.obstacles) {
            const double bufferM = obstacle.buffer.si();
            const auto frame = LocalFrame::centredOn(obstacle.outline.outer.front());
            if (bufferM <= 0.0 || !frame) {
                continue;
            }
            Point before = frame->toLocal(obstacle.outline.outer.back());
            for (const GeoPoint& corner : obstacle.outline.outer) {
                const Point here = frame->toLocal(corner);
                sum += distance(before, here) * bufferM;
                before = here;
            }
            sum += std::numbers::pi * bufferM * bufferM;
        }
        return sum;
    }

    /// The field's area is that of its parts, or less by what lies in them.
    void checkArea(pugi::xml_node field, std::size_t firstArea, std::size_t number) {
        double most = 0.0;
        double inside = buffersM2(number);
        for (std::size_t i = firstArea; i < found_.areas.size(); ++i) {
            const ReceivedArea& area = found_.areas[i];
            const bool isHeadland =
                area.kind == ReceivedArea::Kind::Other && area.name.starts_with("Headland");
            (area.kind == ReceivedArea::Kind::Field ? most : inside) +=
                isHeadland ? 0.0 : area.statedM2.value_or(0.0);
        }
        const double stated = field.attribute("D").as_double();
        constexpr double kShare = 0.005;
        if (stated > (1.0 + kShare) * most + 6.0 || stated < most - inside - kShare * most - 6.0) {
            fault("'{}' is said to have {:.0f} m², and has {:.0f} m²", field.attribute("C").value(), stated,
                  most);
        }
    }

    const ExportJob& job_;
    std::span<const FileInMemory> files_;
    ReceivedContent found_;
    bool isV4_ = true;
};

}  // namespace

std::vector<ReceivedContent> findIsoxml(std::span<const FileInMemory> files, const ExportJob& job) {
    std::vector<ReceivedContent> all;
    for (const FileInMemory& file : files) {
        if (file.path.ends_with("TASKDATA.XML")) {
            all.push_back(TaskDataContent{job, files}.of(file));
        }
    }
    if (all.empty()) {
        all.push_back({.file = "TASKDATA.XML"});
        all.back().faults.push_back(isMissing("TASKDATA.XML"));
    }
    return all;
}

}  // namespace furrow
