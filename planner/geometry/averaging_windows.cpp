#include "planner/geometry/averaging_windows.h"

#include <algorithm>

namespace furrow {

AveragingWindows::AveragingWindows(std::span<const double> fromM, std::span<const double> mostM, double endM)
    : placesM_{fromM.begin(), fromM.end()}, mostM_{mostM.begin(), mostM.end()} {
    placesM_.push_back(endM);
    mostM_.push_back(0.0);
    limitsM_.push_back(0.0);
    for (std::size_t i = 0; i + 1 < mostM_.size(); ++i) {
        limitsM_.push_back(std::min(mostM_[i], mostM_[i + 1]));
    }
    for (std::size_t i = 1; i < placesM_.size(); ++i) {
        limitsM_[i] = std::min(limitsM_[i], limitsM_[i - 1] + placesM_[i] - placesM_[i - 1]);
    }
    for (std::size_t i = placesM_.size() - 1; i > 0; --i) {
        limitsM_[i - 1] = std::min(limitsM_[i - 1], limitsM_[i] + placesM_[i] - placesM_[i - 1]);
    }
}

std::size_t AveragingWindows::stretchAt(double m) const {
    const auto after = std::upper_bound(placesM_.begin() + 1, placesM_.end() - 1, m);
    return static_cast<std::size_t>(after - placesM_.begin()) - 1;
}

std::vector<double> AveragingWindows::kinks() const {
    std::vector<double> all = placesM_;
    for (std::size_t i = 0; i + 1 < placesM_.size(); ++i) {
        const double wayM = placesM_[i + 1] - placesM_[i];
        // Rising ends at the bound, or where falling begins.
        const double peakM = std::min(mostM_[i], 0.5 * (limitsM_[i] + limitsM_[i + 1] + wayM));
        all.push_back(placesM_[i] + std::clamp(peakM - limitsM_[i], 0.0, wayM));
        all.push_back(placesM_[i + 1] - std::clamp(peakM - limitsM_[i + 1], 0.0, wayM));
    }
    return all;
}

std::vector<LineRange> AveragingWindows::kept() const {
    std::vector<LineRange> ranges;
    for (std::size_t i = 0; i + 1 < placesM_.size(); ++i) {
        if (mostM_[i] <= kKeptM && placesM_[i + 1] > placesM_[i]) {
            ranges.push_back({placesM_[i], placesM_[i + 1]});
        }
    }
    return ranges;
}

}  // namespace furrow
