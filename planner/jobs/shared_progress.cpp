#include "planner/jobs/shared_progress.h"

#include <algorithm>
#include <numeric>

namespace furrow {

JobContext SharedProgress::piece(std::size_t index) {
    JobContext piece = job_.withoutProgress();
    if (job_.progress) {
        piece.progress = [this, index](double share) { report(index, share); };
    }
    return piece;
}

void SharedProgress::report(std::size_t index, double share) {
    // Told under the lock: otherwise a thread could tell an older mean after a newer one.
    const std::scoped_lock lock{mutex_};
    if (share > shares_[index]) {
        shares_[index] = std::min(share, 1.0);
        job_.report(std::accumulate(shares_.begin(), shares_.end(), 0.0) /
                    static_cast<double>(shares_.size()));
    }
}

}  // namespace furrow
