// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <memory>

#include "base/error.h"
#include "base/parallel.h"
#include "formats/files/endian.h"
#include "formats/files/fast_number.h"
#include "formats/files/component.h"
#include "formats/files/finish_cloud.h"
#include "formats/files/utf8.h"
#include "formats/pcd/header.h"
#include "formats/pcd/lzf.h"
#include "formats/pcd/pcd.h"
#include "formats/text/line_reader.h"

namespace jalon {

namespace {

using namespace pcd;

constexpr size_t kPcdGrain = size_t{1} << 15;        // points a chunk
constexpr size_t kPcdBlockBytes = size_t{96} << 10;  // read at once
constexpr size_t kPcdTicks = 4096;                   // lines between two looks at the task

/// Where one member of the records goes: elements of `type`, `stride` of them from point to point.
struct Target {
  void* out = nullptr;  ///< nullptr: padding
  size_t stride = 1;
  ElementType type = ElementType::kFloat64;
  std::array<uint8_t*, 4> packed{};  ///< blue, green, red, alpha of one packed colour
};

struct PcdPoints {
  Buffer<double> xyz;
  std::vector<std::shared_ptr<Column>> columns;
  std::vector<Target> targets;  ///< one a member
};

bool is_packed_colour(const Member& member) {
  return (member.name == "rgb" || member.name == "rgba") && member.count == 1 &&
         size_of(member.type) == 4;
}

class Layout {
 public:
  Layout(const ByteSource& source, const Header& header) : source_(source), header_(header) {}

  PcdPoints run() {
    points_.xyz = Buffer<double>(3 * header_.points);
    for (const char* name : {"x", "y", "z"})
      if (count_of(name) != 1) source_.refuse(0, "the header needs one field %s", name);
    const bool normals =
        count_of("normal_x") == 1 && count_of("normal_y") == 1 && count_of("normal_z") == 1;
    if (normals) normal_ = add({"normal", ElementType::kFloat32, 3, "", "unit normal"});
    for (const Member& member : header_.members) points_.targets.push_back(target_of(member));
    return std::move(points_);
  }

 private:
  auto count_of(std::string_view name) const -> ptrdiff_t {
    return std::ranges::count_if(header_.members,
                                 [&](const Member& m) { return m.name == name && m.count == 1; });
  }

  Column* add(FieldInfo info) {
    info.name = unique_.add(info.name);
    points_.columns.push_back(std::make_shared<Column>(std::move(info), header_.points));
    return points_.columns.back().get();
  }

  Target target_of(const Member& member) {
    Target target;
    if (member.name == "_") return target;
    for (size_t k = 0; k < 3 && member.count == 1; ++k) {
      if (member.name == std::string(1, "xyz"[k]))
        return {component(points_.xyz.data(), k), 3, ElementType::kFloat64, {}};
      if (normal_ != nullptr && member.name == std::string("normal_") + "xyz"[k])
        return {component(static_cast<float*>(normal_->raw()), k), 3, ElementType::kFloat32, {}};
    }
    if (is_packed_colour(member)) {
      static constexpr const char* kColours[] = {"red", "green", "blue", "alpha"};
      const size_t used = member.name == "rgba" ? 4 : 3;
      for (size_t k = 0; k < used; ++k) {
        Column* column = add({kColours[k], ElementType::kUint8, 1, "", ""});
        target.packed[k < 3 ? 2 - k : 3] = static_cast<uint8_t*>(column->raw());
      }
      return target;
    }
    Column* column = add({member.name, member.type, member.count, "", ""});
    return {column->raw(), member.count, member.type, {}};
  }

