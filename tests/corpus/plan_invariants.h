#pragma once

#include "planner/plan/plan.h"
#include "tests/corpus/drawn_requests.h"

#include <chrono>
#include <cstdint>
#include <string>

namespace furrow::test {

/// What came of one drawn request.
enum class DrawnOutcome { Refused, Planned, Drivable };

struct DrawnVerdict {
    DrawnOutcome outcome = DrawnOutcome::Refused;
    std::string fault;         ///< what must never be; empty where all is well
    double seconds = 0.0;      ///< of the processor
    double stopSeconds = 0.0;  ///< from the stop request until the job had ended; 0: none was made
};

/// What may be tried beside making the plan once.
enum class DrawnTrial { PlanOnly, OneThreadAndTwo, Stop };

/// Plans and audits a drawn request, and looks at what must hold of every plan: an error says what is wrong
/// and what to do; no number that is none; swaths inside of the mainland; JSON that can be read. By one
/// thread and by two it has to be the same; where it is to be stopped, it is after `stopAfter`.
DrawnVerdict verdictOn(const DrawnRequest& drawn, DrawnTrial trial = DrawnTrial::PlanOnly,
                       std::chrono::milliseconds stopAfter = {});

/// The same of a seed's request. Every third one is planned by two threads, too, and every other third is
/// stopped meanwhile.
DrawnVerdict verdictOn(std::uint64_t seed, DrawnSize size = DrawnSize::Any);

}  // namespace furrow::test
