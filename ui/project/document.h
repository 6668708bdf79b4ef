#pragma once

#include "planner/project/history.h"
#include "ui/text/message_text.h"

#include <QtQml/qqmlregistration.h>
#include <QObject>
#include <QUndoStack>

#include <optional>

namespace furrow {

class ChangeCommand;

/// The farm that is worked on. Every change of it is a command that can be undone; there is no other way to
/// change it but for what is merely looked at.
class Document : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("made by the application")
    Q_PROPERTY(bool canUndo READ canUndo NOTIFY historyChanged FINAL)
    Q_PROPERTY(bool canRedo READ canRedo NOTIFY historyChanged FINAL)
    /// What would be undone or redone: "Move a point"; empty for nothing.
    Q_PROPERTY(QString undoText READ undoText NOTIFY historyChanged FINAL)
    Q_PROPERTY(QString redoText READ redoText NOTIFY historyChanged FINAL)
    /// Differs from what was saved last.
    Q_PROPERTY(bool modified READ isModified NOTIFY historyChanged FINAL)

public:
    /// Whether more changes of the same kind follow and belong to this one, as while something is dragged.
    enum class Follows { Nothing, More };

    explicit Document(QObject* parent = nullptr);

    const std::shared_ptr<const Project>& project() const { return project_; }
    bool canUndo() const { return stack_.canUndo(); }
    bool canRedo() const { return stack_.canRedo(); }
    QString undoText() const;
    QString redoText() const;
    bool isModified() const { return !stack_.isClean(); }
    /// The last change was one that others follow.
    bool isDragging() const;

    /// Changes the project. Changes with the same `key` are one command until one comes that nothing follows.
    /// `text` says what is done, in the language of the moment it is asked in.
    void change(LazyText text, Project after, const QString& key = {}, Follows follows = Follows::Nothing);
    /// Shows another field or plan: nothing to undo.
    void look(Project project);
    /// What was dragged last is done.
    void endDrag();

    Q_INVOKABLE void undo();
    Q_INVOKABLE void redo();

    /// Begins with another project, saved or not.
    void begin(const History& history);
    History history() const;
    void markSaved() { stack_.setClean(); }
    /// Back to what was saved last. False where that is no longer known.
    bool revert();

signals:
    /// Another project took the place of the one before.
    void begun();
    /// What was dragged is done.
    void dragEnded();
    /// The project is another one than before.
    void projectChanged();
    void historyChanged();

private:
    friend class ChangeCommand;
    /// The command that leads to the state at this place of the stack; null where there is none.
    const ChangeCommand* commandAt(int index) const;
    void show(std::shared_ptr<const Project> project);

    QUndoStack stack_;
    std::shared_ptr<const Project> base_;
    std::shared_ptr<const Project> project_;
    bool beginning_ = false;
    /// Of the change that is being made.
    std::optional<Follows> pushed_;
};

}  // namespace furrow
