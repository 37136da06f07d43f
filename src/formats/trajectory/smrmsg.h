// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "base/task.h"
#include "model/trajectory/trajectory.h"

namespace jalon {

/// The sigmas of a file smrmsg (usually one a second), linear in time between its records, turned
/// from north, east, down to the world's axes. Before its first record and behind its last they are
/// held for as long as its longest step; Error(kFormat) beyond.
void add_sigmas(Trajectory& trajectory, std::span<const Matrix3> T_world_local,
                const std::string& path, Task& task);
/// A record an epoch; the trajectory has all sigmas.
void write_smrmsg(const Trajectory& trajectory, std::span<const Matrix3> T_world_local,
                  const std::string& path, Task& task);

}  // namespace jalon
