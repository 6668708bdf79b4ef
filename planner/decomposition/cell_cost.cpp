#include "planner/decomposition/cell_cost.h"

#include "planner/turns/connection.h"
#include "planner/turns/dubins.h"
#include "planner/units/angle.h"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

namespace furrow {

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
// Number of nearest ends that each end of a cell is matched with.
constexpr std::size_t kNearest = 14;
// With up to 8 pieces, all ends are near each other, and exact ways improve the sequence. With up to 200,
// rough ways do. Pieces are counted, not cells: otherwise estimates before and after a join could not be
// compared.
constexpr std::size_t kFew = kNearest / 2 + 1;
constexpr std::size_t kMany = 200;
constexpr int kMostRounds = 20;
// A sequence that gains less counts as equal.
constexpr double kSameS = 1e-6;

}  // namespace

CellCost::CellCost(const SwathSet& swaths, const Machine& machine,
                   std::vector<std::vector<std::size_t>> pieces)
    : swaths_{swaths}, machine_{machine} {
    for (std::vector<std::size_t>& indices : pieces) {
        Piece piece{.swaths = std::move(indices)};
        for (std::size_t i = 1; i < piece.swaths.size(); ++i) {
            for (const std::size_t side : {0U, 1U}) {
                // From a swath's start, the first turn is at its end, the second at the start of the next.
                const std::size_t at = (side + i) % 2;
                piece.turning[side] += linkSeconds(2 * piece.swaths[i - 1] + at, 2 * piece.swaths[i] + at);
            }
        }
        pieces_.push_back(std::move(piece));
    }
    const auto driven = static_cast<std::size_t>(
        std::ranges::count_if(pieces_, [](const Piece& piece) { return !piece.swaths.empty(); }));
    areFew_ = driven <= kFew;
    findLinks();
    if (pieces_.size() <= kMany) {
        findRoughSeconds();
    }
}

double CellCost::linkSeconds(Port leaving, Port arriving) const {
    const auto pose = [this](Port port, bool isLeaving) {
        const Swath& swath = swaths_.swaths[port / 2];
        const bool isAtEnd = port % 2 == 1;
        // Forwards if its end is left, or if its start is driven onto.
        const Angle along = swath.isCurved() ? lineOf(swath).start.heading : swaths_.heading;
        const Angle heading = isAtEnd == isLeaving ? along : along + degrees(180.0);
        return vehicleAt(
            {.position = isAtEnd ? swath.end : swath.start, .heading = normalisedPoseHeading(heading)},
            machine_);
    };
    const Length curve =
        dubinsLength(pose(leaving, true), pose(arriving, false), machine_.minTurningRadius());
    return (curve + machine_.runIn()).si() / machine_.turningSpeed().si();
}

std::size_t CellCost::swathAt(Corner corner) const {
    const Piece& piece = pieces_[corner / 4];
    return corner % 4 >= 2 ? piece.swaths.back() : piece.swaths.front();
}

double CellCost::cornerSeconds(Corner leaving, Corner arriving) const {
    return linkSeconds(2 * swathAt(leaving) + leaving % 2, 2 * swathAt(arriving) + arriving % 2);
}

void CellCost::findLinks() {
    std::vector<Corner> ends;
    for (std::size_t piece = 0; piece < pieces_.size(); ++piece) {
        if (!isEmpty(piece)) {
            ends.push_back(4 * piece);
            ends.push_back(4 * piece + 2);
        }
    }
    const auto apart = [&](Corner a, Corner b) {
        const Swath& from = swaths_.swaths[swathAt(a)];
        const Swath& to = swaths_.swaths[swathAt(b)];
        return std::min({distance(from.start, to.start), distance(from.end, to.end),
                         distance(from.start, to.end), distance(from.end, to.start)});
    };
    std::vector<std::pair<double, Corner>> others;
    for (const Corner a : ends) {
        others.clear();
        for (const Corner b : ends) {
            if (a / 4 != b / 4) {
                others.emplace_back(apart(a, b), b);
            }
        }
        const std::size_t count = std::min(kNearest, others.size());
        std::ranges::partial_sort(others, others.begin() + static_cast<std::ptrdiff_t>(count));
        for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t sides = 0; sides < 4; ++sides) {
                const Corner from = std::min(a, others[i].second) + sides % 2;
                const Corner to = std::max(a, others[i].second) + sides / 2;
                links_.push_back({.seconds = cornerSeconds(from, to), .from = from, .to = to});
            }
        }
    }
    const auto key = [](const Link& link) { return std::tuple{link.seconds, link.from, link.to}; };
    std::ranges::sort(links_, {}, key);
    const auto doubles = std::ranges::unique(links_, {}, key);
    links_.erase(doubles.begin(), doubles.end());
}

