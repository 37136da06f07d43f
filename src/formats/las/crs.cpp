// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstring>

#include "base/error.h"
#include "base/text_number.h"
#include "formats/files/endian.h"
#include "formats/files/utf8.h"
#include "formats/las/layout.h"
#include "formats/units/epsg_wkt.h"

namespace jalon::las {

namespace {

constexpr const char* kProjectionUser = "LASF_Projection";
constexpr const char* kOwnUser = "jalon";
constexpr uint16_t kOwnCrsRecord = 1;  // a CRS text that is neither WKT nor an EPSG code
constexpr uint16_t kWkt = 2112, kGeoKeys = 34735, kGeoDoubles = 34736;
constexpr uint16_t kUserDefined = 32767;

// Keys of the GeoTIFF specification 1.8.2.
enum GeoKey : uint16_t {
  kModelType = 1024,
  kGeographicType = 2048,
  kProjectedType = 3072,
  kLinearUnits = 3076,
  kLinearUnitSize = 3077,
  kVerticalType = 4096,
  kVerticalUnits = 4099,
};
enum ModelType : uint16_t { kProjectedModel = 1, kGeographicModel = 2 };

const Record* find(const std::vector<Record>& vlrs, const std::vector<Record>& evlrs,
                   const char* user, unsigned id) {
  for (const auto* list : {&vlrs, &evlrs})
    for (const Record& record : *list)
      if (record.is(user, id)) return &record;
  return nullptr;
}

// The directory of GeoTIFF keys: a header of four 16-bit numbers, then (key, location, count,
// value) each.
class GeoKeys {
 public:
  GeoKeys(const Record* directory, const Record* doubles)
      : directory_(directory), doubles_(doubles) {}
  bool present() const { return directory_ != nullptr && directory_->size() >= 8; }
  /// 0 when the key is not there or its value is no short number.
  uint16_t code(uint16_t key) const {
    const std::byte* entry = find_entry(key);
    return entry != nullptr && load<uint16_t>(entry + 2) == 0 ? load<uint16_t>(entry + 6)
                                                              : uint16_t{0};
  }
  double number(uint16_t key) const {
    const std::byte* entry = find_entry(key);
    if (entry == nullptr || load<uint16_t>(entry + 2) != kGeoDoubles || doubles_ == nullptr)
      return 0;
    const size_t i = load<uint16_t>(entry + 6);
    return (i + 1) * 8 <= doubles_->size() ? load<double>(doubles_->data() + 8 * i) : 0;
  }

