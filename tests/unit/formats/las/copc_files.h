// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "formats/codecs/codecs.h"
#include "formats/files/endian.h"
#include "formats/las/copc.h"
#include "formats/las/las.h"
#include "unit/formats/las/las_bytes.h"
#include "unit/formats/opened_file.h"

namespace jalon::test {

constexpr size_t kCopcInfoAt = 375 + las::kVlrHeader;  // of the data of the first record

inline bool lacks_codecs() {
  if (has_codecs()) return false;
  MESSAGE("skipped: built without JALON_WITH_RUST_FORMATS");
  return true;
}

/// A wall above a ground, far from the origin, with the number of each point as the field "id".
inline Cloud wall_and_ground(size_t n, uint64_t seed) {
  RandomStream random(seed, 1);
  Buffer<double> xyz(3 * n);
  auto id = std::make_shared<Column>(FieldInfo{"id", ElementType::kUint32, 1, "", ""}, n);
  for (size_t i = 0; i < n; ++i) {
    const bool wall = i % 3 != 0;
    xyz[3 * i] = 652000 + 30 * random.uniform();
    xyz[3 * i + 1] = 6861000 + (wall ? 0.02 * random.normal() : 20 * random.uniform());
    xyz[3 * i + 2] = 100 + (wall ? 12 * random.uniform() : 0.02 * random.normal());
    id->values<uint32_t>()[i] = static_cast<uint32_t>(i);
  }
  Cloud cloud = make_cloud(std::move(xyz));
  cloud.fields.set(id);
  return cloud;
}

inline std::string copc_bytes(const Cloud& cloud, unsigned threads = 0,
                              const std::string& name = "a.copc.laz") {
  const Folder folder;
  Task::Hooks hooks;
  hooks.threads = threads;
  Task task(hooks);
  write_cloud(cloud, folder.file(name), {}, task);
  return slurp(folder.file(name));
}

inline std::vector<uint32_t> ids_of(const Cloud& cloud) {
  const auto values = cloud.fields.require("id").values<uint32_t>();
  return {values.begin(), values.end()};
}

inline ReadSettings in_box(const Box3& box) {
  ReadSettings settings;
  settings.box = {box.min.x, box.min.y, box.min.z, box.max.x, box.max.y, box.max.z};
  return settings;
}

struct NodeInFile {
  size_t at = 0;  ///< of its entry
  las::CopcEntry entry;
};
/// The entries of the one page that our writer makes.
inline std::vector<NodeInFile> nodes_in(const std::string& bytes) {
  std::vector<NodeInFile> nodes;
  const auto page = get_at<uint64_t>(bytes, kCopcInfoAt + 40);
  const auto size = get_at<uint64_t>(bytes, kCopcInfoAt + 48);
  for (size_t at = page; at < page + size; at += las::kCopcEntryBytes)
    nodes.push_back({at,
                     {{get_at<int32_t>(bytes, at), get_at<int32_t>(bytes, at + 4),
                       get_at<int32_t>(bytes, at + 8), get_at<int32_t>(bytes, at + 12)},
                      get_at<uint64_t>(bytes, at + 16),
                      get_at<int32_t>(bytes, at + 24),
                      get_at<int32_t>(bytes, at + 28)}});
  return nodes;
}

}  // namespace jalon::test
