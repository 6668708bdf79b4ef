// `furrow-cli report`: the pages are read back by other programs (poppler), and the figures compared with the
// plan's.

#include "planner/machine/machine_library.h"
#include "planner/plan/method_registry.h"
#include "planner/project/project_file.h"
#include "tests/support/field_generator.h"
#include "tests/support/furrow_cli.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QCryptographicHash>
#include <QDir>
#include <QImage>
#include <QJsonArray>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

#include <cmath>
#include <csignal>
#include <map>
#include <optional>

// What Qt's waiting macros expand to narrows a duration.
#pragma GCC diagnostic ignored "-Wconversion"

using namespace furrow;
using namespace furrow::test;

namespace {

QByteArray outputOf(const QString& program, const QStringList& arguments) {
    QProcess process;
    process.start(program, arguments);
    return process.waitForFinished(60'000) && process.exitCode() == 0 ? process.readAllStandardOutput()
                                                                      : QByteArray{};
}

QString textOf(const QString& pdf) {
    return QString::fromUtf8(outputOf(QStringLiteral("pdftotext"), {"-layout", pdf, "-"}));
}

/// "Pages", "Page size"
QString infoOf(const QString& pdf, const QString& key) {
    for (const QByteArray& line : outputOf(QStringLiteral("pdfinfo"), {pdf}).split('\n')) {
        if (line.startsWith(key.toUtf8() + ':')) {
            return QString::fromUtf8(line.mid(key.size() + 1)).trimmed();
        }
    }
    return {};
}

QString sha256(const QByteArray& bytes) {
    return QString::fromLatin1(QCryptographicHash::hash(bytes, QCryptographicHash::Sha256).toHex());
}

QByteArray simplified(const QString& text) {
    return text.simplified().toUtf8();
}

std::shared_ptr<const ProjectField> rectangleField(const std::string& id, const std::string& name,
                                                   double widthM, double heightM, double lonDeg,
                                                   WorkOrder order) {
    FieldSource source = fieldSourceFromLocal({centredRectangle(widthM, heightM)}, {lonDeg, 52.0});
    source.id = source.name = name;
    FieldPlan plan{.id = "plan-" + id,
                   .name = "Spring",
                   .season = "2026",
                   .machine = findMachine("cultivator").value(),
                   .settings = {},
                   .order = std::move(order),
                   .others = {}};
    return std::make_shared<const ProjectField>(
        ProjectField{.id = id,
                     .source = std::make_shared<const FieldSource>(std::move(source)),
                     .plans = {std::move(plan)},
                     .others = {},
                     .obstacleOthers = {},
                     .gateOthers = {}});
}

constexpr auto kOrder = R"({"number": "2026-014", "customer": "Hof Müller", "operator": "Jan de Vries",
    "product": "Barley", "rate_per_ha": 100, "rate_unit": "kg", "status": "issued", "remark": "Mind the pole"})";

}  // namespace

class TestReportCli : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    QString at(const QString& name) const { return folder_.filePath(name); }

