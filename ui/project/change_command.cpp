#include "ui/project/change_command.h"

#include <utility>

namespace furrow {

ChangeCommand::ChangeCommand(Document& document, LazyText text, std::shared_ptr<const Project> before,
                             std::shared_ptr<const Project> after, QString key, Document::Follows follows)
    : document_{document},
      text_{std::move(text)},
      before_{std::move(before)},
      after_{std::move(after)},
      key_{std::move(key)},
      follows_{follows} {}

void ChangeCommand::undo() {
    close();
    document_.show(before_);
}

void ChangeCommand::redo() {
    document_.show(after_);
}

bool ChangeCommand::mergeWith(const QUndoCommand* other) {
    const auto& next = static_cast<const ChangeCommand&>(*other);
    if (!isOpen() || next.key_ != key_) {
        return false;
    }
    after_ = next.after_;
    follows_ = next.follows_;
    // While it goes on it may come back to where it began and leave again.
    setObsolete(!isOpen() && *after_ == *before_);
    return true;
}

}  // namespace furrow
