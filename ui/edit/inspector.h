#pragma once

#include "planner/plan/turn_options.h"
#include "ui/edit/field_editor.h"
#include "ui/edit/inspector_text.h"
#include "ui/jobs/job_runner.h"

#include <QtQml/qqmlregistration.h>
#include <QAbstractListModel>

#include <memory>
#include <optional>
#include <utility>

namespace furrow {

/// What is selected on the map: its lines, what can be typed of it, and one sentence about it.
class Inspector : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    Q_PROPERTY(furrow::FieldEditor* editor READ editor WRITE setEditor NOTIFY editorChanged REQUIRED FINAL)
    Q_PROPERTY(bool shown READ isShown NOTIFY changed FINAL)
    Q_PROPERTY(QString title READ title NOTIFY changed FINAL)
    Q_PROPERTY(QString sentence READ sentence NOTIFY changed FINAL)
    /// Obstacles can be passable or not.
    Q_PROPERTY(bool hasPassable READ hasPassable NOTIFY changed FINAL)
    Q_PROPERTY(bool passable READ isPassable WRITE setPassable NOTIFY changed FINAL)
    Q_PROPERTY(bool isEdge READ isEdge NOTIFY changed FINAL)
    Q_PROPERTY(bool hasOwnHeadland READ hasOwnHeadland NOTIFY changed FINAL)

public:
    enum class Kind { Figure, Number, Text };
    Q_ENUM(Kind)
    enum Role {
        LabelRole = Qt::UserRole + 1,
        TextRole,
        KindRole,
        NumberRole,
        QuantityRole,
        DecimalsRole,
        FromRole,
        ToRole
    };

    explicit Inspector(QObject* parent = nullptr) : QAbstractListModel{parent} {}

    FieldEditor* editor() const { return editor_; }
    void setEditor(FieldEditor* editor);
    bool isShown() const { return text_.has_value(); }
    QString title() const { return text_ ? text_->title : QString{}; }
    QString sentence() const { return text_ ? text_->sentence : QString{}; }
    bool hasPassable() const { return text_ && text_->passable; }
    bool isPassable() const { return text_ && text_->passable.value_or(false); }
    void setPassable(bool passable);
    bool isEdge() const { return text_ && text_->isEdge; }
    bool hasOwnHeadland() const { return text_ && text_->hasOwnHeadland; }

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QHash<int, QByteArray> roleNames() const override;

    Q_INVOKABLE void setNumber(int row, double number);
    Q_INVOKABLE void setText(int row, const QString& text);

signals:
    void editorChanged();
    void changed();

private:
    void follow();
    /// What else could be driven in place of the turn that is selected: looked for in the background.
    void askForOptions();
    const InspectorRow& at(int row) const { return text_->rows[static_cast<std::size_t>(row)]; }

    FieldEditor* editor_ = nullptr;
    std::optional<InspectorText> text_;
    /// The plan and the segment whose options are here, or are looked for.
    std::pair<std::shared_ptr<const Plan>, int> askedOf_{nullptr, -1};
    std::optional<TurnOptions> options_;
    JobRunner optionsAsker_;
};

}  // namespace furrow
