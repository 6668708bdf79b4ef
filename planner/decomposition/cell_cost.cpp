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
// Ends of cells are matched with so many of those nearest to them first.
constexpr std::size_t kNearest = 12;
// Sequences of so few pieces are improved by exact ways, of so many by rough ones. Not cells: estimates before and after a
// join could not be compared.
constexpr std::size_t kFew = 8;
constexpr std::size_t kMany = 200;
constexpr int kMostRounds = 20;
// A sequence that is quicker by less is the same.
constexpr double kSameS = 1e-6;

}  // namespace

CellCost::CellCost(const SwathSet& swaths, const Machine& machine, std::vector<std::vector<std::size_t>> pieces)
    : swaths_{swaths}, machine_{machine} {
    for (std::vector<std::size_t>& indices : pieces) {
        Piece piece{.swaths = std::move(indices)};
        for (std::size_t i = 1; i < piece.swaths.size(); ++i) {
            for (const std::size_t side : {0U, 1U}) {
                // Begun at a swath's start, the first turn is at its end, the second at the start of the next.
                const std::size_t at = (side + i) % 2;
                piece.turning[side] += linkSeconds(2 * piece.swaths[i - 1] + at, 2 * piece.swaths[i] + at);
            }
        }
        pieces_.push_back(std::move(piece));
    }
    const auto driven = static_cast<std::size_t>(std::ranges::count_if(pieces_, [](const Piece& piece) { return !piece.swaths.empty(); }));
    areFew_ = driven <= kFew;
    findLinks();
    if (!areFew_ && pieces_.size() <= kMany) {
        findRoughSeconds();
    }
}

double CellCost::linkSeconds(Port leaving, Port arriving) const {
    const auto pose = [this](Port port, bool isLeaving) {
        const Swath& swath = swaths_.swaths[port / 2];
        const bool isAtEnd = port % 2 == 1;
        // Forwards where its end is left, or its start driven onto.
        const Angle heading = isAtEnd == isLeaving ? swaths_.heading : swaths_.heading + degrees(180.0);
        return vehicleAt({.position = isAtEnd ? swath.end : swath.start, .heading = normalisedPoseHeading(heading)}, machine_);
    };
    const Length curve = dubinsLength(pose(leaving, true), pose(arriving, false), machine_.minTurningRadius());
    return (curve + machine_.runIn()).si() / machine_.turningSpeed().si();
}

double CellCost::endsSeconds(std::size_t end, std::size_t other) const {
    const auto swathAt = [this](std::size_t at) {
        const Piece& piece = pieces_[at / 2];
        return at % 2 == 1 ? piece.swaths.back() : piece.swaths.front();
    };
    double least = kInfinite;
    for (const std::size_t side : {0U, 1U}) {
        for (const std::size_t otherSide : {0U, 1U}) {
            least = std::min(least, linkSeconds(2 * swathAt(end) + side, 2 * swathAt(other) + otherSide));
        }
    }
    return least;
}

void CellCost::findLinks() {
    std::vector<std::size_t> ends;
    std::vector<Bounds> boxes;
    for (std::size_t piece = 0; piece < pieces_.size(); ++piece) {
        for (std::size_t end = 0; end < 2 && !isEmpty(piece); ++end) {
            const Swath& swath = swaths_.swaths[end == 1 ? pieces_[piece].swaths.back() : pieces_[piece].swaths.front()];
            ends.push_back(2 * piece + end);
            boxes.push_back({.min = swath.start, .max = swath.end});
        }
    }
    const auto apart = [&](std::size_t a, std::size_t b) {
        return std::min({distance(boxes[a].min, boxes[b].min), distance(boxes[a].max, boxes[b].max),
                         distance(boxes[a].min, boxes[b].max), distance(boxes[a].max, boxes[b].min)});
    };
    std::vector<std::pair<double, std::size_t>> others;
    for (std::size_t a = 0; a < ends.size(); ++a) {
        others.clear();
        for (std::size_t b = 0; b < ends.size(); ++b) {
            if (ends[a] / 2 != ends[b] / 2) {
                others.emplace_back(apart(a, b), b);
            }
        }
        const std::size_t count = std::min(kNearest, others.size());
        std::ranges::partial_sort(others, others.begin() + static_cast<std::ptrdiff_t>(count));
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t b = others[i].second;
            links_.push_back({.seconds = endsSeconds(ends[std::min(a, b)], ends[std::max(a, b)]),
                              .from = ends[std::min(a, b)],
                              .to = ends[std::max(a, b)]});
        }
    }
    const auto key = [](const Link& link) { return std::tuple{link.seconds, link.from, link.to}; };
    std::ranges::sort(links_, {}, key);
    const auto doubles = std::ranges::unique(links_, {}, key);
    links_.erase(doubles.begin(), doubles.end());
}