void CellCost::findRoughSeconds() {
    const std::size_t count = 4 * pieces_.size();
    roughSeconds_.assign(count * count, 0.0);
    const auto place = [this](Corner corner) {
        const Swath& swath = swaths_.swaths[swathAt(corner)];
        return corner % 2 == 1 ? swath.end : swath.start;
    };
    for (Corner a = 0; a < count; ++a) {
        for (Corner b = 0; b < count; ++b) {
            if (!isEmpty(a / 4) && !isEmpty(b / 4)) {
                roughSeconds_[a * count + b] = distance(place(a), place(b)) / machine_.turningSpeed().si();
            }
        }
    }
    for (const Link& link : links_) {
        roughSeconds_[link.from * count + link.to] = roughSeconds_[link.to * count + link.from] =
            link.seconds;
    }
}

std::vector<CellCost::Cell> CellCost::cellsOf(const Groups& groups) const {
    // In the order of their first pieces with swaths, since other pieces change nothing.
    std::vector<std::size_t> order;
    std::vector<std::size_t> first(pieces_.size(), pieces_.size());
    for (std::size_t piece = 0; piece < pieces_.size(); ++piece) {
        if (!isEmpty(piece)) {
            order.push_back(piece);
            first[groups[piece]] = std::min(first[groups[piece]], piece);
        }
    }
    std::ranges::sort(order, {}, [&](std::size_t piece) {
        return std::pair{first[groups[piece]], pieces_[piece].swaths.front()};
    });
    std::vector<Cell> cells;
    for (const std::size_t index : order) {
        const Piece& piece = pieces_[index];
        const bool isOdd = piece.swaths.size() % 2 == 1;
        if (cells.empty() || groups[cells.back().firstPiece] != groups[index]) {
            cells.push_back({.firstPiece = index,
                             .lastPiece = index,
                             .firstSwath = piece.swaths.front(),
                             .lastSwath = piece.swaths.back(),
                             .isOdd = isOdd,
                             .turning = piece.turning});
            continue;
        }
        Cell& cell = cells.back();
        for (const std::size_t side : {0U, 1U}) {
            // After an odd number of swaths the machine is at the other side and continues from there.
            const std::size_t at = cell.across(side);
            cell.turning[side] +=
                linkSeconds(2 * cell.lastSwath + at, 2 * piece.swaths.front() + at) + piece.turning[at];
        }
        cell.lastPiece = index;
        cell.lastSwath = piece.swaths.back();
        cell.isOdd = cell.isOdd != isOdd;
    }
    return cells;
}

CellCost::Corner CellCost::entered(const std::vector<Cell>& cells, const Visit& visit) const {
    const Cell& cell = cells[visit.cell];
    return visit.fromLast ? 4 * cell.lastPiece + 2 + cell.across(visit.side)
                          : 4 * cell.firstPiece + visit.side;
}

CellCost::Corner CellCost::left(const std::vector<Cell>& cells, const Visit& visit) const {
    return entered(cells, {.cell = visit.cell, .fromLast = !visit.fromLast, .side = visit.side});
}

