#include "planner/route/order_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>
#include <numeric>
#include <random>
#include <utility>

namespace furrow {

namespace {

/// Before the first swath and after the last one.
constexpr SwathEnd kDepot = std::numeric_limits<SwathEnd>::max();
// Moves that gain less, in parts of the whole cost, are rounding.
constexpr double kMoveRounding = 1e-9;
// Longer stretches are moved only as the rest of what lies between two others.
constexpr std::size_t kLongestMoved = 50;
constexpr std::size_t kBestStarts = 2;
// Swaths among which one disturbance takes place.
constexpr std::size_t kDisturbed = 12;
// What a round at the beginning may make the order dearer, about, in mean links. Found by trial on random
// fields of 8 to 300 swaths.
constexpr double kMayLose = 1.0;
// Of a random number, which has more than a double.
constexpr int kUnusedBits = 11;

/// Places in the order, both ends included, of which the stretch is driven in either direction.
struct Block {
    std::size_t from = 0;
    std::size_t to = 0;
    bool turned = false;
};

/// A stretch of the order, newly put together from adjacent blocks.
struct Move {
    double change = 0.0;  ///< of the cost
    std::array<Block, 3> blocks;
    std::size_t count = 0;
};

/// An order of swaths at places 1 to n, with the depot at 0 and n + 1.
class Tour {
public:
    Tour(const LinkCosts& costs, const OpenStripLimit* strips, const EndOrder& order)
        : costs_{&costs},
          strips_{strips},
          entered_(order.size() + 2, kDepot),
          place_(order.size()),
          turning_(order.size() + 2) {
        std::ranges::copy(order, entered_.begin() + 1);
        update(1, order.size());
        excess_ = strips_ != nullptr ? strips_->excess(order) : 0;
    }

    std::size_t size() const { return place_.size(); }
    SwathEnd entered(std::size_t place) const { return entered_[place]; }
    SwathEnd left(std::size_t place) const {
        return entered_[place] == kDepot ? kDepot : otherEnd(entered_[place]);
    }
    std::size_t placeOf(SwathEnd end) const { return place_[end / 2]; }
    EndOrder order() const { return {entered_.begin() + 1, entered_.end() - 1}; }
    double cost() const { return costOfLinks(1, size() + 1); }
    /// Of the links into these places.
    double costOfLinks(std::size_t from, std::size_t to) const {
        double sum = 0.0;
        for (std::size_t place = from; place <= to; ++place) {
            sum += link(left(place - 1), entered(place));
        }
        return sum;
    }

    double link(SwathEnd leaving, SwathEnd entered) const {
        return leaving == kDepot   ? (entered == kDepot ? 0.0 : costs_->begin(entered))
               : entered == kDepot ? costs_->finish(leaving)
                                   : costs_->link(leaving, entered);
    }
    /// The same or less, without looking up what is not known.
    double atLeast(SwathEnd leaving, SwathEnd entered) const {
        return leaving == kDepot || entered == kDepot ? link(leaving, entered)
                                                      : costs_->knownOrLess(leaving, entered);
    }
    /// What a stretch costs more if it is driven the other way.
    double turning(std::size_t from, std::size_t to) const { return turning_[to] - turning_[from]; }

    /// Open strips over the limit.
    std::size_t excess() const { return excess_; }
    /// Whether a move leaves no more strips open than allowed, or than before.
    bool allows(const Move& move) const {
        if (strips_ == nullptr) {
            return true;
        }
        EndOrder after = order();
        std::ranges::copy(stretch(move), after.begin() + static_cast<std::ptrdiff_t>(begin(move)) - 1);
        return strips_->excess(after, excess_) <= excess_;
    }

    void apply(const Move& move) {
        const std::size_t from = begin(move);
        const EndOrder after = stretch(move);
        std::ranges::copy(after, entered_.begin() + static_cast<std::ptrdiff_t>(from));
        update(from, from + after.size() - 1);
        if (strips_ != nullptr) {
            excess_ = strips_->excess(order());
        }
    }

