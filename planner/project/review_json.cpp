#include "planner/project/review_json.h"

#include <array>
#include <utility>

namespace furrow {

namespace {

constexpr std::array<std::pair<Verdict, const char*>, 3> kVerdicts{
    {{Verdict::None, "none"}, {Verdict::Approved, "approved"}, {Verdict::ChangesWanted, "changes-wanted"}}};

std::string idOf(Verdict verdict) {
    for (const auto& [each, id] : kVerdicts) {
        if (each == verdict) {
            return id;
        }
    }
    return kVerdicts.front().second;
}

/// Those of later versions are none.
Verdict verdictFrom(const std::string& id) {
    for (const auto& [verdict, each] : kVerdicts) {
        if (each == id) {
            return verdict;
        }
    }
    return Verdict::None;
}

OrderedJson commentJson(const ReviewComment& comment) {
    OrderedJson json{
        {"id", comment.id}, {"author", comment.author}, {"written", comment.written}, {"text", comment.text}};
    if (comment.place) {
        json["lon_deg"] = comment.place->lonDeg;
        json["lat_deg"] = comment.place->latDeg;
    }
    json["plan_key"] = comment.planKey;
    json["settled"] = comment.settled;
    addMembers(json, comment.others);
    return json;
}

ReviewComment commentFrom(const OrderedJson& json) {
    ReviewComment comment{.id = json.at("id").get<std::string>(),
                          .author = json.value("author", ""),
                          .written = json.value("written", ""),
                          .text = json.value("text", ""),
                          .place = {},
                          .planKey = json.value("plan_key", ""),
                          .settled = json.value("settled", false),
                          .others = otherMembers(json, {"id", "author", "written", "text", "lon_deg",
                                                        "lat_deg", "plan_key", "settled"})};
    if (json.contains("lon_deg") && json.contains("lat_deg")) {
        comment.place =
            GeoPoint{.lonDeg = json.at("lon_deg").get<double>(), .latDeg = json.at("lat_deg").get<double>()};
    }
    return comment;
}

}  // namespace

OrderedJson reviewJson(const Review& review) {
    OrderedJson json{{"id", review.id}};
    if (review.received) {
        json["received"] = true;
    }
    json["comments"] = OrderedJson::array();
    for (const ReviewComment& comment : review.comments) {
        json["comments"].push_back(commentJson(comment));
    }
    if (review.verdict.verdict != Verdict::None) {
        json["verdict"] = {{"verdict", idOf(review.verdict.verdict)},
                           {"author", review.verdict.author},
                           {"written", review.verdict.written},
                           {"plan_key", review.verdict.planKey}};
    }
    addMembers(json, review.others);
    return json;
}

Review reviewFrom(const OrderedJson& json) {
    Review review{.id = json.value("id", ""),
                  .received = json.value("received", false),
                  .comments = {},
                  .verdict = {},
                  .others = otherMembers(json, {"id", "received", "comments", "verdict"})};
    for (const OrderedJson& comment : json.value("comments", OrderedJson::array())) {
        review.comments.push_back(commentFrom(comment));
    }
    if (json.contains("verdict")) {
        const OrderedJson& verdict = json.at("verdict");
        review.verdict = {.verdict = verdictFrom(verdict.value("verdict", "none")),
                          .author = verdict.value("author", ""),
                          .written = verdict.value("written", ""),
                          .planKey = verdict.value("plan_key", "")};
    }
    return review;
}

}  // namespace furrow
