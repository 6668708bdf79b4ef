#pragma once

#include "planner/io/content/format_parts.h"

namespace furrow {

/// path.pb: the message furrow.v1.PathMessage of planner/io/formats/protobuf/proto/path_message.proto.
FormatWriter writeProtobuf;
ContentFinder findPathMessage;

}  // namespace furrow
