#include "app/cli/convert_command.h"

#include "app/cli/exit_status.h"
#include "app/cli/export_arguments.h"
#include "app/cli/terminal.h"
#include "planner/field/outline_steps.h"
#include "planner/io/delivery/field_files.h"
#include "planner/io/import/boundary_import.h"
#include "planner/io/import/field_reader.h"
#include "planner/io/import/track_reader.h"
#include "planner/track/track_outline.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <format>
#include <iterator>
#include <memory>
#include <optional>
#include <print>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace furrow::cli {

namespace {

using Json = nlohmann::ordered_json;

struct ConvertArguments {
    std::string in;
    std::string out;
    std::optional<std::string> format;
    std::optional<std::string> fieldId;
    std::string fromTrack;  ///< empty: boundaries are read
    double widthM = 6.0;
    double beyondM = 0.0;
    std::optional<double> gapM;
    bool straightensSteps = false;
    ExportOptions options;
    bool json = false;
};

constexpr std::string_view kTrackKinds[] = {"auto", "round", "worked"};

/// The land that a recorded track goes around, or was worked along.
Result<ImportedFields> fieldsFromTrack(const ConvertArguments& arguments, const JobContext& job) {
    const auto file = readTracks(arguments.in, job);
    if (!file) {
        return std::unexpected(file.error());
    }
    TrackOutlineOptions options{.width = metres(arguments.widthM), .beyond = metres(arguments.beyondM)};
    if (arguments.fromTrack != kTrackKinds[0]) {
        options.kind = arguments.fromTrack == kTrackKinds[1] ? TrackKind::Round : TrackKind::Worked;
    }
    if (arguments.gapM) {
        options.gap = metres(*arguments.gapM);
    }
    const auto outline = outlineOfTracks(file->tracks, options, job);
    if (!outline) {
        return std::unexpected(outline.error());
    }
    const std::filesystem::path path{arguments.in};
    ImportedFields imported;
    imported.notes = file->notes;
    imported.notes.push_back({.text = outline->kind == TrackKind::Round
                                          ? Message{"The track was driven around the field."}
                                          : Message{"The field was worked along the track."},
                              .where = {},
                              .place = {}});
    imported.notes.insert(imported.notes.end(), outline->notes.begin(), outline->notes.end());
    for (FieldSource& field : fieldsOf(*outline, path.stem().string(), path.filename().string())) {
        imported.fields.push_back({.field = std::move(field)});
    }
    return imported;
}

/// The field with the steps of its outline made straight. Where that would be refused they stay; both is
/// noted. Cancelled.
Result<Field> straightened(Field field, std::vector<std::string>& notes, const JobContext& job) {
    const auto steps = stepsOf(field.source());
    if (!steps) {
        return field;
    }
    FieldSource mended = field.source();
    mended.repairs = field.repairs();
    auto straight = withStraightSteps(mended, job).and_then([&](const FieldSource& source) {
        return Field::create(source, job);
    });
    if (straight) {
        notes.push_back(std::format("'{}': {} steps of about {:.1f} m were made straight", field.name(),
                                    steps->count, steps->height.si()));
    } else if (straight.error().code != ErrorCode::Cancelled) {
        notes.push_back(std::format("'{}': its steps stay; made straight, it would be refused: {}",
                                    field.name(), straight.error().line()));
        return field;
    }
    return straight;
}

/// What is read, checked and repaired; what is refused is left out, as long as something remains, and named
/// in `leftOut`.
Result<std::vector<FieldContent>> fieldsFrom(const ConvertArguments& arguments,
                                             std::vector<std::string>& notes,
                                             std::vector<std::string>& leftOut, const JobContext& job) {
    auto imported =
        arguments.fromTrack.empty() ? readFields(arguments.in, job) : fieldsFromTrack(arguments, job);
    if (!imported) {
        return std::unexpected(imported.error());
    }
    const auto tell = [&notes](const Note& note) {
        notes.push_back(note.where.empty() ? note.text.text()
                                           : std::format("{} ({})", note.text.text(), note.where.text()));
    };
    for (const Note& note : imported->notes) {
        tell(note);
    }
    if (!imported->looseLines.empty()) {
        notes.push_back(std::format("{} guidance lines that belong to no field are left out",
                                    imported->looseLines.size()));
    }
    std::vector<FieldSource> sources;
    for (const FieldContent& content : imported->fields) {
        sources.push_back(content.field);
    }
    std::optional<FieldSource> only;
    if (arguments.fieldId) {
        auto picked = pickField(sources, *arguments.fieldId);
        if (!picked) {
            return std::unexpected(picked.error());
        }
        only = *std::move(picked);
    }
    std::vector<FieldContent> fields;
    std::optional<Error> refused;
    for (FieldContent& content : imported->fields) {
        if (only && !(content.field == *only)) {
            continue;
        }
        auto field = Field::create(content.field, job);
        if (field && arguments.straightensSteps) {
            field = straightened(*std::move(field), notes, job);
        }
        if (!field && field.error().code == ErrorCode::Cancelled) {
            return std::unexpected(field.error());
        }
        if (!field) {
            leftOut.push_back(std::format("'{}' is left out: {}", content.field.name, field.error().line()));
            refused = refused.value_or(field.error());
            continue;
        }
        for (const Note& repair : field->repairs()) {
            tell({std::format("'{}': {}", content.field.name, repair.text.text()), repair.where, {}});
        }
        content.field = field->source();
        content.area = field->area();
        fields.push_back(std::move(content));
    }
    if (fields.empty()) {
        return std::unexpected(refused.value_or(Error{.code = ErrorCode::InputRefused,
                                                      .what = "there is no field in it, only guidance lines",
                                                      .where = arguments.in,
                                                      .remedy = "export the field with its boundary"}));
    }
    return fields;
}

int runConvert(const ConvertArguments& arguments) {
    const InterruptWatch watch;
    const JobContext job = terminalJob(watch, 0, true);
    std::vector<std::string> notes;
    std::vector<std::string> leftOut;
    const auto fields = fieldsFrom(arguments, notes, leftOut, job);
    if (!fields) {
        return failWith(fields.error());
    }
    const auto written = writeFields(*fields, arguments.out, arguments.format, arguments.options, job);
    if (!written) {
        return failWith(written.error());
    }
    notes.insert(notes.end(), written->notes.begin(), written->notes.end());
    printProblems(written->checks);
    for (const std::string& field : leftOut) {
        say(stderr, "furrow-cli: {}", field);
    }
    const ExitStatus status = leftOut.empty() ? kDrivable : kBlockingFinding;
    if (arguments.json) {
        Json files = Json::array();
        for (const auto& file : written->files) {
            files.push_back(file.string());
        }
        Json names = Json::array();
        for (const FieldContent& content : *fields) {
            names.push_back({{"id", content.field.id},
                             {"name", content.field.name},
                             {"area_m2", content.statedArea().si()},
                             {"obstacles", content.field.obstacles.size()},
                             {"lines", content.lines.size()}});
        }
        Json problems = Json::array();
        for (const std::string& problem : written->checks.problems) {
            problems.push_back(problem);
        }
        const Json checks{{"made", written->checks.made}, {"problems", problems}};
        std::println("{}", Json{{"fields", names},
                                {"left_out", leftOut},
                                {"files", files},
                                {"notes", notes},
                                {"checks", checks}}
                               .dump(2, ' ', false, Json::error_handler_t::replace));
        return status;
    }
    for (const FieldContent& content : *fields) {
        say("{:24}  {:.2f} ha  {} obstacles  {} guidance lines", content.field.name,
            inHectares(content.statedArea()), content.field.obstacles.size(), content.lines.size());
    }
    for (const std::string& note : notes) {
        say("Note: {}", note);
    }
    say("Checked: {}", checkSummary(written->checks));
    say("Written:");
    for (const auto& file : written->files) {
        say("  {}", file.string());
    }
    return status;
}

}  // namespace

