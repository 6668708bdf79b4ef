#pragma once

#include "tests/support/geo_rings.h"

#include <QString>

#include <filesystem>

namespace furrow::test {

/// The field of tests/data/imports/README.md, by hand.
inline const GeoPolygon kNorthField{
    .outer = {{9.0, 52.0}, {9.003, 52.0}, {9.003, 52.002}, {9.0, 52.002}},
    .holes = {{{9.001, 52.0005}, {9.001, 52.0015}, {9.002, 52.0015}, {9.002, 52.0005}}}};

inline constexpr double kToleranceM = 0.001;

inline std::filesystem::path dataFile(const QString& name) {
    return std::filesystem::path{FURROW_TEST_DATA_DIR} / "imports" / name.toStdString();
}

inline bool isNorthField(const FieldSource& field) {
    return field.parts.size() == 1 && samePolygon(field.parts[0], kNorthField, kToleranceM);
}

}  // namespace furrow::test
