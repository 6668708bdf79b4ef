// Reviews: what is merged, what is written, what other programs see.

#include "planner/io/import/boundary_import.h"
#include "planner/plan/plan.h"
#include "planner/project/plan_key.h"
#include "planner/project/project_edits.h"
#include "planner/project/project_file.h"
#include "planner/project/review_file.h"
#include "tests/planner/project/project_samples.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <nlohmann/json.hpp>

#include <QTemporaryDir>
#include <QTest>

using namespace furrow;
using namespace furrow::test;

namespace {

ReviewComment comment(const std::string& id, const std::string& text, const std::string& written) {
    return {.id = id, .author = "Ann", .written = written, .text = text, .place = {}, .planKey = "k"};
}

/// One field that can be planned, sent for review as "r1".
Project sentProject() {
    const FieldSource field =
        readBoundaries(FURROW_SOURCE_DIR "/resources/sample_fields/home_field.geojson").value().front();
    Project project = withFields(Project::empty(), {field});
    project = withPlanCopy(std::move(project), "Second");
    return withReview(std::move(project),
                      {.id = "r1", .comments = {comment("c1", "Gate is wet", "2026-11-01T08:00:00Z")}});
}

std::shared_ptr<const Plan> planOf(const Project& project) {
    return makePlan({.field = std::make_shared<const Field>(Field::create(*project.field()->source).value()),
                     .machine = project.plan().machine,
                     .settings = project.plan().settings})
        .value();
}

}  // namespace

class TestReview : public QObject {
    Q_OBJECT

private slots:
    void twiceGivesNothingTwice();
    void theLaterTextHolds();
    void settledStaysSettled();
    void theLaterVerdictHolds();
    void readBackFromAProject();
    void keyTellsChangesOfTheInputs();
    void reviewFileIsAProjectAndAMap();
    void comesBackToItsPlan();
    void aChangedPlanIsTold();
    void notSentFromHere();
    void copiesHaveNoReview();
};

void TestReview::twiceGivesNothingTwice() {
    const Review mine{.id = "r", .comments = {comment("a", "A", "2026-01-01T00:00:00Z")}};
    const Review theirs{
        .id = "r",
        .comments = {comment("a", "A", "2026-01-01T00:00:00Z"), comment("b", "B", "2026-01-02T00:00:00Z")}};
    const MergedReview once = merged(mine, theirs);
    QCOMPARE(once.added, 1);
    QCOMPARE(once.changed, 0);
    QCOMPARE(once.review.comments.size(), 2U);
    const MergedReview twice = merged(once.review, theirs);
    QCOMPARE(twice.added, 0);
    QCOMPARE(twice.changed, 0);
    QVERIFY(twice.review == once.review);
}

void TestReview::theLaterTextHolds() {
    const Review old{.id = "r", .comments = {comment("a", "old", "2026-01-01T00:00:00Z")}};
    const Review later{.id = "r", .comments = {comment("a", "later", "2026-01-03T00:00:00Z")}};
    QCOMPARE(merged(old, later).review.comments[0].text, std::string{"later"});
    QCOMPARE(merged(old, later).changed, 1);
    QCOMPARE(merged(later, old).review.comments[0].text, std::string{"later"});
    QCOMPARE(merged(later, old).changed, 0);
}

void TestReview::settledStaysSettled() {
    Review open{.id = "r", .comments = {comment("a", "A", "2026-01-01T00:00:00Z")}};
    Review settled = open;
    settled.comments[0].settled = true;
    QVERIFY(merged(open, settled).review.comments[0].settled);
    QVERIFY(merged(settled, open).review.comments[0].settled);
}

void TestReview::theLaterVerdictHolds() {
    const Review mine{.id = "r",
                      .verdict = {.verdict = Verdict::ChangesWanted, .written = "2026-01-02T00:00:00Z"}};
    const Review later{.id = "r",
                       .verdict = {.verdict = Verdict::Approved, .written = "2026-01-03T00:00:00Z"}};
    QVERIFY(merged(mine, later).verdictChanged);
    QCOMPARE(merged(mine, later).review.verdict.verdict, Verdict::Approved);
    QVERIFY(!merged(later, mine).verdictChanged);
    QVERIFY(!merged(mine, Review{.id = "r"}).verdictChanged);
}

void TestReview::readBackFromAProject() {
    Review review{.id = "r7",
                  .comments = {comment("a", "Wet \"corner\"\nsecond line", "2026-01-01T00:00:00Z")},
                  .verdict = {.verdict = Verdict::Approved,
                              .author = "Bob",
                              .written = "2026-01-02T00:00:00Z",
                              .planKey = "k2"}};
    review.comments[0].place = GeoPoint{.lonDeg = 22.5000000001, .latDeg = 58.25};
    review.comments[0].settled = true;
    review.comments[0].others = R"({"mood":"good"})";
    const Project project = withReview(sampleProject(), review);
    const auto read = parseProject(projectText(project), "farm.furrow");
    VERIFY_RESULT(read);
    QVERIFY(read->project == project);
    QVERIFY(read->project.plan().review == review);
    // A plan that nobody reviewed says nothing of it.
    QVERIFY(!projectText(sampleProject()).contains("review"));
}

