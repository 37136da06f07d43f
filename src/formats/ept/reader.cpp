// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "base/parallel.h"
#include "formats/ept/data_set.h"
#include "formats/ept/ept.h"
#include "formats/ept/hierarchy.h"
#include "formats/ept/index.h"
#include "formats/ept/nodes.h"
#include "formats/files/endian.h"
#include "formats/files/finish_cloud.h"

namespace jalon {

namespace {

using namespace ept;

int most_level_of(const Index& index, double spacing_m) {
  int level = 0;
  while (level < las::kMostCopcLevel && std::ldexp(index.spacing, -level) > spacing_m) ++level;
  return level;
}

void get_coordinates(const Index& index, const std::byte* records, size_t n, double* xyz) {
  for (size_t k = 0; k < 3; ++k) {
    const Index::Axis& axis = index.axes[k];
    visit(axis.type, [&](auto zero) {
      for (size_t i = 0; i < n; ++i)
        xyz[3 * i + k] = static_cast<double>(
                             load<decltype(zero)>(records + i * index.record_bytes + axis.offset)) *
                             axis.scale +
                         axis.shift;
    });
  }
}

void get_field(const Index& index, const Index::Member& member, const std::byte* records, size_t n,
               size_t first, Column& column) {
  visit(member.type, [&](auto zero) {
    using T = decltype(zero);
    T* to = static_cast<T*>(column.raw()) + first * member.components;
    for (size_t i = 0; i < n; ++i)
      for (uint32_t c = 0; c < member.components; ++c)
        *to++ = load<T>(records + i * index.record_bytes + member.offset + c * sizeof(T));
  });
}

Cloud cloud_of(const ByteSource& source, const Index& index, const std::vector<Node>& nodes,
               Task& task) {
  std::vector<size_t> first = {0};
  for (const Node& node : nodes) first.push_back(first.back() + static_cast<size_t>(node.points));
  const size_t all = first.back();
  Buffer<double> xyz(3 * all);
  std::vector<std::shared_ptr<Column>> columns;
  for (const Index::Member& member : index.members)
    columns.push_back(std::make_shared<Column>(
        FieldInfo{member.field, member.type, member.components, "", ""}, all));
  parallel_chunks(task, nodes.size(), [&](size_t k) {
    const size_t n = first[k + 1] - first[k];
    std::vector<std::byte> records(n * index.record_bytes);
    const std::string name = name_of(nodes[k].key) + ".bin";
    ByteSource(file_beside(source.path(), kDataFolder, name))
        .read(0, records.data(), records.size());
    get_coordinates(index, records.data(), n, xyz.data() + 3 * first[k]);
    for (size_t c = 0; c < columns.size(); ++c)
      get_field(index, index.members[c], records.data(), n, first[k], *columns[c]);
  });
  Cloud cloud = make_cloud(std::move(xyz));
  for (const auto& column : columns) cloud.fields.add(column);
  cloud.crs = index.crs;
  return cloud;
}

}  // namespace

Cloud read_ept(const ByteSource& source, const ReadSettings& settings, Task& task) {
  ProgressSpan span(task, 0, 0.99, "reading EPT");
  const Index index = read_index(source, task);
  const int most_level =
      settings.spacing_m > 0 ? most_level_of(index, settings.spacing_m) : las::kMostCopcLevel;
  Cloud cloud = cloud_of(source, index,
                         wanted_nodes(source, index, settings.box_m(), most_level, task), task);
  if (!index.stations.stations.empty()) {
    cloud = with_told_stations(std::move(cloud), index.stations, {1, 1, 1}, source.path(), task);
    if (!cloud.stations.empty()) cloud.fields.remove(index.stations.field);
  }
  return finish_cloud(std::move(cloud), source, settings.drop_invalid, task);
}

}  // namespace jalon