CellCost::MatchedEnds CellCost::matchedEnds(const std::vector<Cell>& cells) const {
    // Ends of cells: 2 × cell + 1 at its last swath.
    std::vector<std::size_t> endOfPiece(2 * pieces_.size(), kNone);
    for (std::size_t cell = 0; cell < cells.size(); ++cell) {
        endOfPiece[2 * cells[cell].firstPiece] = 2 * cell;
        endOfPiece[2 * cells[cell].lastPiece + 1] = 2 * cell + 1;
    }
    MatchedEnds matched{.partner = std::vector<std::size_t>(2 * cells.size(), kNone),
                        .sides = std::vector<std::size_t>(cells.size(), kNone)};
    auto& [partner, sides] = matched;
    // The other end of the chain of an end.
    std::vector<std::size_t> farEnd(2 * cells.size());
    for (std::size_t end = 0; end < farEnd.size(); ++end) {
        farEnd[end] = end ^ 1U;
    }
    const auto sideFor = [&](std::size_t end, std::size_t side) {
        return end % 2 == 1 ? cells[end / 2].across(side) : side;
    };
    const auto isFree = [&](std::size_t end, std::size_t side) {
        return end != kNone && partner[end] == kNone &&
               (sides[end / 2] == kNone || sides[end / 2] == sideFor(end, side));
    };
    for (const Link& link : links_) {
        const std::size_t a = endOfPiece[link.from / 2];
        const std::size_t b = endOfPiece[link.to / 2];
        if (isFree(a, link.from % 2) && isFree(b, link.to % 2) && farEnd[a] != b) {
            sides[a / 2] = sideFor(a, link.from % 2);
            sides[b / 2] = sideFor(b, link.to % 2);
            partner[a] = b;
            partner[b] = a;
            const std::size_t first = farEnd[a];
            const std::size_t last = farEnd[b];
            farEnd[first] = last;
            farEnd[last] = first;
        }
    }
    return matched;
}

std::vector<CellCost::Visit> CellCost::sequenceOf(const std::vector<Cell>& cells) const {
    auto [partner, sides] = matchedEnds(cells);
    // The matched cells form chains. Each chain is followed by the nearest one.
    std::vector<Visit> sequence;
    std::vector<bool> isDone(cells.size(), false);
    while (sequence.size() < cells.size()) {
        Visit next{};
        double least = kInfinite;
        for (std::size_t end = 0; end < partner.size(); ++end) {
            for (const std::size_t side : {0U, 1U}) {
                if (isDone[end / 2] || partner[end] != kNone ||
                    (sides[end / 2] != kNone && sides[end / 2] != side)) {
                    continue;
                }
                const Visit visit{.cell = end / 2, .fromLast = end % 2 == 1, .side = side};
                const double seconds =
                    sequence.empty() ? 0.0
                                     : cornerSeconds(left(cells, sequence.back()), entered(cells, visit));
                if (seconds < least) {
                    least = seconds;
                    next = visit;
                }
            }
        }
        sides[next.cell] = next.side;
        for (std::size_t end = 2 * next.cell + (next.fromLast ? 1 : 0); end != kNone;
             end = partner[end ^ 1U]) {
            isDone[end / 2] = true;
            sequence.push_back({.cell = end / 2, .fromLast = end % 2 == 1, .side = sides[end / 2]});
        }
    }
    return sequence;
}

double CellCost::secondsOf(const std::vector<Cell>& cells, const std::vector<Visit>& sequence) const {
    const bool areKnown = areFew_ && !roughSeconds_.empty();
    const auto way = [&](Corner from, Corner to) {
        return areKnown ? roughSeconds_[from * 4 * pieces_.size() + to] : cornerSeconds(from, to);
    };
    BySide soFar{};
    for (std::size_t i = 0; i < sequence.size(); ++i) {
        BySide next{kInfinite, kInfinite};
        for (const std::size_t side : {0U, 1U}) {
            Visit here = sequence[i];
            here.side = side;
            const double turning = cells[here.cell].turning[side];
            if (i == 0) {
                next[side] = turning;
                continue;
            }
            for (const std::size_t sideBefore : {0U, 1U}) {
                Visit before = sequence[i - 1];
                before.side = sideBefore;
                next[side] = std::min(
                    next[side], soFar[sideBefore] + way(left(cells, before), entered(cells, here)) + turning);
            }
        }
        soFar = next;
    }
    return sequence.empty() ? 0.0 : std::min(soFar[0], soFar[1]);
}

