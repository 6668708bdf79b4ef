#include "tests/support/patience.h"
#include "tests/support/test_program.h"
#include "tests/ui/window/window_test.h"
#include "ui/text/display.h"

#include <QPointer>
#include <QRegularExpression>
#include <QSettings>
#include <QSignalSpy>

namespace furrow::test {

/// Language and units are chosen in the window and hold at once.
class TestLanguageWindow : public WindowTest {
    Q_OBJECT

    Display& display() const { return Display::instance(); }
    QString textOf(const QString& name) const {
        const QQuickItem* found = item(name);
        return found == nullptr ? QString{} : found->property("text").toString();
    }
    /// The names of the steps, from top to bottom.
    QStringList steps() const {
        QStringList names;
        for (int row = 0; row < session_->planning()->steps()->rowCount(); ++row) {
            names << session_->planning()->steps()->index(row).data(StepsModel::NameRole).toString();
        }
        return names;
    }
    QString result(int step) const {
        return session_->planning()->steps()->index(step).data(StepsModel::ResultRole).toString();
    }
    void begin(Display::Units units = Display::Metric) {
        QSettings{}.remove(QStringLiteral("display"));
        display().setLanguage(QStringLiteral("en"));
        display().setUnits(units);
    }
    /// Opens the dialog by its key and takes an entry of one of its lists.
    void choose(const QString& list, int entry) {
        key(Qt::Key_Comma, Qt::ControlModifier);
        QTRY_VERIFY(item(list) != nullptr && item(list)->isVisible());
        waitForRest(*item(list));
        QQuickItem* box = item(list);
        box->forceActiveFocus();
        QTRY_VERIFY(box->hasActiveFocus());
        const int steps = entry - box->property("currentIndex").toInt();
        for (int i = 0; i < std::abs(steps); ++i) {
            key(steps > 0 ? Qt::Key_Down : Qt::Key_Up);
        }
        click(QStringLiteral("preferences.close"));
        QTRY_VERIFY(item(list) == nullptr || !item(list)->isVisible());
    }

    /// On the screen, and no longer fading in.
    bool isShown(const QString& name) const {
        const QQuickItem* at = item(name);
        bool shown = at != nullptr && at->isVisible();
        for (; shown && at != nullptr; at = at->parentItem()) {
            shown = at->opacity() == 1.0;
        }
        return shown;
    }
    /// Texts that end in dots, or reach out of what holds them.
    QStringList cut() const {
        QStringList texts;
        const auto look = [&texts](const auto& self, const QQuickItem* at) -> void {
            if (!at->isVisible() || at->opacity() == 0.0) {
                return;
            }
            const QVariant truncated = at->property("truncated");
            if (truncated.isValid() && truncated.toBool()) {
                texts << at->property("text").toString();
            }
            for (const QQuickItem* child : at->childItems()) {
                self(self, child);
            }
        };
        look(look, window_->contentItem());
        return texts;
    }

