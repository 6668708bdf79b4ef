// The plans of several fields on their way out together: a folder for each, one set of files where terminals
// look for all of them at once.

#include "planner/io/check/read_back.h"
#include "planner/io/delivery/farm_files.h"
#include "planner/io/delivery/stick_writer.h"
#include "planner/io/import/field_reader.h"
#include "planner/machine/machine_library.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>

using namespace furrow;
using namespace furrow::test;

namespace {

namespace fs = std::filesystem;

/// A rectangle so many metres wide and 100 m high.
std::shared_ptr<const Plan> planOf(const std::string& name, double widthM, double lonDeg) {
    FieldSource source = fieldSourceFromLocal({centredRectangle(widthM, 100.0)}, {lonDeg, 51.5});
    source.name = name;
    return makePlan({.field = std::make_shared<const Field>(Field::create(source).value()),
                     .machine = findMachine("cultivator").value(),
                     .settings = {}})
        .value();
}

std::vector<std::string> filesIn(const fs::path& root) {
    std::vector<std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator{root}) {
        if (entry.is_regular_file()) {
            files.push_back(entry.path().lexically_relative(root).generic_string());
        }
    }
    std::ranges::sort(files);
    return files;
}

/// Hectares of the fields that a file or folder holds, by name.
std::map<std::string, double> fieldsIn(const fs::path& path) {
    std::map<std::string, double> hectares;
    const auto read = readFields(path).value();
    for (const FieldContent& field : read.fields) {
        hectares[field.field.name] += field.statedArea().si() / 1e4;
    }
    return hectares;
}

}  // namespace

class FarmFilesTest : public QObject {
    Q_OBJECT

private slots:
    /// Two fields of 2 and 3 ha.
    void aFolderForEachAndOneTaskData() {
        const QTemporaryDir folder;
        const fs::path root{folder.path().toStdString()};
        constexpr std::array<std::string_view, 3> kFormats{"geojson", "isoxml", "csv"};
        FarmFolder farm = FarmFolder::at(root, kFormats).value();
        QCOMPARE(farm.add(*planOf("Long Acre", 200.0, 9.5)).value().files.size(), std::size_t{3});
        QCOMPARE(farm.add(*planOf("Glebe", 300.0, 9.51)).value().files.size(), std::size_t{3});
        const WrittenFiles together = farm.finish().value();
        QCOMPARE(together.files.size(), std::size_t{2});
        QVERIFY(!together.checks.made.empty());
        QVERIFY(together.checks.problems.empty());
        const std::vector<std::string> wanted{"Glebe/path.csv",         "Glebe/plan.geojson",
                                              "Glebe/summary.json",     "Long Acre/path.csv",
                                              "Long Acre/plan.geojson", "Long Acre/summary.json",
                                              "TASKDATA/LINKLIST.XML",  "TASKDATA/TASKDATA.XML"};
        QCOMPARE(filesIn(root), wanted);
        const auto read = fieldsIn(root / "TASKDATA");
        QCOMPARE(read.size(), std::size_t{2});
        QVERIFY(std::abs(read.at("Long Acre") - 2.0) < 0.01);
        QVERIFY(std::abs(read.at("Glebe") - 3.0) < 0.01);
    }

    /// Two fields of one name are two folders; written again they are the same two.
    void namesTwice() {
        const QTemporaryDir folder;
        const fs::path root{folder.path().toStdString()};
        constexpr std::array<std::string_view, 1> kFormats{"geojson"};
        for (int i = 0; i < 2; ++i) {
            FarmFolder farm = FarmFolder::at(root, kFormats).value();
            QVERIFY(farm.add(*planOf("Long/Acre", 200.0, 9.5)).has_value());
            QVERIFY(farm.add(*planOf("Long/Acre", 300.0, 9.51)).has_value());
            QVERIFY(farm.finish().value().files.empty());
            QCOMPARE(std::ranges::distance(fs::directory_iterator{root}), 2);
            QCOMPARE(filesIn(root).size(), std::size_t{4});
        }
    }

    void anUnknownFormatAndAFolderThatCannotBe() {
        constexpr std::array<std::string_view, 1> kUnknown{"papyrus"};
        QCOMPARE(FarmFolder::at("/tmp", kUnknown).error().code, ErrorCode::Usage);
        const QTemporaryDir folder;
        QFile file{folder.filePath("file")};
        QVERIFY(file.open(QIODevice::WriteOnly));
        constexpr std::array<std::string_view, 2> kFormats{"geojson", "isoxml"};
        FarmFolder farm = FarmFolder::at(fs::path{file.fileName().toStdString()}, kFormats).value();
        QCOMPARE(farm.add(*planOf("Glebe", 200.0, 9.5)).error().code, ErrorCode::WriteFailed);
        // What could not be written is in nothing.
        QVERIFY(farm.finish().value().files.empty());
    }

    void onAStick_data() {
        QTest::addColumn<QString>("terminal");
        QTest::addColumn<QStringList>("files");
        QTest::newRow("ISOXML 4") << "fendt" << QStringList{"TASKDATA/LINKLIST.XML", "TASKDATA/TASKDATA.XML"};
        QTest::newRow("ISOXML 3") << "claas-s10" << QStringList{"TASKDATA/TASKDATA.XML"};
        QTest::newRow("AgOpenGPS") << "agopengps"
                                   << QStringList{"AgOpenGPS/Fields/Glebe/RecPath.txt",
                                                  "AgOpenGPS/Fields/Glebe 2/RecPath.txt"};
        QTest::newRow("AgGPS") << "trimble"
                               << QStringList{"AgGPS/Data/Furrow/Farm/Glebe/Swaths.shp",
                                              "AgGPS/Data/Furrow/Farm/Glebe 2/Swaths.shp"};
    }
    /// Two fields of one name, 2 and 3 ha: read back from the stick they are the two that were meant.
    void onAStick() {
        QFETCH(QString, terminal);
        QFETCH(QStringList, files);
        const QTemporaryDir folder;
        const fs::path root{folder.path().toStdString()};
        const Terminal& known = **findTerminal(terminal.toStdString());
        FarmOnStick farm{known};
        FarmOnStick named{known};
        for (const auto& plan : {planOf("Glebe", 200.0, 9.5), planOf("Glebe", 300.0, 9.51)}) {
            QVERIFY(farm.add(*plan).has_value());
            QVERIFY(named.add(plan->field().source()).has_value());
        }
        const FormatFiles made = farm.files().value();
        QVERIFY(made.checks.problems.empty());
        const auto stick = openStick(root);
        const auto report = writeToStick(*stick, made, farm.fields(), false);
        QVERIFY2(report.has_value(), report ? "" : report.error().line().c_str());
        QVERIFY(report->contentCompared);
        for (const QString& file : files) {
            QVERIFY2(fs::exists(root / file.toStdString()), qPrintable(file));
        }
        // What stands in the way is known before the fields are planned.
        QVERIFY(stickConflicts(*stick, named.files().value()) == stickConflicts(*stick, made));
        QVERIFY(!stickConflicts(*stick, made).empty());
    }
};

FURROW_TEST(FarmFilesTest);
#include "tst_farm_files.moc"