void CellCost::turnRound(std::vector<Visit>& sequence, std::size_t first, std::size_t last) {
    std::reverse(sequence.begin() + static_cast<std::ptrdiff_t>(first),
                 sequence.begin() + static_cast<std::ptrdiff_t>(last) + 1);
    for (std::size_t at = first; at <= last; ++at) {
        sequence[at].fromLast = !sequence[at].fromLast;
    }
}

void CellCost::improveRoughly(const std::vector<Cell>& cells, std::vector<Visit>& sequence) const {
    const std::size_t count = 4 * pieces_.size();
    const auto way = [&](const Visit& from, const Visit& to) {
        return roughSeconds_[left(cells, from) * count + entered(cells, to)];
    };
    const auto around = [&](std::size_t i, const Visit& visit) {
        return (i > 0 ? way(sequence[i - 1], visit) : 0.0) +
               (i + 1 < sequence.size() ? way(visit, sequence[i + 1]) : 0.0) +
               cells[visit.cell].turning[visit.side];
    };
    const auto turned = [](Visit visit) {
        visit.fromLast = !visit.fromLast;
        return visit;
    };
    bool isBetter = true;
    for (int round = 0; isBetter && round < kMostRounds; ++round) {
        isBetter = false;
        for (std::size_t i = 0; i < sequence.size(); ++i) {
            Visit otherSide = sequence[i];
            otherSide.side = 1 - otherSide.side;
            if (around(i, otherSide) < around(i, sequence[i]) - kSameS) {
                sequence[i] = otherSide;
                isBetter = true;
            }
            for (std::size_t k = i; k < sequence.size(); ++k) {
                double gain = 0.0;
                if (i > 0) {
                    gain += way(sequence[i - 1], sequence[i]) - way(sequence[i - 1], turned(sequence[k]));
                }
                if (k + 1 < sequence.size()) {
                    gain += way(sequence[k], sequence[k + 1]) - way(turned(sequence[i]), sequence[k + 1]);
                }
                if (gain > kSameS) {
                    turnRound(sequence, i, k);
                    isBetter = true;
                }
            }
        }
    }
}

void CellCost::improve(const std::vector<Cell>& cells, std::vector<Visit>& sequence, double& seconds) const {
    bool isBetter = true;
    const auto tryOther = [&](std::vector<Visit> changed) {
        if (const double other = secondsOf(cells, changed); other < seconds - kSameS) {
            seconds = other;
            sequence = std::move(changed);
            isBetter = true;
        }
    };
    while (isBetter) {
        isBetter = false;
        for (std::size_t i = 0; i < sequence.size(); ++i) {
            for (std::size_t k = 0; k < sequence.size(); ++k) {
                std::vector<Visit> changed = sequence;
                if (k >= i) {
                    turnRound(changed, i, k);
                    tryOther(std::move(changed));
                    changed = sequence;
                }
                // One cell at another place, in both directions.
                const Visit visit = changed[i];
                changed.erase(changed.begin() + static_cast<std::ptrdiff_t>(i));
                changed.insert(changed.begin() + static_cast<std::ptrdiff_t>(k), visit);
                tryOther(changed);
                changed[k].fromLast = !changed[k].fromLast;
                tryOther(std::move(changed));
            }
        }
    }
}

Duration CellCost::of(const Groups& groups) const {
    const std::vector<Cell> cells = cellsOf(groups);
    std::vector<Visit> sequence = sequenceOf(cells);
    if (!areFew_ && !roughSeconds_.empty()) {
        improveRoughly(cells, sequence);
    }
    double sum = secondsOf(cells, sequence);
    if (areFew_) {
        improve(cells, sequence, sum);
    }
    return seconds(sum);
}

}  // namespace furrow
