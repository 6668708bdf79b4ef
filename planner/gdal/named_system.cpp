#include "planner/gdal/named_system.h"

#include <cpl_error.h>
#include <ogr_spatialref.h>

#include <optional>

namespace furrow {

namespace {

std::optional<OGRSpatialReference> systemCalled(const std::string& name) {
    OGRSpatialReference system;
    CPLPushErrorHandler(CPLQuietErrorHandler);
    const bool known =
        system.SetFromUserInput(name.c_str(), OGRSpatialReference::SET_FROM_USER_INPUT_LIMITATIONS_get()) ==
        OGRERR_NONE;
    CPLPopErrorHandler();
    return known ? std::optional{system} : std::nullopt;
}

}  // namespace

bool isKnownSystem(const std::string& name) {
    return systemCalled(name).has_value();
}

bool areSameSystem(const std::string& a, const std::string& b) {
    constexpr const char* kOptions[] = {"CRITERION=EQUIVALENT_EXCEPT_AXIS_ORDER_GEOGCRS",
                                        "IGNORE_DATA_AXIS_TO_SRS_AXIS_MAPPING=YES", nullptr};
    const auto first = systemCalled(a);
    const auto second = systemCalled(b);
    return first && second && first->IsSame(&*second, kOptions) != 0;
}

}  // namespace furrow
