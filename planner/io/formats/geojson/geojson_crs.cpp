#include "planner/io/formats/geojson/geojson_crs.h"

#include "planner/core/file_error.h"
#include "planner/core/text.h"
#include "planner/gdal/named_system.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

namespace furrow {

namespace {

using CrsJson = nlohmann::json;

/// A coordinate system as it stands in the text.
struct Found {
    std::size_t feature = 0;  ///< from 1; 0 of the whole file
    bool ofFile = false;      ///< of the outermost object
    CrsJson value;
};

/// Follows a GeoJSON text and keeps the values of `crs` and `coordRefSys` where GeoJSON has a place for them.
class CrsFinder final : public nlohmann::json_sax<CrsJson> {
public:
    std::vector<Found> found;

    bool null() override { return value(nullptr); }
    bool boolean(bool flag) override { return value(flag); }
    bool number_integer(number_integer_t number) override { return value(number); }
    bool number_unsigned(number_unsigned_t number) override { return value(number); }
    bool number_float(number_float_t number, const string_t&) override { return value(number); }
    bool string(string_t& text) override { return value(text); }
    bool binary(binary_t&) override { return true; }

    bool start_object(std::size_t) override { return open(CrsJson::object()); }
    bool start_array(std::size_t) override { return open(CrsJson::array()); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }
    bool key(string_t& name) override {
        key_ = name;
        return true;
    }
    /// What is no JSON is told elsewhere; GDAL reads some of it all the same.
    bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override {
        return false;
    }

private:
    enum class Place { Root, Features, Feature, Geometries, Geometry, Other };

    bool isCrs() const {
        return !places_.empty() && (key_ == "crs" || key_ == "coordRefSys") &&
               (places_.back() == Place::Root || places_.back() == Place::Feature ||
                places_.back() == Place::Geometry);
    }

    Place placeBelow(bool isArray) const {
        if (places_.empty()) {
            return Place::Root;
        }
        switch (places_.back()) {
            case Place::Features: return Place::Feature;
            case Place::Geometries: return Place::Geometry;
            case Place::Other: return Place::Other;
            default: break;
        }
        if (isArray) {
            return key_ == "features"     ? Place::Features
                   : key_ == "geometries" ? Place::Geometries
                                          : Place::Other;
        }
        return key_ == "geometry" || key_ == "place" ? Place::Geometry : Place::Other;
    }

    Found made(CrsJson value) const {
        return {.feature = feature_, .ofFile = places_.back() == Place::Root, .value = std::move(value)};
    }

    bool open(CrsJson empty) {
        if (!kept_.empty()) {
            kept_.push_back(&add(std::move(empty)));
        } else if (isCrs()) {
            found.push_back(made(std::move(empty)));
            kept_.push_back(&found.back().value);
        } else {
            places_.push_back(placeBelow(empty.is_array()));
            feature_ += places_.back() == Place::Feature ? 1 : 0;
        }
        key_.clear();
        return true;
    }

    bool close() {
        if (!kept_.empty()) {
            kept_.pop_back();
        } else {
            places_.pop_back();
        }
        return true;
    }

    bool value(CrsJson scalar) {
        if (!kept_.empty()) {
            add(std::move(scalar));
        } else if (isCrs()) {
            found.push_back(made(std::move(scalar)));
        }
        key_.clear();
        return true;
    }

    CrsJson& add(CrsJson member) {
        CrsJson& around = *kept_.back();
        if (around.is_array()) {
            around.push_back(std::move(member));
            return around.back();
        }
        return around[key_] = std::move(member);
    }

    std::string key_;
    std::size_t feature_ = 0;
    std::vector<Place> places_;
    std::vector<CrsJson*> kept_;  ///< objects and arrays around the current place, within a coordinate system
};

std::string wordIn(const CrsJson& object, const char* key) {
    const auto member = object.is_object() ? object.find(key) : object.end();
    return member == object.end() ? std::string{}
           : member->is_string()  ? member->get<std::string>()
                                  : member->dump();
}

bool isLink(const CrsJson& crs) {
    const std::string type = inSmallLetters(wordIn(crs, "type"));
    return type == "link" || type == "url";
}

/// What it is called, as GeoJSON of 2008 writes it, and as JSON-FG does.
std::string nameIn(const CrsJson& crs) {
    if (crs.is_string()) {
        const std::string name = crs.get<std::string>();
        return name.starts_with('[') && name.ends_with(']') ? name.substr(1, name.size() - 2) : name;
    }
    const std::string type = inSmallLetters(wordIn(crs, "type"));
    const CrsJson properties = crs.is_object() ? crs.value("properties", CrsJson{}) : CrsJson{};
    return type == "name"        ? wordIn(properties, "name")
           : type == "epsg"      ? "EPSG:" + wordIn(properties, "code")
           : type == "ogc"       ? wordIn(properties, "urn")
           : type == "reference" ? wordIn(crs, "href")
                                 : crs.dump();
}

Error refused(const Found& found, const std::string& name, Message what, Message remedy) {
    return inputRefused(
        found.feature == 0 ? Message{name} : message("{}, {}", name, message("feature {}", found.feature)),
        std::move(what), std::move(remedy));
}

/// The name of a system that is known.
Result<std::string> knownName(const Found& found, const std::string& name) {
    constexpr const char* kRemedy = "export the field again in WGS84 (longitude and latitude)";
    if (isLink(found.value)) {
        const CrsJson properties = found.value.value("properties", CrsJson{});
        const std::string href = wordIn(properties, "href");
        return std::unexpected(refused(found, name,
                                       message("its coordinate system would have to be fetched from '{}'",
                                               href.empty() ? wordIn(properties, "url") : href),
                                       kRemedy));
    }
    std::string called = nameIn(found.value);
    if (!isKnownSystem(called)) {
        return std::unexpected(refused(
            found, name, message("its coordinate system '{}' is not known", called.substr(0, 200)), kRemedy));
    }
    return called;
}

std::vector<std::string_view> recordsOf(std::string_view text, bool sequence) {
    if (!sequence) {
        return {text};
    }
    const char separator = text.contains('\x1e') ? '\x1e' : '\n';
    std::vector<std::string_view> records;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find(separator, at), text.size());
        records.push_back(text.substr(at, end - at));
        at = end + 1;
    }
    return records;
}

}  // namespace

Result<bool> checkCrs(std::string_view text, bool sequence, const std::string& name) {
    std::vector<Found> all;
    std::size_t records = 0;
    for (const std::string_view record : recordsOf(text, sequence)) {
        CrsFinder finder;
        CrsJson::sax_parse(record, &finder, nlohmann::detail::input_format_t::json, true, true);
        ++records;
        for (Found& found : finder.found) {
            // A record is a feature of the file.
            found.feature = sequence ? records : found.feature;
            found.ofFile = found.ofFile && !sequence;
            all.push_back(std::move(found));
        }
    }
    bool isNull = false;
    std::string ofFile = "WGS84";
    std::ranges::stable_sort(all, std::greater{}, &Found::ofFile);
    for (const Found& found : all) {
        if (found.value.is_null()) {
            isNull = isNull || found.ofFile;
            continue;
        }
        const auto system = knownName(found, name);
        if (!system) {
            return std::unexpected(system.error());
        }
        if (found.ofFile) {
            ofFile = *system;
        } else if (!areSameSystem(*system, ofFile)) {
            return std::unexpected(refused(found, name, "it has another coordinate system than the file",
                                           "export the fields again in one coordinate system"));
        }
    }
    return isNull;
}

}  // namespace furrow
