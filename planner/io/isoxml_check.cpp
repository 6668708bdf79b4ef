#include "planner/io/isoxml_check.h"

#include "planner/geodesy/local_frame.h"
#include "planner/geometry/geos_bridge.h"
#include "planner/io/geo_ring.h"

#include <pugixml.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <format>
#include <optional>
#include <set>
#include <utility>

namespace furrow {

namespace {

constexpr std::size_t kLongestName = 32;
constexpr double kAreaShare = 0.005;
// Rounding to whole square metres counts on small areas.
constexpr double kAreaSlackM2 = 1.0;
constexpr double kFarM = 10'000.0;

std::size_t characters(std::string_view text) {
    return static_cast<std::size_t>(
        std::ranges::count_if(text, [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0) != 0x80; }));
}

/// A plain decimal with at most nine digits behind the point.
std::optional<double> plainDecimal(std::string_view text) {
    const std::size_t point = text.find('.');
    const bool plain = !text.empty() && text.find_first_not_of("-0123456789.") == std::string_view::npos &&
                       (point == std::string_view::npos || text.size() - point - 1 <= 9);
    double number = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return plain && error == std::errc{} && end == text.data() + text.size() ? std::optional{number}
                                                                             : std::nullopt;
}

class TaskDataCheck {
public:
    explicit TaskDataCheck(std::span<const FieldContent> meant) : meant_{meant} {}

    std::vector<std::string> run(std::string_view xml) {
        pugi::xml_document document;
        if (!document.load_buffer(xml.data(), xml.size())) {
            return {"it is no XML"};
        }
        const pugi::xml_node root = document.child("ISO11783_TaskData");
        if (!root) {
            return {"it is no task data"};
        }
        isV4_ = std::string_view{root.attribute("VersionMajor").value()} == "4";
        collectIds(root);
        std::set<std::string> fieldNames;
        int fields = 0;
        for (const pugi::xml_node field : root.children("PFD")) {
            checkName(field.attribute("C"), fieldNames);
            checkField(field);
            ++fields;
        }
        if (std::cmp_not_equal(fields, meant_.size())) {
            tell("{} fields are in it, not {}", fields, meant_.size());
        }
        return std::move(problems_);
    }

private:
    template <class... Values>
    void tell(std::format_string<Values...> text, Values&&... values) {
        problems_.push_back(std::format(text, std::forward<Values>(values)...));
    }

    void collectIds(pugi::xml_node root) {
        std::set<std::string> ids;
        for (const char* path : {"//CTR/@A", "//FRM/@A", "//PFD/@A", "//GGP/@A", "//GPN/@A"}) {
            for (const pugi::xpath_node& found : root.select_nodes(path)) {
                const std::string id = found.attribute().value();
                if (!ids.insert(id).second) {
                    tell("the id {} is there twice", id);
                }
            }
        }
        for (const char* path : {"//PFD/@E", "//PFD/@F", "//FRM/@I", "//GAN/@A"}) {
            for (const pugi::xpath_node& found : root.select_nodes(path)) {
                if (!ids.contains(found.attribute().value())) {
                    tell("{} is referred to and not there", found.attribute().value());
                }
            }
        }
    }

    void checkName(pugi::xml_attribute attribute, std::set<std::string>& used) {
        const std::string name = attribute.value();
        if (characters(name) > kLongestName) {
            tell("the name '{}' is longer than {} characters", name, kLongestName);
        }
        if (!name.empty() && !used.insert(name).second) {
            tell("the name '{}' is there twice", name);
        }
    }

    std::optional<GeoPoint> pointOf(pugi::xml_node node) {
        const std::string_view latText = node.attribute("C").value();
        const std::string_view lonText = node.attribute("D").value();
        const auto lat = plainDecimal(latText);
        const auto lon = plainDecimal(lonText);
        if (!lat || !lon || std::abs(*lat) > 90.0 || std::abs(*lon) > 180.0) {
            tell("'{}', '{}' is no latitude and longitude", latText, lonText);
            return std::nullopt;
        }
        const GeoPoint point{*lon, *lat};
        const bool isNear = std::ranges::any_of(meant_, [point](const FieldContent& content) {
            return std::ranges::any_of(content.field.parts, [point](const GeoPolygon& part) {
                return std::ranges::any_of(
                    part.outer, [point](GeoPoint vertex) { return roughDistanceM(vertex, point) < kFarM; });
            });
        });
        if (!isNear) {
            tell("{:.6f}, {:.6f} is far from the field", point.lonDeg, point.latDeg);
            return std::nullopt;
        }
        return point;
    }

