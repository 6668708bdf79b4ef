#include "ui/project/document.h"

#include "ui/project/change_command.h"
#include "ui/project/last_machine.h"
#include "ui/text/display.h"

#include <utility>

namespace furrow {

Document::Document(QObject* parent)
    : QObject{parent}, base_{std::make_shared<const Project>(freshProject())}, project_{base_} {
    connect(&stack_, &QUndoStack::indexChanged, this, &Document::historyChanged);
    connect(&stack_, &QUndoStack::cleanChanged, this, &Document::historyChanged);
    connect(&Display::instance(), &Display::changed, this, &Document::historyChanged);
}

const ChangeCommand* Document::commandAt(int index) const {
    return static_cast<const ChangeCommand*>(stack_.command(index));
}

QString Document::undoText() const {
    const ChangeCommand* command = canUndo() ? commandAt(stack_.index() - 1) : nullptr;
    return command == nullptr ? QString{} : command->said();
}

QString Document::redoText() const {
    const ChangeCommand* command = canRedo() ? commandAt(stack_.index()) : nullptr;
    return command == nullptr ? QString{} : command->said();
}

bool Document::isDragging() const {
    if (pushed_) {
        return *pushed_ == Follows::More;
    }
    const ChangeCommand* last = commandAt(stack_.index() - 1);
    return last != nullptr && last->isOpen();
}

void Document::change(LazyText text, Project after, const QString& key, Follows follows) {
    auto changed = std::make_shared<const Project>(std::move(after));
    if (isDragging() && commandAt(stack_.index() - 1)->key() != key) {
        endDrag();
    }
    if (!isDragging() && *changed == *project_) {
        return;
    }
    // The stack tells of a change before it has it.
    pushed_ = follows;
    stack_.push(new ChangeCommand{*this, std::move(text), project_, std::move(changed), key, follows});
    pushed_.reset();
}

void Document::look(Project project) {
    endDrag();
    show(std::make_shared<const Project>(std::move(project)));
}

void Document::endDrag() {
    if (isDragging()) {
        const_cast<ChangeCommand*>(commandAt(stack_.index() - 1))->close();
        emit dragEnded();
    }
}

void Document::undo() {
    stack_.undo();
}

void Document::redo() {
    stack_.redo();
}

void Document::begin(const History& history) {
    // Of all the states on the way only the last one is to be seen.
    beginning_ = true;
    stack_.clear();
    base_ = history.base;
    show(base_);
    if (history.saved == std::size_t{0}) {
        stack_.setClean();
    }
    for (std::size_t i = 0; i < history.steps.size(); ++i) {
        const HistoryStep& step = history.steps[i];
        stack_.push(new ChangeCommand{*this,
                                      [text = QString::fromStdString(step.text)] { return text; },
                                      project_,
                                      step.after,
                                      {},
                                      Follows::Nothing});
        if (history.saved == i + 1) {
            stack_.setClean();
        }
    }
    if (!history.saved) {
        stack_.resetClean();
    }
    stack_.setIndex(static_cast<int>(history.done));
    beginning_ = false;
    emit begun();
    emit projectChanged();
    emit historyChanged();
}

History Document::history() const {
    History history;
    history.base = base_;
    for (int i = 0; i < stack_.count(); ++i) {
        const ChangeCommand* command = commandAt(i);
        history.steps.push_back({command->said().toStdString(), command->after()});
    }
    history.done = static_cast<std::size_t>(stack_.index());
    if (stack_.cleanIndex() >= 0) {
        history.saved = static_cast<std::size_t>(stack_.cleanIndex());
    }
    return history;
}

bool Document::revert() {
    if (stack_.cleanIndex() < 0) {
        return false;
    }
    stack_.setIndex(stack_.cleanIndex());
    return true;
}

void Document::show(std::shared_ptr<const Project> project) {
    if (project != project_) {
        project_ = std::move(project);
        if (!beginning_) {
            emit projectChanged();
        }
    }
}

}  // namespace furrow
