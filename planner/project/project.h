#pragma once

#include "planner/core/result.h"
#include "planner/field/field.h"
#include "planner/machine/machine.h"
#include "planner/project/review.h"
#include "planner/project/work_order.h"
#include "planner/settings/settings.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace furrow {

/// What is done on a field: a machine and the settings to plan it with.
struct FieldPlan {
    std::string id;      ///< not empty; no other plan of the project has it
    std::string name;    ///< "Spring drilling"
    std::string season;  ///< "2026"; may be empty
    Machine machine;
    Settings settings;
    Review review;
    WorkOrder order = {};
    /// Members of a file that this version does not know, as a JSON object; empty for none.
    std::string others;

    friend bool operator==(const FieldPlan&, const FieldPlan&) = default;
};

/// A field of a farm and its plans.
struct ProjectField {
    std::string id;                             ///< not empty; no other field of the project has it
    std::shared_ptr<const FieldSource> source;  ///< not null, not checked: as it was drawn or read
    std::vector<FieldPlan> plans;               ///< at least one
    /// Members of the field's own feature that this version does not know, as FieldPlan::others.
    std::string others;
    /// The same of each obstacle and each gate, in the order of the source; missing ones are empty.
    std::vector<std::string> obstacleOthers;
    std::vector<std::string> gateOthers;

    friend bool operator==(const ProjectField& a, const ProjectField& b);
};

/// A picture or heights under the map, by the file that holds it.
struct ImageryLayer {
    /// The file or the folder of tiles; absolute, or as the project's text says.
    std::string path;
    std::string name;
    bool visible = true;
    double opacity = 1.0;  ///< in [0, 1]
    /// Rows of a folder of tiles count from the south; nothing to take what the folder says.
    std::optional<bool> rowsFromSouth;
    /// Members of a file that this version does not know, as FieldPlan::others.
    std::string others;

    friend bool operator==(const ImageryLayer&, const ImageryLayer&) = default;
};

/// A farm: everything that a project file keeps. A value; copies share the fields that are equal.
struct Project {
    std::string name;
    std::vector<std::shared_ptr<const ProjectField>> fields;
    /// What is worked on; both out of range where there is no field.
    std::size_t currentField = 0;
    std::size_t currentPlan = 0;
    /// What the plan of a first field begins with.
    FieldPlan standard;
    /// Lowest first.
    std::vector<ImageryLayer> imagery;
    /// Members of the file that this version does not know, as FieldPlan::others.
    std::string others;
    /// Features that are no part of a field, each as JSON.
    std::vector<std::string> otherFeatures;

    /// An empty farm with the library's first machine.
    static Project empty();

    const ProjectField* field() const;
    /// The current plan, or the standard one where there is no field.
    const FieldPlan& plan() const;
    /// The plan that a field is known by: of the current field the current one, of others the first.
    const FieldPlan& planOf(std::size_t field) const;

    friend bool operator==(const Project& a, const Project& b);
};

/// "field-3": an id with this beginning that nothing in the project has.
std::string freeFieldId(const Project& project);
std::string freePlanId(const Project& project);

/// The plan that a field begins with after another: the same machine and settings but for what names places
/// of one field only.
FieldPlan planForAnotherField(const FieldPlan& plan);

}  // namespace furrow
