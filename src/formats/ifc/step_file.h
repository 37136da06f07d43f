// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "formats/files/atomic_file.h"
#include "geometry/vec.h"

// The exchange structure of STEP (ISO 10303-21:2016): numbered entities with lists of values.
namespace jalon::ifc {

/// Number of an entity in its file, from 1; 0 = none, written as "$".
using Id = size_t;

/// The values of an entity, or of a list within it, in their order.
class Values {
 public:
  Values& none() { return raw("$"); }
  Values& derived() { return raw("*"); }
  Values& id(Id entity) { return entity == 0 ? none() : raw("#" + std::to_string(entity)); }
  Values& ids(std::span<const Id> entities);
  Values& word(std::string_view enumeration);  ///< ELEMENT -> .ELEMENT.
  Values& flag(bool value) { return word(value ? "T" : "F"); }
  Values& text(std::string_view utf8);
  Values& real(double value);  ///< "$" where it is not finite
  Values& integer(size_t value) { return raw(std::to_string(value)); }
  Values& list(const Values& values) { return raw("(" + values.text_ + ")"); }
  Values& point(const Vec3& p) { return list(Values().real(p.x).real(p.y).real(p.z)); }
  /// A value with its type said: IFCLABEL('measured').
  Values& typed(std::string_view type, const Values& value) {
    return raw(std::string(type) + "(" + value.text_ + ")");
  }
  bool empty() const { return text_.empty(); }
  const std::string& str() const { return text_; }

 private:
  Values& raw(std::string_view text);
  std::string text_;
};

/// A number as STEP wants it: "1.", "2.5E-7"; shortest that reads back the same.
std::string real_text(double value);
/// Quotes doubled, backslashes too; what is not printable ASCII as \X2\00E9\X0\, beyond the first 65 536 as \X4\.
std::string string_text(std::string_view utf8);

/// Entities one after another, behind the header of an IFC4 file.
class StepFile {
 public:
  StepFile(AtomicFile& file, std::string_view view, std::string_view name);
  Id add(std::string_view entity, const Values& values);
  void end();

 private:
  AtomicFile& file_;
  Id last_ = 0;
};

/// The 22 characters of an IfcGloballyUniqueId, hashed from a name that no other object of the file has.
std::string guid_of(std::string_view name);

}  // namespace jalon::ifc
