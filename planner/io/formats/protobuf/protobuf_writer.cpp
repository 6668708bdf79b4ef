#include "planner/io/formats/protobuf/protobuf.h"

#include "planner/io/files/file_names.h"
#include "planner/plan/plan.h"

#include "path_message.pb.h"

#include <cmath>
#include <utility>

namespace furrow {

namespace {

constexpr unsigned kFormatVersion = 1;

/// Protobuf's texts are UTF-8 or refused.
std::string validText(const std::string& text) {
    return cutText(text, text.size());
}

void fill(v1::Place& place, GeoPoint point) {
    place.set_lat_deg(point.latDeg);
    place.set_lon_deg(point.lonDeg);
}

void fill(v1::Polygon& message, const GeoPolygon& polygon) {
    for (const GeoPoint& point : polygon.outer) {
        fill(*message.add_outer(), point);
    }
    for (const GeoRing& hole : polygon.holes) {
        v1::Ring& ring = *message.add_holes();
        for (const GeoPoint& point : hole) {
            fill(*ring.add_places(), point);
        }
    }
}

v1::SegmentKind kindOf(SegmentKind kind) {
    switch (kind) {
        case SegmentKind::Swath: return v1::SEGMENT_KIND_SWATH;
        case SegmentKind::Turn: return v1::SEGMENT_KIND_TURN;
        case SegmentKind::HeadlandPass: return v1::SEGMENT_KIND_HEADLAND_PASS;
        case SegmentKind::Transfer: return v1::SEGMENT_KIND_TRANSFER;
        case SegmentKind::Refill: return v1::SEGMENT_KIND_REFILL;
        case SegmentKind::Wait: return v1::SEGMENT_KIND_WAIT;
    }
    return v1::SEGMENT_KIND_UNSPECIFIED;
}

void fill(v1::Sample& message, const PathSample& sample, Gear gear, const LocalFrame& frame) {
    const double along = gear == Gear::Reverse ? -sample.speedMps : sample.speedMps;
    message.set_time_s(sample.tS);
    fill(*message.mutable_place(), frame.toGeo(sample.position));
    message.set_x_m(sample.position.x);
    message.set_y_m(sample.position.y);
    message.set_heading_rad(sample.headingRad);
    message.mutable_orientation()->set_z(std::sin(sample.headingRad / 2.0));
    message.mutable_orientation()->set_w(std::cos(sample.headingRad / 2.0));
    message.set_speed_mps(sample.speedMps);
    message.set_velocity_x_mps(along * std::cos(sample.headingRad));
    message.set_velocity_y_mps(along * std::sin(sample.headingRad));
    message.set_yaw_rate_radps(along * sample.curvature1pm);
    message.set_curvature_1pm(sample.curvature1pm);
}

v1::PathMessage messageOf(const Plan& plan) {
    const FieldSource& field = plan.field().source();
    const LocalFrame& frame = plan.field().frame();
    v1::PathMessage message;
    message.set_format_version(kFormatVersion);
    message.set_software("Furrow " FURROW_VERSION);
    message.set_field_name(validText(field.name));
    message.set_machine_name(validText(plan.request.machine.name()));
    message.set_operating_width_m(plan.request.machine.operatingWidth().si());
    fill(*message.mutable_frame()->mutable_origin(), frame.centre());
    message.mutable_frame()->set_proj(frame.projString());
    for (const GeoPolygon& part : field.parts) {
        fill(*message.add_fence(), part);
    }
    for (const Obstacle& obstacle : field.obstacles) {
        if (!obstacle.passable) {
            v1::Polygon& polygon = *message.add_keep_out();
            polygon.set_name(validText(obstacle.name));
            fill(polygon, obstacle.outline);
        }
    }
    for (const PathSegment& segment : plan.path.segments) {
        v1::Segment& written = *message.add_segments();
        written.set_kind(kindOf(segment.kind));
        written.set_reverse(segment.gear == Gear::Reverse);
        written.set_implement_down(segment.implementDown);
        written.set_drivable(segment.drivable);
        for (const PathSample& sample : segment.samples) {
            fill(*written.add_samples(), sample, segment.gear, frame);
        }
    }
    return message;
}

}  // namespace

Result<FormatFiles> writeProtobuf(const ExportJob& job) {
    if (job.plan == nullptr) {
        return std::unexpected(needsPlan("protobuf"));
    }
    FormatFiles made;
    made.files.push_back({"path.pb", [&plan = *job.plan] { return messageOf(plan).SerializeAsString(); }});
    return made;
}

}  // namespace furrow
