// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/ifc/step_file.h"

#include <array>
#include <cmath>
#include <cstdint>

#include "base/text_number.h"
#include "base/utf8_character.h"
#include "formats/files/utf8.h"

namespace jalon::ifc {

namespace {

void append_hexadecimal(std::string& out, uint32_t code, int digits) {
  for (int shift = 4 * (digits - 1); shift >= 0; shift -= 4)
    out += "0123456789ABCDEF"[code >> shift & 15];
}

// FNV-1a with 64 bits (Fowler, Noll & Vo 1991), begun with a number of the caller's.
uint64_t hash_of(std::string_view text, uint64_t basis) {
  for (const char c : text) basis = (basis ^ static_cast<uint8_t>(c)) * 0x100000001B3ull;
  // FNV leaves the last bytes in the low bits; splitmix64's finaliser spreads them.
  basis = (basis ^ (basis >> 30)) * 0xBF58476D1CE4E5B9ull;
  basis = (basis ^ (basis >> 27)) * 0x94D049BB133111EBull;
  return basis ^ (basis >> 31);
}

}  // namespace

Values& Values::raw(std::string_view text) {
  if (!text_.empty()) text_ += ',';
  text_ += text;
  return *this;
}

Values& Values::ids(std::span<const Id> entities) {
  Values all;
  for (const Id entity : entities) all.id(entity);
  return list(all);
}

Values& Values::word(std::string_view enumeration) {
  return raw("." + std::string(enumeration) + ".");
}

Values& Values::text(std::string_view utf8) { return raw(string_text(utf8)); }

Values& Values::real(double value) { return std::isfinite(value) ? raw(real_text(value)) : none(); }

std::string real_text(double value) {
  std::string text = text_of(value == 0 ? 0 : value);  // no "-0"
  const size_t exponent = text.find('e');
  const std::string_view mantissa = std::string_view(text).substr(0, exponent);
  std::string out(mantissa);
  if (mantissa.find('.') == std::string_view::npos) out += '.';
  if (exponent != std::string::npos) out += 'E' + text.substr(exponent + 1);
  return out;
}

std::string string_text(std::string_view given) {
  const std::string text = valid_utf8(given);
  std::string out = "'";
  for (size_t at = 0; at < text.size();) {
    const size_t bytes = utf8_character_bytes(std::string_view(text).substr(at));
    const uint32_t code = utf8_code(std::string_view(text).substr(at, bytes));
    at += bytes;
    if (code == '\'' || code == '\\') out.append(2, static_cast<char>(code));
    else if (code >= 0x20 && code < 0x7F) out += static_cast<char>(code);
    else {
      const bool is_long = code > 0xFFFF;
      out += is_long ? "\\X4\\" : "\\X2\\";
      append_hexadecimal(out, code, is_long ? 8 : 4);
      out += "\\X0\\";
    }
  }
  return out + "'";
}

StepFile::StepFile(AtomicFile& file, std::string_view view, std::string_view name) : file_(file) {
  file_.write("ISO-10303-21;\nHEADER;\n");
  file_.write("FILE_DESCRIPTION((" + string_text("ViewDefinition [" + std::string(view) + "]") +
              "),'2;1');\n");
  // The time stamp is that of a day before computers: equal models give equal files.
  file_.write("FILE_NAME(" + string_text(name) +
              ",'1970-01-01T00:00:00',(''),(''),'Jalon','Jalon','');\n");
  file_.write("FILE_SCHEMA(('IFC4'));\nENDSEC;\nDATA;\n");
}

Id StepFile::add(std::string_view entity, const Values& values) {
  file_.write("#" + std::to_string(++last_) + "=");
  file_.write(entity);
  file_.write("(" + values.str() + ");\n");
  return last_;
}

void StepFile::end() { file_.write("ENDSEC;\nEND-ISO-10303-21;\n"); }

std::string guid_of(std::string_view name) {
  constexpr char kDigits[] = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_$";
  constexpr uint64_t kOffsetBasis = 0xCBF29CE484222325ull;  // FNV-1a's own
  constexpr uint64_t kOther = 0x9E3779B97F4A7C15ull;        // of the golden ratio
  const uint64_t high = hash_of(name, kOffsetBasis), low = hash_of(name, kOther);
  std::string out(22, '0');
  // 128 bits, six a character from the right, so that two are left for the first.
  for (int k = 0; k < 22; ++k) {
    const int at = 6 * k;
    const uint64_t bits =
        at < 64 ? low >> at | (at > 58 ? high << (64 - at) : 0) : high >> (at - 64);
    out[static_cast<size_t>(21 - k)] = kDigits[bits & 63];
  }
  return out;
}

}  // namespace jalon::ifc
