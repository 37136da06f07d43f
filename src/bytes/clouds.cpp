// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "bytes/clouds.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/parallel.h"
#include "bytes/tables.h"
#include "geometry/rigid_motion.h"

namespace jalon {

namespace {

constexpr size_t kPointBytes = 3 * sizeof(double);
constexpr size_t kPointsAtOnce = 1 << 15;

Buffer<double> read_points(ByteReader& reader, Task& task) {
  const size_t points = reader.count(kPointBytes);
  const uint8_t* from = reader.block(points * kPointBytes);
  Buffer<double> xyz(3 * points);
  std::vector<char> is_finite((points + kPointsAtOnce - 1) / kPointsAtOnce, 1);
  parallel_for(task, points, kPointsAtOnce, [&](size_t begin, size_t end) {
    double* to = xyz.data() + 3 * begin;
    std::memcpy(to, from + begin * kPointBytes, (end - begin) * kPointBytes);
    is_finite[begin / kPointsAtOnce] =
        std::all_of(to, to + 3 * (end - begin), [](double v) { return std::isfinite(v); });
  });
  if (std::find(is_finite.begin(), is_finite.end(), 0) != is_finite.end())
    reader.refuse("a coordinate is not finite");
  return xyz;
}

std::vector<Station> read_stations(ByteReader& reader, size_t points) {
  std::vector<Station> stations;
  reader.list(stations);
  uint64_t end = 0;
  for (const Station& station : stations) {
    if (!is_rigid(station.pose)) reader.refuse("the pose of a station is no rigid motion");
    if (station.first < end || station.first > points || station.count > points - station.first)
      reader.refuse("a station has points that another has, or more than there are");
    end = station.first + station.count;
  }
  return stations;
}

std::vector<Attachment> read_attachments(ByteReader& reader) {
  std::vector<Attachment> attachments(reader.count(2 * sizeof(uint64_t)));
  for (Attachment& attachment : attachments) {
    attachment.key = reader.text();
    reader.list(attachment.bytes);
  }
  return attachments;
}

}  // namespace

void write_cloud(ByteWriter& writer, const Cloud& cloud) {
  writer.item(static_cast<uint64_t>(cloud.size()));
  writer.block(cloud.xyz_buffer->data(), cloud.size() * kPointBytes);
  write_table(writer, cloud.fields);
  writer.list(cloud.stations);
  writer.item(cloud.crs);
  const size_t attachments = cloud.attachments != nullptr ? cloud.attachments->size() : 0;
  writer.item(static_cast<uint64_t>(attachments));
  for (size_t i = 0; i < attachments; ++i) {
    writer.item(cloud.attachments->at(i).key);
    writer.list(cloud.attachments->at(i).bytes);
  }
}

Cloud read_cloud(ByteReader& reader, Task& task) {
  Cloud cloud = make_cloud(read_points(reader, task));
  cloud.fields = read_table(reader, task);
  require_rows(reader, cloud.fields, "fields", cloud.size());
  cloud.stations = read_stations(reader, cloud.size());
  reader.item(cloud.crs);
  if (std::vector<Attachment> attachments = read_attachments(reader); !attachments.empty())
    cloud.attachments = std::make_shared<const std::vector<Attachment>>(std::move(attachments));
  return cloud;
}

}  // namespace jalon
