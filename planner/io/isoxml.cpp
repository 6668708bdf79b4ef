#include "planner/io/isoxml.h"

#include "planner/swaths/curve_parts.h"
#include "planner/units/angle.h"

#include <pugixml.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <format>
#include <limits>
#include <numbers>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>
#include <vector>

namespace furrow {

namespace {

// ISO 11783-10 names everything by letters; the values used here.
constexpr const char* kFieldBoundary = "1";
constexpr const char* kObstacle = "6";
constexpr const char* kOtherArea = "8";
constexpr const char* kOuterRing = "1";
constexpr const char* kInnerRing = "2";
constexpr const char* kGuidanceLine = "5";
constexpr const char* kRingPoint = "2";
constexpr const char* kFieldAccess = "3";
constexpr const char* kReferenceA = "6";
constexpr const char* kReferenceB = "7";
constexpr const char* kReferenceCentre = "8";
constexpr const char* kGuidancePoint = "9";
constexpr const char* kAbLine = "1";
constexpr const char* kCurve = "3";
constexpr const char* kPivot = "4";
constexpr const char* kFullCircle = "3";
constexpr const char* kBothSides = "1";
constexpr const char* kNoSides = "4";
constexpr const char* kBothEnds = "1";
constexpr const char* kMadeOnDesktop = "16";

constexpr std::size_t kLongestName = 32;

// Lines whose directions differ by less than this (1 cm over 100 m) are one direction to a terminal.
constexpr double kSameDirectionRad = 1e-4;

// Curves are written as chords that stay this close to them,
constexpr Length kGuideChord = metres(0.02);
// and stand for those beside them, which may be off by so much.
constexpr double kBesideM = 0.15;
constexpr Length kDrawnOut = metres(5000.0);
// A line is compared with a guide at so many places.
constexpr double kAsked = 100.0;

/// How many bytes the character at the front takes; 0 where these bytes are not UTF-8.
std::size_t characterBytes(std::string_view text) {
    const auto byte = [&text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char lead = byte(0);
    const std::size_t count = lead < 0x80                   ? 1
                              : lead >= 0xC2 && lead < 0xE0 ? 2
                              : lead >= 0xE0 && lead < 0xF0 ? 3
                              : lead >= 0xF0 && lead < 0xF5 ? 4
                                                            : 0;
    if (count == 0 || text.size() < count) {
        return 0;
    }
    for (std::size_t i = 1; i < count; ++i) {
        if ((byte(i) & 0xC0) != 0x80) {
            return 0;
        }
    }
    // Forms that say the same with too many bytes, halves of pairs, beyond the last character.
    if ((lead == 0xE0 && byte(1) < 0xA0) || (lead == 0xED && byte(1) >= 0xA0) ||
        (lead == 0xF0 && byte(1) < 0x90) || (lead == 0xF4 && byte(1) >= 0x90)) {
        return 0;
    }
    return count;
}

/// The first `longest` characters, without what XML cannot hold.
std::string cut(std::string_view text, std::size_t longest) {
    std::string kept;
    for (std::size_t characters = 0; !text.empty() && characters < longest;) {
        const std::size_t bytes = characterBytes(text);
        const std::string_view character = text.substr(0, std::max<std::size_t>(bytes, 1));
        text.remove_prefix(character.size());
        const bool isControl =
            bytes == 1 && (static_cast<unsigned char>(character[0]) < 0x20 || character[0] == 0x7F);
        const bool isNoCharacter = character == "\xEF\xBF\xBE" || character == "\xEF\xBF\xBF";
        if (isControl || isNoCharacter) {
            continue;
        }
        kept += bytes == 0 ? std::string_view{"?"} : character;
        ++characters;
    }
    while (kept.ends_with(' ')) {
        kept.pop_back();
    }
    return kept;
}

/// Names of one list, unequal even after they were cut.
class Names {
public:
    std::string unique(std::string_view wanted, std::string_view otherwise) {
        std::string name = cut(wanted, kLongestName);
        if (name.empty()) {
            name = otherwise;
        }
        std::string tried = name;
        for (int number = 2; !used_.insert(tried).second; ++number) {
            const std::string suffix = std::format(" {}", number);
            tried = cut(name, kLongestName - suffix.size()) + suffix;
        }
        return tried;
    }

private:
    std::set<std::string> used_;
};

void addPoint(pugi::xml_node parent, const char* type, GeoPoint point) {
    pugi::xml_node node = parent.append_child("PNT");
    node.append_attribute("A") = type;
    node.append_attribute("C") = std::format("{:.9f}", point.latDeg).c_str();
    node.append_attribute("D") = std::format("{:.9f}", point.lonDeg).c_str();
}

bool isCounterClockwise(const GeoRing& ring) {
    double twiceArea = 0.0;
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
        const double fromLon = std::remainder(ring[j].lonDeg - ring[0].lonDeg, 360.0);
        const double toLon = std::remainder(ring[i].lonDeg - ring[0].lonDeg, 360.0);
        twiceArea += fromLon * (ring[i].latDeg - ring[0].latDeg) - toLon * (ring[j].latDeg - ring[0].latDeg);
    }
    return twiceArea > 0.0;
}

void addRing(pugi::xml_node polygon, const char* type, const GeoRing& ring, bool counterClockwise) {
    if (ring.empty()) {
        return;
    }
    pugi::xml_node line = polygon.append_child("LSG");
    line.append_attribute("A") = type;
    const auto add = [line](const GeoPoint& point) { addPoint(line, kRingPoint, point); };
    if (isCounterClockwise(ring) == counterClockwise) {
        std::ranges::for_each(ring, add);
        add(ring.front());
    } else {
        add(ring.front());
        std::for_each(ring.rbegin(), ring.rend(), add);
    }
}

std::string wholeNumber(double value) {
    return std::format("{}", std::llround(value));
}

void addPolygon(pugi::xml_node field, const char* type, const std::string& name, const GeoPolygon& polygon) {
    pugi::xml_node node = field.append_child("PLN");
    node.append_attribute("A") = type;
    node.append_attribute("B") = name.c_str();
    node.append_attribute("C") = wholeNumber(geodesicArea(polygon).si()).c_str();
    addRing(node, kOuterRing, polygon.outer, true);
    for (const GeoRing& hole : polygon.holes) {
        addRing(node, kInnerRing, hole, false);
    }
}

double directionRad(const Swath& swath) {
    const Point along = swath.end - swath.start;
    return normalisedSwathHeading(radians(std::atan2(along.y, along.x))).si();
}

/// A swath in its own direction is straight, too.
bool isBent(const Swath& swath) {
    return sharpestBend(swath.curve) > Curvature{};
}

/// For each direction the longest swath of its first track, in the order in which directions first come.
std::vector<const Swath*> straightGuides(const SwathSet& set) {
    std::vector<const Swath*> chosen;
    for (const Swath& swath : set.swaths) {
        if (swath.isCurved()) {
            continue;
        }
        const double direction = directionRad(swath);
        const auto same = std::ranges::find_if(chosen, [direction](const Swath* other) {
            return std::abs(std::remainder(directionRad(*other) - direction, std::numbers::pi)) <
                   kSameDirectionRad;
        });
        if (same == chosen.end()) {
            chosen.push_back(&swath);
        } else if (swath.track == (*same)->track && swath.length() > (*same)->length()) {
            *same = &swath;
        }
    }
    return chosen;
}

double toLineM(Point point, const Polyline& line) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const Point way = line[i + 1] - line[i];
        const double share = std::clamp(dot(point - line[i], way) / std::max(dot(way, way), 1e-12), 0.0, 1.0);
        nearest = std::min(nearest, distance(point, line[i] + share * way));
    }
    return nearest;
}

