#include "planner/project/history.h"

#include "planner/core/json_text.h"
#include "planner/io/files/file_folder.h"
#include "planner/project/project_edits.h"
#include "planner/project/project_json.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <format>
#include <map>
#include <string_view>
#include <system_error>
#include <utility>

namespace furrow {

namespace {

namespace fs = std::filesystem;

Error writeFailed(const fs::path& path) {
    return {.code = ErrorCode::WriteFailed,
            .what = message("changes cannot be kept for the case of a crash: {}",
                            std::error_code{errno, std::generic_category()}.message()),
            .where = path.string(),
            .remedy = "save the project, and free some space"};
}

/// Fields that are not the same as in another state, ids of all, and the rest.
OrderedJson stateJson(const Project& project, const Project* before) {
    OrderedJson ids = OrderedJson::array();
    OrderedJson changed = OrderedJson::array();
    for (const auto& field : project.fields) {
        ids.push_back(field->id);
        const bool known = before != nullptr && std::ranges::contains(before->fields, field);
        if (!known) {
            changed.push_back({{"features", featuresOf(*field)}, {"plans", plansOf(*field)}});
        }
    }
    return {{"head", headOf(project)}, {"ids", ids}, {"changed", changed}, {"others", project.otherFeatures}};
}

std::shared_ptr<const Project> projectOf(const OrderedJson& state, const Project* before) {
    Notes ignored;
    Project project = Project::empty();
    readHead(state.at("head"), project, ignored);
    std::map<std::string, std::shared_ptr<const ProjectField>> fields;
    if (before != nullptr) {
        for (const auto& field : before->fields) {
            fields[field->id] = field;
        }
    }
    for (const OrderedJson& changed : state.at("changed")) {
        auto field = std::make_shared<const ProjectField>(fieldOf(
            changed.at("features"), changed.at("plans"), project.standard, freePlanId(project), ignored));
        fields[field->id] = std::move(field);
    }
    for (const OrderedJson& id : state.at("ids")) {
        const auto field = fields.find(id.get<std::string>());
        if (field == fields.end()) {
            return nullptr;
        }
        project.fields.push_back(field->second);
    }
    project.otherFeatures = state.at("others").get<std::vector<std::string>>();
    readHead(state.at("head"), project, ignored);
    return std::make_shared<const Project>(std::move(project));
}

/// The state after this many steps.
std::shared_ptr<const Project> stateAt(const History& history, std::size_t steps) {
    return steps == 0 ? history.base : history.steps[steps - 1].after;
}

/// A line with what its bytes come to, so that one that was cut off or damaged is known.
std::string sealed(const OrderedJson& json) {
    const std::string text = textOf(json);
    std::size_t sum = 0;
    for (const char byte : text) {
        sum = (sum * 31 + static_cast<unsigned char>(byte)) % 1'000'000'007;
    }
    return std::format("{} {}\n", sum, text);
}

// A project lies some levels deep in it.
constexpr int kDeepestLine = kDeepestJson + 20;

std::optional<OrderedJson> unsealed(std::string_view line) {
    const std::size_t space = line.find(' ');
    if (space == std::string_view::npos) {
        return std::nullopt;
    }
    OrderedJson json = jsonOrDiscarded<OrderedJson>(line.substr(space + 1), kDeepestLine);
    if (json.is_discarded() || sealed(json) != std::string{line} + "\n") {
        return std::nullopt;
    }
    return json;
}

/// One line read into what was read before it.
bool apply(History& history, const OrderedJson& json) {
    if (json.contains("base")) {
        history = {};
        history.base = projectOf(json.at("base"), nullptr);
        return history.base != nullptr;
    }
    if (history.base == nullptr) {
        return false;
    }
    if (json.contains("step")) {
        const auto step = json.at("step").get<std::size_t>();
        if (step > history.steps.size()) {
            return false;
        }
        history.steps.resize(step);
        auto after = projectOf(json.at("state"), stateAt(history, step).get());
        if (after == nullptr) {
            return false;
        }
        history.steps.push_back({json.at("text").get<std::string>(), std::move(after)});
        return true;
    }
    if (json.at("steps").get<std::size_t>() > history.steps.size()) {
        return false;
    }
    history.steps.resize(json.at("steps").get<std::size_t>());
    history.done = std::min(json.at("done").get<std::size_t>(), history.steps.size());
    history.file =
        fs::path{std::u8string{reinterpret_cast<const char8_t*>(json.at("file").get<std::string>().c_str())}};
    history.savedFingerprint = json.at("fingerprint").get<std::string>();
    history.saved =
        json.at("saved").is_null() ? std::nullopt : std::optional{json.at("saved").get<std::size_t>()};
    return true;
}

}  // namespace

bool recogniseSaved(History& history, const Project& inFile, const std::string& fingerprint) {
    if (history.savedFingerprint == fingerprint) {
        return true;
    }
    // What is merely looked at is no change.
    const Project plain = showing(inFile, 0, 0);
    for (std::size_t steps = history.steps.size() + 1; steps-- > 0;) {
        if (showing(*stateAt(history, steps), 0, 0) == plain) {
            history.savedFingerprint = fingerprint;
            history.saved = steps;
            return true;
        }
    }
    return false;
}

Result<HistoryJournal> HistoryJournal::open(const fs::path& path) {
    std::error_code ignored;
    fs::create_directories(path.parent_path(), ignored);
    const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
    if (file < 0) {
        return std::unexpected(writeFailed(path));
    }
    if (::flock(file, LOCK_EX | LOCK_NB) != 0) {
        ::close(file);
        return std::unexpected(Error{.code = ErrorCode::Usage,
                                     .what = "this project is open in another window of Furrow",
                                     .where = path.string(),
                                     .remedy = "close it there first"});
    }
    return HistoryJournal{path, file};
}

HistoryJournal::~HistoryJournal() {
    if (file_ >= 0) {
        ::close(file_);
    }
}

HistoryJournal::HistoryJournal(HistoryJournal&& other) noexcept
    : path_{std::move(other.path_)},
      file_{std::exchange(other.file_, -1)},
      written_{std::move(other.written_)},
      bytes_{other.bytes_},
      bytesAtRewrite_{other.bytesAtRewrite_} {}

HistoryJournal& HistoryJournal::operator=(HistoryJournal&& other) noexcept {
    std::swap(path_, other.path_);
    std::swap(file_, other.file_);
    std::swap(written_, other.written_);
    std::swap(bytes_, other.bytes_);
    std::swap(bytesAtRewrite_, other.bytesAtRewrite_);
    return *this;
}

std::optional<History> HistoryJournal::read() const {
    const auto bytes = fileBytes(path_);
    if (!bytes) {
        return std::nullopt;
    }
    History history;
    std::string_view rest = *bytes;
    try {
        for (std::size_t end = rest.find('\n'); end != std::string_view::npos; end = rest.find('\n')) {
            const auto json = unsealed(rest.substr(0, end));
            if (!json || !apply(history, *json)) {
                break;
            }
            rest.remove_prefix(end + 1);
        }
    } catch (const OrderedJson::exception&) {
        // What was read up to here is whole.
    }
    if (history.base == nullptr) {
        return std::nullopt;
    }
    history.done = std::min(history.done, history.steps.size());
    if (history.steps.size() > kMostSteps && history.done > 0) {
        const std::size_t dropped = std::min(history.steps.size() - kMostSteps, history.done);
        history.base = stateAt(history, dropped);
        history.steps.erase(history.steps.begin(),
                            history.steps.begin() + static_cast<std::ptrdiff_t>(dropped));
        history.done -= dropped;
        history.saved = history.saved && *history.saved >= dropped ? std::optional{*history.saved - dropped}
                                                                   : std::nullopt;
    }
    return history;
}

std::string HistoryJournal::lineOfRest(const History& history) const {
    const std::u8string file = history.file.u8string();
    OrderedJson saved;
    if (history.saved) {
        saved = *history.saved;
    }
    return sealed({{"steps", history.steps.size()},
                   {"done", history.done},
                   {"file", std::string{file.begin(), file.end()}},
                   {"fingerprint", history.savedFingerprint},
                   {"saved", saved}});
}

Result<void> HistoryJournal::write(const History& history) {
    if (written_.base != history.base || bytes_ > std::max(kLargestBytes, 2 * bytesAtRewrite_)) {
        return rewrite(history);
    }
    std::string text;
    const auto isSame = [](const HistoryStep& a, const HistoryStep& b) { return a.after == b.after; };
    const std::size_t same = static_cast<std::size_t>(
        std::ranges::mismatch(written_.steps, history.steps, isSame).in1 - written_.steps.begin());
    for (std::size_t i = same; i < history.steps.size(); ++i) {
        text += sealed({{"step", i},
                        {"text", history.steps[i].text},
                        {"state", stateJson(*history.steps[i].after, stateAt(history, i).get())}});
    }
    const bool restSame = written_.done == history.done && written_.file == history.file &&
                          written_.savedFingerprint == history.savedFingerprint &&
                          written_.saved == history.saved;
    if (text.empty() && restSame) {
        return {};
    }
    if (const auto appended = append(text + lineOfRest(history)); !appended) {
        // A part of it may be there: the next time everything is written anew.
        written_ = {};
        return appended;
    }
    written_ = history;
    return {};
}

Result<void> HistoryJournal::rewrite(const History& history) {
    std::string text = sealed({{"base", stateJson(*history.base, nullptr)}});
    for (std::size_t i = 0; i < history.steps.size(); ++i) {
        text += sealed({{"step", i},
                        {"text", history.steps[i].text},
                        {"state", stateJson(*history.steps[i].after, stateAt(history, i).get())}});
    }
    text += lineOfRest(history);

    const fs::path part = path_.string() + ".part";
    // What an interrupted run left is replaced. A link of that name would lead elsewhere.
    ::unlink(part.c_str());
    const int file =
        ::open(part.c_str(), O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_APPEND | O_CLOEXEC, 0600);
    if (file < 0) {
        return std::unexpected(writeFailed(part));
    }
    // Locked before it takes the name, so that nobody gets between.
    HistoryJournal fresh{path_, file};
    const bool locked = ::flock(file, LOCK_EX | LOCK_NB) == 0;
    const auto written = locked ? fresh.append(text) : std::unexpected(writeFailed(part));
    if (!written || ::rename(part.c_str(), path_.c_str()) != 0) {
        const Error error = written ? writeFailed(path_) : written.error();
        ::unlink(part.c_str());
        return std::unexpected(error);
    }
    std::swap(file_, fresh.file_);
    bytes_ = fresh.bytes_;
    bytesAtRewrite_ = bytes_;
    written_ = history;
    return {};
}

Result<void> HistoryJournal::append(const std::string& text) {
    std::string_view rest = text;
    while (!rest.empty()) {
        const ssize_t count = ::write(file_, rest.data(), rest.size());
        if (count >= 0) {
            rest.remove_prefix(static_cast<std::size_t>(count));
        } else if (errno != EINTR) {
            return std::unexpected(writeFailed(path_));
        }
    }
    if (::fdatasync(file_) != 0) {
        return std::unexpected(writeFailed(path_));
    }
    bytes_ += text.size();
    return {};
}

void HistoryJournal::remove() {
    ::unlink(path_.c_str());
    written_ = {};
}

}  // namespace furrow
