#pragma once

#include "ui/map/mesh.h"

#include <memory>
#include <vector>

namespace furrow {

/// Coasts and borders of one level of detail, cut into pieces that can be left out where they are not in
/// view.
struct WorldLevel {
    struct Lines {
        QRectF box;
        LineMesh mesh;
    };
    struct Land {
        QRectF box;
        FillMesh mesh;
    };
    std::vector<Land> land;
    std::vector<Lines> coasts;
    std::vector<Lines> borders;
};

/// The embedded outline of the world, in units around the middle of the map. Levels from coarse to fine.
struct WorldOutline {
    std::vector<WorldLevel> levels;
};

/// Reads the embedded file (see resources/map/README.md). Takes some 100 ms: call it from a worker.
std::shared_ptr<const WorldOutline> readWorldOutline();

}  // namespace furrow
