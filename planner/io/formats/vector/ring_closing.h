#pragma once

#include "planner/io/formats/vector/vector_file.h"

#include <optional>
#include <string>
#include <vector>

namespace furrow {

// Internal to the reader of vector files: lines that mean areas.

/// What is said of rings that a file left open; they are closed as they are read.
std::optional<Note> noteOfOpenRings(const VectorFeature& feature, Message where);

/// Closed lines count as areas in drawings and where nothing better is there.
void closeLines(VectorFeature& feature);

/// Recorded tracks that went round something and stopped shortly before they were there again.
void closeTracks(VectorFeature& feature, std::vector<Note>& notes, const std::string& name);

}  // namespace furrow
