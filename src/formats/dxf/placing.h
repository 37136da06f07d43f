// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <string>

#include "base/task.h"
#include "formats/dxf/shapes.h"

namespace jalon::dxf {

/// Blocks by their name, as INSERT finds them: without regard to capitals.
using Blocks = std::map<std::string, Shapes>;

/// Takes what a drawing shows: the shapes themselves, and those of inserted blocks where they are placed.
struct Taker {
  std::function<void(Loop)> loop;
  std::function<void(Patch)> patch;
  std::function<void(const std::string& block)> missing;
};

/// Of the file, for messages and for what its blocks may become.
struct DrawingFile {
  std::string path;
  uint64_t bytes = 0;
};

/// Arcs stay arcs where a block is placed with one scale along and across them; else they become chords. What stands on
/// layer 0 of a block takes the layer of its INSERT. Error(kLimit) where blocks in blocks become far more than
/// the file tells.
void place(const Shapes& shapes, const Blocks& blocks, const Taker& taker, const DrawingFile& file,
           Task& task);

}  // namespace jalon::dxf
