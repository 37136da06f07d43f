// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

// STL (3D Systems, "Stereolithography Interface Specification", 1989): in its binary form a header without meaning, a
// count, and records of a normal, three corners (float32, little-endian) and two spare bytes.
namespace jalon::stl {

inline constexpr size_t kHeaderBytes = 80, kCountBytes = 4, kRecordBytes = 50;
/// Begins the header of files whose coordinates have a shift taken off; the shift in metres follows.
inline constexpr char kShiftWord[] = "Jalon, metres, add";

}  // namespace jalon::stl
