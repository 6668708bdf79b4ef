#pragma once

#include "planner/editing/field_shape.h"
#include "planner/project/project.h"

#include <span>
#include <string>
#include <vector>

namespace furrow {

// Projects with one thing changed. What is not touched is shared with the project they were made from.

/// The current field with another source; obstacles and gates keep their order. Nothing to do without a
/// field.
Project withSource(Project project, FieldSource source);
/// The current plan, or the standard one where there is no field, with this machine and these settings.
Project withPlan(Project project, const Machine& machine, const Settings& settings);

/// With new fields behind the others, each with a plan after the current one; the first of them is current.
Project withFields(Project project, std::vector<FieldSource> sources);
/// Without the current field; its neighbour is current then.
Project withoutField(Project project);
/// With another obstacle, gate or hole in the current field, behind the others.
Project withObstacle(Project project, Obstacle obstacle);
Project withGate(Project project, Gate gate);
Project withHole(Project project, std::size_t part, GeoRing hole);
Project withoutHole(Project project, std::size_t part, std::size_t hole);
/// With the swaths of the current plan along this line; of three points or more, as a curve where the planner
/// can. Without points: back to the planner's own choice.
Project withGuide(Project project, const GeoRing& line);
/// With these lines for the mainland of the current plan to be cut along, each of at least two points.
Project withSplits(Project project, const std::vector<GeoRing>& lines);
/// What is drawn across the field: the line that the current plan's swaths follow, and those it is cut along.
DrawnLines linesOf(const Project& project);
/// Whether swaths can follow a curve.
bool canFollowCurves();
/// Without one obstacle or gate of the current field.
Project withoutObstacle(Project project, std::size_t obstacle);
Project withoutGate(Project project, std::size_t gate);

/// With a copy of the current plan under this name, which is current.
Project withPlanCopy(Project project, const std::string& name);
/// Without the current plan; the last one stays.
Project withoutPlan(Project project);
/// With other work order data in the current plan. Nothing to do without a field.
Project withWorkOrder(Project project, WorkOrder order);
/// With the steps of these fields' outlines made straight (see outline_steps); outlines that would cross
/// themselves stay.
Project withStraightSteps(Project project, std::span<const std::size_t> fields);
/// With the machine and the settings of this plan in the plans that these fields are known by (planOf); what
/// names places of one field stays behind.
Project withPlansLike(Project project, std::span<const std::size_t> fields, const FieldPlan& like);
/// With a copy of the plan that each of these fields is known by, in front of its others, under this name and
/// for this season. In the current field it is current.
Project withPlansAdded(Project project, std::span<const std::size_t> fields, const std::string& name,
                       const std::string& season);
Project withFieldName(Project project, const std::string& name);
Project withPlanName(Project project, const std::string& name, const std::string& season);
/// With this review of the current plan.
Project withReview(Project project, Review review);

/// With more imagery above what is there.
Project withImagery(Project project, std::vector<ImageryLayer> layers);
/// With another layer in the place of one. These three do nothing where there is no such layer.
Project withImageryLayer(Project project, std::size_t index, ImageryLayer layer);
Project withoutImageryLayer(Project project, std::size_t index);
/// With a layer in another place of the order; `to` counts without it.
Project withImageryMoved(Project project, std::size_t from, std::size_t to);

/// With another field or plan to work on; what is out of range becomes the last one.
Project showing(Project project, std::size_t field, std::size_t plan);

}  // namespace furrow
