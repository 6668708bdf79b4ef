#include "ui/drive/machine_shape_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace furrow {

namespace {

constexpr double kWheelLengthM = 1.5;
constexpr double kFrontWheelLengthM = 1.1;
constexpr double kWheelWidthM = 0.5;
// A bar is seen as one even where the implement is short.
constexpr double kLeastImplementM = 0.6;

/// Places on a machine: along its nose and to the left of it, from a point that is a place in the field.
class Carrier {
public:
    Carrier(Point at, double headingRad, double scale, const MapFrame& frame)
        : at_{at}, nose_{std::cos(headingRad), std::sin(headingRad)}, scale_{scale}, frame_{&frame} {}

    Point place(double along, double left) const {
        return at_ + scale_ * (along * nose_ + left * Point{-nose_.y, nose_.x});
    }
    std::array<MapPoint, 4> box(double from, double to, double left, double right) const {
        return {frame_->map(place(from, right)), frame_->map(place(to, right)), frame_->map(place(to, left)),
                frame_->map(place(from, left))};
    }

private:
    Point at_;
    Point nose_;
    double scale_;
    const MapFrame* frame_;
};

void fill(FillMesh& mesh, const std::array<MapPoint, 4>& box) {
    for (const std::size_t corner : {0U, 1U, 2U, 0U, 2U, 3U}) {
        mesh.push_back(box[corner]);
    }
}

void addTractor(const Tractor& tractor, const Carrier& carrier, MachineShapeDrawing& drawing) {
    const double rear = -tractor.rearOverhang.si();
    const double front = rear + tractor.length.si();
    const double half = 0.5 * tractor.width.si();
    // Between the wheels; narrower in front, so that the nose is told from the tail.
    const double body = std::max(0.35 * half, half - kWheelWidthM);
    const auto cab = carrier.box(rear, 0.45 * front, body, -body);
    const auto hood = carrier.box(0.45 * front, front, 0.65 * body, -0.65 * body);
    fill(drawing.body, cab);
    fill(drawing.body, hood);
    drawing.outline.add(cab, true);
    drawing.outline.add(hood, true);
    const double axle = std::min(tractor.wheelbase.si(), front - 0.3);
    for (const double side : {1.0, -1.0}) {
        const double outer = side * half;
        const double inner = side * (half - kWheelWidthM);
        const double long2 = 0.5 * std::min(kWheelLengthM, 0.5 * tractor.length.si());
        const double short2 = 0.5 * std::min(kFrontWheelLengthM, 0.4 * tractor.length.si());
        fill(drawing.wheels, carrier.box(-long2, long2, std::max(outer, inner), std::min(outer, inner)));
        fill(drawing.wheels,
             carrier.box(axle - short2, axle + short2, std::max(outer, inner), std::min(outer, inner)));
    }
}

double widthOf(const Implement& implement, Carried carried) {
    const Length raised = implement.raisedWidth.value_or(implement.operatingWidth);
    switch (carried) {
        case Carried::Down: return implement.operatingWidth.si();
        case Carried::Up: return raised.si();
        case Carried::Folded: break;
    }
    return implement.transportWidth.value_or(raised).si();
}

}  // namespace

MachineShapeDrawing machineDrawing(const Machine& machine, const DriveState& state, Carried carried,
                                   const MapFrame& frame, Length least) {
    const Tractor& tractor = machine.spec().tractor;
    const Implement& implement = machine.spec().implement;
    MachineShapeDrawing drawing;
    const double width = widthOf(implement, carried);
    const double size = std::max({tractor.length.si(), width, 0.1});
    const double scale = std::max(1.0, least.si() / size);
    const Carrier vehicle{state.position, state.heading.si(), scale, frame};
    addTractor(tractor, vehicle, drawing);
    // Where it is drawn larger, the implement is farther away, too.
    const Point at = state.position + scale * (state.implement - state.position);
    const Carrier carrier{at, state.implementHeading.si(), scale, frame};
    const double half = 0.5 * std::max(implement.length.si(), kLeastImplementM);
    const auto bar = carrier.box(-half, half, 0.5 * width, -0.5 * width);
    fill(drawing.implement, bar);
    drawing.implementOutline.add(bar, true);
    const std::array drawbar{frame.map(vehicle.place(implement.hitchOffset.si(), 0.0)), frame.map(at)};
    drawing.drawbar.add(drawbar);
    return drawing;
}

}  // namespace furrow
