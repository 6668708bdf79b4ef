#pragma once

#include <compare>
#include <numbers>

namespace furrow {

/// A scalar in SI units that cannot be mistaken for one of another kind.
template <class Tag>
class Quantity {
public:
    constexpr Quantity() = default;
    static constexpr Quantity fromSi(double value) { return Quantity{value}; }
    /// The plain number in SI units (m, m², m/s, s, rad, 1/m ...).
    constexpr double si() const { return value_; }

    friend constexpr auto operator<=>(Quantity, Quantity) = default;
    friend constexpr Quantity operator+(Quantity a, Quantity b) { return Quantity{a.value_ + b.value_}; }
    friend constexpr Quantity operator-(Quantity a, Quantity b) { return Quantity{a.value_ - b.value_}; }
    friend constexpr Quantity operator-(Quantity a) { return Quantity{-a.value_}; }
    friend constexpr Quantity operator*(Quantity a, double k) { return Quantity{a.value_ * k}; }
    friend constexpr Quantity operator*(double k, Quantity a) { return Quantity{a.value_ * k}; }
    friend constexpr Quantity operator/(Quantity a, double k) { return Quantity{a.value_ / k}; }
    friend constexpr double operator/(Quantity a, Quantity b) { return a.value_ / b.value_; }
    constexpr Quantity& operator+=(Quantity other) {
        value_ += other.value_;
        return *this;
    }

private:
    constexpr explicit Quantity(double value) : value_{value} {}
    double value_ = 0.0;
};

using Length = Quantity<struct LengthTag>;
using Area = Quantity<struct AreaTag>;
using Speed = Quantity<struct SpeedTag>;
using Acceleration = Quantity<struct AccelerationTag>;
using Duration = Quantity<struct DurationTag>;
/// Radians. A swath heading is modulo pi, a pose heading modulo 2 pi, both counter-clockwise from east.
using Angle = Quantity<struct AngleTag>;
/// 1/m, positive to the left along the vehicle's nose.
using Curvature = Quantity<struct CurvatureTag>;
/// 1/m², change of curvature along the path.
using CurvatureRate = Quantity<struct CurvatureRateTag>;

constexpr Length metres(double value) {
    return Length::fromSi(value);
}
constexpr Area squareMetres(double value) {
    return Area::fromSi(value);
}
constexpr Speed metresPerSecond(double value) {
    return Speed::fromSi(value);
}
constexpr Duration seconds(double value) {
    return Duration::fromSi(value);
}
constexpr Angle radians(double value) {
    return Angle::fromSi(value);
}
constexpr Angle degrees(double value) {
    return Angle::fromSi(value * std::numbers::pi / 180.0);
}
constexpr double inDegrees(Angle angle) {
    return angle.si() * 180.0 / std::numbers::pi;
}
constexpr double inHectares(Area area) {
    return area.si() / 1e4;
}

}  // namespace furrow
