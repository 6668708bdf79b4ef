#pragma once

#include "planner/core/message.h"
#include "planner/geometry/point.h"

#include <string>

namespace furrow {

enum class Severity { Blocking, Note };

/// Something the user must or should know about a plan, with its place.
struct Finding {
    Severity severity = Severity::Note;
    std::string kind;  ///< "outside", "obstacle", "headland", "repair" ...
    Point place;
    Message text;        ///< what and why
    Message suggestion;  ///< what would mend it

    friend bool operator==(const Finding&, const Finding&) = default;
};

}  // namespace furrow
