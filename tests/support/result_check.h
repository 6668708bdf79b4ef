#pragma once

#include <QTest>

/// Ends the test with the error's own words where a Result holds no value.
#define VERIFY_RESULT(result) \
    QVERIFY2((result).has_value(), (result).has_value() ? "" : (result).error().line().c_str())

/// QVERIFY2 whose message is only put together where it is needed: for loops over thousands of cases.
#define VERIFY_TOLD(condition, message)                                            \
    do {                                                                           \
        if (!(condition)) {                                                        \
            QFAIL((QByteArray{#condition " is false: "} + (message)).constData()); \
        }                                                                          \
    } while (false)

/// Compares two numbers up to an absolute tolerance and says both where they differ.
#define COMPARE_WITHIN(actual, expected, tolerance)                          \
    do {                                                                     \
        const double comparedActual = (actual);                              \
        const double comparedExpected = (expected);                          \
        QVERIFY2(std::abs(comparedActual - comparedExpected) <= (tolerance), \
                 qPrintable(QStringLiteral("%1 is %2, not %3")               \
                                .arg(QLatin1String(#actual))                 \
                                .arg(comparedActual, 0, 'g', 15)             \
                                .arg(comparedExpected, 0, 'g', 15)));        \
    } while (false)
