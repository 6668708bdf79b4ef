#pragma once

#include <string>

namespace furrow {

// Coordinate systems by what files call them. Only what is understood without asking anybody: codes, names,
// well-known text, the addresses of OGC's register.

bool isKnownSystem(const std::string& name);

/// Two that are known; whichever of longitude and latitude either names first.
bool areSameSystem(const std::string& a, const std::string& b);

}  // namespace furrow
