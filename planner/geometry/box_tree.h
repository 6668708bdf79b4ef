#pragma once

#include "planner/geometry/bounds.h"

#include <cstddef>
#include <vector>

namespace furrow {

/// Boxes in an order in which neighbours lie near each other, like the edges of rings. The order is halved
/// again and again, and each half has a box around it. Immutable; thread-safe.
class BoxTree {
public:
    BoxTree() = default;
    explicit BoxTree(const std::vector<Bounds>& boxes) : size_{boxes.size()} {
        if (size_ > 0) {
            nodes_.reserve(2 * size_);
            build(boxes, 0, size_);
        }
    }

    /// Calls visit(index) for boxes inside boxes for which `matters(box)` holds, until it returns true.
    /// Returns whether it did.
    template <class Matters, class Visit>
    bool any(const Matters& matters, const Visit& visit) const {
        return size_ > 0 && any(0, 0, size_, matters, visit);
    }

private:
    struct Node {
        Bounds box;
        std::size_t second = 0;  ///< index of the upper half; the lower half is the next node
    };

    std::size_t build(const std::vector<Bounds>& boxes, std::size_t first, std::size_t last) {
        const std::size_t self = nodes_.size();
        nodes_.emplace_back();
        if (last - first == 1) {
            nodes_[self].box = boxes[first];
            return self;
        }
        const std::size_t middle = first + (last - first) / 2;
        const std::size_t lower = build(boxes, first, middle);
        const std::size_t upper = build(boxes, middle, last);
        nodes_[self] = {joined(nodes_[lower].box, nodes_[upper].box), upper};
        return self;
    }

    template <class Matters, class Visit>
    bool any(std::size_t node, std::size_t first, std::size_t last, const Matters& matters,
             const Visit& visit) const {
        if (!matters(nodes_[node].box)) {
            return false;
        }
        if (last - first == 1) {
            return visit(first);
        }
        const std::size_t middle = first + (last - first) / 2;
        return any(node + 1, first, middle, matters, visit) ||
               any(nodes_[node].second, middle, last, matters, visit);
    }

    std::size_t size_ = 0;
    std::vector<Node> nodes_;
};

}  // namespace furrow
