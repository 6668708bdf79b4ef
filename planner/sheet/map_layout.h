#pragma once

#include "planner/geometry/point.h"
#include "planner/geometry/polygon.h"

#include <optional>
#include <span>
#include <vector>

namespace furrow {

/// The largest round scale (1 to 1,000, 1,250, 1,500, 1,750, 2,000, 2,500, 3,000, 3,500, 4,000, 4,500, 5,000,
/// 6,000, 7,500, 8,000 and tenfold) at which an extent fits on paper.
///
/// @param extent   metres; not empty
/// @param widthMm, heightMm  of the paper, > 0
/// @return what one millimetre stands for, in millimetres: 2000 for 1 to 2,000; at least 100
double roundMapScale(const Bounds& extent, double widthMm, double heightMm);

/// A place on paper, in millimetres, y downwards, and how much of it is taken.
struct PaperBox {
    Point corner;  ///< upper left
    double width = 0.0;
    double height = 0.0;

    bool overlaps(const PaperBox& other) const;
    bool holds(const PaperBox& other) const;
    friend bool operator==(const PaperBox&, const PaperBox&) = default;
};

/// Something to write on a map, and where its middle may be, the best place first.
struct LabelWish {
    std::vector<Point> places;
    double width = 0.0;
    double height = 0.0;
};

/// Keeps what is written on a map apart.
class LabelPlaces {
public:
    /// Nothing stands out of this box.
    explicit LabelPlaces(const PaperBox& within) : within_{within} {}

    /// What stands there already, whether it overlaps others or not.
    void block(const PaperBox& box) { taken_.push_back(box); }
    /// The first place that is free, which is taken from now on. Empty where there is none.
    /// Cost: O(places × taken).
    std::optional<Point> place(const LabelWish& wish);

private:
    PaperBox within_;
    std::vector<PaperBox> taken_;
};

/// Numbers on lines side by side. Either all of them, or every 2nd, 5th, 10th ..., always with the first and
/// the last: the finest of these steps that leaves room for nearly all it names.
///
/// @param wishes  one for each line, in the order of their numbers, which count from 1
/// @param places  takes those that are written
/// @return for each line where its number stands; empty for none
std::vector<std::optional<Point>> placeNumbers(std::span<const LabelWish> wishes, LabelPlaces& places);

/// The point of a line at this share of its length, in [0, 1], and the way it goes there (a unit vector; zero
/// for a line without length).
struct PointOnLine {
    Point place;
    Point way;
};
PointOnLine pointAt(std::span<const Point> line, double share);

}  // namespace furrow
