#pragma once

#include "planner/units/quantity.h"

#include <QString>

namespace furrow {

/// Quantities as people read them, in the user's locale: hectares, metres or kilometres, km/h, hours.
QString areaText(Area area);
QString lengthText(Length length);
/// With this many decimals, always in metres.
QString metresText(Length length, int decimals);
QString speedText(Speed speed);
QString durationText(Duration duration);
QString percentText(double share, int decimals = 0);
QString numberText(double value, int decimals);
/// Of a swath heading: "100°".
QString bearingText(Angle swathHeading);
/// Without decimals that are zero.
QString shortNumberText(double value, int mostDecimals);

QString fromStd(std::string_view text);

}  // namespace furrow
