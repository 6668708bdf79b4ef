#include "planner/io/formats/logs/logs.h"

#include "planner/core/text_file.h"

namespace furrow {

Recognition recogniseLog(const ChosenFile& chosen) {
    const bool known = chosen.isPlainText() && (looksLikeGpsd(chosen.text()) || looksLikeNmea(chosen.text()));
    return known || holdsNmea(chosen.text()) ? Recognition::Likely : Recognition::No;
}

Result<TrackFile> readLog(const ChosenFile& chosen, const JobContext& job) {
    const auto bytes = fileBytes(chosen.path());
    if (!bytes) {
        return std::unexpected(bytes.error());
    }
    const std::string_view text = withoutByteOrderMark(*bytes);
    const std::string where = chosen.path().string();
    return looksLikeGpsd(chosen.text()) ? gpsdTracks(text, where, job) : nmeaTracks(text, where, job);
}

}  // namespace furrow
