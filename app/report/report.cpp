#include "app/report/report.h"

#include "app/cli/exit_status.h"
#include "app/cli/report_command.h"
#include "app/cli/terminal.h"
#include "planner/core/text_file.h"
#include "planner/io/content/field_choice.h"
#include "planner/io/files/atomic_files.h"
#include "planner/io/files/file_folder.h"
#include "planner/plan/advice.h"
#include "planner/project/field_tasks.h"
#include "planner/project/project_file.h"
#include "ui/pages/page_files.h"
#include "ui/text/display.h"
#include "ui/text/unit_text.h"

#include <QDateTime>

#include <algorithm>
#include <filesystem>
#include <print>
#include <utility>
#include <vector>

namespace furrow::cli {

namespace {

namespace fs = std::filesystem;

enum class Kind { Pdf, Png, Svg };

Result<Kind> kindOf(const fs::path& out) {
    std::string extension = out.extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    for (const auto& [known, kind] :
         {std::pair{".pdf", Kind::Pdf}, {".png", Kind::Png}, {".svg", Kind::Svg}}) {
        if (extension == known) {
            return kind;
        }
    }
    return std::unexpected(Error{.code = ErrorCode::Usage,
                                 .what = message("{} is no file that a work order can be", out.string()),
                                 .where = "--out",
                                 .remedy = "name a .pdf, .png or .svg"});
}

Result<std::optional<WorkOrder>> givenOrder(const std::string& file) {
    if (file.empty()) {
        return std::optional<WorkOrder>{};
    }
    return fileBytes(file)
        .and_then([&file](const std::string& text) { return parseWorkOrder(text, file); })
        .transform([](WorkOrder order) { return std::optional{std::move(order)}; });
}

OrderedPlan orderedPlan(OrderSheet sheet, WorkOrder order) {
    OrderedPlan plan{.sheet = {},
                     .order = std::move(order),
                     .planName = {},
                     .season = {},
                     .hash = planHash(sheet.pathFile)};
    sheet.pathFile = {};
    plan.sheet = std::make_shared<const OrderSheet>(std::move(sheet));
    return plan;
}

Result<OrderSheet> plannedSheet(const ProjectField& field, const FieldPlan& plan, const JobContext& job) {
    return planOfSource(*field.source, plan.machine, plan.settings, job.part(0.0, 0.9))
        .and_then([&job](const auto& finished) { return withAdvice(finished, job.part(0.9, 1.0)); })
        .and_then([](const auto& finished) { return orderSheet(*finished); });
}

Error oneFieldOnly() {
    return {.code = ErrorCode::Usage,
            .what = "a picture shows one field, and this project has several",
            .where = "--field-id",
            .remedy = "say which, or write a .pdf of all of them"};
}

Result<PrintJob> jobOfProject(const ReportArguments& arguments, Kind kind, const JobContext& job) {
    const auto opened = readProject(arguments.source);
    if (!opened) {
        return std::unexpected(opened.error());
    }
    const Project& project = opened->project;
    if (project.fields.empty()) {
        return std::unexpected(Error{.code = ErrorCode::InputRefused,
                                     .what = "there is no field in this project",
                                     .where = arguments.source,
                                     .remedy = "draw or open one in the window first"});
    }
    std::vector<std::size_t> wanted;
    if (arguments.fieldId) {
        std::vector<FieldSource> sources;
        sources.reserve(project.fields.size());
        for (const auto& field : project.fields) {
            sources.push_back(*field->source);
        }
        const auto index = pickFieldIndex(sources, arguments.fieldId);
        if (!index) {
            return std::unexpected(index.error());
        }
        wanted = {*index};
    } else {
        for (std::size_t i = 0; i < project.fields.size(); ++i) {
            wanted.push_back(i);
        }
    }
    if (kind != Kind::Pdf && wanted.size() > 1) {
        return std::unexpected(oneFieldOnly());
    }
    PrintJob print{.farm = fromStd(project.name), .wholeFarm = wanted.size() > 1};
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const ProjectField& field = *project.fields[wanted[i]];
        const FieldPlan& plan = wanted[i] == project.currentField ? project.plan() : field.plans.front();
        const auto count = static_cast<double>(wanted.size());
        auto sheet = plannedSheet(
            field, plan, job.part(static_cast<double>(i) / count, static_cast<double>(i + 1) / count));
        if (!sheet) {
            Error error = sheet.error();
            if (wanted.size() > 1 && error.code != ErrorCode::Cancelled) {
                error.where = message("field '{}', {}", field.source->name, error.where);
            }
            return std::unexpected(error);
        }
        print.plans.push_back(orderedPlan(*std::move(sheet), plan.order));
        print.plans.back().planName = fromStd(plan.name);
        print.plans.back().season = fromStd(plan.season);
        print.plans.back().comments = plan.review.openComments();
    }
    return print;
}

Result<PrintJob> jobOfFolder(const ReportArguments& arguments) {
    if (arguments.fieldId) {
        return std::unexpected(Error{.code = ErrorCode::Usage,
                                     .what = "the folder of a plan has one field",
                                     .where = "--field-id",
                                     .remedy = "leave it out, or give a project of the window"});
    }
    return readOrderSheet(arguments.source).transform([](OrderSheet sheet) {
        return PrintJob{.farm = {}, .plans = {orderedPlan(std::move(sheet), {})}};
    });
}

Result<std::string> fileOf(const PrintJob& print, Kind kind, const JobContext& job) {
    const WorkOrderPages pages{print};
    const QString title = print.wholeFarm ? print.farm : fromStd(print.plans.front().sheet->fieldName);
    const auto goOn = [&job](int) { return !job.stopRequested(); };
    const QByteArray bytes = kind == Kind::Pdf   ? pdfOf(pages, title, goOn)
                             : kind == Kind::Png ? pngOf(pages)
                                                 : svgOf(pages, title);
    return job.stopRequested() ? Result<std::string>{std::unexpected(cancelled())} : bytes.toStdString();
}

Result<void> written(const fs::path& out, const std::string& bytes, const JobContext& job) {
    const fs::path whole = fs::absolute(out);
    const FileToWrite files[] = {{whole.filename(), [&bytes] { return bytes; }}};
    return writeTogether(whole.parent_path(), files, job).transform([](const auto&) {});
}

}  // namespace