    std::vector<GeoPoint> pointsOf(pugi::xml_node line) {
        std::vector<GeoPoint> points;
        for (const pugi::xml_node node : line.children("PNT")) {
            if (const auto point = pointOf(node)) {
                points.push_back(*point);
            } else {
                break;  // one word about a line is enough
            }
        }
        return points;
    }

    /// Empty where it is no ring.
    GeoRing ringOf(pugi::xml_node line, const std::string& name) {
        GeoRing ring = pointsOf(line);
        if (ring.size() < 4) {
            tell("a ring of '{}' has fewer than three corners", name);
            return {};
        }
        if (ring.front() != ring.back()) {
            tell("a ring of '{}' does not end where it begins", name);
            return {};
        }
        ring.pop_back();
        return ring;
    }

    Area checkPolygon(pugi::xml_node node) {
        const std::string name = node.attribute("B").value();
        GeoPolygon polygon;
        for (const pugi::xml_node line : node.children("LSG")) {
            const std::string_view type = line.attribute("A").value();
            GeoRing ring = ringOf(line, name);
            if (type == "1" && polygon.outer.empty()) {
                polygon.outer = std::move(ring);
            } else if (type == "2") {
                polygon.holes.push_back(std::move(ring));
            } else {
                tell("'{}' holds a line of kind {}", name, type);
            }
        }
        const bool incomplete =
            polygon.outer.empty() || std::ranges::any_of(polygon.holes, [](const GeoRing& hole) { return hole.empty(); });
        if (incomplete) {
            tell("'{}' is no polygon", name);
            return {};
        }
        const auto frame = LocalFrame::centredOn(polygon.outer.front());
        const auto invalid = findInvalidPlace({frame->toLocal(polygon)}, {});
        if (!invalid || *invalid) {
            tell("'{}' crosses itself, or a hole lies outside of it", name);
        }
        const Area measured = geodesicArea(polygon);
        const double stated = node.attribute("C").as_double();
        if (std::abs(stated - measured.si()) > kAreaSlackM2 + kAreaShare * measured.si()) {
            tell("'{}' is said to have {} m² and has {:.0f}", name, stated, measured.si());
        }
        return measured;
    }

    void checkPattern(pugi::xml_node pattern) {
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
                               : kind == "4" ? (kinds == "8" && !pattern.attribute("H").empty()) || kinds == "867"
                                             : false;
            if (!right) {
                tell("'{}' is of kind {} and its points are of kinds {}", name, kind, kinds);
            }
            const GeoRing points = pointsOf(line);
            if (kind == "1" && points.size() == 2 && roughDistanceM(points[0], points[1]) < 0.5) {
                tell("A and B of '{}' are the same place", name);
            }
        }
        if (lines != 1) {
            tell("'{}' has {} lines", name, lines);
        }
    }

    void checkField(pugi::xml_node field) {
        std::set<std::string> polygonNames;
        std::set<std::string> lineNames;
        std::set<std::string> patternNames;
        Area most;
        Area least;
        for (const pugi::xml_node polygon : field.children("PLN")) {
            checkName(polygon.attribute("B"), polygonNames);
            const Area measured = checkPolygon(polygon);
            const std::string_view type = polygon.attribute("A").value();
            if (type == "1") {
                most += measured;
                least += measured;
            } else if (type != "10") {
                least = least - measured;
            }
        }
        const double stated = field.attribute("D").as_double();
        if (stated > (1.0 + kAreaShare) * most.si() + kAreaSlackM2 ||
            stated < least.si() - kAreaShare * most.si() - kAreaSlackM2) {
            tell("the field is said to have {:.0f} m², and its outline has {:.0f}", stated, most.si());
        }
        for (const pugi::xml_node point : field.children("PNT")) {
            pointOf(point);
        }
        for (const pugi::xml_node line : field.children("LSG")) {
            checkName(line.attribute("B"), lineNames);
            if (pointsOf(line).size() < 2) {
                tell("the line '{}' has fewer than two points", line.attribute("B").value());
            }
        }
        for (const pugi::xml_node group : field.children("GGP")) {
            if (!isV4_) {
                tell("guidance groups are not known before version 4");
            }
            for (const pugi::xml_node pattern : group.children("GPN")) {
                checkName(pattern.attribute("B"), patternNames);
                checkPattern(pattern);
            }
        }
    }

    std::span<const FieldContent> meant_;
    bool isV4_ = true;
    std::vector<std::string> problems_;
};

}  // namespace

std::vector<std::string> isoxmlProblems(std::string_view xml, std::span<const FieldContent> meant) {
    return TaskDataCheck{meant}.run(xml);
}

}  // namespace furrow
