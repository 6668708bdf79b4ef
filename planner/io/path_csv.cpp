#include "planner/io/path_csv.h"

#include <format>
#include <iterator>

namespace furrow {

std::string pathCsv(const Plan& plan) {
    std::string text =
        "s_m,t_s,x_m,y_m,lon_deg,lat_deg,heading_rad,curvature_1pm,speed_mps,gear,implement_down,segment,"
        "order,"
        "machine,level\n";
    const auto out = std::back_inserter(text);
    for (std::size_t order = 0; order < plan.path.segments.size(); ++order) {
        const PathSegment& segment = plan.path.segments[order];
        Polyline line;
        for (const PathSample& sample : segment.samples) {
            line.push_back(sample.position);
        }
        const GeoRing places = plan.field().frame().toGeo(line);
        for (std::size_t i = 0; i < segment.samples.size(); ++i) {
            const PathSample& sample = segment.samples[i];
            std::format_to(out, "{},{},{},{},{},{},{},{},{},{},{},{},{},0,\n", sample.sM, sample.tS,
                           sample.position.x, sample.position.y, places[i].lonDeg, places[i].latDeg,
                           sample.headingRad, sample.curvature1pm, sample.speedMps,
                           static_cast<int>(segment.gear), segment.implementDown ? 1 : 0,
                           segmentKindId(segment.kind), order);
        }
    }
    return text;
}

}  // namespace furrow
