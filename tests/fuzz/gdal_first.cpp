#include "planner/gdal/drivers.h"

#include <sanitizer/lsan_interface.h>

/// GDAL loses a few kilobytes while it registers its drivers, once for the process. It would be told as a
/// fault at the end of each run.
extern "C" int LLVMFuzzerInitialize(int* /*argc*/, char*** /*argv*/) {
    __lsan_disable();
    furrow::registerGdalDrivers();
    __lsan_enable();
    return 0;
}
