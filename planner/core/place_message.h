#pragma once

#include "planner/core/geo_point.h"
#include "planner/core/message.h"

#include <algorithm>

namespace furrow {

/// A place within a sentence: longitude and latitude, as files have them. A window knows it by its decimals
/// (isPlace) and shows it its own way.
inline Message placeMessage(GeoPoint place) {
    return message("{:.7f}, {:.7f}", place.lonDeg, place.latDeg);
}

/// It is one of placeMessage.
inline bool isPlace(const Message& message) {
    constexpr int kDecimals = 7;
    const auto& arguments = message.arguments();
    return arguments.size() == 2 && message.key() == "%1, %2" &&
           std::ranges::all_of(arguments, [](const MessageArgument& argument) {
               return argument.kind == MessageArgument::Kind::Number && argument.decimals == kDecimals;
           });
}

}  // namespace furrow