/// Evenly along a line: bends have more points than straights.
std::vector<Point> evenly(const Polyline& line) {
    const double stepM = lengthM(line) / kAsked;
    std::vector<Point> points;
    double nextM = 0.5 * stepM;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const double edgeM = distance(line[i], line[i + 1]);
        for (; nextM <= edgeM; nextM += stepM) {
            points.push_back(line[i] + (nextM / edgeM) * (line[i + 1] - line[i]));
        }
        nextM -= edgeM;
    }
    return points;
}

/// Whether a terminal that moves the guide beside itself gets the line, but for what is rounded.
bool isBeside(const Polyline& line, const Polyline& guide) {
    std::vector<double> distances;
    for (const Point& point : evenly(line)) {
        distances.push_back(toLineM(point, guide));
    }
    std::ranges::sort(distances);
    const std::size_t rounded = distances.size() / 4;
    return distances.empty() || distances[distances.size() - 1 - rounded] - distances.front() < kBesideM;
}

/// Of lines of their own that lie beside each other the one that was given, or the longest; rings are one pivot, which the outermost stands for.
std::vector<const Swath*> curvedGuides(const SwathSet& set) {
    std::vector<const Swath*> longest;
    for (const Swath& swath : set.swaths) {
        if (swath.isCurved()) {
            longest.push_back(&swath);
        }
    }
    // The line that was given before its parallels, which may have lost a bend that it has.
    std::ranges::stable_sort(longest, [](const Swath* a, const Swath* b) {
        const auto stepsOf = [](const Swath& swath) { return swath.lane ? std::abs(*swath.lane) : std::numeric_limits<int>::max(); };
        // A straight end of a curve's parallel is no guide of its own.
        if (isBent(*a) != isBent(*b)) {
            return isBent(*a);
        }
        return stepsOf(*a) != stepsOf(*b) ? stepsOf(*a) < stepsOf(*b) : a->length() > b->length();
    });
    std::vector<const Swath*> chosen;
    std::vector<Polyline> lines;
    for (const Swath* swath : longest) {
        const Polyline line = middleLine(*swath, kGuideChord);
        if (std::ranges::none_of(lines, [&](const Polyline& guide) { return isBeside(line, guide); })) {
            chosen.push_back(swath);
            // Terminals draw curves out at both ends.
            lines.push_back(swath->isClosed() ? line
                                              : middleLine({.curve = extended(swath->curve, kDrawnOut, kDrawnOut)}, kGuideChord));
        }
    }
    return chosen;
}

