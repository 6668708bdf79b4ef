#pragma once

namespace furrow {

// Units that people measure in, in SI units. Exact by definition (international foot, 1959).
inline constexpr double kFootM = 0.3048;
inline constexpr double kInchM = kFootM / 12.0;
inline constexpr double kYardM = 3.0 * kFootM;
inline constexpr double kMileM = 5280.0 * kFootM;
inline constexpr double kHectareM2 = 1e4;
inline constexpr double kAcreM2 = 43560.0 * kFootM * kFootM;
inline constexpr double kKilometrePerHourMps = 1.0 / 3.6;
inline constexpr double kMilePerHourMps = kMileM / 3600.0;

}  // namespace furrow
