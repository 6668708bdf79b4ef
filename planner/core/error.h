#pragma once

#include "planner/core/geo_point.h"
#include "planner/core/message.h"

#include <optional>
#include <string>

namespace furrow {

/// What a caller does about an error; one code for each different reaction.
enum class ErrorCode {
    Usage,         ///< the request names something that does not exist, or leaves out what is needed
    InputRefused,  ///< the field, machine or a value cannot be planned with
    ReadFailed,    ///< a file could not be read
    WriteFailed,   ///< a file could not be written
    Cancelled,     ///< stopped on request; nothing partial is left behind
};

/// A failed operation, told in three parts: what, where, and what to do about it.
struct Error {
    ErrorCode code = ErrorCode::InputRefused;
    Message what;                   ///< one sentence without its final stop
    Message where;                  ///< file, part, vertex or setting; empty where there is no place
    Message remedy;                 ///< what the user can do; empty where nothing is known to help
    std::optional<GeoPoint> place;  ///< on the map, where it has one

    /// All three parts in one line, as the command line prints it.
    std::string line() const;

    friend bool operator==(const Error&, const Error&) = default;
};

/// The error of every stage that was stopped.
Error cancelled();

/// Something that worked, but that the user should know: a repaired boundary, a narrower headland.
struct Note {
    Message text;
    Message where;
    std::optional<GeoPoint> place;

    friend bool operator==(const Note&, const Note&) = default;
};

}  // namespace furrow
