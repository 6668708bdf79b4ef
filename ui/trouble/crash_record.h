#pragma once

#include <filesystem>
#include <string>

namespace furrow {

/// Keeps on the disk what a crash ended: what the program was, what it worked on, and where it stopped.
/// Nothing is ever sent.
///
/// A handler of fatal signals may do hardly anything. So the text is made beforehand, whenever the work
/// changes, and the handler only writes it.
namespace crash_record {

/// From now on a crash of this process writes `FOLDER/crash-PID.txt`, which is there whole or not at all.
/// The folder is made. Called once, by the program that people use.
void begin(const std::filesystem::path& folder);

/// What will stand in the record, as one line of JSON. Thread: the one that called `begin`.
void setText(std::string text);

}  // namespace crash_record

}  // namespace furrow
