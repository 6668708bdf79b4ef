#include "planner/io/formats/ros/ros.h"

#include "planner/io/files/sqlite.h"
#include "planner/io/formats/ros/nav_path.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/plan.h"

#include <sqlite3.h>

#include <cmath>
#include <format>
#include <iterator>
#include <memory>
#include <utility>

namespace furrow {

namespace {

/// Where "map" lies.
FileToWrite frameFile(const Plan& plan) {
    const LocalFrame& frame = plan.field().frame();
    return {"map_frame.yaml", [frame] {
                return std::format(
                    "# The frame \"map\": metres east and north of this place, in this projection.\n"
                    "frame_id: map\norigin: {{lat: {:.9f}, lon: {:.9f}}}\nproj: \"{}\"\n",
                    frame.centre().latDeg, frame.centre().lonDeg, frame.projString());
            }};
}

void noteReversing(const std::vector<NavPath>& paths, FormatFiles& made) {
    if (paths.size() > 1) {
        made.notes.emplace_back(
            "nav_msgs/Path does not say which gear: beside the whole path there is a message for each stretch in one "
            "gear, on /coverage_path/forward and /coverage_path/reverse.");
    }
}

bool insertTopics(sqlite3* database, const std::vector<NavTopic>& topics) {
    const SqliteStatement addTopic =
        prepared(database, "INSERT INTO topics VALUES (?, ?, 'nav_msgs/msg/Path', 'cdr', '')");
    const SqliteStatement addMessage =
        prepared(database, "INSERT INTO messages (topic_id, timestamp, data) VALUES (?, ?, ?)");
    for (std::size_t i = 0; i < topics.size(); ++i) {
        const auto id = static_cast<sqlite3_int64>(i + 1);
        sqlite3_reset(addTopic.get());
        sqlite3_bind_int64(addTopic.get(), 1, id);
        sqlite3_bind_text(addTopic.get(), 2, topics[i].name.c_str(), -1, SQLITE_TRANSIENT);
        if (sqlite3_step(addTopic.get()) != SQLITE_DONE) {
            return false;
        }
        for (const NavPath* path : topics[i].messages) {
            const std::string data = cdrOf(*path);
            sqlite3_reset(addMessage.get());
            sqlite3_bind_int64(addMessage.get(), 1, id);
            sqlite3_bind_int64(addMessage.get(), 2, path->recordedNs());
            sqlite3_bind_blob64(addMessage.get(), 3, data.data(), data.size(), SQLITE_TRANSIENT);
            if (sqlite3_step(addMessage.get()) != SQLITE_DONE) {
                return false;
            }
        }
    }
    return true;
}

/// The bytes of a database in memory.
Result<std::string> databaseOf(const std::vector<NavPath>& paths) {
    const SqliteDatabase database = emptyDatabase();
    constexpr const char* kTables =
        "CREATE TABLE topics (id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL,"
        " serialization_format TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL);"
        "CREATE TABLE messages (id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, timestamp INTEGER NOT NULL,"
        " data BLOB NOT NULL);"
        "CREATE INDEX timestamp_idx ON messages (timestamp ASC);";
    const bool good = sqlite3_exec(database.get(), kTables, nullptr, nullptr, nullptr) == SQLITE_OK &&
                      insertTopics(database.get(), topicsOf(paths));
    sqlite3_int64 size = 0;
    const std::unique_ptr<unsigned char, decltype(&sqlite3_free)> bytes{
        good ? sqlite3_serialize(database.get(), "main", &size, 0) : nullptr, &sqlite3_free};
    if (!bytes) {
        return std::unexpected(
            Error{.code = ErrorCode::WriteFailed,
                  .what = message("the recording cannot be made: {}", sqlite3_errmsg(database.get())),
                  .where = "rosbag2",
                  .remedy = "choose the format rosbag2-mcap"});
    }
    return std::string{reinterpret_cast<const char*>(bytes.get()), static_cast<std::size_t>(size)};
}

/// Of a setting that is a choice, as the plan was made.
std::string choiceOf(const Plan& plan, std::string_view key) {
    return plan.request.settings.choice(**findParameter(key));
}

std::string ringText(const Ring& ring) {
    std::string text = "- coordinates:\n";
    const auto add = [&text](const Point& point) {
        std::format_to(std::back_inserter(text), "  - {{axis1: {:.4f}, axis2: {:.4f}}}\n", point.x, point.y);
    };
    for (const Point& point : ring) {
        add(point);
    }
    add(ring.front());  // refused where it is not closed
    return text;
}

}  // namespace

Result<FormatFiles> writeRosbagSqlite(const ExportJob& job) {
    if (job.plan == nullptr) {
        return std::unexpected(needsPlan("rosbag2"));
    }
    const std::vector<NavPath> paths = navPaths(*job.plan);
    return databaseOf(paths).transform([&](std::string database) {
        FormatFiles made;
        made.files.push_back({"rosbag2_sqlite3/metadata.yaml",
                              [text = bagMetadata(paths, "sqlite3", "path_0.db3")] { return text; }});
        made.files.push_back(
            {"rosbag2_sqlite3/path_0.db3", [database = std::move(database)] { return database; }});
        made.files.push_back(frameFile(*job.plan));
        noteReversing(paths, made);
        return made;
    });
}

Result<FormatFiles> writeRosbagMcap(const ExportJob& job) {
    if (job.plan == nullptr) {
        return std::unexpected(needsPlan("rosbag2-mcap"));
    }
    const std::vector<NavPath> paths = navPaths(*job.plan);
    FormatFiles made;
    made.files.push_back(
        {"rosbag2_mcap/metadata.yaml", [text = bagMetadata(paths, "mcap", "path_0.mcap")] { return text; }});
    made.files.push_back({"rosbag2_mcap/path_0.mcap", [bytes = mcapOf(paths)] { return bytes; }});
    made.files.push_back(frameFile(*job.plan));
    noteReversing(paths, made);
    return made;
}

Result<FormatFiles> writeNavPathYaml(const ExportJob& job) {
    if (job.plan == nullptr) {
        return std::unexpected(needsPlan("nav-path"));
    }
    const NavPath path = navPaths(*job.plan).front();
    std::string text;
    const auto add = [&text]<class... Values>(std::format_string<Values...> line, Values&&... values) {
        std::format_to(std::back_inserter(text), line, std::forward<Values>(values)...);
    };
    const auto stamp = [](const NavPose& pose) {
        return std::format("{{sec: {}, nanosec: {}}}", pose.stampNs / 1'000'000'000,
                           pose.stampNs % 1'000'000'000);
    };
    add("header:\n  stamp: {}\n  frame_id: map\nposes:\n", stamp(path.poses.front()));
    for (const NavPose& pose : path.poses) {
        add("- header: {{stamp: {}, frame_id: map}}\n  pose:\n    position: {{x: {:.4f}, y: {:.4f}, z: 0.0}}\n"
            "    orientation: {{x: 0.0, y: 0.0, z: {:.9f}, w: {:.9f}}}\n",
            stamp(pose), pose.x, pose.y, pose.qz, pose.qw);
    }
    FormatFiles made;
    made.files.push_back({"nav_msgs_path.yaml", [text = std::move(text)] { return text; }});
    made.files.push_back(frameFile(*job.plan));
    return made;
}

Result<FormatFiles> writeCoverageGoal(const ExportJob& job) {
    if (job.plan == nullptr) {
        return std::unexpected(needsPlan("coverage-goal"));
    }
    const Plan& plan = *job.plan;
    FormatFiles made;
    if (plan.field().boundary().size() > 1) {
        made.notes.push_back(
            message("A goal of opennav_coverage has one outline: {} of {} parts are left out.",
                    plan.field().boundary().size() - 1, plan.field().boundary().size()));
    }
    const bool driven = plan.headland.width > metres(0.0);
    std::string text = std::format(
        "generate_headland: {}\ngenerate_route: true\ngenerate_path: true\nuse_gml_file: false\ngml_field: \"\"\n"
        "frame_id: map\npolygons:\n",
        driven);
    // Obstacles are taken out of it already: what is left is what can be worked.
    const Polygon& field = plan.field().workable().front();
    text += ringText(field.outer);
    for (const Ring& hole : field.holes) {
        text += ringText(hole);
    }
    const std::string turns = choiceOf(plan, "path.method");
    const std::string route = choiceOf(plan, "route.method");
    const bool named = route == "boustrophedon" || route == "snake" || route == "spiral";
    std::string order;
    if (!named) {
        for (const RouteStep& step : plan.route.steps) {
            order += std::format("{}{}", order.empty() ? "" : ", ", step.swath);
        }
    }
    std::format_to(
        std::back_inserter(text),
        "headland_mode: {{mode: CONSTANT, width: {:.4f}}}\n"
        "swath_mode: {{objective: LENGTH, mode: SET_ANGLE, best_angle: {:.9f}, step_angle: 0.017453}}\n"
        "route_mode: {{mode: {}, spiral_n: 4, custom_order: [{}]}}\n"
        "path_mode: {{mode: {}, continuity_mode: {}, turn_point_distance: 0.1}}\n",
        plan.headland.width.si(), plan.swaths.heading.si(),
        route == "boustrophedon" ? "BOUSTROPHEDON"
        : route == "snake"       ? "SNAKE"
        : route == "spiral"      ? "SPIRAL"
                                 : "CUSTOM",
        order, turns.starts_with("reeds-shepp") ? "REEDS_SHEPP" : "DUBIN",
        turns.ends_with("-cc") ? "CONTINUOUS" : "DISCONTINUOUS");
    made.notes.emplace_back(
        "opennav_coverage lays swaths and turns of its own from the goal; they need not be those of this plan.");
    made.files.push_back({"compute_coverage_path_goal.yaml", [text = std::move(text)] { return text; }});
    made.files.push_back(frameFile(plan));
    return made;
}

}  // namespace furrow
