#pragma once

#include <QObject>
#include <QtQml/qqmlregistration.h>

#include <optional>

namespace furrow {

/// A number typed by a person, with decimal point or comma and with or without a unit behind it.
std::optional<double> parsedNumber(const QString& text);

/// Numbers as fields show and read them.
class NumberText : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_SINGLETON

public:
    /// Whether `text` is a number.
    Q_INVOKABLE bool isNumber(const QString& text) const { return parsedNumber(text).has_value(); }
    /// The number; 0 where it is none.
    Q_INVOKABLE double number(const QString& text) const { return parsedNumber(text).value_or(0.0); }
    /// With this many decimals, in the user's locale, without grouping.
    Q_INVOKABLE QString text(double value, int decimals) const;
};

}  // namespace furrow