void addConvertCommand(CLI::App& app, std::function<int()>& run) {
    const auto arguments = std::make_shared<ConvertArguments>();
    CLI::App* convert =
        app.add_subcommand("convert", "Read fields from one format and write them in another.");
    convert->add_option("IN", arguments->in, "A file or folder; furrow-cli list formats shows what is read")
        ->required();
    convert->add_option("OUT", arguments->out, "A file whose name says the format, or a folder")->required();
    convert->add_option("--format", arguments->format, "The format, where the name of OUT does not say it");
    convert->add_option("--field-id", arguments->fieldId,
                        "One field: its id, its name, or its number from 1");
    CLI::Option* track =
        convert
            ->add_option(
                "--from-track", arguments->fromTrack,
                "IN is a recorded track: 'round', driven around the field; 'worked', over all of it; "
                "'auto', as it looks")
            ->check(CLI::IsMember(std::vector<std::string>(std::begin(kTrackKinds), std::end(kTrackKinds))));
    convert->add_option("--width", arguments->widthM, "Operating width on that track, m (6)")->needs(track);
    convert
        ->add_option("--beyond", arguments->beyondM,
                     "How far the edge lies outside of a track around the field, m (0)")
        ->needs(track);
    convert
        ->add_option("--gap", arguments->gapM,
                     "Gaps between strips up to this belong to worked land, m (one width)")
        ->needs(track);
    convert->add_flag("--straighten-steps", arguments->straightensSteps,
                      "Lead outlines that were traced along the pixels of an image through the middles\n"
                      "of their steps; others stay as they are");
    addExportOptions(*convert, arguments->options, false);
    convert->add_flag("--json", arguments->json, "Print one JSON object and nothing else");
    convert->footer(
        "Examples:\n"
        "  furrow-cli convert field.kml field.geojson\n"
        "  furrow-cli convert TASKDATA fields.gpkg\n"
        "  furrow-cli convert farm.shp TASKDATA --format isoxml-v3\n"
        "  furrow-cli convert drive.gpx field.geojson --from-track auto --width 24\n"
        "  furrow-cli convert traced.geojson straight.geojson --straighten-steps\n"
        "\n"
        "Exit status: 0 all fields are written, 1 some are left out and named on standard error,\n"
        "2 wrong usage, 3 input refused, 4 could not read or write, 130 cancelled.");
    convert->callback([&run, arguments] { run = [arguments] { return runConvert(*arguments); }; });
}

}  // namespace furrow::cli
