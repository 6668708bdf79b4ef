#pragma once

#include "planner/plan/plan.h"
#include "planner/settings/settings.h"

#include <QtQml/qqmlregistration.h>
#include <QAbstractListModel>

#include <vector>

namespace furrow {

/// The settings of one step, as the panel edits them. Values are in the unit people read: directions as
/// bearings, everything else as in the settings.
class ParameterModel : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("belongs to a step")

public:
    enum class Kind { Number, Direction, Choice, Flag, Text };
    Q_ENUM(Kind)
    /// How a text is got without typing it.
    enum class Pick { None, Place, Line, Split, File, Places };
    Q_ENUM(Pick)
    enum Role {
        KeyRole = Qt::UserRole + 1,
        NameRole,
        DescriptionRole,
        KindRole,
        ValueRole,
        AutoTextRole,  ///< what is shown while the planner chooses; empty where a value is set
        CanBeAutoRole,
        QuantityRole,
        FromRole,
        ToRole,
        StepRole,
        DecimalsRole,
        SliderToRole,  ///< end of the slider; 0 for none
        ChoicesRole,   ///< names
        ChoiceIndexRole,
        ChoiceHintRole,  ///< description of what is chosen
        CheckedRole,
        TextRole,    ///< of lines and lists, as the settings hold them
        PickedRole,  ///< what a text that is picked on the map holds, in words; empty where it is empty
        PickRole,
    };

    explicit ParameterModel(QObject* parent = nullptr);

    /// Shows these settings with the values of `settings`; `plan` may be null.
    void show(const std::vector<const Parameter*>& parameters, const Settings& settings, const Plan* plan);

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QHash<int, QByteArray> roleNames() const override;

    /// `live`: more values will follow while the user drags.
    Q_INVOKABLE void setNumber(int row, double value, bool live = false);
    Q_INVOKABLE void setAuto(int row);
    Q_INVOKABLE void setChoice(int row, int choice);
    Q_INVOKABLE void setFlag(int row, bool on);
    /// Whether the text can be a value of this setting.
    Q_INVOKABLE bool accepts(int row, const QString& text) const;
    Q_INVOKABLE void setText(int row, const QString& text);
    /// The user wants to pick it on the map, or from a list of files.
    Q_INVOKABLE void pick(int row);

signals:
    /// The user wants this value, in the unit of the settings.
    void changeRequested(const furrow::Parameter* parameter, const furrow::SettingValue& value, bool live);
    /// `how` is a Pick.
    void pickRequested(const QString& key, int how);

private:
    const Parameter& at(int row) const { return *parameters_[static_cast<std::size_t>(row)]; }
    QVariant value(const Parameter& parameter, int role) const;
    Pick pickOf(const Parameter& parameter) const;
    void showRows(const std::vector<const Parameter*>& parameters);
    void refresh();

    std::vector<const Parameter*> parameters_;
    Settings settings_;
    /// Numbers that the planner chose, by key.
    std::map<std::string, double, std::less<>> used_;
    double widthM_ = 0.0;
};

}  // namespace furrow
