#pragma once

#include "planner/io/delivery/plan_folder.h"
#include "planner/io/formats/registry.h"
#include "tests/planner/io/format_cases.h"
#include "tests/support/scratch.h"

#include <QTemporaryDir>

#include <algorithm>
#include <string_view>
#include <vector>

namespace furrow::test {

/// One plan, written once in every format.
class WrittenPlan {
public:
    WrittenPlan() {
        std::vector<std::string_view> ids;
        for (const Format& format : formats()) {
            if (format.writes()) {
                ids.push_back(format.id);
            }
        }
        result = writePlanFolder(planWithEverything(), folder.path().toStdString(), ids);
    }
    QString file(const QString& name) const { return folder.filePath(name); }
    QByteArray text(const QString& name) const {
        return QByteArray::fromStdString(bytesOf(file(name).toStdString()));
    }

    QTemporaryDir folder;
    Result<WrittenFiles> result;
};

inline const WrittenPlan& writtenPlan() {
    static const WrittenPlan all;
    return all;
}

inline GeoPoint firstPlace() {
    return planWithEverything().field().frame().toGeo(
        planWithEverything().path.segments.front().samples.front().position);
}
inline GeoPoint lastPlace() {
    return planWithEverything().field().frame().toGeo(
        planWithEverything().path.segments.back().samples.back().position);
}

/// If it does not, less is tested than meant.
inline bool pathReverses() {
    return std::ranges::any_of(planWithEverything().path.segments,
                               [](const PathSegment& s) { return s.gear == Gear::Reverse; });
}

}  // namespace furrow::test