    /// Everything that is to be read in the window, with the units beside fields.
    QStringList texts() const {
        QStringList all;
        const auto look = [&all](const auto& self, const QQuickItem* at) -> void {
            if (!at->isVisible() || at->opacity() == 0.0) {
                return;
            }
            if (const QString text = at->property("text").toString(); !text.isEmpty()) {
                all << text;
            }
            for (const QQuickItem* child : at->childItems()) {
                self(self, child);
            }
        };
        look(look, window_->contentItem());
        return all;
    }
    /// Those that are in a unit of these, alone or behind a number.
    QStringList textsIn(const QString& units) const {
        const QRegularExpression unit{QStringLiteral("(?:^|\\d[ \u00a0])(?:%1)(?=$|[^\\w/²])").arg(units)};
        QStringList found = texts().filter(unit);
        // The names of machines stay as they are.
        found.removeIf(
            [this](const QString& text) { return text.contains(session_->planning()->machine()->name()); });
        return found;
    }

private slots:
    void everyUnitFollowsAtOnce_data() {
        QTest::addColumn<QString>("step");
        for (const char* step : {"machine", "headland", "swaths", "route", "path", "field"}) {
            QTest::newRow(step) << QString::fromLatin1(step);
        }
    }
    void everyUnitFollowsAtOnce() {
        QFETCH(QString, step);
        begin();
        openSample(QStringLiteral("Slanted Field"));
        if (step != QStringLiteral("field")) {
            click(QStringLiteral("step.") + step);
        }
        // An edge, so that the inspector has numbers, too.
        key(Qt::Key_E);
        QTRY_VERIFY(item(QStringLiteral("inspector"))->isVisible());
        // What is worked out in the background has come, too.
        QTRY_VERIFY(session_->planning()->reasons()->plan() == session_->shown()->plan());
        QTRY_VERIFY(session_->drive()->isAvailable());
        const QString metric = QStringLiteral("m|km|ha|m²|km/h");
        const QString imperial = QStringLiteral("ft|mi|ac|ft²|mph");
        QTRY_COMPARE(textsIn(imperial), QStringList{});
        const auto inMetric = textsIn(metric).size();
        QVERIFY(inMetric > 8);
        choose(QStringLiteral("preferences.units"), 2);
        QCOMPARE(textsIn(metric), QStringList{});
        picture(QStringLiteral("units_imperial_") + step);
        QCOMPARE(textsIn(imperial).size(), inMetric);
        choose(QStringLiteral("preferences.units"), 1);
        QCOMPARE(textsIn(imperial), QStringList{});
    }
    void theUnitBesideANumberFollows() {
        begin();
        openSample(QStringLiteral("Slanted Field"));
        click(QStringLiteral("step.machine"));
        const QString width = QStringLiteral("machine.operating_width_m");
        const QString speed = QStringLiteral("machine.working_speed_mps");
        QTRY_VERIFY(item(width) != nullptr);
        session_->planning()->machine()->setNumber(0, 24.0);
        const double mps = session_->planning()->machine()->machine().spec().tractor.workingSpeed.si();
        QTRY_COMPARE(textOf(width), QStringLiteral("24.00"));
        QCOMPARE(item(width)->property("unitText").toString(), QStringLiteral("m"));
        const QString metricBar = item(QStringLiteral("scaleBar"))->property("metres").toString();
        choose(QStringLiteral("preferences.units"), 2);
        // 24 / 0.3048; miles an hour are 0.44704 m/s.
        QCOMPARE(textOf(width), QStringLiteral("78.74"));
        QCOMPARE(item(width)->property("unitText").toString(), QStringLiteral("ft"));
        QCOMPARE(textOf(speed), QString::number(mps / 0.44704, 'f', 1));
        QCOMPARE(item(speed)->property("unitText").toString(), QStringLiteral("mph"));
        QVERIFY(item(QStringLiteral("scaleBar"))->property("metres").toString() != metricBar);
        choose(QStringLiteral("preferences.language"), 2);
        QCOMPARE(textOf(width), QStringLiteral("78,74"));
    }
    /// In a narrow window names give way, and every button stays in it.
    void theBarFitsTheWindow_data() {
        QTest::addColumn<QString>("language");
        for (const char* language : {"en", "de", "nl", "fr", "es", "pt_BR", "pt_PT"}) {
            QTest::newRow(language) << language;
        }
    }
    void theBarFitsTheWindow() {
        QFETCH(QString, language);
        begin(Display::Metric);
        display().setLanguage(language);
        click(QStringLiteral("empty.sample.0"));
        QTRY_VERIFY_WITH_TIMEOUT(isFinished(session_->planning()->state()), kPatienceMs);
        window_->setMinimumSize({});
        for (const int width : {1280, 1101, 1001, 1000, 900, 781, 780, 721, 683}) {
            window_->resize(width, 640);
            QTRY_COMPARE(window_->width(), width);
            const auto outside = [&] {
                QStringList names;
                for (const QQuickItem* row : item(QStringLiteral("topBar"))->childItems()) {
                    for (const QQuickItem* part : row->childItems()) {
                        const double left = part->mapToScene({0.0, 0.0}).x();
                        if (part->isVisible() && (left < 0.0 || left + part->width() > width)) {
                            names << part->objectName();
                        }
                    }
                }
                return names.join(QLatin1Char{' '});
            };
            QTRY_VERIFY2(outside().isEmpty(), qPrintable(QStringLiteral("%1: %2").arg(width).arg(outside())));
            if (width == 1000 || width == 683) {
                QObject* const colours = engine_->singletonInstance<QObject*>("Furrow.Controls", "Theme");
                for (const int theme : {2, 0}) {
                    colours->setProperty("forced", theme);
                    picture(QStringLiteral("bar_%1_%2_%3").arg(language).arg(width).arg(theme));
                }
            }
        }
    }
    void nothingIsCutOff_data() {
        QTest::addColumn<QString>("language");
        QTest::addColumn<Display::Units>("units");
        QTest::newRow("English, imperial") << "en" << Display::Imperial;
        QTest::newRow("German") << "de" << Display::Metric;
        QTest::newRow("Dutch, imperial") << "nl" << Display::Imperial;
        QTest::newRow("French") << "fr" << Display::Metric;
        QTest::newRow("Spanish") << "es" << Display::Metric;
        QTest::newRow("Portuguese of Brazil") << "pt_BR" << Display::Metric;
        QTest::newRow("Portuguese of Portugal, imperial") << "pt_PT" << Display::Imperial;
    }
    void nothingIsCutOff() {
        QFETCH(QString, language);
        QFETCH(Display::Units, units);
        begin(units);
        display().setLanguage(language);
        window_->resize(1280, 800);
        click(QStringLiteral("empty.sample.0"));
        QTRY_VERIFY_WITH_TIMEOUT(isFinished(session_->planning()->state()), kPatienceMs);
        QStringList wrong;
        const auto check = [&](const QString& state) {
            picture(QStringLiteral("language_%1_%2").arg(language, state));
            for (const QString& text : cut()) {
                wrong << state + QStringLiteral(": ") + text;
            }
        };
        for (const char* step :
             {"field", "machine", "headland", "swaths", "decomposition", "route", "path"}) {
            // One open at a time: closed, they all fit the window. The first is open from the start.
            const QString header = QStringLiteral("step.") + QString::fromLatin1(step);
            if (qstrcmp(step, "field") != 0) {
                click(header);
            }
            waitForRest(*item(QStringLiteral("step.path")));
            check(QString::fromLatin1(step));
            click(header);
            waitForRest(*item(QStringLiteral("step.path")));
        }
        key(Qt::Key_F1, Qt::ControlModifier);
        QTRY_VERIFY(isShown(QStringLiteral("keysDialog.close")));
        check(QStringLiteral("keys"));
        // Of commands, not of the map only.
        QVERIFY(texts().contains(QStringLiteral("F5")));
        click(QStringLiteral("keysDialog.close"));
        QTRY_VERIFY(item(QStringLiteral("keysDialog.close")) == nullptr ||
                    !item(QStringLiteral("keysDialog.close"))->isVisible());
        key(Qt::Key_Comma, Qt::ControlModifier);
        QTRY_VERIFY(isShown(QStringLiteral("preferences.units")));
        check(QStringLiteral("preferences"));
        click(QStringLiteral("preferences.close"));
        key(Qt::Key_L, Qt::ControlModifier);
        QTRY_VERIFY(isShown(QStringLiteral("layersPanel.close")));
        check(QStringLiteral("layers"));
        click(QStringLiteral("layersPanel.close"));
        click(QStringLiteral("exportButton"));
        QTRY_VERIFY(isShown(QStringLiteral("export.onStick")));
        waitForRest(*item(QStringLiteral("export.onStick")));
        check(QStringLiteral("export"));
        click(QStringLiteral("export.onStick"));
        QTRY_VERIFY(isShown(QStringLiteral("stick.terminal")));
        check(QStringLiteral("stick"));
        key(Qt::Key_Escape);
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QLatin1Char('\n'))));
    }

    void languageHoldsAtOnce() {
        begin();
        openSample(QStringLiteral("Slanted Field"));
        QCOMPARE(steps().value(2), QStringLiteral("Headland"));
        QVERIFY(result(2).contains(QStringLiteral("inside")));
        const QStringList findings = [this] {
            QStringList all;
            for (int row = 0; row < session_->findings()->rowCount(); ++row) {
                all << session_->findings()->index(row).data(FindingsModel::TextRole).toString();
            }
            return all;
        }();
        // As the computer, English, Deutsch, Nederlands, Français, Español, Português (Brasil), Português
        // (Portugal).
        QSignalSpy renamed{session_->planning()->steps()->parameters(QStringLiteral("headland")),
                           &QAbstractItemModel::dataChanged};
        choose(QStringLiteral("preferences.language"), 2);
        QCOMPARE(display().language(), QStringLiteral("de"));
        QVERIFY(!renamed.isEmpty());
        QTRY_COMPARE(steps(), (QStringList{"Schlag", "Maschine", "Vorgewende", "Spuren", "Teilflächen",
                                           "Fahrroute", "Wendungen", "Prüfung", "Export"}));
        QVERIFY2(result(2).contains(QStringLiteral("Innenfläche")), qPrintable(result(2)));
        QVERIFY2(session_->planning()->statusText().startsWith(QStringLiteral("Plan fertig")),
                 qPrintable(session_->planning()->statusText()));
        for (int row = 0; row < session_->findings()->rowCount(); ++row) {
            const QString german = session_->findings()->index(row).data(FindingsModel::TextRole).toString();
            QVERIFY2(german != findings.value(row), qPrintable(german));
        }
        QVERIFY(item(QStringLiteral("bar.Datei")) != nullptr);
        QCOMPARE(session_->figures()->index(0).data(FiguresModel::LabelRole).toString(),
                 QStringLiteral("Fläche"));
        QVERIFY(session_->figures()
                    ->index(0)
                    .data(FiguresModel::ValueRole)
                    .toString()
                    .startsWith(QStringLiteral("5,4")));
        picture(QStringLiteral("language_de"));
        choose(QStringLiteral("preferences.language"), 4);
        QTRY_COMPARE(steps().value(2), QStringLiteral("Fourrière"));
        choose(QStringLiteral("preferences.language"), 1);
        QTRY_COMPARE(steps().value(2), QStringLiteral("Headland"));
    }

    /// Made anew for each title that changed, they held up the window for seconds.
    void menusStayWhileTheirTextsFollow() {
        begin();
        const QPointer<QObject> entry = window_->findChild<QObject*>(QStringLiteral("command.about.item"));
        QVERIFY(entry != nullptr);
        QCOMPARE(entry->property("text").toString(), QStringLiteral("About Furrow"));
        choose(QStringLiteral("preferences.language"), 2);
        QVERIFY(item(QStringLiteral("bar.Datei")) != nullptr);
        QVERIFY(entry != nullptr);
        QTRY_COMPARE(entry->property("text").toString(), QStringLiteral("Über Furrow"));
    }

    void whatIsWrongWithImageryFollows() {
        begin();
        session_->imagery()->add({QStringLiteral("/nowhere/meadow.tif")});
        QTRY_COMPARE(session_->imagery()->message(),
                     QStringLiteral("meadow.tif: There is no such file or folder"));
        choose(QStringLiteral("preferences.language"), 2);
        QTRY_COMPARE(textOf(QStringLiteral("imageryNotice.text")),
                     QStringLiteral("meadow.tif: Diese Datei oder diesen Ordner gibt es nicht"));
        click(QStringLiteral("imageryNotice.close"));
    }

    void theChoiceIsRemembered() {
        begin();
        choose(QStringLiteral("preferences.language"), 3);
        QTRY_COMPARE(display().language(), QStringLiteral("nl"));
        QCOMPARE(QSettings{}.value(QStringLiteral("display/language")).toString(), QStringLiteral("nl"));
        choose(QStringLiteral("preferences.units"), 2);
        QTRY_COMPARE(display().units(), Display::Imperial);
        QCOMPARE(QSettings{}.value(QStringLiteral("display/units")).toInt(), 2);
    }

    void unitsHoldAtOnceAndTheDocumentStays() {
        begin();
        openSample(QStringLiteral("Slanted Field"));
        const auto before = session_->document()->project();
        QCOMPARE(session_->figures()->index(0).data(FiguresModel::ValueRole).toString(),
                 QStringLiteral("5.4 ha"));
        choose(QStringLiteral("preferences.units"), 2);
        // 5.4 ha are 13.3 acres.
        QTRY_COMPARE(session_->figures()->index(0).data(FiguresModel::ValueRole).toString(),
                     QStringLiteral("13.3 ac"));
        QVERIFY2(result(2).contains(QStringLiteral(" ft")), qPrintable(result(2)));
        QVERIFY2(result(1).contains(QStringLiteral(" mph")), qPrintable(result(1)));
        QCOMPARE(session_->document()->project(), before);
        picture(QStringLiteral("units_imperial"));
    }

    void widthIsTypedInEitherSystem_data() {
        QTest::addColumn<Display::Units>("units");
        QTest::addColumn<QString>("typed");
        QTest::addColumn<double>("metresWide");
        QTest::addColumn<QString>("shownAfter");
        QTest::newRow("metres") << Display::Metric << "4.5" << 4.5 << "4.50";
        QTest::newRow("comma") << Display::Metric << "4,5 m" << 4.5 << "4.50";
        QTest::newRow("feet in metres") << Display::Metric << "15 ft" << 4.572 << "4.57";
        QTest::newRow("feet and inches") << Display::Metric << "10'6\"" << 3.2004 << "3.20";
        QTest::newRow("feet") << Display::Imperial << "15" << 4.572 << "15.00";
        QTest::newRow("metres in feet") << Display::Imperial << "4.5 m" << 4.5 << "14.76";
    }
    void widthIsTypedInEitherSystem() {
        QFETCH(Display::Units, units);
        QFETCH(QString, typed);
        QFETCH(double, metresWide);
        QFETCH(QString, shownAfter);
        begin(units);
        openSample(QStringLiteral("Slanted Field"));
        click(QStringLiteral("step.machine"));
        const QString field = QStringLiteral("machine.operating_width_m");
        click(field);
        QTRY_VERIFY(item(field)->hasActiveFocus());
        key(Qt::Key_A, Qt::ControlModifier);
        type(QStringLiteral("wide"));
        const auto isRefused = [this, &field] {
            const QQuickItem* const told = item(field + QStringLiteral(".complaint"));
            return told != nullptr && told->isVisible();
        };
        QTRY_VERIFY(isRefused());
        key(Qt::Key_A, Qt::ControlModifier);
        type(typed);
        QTRY_VERIFY(!isRefused());
        key(Qt::Key_Return);
        QTRY_VERIFY(std::abs(session_->planning()->machine()->machine().operatingWidth().si() - metresWide) <
                    1e-9);
        QTRY_COMPARE(textOf(field), shownAfter);
    }
};

}  // namespace furrow::test

FURROW_TEST_WITH(furrow::test::TestLanguageWindow, QGuiApplication);
#include "tst_language_window.moc"