    /// The swaths whose links a move has changed.
    template <class Use>
    void touched(const Move& move, const Use& use) const {
        std::size_t place = begin(move);
        const auto tell = [&](std::size_t at) {
            if (at >= 1 && at <= size()) {
                use(entered_[at] / 2);
            }
        };
        tell(place - 1);
        for (std::size_t i = 0; i < move.count; ++i) {
            tell(place);
            place += move.blocks[i].to - move.blocks[i].from;
            tell(place);
            ++place;
        }
        tell(place);
    }

private:
    static std::size_t begin(const Move& move) {
        std::size_t from = move.blocks[0].from;
        for (std::size_t i = 1; i < move.count; ++i) {
            from = std::min(from, move.blocks[i].from);
        }
        return from;
    }

    /// What a move puts together.
    EndOrder stretch(const Move& move) const {
        EndOrder after;
        for (std::size_t i = 0; i < move.count; ++i) {
            const Block& block = move.blocks[i];
            for (std::size_t k = 0; k <= block.to - block.from; ++k) {
                after.push_back(block.turned ? left(block.to - k) : entered(block.from + k));
            }
        }
        return after;
    }

    void update(std::size_t from, std::size_t to) {
        for (std::size_t place = from; place <= to; ++place) {
            place_[entered_[place] / 2] = place;
        }
        const std::size_t last = std::min(to + 1, size());
        const double old = turning_[last];
        for (std::size_t place = from; place <= last; ++place) {
            turning_[place] = turning_[place - 1];
            if (place > 1) {
                turning_[place] += costs_->link(entered(place), left(place - 1)) -
                                   costs_->link(left(place - 1), entered(place));
            }
        }
        const double shift = turning_[last] - old;
        for (std::size_t place = last + 1; place <= size(); ++place) {
            turning_[place] += shift;
        }
    }

    const LinkCosts* costs_;
    const OpenStripLimit* strips_;
    std::size_t excess_ = 0;
    std::vector<SwathEnd> entered_;
    std::vector<std::size_t> place_;  ///< of each swath
    std::vector<double> turning_;     ///< sums up to each place
};

/// A tour as it is, or as it looks from its end: every link backwards. One set of moves serves both.
template <bool isMirrored>
class View {
public:
    View(const Tour& tour, const NearEnds& near, const std::vector<SwathEnd>& nearDepot)
        : tour_{tour}, near_{isMirrored ? near.leftBefore : near.enteredFrom}, nearDepot_{nearDepot} {}

    std::size_t size() const { return tour_.size(); }
    SwathEnd entered(std::size_t place) const {
        return isMirrored ? tour_.left(mirrored(place)) : tour_.entered(place);
    }
    SwathEnd left(std::size_t place) const {
        return isMirrored ? tour_.entered(mirrored(place)) : tour_.left(place);
    }
    std::size_t placeOf(SwathEnd end) const { return mirrored(tour_.placeOf(end)); }
    double link(SwathEnd leaving, SwathEnd entered) const {
        return isMirrored ? tour_.link(entered, leaving) : tour_.link(leaving, entered);
    }
    double atLeast(SwathEnd leaving, SwathEnd entered) const {
        return isMirrored ? tour_.atLeast(entered, leaving) : tour_.atLeast(leaving, entered);
    }
    double turning(std::size_t from, std::size_t to) const {
        return isMirrored ? tour_.turning(mirrored(to), mirrored(from)) : tour_.turning(from, to);
    }
    const std::vector<SwathEnd>& near(SwathEnd leaving) const {
        return leaving == kDepot ? nearDepot_ : near_[leaving];
    }
    /// Of a move as it looks from here.
    bool allows(const Move& move) const { return tour_.allows(real(move)); }
    Move real(Move move) const {
        if (isMirrored) {
            std::reverse(move.blocks.begin(), move.blocks.begin() + static_cast<std::ptrdiff_t>(move.count));
            for (std::size_t i = 0; i < move.count; ++i) {
                Block& block = move.blocks[i];
                block = {mirrored(block.to), mirrored(block.from), block.turned};
            }
        }
        return move;
    }

private:
    std::size_t mirrored(std::size_t place) const { return isMirrored ? size() + 1 - place : place; }

