// The paper's experiments: what goes in is what is said, what comes out repeats.

#include "planner/benchmarks/line_fit.h"
#include "planner/benchmarks/paper.h"
#include "planner/benchmarks/paper_settings.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QTest>
#include <QXmlStreamReader>

#include <cmath>
#include <stop_token>

using namespace furrow;

namespace {

const PaperFile* fileNamed(const PaperExperiment& experiment, const std::string& name) {
    const auto found = std::ranges::find(experiment.files, name, &PaperFile::name);
    return found == experiment.files.end() ? nullptr : &*found;
}

void checkFiles(const PaperExperiment& experiment) {
    for (const PaperFile& file : experiment.files) {
        QVERIFY2(!file.text.empty(), file.name.c_str());
        if (file.name.ends_with(".svg")) {
            QXmlStreamReader xml{QByteArray::fromStdString(file.text)};
            while (!xml.atEnd()) {
                xml.readNext();
            }
            QVERIFY2(!xml.hasError(), file.name.c_str());
        } else {
            // As many cells in every row as in the header.
            const QList<QByteArray> rows = QByteArray::fromStdString(file.text).trimmed().split('\n');
            QVERIFY(rows.size() > 1);
            for (const QByteArray& row : rows) {
                QCOMPARE(row.count(','), rows.front().count(','));
            }
        }
    }
}

}  // namespace

class PaperTest : public QObject {
    Q_OBJECT

private slots:
    // 1, 3, 2 at 0, 1, 2: slope 1/2, offset 3/2; the line explains 0.5 of the variance 2.
    void fitByHand() {
        const Point points[] = {{0.0, 1.0}, {1.0, 3.0}, {2.0, 2.0}};
        const LineFit fit = fitLine(points);
        COMPARE_WITHIN(fit.slope, 0.5, 1e-12);
        COMPARE_WITHIN(fit.offset, 1.5, 1e-12);
        COMPARE_WITHIN(fit.r2, 0.25, 1e-12);
        const Point onLine[] = {{1.0, 5.0}, {2.0, 7.0}, {4.0, 11.0}};
        COMPARE_WITHIN(fitLine(onLine).r2, 1.0, 1e-12);
    }

    void theMachineIsThePapers() {
        QCOMPARE(paperMachine().operatingWidth().si(), 2.5);
        QCOMPARE(paperMachine().minTurningRadius().si(), 2.1);
        QCOMPARE(paperMachine().spec().implement.offset.si(), 0.0);
    }

    void theShapesAreOfAHundredSquareMetres() {
        for (const Polygon& shape : {paperRectangle(), paperCircle(), paperSlanted()}) {
            COMPARE_WITHIN(area(shape).si(), 100.0, 1e-9);
            QVERIFY(signedAreaM2(shape.outer) > 0.0);
        }
    }

    void thirtyEightStrictlyConvexFields() {
        const std::vector<FieldSource> fields = paperFields();
        QCOMPARE(fields.size(), std::size_t{38});
        for (const FieldSource& source : fields) {
            const auto field = Field::create(source);
            VERIFY_RESULT(field);
            QVERIFY2(field->repairs().empty(), source.name.c_str());
            const Ring& ring = field->boundary().front().outer;
            QVERIFY(ring.size() > 4);
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const Point& next = ring[(i + 1) % ring.size()];
                QVERIFY2(cross(next - ring[i], ring[(i + 2) % ring.size()] - next) > 0.0,
                         source.name.c_str());
            }
            const Polygon hectare = scaledTo(field->boundary().front(), squareMetres(1e4));
            COMPARE_WITHIN(area(hectare).si(), 1e4, 1e-6);
        }
    }

    void headings() {
        const auto experiment = paperHeadings({});
        VERIFY_RESULT(experiment);
        checkFiles(*experiment);
        QCOMPARE(experiment->statements.size(), std::size_t{6});
        // What does not depend on the paper's outlines: fewest swaths on the long shapes is two.
        QCOMPARE(experiment->statements[0].agrees, std::optional{true});
        QCOMPARE(experiment->statements[1].agrees, std::optional{true});
        const auto again = paperHeadings({.threads = 1});
        VERIFY_RESULT(again);
        for (std::size_t i = 0; i < experiment->files.size(); ++i) {
            QCOMPARE(again->files[i].text, experiment->files[i].text);
        }
        // Three shapes, three objectives; three shapes, 180 headings.
        QCOMPARE(std::ranges::count(fileNamed(*experiment, "experiment1_best.csv")->text, '\n'), 1 + 9);
        QCOMPARE(std::ranges::count(fileNamed(*experiment, "experiment1_headings.csv")->text, '\n'), 1 + 540);
    }

    void turning() {
        std::vector<FieldSource> fields = paperFields();
        fields.resize(2);
        const auto experiment = paperTurning(fields, {});
        if (!experiment && experiment.error().code == ErrorCode::Usage) {
            QSKIP("the planner does not have all patterns");
        }
        VERIFY_RESULT(experiment);
        checkFiles(*experiment);
        QCOMPARE(experiment->statements.size(), std::size_t{4});
        QCOMPARE(std::ranges::count(experiment->files.front().text, '\n'), 1 + 2 * 18);
    }

    void drive() {
        const auto experiment = paperDrive({});
        VERIFY_RESULT(experiment);
        checkFiles(*experiment);
        QCOMPARE(experiment->statements.size(), std::size_t{2});
        for (const PaperStatement& statement : experiment->statements) {
            QVERIFY2(statement.agrees == std::optional{true}, statement.found.c_str());
        }
        QVERIFY(fileNamed(*experiment, "experiment4_figures.csv") != nullptr);
    }

    void cancelled() {
        std::stop_source stop;
        stop.request_stop();
        for (const auto& experiment :
             {paperHeadings({.stop = stop.get_token()}), paperTiming({.stop = stop.get_token()}),
              paperDrive({.stop = stop.get_token()})}) {
            QVERIFY(!experiment);
            QCOMPARE(experiment.error().code, ErrorCode::Cancelled);
        }
    }
};

FURROW_TEST(PaperTest);
#include "tst_paper.moc"
