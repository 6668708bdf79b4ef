#include "ui/text/display.h"

#include "ui/text/quantity_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <QQmlEngine>
#include <QSettings>
#include <QTranslator>

#include <algorithm>
#include <array>

namespace furrow {

namespace {

constexpr auto kLanguageKey = "display/language";
constexpr auto kUnitsKey = "display/units";

struct Language {
    const char* code;
    const char* name;
};

// By the names that their speakers give them; whoever looks for his own finds it in any language.
constexpr std::array kLanguages{Language{"en", "English"},
                                Language{"de", "Deutsch"},
                                Language{"nl", "Nederlands"},
                                Language{"fr", "Français"},
                                Language{"es", "Español"},
                                Language{"pt_BR", "Português (Brasil)"},
                                Language{"pt_PT", "Português (Portugal)"}};

bool isKnown(const QString& code) {
    return std::ranges::any_of(kLanguages,
                               [&code](const Language& each) { return code == QLatin1String{each.code}; });
}

/// The language of the system, or English.
QString systemLanguage() {
    for (const QString& wanted : QLocale::system().uiLanguages()) {
        const QLocale locale{wanted};
        const QString whole = locale.name();
        const QString language = whole.section(QLatin1Char('_'), 0, 0);
        if (isKnown(whole)) {
            return whole;
        }
        if (language == QLatin1String{"pt"}) {
            return locale.territory() == QLocale::Portugal ? QStringLiteral("pt_PT")
                                                           : QStringLiteral("pt_BR");
        }
        if (isKnown(language)) {
            return language;
        }
    }
    return QStringLiteral("en");
}

/// Numbers as in the user's country where its language is the one that is shown.
QLocale localeFor(const QString& language) {
    const QLocale system = QLocale::system();
    const QLocale wanted{language};
    return system.language() == wanted.language() && system.language() != QLocale::C ? system : wanted;
}

}  // namespace

Display& Display::instance() {
    static QPointer<Display> display;
    if (display.isNull()) {
        display = new Display;
        display->setParent(QCoreApplication::instance());
    }
    return *display;
}

Display* Display::create(QQmlEngine* engine, QJSEngine*) {
    Display& display = instance();
    display.engines_.emplace_back(engine);
    QJSEngine::setObjectOwnership(&display, QJSEngine::CppOwnership);
    return &display;
}

Display::Display() : quantities_{std::make_unique<QuantityText>()} {
    QJSEngine::setObjectOwnership(quantities_.get(), QJSEngine::CppOwnership);
    const QSettings settings;
    language_ = settings.value(kLanguageKey).toString();
    if (!isKnown(language_)) {
        language_.clear();
    }
    units_ = static_cast<Units>(std::clamp(settings.value(kUnitsKey, 0).toInt(), 0, 2));
    use(language_);
}

Display::~Display() = default;

void Display::setLanguage(const QString& language) {
    if (language == language_ || (!language.isEmpty() && !isKnown(language))) {
        return;
    }
    language_ = language;
    if (remembers_) {
        QSettings{}.setValue(kLanguageKey, language_);
    }
    use(language_);
    tell();
}

void Display::setUnits(Units units) {
    if (units == units_) {
        return;
    }
    units_ = units;
    if (remembers_) {
        QSettings{}.setValue(kUnitsKey, static_cast<int>(units_));
    }
    tell();
}

void Display::force(const QString& language, Units units) {
    remembers_ = remembers_ && language.isEmpty() && units == UnitsOfSystem;
    if (!language.isEmpty()) {
        setLanguage(language);
    }
    if (units != UnitsOfSystem) {
        setUnits(units);
    }
}

QStringList Display::languages() const {
    QStringList codes;
    for (const Language& each : kLanguages) {
        codes << QLatin1String{each.code};
    }
    return codes;
}

QString Display::nameOf(const QString& language) const {
    const auto found = std::ranges::find_if(
        kLanguages, [&language](const Language& each) { return language == QLatin1String{each.code}; });
    return found == kLanguages.end() ? QString{} : QString::fromUtf8(found->name);
}

UnitSystem Display::unitSystem() const {
    if (units_ == UnitsOfSystem) {
        // Farms in the United Kingdom measure in hectares.
        return QLocale::system().measurementSystem() == QLocale::ImperialUSSystem ? UnitSystem::Imperial
                                                                                  : UnitSystem::Metric;
    }
    return units_ == Imperial ? UnitSystem::Imperial : UnitSystem::Metric;
}

void Display::use(const QString& language) {
    shown_ = language.isEmpty() ? systemLanguage() : language;
    for (const auto& translator : translators_) {
        QCoreApplication::removeTranslator(translator.get());
    }
    translators_.clear();
    QLocale::setDefault(localeFor(shown_));
    // The texts of Qt's own dialogs first: what is installed last is asked first. A variant lies over its
    // language.
    QStringList names;
    for (const QString& variant : shown_ == QLatin1String{"pt_PT"}
                                      ? QStringList{QStringLiteral("pt_BR"), shown_}
                                      : QStringList{shown_}) {
        names << QStringLiteral("qtbase_") + variant << QStringLiteral("qtdeclarative_") + variant
              << QStringLiteral("furrow_") + variant;
    }
    for (const QString& name : std::as_const(names)) {
        auto translator = std::make_unique<QTranslator>();
        if (translator->load(QStringLiteral(":/furrow/translations/") + name + QStringLiteral(".qm")) &&
            QCoreApplication::installTranslator(translator.get())) {
            translators_.push_back(std::move(translator));
        }
    }
}

void Display::tell() {
    emit changed();
    for (const QPointer<QQmlEngine>& engine : engines_) {
        if (!engine.isNull()) {
            engine->retranslate();
        }
    }
}

}  // namespace furrow
