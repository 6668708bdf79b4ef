#include "planner/io/check/content_checks.h"

#include "planner/core/text.h"
#include "planner/io/content/geo_ring.h"
#include "planner/io/files/file_names.h"
#include "planner/io/formats/registry.h"
#include "planner/plan/plan.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <string_view>

namespace furrow {

namespace {

constexpr double kSamePlaceM = 0.5;
constexpr double kSameSwathEndM = 1e-3;
constexpr double kWidthSlackM = 0.0011;

bool isAscii(std::string_view text) {
    return std::ranges::all_of(text, [](char byte) { return static_cast<unsigned char>(byte) < 0x80; });
}

std::size_t characters(std::string_view text) {
    return static_cast<std::size_t>(std::ranges::count_if(
        text, [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0) != 0x80; }));
}

/// Things that are counted, as they are meant and as they are found.
struct ContentCount {
    std::size_t parts = 0;
    std::size_t holes = 0;
    std::size_t lines = 0;
};

ContentCount meantCount(const ExportJob& job, bool obstaclesAsHoles) {
    ContentCount meant;
    for (const FieldContent& content : job.fields) {
        meant.parts += content.field.parts.size();
        for (const GeoPolygon& part : content.field.parts) {
            meant.holes += part.holes.size();
            for (const Obstacle& obstacle : content.field.obstacles) {
                meant.holes +=
                    obstaclesAsHoles && contains(part.outer, obstacle.outline.outer.front()) ? 1 : 0;
            }
        }
        meant.lines += static_cast<std::size_t>(std::ranges::count_if(
            content.lines, [](const GuidanceLine& line) { return drawn(line, metres(100.0)).size() >= 2; }));
    }
    return meant;
}

ContentCount receivedCount(std::span<const ReceivedContent> contents) {
    ContentCount received;
    for (const ReceivedContent& content : contents) {
        for (const ReceivedArea& area : content.areas) {
            received.parts += area.kind == ReceivedArea::Kind::Field ? 1 : 0;
            received.holes += area.kind == ReceivedArea::Kind::Field ? area.rings.holes.size() : 0;
        }
        received.lines += content.lines.size();
    }
    return received;
}

}  // namespace

void readable(CheckRun& run) {
    run.applied = true;
    for (const ReceivedContent& content : run.contents) {
        for (const Message& fault : content.faults) {
            run.report(content.file, fault);
        }
    }
}

void contentCounted(CheckRun& run) {
    const CarriedContent& carried = run.format.writing.content;
    const ContentCount meant = meantCount(run.job, carried.obstaclesAsHoles);
    const ContentCount received = receivedCount(run.contents);
    const std::string file = run.contents.empty() ? std::string{run.format.id} : run.contents.front().file;
    const auto compare = [&](const char* pattern, std::size_t found, std::size_t wanted) {
        run.applied = true;
        if (found != wanted) {
            run.report(file, message(pattern, found, wanted));
        }
    };
    const bool isPlan = run.job.plan != nullptr;
    if (carried.fields && !(isPlan && carried.pathAlone)) {
        compare("{} boundaries are in it, not {}", received.parts,
                meant.parts + (carried.holesAsFields ? meant.holes : 0));
        if (carried.holes) {
            const bool apart = run.job.options.holesAsObstacles && carried.holesApart;
            compare("{} holes are in it, not {}", received.holes, apart ? 0 : meant.holes);
        }
    }
    if (carried.lines || (carried.swaths && !isPlan)) {
        compare("{} guidance lines are in it, not {}", received.lines, meant.lines);
    } else if (carried.swaths) {
        compare("{} swaths are in it, not {}", received.lines, run.job.plan->route.steps.size());
    }
}

