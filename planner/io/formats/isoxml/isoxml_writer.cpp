#include "planner/io/formats/isoxml/isoxml_writer.h"

#include "planner/geodesy/local_frame.h"
#include "planner/io/content/geo_ring.h"
#include "planner/io/content/plan_content.h"
#include "planner/io/files/file_names.h"
#include "planner/io/formats/isoxml/isoxml.h"
#include "planner/io/formats/isoxml/isoxml_codes.h"
#include "planner/io/formats/isoxml/isoxml_links.h"

#include <pugixml.hpp>

#include <algorithm>
#include <cmath>
#include <format>
#include <sstream>
#include <string_view>
#include <utility>

namespace furrow {

namespace {

using namespace isoxml;

// What A+ becomes where only lines are known.
constexpr Length kAPlusReach = metres(100.0);

constexpr std::size_t kOldTerminalsBytes = 2'000'000;

std::string wholeNumber(double value) {
    return std::format("{}", std::llround(value));
}

void addPoint(pugi::xml_node parent, const char* type, GeoPoint point) {
    pugi::xml_node node = parent.append_child("PNT");
    node.append_attribute("A") = type;
    node.append_attribute("C") = std::format("{:.9f}", point.latDeg).c_str();
    node.append_attribute("D") = std::format("{:.9f}", point.lonDeg).c_str();
}

void addRing(pugi::xml_node polygon, const char* type, const GeoRing& ring, bool counterClockwise) {
    if (ring.empty()) {
        return;
    }
    pugi::xml_node line = polygon.append_child("LSG");
    line.append_attribute("A") = type;
    const auto add = [line](const GeoPoint& point) { addPoint(line, kOtherPoint, point); };
    if (isCounterClockwise(ring) == counterClockwise) {
        std::ranges::for_each(ring, add);
        add(ring.front());
    } else {
        add(ring.front());
        std::for_each(ring.rbegin(), ring.rend(), add);
    }
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

class TaskData {
public:
    TaskData(IsoxmlVersion version, const ExportOptions& options)
        : version_{version}, options_{options}, fieldNames_{names()} {
        pugi::xml_node declaration = document_.append_child(pugi::node_declaration);
        declaration.append_attribute("version") = "1.0";
        declaration.append_attribute("encoding") = "UTF-8";
        root_ = document_.append_child("ISO11783_TaskData");
        root_.append_attribute("VersionMajor") = isV4() ? "4" : "3";
        root_.append_attribute("VersionMinor") = "3";
        root_.append_attribute("ManagementSoftwareManufacturer") = "Furrow";
        root_.append_attribute("ManagementSoftwareVersion") = FURROW_VERSION;
        root_.append_attribute("DataTransferOrigin") = "1";
    }

    /// That there is a LINKLIST.XML beside it.
    void addLinkList() {
        pugi::xml_node links = root_.append_child("AFE");
        links.append_attribute("A") = "LINKLIST.XML";
        links.append_attribute("B") = "1";
        links.append_attribute("C") = "";
        links.append_attribute("D") = kLinkList;
    }

    void add(const FieldContent& content) {
        const FieldSource& source = content.field;
        const std::string fieldName = fieldNames_.unique(source.name, "Field");
        pugi::xml_node node = root_.append_child("PFD");
        node.append_attribute("A") = std::format("PFD{}", ++fields_).c_str();
        node.append_attribute("C") = fieldName.c_str();
        node.append_attribute("D") = wholeNumber(content.statedArea().si()).c_str();
        UniqueNames polygonNames = names();
        addBoundary(node, source, polygonNames.unique(fieldName, "Field"), polygonNames);
        for (const Obstacle& obstacle : source.obstacles) {
            const std::string name = polygonNames.unique(obstacle.name, "Obstacle");
            addPolygon(node, obstacle.passable ? kOtherArea : kObstacleArea, name, obstacle.outline);
        }
        if (isV4()) {
            for (const GeoPolygon& polygon : content.mainland) {
                addPolygon(node, kHeadlandArea, polygonNames.unique("Headland", "Headland"), polygon);
            }
        }
        for (const Gate& gate : source.gates) {
            addPoint(node, isV4() ? kFieldAccess : kFlag, gate.position);
            node.last_child().append_attribute("B") = polygonNames.unique(gate.name, "Gate").c_str();
        }
        UniqueNames lineNames = names();
        const int firstGroup = patterns_ + 1;
        for (const GuidanceLine& line : content.lines) {
            const std::string name = lineNames.unique(line.name, "Line");
            isV4() ? addPattern(node, line, name) : addLine(node, drawn(line, kAPlusReach), line, name);
        }
        tasks_.push_back({fieldName, firstGroup, patterns_});
    }

    /// For terminals that show lines in a task only.
    void addTasks() {
        for (std::size_t i = 0; options_.task && i < tasks_.size(); ++i) {
            pugi::xml_node task = root_.append_child("TSK");
            task.append_attribute("A") = std::format("TSK{}", i + 1).c_str();
            task.append_attribute("B") = tasks_[i].name.c_str();
            task.append_attribute("E") = std::format("PFD{}", i + 1).c_str();
            task.append_attribute("G") = kPlanned;
            for (int group = tasks_[i].firstGroup; isV4() && group <= tasks_[i].lastGroup; ++group) {
                task.append_child("GAN").append_attribute("A") = std::format("GGP{}", group).c_str();
            }
        }
    }

    std::string text() const {
        std::ostringstream out;
        document_.save(out, "  ", pugi::format_default, pugi::encoding_utf8);
        return std::move(out).str();
    }

private:
    bool isV4() const { return version_ == IsoxmlVersion::V4; }
    UniqueNames names() const {
        return {static_cast<std::size_t>(std::max(options_.longestName, 8)), options_.asciiNames};
    }

    void addBoundary(pugi::xml_node node, const FieldSource& source, const std::string& firstName,
                     UniqueNames& polygonNames) {
        for (std::size_t i = 0; i < source.parts.size(); ++i) {
            // The first part is called like the field.
            const std::string name = i == 0 ? firstName : polygonNames.unique(source.name, "Field");
            if (!options_.holesAsObstacles) {
                addPolygon(node, kFieldBoundary, name, source.parts[i]);
                continue;
            }
            addPolygon(node, kFieldBoundary, name, {.outer = source.parts[i].outer, .holes = {}});
            for (const GeoRing& hole : source.parts[i].holes) {
                addPolygon(node, kObstacleArea, polygonNames.unique("Hole", "Hole"),
                           {.outer = hole, .holes = {}});
            }
        }
    }

    static void addWidth(pugi::xml_node line, const GuidanceLine& guidance) {
        if (guidance.width) {
            line.append_attribute("C") = wholeNumber(guidance.width->si() * 1000.0).c_str();
        }
    }

    /// Version 3: a line string of the field itself.
    static void addLine(pugi::xml_node field, const GeoRing& points, const GuidanceLine& guidance,
                        const std::string& name) {
        if (points.size() < 2) {
            return;
        }
        pugi::xml_node line = field.append_child("LSG");
        line.append_attribute("A") = kGuidanceLine;
        line.append_attribute("B") = name.c_str();
        addWidth(line, guidance);
        for (const GeoPoint& point : points) {
            addPoint(line, kOtherPoint, point);
        }
    }

    /// Version 4. A group of its own for each line: there are terminals that take the first line of a group
    /// only.
    void addPattern(pugi::xml_node field, const GuidanceLine& guidance, const std::string& name) {
        ++patterns_;
        pugi::xml_node group = field.append_child("GGP");
        group.append_attribute("A") = std::format("GGP{}", patterns_).c_str();
        group.append_attribute("B") = name.c_str();
        pugi::xml_node pattern = group.append_child("GPN");
        pattern.append_attribute("A") = std::format("GPN{}", patterns_).c_str();
        pattern.append_attribute("B") = name.c_str();
        const bool isArc = guidance.kind == GuidanceKind::Pivot && guidance.points.size() >= 3;
        switch (guidance.kind) {
            case GuidanceKind::AbLine: pattern.append_attribute("C") = kAb; break;
            case GuidanceKind::APlus: pattern.append_attribute("C") = kAPlus; break;
            case GuidanceKind::Curve: pattern.append_attribute("C") = kCurve; break;
            case GuidanceKind::Pivot:
                pattern.append_attribute("C") = kPivot;
                pattern.append_attribute("D") = !isArc               ? kFullCircle
                                                : guidance.clockwise ? kClockwise
                                                                     : kCounterClockwise;
                break;
        }
        pattern.append_attribute("E") = guidance.repeats ? kBothSides : kNone;
        pattern.append_attribute("F") =
            guidance.repeats && guidance.kind != GuidanceKind::Pivot ? kBothEnds : kNone;
        if (guidance.bearing) {
            pattern.append_attribute("G") = std::format("{:.4f}", inDegrees(*guidance.bearing)).c_str();
        }
        if (guidance.kind == GuidanceKind::Pivot && guidance.radius) {
            pattern.append_attribute("H") = wholeNumber(guidance.radius->si() * 1000.0).c_str();
        }
        pattern.append_attribute("I") = kMadeOnDesktop;
        pugi::xml_node line = pattern.append_child("LSG");
        line.append_attribute("A") = kGuidanceLine;
        line.append_attribute("B") = name.c_str();
        addWidth(line, guidance);
        const auto last = guidance.points.size() - 1;
        for (std::size_t i = 0; i < guidance.points.size(); ++i) {
            const char* type = guidance.kind == GuidanceKind::Pivot ? (i == 0   ? kCentre
                                                                       : i == 1 ? kReferenceA
                                                                                : kReferenceB)
                                                                    : (i == 0      ? kReferenceA
                                                                       : i == last ? kReferenceB
                                                                                   : kGuidancePoint);
            addPoint(line, type, guidance.points[i]);
        }
    }

    struct Task {
        std::string name;
        int firstGroup = 0;
        int lastGroup = 0;
    };

    IsoxmlVersion version_;
    ExportOptions options_;
    std::vector<Task> tasks_;
    pugi::xml_document document_;
    pugi::xml_node root_;
    UniqueNames fieldNames_;
    int fields_ = 0;
    int patterns_ = 0;
};

std::string taskData(std::span<const FieldContent> fields, IsoxmlVersion version,
                     const ExportOptions& options, bool withLinks) {
    TaskData data{version, options};
    if (withLinks) {
        data.addLinkList();
    }
    for (const FieldContent& field : fields) {
        data.add(field);
    }
    data.addTasks();
    return data.text();
}

FormatFiles writeVersion(const ExportJob& job, IsoxmlVersion version) {
    std::string text = taskData(job.fields, version, job.options, version == IsoxmlVersion::V4);
    FormatFiles made;
    if (text.size() > kOldTerminalsBytes) {
        made.notes.push_back(message("The task data has {:.1f} MB; old terminals take at most 2 MB.",
                                     static_cast<double>(text.size()) / 1e6));
    }
    made.files.push_back({"TASKDATA/TASKDATA.XML", [text = std::move(text)] { return text; }});
    if (version == IsoxmlVersion::V4) {
        made.files.push_back(
            {"TASKDATA/LINKLIST.XML", [links = isoxmlLinkList(job.fields)] { return links; }});
    }
    return made;
}

}  // namespace

std::string isoxmlText(std::span<const FieldContent> fields, IsoxmlVersion version,
                       const ExportOptions& options) {
    return taskData(fields, version, options, false);
}

std::string isoxmlTaskData(const Plan& plan) {
    return isoxmlText(std::vector{contentOf(plan)}, IsoxmlVersion::V4);
}

Result<FormatFiles> writeIsoxml4(const ExportJob& job) {
    return writeVersion(job, IsoxmlVersion::V4);
}

Result<FormatFiles> writeIsoxml3(const ExportJob& job) {
    return writeVersion(job, IsoxmlVersion::V3);
}

}  // namespace furrow
