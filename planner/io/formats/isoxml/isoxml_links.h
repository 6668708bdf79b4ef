#pragma once

#include "planner/io/content/field_content.h"

#include <map>
#include <span>
#include <string>
#include <string_view>

namespace furrow {

/// What a field is known by wherever it goes: its id where that is a UUID (a link list or another program
/// gave it), else a UUID of version 8 (RFC 9562) made of id, name and place to a hundredth of a degree. The
/// same field gives the same one in every export, so that a terminal updates it instead of adding it again.
std::string fieldUuid(const FieldSource& field);

/// The text of LINKLIST.XML beside task data of version 4 whose fields are PFD1, PFD2, ... in this order.
std::string isoxmlLinkList(std::span<const FieldContent> fields);

/// UUIDs by the id of their object ("PFD1") of such a file; empty where it is none. Cost: linear.
std::map<std::string, std::string> isoxmlLinks(std::string_view xml);

}  // namespace furrow
