#include "planner/project/project_file.h"

#include "planner/core/file_error.h"
#include "planner/core/json_text.h"
#include "planner/core/text.h"
#include "planner/io/files/atomic_files.h"
#include "planner/io/files/file_folder.h"
#include "planner/project/migrations.h"
#include "planner/project/project_json.h"
#include "planner/version.h"

#include <algorithm>
#include <cstdint>
#include <format>
#include <map>
#include <system_error>

namespace furrow {

namespace {

constexpr const char* kMember = "furrow_project";
// A project says in its first bytes what it is.
constexpr std::size_t kBytesThatTell = 4096;

std::string textProperty(const OrderedJson& feature, const char* key) {
    const OrderedJson* properties = feature.contains("properties") ? &feature["properties"] : nullptr;
    return properties != nullptr && properties->is_object() && properties->contains(key) &&
                   (*properties)[key].is_string()
               ? (*properties)[key].get<std::string>()
               : std::string{};
}

/// Features and plans of one field, as far as they were found.
struct FieldParts {
    std::string id;
    OrderedJson features = OrderedJson::array();
    OrderedJson plans = OrderedJson::array();
};

/// Which obstacle stands nowhere; they are never left out.
Error withoutField(const OrderedJson& obstacle, const std::string& origin) {
    const std::string field = textProperty(obstacle, "field");
    return inputRefused(message("{}, obstacle {}", origin, textProperty(obstacle, "name")),
                        field.empty() ? Message{"it does not say which field it belongs to"}
                                      : message("there is no field '{}' in the project", field),
                        "give it the field that it lies in, or remove it from the file");
}

bool isArea(const OrderedJson& feature) {
    const auto geometry = feature.find("geometry");
    return geometry != feature.end() && geometry->is_object() &&
           geometry->value("type", "").ends_with("Polygon");
}

bool isDrawnOnly(const OrderedJson& feature) {
    const auto properties = feature.find("properties");
    return properties != feature.end() && properties->is_object() && properties->contains(kDrawnOnly) &&
           (*properties)[kDrawnOnly] == true;
}

/// Sorts features into fields; those that are no part of any go to the project.
Result<std::vector<FieldParts>> sorted(const OrderedJson& document, OpenedProject& opened,
                                       const std::string& origin) {
    std::vector<FieldParts> fields;
    std::size_t unused = 0;
    const auto find = [&fields](const std::string& id) {
        return std::ranges::find(fields, id, &FieldParts::id);
    };
    for (OrderedJson feature : document.at("features")) {
        if (textProperty(feature, "kind") != "field") {
            continue;
        }
        // Another program may have added a field, or copied one.
        std::string id = textProperty(feature, "field");
        for (std::size_t number = fields.size() + 1; id.empty() || find(id) != fields.end(); ++number) {
            id = std::format("field-{}", number);
        }
        feature["properties"]["field"] = id;
        fields.push_back({.id = id});
        fields.back().features.push_back(std::move(feature));
    }
    for (const OrderedJson& feature : document.at("features")) {
        if (isDrawnOnly(feature)) {
            continue;
        }
        const std::string kind = textProperty(feature, "kind");
        const auto owner = find(textProperty(feature, "field"));
        if ((kind == "obstacle" || kind == "gate") && owner != fields.end()) {
            owner->features.push_back(feature);
        } else if (kind == "obstacle") {
            return std::unexpected(withoutField(feature, origin));
        } else if (kind != "field") {
            opened.project.otherFeatures.push_back(textOf(feature));
            unused += isArea(feature) ? 1 : 0;
        }
    }
    if (unused > 0) {
        opened.notes.push_back(
            counted("{} area in the file is neither field nor obstacle and was not used",
                    "{} areas in the file are neither field nor obstacle and were not used", unused));
    }
    if (const OrderedJson& head = document.at(kMember); head.contains("plans")) {
        for (const OrderedJson& plan : head.at("plans")) {
            if (const auto owner = find(plan.value("field", "")); owner != fields.end()) {
                owner->plans.push_back(plan);
            }
        }
    }
    return fields;
}

Result<OpenedProject> projectFrom(const OrderedJson& document, const std::string& origin) {
    OpenedProject opened{.project = Project::empty(), .fingerprint = {}, .notes = {}};
    Project& project = opened.project;
    const auto fields = sorted(document, opened, origin);
    if (!fields) {
        return std::unexpected(fields.error());
    }
    readHead(document.at(kMember), project, opened.notes);
    for (const FieldParts& parts : *fields) {
        project.fields.push_back(std::make_shared<const ProjectField>(
            fieldOf(parts.features, parts.plans, project.standard, freePlanId(project), opened.notes)));
    }
    Notes ignored;
    // Which field is current can only be told when they are there.
    readHead(document.at(kMember), project, ignored);
    OrderedJson others = OrderedJson::object();
    addMembers(others, project.others);
    if (const std::string members = otherMembers(document, {"type", "features", kMember}); !members.empty()) {
        others["document"] = OrderedJson::parse(members);
    }
    project.others = others.empty() ? std::string{} : textOf(others);
    return opened;
}

/// Paths of imagery as they are written: from the project's folder, so that both can be moved together; as
/// they are where they have nothing in common with it but the root.
Project withPathsFrom(Project project, const std::filesystem::path& folder) {
    for (ImageryLayer& layer : project.imagery) {
        const std::filesystem::path path{layer.path};
        const std::filesystem::path own = path.relative_path();
        const std::filesystem::path there = folder.relative_path();
        if (path.is_absolute() && folder.is_absolute() && !own.empty() && !there.empty() &&
            *own.begin() == *there.begin()) {
            layer.path = path.lexically_relative(folder).generic_string();
        }
    }
    return project;
}

Project withPathsIn(Project project, const std::filesystem::path& folder) {
    for (ImageryLayer& layer : project.imagery) {
        layer.path = (folder / layer.path).lexically_normal().string();
    }
    return project;
}

}  // namespace

std::optional<std::string> fileFingerprint(const std::filesystem::path& path) {
    const auto bytes = fileBytes(path);
    return bytes ? std::optional{fingerprint(*bytes)} : std::nullopt;
}

bool isProject(std::string_view text) {
    return text.substr(0, kBytesThatTell).contains(std::format("\"{}\"", kMember));
}

bool holdsProject(const std::filesystem::path& path) {
    const std::string extension = inSmallLetters(path.extension().string());
    if (extension == kProjectExtension) {
        return true;
    }
    std::error_code ignored;
    const auto start = std::filesystem::is_regular_file(path, ignored) ? fileStart(path, kBytesThatTell)
                                                                       : Result<std::string>{""};
    return start && isProject(*start);
}

Result<OpenedProject> parseProject(std::string_view text, const std::string& origin) {
    const auto damaged = [&origin](const Message& what) {
        return std::unexpected(inputRefused(origin, message("this project file is damaged: {}", what),
                                            "restore a copy of the file"));
    };
    auto json = readJson<OrderedJson>(text);
    if (!json) {
        const JsonFault& fault = json.error();
        return damaged(fault.place.empty() ? fault.what : message("{} ({})", fault.what, fault.place));
    }
    try {
        OrderedJson document = *std::move(json);
        if (!document.is_object() || !document.contains(kMember) || !document.at(kMember).is_object()) {
            return std::unexpected(inputRefused(origin, "this is not a project of Furrow",
                                                "open it as a field boundary, or choose another file"));
        }
        const int version = document.at(kMember).value("format_version", 0);
        auto current = migrated(std::move(document), version, projectMigrations(), origin);
        if (!current) {
            return std::unexpected(current.error());
        }
        auto opened = projectFrom(*current, origin);
        if (opened) {
            opened->fingerprint = fingerprint(text);
        }
        return opened;
    } catch (const OrderedJson::exception&) {
        return damaged("a value in it is not of the kind that belongs there");
    }
}

Result<OpenedProject> readProject(const std::filesystem::path& path) {
    const auto bytes = fileBytes(path);
    auto opened = bytes ? parseProject(*bytes, path.string()) : std::unexpected(bytes.error());
    if (opened) {
        std::error_code ignored;
        opened->project =
            withPathsIn(std::move(opened->project), std::filesystem::absolute(path, ignored).parent_path());
    }
    return opened;
}

std::string projectText(const Project& project) {
    OrderedJson head{{"format_version", kProjectVersion}, {"written_by", "Furrow " FURROW_VERSION}};
    head.update(headOf(project));
    OrderedJson document = OrderedJson::object();
    if (head.contains("document")) {
        document = head["document"];
        head.erase("document");
    }
    std::string text = "{\"type\": \"FeatureCollection\",\n";
    for (const auto& [key, value] : document.items()) {
        text += std::format("{}: {},\n", OrderedJson(key).dump(), textOf(value));
    }
    OrderedJson plans = OrderedJson::array();
    std::string features;
    for (const auto& field : project.fields) {
        for (OrderedJson& plan : plansOf(*field)) {
            plans.push_back(std::move(plan));
        }
        for (const OrderedJson& feature : featuresOf(*field)) {
            features += (features.empty() ? "" : ",\n") + textOf(feature);
        }
    }
    for (const std::string& feature : project.otherFeatures) {
        features += (features.empty() ? "" : ",\n") + feature;
    }
    head["plans"] = std::move(plans);
    return text + std::format("\"{}\": {},\n\"features\": [\n{}\n]}}\n", kMember, textOf(head), features);
}

Result<std::string> writeProject(const Project& project, const std::filesystem::path& path) {
    std::error_code ignored;
    const std::filesystem::path target = std::filesystem::weakly_canonical(path, ignored);
    const std::filesystem::path& place = target.empty() ? path : target;
    const std::string text =
        projectText(withPathsFrom(project, std::filesystem::absolute(place, ignored).parent_path()));
    const FileToWrite file{.path = place.filename(), .text = [&text]() -> std::string { return text; }};
    const auto written = writeTogether(place.parent_path(), std::span{&file, 1});
    return written ? Result<std::string>{fingerprint(text)} : std::unexpected(written.error());
}

}  // namespace furrow
