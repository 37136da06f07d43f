// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "base/params.h"
#include "base/task.h"
#include "cloud/cloud.h"
#include "model/model.h"

namespace jalon {

/// Parameter tables of the operations "read" and "write".
std::span<const ParamRow> read_rows();
std::span<const ParamRow> write_rows();

/// By content first, by extension second. Errors name file, offset and reason.
Cloud read_cloud(const std::string& path, const ParamSet& options, Task& task);
void write_cloud(const Cloud& cloud, const std::string& path, const ParamSet& options, Task& task);
Model read_model(const std::string& path, const ParamSet& options, Task& task);
void write_model(const Model& model, const std::string& path, const ParamSet& options, Task& task);

/// The registry, for listings.
struct FormatInfo {
  const char* name;        ///< "LAS"
  const char* extensions;  ///< "las"
  const char* abilities;   ///< "cloud read write"
};
std::span<const FormatInfo> formats();

}  // namespace jalon
