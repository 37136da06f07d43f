// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/files/utf8.h"

#include "base/utf8_character.h"

namespace jalon {

namespace {

constexpr size_t kNameBytes = 256;

bool continues(std::string_view text, size_t i) {
  return (static_cast<unsigned char>(text[i]) & 0xC0) == 0x80;
}

}  // namespace

std::string valid_utf8(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    const size_t length = text.front() == 0 ? 0 : utf8_character_bytes(text);
    if (length == 0) {
      out += kReplacementCharacter;
      text.remove_prefix(1);
    } else {
      out += text.substr(0, length);
      text.remove_prefix(length);
    }
  }
  return out;
}

std::string_view utf8_prefix(std::string_view text, size_t bytes) {
  if (text.size() <= bytes) return text;
  while (bytes > 0 && continues(text, bytes)) --bytes;
  return text.substr(0, bytes);
}

std::string text_field(const void* data, size_t bytes) {
  std::string_view text(static_cast<const char*>(data), bytes);
  text = text.substr(0, text.find('\0'));
  const size_t end = text.find_last_not_of(" \t\r\n");
  text = text.substr(0, end == std::string_view::npos ? 0 : end + 1);
  std::string out = valid_utf8(text);
  for (char& c : out)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  return out;
}

std::string name_from_file(std::string_view text, std::string_view fallback) {
  std::string name = text_field(text.data(), text.size());
  name.erase(0, name.find_first_not_of(' '));
  name = utf8_prefix(name, kNameBytes);
  return name.empty() ? std::string(fallback) : name;
}

std::string numbered(std::string_view name, size_t number) {
  std::string out(name);
  out.append("_").append(std::to_string(number));
  return out;
}

std::string UniqueNames::add(const std::string& name) {
  const auto [entry, added] = next_.try_emplace(name, 2);
  if (added) return name;
  for (;;) {
    std::string other = numbered(name, entry->second++);
    if (next_.try_emplace(other, 2).second) return other;
  }
}

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return out;
}

}  // namespace jalon
