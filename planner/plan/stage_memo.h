#pragma once

#include "planner/plan/plan_request.h"

#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <utility>

namespace furrow {

/// The last results of one stage with what they were made from. A stage whose inputs are equal is not run
/// again: field, machine and guides, the settings that it asked for, and `Inputs`, what the stages before it
/// made. May be asked by several threads at once. Of more than `kMost` results those that were made first are
/// known only as long as somebody else keeps them.
template <class Inputs, class Value, std::size_t kMost = 24>
class StageMemo {
public:
    /// What was made before from the same, or what `make` makes now: Result<Value>(const PlanRequest&).
    /// Errors are not kept.
    template <class Make>
    Result<std::shared_ptr<const Value>> get(const PlanRequest& request, Inputs inputs, const Make& make) {
        if (auto known = find(request, inputs)) {
            return known;
        }
        const auto reads = std::make_shared<SettingReads>();
        PlanRequest listening = request;
        listening.settings = request.settings.writingDown(reads);
        auto made = make(std::as_const(listening));
        if (!made) {
            return std::unexpected(made.error());
        }
        auto value = std::make_shared<const Value>(*std::move(made));
        const std::scoped_lock lock{mutex_};
        listening.settings = request.settings.writingDown({});
        results_.push_front({.request = std::move(listening),
                             .reads = reads,
                             .inputs = std::move(inputs),
                             .value = value,
                             .kept = value});
        if (results_.size() > kMost) {
            results_[kMost].kept.reset();
            std::erase_if(results_, [](const Known& known) { return known.value.expired(); });
        }
        return value;
    }

private:
    struct Known {
        PlanRequest request;
        std::shared_ptr<const SettingReads> reads;
        Inputs inputs;
        std::weak_ptr<const Value> value;
        std::shared_ptr<const Value> kept;  ///< the same, or empty
    };

    std::shared_ptr<const Value> find(const PlanRequest& request, const Inputs& inputs) const {
        const std::scoped_lock lock{mutex_};
        for (const Known& known : results_) {
            if (isSameButSettings(known.request, request) &&
                known.reads->areEqualIn(known.request.settings, request.settings) && known.inputs == inputs) {
                if (auto value = known.value.lock()) {
                    return value;
                }
            }
        }
        return nullptr;
    }

    mutable std::mutex mutex_;
    std::deque<Known> results_;  ///< the last one first
};

}  // namespace furrow