int runReport(const ReportArguments& arguments, const InterruptWatch& watch) {
    const JobContext job = terminalJob(watch, arguments.threads, false);
    const auto kind = kindOf(arguments.out);
    if (!kind) {
        return failWith(kind.error());
    }
    const auto order = givenOrder(arguments.order);
    if (!order) {
        return failWith(order.error());
    }
    Display::instance().force(QString::fromStdString(arguments.language),
                              arguments.units == "imperial" ? Display::Imperial : Display::Metric);
    std::error_code ignored;
    auto print = fs::is_directory(arguments.source, ignored)
                     ? jobOfFolder(arguments)
                     : jobOfProject(arguments, *kind, job.part(0.0, 0.95));
    if (print) {
        print->paper = arguments.paper == "letter" ? PaperSize::Letter : PaperSize::A4;
        print->printed = QDateTime::currentDateTime();
        for (OrderedPlan& plan : print->plans) {
            plan.order = order->value_or(plan.order);
        }
    }
    const auto done =
        print.and_then([&](const PrintJob& ready) { return fileOf(ready, *kind, job); })
            .and_then([&](const std::string& bytes) { return written(arguments.out, bytes, job); });
    clearProgress(false);
    if (!done) {
        return failWith(done.error());
    }
    std::println("Written: {}", arguments.out);
    const bool drivable = std::ranges::all_of(
        print->plans, [](const OrderedPlan& plan) { return plan.sheet->blockingCount() == 0; });
    return drivable ? kDrivable : kBlockingFinding;
}

}  // namespace furrow::cli
