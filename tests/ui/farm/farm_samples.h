#pragma once

#include "planner/project/project_edits.h"
#include "tests/support/field_generator.h"

#include <format>

namespace furrow::test {

/// So many rectangular fields, each longer than the one before, in rows of six: 1, 1.1, 1.2 ... ha: "Field
/// 1", "Field 2" ...
inline Project farmOf(int count, double widthM = 100.0, double moreM = 10.0) {
    std::vector<FieldSource> fields;
    for (int i = 0; i < count; ++i) {
        FieldSource field =
            fieldSourceFromLocal({rectangle(widthM + moreM * i, widthM)},
                                 {.lonDeg = 22.5 + 0.01 * (i % 6), .latDeg = 58.25 + 0.004 * (i / 6)});
        field.id = std::format("f{}", i + 1);
        field.name = std::format("Field {}", i + 1);
        fields.push_back(std::move(field));
    }
    return showing(withFields(Project::empty(), std::move(fields)), 0, 0);
}

}  // namespace furrow::test
