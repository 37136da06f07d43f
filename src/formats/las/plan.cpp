// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/las/plan.h"

#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/parallel.h"
#include "base/text_number.h"
#include "formats/files/endian.h"
#include "formats/las/copc.h"
#include "formats/las/stations.h"
#include "formats/units/epsg_wkt.h"

namespace jalon::las {

namespace {

constexpr size_t kPlanGrain = size_t{1} << 18;
constexpr double kDefaultScale_m = 0.0001;  // a tenth of what a scanner resolves
constexpr double kLargest = 2147483000;     // of int32, with room for rounding
constexpr double kExact = 1e-3;  // of a scale step: coordinates that came from such integers
constexpr uint64_t kMaxLegacyCount = 0xFFFFFFFFull;

struct Origin {
  std::vector<std::byte> header;
  std::vector<Record> vlrs, evlrs;
};

Origin origin_of(const Cloud& cloud) {
  Origin origin;
  if (!cloud.attachments) return origin;
  for (const Attachment& attachment : *cloud.attachments) {
    if (attachment.key == "las:header" && attachment.bytes.size() >= 227)
      origin.header = attachment.bytes;
    if (attachment.key == "las:vlr") origin.vlrs.push_back(record_of(attachment.bytes, kVlrHeader));
    if (attachment.key == "las:evlr")
      origin.evlrs.push_back(record_of(attachment.bytes, kEvlrHeader));
  }
  return origin;
}

// The CRS records of the file stay as they are while they still say the cloud's CRS.
bool says_crs_of(const Origin& origin, const Cloud& cloud) {
  return crs_text(origin.vlrs, origin.evlrs) == cloud.crs.str();
}

bool is_extended_header(const std::vector<std::byte>& header) {
  return !header.empty() && header[25] == std::byte{4} &&
         (static_cast<unsigned>(header[104]) & 0x3Fu) >= 6;
}

// All that a wave packet's place in a record holds.
bool has_wave_packets(const FieldTable& fields) {
  for (const char* name : kWaveNames)
    if (fields.find(name) == nullptr) return false;
  return true;
}

// The smallest format of a family that has a place for the fields there are.
unsigned format_in_family(const FieldTable& fields, bool extended, bool waves) {
  const bool rgb = fields.find("red") != nullptr || fields.find("green") != nullptr ||
                   fields.find("blue") != nullptr;
  const bool nir = fields.find("nir") != nullptr;
  if (extended && waves) return rgb || nir ? 10 : 9;
  if (extended) return nir ? 8 : rgb ? 7 : 6;
  if (waves) return rgb ? 5 : 4;
  return (fields.find("gps_time") != nullptr ? 1u : 0u) + (rgb ? 2u : 0u);
}

// Formats 6-10 hold values of standard fields that 0-5 cannot.
bool needs_extended(const FieldTable& fields, bool waves, Task& task) {
  std::vector<ColumnPtr> left_old, left_new;
  standard_columns(fields, format_in_family(fields, false, waves), left_old, task);
  standard_columns(fields, format_in_family(fields, true, waves), left_new, task);
  for (const ColumnPtr& column : left_old) {
    bool placed = true;
    for (const ColumnPtr& other : left_new) placed = placed && other != column;
    if (placed) return true;
  }
  return false;
}

void choose_version(Plan& plan, const Cloud& cloud, const Origin& origin, LasVersion wanted,
                    Profile profile, Task& task) {
  const bool waves =
      profile == Profile::kPlain && wanted != LasVersion::k12 && has_wave_packets(cloud.fields);
  bool extended = wanted == LasVersion::k14;
  if (wanted == LasVersion::kAuto)
    extended = is_extended_header(origin.header) || cloud.size() > kMaxLegacyCount ||
               (is_wkt(cloud.crs) && !says_crs_of(origin, cloud)) || !origin.evlrs.empty() ||
               needs_extended(cloud.fields, waves, task);
  plan.version_minor = extended ? 4 : waves ? 3 : 2;
  plan.format = format_in_family(cloud.fields, extended, waves);
  if (!extended && cloud.size() > kMaxLegacyCount)
    fail(Status::kLimit, "LAS 1.2 holds at most 2^32 - 1 points");
}

void choose_records(Plan& plan, const Cloud& cloud, const Origin& origin, Task& task) {
  const bool same_crs = says_crs_of(origin, cloud);
  const auto keep = [&](const Record& record) {
    return record.user != "laszip encoded" && !is_copc_record(record) &&
           !record.is(kSpecUser, kExtraBytes) && !is_station_record(record) &&
           (same_crs || !is_crs_record(record));
  };
  for (const Record& record : origin.vlrs)
    if (keep(record)) plan.vlrs.push_back(record);
  for (const Record& record : origin.evlrs) {
    if (!keep(record)) continue;
    if (plan.version_minor == 4) plan.evlrs.push_back(record);
    else
      task.log(Task::kWarning, "LAS 1.2 has no extended records: %s %u is left out",
               record.user.c_str(), record.id);
  }
  if (!same_crs)
    for (Record& record : crs_records(cloud.crs)) {
      const bool small = record.header_bytes == kVlrHeader;
      if (!small && plan.version_minor != 4)
        fail(Status::kLimit, "the CRS text is too long for LAS 1.2");
      (small ? plan.vlrs : plan.evlrs).push_back(std::move(record));
    }
}

// Beside the keys of GeoTIFF, which readers of COPC need not know. Units that only the keys tell are none of the text.
void add_wkt(Plan& plan, const Cloud& cloud, const std::string& path, Task& task) {
  const std::string crs = cloud.crs.str();
  if (crs.empty() || is_wkt(crs)) return;
  std::string wkt;
  if (units_of(plan.vlrs, plan.evlrs, path).metres()) wkt = wkt_of_epsg(epsg_code(crs));
  if (!wkt.empty())
    for (Record& record : crs_records(wkt)) plan.vlrs.push_back(std::move(record));
  else
    task.log(Task::kWarning,
             "%s: COPC names its CRS by WKT, which is not known of %.60s: it is in the file as LAS "
             "1.2 has it, where other programs may not look",
             path.c_str(), crs.c_str());
}

// One extra bytes VLR, at the place of the old one; the very old one when nothing changed.
void add_descriptors(Plan& plan, const Origin& origin) {
  std::vector<std::byte> data;
  for (const ExtraColumn& column : plan.extra)
    data.insert(data.end(), column.descriptor.begin(), column.descriptor.end());
  const Record* old = nullptr;
  size_t place = 0;
  for (const Record& record : origin.vlrs) {
    if (record.is(kSpecUser, kExtraBytes)) {
      old = &record;
      break;
    }
    for (const Record& kept : plan.vlrs) place += kept.bytes == record.bytes ? 1 : 0;
  }
  if (data.empty()) return;
  if (data.size() > 0xFFFF)
    fail(Status::kLimit, "a LAS file describes at most %zu extra fields",
         0xFFFF / kDescriptorBytes);
  const bool unchanged = old != nullptr && old->size() == data.size() &&
                         std::equal(data.begin(), data.end(), old->data());
  Record record = unchanged ? *old
                            : make_record(kSpecUser, kExtraBytes, "Extra Bytes Record", data.data(),
                                          data.size());
  place = old != nullptr ? std::min(place, plan.vlrs.size()) : plan.vlrs.size();
  plan.vlrs.insert(plan.vlrs.begin() + static_cast<ptrdiff_t>(place), std::move(record));
}

Box3 in_file(Box3 box, const LengthUnits& units) {
  for (Vec3* corner : {&box.min, &box.max})
    *corner = {corner->x / units.horizontal, corner->y / units.horizontal,
               corner->z / units.vertical};
  return box;
}

// True when the integers of the file that the cloud came from give all coordinates back.
bool old_steps_fit(const Cloud& cloud, const Plan& plan, const Vec3& scale, const Vec3& offset,
                   Task& task) {
  const std::span<const double> xyz = cloud.xyz();
  const Vec3 unit{plan.units.horizontal, plan.units.horizontal, plan.units.vertical};
  return parallel_reduce<uint64_t>(
             task, cloud.size(), kPlanGrain, 0, [&](size_t begin, size_t end) {
               uint64_t bad = 0;
               for (size_t i = begin; i < end; ++i)
                 for (int k = 0; k < 3; ++k) {
                   const double steps =
                       (xyz[3 * i + static_cast<size_t>(k)] / unit[k] - offset[k]) / scale[k];
                   bad += std::fabs(steps) <= kLargest &&
                                  std::fabs(steps - std::nearbyint(steps)) <= kExact
                              ? 0
                              : 1;
                 }
               return bad;
             }) == 0;
}

void choose_steps(Plan& plan, const Cloud& cloud, const std::string& path, double wanted,
                  const std::optional<Box3>& of_all, Task& task) {
  if (!plan.old_header.empty() && wanted == 0) {
    for (int k = 0; k < 3; ++k) {
      plan.scale[k] = load<double>(plan.old_header.data() + 131 + 8 * k);
      plan.offset[k] = load<double>(plan.old_header.data() + 155 + 8 * k);
    }
    if (old_steps_fit(cloud, plan, plan.scale, plan.offset, task)) return;
  }
  plan.has_steps_of_bounds = true;
  const Box3 box = of_all              ? in_file(*of_all, plan.units)
                   : cloud.size() != 0 ? in_file(bounds(cloud, task), plan.units)
                                       : Box3{{0, 0, 0}, {0, 0, 0}};
  for (int k = 0; k < 3; ++k) {
    const double metres = k == 2 ? plan.units.vertical : plan.units.horizontal;
    plan.scale[k] = wanted != 0 ? wanted / metres : kDefaultScale_m;
    plan.offset[k] = std::floor(box.min[k] / 2 + box.max[k] / 2);
    const double reach = std::max(box.max[k] - plan.offset[k], plan.offset[k] - box.min[k]);
    while (wanted == 0 && reach / plan.scale[k] > kLargest && std::isfinite(plan.scale[k]))
      plan.scale[k] *= 10;
    if (!(reach / plan.scale[k] <= kLargest) || !std::isfinite(plan.scale[k]))
      fail(Status::kLimit, "%s: coordinates from %s to %s do not fit 32 bits with a scale of %s",
           path.c_str(), text_of(box.min[k]).c_str(), text_of(box.max[k]).c_str(),
           text_of(plan.scale[k]).c_str());
  }
}

}  // namespace

Plan make_plan(const Cloud& cloud, const std::string& path, const WriteSettings& settings,
               Task& task, Profile profile, const std::optional<Box3>& bounds) {
  Plan plan;
  Origin origin = origin_of(cloud);
  const bool same_crs = says_crs_of(origin, cloud);
  choose_version(plan, cloud, origin, settings.las_version, profile, task);
  choose_records(plan, cloud, origin, task);
  if (profile == Profile::kCopc) add_wkt(plan, cloud, path, task);

  std::vector<ColumnPtr> left;
  plan.standard = standard_columns(cloud.fields, plan.format, left, task);
  const ColumnPtr station = station_column(cloud, task);
  if (station != nullptr) left.push_back(station);
  const size_t core = point_format(plan.format)->bytes;
  const auto known =
      extra_dimensions(origin.vlrs, origin.evlrs, std::numeric_limits<uint16_t>::max(), task);
  plan.extra = extra_columns(left, known, plan.format, task);
  plan.record_bytes = core;
  for (const ExtraColumn& column : plan.extra)
    plan.record_bytes += size_of(column.raw_type) * column.components;
  add_descriptors(plan, origin);

  plan.old_header = std::move(origin.header);
  plan.units = units_of(plan.vlrs, plan.evlrs, path);
  if (plan.units.degrees && !same_crs)
    fail(Status::kUnsupported, "%s: coordinates in metres cannot be written under a CRS in degrees",
         path.c_str());
  if (station != nullptr)
    for (Record& record :
         station_records(cloud, station->info().name,
                         {plan.units.horizontal, plan.units.horizontal, plan.units.vertical}))
      plan.vlrs.push_back(std::move(record));
  choose_steps(plan, cloud, path, settings.scale, bounds, task);
  return plan;
}

Plan plan_of_steps(const Cloud& cloud, const std::string& path, double scale_m, Task& task) {
  Plan plan;
  plan.old_header = origin_of(cloud).header;
  choose_steps(plan, cloud, path, scale_m, std::nullopt, task);
  return plan;
}

}  // namespace jalon::las
