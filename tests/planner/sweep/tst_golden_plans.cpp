// Plans of ten fields as they were: what a change of the code moves, and by how much. Where plans are meant
// to change, FURROW_WRITE_GOLDEN=1 writes them anew, and the difference of the file is part of that change.

#include "planner/core/fingerprint.h"
#include "planner/io/import/boundary_import.h"
#include "planner/machine/machine_library.h"
#include "planner/plan/plan.h"
#include "tests/planner/sweep/sweep_shapes.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QTest>

#include <cmath>
#include <cstdint>
#include <format>
#include <map>
#include <memory>

using namespace furrow;

namespace {

const QString kGolden = QStringLiteral(FURROW_TEST_DATA_DIR "/plans/golden.tsv");

/// A shape of the sweep or a sample field, and who works it.
struct GoldenCase {
    const char* field;
    const char* machine;
};
constexpr GoldenCase kCases[] = {
    {"rectangle", "agbot"},
    {"l-shape", "combine"},
    {"headland-pond", "cultivator"},
    {"wet-spot", "mounted-drill"},
    {"slanted_field", "power-harrow-drill"},
    {"home_field", "agbot"},
    {"home_field", "trailed-sprayer"},
    {"bend", "cultivator"},
    {"long_strip", "field-robot"},
    {"three_ponds", "cultivator"},
};

FieldSource sourceOf(const std::string& name, const Machine& machine) {
    const std::string path = FURROW_SOURCE_DIR "/resources/sample_fields/" + name + ".geojson";
    return QFile::exists(QString::fromStdString(path)) ? readBoundaries(path).value().front()
                                                       : test::sweepField(name, machine);
}

/// Of where the path leads, in millimetres.
std::string pathMark(const Path& path) {
    std::string places;
    for (const PathSegment& segment : path.segments) {
        for (const PathSample& sample : segment.samples) {
            places += std::format("{} {};", std::llround(1e3 * sample.position.x),
                                  std::llround(1e3 * sample.position.y));
        }
    }
    return fingerprint(places);
}

/// One line of the file, what people look at first.
std::string figuresOf(const Plan& plan) {
    return std::format("{} swaths\t{} segments\t{:.3f} m\t{:.2f} s\t{:.2f} m2 missed\t{} blocking\t{}",
                       plan.swaths.swaths.size(), plan.path.segments.size(), plan.path.length().si(),
                       plan.path.duration().si(), plan.audit.missed.value_or(Area{}).si(),
                       plan.blockingCount(), pathMark(plan.path));
}

std::map<QString, QString> golden() {
    QFile file{kGolden};
    std::map<QString, QString> lines;
    if (file.open(QIODevice::ReadOnly)) {
        for (const QString& line : QString::fromUtf8(file.readAll()).split(u'\n', Qt::SkipEmptyParts)) {
            lines[line.section(u'\t', 0, 0)] = line.section(u'\t', 1);
        }
    }
    return lines;
}

}  // namespace

class GoldenPlansTest : public QObject {
    Q_OBJECT

private slots:
    void planIsAsItWas_data() {
        QTest::addColumn<QString>("field");
        QTest::addColumn<QString>("machine");
        for (const GoldenCase& each : kCases) {
            QTest::addRow("%s, %s", each.field, each.machine) << each.field << each.machine;
        }
    }
    void planIsAsItWas() {
        QFETCH(QString, field);
        QFETCH(QString, machine);
        const Machine driven = findMachine(machine.toStdString()).value();
        const auto plan = makePlan({.field = std::make_shared<const Field>(
                                        Field::create(sourceOf(field.toStdString(), driven)).value()),
                                    .machine = driven,
                                    .settings = {}});
        VERIFY_RESULT(plan);
        const QString name = QString::fromUtf8(QTest::currentDataTag());
        made_[name] = QString::fromStdString(figuresOf(**plan));
        if (!qEnvironmentVariableIsSet("FURROW_WRITE_GOLDEN")) {
            QCOMPARE(made_[name], golden()[name]);
        }
    }

    void cleanupTestCase() {
        QFile file{kGolden};
        if (!qEnvironmentVariableIsSet("FURROW_WRITE_GOLDEN")) {
            return;
        }
        QVERIFY(file.open(QIODevice::WriteOnly));
        for (const auto& [name, figures] : made_) {
            file.write((name + u'\t' + figures + u'\n').toUtf8());
        }
    }

private:
    std::map<QString, QString> made_;
};

FURROW_TEST(GoldenPlansTest);
#include "tst_golden_plans.moc"