/// Writes guidance patterns, each in a group of its own: there are terminals that take the first line of a group only.
class GuidanceWriter {
public:
    GuidanceWriter(pugi::xml_node field, const Plan& plan)
        : field_{field}, frame_{plan.field().frame()}, widthM_{plan.request.machine.operatingWidth().si()} {}

    /// @param lasting  a line that stays where it is: nothing is laid beside it
    void add(const Swath& swath, const std::string& name, bool lasting) {
        if (!isBent(swath)) {
            addLine(swath, name, lasting);
        } else if (swath.isClosed()) {
            addRing(swath, name, lasting);
        } else {
            addCurve(swath, name, lasting);
        }
    }

    static std::string nameOf(const Swath& swath, std::size_t number) {
        if (!isBent(swath)) {
            return std::format("AB {:.1f}", bearingDeg(swath));
        }
        return std::format("{} {}", swath.isClosed() ? "Pivot" : "Curve", number);
    }

private:
    /// From A to B, so in the full circle; what is rounded up to 360 is north again.
    static double bearingDeg(const Swath& swath) {
        const Point along = swath.end - swath.start;
        const double eastDeg = inDegrees(radians(std::atan2(along.y, along.x)));
        return std::fmod(std::round((450.0 - eastDeg) * 1e4) / 1e4, 360.0);
    }

    pugi::xml_node addPattern(const std::string& given, const char* type, bool lasting) {
        ++number_;
        const std::string name = names_.unique(given, "AB");
        pugi::xml_node group = field_.append_child("GGP");
        group.append_attribute("A") = std::format("GGP{}", number_).c_str();
        group.append_attribute("B") = name.c_str();
        pugi::xml_node pattern = group.append_child("GPN");
        pattern.append_attribute("A") = std::format("GPN{}", number_).c_str();
        pattern.append_attribute("B") = name.c_str();
        pattern.append_attribute("C") = type;
        name_ = name;
        lasting_ = lasting;
        return pattern;
    }

    void addExtensions(pugi::xml_node pattern) const {
        pattern.append_attribute("E") = lasting_ ? kNoSides : kBothSides;
        pattern.append_attribute("F") = kBothEnds;
    }

    pugi::xml_node addLineString(pugi::xml_node pattern) const {
        pugi::xml_node line = pattern.append_child("LSG");
        line.append_attribute("A") = kGuidanceLine;
        line.append_attribute("B") = name_.c_str();
        line.append_attribute("C") = wholeNumber(widthM_ * 1000.0).c_str();
        return line;
    }

    void addLine(const Swath& swath, const std::string& name, bool lasting) {
        pugi::xml_node pattern = addPattern(name, kAbLine, lasting);
        addExtensions(pattern);
        pattern.append_attribute("G") = std::format("{:.4f}", bearingDeg(swath)).c_str();
        pattern.append_attribute("I") = kMadeOnDesktop;
        pugi::xml_node line = addLineString(pattern);
        addPoint(line, kReferenceA, frame_.toGeo(swath.start));
        addPoint(line, kReferenceB, frame_.toGeo(swath.end));
    }

