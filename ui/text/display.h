#pragma once

#include <QtQml/qqmlregistration.h>
#include <QHash>
#include <QObject>
#include <QPointer>
#include <QStringList>

#include <memory>
#include <vector>

class QJSEngine;
class QQmlEngine;
class QTranslator;

Q_MOC_INCLUDE("ui/text/quantity_text.h")

namespace furrow {

class QuantityText;

enum class UnitSystem { Metric, Imperial };

/// In which language and units this user reads and types; remembered. Documents and the planner stay in SI
/// units and English whatever it says.
///
/// Texts of QML follow a change by themselves, since the engine is told; whoever keeps a text that was made
/// in C++ makes it again at changed().
class Display : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_SINGLETON
    /// "de", "pt_PT" ...; empty to follow the system.
    Q_PROPERTY(QString language READ language WRITE setLanguage NOTIFY changed FINAL)
    /// Which language that is: "de".
    Q_PROPERTY(QString shownLanguage READ shownLanguage NOTIFY changed FINAL)
    Q_PROPERTY(QStringList languages READ languages CONSTANT FINAL)
    Q_PROPERTY(Units units READ units WRITE setUnits NOTIFY changed FINAL)
    Q_PROPERTY(bool imperial READ isImperial NOTIFY changed FINAL)
    /// Quantities as this user reads and types them. What calls its functions through here is evaluated again
    /// at every change; a mere mention of another property beside the call is not enough: the compiler leaves
    /// it out.
    Q_PROPERTY(furrow::QuantityText* quantities READ quantities NOTIFY changed FINAL)

public:
    enum Units { UnitsOfSystem, Metric, Imperial };
    Q_ENUM(Units)

    /// The one of this program; the application has to exist.
    static Display& instance();
    static Display* create(QQmlEngine* engine, QJSEngine*);

    QString language() const { return language_; }
    void setLanguage(const QString& language);
    QString shownLanguage() const { return shown_; }
    /// What there is a translation for, English first.
    QStringList languages() const;
    /// In the language itself: "Deutsch".
    Q_INVOKABLE QString nameOf(const QString& language) const;

    Units units() const { return units_; }
    void setUnits(Units units);
    bool isImperial() const { return unitSystem() == UnitSystem::Imperial; }
    UnitSystem unitSystem() const;
    QuantityText* quantities() const { return quantities_.get(); }

    /// For this run only: what a command line asks for. Empty and UnitsOfSystem leave what is remembered.
    void force(const QString& language, Units units);

signals:
    void changed();

private:
    Display();
    ~Display() override;
    void use(const QString& language);
    void tell();

    QString language_;
    QString shown_;
    Units units_ = UnitsOfSystem;
    std::unique_ptr<QuantityText> quantities_;
    bool remembers_ = true;
    std::vector<std::unique_ptr<QTranslator>> translators_;
    std::vector<QPointer<QQmlEngine>> engines_;
};

}  // namespace furrow