private slots:
    void initTestCase() {
        QCOMPARE(furrowCli({"plan", sampleField("home_field"), "--out", at("plan"), "--quiet"}).status, 0);
        writeFile(at("order.json"), kOrder);
        Project farm = Project::empty();
        farm.name = "Test farm";
        WorkOrder order;
        order.number = "7/2026";
        farm.fields = {rectangleField("field-1", "North", 200.0, 120.0, 5.0, order),
                       rectangleField("field-2", "South", 300.0, 100.0, 5.01, {})};
        VERIFY_RESULT(writeProject(farm, at("Farm.furrow").toStdU16String()));
    }

    void theOrderOfAPlan() {
        const Answer answer =
            furrowCli({"report", at("plan"), "--order", at("order.json"), "--out", at("order.pdf")});
        QVERIFY2(answer.status == 0, answer.error);
        QVERIFY(answer.error.isEmpty());
        const QString text = textOf(at("order.pdf"));
        for (const char* said :
             {"Home Field", "Work order 2026-014", "Issued", "Hof Müller", "Jan de Vries", "Barley",
              "Mind the pole", "AgBot", "Signature", "Wind", "Temperature", "Tillage"}) {
            QVERIFY2(text.contains(QString::fromUtf8(said)), said);
        }
        QVERIFY(!text.contains("Not drivable"));
        // The sum of the file that the plan's folder has.
        QVERIFY(text.contains(sha256(contentsOf(at("plan/path.csv")))));
        // 100 kg on each hectare that is worked.
        const QJsonObject summary = QJsonDocument::fromJson(contentsOf(at("plan/summary.json"))).object();
        const double hectares = summary["audit"].toObject()["covered_m2"].toDouble() / 1e4;
        QVERIFY(hectares > 4.0 && hectares < 6.0);
        const QString total = QStringLiteral("100 kg/ha = %1 kg").arg(std::lround(100.0 * hectares));
        QVERIFY2(simplified(text).contains(total.toUtf8()), qPrintable(total));
        // Each swath once in the order of the passes.
        const int swaths = summary["swaths"].toObject()["count"].toInt();
        for (int number = 1; number <= swaths; ++number) {
            const QRegularExpression row{QStringLiteral("Swath %1\\b").arg(number)};
            QVERIFY2(text.contains(row), qPrintable(row.pattern()));
        }
        static const QRegularExpression lastPage{QStringLiteral("Page (\\d+) of (\\d+)\\s*$")};
        const auto last = lastPage.match(text.trimmed());
        QCOMPARE(last.captured(1), infoOf(at("order.pdf"), "Pages"));
        QCOMPARE(last.captured(2), infoOf(at("order.pdf"), "Pages"));
    }

    // Swaths are called on the map as in the order of the passes and in findings. The last one is driven
    // first here, and lies in the west.
    void oneNumberForASwath() {
        QCOMPARE(furrowCli({"plan", sampleField("slanted_field"), "--machine", "trailed-sprayer", "--out",
                            at("slanted"), "--quiet"})
                     .status,
                 0);
        QCOMPARE(furrowCli({"report", at("slanted"), "--out", at("slanted.svg")}).status, 0);
        QCOMPARE(furrowCli({"report", at("slanted"), "--out", at("slanted.pdf")}).status, 0);
        QXmlStreamReader xml{contentsOf(at("slanted.svg"))};
        std::map<int, double> westToEast;  // by number
        while (!xml.atEnd()) {
            xml.readNext();
            if (!xml.isStartElement() || xml.name() != QLatin1String{"text"} ||
                xml.attributes().value("font-size") != QLatin1String{"212"}) {
                continue;
            }
            const double x = xml.attributes().value("x").toDouble();
            bool isNumber = false;
            const int number = xml.readElementText().trimmed().toInt(&isNumber);
            if (isNumber) {
                westToEast.emplace(number, x);  // findings come later
            }
        }
        QCOMPARE(westToEast.size(), std::size_t{6});
        static const QRegularExpression first{QStringLiteral("\\b2 Swath (\\d)\\b")};
        const QString order = textOf(at("slanted.pdf")).section(QStringLiteral("Order of the passes"), 1);
        QCOMPARE(first.match(order).captured(1), QStringLiteral("6"));
        QVERIFY(westToEast[6] < westToEast[3] && westToEast[3] < westToEast[1]);
    }

    void theMapIsToScale() {
        // A millimetre on paper is two metres at 1 : 2,000: the bar of 50 m is 25 mm long.
        QCOMPARE(furrowCli({"report", at("plan"), "--out", at("map.svg")}).status, 0);
        const QByteArray svg = contentsOf(at("map.svg"));
        QXmlStreamReader xml{svg};
        QStringList texts;
        while (!xml.atEnd()) {
            xml.readNext();
            if (xml.isStartElement() && xml.name() == QLatin1String{"text"}) {
                texts << xml.readElementText().trimmed();
            }
        }
        QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
        const auto scale = texts.filter(QRegularExpression{QStringLiteral("^1 : [\\d,]+$")});
        QCOMPARE(scale.size(), 1);
        // What a field of this size needs: 352 m by 357 m on 176 mm by about 150 mm.
        const double denominator = QString{scale[0]}.remove(QLatin1String{"1 : "}).remove(u',').toDouble();
        QVERIFY2(denominator >= 1500.0 && denominator <= 2500.0, qPrintable(scale[0]));
        QVERIFY(texts.contains(QStringLiteral("Home Field")));
        QVERIFY(texts.contains(QStringLiteral("N")));
    }

    void paper_data() {
        QTest::addColumn<QString>("paper");
        QTest::addColumn<double>("widthPt");
        QTest::addColumn<double>("heightPt");
        QTest::addColumn<QSize>("picture");
        // 210 and 297 mm, 8.5 and 11 inches; pictures have 200 dots to the inch.
        QTest::newRow("A4") << "a4" << 595.3 << 841.9 << QSize{1654, 2339};
        QTest::newRow("Letter") << "letter" << 612.0 << 792.0 << QSize{1700, 2200};
    }
    void paper() {
        QFETCH(QString, paper);
        QFETCH(double, widthPt);
        QFETCH(double, heightPt);
        QFETCH(QSize, picture);
        QCOMPARE(furrowCli({"report", at("plan"), "--paper", paper, "--out", at(paper + ".pdf")}).status, 0);
        static const QRegularExpression size{QStringLiteral("([\\d.]+) x ([\\d.]+) pts")};
        const auto match = size.match(infoOf(at(paper + ".pdf"), "Page size"));
        COMPARE_WITHIN(match.captured(1).toDouble(), widthPt, 0.8);
        COMPARE_WITHIN(match.captured(2).toDouble(), heightPt, 0.8);
        QCOMPARE(furrowCli({"report", at("plan"), "--paper", paper, "--out", at(paper + ".png")}).status, 0);
        QCOMPARE(QImage{at(paper + ".png")}.size(), picture);
        // Drawn as another program draws it: no page is empty.
        QVERIFY(QProcess::execute(QStringLiteral("pdftoppm"),
                                  {"-r", "20", "-png", at(paper + ".pdf"), at(paper)}) == 0);
        const int pages = infoOf(at(paper + ".pdf"), "Pages").toInt();
        QVERIFY(pages >= 2);
        for (int page = 1; page <= pages; ++page) {
            const QImage image{at(QStringLiteral("%1-%2.png").arg(paper).arg(page))};
            QVERIFY(!image.isNull());
            int dark = 0;
            for (int y = 0; y < image.height(); ++y) {
                for (int x = 0; x < image.width(); ++x) {
                    dark += qGray(image.pixel(x, y)) < 200 ? 1 : 0;
                }
            }
            QVERIFY(dark > 50);
        }
    }

    void otherUnitsAndLanguages() {
        QCOMPARE(furrowCli({"report", at("plan"), "--units", "imperial", "--order", at("order.json"), "--out",
                            at("imperial.pdf")})
                     .status,
                 0);
        const QString imperial = textOf(at("imperial.pdf"));
        QVERIFY(imperial.contains(QRegularExpression{QStringLiteral("[\\d.]+ ac\\b")}));
        QVERIFY(!imperial.contains(QRegularExpression{QStringLiteral("\\d ha\\b")}));
        QVERIFY(imperial.contains(" mi") && imperial.contains(" mph"));
        // 100 kg on a hectare are 40.47 kg on an acre.
        QVERIFY(imperial.contains("40.47 kg/ac"));
        QCOMPARE(furrowCli({"report", at("plan"), "--language", "de", "--out", at("german.pdf")}).status, 0);
        const QString german = textOf(at("german.pdf"));
        QVERIFY(german.contains("Bodenbearbeitung"));
        QVERIFY(german.contains(QRegularExpression{QStringLiteral("\\d,\\d ha")}));
    }

    void aPlanThatCannotBeDriven() {
        QCOMPARE(furrowCli({"plan", sampleField("bend"), "--machine", "trailed-sprayer", "--set",
                            "headland.method=none", "--out", at("bad"), "--quiet"})
                     .status,
                 1);
        const Answer answer = furrowCli({"report", at("bad"), "--out", at("bad.pdf")});
        QCOMPARE(answer.status, 1);
        const QJsonObject summary = QJsonDocument::fromJson(contentsOf(at("bad/summary.json"))).object();
        int blocking = 0;
        QString first;
        for (const auto& finding : summary["audit"].toObject()["findings"].toArray()) {
            const bool blocks = finding.toObject()["severity"] == QLatin1String{"blocking"};
            first = blocks && blocking == 0 ? finding.toObject()["text"].toString() : first;
            blocking += blocks ? 1 : 0;
        }
        QVERIFY(blocking > 0);
        const QString text = textOf(at("bad.pdf"));
        QVERIFY(text.contains(QRegularExpression{QStringLiteral("Not drivable: %1 ").arg(blocking)}));
        QVERIFY2(simplified(text).contains(first.left(30).toUtf8()), qPrintable(first));
    }

    void aWholeFarm() {
        const Answer answer = furrowCli({"report", at("Farm.furrow"), "--out", at("farm.pdf")});
        QVERIFY2(answer.status == 0, answer.error);
        const QString text = textOf(at("farm.pdf"));
        const QString table = text.section(QChar{'\f'}, 0, 0);
        QVERIFY(table.contains("Test farm") && table.contains("North") && table.contains("South"));
        // 200 by 120 m, 300 by 100 m, and both.
        QVERIFY(table.contains("2.4 ha") && table.contains("3.0 ha") && table.contains("5.4 ha"));
        QVERIFY(text.contains("Work order 7/2026"));
        // The farm's page, then each field on the page that the table names.
        static const QRegularExpression south{QStringLiteral("South .* (\\d+)\\n")};
        const int page = south.match(table).captured(1).toInt();
        QVERIFY(page > 2);
        QVERIFY(text.section(QChar{'\f'}, page - 1, page - 1).contains("South"));
        // The same hash as of the plan's own folder.
        for (const char* field : {"North", "South"}) {
            QCOMPARE(
                furrowCli({"plan", at("Farm.furrow"), "--field-id", field, "--out", at(field), "--quiet"})
                    .status,
                0);
            QVERIFY(text.contains(sha256(contentsOf(at(field) + "/path.csv"))));
        }
        QVERIFY(sha256(contentsOf(at("North/path.csv"))) != sha256(contentsOf(at("South/path.csv"))));
    }

    // Comments that nobody has settled, with a letter where they have a place.
    void commentsOfAReview() {
        Project farm = Project::empty();
        farm.fields = {rectangleField("field-1", "North", 200.0, 120.0, 5.0, {})};
        ProjectField field = *farm.fields.front();
        const auto comment = [](const char* id, const char* text, std::optional<GeoPoint> place,
                                bool settled) {
            return ReviewComment{.id = id,
                                 .author = "Bram",
                                 .written = "2026-11-25T10:56:00Z",
                                 .text = text,
                                 .place = place,
                                 .planKey = {},
                                 .settled = settled,
                                 .others = {}};
        };
        field.plans.front().review.comments = {
            comment("1", "Power pole, keep 3 m away", GeoPoint{5.0, 52.0}, false),
            comment("2", "Was too fast", std::nullopt, true),
            comment("3", "Begin before noon", std::nullopt, false)};
        farm.fields.front() = std::make_shared<const ProjectField>(std::move(field));
        VERIFY_RESULT(writeProject(farm, at("Review.furrow").toStdU16String()));
        QCOMPARE(furrowCli({"report", at("Review.furrow"), "--out", at("review.pdf")}).status, 0);
        QCOMPARE(furrowCli({"report", at("Review.furrow"), "--out", at("review.svg")}).status, 0);
        const QString text = textOf(at("review.pdf"));
        static const QRegularExpression placed{QStringLiteral("A\\s+Power pole, keep 3 m away\\s+Bram")};
        static const QRegularExpression whole{QStringLiteral("B\\s+Begin before noon\\s+Bram")};
        QVERIFY(text.contains("Comments") && text.contains(placed) && text.contains(whole));
        QVERIFY(!text.contains("Was too fast"));
        const QByteArray map = contentsOf(at("review.svg"));
        QVERIFY(map.contains(">A</text>") && !map.contains(">B</text>"));
    }

    /// Nothing of it is cut while a column beside it is empty.
    void namesOnTheFarmsPageAreWhole() {
        Project farm = Project::empty();
        farm.name = "Long names";
        ProjectField field = *rectangleField("field-1", "North", 200.0, 120.0, 5.0, {});
        field.plans.front().name.clear();
        field.plans.front().machine = findMachine("power-harrow-drill").value();
        ProjectField other = *rectangleField("field-2", "South", 150.0, 120.0, 5.01, {});
        other.plans = field.plans;
        other.plans.front().id = "plan-2";
        farm.fields = {std::make_shared<const ProjectField>(field),
                       std::make_shared<const ProjectField>(other)};
        VERIFY_RESULT(writeProject(farm, at("Long.furrow").toStdU16String()));
        for (const char* language : {"en", "de", "fr", "es", "nl", "pt_BR"}) {
            QCOMPARE(furrowCli({"report", at("Long.furrow"), "--language", language, "--out", at("long.pdf")})
                         .status,
                     0);
            const QString table = textOf(at("long.pdf")).section(QChar{'\f'}, 0, 0);
            QVERIFY2(table.contains("Long names") && table.contains("South") && !table.contains(u'…'),
                     qPrintable(table));
        }
        // What a tank holds has no unit of its own: 1200 / 0.018 m².
        QCOMPARE(furrowCli({"report", at("Long.furrow"), "--out", at("long.pdf")}).status, 0);
        const QString text = textOf(at("long.pdf"));
        QVERIFY(text.section(QChar{'\f'}, 0, 0).contains("Power harrow and drill, 3 m"));
        QVERIFY2(text.contains("enough for 6.7 ha"), qPrintable(text));
    }

    void oneFieldOfAFarm() {
        QCOMPARE(
            furrowCli({"report", at("Farm.furrow"), "--field-id", "South", "--out", at("south.svg")}).status,
            0);
        QVERIFY(contentsOf(at("south.svg")).contains(">South</text>"));
        QCOMPARE(furrowCli({"report", at("Farm.furrow"), "--field-id", "1", "--out", at("north.pdf")}).status,
                 0);
        const QString text = textOf(at("north.pdf"));
        QVERIFY(text.contains("North") && text.contains("Spring · 2026") && !text.contains("South"));
    }

    void badInputs_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<int>("status");
        QTest::addColumn<QByteArray>("named");
        const QString plan = at("plan");
        const QString farm = at("Farm.furrow");
        writeFile(at("bad_order.json"), R"({"status": "lost"})");
        writeFile(at("file"), "x");
        QTest::newRow("no such kind of file")
            << QStringList{plan, "--out", at("x.docx")} << 2 << QByteArray{".pdf"};
        QTest::newRow("no out") << QStringList{plan} << 2 << QByteArray{"--out"};
        QTest::newRow("no such paper")
            << QStringList{plan, "--paper", "a3", "--out", at("x.pdf")} << 2 << QByteArray{"paper"};
        QTest::newRow("a picture of a farm")
            << QStringList{farm, "--out", at("x.png")} << 2 << QByteArray{"field-id"};
        QTest::newRow("no such field")
            << QStringList{farm, "--field-id", "West", "--out", at("x.pdf")} << 2 << QByteArray{"West"};
        QTest::newRow("a field of a folder")
            << QStringList{plan, "--field-id", "1", "--out", at("x.pdf")} << 2 << QByteArray{"field-id"};
        QTest::newRow("not there") << QStringList{at("none"), "--out", at("x.pdf")} << 4
                                   << QByteArray{"none"};
        QTest::newRow("an empty folder")
            << QStringList{folder_.path(), "--out", at("x.pdf")} << 4 << QByteArray{"summary.json"};
        QTest::newRow("a boundary") << QStringList{sampleField("bend"), "--out", at("x.pdf")} << 3
                                    << QByteArray{"bend"};
        QTest::newRow("a bad order") << QStringList{plan, "--order", at("bad_order.json"), "--out",
                                                    at("x.pdf")}
                                     << 3 << QByteArray{"in_progress"};
        QTest::newRow("a file for a folder")
            << QStringList{plan, "--out", at("file/x.pdf")} << 4 << QByteArray{"file"};
    }
    void badInputs() {
        QFETCH(QStringList, arguments);
        QFETCH(int, status);
        QFETCH(QByteArray, named);
        const Answer answer = furrowCli(QStringList{"report"} + arguments);
        QVERIFY2(answer.status == status, answer.all());
        QVERIFY(answer.out.isEmpty());
        QCOMPARE(answer.error.trimmed().count('\n'), 0);
        QVERIFY2(answer.error.contains(named), answer.error);
        QVERIFY(!QFile::exists(at("x.pdf")) && !QFile::exists(at("x.png")) &&
                !QFile::exists(at("x.pdf.part")));
    }

    void anInterruptLeavesNothing() {
        Project farm = Project::empty();
        for (int i = 0; i < 40; ++i) {
            farm.fields.push_back(rectangleField("field-" + std::to_string(i), "Field " + std::to_string(i),
                                                 900.0, 700.0, 5.0 + 0.02 * i, {}));
        }
        VERIFY_RESULT(writeProject(farm, at("Large.furrow").toStdU16String()));
        QProcess process;
        process.start(kFurrowCli, {"report", at("Large.furrow"), "--out", at("large.pdf")});
        QVERIFY(process.waitForStarted());
        // The program that prints has taken over and waits for signals: it blocks them in every thread.
        const QString status = QStringLiteral("/proc/%1/").arg(process.processId());
        QTRY_VERIFY(contentsOf(status + "cmdline").contains("report") &&
                    QFile::symLinkTarget(status + "exe").endsWith("furrow-report") &&
                    QDir{status + "task"}.entryList(QDir::Dirs | QDir::NoDotAndDotDot).size() > 1);
        ::kill(static_cast<pid_t>(process.processId()), SIGINT);
        QVERIFY(process.waitForFinished(30'000));
        QCOMPARE(process.exitStatus(), QProcess::NormalExit);
        QCOMPARE(process.exitCode(), 130);
        QVERIFY(!QFile::exists(at("large.pdf")) && !QFile::exists(at("large.pdf.part")));
    }
};

FURROW_TEST_WITH(TestReportCli, QCoreApplication);
#include "tst_report_cli.moc"