  const ByteSource& source_;
  const Header& header_;
  PcdPoints points_;
  Column* normal_ = nullptr;
  UniqueNames unique_;
};

// Of n points from `first` on: their member lies at from + i * step.
void put_member(const Member& member, const Target& target, const std::byte* from, size_t step,
                size_t n, size_t first) {
  if (target.packed[0] != nullptr) {
    for (size_t i = 0; i < n; ++i) {
      const auto colour = load<uint32_t>(from + i * step);
      for (unsigned k = 0; k < 4; ++k)
        if (target.packed[k] != nullptr)
          target.packed[k][first + i] = static_cast<uint8_t>(colour >> (8 * k));
    }
    return;
  }
  if (target.out == nullptr) return;
  visit(member.type, [&](auto stored_zero) {
    using Stored = decltype(stored_zero);
    const auto copy = [&](auto zero) {
      using T = decltype(zero);
      T* out = static_cast<T*>(target.out) + first * target.stride;
      for (size_t i = 0; i < n; ++i)
        for (size_t c = 0; c < member.count; ++c)
          out[i * target.stride + c] =
              static_cast<T>(load<Stored>(from + i * step + c * sizeof(Stored)));
    };
    if (target.type == member.type) return copy(Stored{});
    return target.type == ElementType::kFloat32 ? copy(float{}) : copy(double{});
  });
}

void put_records(const Header& header, const PcdPoints& points, const std::byte* records, size_t n,
                 size_t first) {
  for (size_t m = 0; m < header.members.size(); ++m)
    put_member(header.members[m], points.targets[m], records + header.members[m].offset,
               header.record_bytes, n, first);
}

void read_binary(const ByteSource& source, const Header& header, const PcdPoints& points,
                 Task& task) {
  const size_t record = header.record_bytes;
  const size_t block = std::max<size_t>(1, kPcdBlockBytes / record);
  parallel_for(task, header.points, kPcdGrain, [&](size_t begin, size_t end) {
    const auto bytes =
        std::make_unique_for_overwrite<std::byte[]>(std::min(block, end - begin) * record);
    for (size_t first = begin; first < end; first += block) {
      const size_t n = std::min(block, end - first);
      source.read(header.data_offset + uint64_t{first} * record, bytes.get(), n * record);
      put_records(header, points, bytes.get(), n, first);
    }
  });
}

using Bytes = std::unique_ptr<std::byte[]>;

// Two sizes, then all values of the first member, all of the second ... packed.
Bytes unpacked(const ByteSource& source, const Header& header, Task& task) {
  std::byte sizes[8];
  source.read(header.data_offset, sizes, sizeof sizes);
  const uint64_t packed_bytes = load<uint32_t>(sizes), bytes = load<uint32_t>(sizes + 4);
  if (!source.has(header.data_offset + 8, packed_bytes))
    source.refuse(header.data_offset, "the file ends before its %llu compressed bytes",
                  static_cast<unsigned long long>(packed_bytes));
  if (bytes != header.points * header.record_bytes)
    source.refuse(header.data_offset + 4, "the compressed points are not those of the header");
  const auto packed = std::make_unique_for_overwrite<std::byte[]>(packed_bytes);
  source.read(header.data_offset + 8, packed.get(), packed_bytes);
  task.checkpoint(0);
  // Before there is memory for what they claim to be.
  if (unpacked_lzf_bytes({packed.get(), packed_bytes}) != bytes)
    source.refuse(header.data_offset + 8, "the compressed bytes do not give the %llu promised",
                  static_cast<unsigned long long>(bytes));
  Bytes whole = std::make_unique_for_overwrite<std::byte[]>(bytes);
  if (!unpack_lzf({packed.get(), packed_bytes}, {whole.get(), bytes}))
    source.refuse(header.data_offset + 8, "the compressed bytes are damaged");
  return whole;
}

void read_compressed(const Header& header, const PcdPoints& points, const Bytes& whole,
                     Task& task) {
  parallel_for(task, header.points, kPcdGrain, [&](size_t begin, size_t end) {
    for (size_t m = 0; m < header.members.size(); ++m) {
      const Member& member = header.members[m];
      put_member(member, points.targets[m],
                 whole.get() + member.offset * header.points + begin * member.bytes(),
                 member.bytes(), end - begin, begin);
    }
  });
}

class AsciiReader {
 public:
  AsciiReader(const ByteSource& source, const Header& header, const PcdPoints& points)
      : source_(source), header_(header), points_(points), lines_(source) {}

  void run(Task& task) {
    std::string_view line;
    while (lines_.number() + 1 < header_.data_line) lines_.next(line);
    std::vector<std::byte> record(header_.record_bytes);
    for (uint64_t i = 0; i < header_.points; ++i) {
      if (i % kPcdTicks == 0) task.checkpoint(lines_.fraction());
      do {
        if (!lines_.next(line)) refuse("the file ends before the last of its points");
      } while (line.find_first_not_of(" \t") == std::string_view::npos);
      encode(line, record.data());
      put_records(header_, points_, record.data(), 1, i);
    }
  }

