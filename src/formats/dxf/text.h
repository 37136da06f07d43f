// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "formats/settings.h"
#include "geometry/vec.h"

namespace jalon::dxf {

using Version = DxfVersion;

/// Builds the groups (code, value) of a DXF file (Autodesk, "DXF Reference", AutoCAD 2000; release 12 for AC1009).
/// Numbers are the shortest text that reads back the same; texts are made safe for the version.
class Text {
 public:
  explicit Text(Version version) : version_(version) {}

  Text& group(int code, std::string_view text);
  Text& group(int code, const char* text) { return group(code, std::string_view(text)); }
  Text& group(int code, int value);
  /// Error(kUnsupported) when it is not finite: DXF has no such number.
  Text& group(int code, double value);
  Text& handle(int code, uint64_t handle);
  /// code, code + 10, code + 20.
  Text& point(int code, const Vec3& p);
  /// "  0" and the name, then from R2000 on its handle (group 5, or handle_code) and its owner (330).
  Text& begin(std::string_view name, uint64_t own, uint64_t owner, int handle_code = 5);
  /// A subclass marker (100); nothing in R12.
  Text& subclass(std::string_view name);

  bool is_r12() const { return version_ == Version::kR12; }
  Version version() const { return version_; }
  size_t size() const { return out_.size(); }
  std::string take() { return std::exchange(out_, {}); }

 private:
  Text& code(int code);
  Version version_;
  std::string out_;
};

/// Handles: fixed ones of the skeleton below, then one after the other.
enum Handle : uint64_t {
  kBlockRecordTable = 0x1,
  kLayerTable = 0x2,
  kStyleTable = 0x3,
  kLinetypeTable = 0x5,
  kViewTable = 0x6,
  kUcsTable = 0x7,
  kViewportTable = 0x8,
  kAppIdTable = 0x9,
  kDimStyleTable = 0xA,
  kRootDictionary = 0xC,
  kGroupDictionary = 0xD,
  kPlotStyleDictionary = 0xE,
  kPlotStyleNormal = 0xF,
  kLineStyleDictionary = 0x17,
  kLineStyleStandard = 0x18,
  kLayoutDictionary = 0x1A,
  kImageDictionary = 0x1B,
  kModelSpace = 0x1F,
  kModelBlock = 0x20,
  kModelBlockEnd = 0x21,
  kModelLayout = 0x22,
  kPaperSpace = 0x23,
  kPaperBlock = 0x24,
  kPaperBlockEnd = 0x25,
  kPaperLayout = 0x26,
  kViewportActive = 0x27,
  kLinetypeByBlock = 0x28,
  kLinetypeByLayer = 0x29,
  kLinetypeContinuous = 0x2A,
  kLinetypeDashed = 0x2B,
  kStyleStandard = 0x2C,
  kAppIdAcad = 0x2D,
  kAppIdJalon = 0x2E,
  kDimStyleStandard = 0x2F,
  kFirstFree = 0x30,
};

}  // namespace jalon::dxf
