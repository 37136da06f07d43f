// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>

#include "base/task.h"
#include "cloud/cloud.h"

namespace jalon {

/// The step to which each coordinate was rounded when it was kept in 32 bits, which is 0.5 m of a northing of a
/// national grid; 0: it was not, or it cannot be told. Told by the values alone, whatever file they come from: all are
/// of single precision, and its last bit is used.
std::array<double, 3> single_precision_steps(const Cloud& cloud);

/// One warning where that has cost the scan its shape.
void warn_of_single_precision(const Cloud& cloud, const std::string& path, Task& task);

}  // namespace jalon
