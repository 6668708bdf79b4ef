#pragma once

#include "ui/project/document.h"

#include <QUndoCommand>

namespace furrow {

/// One change of the project, by the project before and after it.
class ChangeCommand : public QUndoCommand {
public:
    ChangeCommand(Document& document, LazyText text, std::shared_ptr<const Project> before,
                  std::shared_ptr<const Project> after, QString key, Document::Follows follows);

    const std::shared_ptr<const Project>& before() const { return before_; }
    const std::shared_ptr<const Project>& after() const { return after_; }
    /// What it does, in the user's language: QUndoCommand's own text would stay in the one it was made in.
    QString said() const { return furrow::text(text_); }
    const QString& key() const { return key_; }
    bool isOpen() const { return follows_ == Document::Follows::More; }
    void close() { follows_ = Document::Follows::Nothing; }

    void undo() override;
    void redo() override;
    int id() const override { return key_.isEmpty() ? -1 : 1; }
    bool mergeWith(const QUndoCommand* other) override;

private:
    Document& document_;
    LazyText text_;
    std::shared_ptr<const Project> before_;
    std::shared_ptr<const Project> after_;
    QString key_;
    Document::Follows follows_;
};

}  // namespace furrow