void TestReview::keyTellsChangesOfTheInputs() {
    const Project project = sampleProject();
    const FieldSource& field = *project.field()->source;
    const FieldPlan& plan = project.plan();
    const std::string key = planKey(field, plan);
    FieldPlan renamed = plan;
    renamed.name = "Other";
    renamed.season = "2030";
    renamed.review = {.id = "x"};
    QCOMPARE(planKey(field, renamed), key);
    FieldPlan other = plan;
    other.machine = machineLibrary()[3];
    QVERIFY(planKey(field, other) != key);
    other = plan;
    other.settings.set(**findParameter("swaths.overlap_m"), 0.1).value();
    QVERIFY(planKey(field, other) != key);
    FieldSource moved = field;
    moved.parts[0].outer[0].lonDeg += 1e-9;
    QVERIFY(planKey(moved, plan) != key);
    FieldSource gate = field;
    gate.gates.clear();
    QVERIFY(planKey(gate, plan) != key);
}

void TestReview::reviewFileIsAProjectAndAMap() {
    Project project = sentProject();
    Review review = project.plan().review;
    review.comments[0].place = GeoPoint{.lonDeg = 13.45, .latDeg = 55.47};
    project = withReview(std::move(project), review);
    const QTemporaryDir folder;
    const std::filesystem::path file = folder.filePath("review.furrow").toStdU16String();
    VERIFY_RESULT(writeReview(project, *planOf(project), file));
    const auto read = readProject(file);
    VERIFY_RESULT(read);
    QVERIFY(read->notes.empty());
    QVERIFY(read->project == forReview(project));
    QCOMPARE(read->project.fields.size(), 1U);
    QCOMPARE(read->project.field()->plans.size(), 1U);
    QCOMPARE(read->project.plan().name, std::string{"Second"});
    QVERIFY(read->project.plan().review.received);
    // What a program for maps sees.
    const auto json = nlohmann::json::parse(reviewText(project, *planOf(project)));
    QCOMPARE(json.at("type"), "FeatureCollection");
    std::map<std::string, int> kinds;
    for (const auto& feature : json.at("features")) {
        ++kinds[feature.at("properties").at("kind").get<std::string>()];
    }
    QCOMPARE(kinds["field"], 1);
    QCOMPARE(kinds["comment"], 1);
    QCOMPARE(static_cast<std::size_t>(kinds["swath"]), planOf(project)->swaths.swaths.size());
    QCOMPARE(static_cast<std::size_t>(kinds["path"]), planOf(project)->path.segments.size());
}

void TestReview::comesBackToItsPlan() {
    const Project mine = showing(sentProject(), 0, 0);
    Project sent = forReview(sentProject());
    Review review = sent.plan().review;
    review.comments.push_back(comment("c2", "Start at the road", "2026-11-02T08:00:00Z"));
    review.verdict = {.verdict = Verdict::Approved, .written = "2026-11-02T09:00:00Z"};
    sent = withReview(std::move(sent), review);
    const auto taken = takenReview(mine, sent);
    VERIFY_RESULT(taken);
    QCOMPARE(taken->added, 1);
    QVERIFY(taken->verdictChanged);
    QVERIFY(!taken->planDiffers);
    // The plan that was sent is current, and has what was said; the other one has nothing.
    QCOMPARE(taken->project.plan().name, std::string{"Second"});
    QVERIFY(review.received && !taken->project.plan().review.received);
    review.received = false;
    QVERIFY(taken->project.plan().review == review);
    QVERIFY(taken->project.field()->plans[0].review.empty());
    const auto again = takenReview(taken->project, sent);
    VERIFY_RESULT(again);
    QCOMPARE(again->added, 0);
    QVERIFY(again->project == taken->project);
}

void TestReview::aChangedPlanIsTold() {
    Project mine = sentProject();
    const Project sent = forReview(mine);
    Settings settings = mine.plan().settings;
    settings.set(**findParameter("swaths.overlap_m"), 0.2).value();
    mine = withPlan(mine, mine.plan().machine, settings);
    QVERIFY(takenReview(mine, sent)->planDiffers);
}

void TestReview::notSentFromHere() {
    const auto refused = takenReview(sampleProject(), forReview(sentProject()));
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, ErrorCode::InputRefused);
    // A plan that was never sent is nobody's.
    QVERIFY(!takenReview(sampleProject(), forReview(sampleProject())));
}

void TestReview::copiesHaveNoReview() {
    const Project copied = withPlanCopy(sentProject(), "Third");
    QVERIFY(copied.plan().review.empty());
    QVERIFY(planForAnotherField(sentProject().plan()).review.empty());
}

FURROW_TEST(TestReview);
#include "tst_review.moc"
