#pragma once

#include "planner/core/result.h"
#include "planner/io/content/format_parts.h"

#include <span>
#include <string_view>

namespace furrow {

/// What a receiver has to find in the files of a format of all that is meant; see checkExport.
struct CarriedContent {
    bool fields = false;            ///< an area for each part
    bool holes = false;             ///< as inner rings
    bool holesApart = false;        ///< as areas of their own where ExportOptions::holesAsObstacles says so
    bool obstaclesAsHoles = false;  ///< in the part that they lie in
    bool holesAsFields = false;     ///< nothing but outlines
    bool lines = false;             ///< guidance lines
    bool swaths = false;            ///< of a plan; without one guidance lines
    bool path = false;
    bool pathAlone = false;  ///< of a plan no fields
};

/// One file format: what Furrow does with it. A part that it does not do is null.
struct Format {
    std::string_view id;          ///< as in `--format`
    std::string_view name;        ///< "GeoJSON"
    std::string_view extensions;  ///< "geojson json"
    std::string_view carries;     ///< one sentence: what a reader finds in it

    struct Fields {
        FormatRecogniser* recognise = nullptr;
        FieldReader* read = nullptr;
    };
    Fields fields = {};  ///< as they are read

    struct Writing {
        FormatWriter* write = nullptr;  ///< of plans
        bool fieldsAlone = false;       ///< also of fields without a plan
        bool fieldsTogether = false;    ///< receivers look for all fields in one set of files
        std::string_view folder = {};   ///< of a plan's folder, where it goes; empty for its top
        ContentFinder* find = nullptr;  ///< of all that is written
        CarriedContent content = {};
    };
    Writing writing = {};

    struct Tracks {
        FormatRecogniser* recognise = nullptr;
        TrackReader* read = nullptr;
    };
    Tracks tracks = {};  ///< what a machine drove, to compare with a plan

    bool readsFields() const { return fields.read != nullptr; }
    bool writes() const { return writing.write != nullptr; }
    bool writesFields() const { return writes() && writing.fieldsAlone; }
    bool readsTracks() const { return tracks.read != nullptr; }
};

/// Every format, in the order in which people see them.
std::span<const Format> formats();

/// Null where there is none of this id.
const Format* formatCalled(std::string_view id);

/// A format that plans can be written to. Usage: there is none of that name; the message lists them.
Result<const Format*> findPlanFormat(std::string_view id);

/// The format that is surest that a file or folder is its own.
struct RecognisedFormat {
    const Format* format = nullptr;  ///< null where none knows it
    Recognition how = Recognition::No;
};
RecognisedFormat recognisedAsFields(const ChosenFile& chosen);
RecognisedFormat recognisedAsTracks(const ChosenFile& chosen);

}  // namespace furrow
