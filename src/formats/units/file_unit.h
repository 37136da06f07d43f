// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/task.h"
#include "cloud/cloud.h"
#include "formats/settings.h"

namespace jalon {

/// Metres a unit of the option "unit"; 1 for kAuto.
double metres_of(FileUnit unit);
/// The cloud of a file whose format names no unit, in metres: its coordinates times metres_of(unit).
Cloud in_metres(Cloud cloud, FileUnit unit, Task& task);

}  // namespace jalon