    const Tour& tour_;
    const std::vector<std::vector<SwathEnd>>& near_;
    const std::vector<SwathEnd>& nearDepot_;
};

/// The best move that replaces the link after one place by a cheaper one.
template <class View>
class MovesAfter {
public:
    MovesAfter(const View& view, std::size_t place, double worthwhile)
        : view_{view}, place_{place}, next_{place + 1}, best_{.change = -worthwhile, .blocks = {}} {}

    Move best() {
        const SwathEnd leaving = view_.left(place_);
        const double old = view_.link(leaving, view_.entered(next_));
        for (const SwathEnd end : view_.near(leaving)) {
            const double link = view_.link(leaving, end);
            if (link >= old) {
                break;
            }
            const std::size_t other = view_.placeOf(end);
            const double change = link - old;
            if (view_.entered(other) == end) {
                other > place_ ? bringForwards(other, change) : takeBackwards(other, change);
            } else {
                other > place_ ? turnRound(other, change) : takeTurned(other, change);
            }
        }
        return view_.real(best_);
    }

private:
    double link(std::size_t from, std::size_t to) const {
        return view_.link(view_.left(from), view_.entered(to));
    }

    struct Link {
        SwathEnd leaving = kDepot;
        SwathEnd entered = kDepot;
    };
    /// A move with the cost of all that it changes but two new links.
    void offer(double change, Link first, Link second, std::initializer_list<Block> blocks) {
        if (change + view_.atLeast(first.leaving, first.entered) +
                view_.atLeast(second.leaving, second.entered) >=
            best_.change) {
            return;
        }
        change += view_.link(first.leaving, first.entered) + view_.link(second.leaving, second.entered);
        if (change < best_.change) {
            Move move{.change = change, .blocks = {}, .count = blocks.size()};
            std::ranges::copy(blocks, move.blocks.begin());
            if (view_.allows(move)) {
                best_ = move;
            }
        }
    }
    /// The link between two places as they will follow each other.
    Link fromTo(std::size_t from, std::size_t to) const { return {view_.left(from), view_.entered(to)}; }

    /// A stretch from `first` on comes right after this place, in its direction.
    void bringForwards(std::size_t first, double change) {
        const double from = change - link(first - 1, first);
        const std::size_t most = std::min(first + kLongestMoved - 1, view_.size());
        const double turnedRest = view_.turning(next_, first - 1);
        for (std::size_t last = first; last <= most; ++last) {
            const double base = from - link(last, last + 1);
            offer(base, fromTo(last, next_), fromTo(first - 1, last + 1),
                  {{first, last, false}, {next_, first - 1, false}});
            offer(base + turnedRest, {view_.left(last), view_.left(first - 1)},
                  {view_.entered(next_), view_.entered(last + 1)},
                  {{first, last, false}, {next_, first - 1, true}});
        }
    }

    /// A stretch from `first` on, before this place, comes right after it.
    void takeBackwards(std::size_t first, double change) {
        const double from = change - link(first - 1, first);
        const std::size_t most = std::min(first + kLongestMoved, place_);
        for (std::size_t last = first; last < most; ++last) {
            offer(from - link(last, last + 1), fromTo(first - 1, last + 1), fromTo(last, next_),
                  {{last + 1, place_, false}, {first, last, false}});
        }
    }

    /// A stretch up to `last` comes right after this place, turned round.
    void turnRound(std::size_t last, double change) {
        const double from = change - link(last, last + 1);
        const SwathEnd next = view_.entered(next_);
        const SwathEnd after = view_.entered(last + 1);
        offer(from + view_.turning(next_, last), {next, after}, {}, {{next_, last, true}});
        const std::size_t least = last > kLongestMoved ? std::max(next_, last - kLongestMoved) : next_;
        for (std::size_t first = last; first > least; --first) {
            const double base = from - link(first - 1, first) + view_.turning(first, last);
            offer(base, {view_.entered(first), next}, {view_.left(first - 1), after},
                  {{first, last, true}, {next_, first - 1, false}});
            offer(base + view_.turning(next_, first - 1), {view_.entered(first), view_.left(first - 1)},
                  {next, after}, {{first, last, true}, {next_, first - 1, true}});
        }
    }

