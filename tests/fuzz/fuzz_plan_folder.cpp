#include "planner/audit/audit.h"
#include "planner/io/plan_files/plan_reader.h"
#include "planner/sheet/order_sheet.h"
#include "tests/fuzz/joined_files.h"

#include <cstdint>

using namespace furrow;

/// Whatever the bytes are: no crash, no bad address, no memory without bounds. A written plan is read back,
/// audited, and put on a work order.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const std::filesystem::path folder = fuzz::ownFolder();
    fuzz::writeDivided({reinterpret_cast<const char*>(data), size}, folder,
                       {"summary.json", "plan.geojson", "path.csv"});
    if (const auto plan = readPlan(folder)) {
        (void)audit(auditInput(*plan));
    }
    (void)readOrderSheet(folder);
    return 0;
}
