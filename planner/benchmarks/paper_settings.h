#pragma once

#include "planner/core/result.h"
#include "planner/geometry/polygon.h"
#include "planner/machine/machine.h"
#include "planner/settings/settings.h"

#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace furrow {

class Field;

/// The paper's robot: 2.5 m wide, 2.1 m of turning radius, working at its reference point.
Machine paperMachine();

/// The paper's set-up, with the given settings added: 7.5 m of headland that is not driven, no decomposition,
/// every whole degree, flat swath ends, gaps rather than overlaps, the first corner, Dubins curves that may
/// leave the field. Errors of applySetting for settings and methods that the planner does not have.
Result<Settings> paperSettings(std::initializer_list<std::pair<std::string_view, std::string_view>> own);

/// The same outline, moved to the origin and scaled to an area.
Polygon scaledTo(const Polygon& outline, Area area);

/// A field of this outline, in metres around an arbitrary place.
Result<std::shared_ptr<const Field>> fieldOf(const Polygon& outline, const std::string& name);

/// The circle-like (CIR_B) and slanted (SAL_B) shapes and the rectangle (REC_A) of Nilsson and Zhou, as far
/// as the paper shows them; 100 m².
Polygon paperRectangle();
Polygon paperCircle();
Polygon paperSlanted();

}  // namespace furrow