    /// A stretch up to `last`, before this place, comes right after it, turned round.
    void takeTurned(std::size_t last, double change) {
        if (last == place_) {
            return;
        }
        const double from = change - link(last, last + 1);
        const std::size_t least = last > kLongestMoved ? last - kLongestMoved : 0;
        for (std::size_t first = last; first > least; --first) {
            offer(from - link(first - 1, first) + view_.turning(first, last), fromTo(first - 1, last + 1),
                  {view_.entered(first), view_.entered(next_)},
                  {{last + 1, place_, false}, {first, last, true}});
        }
    }

    const View& view_;
    std::size_t place_;
    std::size_t next_;
    Move best_;
};

/// Swaths whose links may have become improvable, each once.
class Queue {
public:
    explicit Queue(std::size_t swaths) : isIn_(swaths, 0) {}

    void push(std::size_t swath) {
        if (isIn_[swath] == 0) {
            isIn_[swath] = 1;
            swaths_.push_back(swath);
        }
    }
    bool empty() const { return swaths_.empty(); }
    std::size_t pop() {
        const std::size_t swath = swaths_.front();
        swaths_.pop_front();
        isIn_[swath] = 0;
        return swath;
    }

private:
    std::vector<char> isIn_;
    std::deque<std::size_t> swaths_;
};

class OrderSearch {
public:
    OrderSearch(const OrderSearchTask& task, const JobContext& job)
        : task_{task}, job_{job}, queue_{task.costs.swathCount()}, random_{task.seed} {
        firstEntered_ = depotEnds([&](SwathEnd end) { return task.costs.begin(end); });
        lastLeft_ = depotEnds([&](SwathEnd end) { return task.costs.finish(end); });
    }

    FoundOrder run();

private:
    template <class Cost>
    std::vector<SwathEnd> depotEnds(const Cost& cost) const {
        std::vector<SwathEnd> ends(task_.costs.endCount());
        std::iota(ends.begin(), ends.end(), SwathEnd{0});
        std::ranges::stable_sort(ends, {}, cost);
        ends.resize(std::min(ends.size(), task_.near.enteredFrom.empty()
                                              ? std::size_t{0}
                                              : task_.near.enteredFrom.front().size()));
        return ends;
    }

    /// Less and less towards the last round (Kirkpatrick, Gelatt & Vecchi 1983,
    /// doi 10.1126/science.220.4598.671).
    double mayLose(double cost, std::size_t round) {
        const double left = 1.0 - static_cast<double>(round) / static_cast<double>(task_.rounds);
        const double chance = (static_cast<double>(random_() >> kUnusedBits) + 1.0) * 0x1.0p-53;
        return -kMayLose * left * cost / static_cast<double>(task_.costs.swathCount()) * std::log(chance);
    }
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(random_() % count); }

    Move bestMove(const Tour& tour, std::size_t place, double worthwhile) const;
    double improve(Tour& tour, double cost);
    double disturb(Tour& tour, double cost);

