#include "planner/core/text.h"
#include "planner/io/files/file_folder.h"
#include "planner/io/import/field_reader.h"
#include "planner/io/import/track_reader.h"
#include "tests/planner/io/format_cases.h"
#include "tests/support/large_data.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>

using namespace furrow;
using namespace furrow::test;

namespace {

namespace fs = std::filesystem;

const fs::path kShared = test::largeDataPath("");
const fs::path kExpected = FURROW_TEST_DATA_DIR "/shared_formats.txt";

/// Files that only belong to others.
bool isCompanion(const fs::path& file) {
    constexpr std::array<std::string_view, 8> kEndings = {".shx", ".dbf", ".prj", ".cpg",
                                                          ".bin", ".md",  ".js",  ".py"};
    return std::ranges::contains(kEndings, extensionInSmallLetters(file));
}

/// What became of it in one line: a field's counts, a track's samples, or why it is refused.
std::string outcomeOf(const fs::path& path) {
    const auto read = readFields(path);
    if (read) {
        std::size_t parts = 0;
        std::size_t holes = 0;
        std::size_t obstacles = 0;
        std::size_t lines = read->looseLines.size();
        for (const FieldContent& content : read->fields) {
            parts += content.field.parts.size();
            for (const GeoPolygon& part : content.field.parts) {
                holes += part.holes.size();
            }
            obstacles += content.field.obstacles.size();
            lines += content.lines.size();
        }
        return std::format("{} fields, {} parts, {} holes, {} obstacles, {} lines, {} notes",
                           read->fields.size(), parts, holes, obstacles, lines, read->notes.size());
    }
    const auto tracks = fs::is_regular_file(path) || fs::exists(path / "metadata.yaml")
                            ? readTracks(path)
                            : std::unexpected(read.error());
    if (tracks) {
        std::size_t samples = 0;
        for (const auto& track : tracks->tracks) {
            samples += track.samples.size();
        }
        return std::format("{} tracks, {} samples", tracks->tracks.size(), samples);
    }
    const Error& why = read.error();
    return why.what.empty() || why.remedy.empty() ? "refused without a reason" : "refused: " + why.what;
}

/// By the path below the shared folder.
std::map<std::string, std::string> expectedOutcomes() {
    std::map<std::string, std::string> all;
    std::ifstream file{kExpected};
    for (std::string line; std::getline(file, line);) {
        const std::size_t tab = line.find('\t');
        if (tab != std::string::npos) {
            all[line.substr(0, tab)] = line.substr(tab + 1);
        }
    }
    return all;
}

std::vector<fs::path> everything() {
    std::vector<fs::path> all;
    for (const char* folder : {"formats", "tracks"}) {
        for (const auto& entry : fs::recursive_directory_iterator{kShared / folder}) {
            const bool file = entry.is_regular_file() && !isCompanion(entry.path());
            // Folders that are a data set: of a terminal, of AgOpenGPS, a recording.
            const bool set =
                entry.is_directory() &&
                (fs::exists(entry.path() / "TASKDATA.XML") || fs::exists(entry.path() / "TASKDATA.xml") ||
                 fs::exists(entry.path() / "Field.txt") || fs::exists(entry.path() / "metadata.yaml") ||
                 entry.path().filename() == "AgGPS");
            if (file || set) {
                all.push_back(entry.path());
            }
        }
    }
    std::ranges::sort(all);
    return all;
}

}  // namespace

/// Every file of the collection beside the project is read, or refused with a reason, as the table in
/// tests/data says.
class SharedFormatsTest : public QObject {
    Q_OBJECT

private slots:
    void isReadOrRefused_data() {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QString>("expected");
        if (!fs::exists(kShared / "formats")) {
            QSKIP("needs the formats of the large test data");
        }
        const auto expected = expectedOutcomes();
        for (const fs::path& path : everything()) {
            const std::string name = path.lexically_relative(kShared).string();
            const auto known = expected.find(name);
            QTest::newRow(name.c_str())
                << QString::fromStdString(path.string())
                << QString::fromStdString(known == expected.end() ? "" : known->second);
        }
    }

    void isReadOrRefused() {
        QFETCH(QString, path);
        QFETCH(QString, expected);
        const std::string outcome = outcomeOf(path.toStdString());
        if (qEnvironmentVariableIsSet("FURROW_UPDATE_TABLE")) {
            std::ofstream{kExpected, std::ios::app}
                << fs::path{path.toStdString()}.lexically_relative(kShared).string() << '\t' << outcome
                << '\n';
            return;
        }
        QCOMPARE(QString::fromStdString(outcome), expected);
    }
};

FURROW_TEST(SharedFormatsTest);
#include "tst_shared_formats.moc"