void CellCost::findRoughSeconds() {
    const std::size_t count = 2 * pieces_.size();
    const auto swathAt = [this](std::size_t end) -> const Swath& {
        const Piece& piece = pieces_[end / 2];
        return swaths_.swaths[end % 2 == 1 ? piece.swaths.back() : piece.swaths.front()];
    };
    roughSeconds_.assign(count * count, 0.0);
    for (std::size_t a = 0; a < count; ++a) {
        for (std::size_t b = 0; b < count; ++b) {
            if (!isEmpty(a / 2) && !isEmpty(b / 2)) {
                const Swath& from = swathAt(a);
                const Swath& to = swathAt(b);
                roughSeconds_[a * count + b] = std::min({distance(from.start, to.start), distance(from.end, to.end),
                                                         distance(from.start, to.end), distance(from.end, to.start)}) /
                                               machine_.turningSpeed().si();
            }
        }
    }
    for (const Link& link : links_) {
        roughSeconds_[link.from * count + link.to] = roughSeconds_[link.to * count + link.from] = link.seconds;
    }
}

std::vector<CellCost::Cell> CellCost::cellsOf(const Groups& groups) const {
    // In the order of their first pieces with swaths: others change nothing.
    std::vector<std::size_t> order;
    std::vector<std::size_t> first(pieces_.size(), pieces_.size());
    for (std::size_t piece = 0; piece < pieces_.size(); ++piece) {
        if (!isEmpty(piece)) {
            order.push_back(piece);
            first[groups[piece]] = std::min(first[groups[piece]], piece);
        }
    }
    std::ranges::sort(order, {}, [&](std::size_t piece) { return std::pair{first[groups[piece]], pieces_[piece].swaths.front()}; });
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
            // After an odd number of swaths it stands at the other side, and goes on from there.
            const std::size_t at = cell.isOdd ? 1 - side : side;
            cell.turning[side] += linkSeconds(2 * cell.lastSwath + at, 2 * piece.swaths.front() + at) + piece.turning[at];
        }
        cell.lastPiece = index;
        cell.lastSwath = piece.swaths.back();
        cell.isOdd = cell.isOdd != isOdd;
    }
    return cells;
}

std::vector<CellCost::Visit> CellCost::sequenceOf(const std::vector<Cell>& cells) const {
    constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
    // Ends of cells: 2 × cell + 1 at its last swath.
    std::vector<std::size_t> endOfPiece(2 * pieces_.size(), kNone);
    for (std::size_t cell = 0; cell < cells.size(); ++cell) {
        endOfPiece[2 * cells[cell].firstPiece] = 2 * cell;
        endOfPiece[2 * cells[cell].lastPiece + 1] = 2 * cell + 1;
    }
    std::vector<std::size_t> partner(2 * cells.size(), kNone);
    // The other end of the chain that an end is the end of.
    std::vector<std::size_t> farEnd(2 * cells.size());
    for (std::size_t end = 0; end < farEnd.size(); ++end) {
        farEnd[end] = end ^ 1U;
    }
    const auto connect = [&](std::size_t a, std::size_t b) {
        partner[a] = b;
        partner[b] = a;
        const std::size_t first = farEnd[a];
        const std::size_t last = farEnd[b];
        farEnd[first] = last;
        farEnd[last] = first;
    };
    for (const Link& link : links_) {
        const std::size_t a = endOfPiece[link.from];
        const std::size_t b = endOfPiece[link.to];
        if (a != kNone && b != kNone && partner[a] == kNone && partner[b] == kNone && farEnd[a] != b) {
            connect(a, b);
        }
    }
    // What is left are chains that are far apart: from the first on to the nearest each.
    std::vector<Visit> sequence;
    std::vector<bool> isDone(cells.size(), false);
    const auto follow = [&](std::size_t entered) {
        for (std::size_t end = entered; end != kNone; end = partner[end ^ 1U]) {
            isDone[end / 2] = true;
            sequence.push_back({.cell = end / 2, .fromLast = end % 2 == 1});
        }
    };
    const auto pieceEnd = [&](std::size_t end) {
        return end % 2 == 1 ? 2 * cells[end / 2].lastPiece + 1 : 2 * cells[end / 2].firstPiece;
    };
    while (sequence.size() < cells.size()) {
        std::size_t next = kNone;
        double least = kInfinite;
        for (std::size_t end = 0; end < partner.size(); ++end) {
            if (isDone[end / 2] || partner[end] != kNone) {
                continue;
            }
            const double seconds =
                sequence.empty() ? 0.0 : endsSeconds(pieceEnd(2 * sequence.back().cell + (sequence.back().fromLast ? 0 : 1)), pieceEnd(end));
            if (seconds < least) {
                least = seconds;
                next = end;
            }
        }
        follow(next);
    }
    return sequence;
}

