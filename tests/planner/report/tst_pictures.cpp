// What every picture must be: well-formed, finite, and without texts that lie over each other or stick out.

#include "planner/report/chart.h"
#include "planner/report/map_picture.h"

#include <QFontMetricsF>
#include <QGuiApplication>
#include <QTest>
#include <QXmlStreamReader>

#include <cmath>
#include <limits>

using namespace furrow;

namespace {

struct Text {
    QString words;
    QRectF box;
};

struct Drawing {
    QString problem;
    QSizeF size;
    QList<Text> texts;
    int shapes = 0;
};

/// Reads a picture back and measures its texts with the widest of the usual fonts.
Drawing read(const std::string& svg) {
    Drawing drawing;
    QXmlStreamReader xml{QByteArray::fromStdString(svg)};
    QList<QPointF> moves{{0.0, 0.0}};
    while (!xml.atEnd()) {
        xml.readNext();
        if (xml.isEndElement() && xml.name() == u"g") {
            moves.pop_back();
        }
        if (!xml.isStartElement()) {
            continue;
        }
        const QXmlStreamAttributes at = xml.attributes();
        if (xml.name() == u"svg") {
            drawing.size = {at.value("width").toDouble(), at.value("height").toDouble()};
        } else if (xml.name() == u"g") {
            const QStringList by = at.value("transform").toString().mid(10).chopped(1).split(' ');
            moves.push_back(moves.back() + QPointF{by[0].toDouble(), by[1].toDouble()});
        } else if (xml.name() == u"path" || xml.name() == u"circle") {
            ++drawing.shapes;
        } else if (xml.name() == u"text") {
            QFont font{"DejaVu Sans"};
            font.setPixelSize(static_cast<int>(at.value("font-size").toDouble()));
            font.setBold(at.value("font-weight") == u"bold");
            const QPointF base = moves.back() + QPointF{at.value("x").toDouble(), at.value("y").toDouble()};
            const QString anchor = at.value("text-anchor").toString();
            const QString words = xml.readElementText();
            const QFontMetricsF metrics{font};
            const double width = metrics.horizontalAdvance(words);
            const double left = anchor == "middle" ? -0.5 * width : anchor == "end" ? -width : 0.0;
            // Without the room above and below letters that nobody sees.
            drawing.texts.push_back({words, QRectF{base.x() + left, base.y() - metrics.capHeight(), width,
                                                   metrics.capHeight() + 0.5 * metrics.descent()}});
        }
    }
    drawing.problem = xml.hasError() ? xml.errorString() : QString{};
    return drawing;
}

void check(const std::string& svg) {
    const Drawing drawing = read(svg);
    QVERIFY2(drawing.problem.isEmpty(), qPrintable(drawing.problem));
    QVERIFY(!QByteArray::fromStdString(svg).contains("nan") &&
            !QByteArray::fromStdString(svg).contains("inf "));
    const QRectF page{QPointF{0.0, 0.0}, drawing.size};
    for (qsizetype i = 0; i < drawing.texts.size(); ++i) {
        const Text& text = drawing.texts[i];
        QVERIFY2(page.contains(text.box), qPrintable(text.words + " sticks out"));
        for (qsizetype k = 0; k < i; ++k) {
            QVERIFY2(!text.box.intersects(drawing.texts[k].box),
                     qPrintable(text.words + " over " + drawing.texts[k].words));
        }
    }
}

Chart wave(double scale) {
    Chart chart{.title = "Length of the path against the length of its swaths & straight ways",
                .note =
                    "Thirty-eight fields of one hectare, each with three objectives, three patterns and two "
                    "kinds of curves; the line is where turns would cost nothing.",
                .x = {.title = "Length in place L\u2080 (m)"},
                .y = {.title = "Length with turns (m)"}};
    ChartSeries dots{.name = "number of swaths <least>"};
    ChartSeries line{.name = "fitted", .marks = Marks::None, .line = true, .dashed = true, .colour = 1};
    for (int i = 1; i <= 60; ++i) {
        dots.points.push_back({scale * i, scale * (i + 5.0 * std::sin(i))});
        line.points.push_back({scale * i, scale * 1.1 * i});
    }
    chart.series = {dots, line};
    return chart;
}

}  // namespace

class PicturesTest : public QObject {
    Q_OBJECT

private slots:
    void textsDoNotOverlap_data() {
        QTest::addColumn<double>("scale");
        QTest::addColumn<double>("width");
        QTest::addColumn<bool>("logarithmic");
        for (const double scale : {1e-7, 0.003, 1.0, 777.0, 123456.0, 4e9}) {
            for (const double width : {260.0, 640.0}) {
                for (const bool logarithmic : {false, true}) {
                    QTest::addRow("%g at %g px, %s", scale, width, logarithmic ? "log" : "linear")
                        << scale << width << logarithmic;
                }
            }
        }
    }
    void textsDoNotOverlap() {
        QFETCH(double, scale);
        QFETCH(double, width);
        QFETCH(bool, logarithmic);
        Chart chart = wave(scale);
        chart.width = width;
        chart.x.scale = chart.y.scale = logarithmic ? AxisScale::Log : AxisScale::Linear;
        check(svgOf(chart));
        chart.oneToOne = true;
        check(svgOf(chart));
    }

    void everyDotIsDrawn() {
        Chart chart = wave(1.0);
        const double nan = std::numeric_limits<double>::quiet_NaN();
        chart.series[1].points.clear();
        const int before = read(svgOf(chart)).shapes;
        chart.series[0].points.push_back({nan, 1.0});
        chart.series[0].points.push_back({1.0, std::numeric_limits<double>::infinity()});
        QCOMPARE(read(svgOf(chart)).shapes, before);
        chart.series[0].points.push_back({1.0, 1.0});
        QCOMPARE(read(svgOf(chart)).shapes, before + 1);
    }

    void nothingToShow() {
        check(svgOf(Chart{.title = "Empty"}));
        check(svgOf(MapPicture{.title = "Empty"}));
        QVERIFY(svgOf(Chart{}).find("nothing to show") != std::string::npos);
    }

    void chartsSideBySide() {
        const std::vector<Chart> charts{wave(1.0), wave(20.0), wave(3e5)};
        check(svgOf(charts, 2, "Three charts", "Two above, one below."));
    }

    void maps_data() {
        QTest::addColumn<double>("width");
        QTest::addColumn<double>("height");
        QTest::newRow("square") << 100.0 << 100.0;
        QTest::newRow("strip to the east") << 2000.0 << 10.0;
        QTest::newRow("strip to the north") << 10.0 << 2000.0;
        QTest::newRow("line") << 300.0 << 0.0;
    }
    void maps() {
        QFETCH(double, width);
        QFETCH(double, height);
        MapPicture picture{.title = "A field", .note = "With a track."};
        picture.layers.push_back({.name = "field",
                                  .areas = {{.outer = {{0, 0}, {width, 0}, {width, height}, {0, height}}}},
                                  .fill = "#f4f1e8",
                                  .stroke = "#8d7b4f"});
        for (int i = 0; i < 9; ++i) {
            picture.layers.push_back({.name = "recorded, of some class or other",
                                      .lines = {{{0.0, 0.0}, {width, height}}},
                                      .stroke = "#0072b2",
                                      .arrows = true});
        }
        picture.layers.back().lines.front().push_back({std::nan(""), 0.0});
        check(svgOf(picture));
    }
};

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QGuiApplication application{argc, argv};
    PicturesTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "tst_pictures.moc"