    const OrderSearchTask& task_;
    const JobContext& job_;
    Queue queue_;
    std::mt19937_64 random_;
    std::vector<SwathEnd> firstEntered_;
    std::vector<SwathEnd> lastLeft_;
};

/// Of the links before and after a place.
Move OrderSearch::bestMove(const Tour& tour, std::size_t place, double worthwhile) const {
    const View<false> ahead{tour, task_.near, firstEntered_};
    const View<true> back{tour, task_.near, lastLeft_};
    const std::size_t mirrored = tour.size() + 1 - place;
    Move best = MovesAfter{ahead, place, worthwhile}.best();
    const auto offer = [&](const Move& move) {
        if (move.change < best.change) {
            best = move;
        }
    };
    offer(MovesAfter{back, mirrored, worthwhile}.best());
    if (place == 1) {
        offer(MovesAfter{ahead, 0, worthwhile}.best());
    }
    if (mirrored == 1) {
        offer(MovesAfter{back, 0, worthwhile}.best());
    }
    return best;
}

double OrderSearch::improve(Tour& tour, double cost) {
    const double worthwhile = kMoveRounding * std::max(1.0, cost);
    while (!queue_.empty() && !job_.stopRequested()) {
        const std::size_t swath = queue_.pop();
        const auto end = static_cast<SwathEnd>(2 * swath);
        for (Move move = bestMove(tour, tour.placeOf(end), worthwhile); move.count > 0;
             move = bestMove(tour, tour.placeOf(end), worthwhile)) {
            tour.apply(move);
            cost += move.change;
            tour.touched(move, [&](std::size_t touched) { queue_.push(touched); });
        }
    }
    return cost;
}

/// Exchanges neighbouring stretches somewhere, and turns some of them round.
double OrderSearch::disturb(Tour& tour, double cost) {
    const std::size_t n = tour.size();
    const std::size_t window = std::min(n, kDisturbed);
    const std::size_t first = 1 + below(n - window + 1);
    std::array<std::size_t, 4> cuts{};
    for (std::size_t& cut : cuts) {
        cut = first + below(window + 1);
    }
    std::ranges::sort(cuts);
    Move move;
    for (std::size_t i = cuts.size() - 1; i-- > 0;) {
        if (cuts[i] < cuts[i + 1]) {
            move.blocks[move.count++] = {cuts[i], cuts[i + 1] - 1, below(2) == 0};
        }
    }
    if (move.count == 0) {
        return cost;
    }
    if (!tour.allows(move)) {
        return cost;
    }
    const double before = tour.costOfLinks(cuts.front(), cuts.back());
    tour.apply(move);
    tour.touched(move, [&](std::size_t touched) { queue_.push(touched); });
    return cost + tour.costOfLinks(cuts.front(), cuts.back()) - before;
}

FoundOrder OrderSearch::run() {
    std::vector<FoundOrder> starts;
    for (const EndOrder& order : task_.starts) {
        starts.push_back({order, task_.costs.of(order)});
    }
    if (task_.costs.swathCount() == 1) {
        FoundOrder turned = starts.front();
        turned.order.front() = otherEnd(turned.order.front());
        turned.cost = task_.costs.of(turned.order);
        starts.push_back(std::move(turned));
    }
    const auto excess = [&](const FoundOrder& found) {
        return task_.strips != nullptr ? task_.strips->excess(found.order) : 0;
    };
    std::ranges::stable_sort(starts, {},
                             [&](const FoundOrder& found) { return std::pair{excess(found), found.cost}; });
    FoundOrder best = starts.front();
    std::size_t bestExcess = excess(best);
    const auto take = [&](const Tour& tour, double cost) {
        if (tour.excess() < bestExcess ||
            (tour.excess() == bestExcess && cost < best.cost - kMoveRounding * std::max(1.0, best.cost))) {
            best = {tour.order(), tour.cost()};
            bestExcess = tour.excess();
        }
    };
    starts.resize(std::min(starts.size(), kBestStarts));
    const std::size_t swaths = task_.costs.swathCount();
    for (const FoundOrder& start : starts) {
        Tour tour{task_.costs, task_.strips, start.order};
        for (std::size_t swath = 0; swath < swaths; ++swath) {
            queue_.push(swath);
        }
        take(tour, improve(tour, start.cost));
    }
    if (swaths < 2) {
        return best;
    }
    Tour kept{task_.costs, task_.strips, best.order};
    double keptCost = best.cost;
    for (std::size_t round = 0; round < task_.rounds && !job_.stopRequested(); ++round) {
        Tour tour = kept;
        const double cost = improve(tour, disturb(tour, keptCost));
        take(tour, cost);
        if (cost < keptCost + mayLose(best.cost, round)) {
            std::swap(kept, tour);
            keptCost = cost;
        }
        job_.report(static_cast<double>(round + 1) / static_cast<double>(task_.rounds));
    }
    return best;
}

}  // namespace

FoundOrder searchedOrder(const OrderSearchTask& task, const JobContext& job) {
    return OrderSearch{task, job}.run();
}

}  // namespace furrow
