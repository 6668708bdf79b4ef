#pragma once

#include <QTest>

// What a test waits for comes at once on an idle machine and late on a busy one. QtTest gives up after five
// seconds by itself.
inline constexpr int kPatienceMs = 120'000;
#undef QTRY_VERIFY
#define QTRY_VERIFY(...) QTRY_VERIFY_WITH_TIMEOUT((__VA_ARGS__), kPatienceMs)
#undef QTRY_COMPARE
#define QTRY_COMPARE(...) QTRY_COMPARE_WITH_TIMEOUT(__VA_ARGS__, kPatienceMs)