 private:
  const std::byte* find_entry(uint16_t key) const {
    if (!present()) return nullptr;
    for (size_t at = 8; at + 8 <= directory_->size(); at += 8)
      if (load<uint16_t>(directory_->data() + at) == key) return directory_->data() + at;
    return nullptr;
  }
  const Record* directory_;
  const Record* doubles_;
};

GeoKeys geo_keys(const std::vector<Record>& vlrs, const std::vector<Record>& evlrs) {
  return {find(vlrs, evlrs, kProjectionUser, kGeoKeys),
          find(vlrs, evlrs, kProjectionUser, kGeoDoubles)};
}

// Metres a unit of an EPSG unit code; 0 when it is not a known one.
double metres_of_unit(uint16_t code) {
  switch (code) {
    case 9001:
      return 1;
    case 9002:
      return kFoot;
    case 9003:
      return kUsFoot;
    case 9005:
      return 0.3047972654;  // Clarke's foot
    case 9036:
      return 1000;
    case 9096:
      return 0.9144;
    default:
      return 0;
  }
}

LengthUnits units_of_keys(const GeoKeys& keys, const std::string& path) {
  LengthUnits units;
  if (!keys.present()) return units;
  units.degrees = keys.code(kModelType) == kGeographicModel;
  const auto look_up = [&](uint16_t unit, double size, uint16_t system, double& out) {
    if (unit == kUserDefined && size > 0 && std::isfinite(size)) {
      out = size;
    } else if (unit != 0) {
      out = metres_of_unit(unit);
      if (out == 0)
        fail(Status::kUnsupported,
             "%s: the CRS has length unit %u, which Jalon does not know; give the unit of the file",
             path.c_str(), unit);
    } else if (system != 0 && system != kUserDefined) {
      out = unit_of_epsg(system);
    } else {
      return false;
    }
    return true;
  };
  units.known = look_up(keys.code(kLinearUnits), keys.number(kLinearUnitSize),
                        keys.code(kProjectedType), units.horizontal);
  if (!look_up(keys.code(kVerticalUnits), 0, keys.code(kVerticalType), units.vertical))
    units.vertical = units.horizontal;
  return units;
}

bool same_unit(double a, double b) {
  return std::fabs(a - b) <= 1e-9 * std::fabs(a);
}  // texts round the survey foot

}  // namespace

bool is_wkt(const std::string& crs) { return crs.find('[') != std::string::npos; }

bool is_crs_record(const Record& record) {
  return (record.user == kProjectionUser && (record.id == 2111 || record.id == kWkt ||
                                             (record.id >= kGeoKeys && record.id <= 34737))) ||
         record.is(kOwnUser, kOwnCrsRecord);
}

std::string crs_text(const std::vector<Record>& vlrs, const std::vector<Record>& evlrs) {
  if (const Record* own = find(vlrs, evlrs, kOwnUser, kOwnCrsRecord))
    return valid_utf8({reinterpret_cast<const char*>(own->data()), own->size()});
  std::string of_keys;
  const GeoKeys keys = geo_keys(vlrs, evlrs);
  for (const uint16_t key : {uint16_t{kProjectedType}, uint16_t{kGeographicType}}) {
    const uint16_t code = keys.code(key);
    if (code == 0 || code == kUserDefined) continue;
    of_keys = "EPSG:" + std::to_string(code);
    break;
  }
  if (const Record* wkt = find(vlrs, evlrs, kProjectionUser, kWkt)) {
    std::string text = wkt->text();
    // The text that was written beside the keys of a code says no more than the code.
    const bool says_code = !of_keys.empty() && text == wkt_of_epsg(epsg_code(of_keys));
    if (!text.empty() && !says_code) return text;
  }
  return of_keys;
}

LengthUnits units_of(const std::vector<Record>& vlrs, const std::vector<Record>& evlrs,
                     const std::string& path) {
  const Record* wkt = find(vlrs, evlrs, kProjectionUser, kWkt);
  const Record* own = find(vlrs, evlrs, kOwnUser, kOwnCrsRecord);
  LengthUnits of_text = units_of_crs(wkt != nullptr   ? wkt->text()
                                     : own != nullptr ? own->text()
                                                      : "");
  const LengthUnits of_keys = units_of_keys(geo_keys(vlrs, evlrs), path);
  if (of_text.known && of_keys.known && !same_unit(of_text.horizontal, of_keys.horizontal))
    fail(Status::kUnsupported,
         "%s: the two CRS records contradict each other: %s and %s m a unit; give the unit of the "
         "file",
         path.c_str(), text_of(of_text.horizontal).c_str(), text_of(of_keys.horizontal).c_str());
  LengthUnits units = of_text.known ? of_text : of_keys;
  units.degrees = of_text.degrees || of_keys.degrees;
  return units;
}

std::vector<Record> crs_records(const std::string& crs) {
  if (crs.empty()) return {};
  if (is_wkt(crs))
    return {make_record(kProjectionUser, kWkt, "OGC coordinate system WKT", crs.c_str(),
                        crs.size() + 1)};
  const uint32_t code = epsg_code(crs);
  if (code == 0 || code >= kUserDefined || crs != "EPSG:" + std::to_string(code))
    return {make_record(kOwnUser, kOwnCrsRecord, "coordinate reference system", crs.data(),
                        crs.size())};
  const bool geographic = units_of_crs(crs).degrees;
  const uint16_t words[] = {1,
                            1,
                            0,
                            2,
                            kModelType,
                            0,
                            1,
                            geographic ? kGeographicModel : kProjectedModel,
                            geographic ? kGeographicType : kProjectedType,
                            0,
                            1,
                            static_cast<uint16_t>(code)};
  std::byte bytes[sizeof words];
  for (size_t i = 0; i < std::size(words); ++i) store<uint16_t>(bytes + 2 * i, words[i]);
  return {
      make_record(kProjectionUser, kGeoKeys, "GeoTIFF GeoKeyDirectoryTag", bytes, sizeof bytes)};
}

}  // namespace jalon::las
