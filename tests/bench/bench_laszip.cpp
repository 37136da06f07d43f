// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// bench_laszip PREFIX [all]: LASzip's API reading PREFIX_pf0.las and PREFIX_pf3.las, and the same
// compressed, PREFIX_pf0.laz and PREFIX_pf3.laz, point by point as the API has it. Keeps the
// coordinates only (its fastest use), or, with "all", every attribute in a column of its own, which is
// what Jalon's reader does. LASzip has no threads.

#include <laszip_api.h>

#include "driver.h"

namespace {

struct Columns {
  std::vector<double> xyz, time;
  std::vector<uint16_t> intensity, source, rgb;
  std::vector<uint8_t> returns, classification, user;
  std::vector<int8_t> angle;
};

void keep_attributes(const laszip_point_struct& point, bool is_format_3, Columns& columns) {
  columns.intensity.push_back(point.intensity);
  columns.source.push_back(point.point_source_ID);
  columns.returns.push_back(
      static_cast<uint8_t>(point.return_number | point.number_of_returns << 3));
  columns.classification.push_back(point.classification);
  columns.user.push_back(point.user_data);
  columns.angle.push_back(point.scan_angle_rank);
  if (!is_format_3) return;
  columns.time.push_back(point.gps_time);
  columns.rgb.insert(columns.rgb.end(), point.rgb, point.rgb + 3);
}

void reserve(size_t count, bool all, bool is_format_3, Columns& columns) {
  columns.xyz.resize(3 * count);
  if (!all) return;
  columns.intensity.reserve(count);
  columns.source.reserve(count);
  columns.returns.reserve(count);
  columns.classification.reserve(count);
  columns.user.reserve(count);
  columns.angle.reserve(count);
  if (!is_format_3) return;
  columns.time.reserve(count);
  columns.rgb.reserve(3 * count);
}

void check(laszip_I32 code, const char* what) {
  if (code == 0) return;
  std::fprintf(stderr, "LASzip: %s failed\n", what);
  std::exit(1);
}

bench::Result read(const std::string& path, bool all) {
  Columns columns;
  const bench::Stopwatch watch;
  laszip_POINTER reader = nullptr;
  laszip_BOOL is_compressed = 0;
  laszip_header_struct* header = nullptr;
  laszip_point_struct* point = nullptr;
  check(laszip_create(&reader), "create");
  check(laszip_open_reader(reader, path.c_str(), &is_compressed), "open");
  check(laszip_get_header_pointer(reader, &header), "header");
  check(laszip_get_point_pointer(reader, &point), "point");
  const size_t count = header->number_of_point_records;
  const bool is_format_3 = header->point_data_format == 3;
  reserve(count, all, is_format_3, columns);
  for (size_t i = 0; i < count; ++i) {
    check(laszip_read_point(reader), "read");
    check(laszip_get_coordinates(reader, &columns.xyz[3 * i]), "coordinates");
    if (all) keep_attributes(*point, is_format_3, columns);
  }
  check(laszip_close_reader(reader), "close");
  check(laszip_destroy(reader), "destroy");
  bench::Result result{watch.seconds(), count, {}};
  bench::for_samples(count, [&](size_t i) {
    for (size_t axis = 0; axis < 3; ++axis) result.sample.push_back(columns.xyz[3 * i + axis]);
  });
  return result;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const std::string prefix = argv[1];
  const bool all = argc > 2;
  const size_t points = read(prefix + "_pf0.las", false).count;
  return bench::serve(all ? "LASzip-all" : "LASzip", points,
                      {{"las0", [&](int, bool) { return read(prefix + "_pf0.las", all); }},
                       {"las3", [&](int, bool) { return read(prefix + "_pf3.las", all); }},
                       {"laz0", [&](int, bool) { return read(prefix + "_pf0.laz", all); }},
                       {"laz3", [&](int, bool) { return read(prefix + "_pf3.laz", all); }}});
}
