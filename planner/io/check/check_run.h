#pragma once

#include "planner/core/file_in_memory.h"
#include "planner/io/content/export_job.h"
#include "planner/io/content/received_content.h"

#include <algorithm>
#include <span>
#include <string>
#include <vector>

namespace furrow {

struct Format;

/// The checks of one export: what they look at, and where they report. One report for each kind of mistake
/// and file is enough.
struct CheckRun {
    const ExportJob& job;
    const Format& format;
    std::span<const FileInMemory> files;
    std::span<const ReceivedContent> contents;
    std::vector<Message>& problems;
    bool applied = false;  ///< the check that runs had something to look at

    void report(const std::string& file, const Message& problem) {
        problems.push_back(message("Receivers may refuse {}: {}.", file, problem));
    }
};

/// The common signature of all checks.
using ExportCheck = void(CheckRun& run);

/// `visit(ring, isOuter)`.
template <class Visit>
void forEachRing(const ReceivedArea& area, const Visit& visit) {
    visit(area.rings.outer, true);
    for (const GeoRing& hole : area.rings.holes) {
        visit(hole, false);
    }
}

/// Every place of a file that is given in degrees.
template <class Visit>
void forEachPlace(const ReceivedContent& content, const Visit& visit) {
    for (const ReceivedArea& area : content.areas) {
        forEachRing(area, [&visit](const GeoRing& ring, bool) { std::ranges::for_each(ring, visit); });
    }
    for (const ReceivedLine& line : content.lines) {
        std::ranges::for_each(line.points, visit);
    }
    std::ranges::for_each(content.points, visit);
    for (const ReceivedPath& path : content.paths) {
        for (const ReceivedSample& sample : path.samples) {
            if (!sample.isLocal) {
                visit(sample.geo);
            }
        }
    }
}

}  // namespace furrow
