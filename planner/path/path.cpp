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

std::optional<SegmentKind> segmentKindFrom(std::string_view id) {
    for (const SegmentKind kind : {SegmentKind::Swath, SegmentKind::Turn, SegmentKind::HeadlandPass,
                                   SegmentKind::Transfer, SegmentKind::Refill, SegmentKind::Wait}) {
        if (segmentKindId(kind) == id) {
            return kind;
        }
    }
    return std::nullopt;
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

Length Path::workedLength() const {
    return length(SegmentKind::Swath) + length(SegmentKind::HeadlandPass);
}

Duration Path::workedDuration() const {
    return duration(SegmentKind::Swath) + duration(SegmentKind::HeadlandPass);
}

Length Path::reversedLength() const {
    Length sum;
    for (const PathSegment& segment : segments) {
        if (segment.gear == Gear::Reverse) {
            sum += segment.length();
        }
    }
    return sum;
}

int Path::turnCount() const {
    int count = 0;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const bool begins = i == 0 || segments[i - 1].kind != SegmentKind::Turn;
        count += segments[i].kind == SegmentKind::Turn && begins ? 1 : 0;
    }
    return count;
}

int Path::undrivableCount() const {
    int count = 0;
    bool counted = false;
    for (const PathSegment& segment : segments) {
        if (segment.kind != SegmentKind::Turn && segment.kind != SegmentKind::Transfer &&
            segment.kind != SegmentKind::Refill) {
            counted = false;
        } else if (!segment.drivable && !counted) {
            ++count;
            counted = true;
        }
    }
    return count;
}

int Path::refillCount() const {
    return static_cast<int>(std::ranges::count(segments, true, &PathSegment::refills));
}

const PathSegment* Path::workBefore(std::size_t segment) const {
    while (segment > 0) {
        if (segments[--segment].implementDown) {
            return &segments[segment];
        }
    }
    return nullptr;
}

const PathSegment* Path::workAfter(std::size_t segment) const {
    while (++segment < segments.size()) {
        if (segments[segment].implementDown) {
            return &segments[segment];
        }
    }
    return nullptr;
}

bool isWayInOrOut(std::span<const PathSegment> segments, std::size_t segment) {
    const auto works = [](const PathSegment& one) { return one.implementDown; };
    return !works(segments[segment]) && (std::ranges::none_of(segments.first(segment), works) ||
                                         std::ranges::none_of(segments.subspan(segment), works));
}

Message nameOf(const PathSegment& segment) {
    return passName(segment.kind, segment.number);
}

Message passName(SegmentKind kind, int number) {
    return kind == SegmentKind::HeadlandPass ? message("headland pass {}", number)
                                             : message("swath {}", number);
}

}  // namespace furrow
