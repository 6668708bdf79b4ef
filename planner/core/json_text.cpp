#include "planner/core/json_text.h"

#include "planner/core/text_file.h"

#include <nlohmann/json.hpp>

#include <set>
#include <string>
#include <vector>

namespace furrow {

namespace {

/// The keys of the objects that are being read, to find one that is there twice.
class KeyWatch {
public:
    using Event = nlohmann::json::parse_event_t;

    void see(Event event, const auto& value) {
        if (event == Event::object_start) {
            open_.emplace_back();
        } else if (event == Event::object_end) {
            open_.pop_back();
        } else if (event == Event::key && !open_.back().insert(value).second && twice_.empty()) {
            twice_ = value;
        }
    }
    /// Empty where there is none.
    const std::string& twice() const { return twice_; }

private:
    std::vector<std::set<std::string>> open_;
    std::string twice_;
};

}  // namespace

std::optional<std::size_t> jsonTooDeepAt(std::string_view text, int deepest) {
    int depth = 0;
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (quoted) {
            if (c == '\\') {
                ++i;
            } else if (c == '"') {
                quoted = false;
            }
        } else if (c == '"') {
            quoted = true;
        } else if (c == '[' || c == '{') {
            if (++depth > deepest) {
                return i;
            }
        } else if (c == ']' || c == '}') {
            --depth;
        }
    }
    return std::nullopt;
}

template <class Json>
std::expected<Json, JsonFault> readJson(std::string_view text, JsonKeys keys) {
    text = withoutByteOrderMark(text);
    if (const auto deep = jsonTooDeepAt(text)) {
        return std::unexpected(JsonFault{.what = "lists and objects lie too deep in one another here",
                                         .place = lineAndColumn(text, *deep),
                                         .remedy = "remove what does not belong there"});
    }
    KeyWatch watch;
    Json json;
    try {
        if (keys == JsonKeys::Unique) {
            json = Json::parse(text, [&watch](int, typename Json::parse_event_t event, Json& value) {
                watch.see(static_cast<KeyWatch::Event>(event),
                          value.is_string() ? value.template get<std::string>() : std::string{});
                return true;
            });
        } else {
            json = Json::parse(text);
        }
    } catch (const typename Json::parse_error& error) {
        return std::unexpected(
            JsonFault{.what = "this is not JSON from here on",
                      .place = lineAndColumn(text, error.byte > 0 ? error.byte - 1 : 0),
                      .remedy = "look for a missing comma, quote or brace just before it"});
    } catch (const typename Json::exception&) {
        return std::unexpected(JsonFault{
            .what = "a number is too large to be read", .place = {}, .remedy = "give a smaller number"});
    }
    if (!watch.twice().empty()) {
        return std::unexpected(JsonFault{
            .what = "the key is there twice", .place = watch.twice(), .remedy = "keep one of them"});
    }
    return json;
}

template <class Json>
Json jsonOrDiscarded(std::string_view text, int deepest) {
    text = withoutByteOrderMark(text);
    return jsonTooDeepAt(text, deepest) ? Json(Json::value_t::discarded) : Json::parse(text, nullptr, false);
}

template std::expected<nlohmann::json, JsonFault> readJson(std::string_view, JsonKeys);
template std::expected<nlohmann::ordered_json, JsonFault> readJson(std::string_view, JsonKeys);
template nlohmann::json jsonOrDiscarded(std::string_view, int);
template nlohmann::ordered_json jsonOrDiscarded(std::string_view, int);

}  // namespace furrow
