#pragma once

#include "planner/benchmarks/paper.h"
#include "planner/io/import/boundary_import.h"
#include "tests/support/large_data.h"

#include <QByteArrayView>
#include <QtEnvironmentVariables>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

namespace furrow::test {

/// Real fields that come with Furrow: the six samples, then the 38 convex ones of the paper's experiments.
inline std::vector<FieldSource> shippedFields() {
    std::vector<FieldSource> fields;
    for (const char* name :
         {"home_field", "bend", "three_ponds", "long_strip", "great_field", "slanted_field"}) {
        const std::string file =
            std::string{FURROW_SOURCE_DIR "/resources/sample_fields/"} + name + ".geojson";
        std::ranges::move(readBoundaries(file).value(), std::back_inserter(fields));
    }
    std::ranges::move(paperFields(), std::back_inserter(fields));
    return fields;
}

inline bool everyFieldIsWanted() {
    return qEnvironmentVariableIsSet("FURROW_EVERY_FIELD");
}

/// For the constructor of a test of all fields: they take longer than the five minutes that QtTest gives a
/// function of its own accord.
inline void allowTimeForEveryField() {
    if (everyFieldIsWanted() && !qEnvironmentVariableIsSet("QTEST_FUNCTION_TIMEOUT")) {
        qputenv("QTEST_FUNCTION_TIMEOUT", "7200000");
    }
}

/// Every n-th of the two thousand real fields beside the project, all of them where the environment has
/// FURROW_EVERY_FIELD; none where they are not there.
inline std::vector<FieldSource> collectedFields(std::size_t every) {
    const std::filesystem::path file = largeDataPath("fields/all_fields.geojson");
    if (!std::filesystem::exists(file)) {
        return {};
    }
    std::vector<FieldSource> all = readBoundaries(file).value();
    if (everyFieldIsWanted()) {
        return all;
    }
    std::vector<FieldSource> some;
    for (std::size_t i = 0; i < all.size(); i += every) {
        some.push_back(std::move(all[i]));
    }
    return some;
}

}  // namespace furrow::test