 private:
  [[noreturn]] void refuse(const char* reason) const {
    fail(Status::kFormat, "%.400s: line %llu: %s", source_.path().c_str(),
         static_cast<unsigned long long>(lines_.number()), reason);
  }

  // The line as a binary record.
  void encode(std::string_view line, std::byte* record) const {
    const char* p = line.data();
    const char* const end = p + line.size();
    for (const Member& member : header_.members)
      visit(member.type, [&](auto zero) {
        using T = decltype(zero);
        for (size_t c = 0; c < member.count; ++c) {
          while (p < end && (*p == ' ' || *p == '\t')) ++p;
          if (p == end) refuse("the line has fewer numbers than the header has fields");
          const T value = value_at<T>(p, end);
          store<T>(record + member.offset + c * sizeof(T), value);
        }
      });
    while (p < end && (*p == ' ' || *p == '\t')) ++p;
    if (p < end) refuse("the line has more numbers than the header has fields");
  }

  template <class T>
  T value_at(const char*& p, const char* end) const {
    const char* const from = *p == '+' ? p + 1 : p;
    T value{};
    const auto [stop, error] = std::from_chars(from, end, value);
    if (error != std::errc() || (stop < end && *stop != ' ' && *stop != '\t'))
      refuse("this is no number of the field's type");
    p = stop;
    return value;
  }

  const ByteSource& source_;
  const Header& header_;
  const PcdPoints& points_;
  LineReader lines_;
};

// Of an organised cloud: where each point was measured, and only those that were.
Cloud without_empty_cells(Cloud cloud, const Header& header, Task& task) {
  const size_t count = cloud.size();
  const struct {
    const char *name, *meaning;
  } kGrid[] = {{"row", "line of the scan's grid"}, {"column", "column of the scan's grid"}};
  for (const auto& [name, meaning] : kGrid) {
    auto column =
        std::make_shared<Column>(FieldInfo{name, ElementType::kUint32, 1, "", meaning}, count);
    const bool is_row = std::string_view(name) == "row";
    for (size_t i = 0; i < count; ++i)
      static_cast<uint32_t*>(column->raw())[i] =
          static_cast<uint32_t>(is_row ? i / header.width : i % header.width);
    if (cloud.fields.find(name) == nullptr) cloud.fields.set(std::move(column));
  }
  std::vector<uint64_t> kept;
  for (size_t i = 0; i < count; ++i)
    if (is_finite(cloud.point(i))) kept.push_back(i);
  return kept.size() == count ? cloud : select(cloud, kept, task);
}

}  // namespace

bool is_pcd(const ByteSource& source) {
  char start[16];
  const std::string_view look(start, source.read_some(0, start, sizeof start));
  return look.starts_with("# .PCD v") || look.starts_with("VERSION .7\n") ||
         look.starts_with("VERSION 0.7\n");
}

Cloud read_pcd(const ByteSource& source, const ReadSettings& settings, Task& task) {
  const Header header = read_header(source);
  Bytes whole;
  if (header.data == Data::kCompressed) whole = unpacked(source, header, task);
  PcdPoints points = Layout(source, header).run();
  {
    ProgressSpan span(task, 0, 0.9, "reading PCD");
    if (header.data == Data::kBinary) read_binary(source, header, points, task);
    else if (header.data == Data::kCompressed) read_compressed(header, points, whole, task);
    else AsciiReader(source, header, points).run(task);
  }
  Cloud cloud = make_cloud(std::move(points.xyz));
  for (auto& column : points.columns) cloud.fields.set(std::move(column));
  cloud.crs = header.crs;
  if (header.has_pose) {
    Station station;
    station.name = "viewpoint";
    station.has_pose = true;
    station.pose = header.pose;
    station.count = cloud.size();
    cloud.stations.push_back(station);
  }
  if (header.height > 1) cloud = without_empty_cells(std::move(cloud), header, task);
  return finish_cloud(std::move(cloud), source, settings.drop_invalid, task);
}

}  // namespace jalon
