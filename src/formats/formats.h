// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "base/params.h"
#include "base/task.h"
#include "cloud/cloud.h"
#include "formats/settings.h"
#include "model/model.h"
#include "model/part_attributes.h"

// Files of clouds and models. registry.h has a row for each format; nothing else knows them.
namespace jalon {

/// Parameter tables of the operations "read", "write" and "convert": ReadSettings, WriteSettings, ConvertSettings.
std::span<const ParamRow> read_rows();
std::span<const ParamRow> write_rows();
std::span<const ParamRow> convert_rows();

/// The format is the option's, or that of the content, or of the extension, in this order. Errors
/// name file, offset and reason.
Cloud read_cloud(const std::string& path, const ReadSettings& settings, Task& task);
Model read_model(const std::string& path, const ReadSettings& settings, Task& task);
/// The option's format, or that of the extension.
void write_cloud(const Cloud& cloud, const std::string& path, const WriteSettings& settings,
                 Task& task);
/// Reads and writes, piece by piece where both formats can; the bytes are the same. Gives the number of points.
uint64_t convert_cloud(const std::string& from, const std::string& to,
                       const ConvertSettings& settings, Task& task);
/// attributes: of the model's parts, for formats that have a place for them (CityJSON); may be nullptr.
void write_model(const Model& model, const std::string& path, const WriteSettings& settings,
                 Task& task, const PartAttributes* attributes = nullptr);

/// The registry, for listings.
struct FormatInfo {
  const char* name;        ///< "LAS"
  const char* extensions;  ///< "las"
  const char* abilities;   ///< "cloud read write"
};
std::span<const FormatInfo> formats();

}  // namespace jalon
