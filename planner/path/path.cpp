#include "planner/path/path.h"

#include <algorithm>

namespace furrow {

std::string_view segmentKindId(SegmentKind kind) {
    switch (kind) {
        case SegmentKind::Swath: return "swath";
        case SegmentKind::Turn: return "turn";
        case SegmentKind::HeadlandPass: return "headland_pass";
        case SegmentKind::Transfer: return "transfer";
        case SegmentKind::Refill: return "refill";
        case SegmentKind::Wait: return "wait";
    }
    return "";
}

Length Path::length() const {
    return segments.empty() ? Length{} : metres(segments.back().samples.back().sM);
}

Duration Path::duration() const {
    return segments.empty() ? Duration{} : seconds(segments.back().samples.back().tS);
}

Length Path::length(SegmentKind kind) const {
    Length sum;
    for (const PathSegment& segment : segments) {
        if (segment.kind == kind) {
            sum += segment.length();
        }
    }
    return sum;
}

Duration Path::duration(SegmentKind kind) const {
    Duration sum;
    for (const PathSegment& segment : segments) {
        if (segment.kind == kind) {
            sum += segment.duration();
        }
    }
    return sum;
}

int Path::turnCount() const {
    return static_cast<int>(std::ranges::count(segments, SegmentKind::Turn, &PathSegment::kind));
}

int Path::undrivableCount() const {
    return static_cast<int>(std::ranges::count(segments, false, &PathSegment::drivable));
}

}  // namespace furrow
