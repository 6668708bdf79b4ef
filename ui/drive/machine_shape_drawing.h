#pragma once

#include "planner/machine/machine.h"
#include "planner/plan/drive_course.h"
#include "ui/map/map_frame.h"
#include "ui/map/mesh.h"

namespace furrow {

/// How the implement is carried.
enum class Carried { Down, Up, Folded };

/// A machine at one place, to scale, as meshes.
struct MachineShapeDrawing {
    FillMesh body;
    LineMesh outline;  ///< of the tractor and its wheels
    FillMesh wheels;
    FillMesh implement;
    LineMesh implementOutline;
    LineMesh drawbar;
};

/// @param least  the machine is drawn this long and wide at least, so that it can be seen from afar
MachineShapeDrawing machineDrawing(const Machine& machine, const DriveState& state, Carried carried,
                                   const MapFrame& frame, Length least);

}  // namespace furrow
