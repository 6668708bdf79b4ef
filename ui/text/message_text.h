#pragma once

#include "planner/core/message.h"

#include <QString>
#include <QStringList>

#include <functional>
#include <string_view>
#include <vector>

namespace furrow {

/// What the planner says, in the user's language and units. The one way from the planner's texts to the
/// window.
QString shown(const Message& message);
/// The same as a sentence of its own: with a capital.
QString sentence(const Message& message);
/// A fixed text of the planner: names and descriptions of methods, parameters, formats.
QString shown(std::string_view text);
QString shown(const char* text);
QString shown(const std::string& text);
/// One sentence each.
QStringList sentences(const std::vector<Message>& messages);

/// A text that is kept and made anew whenever it is read, so that it follows the language.
using LazyText = std::function<QString()>;
/// Empty where nothing is said.
QString text(const LazyText& said);

}  // namespace furrow
