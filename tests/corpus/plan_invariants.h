#pragma once

#include "planner/plan/plan.h"
#include "tests/corpus/drawn_requests.h"

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

/// Plans and audits a drawn request, and looks at what must hold of every plan: an error says what is wrong
/// and what to do; no number that is none; swaths inside of the mainland; JSON that can be read. Every third
/// one is planned by one thread and by two and has to be the same; every other third is stopped meanwhile.
DrawnVerdict verdictOn(std::uint64_t seed, DrawnSize size = DrawnSize::Any);

}  // namespace furrow::test