void linesUsable(CheckRun& run) {
    // Nobody steers along the swaths of a map by their ends: they are as short as they are driven.
    const bool areSwaths = run.job.plan != nullptr && run.format.writing.content.swaths;
    const double sameM = areSwaths ? kSameSwathEndM : kSamePlaceM;
    for (const ReceivedContent& content : run.contents) {
        for (const ReceivedLine& line : content.lines) {
            run.applied = true;
            if (line.points.size() < line.fewestPoints) {
                run.report(content.file, message("the line '{}' has fewer than two points", line.name));
                break;
            }
            if (line.points.size() == 2 && roughDistanceM(line.points[0], line.points[1]) < sameM &&
                line.fewestPoints == 2) {
                run.report(content.file, message("A and B of '{}' are the same place", line.name));
                break;
            }
        }
    }
}

void widthsMeant(CheckRun& run) {
    std::vector<double> meant;
    for (const FieldContent& content : run.job.fields) {
        for (const GuidanceLine& line : content.lines) {
            meant.push_back(line.width.value_or(Length{}).si());
        }
    }
    if (run.job.plan != nullptr) {
        for (const Swath& swath : run.job.plan->swaths.swaths) {
            meant.push_back(swath.width.si());
        }
    }
    for (const ReceivedContent& content : run.contents) {
        for (const ReceivedLine& line : content.lines) {
            if (!line.widthM) {
                continue;
            }
            run.applied = true;
            const bool known = std::ranges::any_of(
                meant, [&line](double width) { return std::abs(width - *line.widthM) < kWidthSlackM; });
            if (!known) {
                run.report(content.file,
                           message("'{}' is said to be {:.3f} m wide", line.name, *line.widthM));
                break;
            }
        }
    }
}

void numbersInOrder(CheckRun& run) {
    for (const ReceivedContent& content : run.contents) {
        for (const ReceivedNumbers& order : content.orders) {
            run.applied = true;
            for (std::size_t i = 0; i < order.numbers.size(); ++i) {
                const std::int64_t expected = order.first + static_cast<std::int64_t>(i);
                if (order.numbers[i] != expected) {
                    run.report(content.file, message("{} comes where {} should", order.numbers[i], expected));
                    break;
                }
            }
        }
    }
}

void systemNamed(CheckRun& run) {
    for (const ReceivedContent& content : run.contents) {
        run.applied = run.applied || content.namesCrs.has_value();
        if (content.namesCrs == false) {
            run.report(content.file, "it does not say in which coordinate system it is");
        }
    }
}

void namesUsable(CheckRun& run) {
    for (const ReceivedContent& content : run.contents) {
        for (const ReceivedNames& list : content.names) {
            std::set<std::string> used;
            for (const std::string& name : list.names) {
                run.applied = true;
                const bool twice = list.mustDiffer && !name.empty() && !used.insert(name).second;
                if (list.longest > 0 && characters(name) > list.longest) {
                    run.report(content.file,
                               message("the name '{}' is longer than {} characters", name, list.longest));
                } else if (twice) {
                    run.report(content.file, message("the name '{}' is there twice", name));
                } else if (list.ascii && !isAscii(name)) {
                    run.report(content.file, message("the name '{}' has letters beyond A to Z", name));
                } else if (cutText(name, name.size()) != name) {
                    run.report(content.file,
                               message("the name '{}' has characters that are no letters", name));
                } else {
                    continue;
                }
                break;
            }
        }
    }
}

void fileNamesAllowed(CheckRun& run) {
    std::set<std::string> used;
    for (const FileInMemory& file : run.files) {
        run.applied = true;
        const std::filesystem::path path{file.path};
        bool legal = path.is_relative();
        for (const std::filesystem::path& part : path) {
            legal = legal && part.string() == safeFileName(part.string(), "");
        }
        const std::string name = path.filename().string();
        if (legal && path.has_parent_path() && path.parent_path().filename() == "TASKDATA") {
            const std::size_t dot = name.find('.');
            legal = dot != std::string::npos && dot <= 8 && name.size() - dot <= 4 &&
                    std::ranges::none_of(name, [](char letter) { return letter >= 'a' && letter <= 'z'; });
        }
        if (!legal) {
            run.report(file.path, "some systems do not allow a file of this name");
        }
        if (!used.insert(inSmallLetters(file.path)).second) {
            run.report(file.path, "another file differs from it in capitals only");
        }
    }
}

}  // namespace furrow
