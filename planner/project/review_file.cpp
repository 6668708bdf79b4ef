#include "planner/project/review_file.h"

#include "planner/io/files/atomic_files.h"
#include "planner/io/formats/geojson/plan_geojson.h"
#include "planner/project/plan_key.h"
#include "planner/project/project_file.h"
#include "planner/project/project_json.h"

#include <array>
#include <format>
#include <memory>
#include <string_view>
#include <system_error>

namespace furrow {

namespace {

// What a project has anyway is not drawn once more.
constexpr std::array<std::string_view, 4> kDrawn{"headland_pass", "swath", "path", "finding"};

OrderedJson drawnOnly(OrderedJson feature) {
    feature["properties"][kDrawnOnly] = true;
    return feature;
}

OrderedJson commentFeature(const ReviewComment& comment) {
    return drawnOnly(
        {{"type", "Feature"},
         {"properties",
          {{"kind", "comment"},
           {"text", comment.text},
           {"author", comment.author},
           {"written", comment.written},
           {"settled", comment.settled}}},
         {"geometry",
          {{"type", "Point"},
           {"coordinates", OrderedJson::array({comment.place->lonDeg, comment.place->latDeg})}}}});
}

std::vector<std::string> drawnFeatures(const Plan& plan, const Review& review) {
    std::vector<std::string> features;
    const OrderedJson drawn = OrderedJson::parse(planGeoJson(plan));
    for (const OrderedJson& feature : drawn.at("features")) {
        const std::string kind = feature.at("properties").value("kind", "");
        for (const std::string_view each : kDrawn) {
            if (kind == each) {
                features.push_back(textOf(drawnOnly(feature)));
            }
        }
    }
    for (const ReviewComment& comment : review.comments) {
        if (comment.place) {
            features.push_back(textOf(commentFeature(comment)));
        }
    }
    return features;
}

/// Where the plan with this review stands; nothing where none has it.
struct Place {
    std::size_t field = 0;
    std::size_t plan = 0;
};
std::optional<Place> placeOf(const Project& project, const std::string& review) {
    for (std::size_t field = 0; field < project.fields.size() && !review.empty(); ++field) {
        const std::vector<FieldPlan>& plans = project.fields[field]->plans;
        for (std::size_t plan = 0; plan < plans.size(); ++plan) {
            if (plans[plan].review.id == review) {
                return Place{field, plan};
            }
        }
    }
    return std::nullopt;
}

}  // namespace

Project forReview(const Project& project) {
    const ProjectField* const field = project.field();
    Project sent = Project::empty();
    sent.name = project.name;
    sent.standard = project.standard;
    if (field != nullptr) {
        ProjectField alone = *field;
        alone.plans = {project.plan()};
        alone.plans.front().review.received = true;
        sent.fields = {std::make_shared<const ProjectField>(std::move(alone))};
    }
    return sent;
}

std::string reviewText(const Project& project, const Plan& plan) {
    Project sent = forReview(project);
    sent.otherFeatures = drawnFeatures(plan, sent.plan().review);
    return projectText(sent);
}

Result<void> writeReview(const Project& project, const Plan& plan, const std::filesystem::path& path) {
    std::error_code ignored;
    const std::filesystem::path target = std::filesystem::weakly_canonical(path, ignored);
    const std::filesystem::path& place = target.empty() ? path : target;
    const FileToWrite file{.path = place.filename(), .text = [&] { return reviewText(project, plan); }};
    const auto written = writeTogether(place.parent_path(), std::span{&file, 1});
    return written ? Result<void>{} : std::unexpected(written.error());
}

Result<TakenReview> takenReview(const Project& mine, const Project& sent) {
    const Review& theirs = sent.plan().review;
    const auto place = placeOf(mine, theirs.id);
    if (!place || sent.field() == nullptr) {
        return std::unexpected(
            Error{.code = ErrorCode::InputRefused,
                  .what = "no plan of this project was sent for this review",
                  .where = sent.field() != nullptr ? sent.field()->source->name : std::string{},
                  .remedy = "open the project that the plan was sent from, or open the file by itself"});
    }
    TakenReview taken{.project = mine};
    ProjectField field = *mine.fields[place->field];
    FieldPlan& plan = field.plans[place->plan];
    MergedReview both = merged(plan.review, theirs);
    taken.added = both.added;
    taken.changed = both.changed;
    taken.verdictChanged = both.verdictChanged;
    taken.planDiffers = planKey(*field.source, plan) != planKey(*sent.field()->source, sent.plan());
    plan.review = std::move(both.review);
    taken.project.fields[place->field] = std::make_shared<const ProjectField>(std::move(field));
    taken.project.currentField = place->field;
    taken.project.currentPlan = place->plan;
    return taken;
}

}  // namespace furrow
