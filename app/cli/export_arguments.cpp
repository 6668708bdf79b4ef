#include "app/cli/export_arguments.h"

namespace furrow::cli {

void addExportOptions(CLI::App& command, ExportOptions& options, bool ofPlans) {
    command.add_flag("--holes-as-obstacles", options.holesAsObstacles,
                     "ISOXML: holes as areas of their own, for terminals that overlook inner rings");
    command.add_flag("--ascii-names", options.asciiNames, "ISOXML, AgOpenGPS: names in plain letters");
    if (ofPlans) {
        command.add_flag("--headland-lines", options.headlandLines,
                         "Headland passes as guidance curves of their own (ISOXML, AgOpenGPS, AgGPS)");
    }
}

}  // namespace furrow::cli