double CellCost::secondsOf(const std::vector<Cell>& cells, const std::vector<Visit>& sequence) const {
    // By the side at which a cell's first swath begins, or ends where it is driven from the last.
    BySide soFar{};
    for (std::size_t i = 0; i < sequence.size(); ++i) {
        const Cell& cell = cells[sequence[i].cell];
        BySide next{kInfinite, kInfinite};
        for (const std::size_t side : {0U, 1U}) {
            const std::size_t across = cell.isOdd ? 1 - side : side;
            const Port entered = sequence[i].fromLast ? 2 * cell.lastSwath + across : 2 * cell.firstSwath + side;
            for (const std::size_t sideBefore : {0U, 1U}) {
                if (i == 0) {
                    next[side] = cell.turning[side];
                    break;
                }
                const Cell& before = cells[sequence[i - 1].cell];
                const std::size_t acrossBefore = before.isOdd ? 1 - sideBefore : sideBefore;
                const Port left = sequence[i - 1].fromLast ? 2 * before.firstSwath + sideBefore : 2 * before.lastSwath + acrossBefore;
                next[side] = std::min(next[side], soFar[sideBefore] + linkSeconds(left, entered) + cell.turning[side]);
            }
        }
        soFar = next;
    }
    return sequence.empty() ? 0.0 : std::min(soFar[0], soFar[1]);
}

void CellCost::turnRound(std::vector<Visit>& sequence, std::size_t first, std::size_t last) {
    std::reverse(sequence.begin() + static_cast<std::ptrdiff_t>(first), sequence.begin() + static_cast<std::ptrdiff_t>(last) + 1);
    for (std::size_t at = first; at <= last; ++at) {
        sequence[at].fromLast = !sequence[at].fromLast;
    }
}

void CellCost::improveRoughly(const std::vector<Cell>& cells, std::vector<Visit>& sequence) const {
    const std::size_t count = 2 * pieces_.size();
    const auto entered = [&](const Visit& visit) {
        return visit.fromLast ? 2 * cells[visit.cell].lastPiece + 1 : 2 * cells[visit.cell].firstPiece;
    };
    const auto left = [&](const Visit& visit) {
        return visit.fromLast ? 2 * cells[visit.cell].firstPiece : 2 * cells[visit.cell].lastPiece + 1;
    };
    const auto rough = [&](std::size_t from, std::size_t to) { return roughSeconds_[from * count + to]; };
    bool isBetter = true;
    for (int round = 0; isBetter && round < kMostRounds; ++round) {
        isBetter = false;
        for (std::size_t i = 0; i < sequence.size(); ++i) {
            for (std::size_t k = i; k < sequence.size(); ++k) {
                double gain = 0.0;
                if (i > 0) {
                    gain += rough(left(sequence[i - 1]), entered(sequence[i])) - rough(left(sequence[i - 1]), left(sequence[k]));
                }
                if (k + 1 < sequence.size()) {
                    gain += rough(left(sequence[k]), entered(sequence[k + 1])) - rough(entered(sequence[i]), entered(sequence[k + 1]));
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
    for (bool isBetter = true; isBetter;) {
        isBetter = false;
        for (std::size_t i = 0; i < sequence.size(); ++i) {
            for (std::size_t k = i; k < sequence.size(); ++k) {
                std::vector<Visit> turned = sequence;
                turnRound(turned, i, k);
                if (const double other = secondsOf(cells, turned); other < seconds - kSameS) {
                    seconds = other;
                    sequence = std::move(turned);
                    isBetter = true;
                }
            }
        }
    }
}

Duration CellCost::of(const Groups& groups) const {
    const std::vector<Cell> cells = cellsOf(groups);
    std::vector<Visit> sequence = sequenceOf(cells);
    if (!roughSeconds_.empty()) {
        improveRoughly(cells, sequence);
    }
    double sum = secondsOf(cells, sequence);
    if (areFew_) {
        improve(cells, sequence, sum);
    }
    return seconds(sum);
}

}  // namespace furrow