    void addCurve(const Swath& swath, const std::string& name, bool lasting) {
        pugi::xml_node pattern = addPattern(name, kCurve, lasting);
        addExtensions(pattern);
        pattern.append_attribute("I") = kMadeOnDesktop;
        pugi::xml_node line = addLineString(pattern);
        const Polyline points = middleLine(swath, kGuideChord);
        for (std::size_t i = 0; i < points.size(); ++i) {
            addPoint(line, i == 0 ? kReferenceA : i + 1 == points.size() ? kReferenceB : kGuidancePoint,
                     frame_.toGeo(points[i]));
        }
    }

    void addRing(const Swath& swath, const std::string& name, bool lasting) {
        const double radiusM = 1.0 / swath.curve.pieces.front().curvature.si();
        const Point ahead = direction(swath.curve.start.heading.si());
        const Point centre = swath.start + radiusM * Point{-ahead.y, ahead.x};
        pugi::xml_node pattern = addPattern(name, kPivot, lasting);
        pattern.append_attribute("D") = kFullCircle;
        addExtensions(pattern);
        pattern.append_attribute("H") = wholeNumber(std::abs(radiusM) * 1000.0).c_str();
        pattern.append_attribute("I") = kMadeOnDesktop;
        pugi::xml_node line = addLineString(pattern);
        addPoint(line, kReferenceCentre, frame_.toGeo(centre));
    }

    pugi::xml_node field_;
    const LocalFrame& frame_;
    double widthM_;
    Names names_;
    int number_ = 0;
    std::string name_;
    bool lasting_ = false;
};

/// One line for each direction and each curve, which terminals lay the others beside, and every tramline.
void addGuidance(pugi::xml_node field, const Plan& plan) {
    GuidanceWriter writer{field, plan};
    for (const auto& guides : {straightGuides(plan.swaths), curvedGuides(plan.swaths)}) {
        for (std::size_t i = 0; i < guides.size(); ++i) {
            writer.add(*guides[i], GuidanceWriter::nameOf(*guides[i], i + 1), false);
        }
    }
    int tramline = 0;
    for (const Swath& swath : plan.swaths.swaths) {
        if (swath.tramline) {
            writer.add(swath, std::format("Tramline {}", ++tramline), true);
        }
    }
}

}  // namespace

std::string isoxmlTaskData(const Plan& plan) {
    const Field& field = plan.field();
    const FieldSource& source = field.source();

    pugi::xml_document document;
    pugi::xml_node declaration = document.append_child(pugi::node_declaration);
    declaration.append_attribute("version") = "1.0";
    declaration.append_attribute("encoding") = "UTF-8";
    pugi::xml_node root = document.append_child("ISO11783_TaskData");
    root.append_attribute("VersionMajor") = "4";
    root.append_attribute("VersionMinor") = "3";
    root.append_attribute("ManagementSoftwareManufacturer") = "Furrow";
    root.append_attribute("ManagementSoftwareVersion") = FURROW_VERSION;
    root.append_attribute("DataTransferOrigin") = "1";

    Names names;
    const std::string fieldName = names.unique(field.name(), "Field");
    pugi::xml_node node = root.append_child("PFD");
    node.append_attribute("A") = "PFD1";
    node.append_attribute("C") = fieldName.c_str();
    node.append_attribute("D") = wholeNumber(field.area().si()).c_str();
    for (std::size_t i = 0; i < source.parts.size(); ++i) {
        // The first part is called like the field.
        const std::string name = i == 0 ? fieldName : names.unique(field.name(), "Field");
        addPolygon(node, kFieldBoundary, name, source.parts[i]);
    }
    for (const Obstacle& obstacle : source.obstacles) {
        const std::string name = names.unique(obstacle.name, "Obstacle");
        addPolygon(node, obstacle.passable ? kOtherArea : kObstacle, name, obstacle.outline);
    }
    for (const Gate& gate : source.gates) {
        addPoint(node, kFieldAccess, gate.position);
        node.last_child().append_attribute("B") = names.unique(gate.name, "Gate").c_str();
    }
    addGuidance(node, plan);

    std::ostringstream text;
    document.save(text, "  ", pugi::format_default, pugi::encoding_utf8);
    return text.str();
}

}  // namespace furrow
