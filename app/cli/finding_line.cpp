#include "app/cli/finding_line.h"

#include <format>

namespace furrow {

std::string findingLine(std::size_t number, const Finding& finding, const LocalFrame& frame) {
    const GeoPoint place = frame.toGeo(finding.place);
    return std::format("  {} {:3}  {}{}{} ({:.6f}, {:.6f})",
                       finding.severity == Severity::Blocking ? "!" : " ", number, finding.text.text(),
                       finding.suggestion.empty() ? "" : " ", finding.suggestion.text(), place.lonDeg,
                       place.latDeg);
}

}  // namespace furrow
