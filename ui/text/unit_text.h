#pragma once

#include "planner/core/geo_point.h"
#include "planner/units/quantity.h"

#include <QString>
#include <QStringList>

#include <string_view>

namespace furrow {

/// Quantities as people read them, in the user's locale and units: hectares or acres, metres or feet,
/// kilometres or miles, km/h or mph, hours.
QString areaText(Area area);
QString lengthText(Length length);
/// With this many decimals, always in metres or feet.
QString metresText(Length length, int decimals);
/// "20 – 32.5 m"; "20.0 m" where both read the same.
QString metresText(Length least, Length most);
/// In metres or feet, without decimals that are zero.
QString shortLengthText(Length length);
/// Always in square metres or square feet, or in hectares or acres.
QString squareMetresText(Area area, int decimals);
QString hectaresText(Area area, int decimals);
QString speedText(Speed speed);
QString accelerationText(Acceleration acceleration, int decimals);
QString durationText(Duration duration);
/// To the second: "2 min 05 s".
QString exactDurationText(Duration duration);
QString percentText(double share, int decimals = 0);
QString numberText(double value, int decimals);
/// Of a swath heading: "100°".
QString bearingText(Angle swathHeading);
/// Without decimals that are zero.
QString shortNumberText(double value, int mostDecimals);

/// Latitude first: "52.001500° N, 5.001500° E". Can be typed again (placeNamedBy).
QString placeText(GeoPoint place);

/// What stands side by side in one line: "24.0 m · 2 passes".
QString inOneLine(const QStringList& parts);

QString fromStd(std::string_view text);

}  // namespace furrow
