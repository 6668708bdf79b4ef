#include "planner/io/formats/geojson/geojson_check.h"

#include "planner/core/file_error.h"
#include "planner/core/text_file.h"

#include <nlohmann/json.hpp>

#include <format>
#include <optional>
#include <vector>

namespace furrow {

namespace {

/// Follows a GeoJSON text without keeping it, to find what GDAL leaves out without a word: positions with
/// something else than two numbers.
class CoordinateCheck final : public nlohmann::json_sax<nlohmann::json> {
public:
    bool foundBad() const { return bad_; }
    /// "feature 2, part 1, ring 1, vertex 3"; only what there is of it.
    const std::string& place() const { return place_; }
    bool brokeOff() const { return brokeOff_.has_value(); }
    std::size_t brokeOffAt() const { return *brokeOff_; }

    bool null() override { return scalar(false); }
    bool boolean(bool) override { return scalar(false); }
    bool number_integer(number_integer_t) override { return scalar(true); }
    bool number_unsigned(number_unsigned_t) override { return scalar(true); }
    bool number_float(number_float_t, const string_t&) override { return scalar(true); }
    bool string(string_t&) override { return scalar(false); }
    bool binary(binary_t&) override { return scalar(false); }

    bool start_object(std::size_t) override {
        if (!levels_.empty()) {
            return scalar(false);
        }
        ++depth_;
        if (key_ == "properties" && propertiesDepth_ == 0) {
            propertiesDepth_ = depth_;
        }
        if (depth_ == featuresDepth_ + 1 && featuresDepth_ > 0) {
            ++feature_;
        }
        key_.clear();
        return true;
    }
    bool end_object() override {
        if (propertiesDepth_ == depth_) {
            propertiesDepth_ = 0;
        }
        --depth_;
        return true;
    }
    bool key(string_t& name) override {
        key_ = name;
        return true;
    }
    bool start_array(std::size_t) override {
        ++depth_;
        if (!levels_.empty()) {
            ++levels_.back().members;
            levels_.back().hasArrays = true;
            levels_.emplace_back();
        } else if (key_ == "coordinates" && propertiesDepth_ == 0) {
            levels_.emplace_back();
        } else if (key_ == "features" && featuresDepth_ == 0 && propertiesDepth_ == 0) {
            featuresDepth_ = depth_;
        }
        key_.clear();
        return true;
    }
    bool end_array() override {
        --depth_;
        if (!levels_.empty()) {
            const Level closed = levels_.back();
            // An empty array stands for an empty geometry, which is allowed.
            if (closed.members == 1 && !closed.hasArrays) {
                return bad();
            }
            levels_.pop_back();
        }
        return true;
    }
    bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception&) override {
        brokeOff_ = position > 0 ? position - 1 : 0;
        return false;
    }

private:
    struct Level {
        std::size_t members = 0;
        bool hasArrays = false;
    };

    bool scalar(bool isNumber) {
        key_.clear();
        if (levels_.empty()) {
            return true;
        }
        if (!isNumber || levels_.back().hasArrays) {
            return bad();
        }
        ++levels_.back().members;
        return true;
    }

    bool bad() {
        bad_ = true;
        if (feature_ > 0) {
            place_ = message("feature {}", feature_);
        }
        // Among positions a member that is none counts itself; inside one the arrays around it count.
        if (levels_.back().hasArrays) {
            ++levels_.back().members;
        } else {
            levels_.pop_back();
        }
        constexpr std::string_view kNames[] = {"vertex", "ring", "part"};
        const std::size_t first = levels_.size() > 3 ? levels_.size() - 3 : 0;
        for (std::size_t i = first; i < levels_.size(); ++i) {
            place_ += std::format("{}{} {}", place_.empty() ? "" : ", ", kNames[levels_.size() - 1 - i],
                                  levels_[i].members);
        }
        return false;
    }

    std::string key_;
    std::size_t depth_ = 0;
    std::size_t propertiesDepth_ = 0;
    std::size_t featuresDepth_ = 0;
    std::size_t feature_ = 0;
    std::vector<Level> levels_;  ///< the arrays of "coordinates" around the current place
    bool bad_ = false;
    std::string place_;
    std::optional<std::size_t> brokeOff_;
};

}  // namespace

Result<void> checkGeoJson(std::string_view text, const std::string& name, bool opened) {
    CoordinateCheck check;
    nlohmann::json::sax_parse(text, &check);
    if (check.foundBad()) {
        return std::unexpected(
            inputRefused(check.place().empty() ? Message{name} : message("{}, {}", name, check.place()),
                         "a coordinate is not a number", "give each point as [longitude, latitude]"));
    }
    if (!opened && check.brokeOff()) {
        return std::unexpected(readFailed(message("{}, {}", name, lineAndColumn(text, check.brokeOffAt())),
                                          "this is not JSON from here on",
                                          "the file may be cut off or damaged; export it again"));
    }
    return {};
}

}  // namespace furrow
