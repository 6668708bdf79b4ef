#pragma once

#include <QtQml/qqmlregistration.h>
#include <QObject>
#include <QString>

#include <optional>

namespace furrow {

/// What fields show and read, in SI units on this side (metres, square metres, metres per second, seconds;
/// angles in degrees) and in the user's units on the other. The one place where typed values are read.
class QuantityText : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Display.quantities has them")

public:
    enum Kind { Number, Length, Area, Speed, Angle, Duration, Count };
    Q_ENUM(Kind)

    /// The value that was typed: a number in the user's units, or with units of either system behind it ("7,3
    /// m", "24 ft", "10'6\"", "30 cm", "5 mph", "3 ac", "90°"); decimal point or comma. Nothing where it is
    /// not that; a count is a whole number.
    static std::optional<double> parsed(const QString& text, Kind kind);

    Q_INVOKABLE bool isValue(const QString& text, furrow::QuantityText::Kind kind) const {
        return parsed(text, kind).has_value();
    }
    /// 0 where it is none.
    Q_INVOKABLE double value(const QString& text, furrow::QuantityText::Kind kind) const {
        return parsed(text, kind).value_or(0.0);
    }
    /// The number alone, with as many decimals as `decimals` says of the SI value or what comes nearest.
    Q_INVOKABLE QString text(double value, furrow::QuantityText::Kind kind, int decimals) const;
    /// "ft"; empty for plain numbers.
    Q_INVOKABLE QString unit(furrow::QuantityText::Kind kind) const;
    /// How much of the SI value one of the user's unit is.
    Q_INVOKABLE double unitSize(furrow::QuantityText::Kind kind) const;
    /// A step that is round in the user's unit and about `step`, in SI units.
    Q_INVOKABLE double roundStep(double step, furrow::QuantityText::Kind kind) const;
    /// Why a text is refused and what would do; empty where it is taken.
    Q_INVOKABLE QString complaint(const QString& text, furrow::QuantityText::Kind kind, double from,
                                  double to, int decimals) const;
    /// The round length nearest below so many metres, for scale bars; in SI units.
    Q_INVOKABLE double roundLengthBelow(double metres) const;
    /// "200 m", "1 km", "500 ft", "2 mi".
    Q_INVOKABLE QString scaleText(double metres) const;
};

}  // namespace furrow
