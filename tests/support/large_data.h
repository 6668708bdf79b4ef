#pragma once

#include <QString>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace furrow::test {

/// A file of the large collection of real fields, machine files, tracks and maps, from which longer tests
/// are fed: in the folder that FURROW_TEST_DATA names, otherwise in ../shared/data beside the project. It may
/// be missing: tests are skipped then.
inline std::filesystem::path largeDataPath(const std::string& file) {
    const char* const folder = std::getenv("FURROW_TEST_DATA");
    return std::filesystem::path{folder != nullptr ? folder : FURROW_SOURCE_DIR "/../shared/data"} / file;
}

inline QString largeData(const QString& file) {
    return QString::fromStdString(largeDataPath(file.toStdString()).string());
}

}  // namespace furrow::test
