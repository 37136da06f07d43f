// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "base/text_number.h"

namespace jalon {

/// Text made safe for XML and HTML content and attributes: & < > " ' become references, control
/// characters and broken UTF-8 become U+FFFD (XML 1.0 allows neither).
std::string xml_escaped(std::string_view text);

/// A number for drawings: at most this many decimals, without trailing zeros; "0" when it is not
/// finite.
std::string svg_number(double value, int decimals = 3);

/// Builds XML text element by element; everything that comes from outside is escaped, tags always
/// match.
///
///   SvgWriter svg;
///   svg.open("svg", {{"xmlns", "http://www.w3.org/2000/svg"}, {"width", 640}});
///   svg.leaf("circle", {{"cx", 3.5}, {"cy", 4}, {"r", 2}, {"fill", "#c33"}});
///   svg.element("text", {{"x", 1}, {"y", 2}}, hostile_name);
///   svg.close();
///   file.write(svg.take());
class SvgWriter {
 public:
  struct Attribute {
    Attribute(std::string_view n, std::string_view v) : name(n), value(v) {}
    Attribute(std::string_view n, const char* v) : name(n), value(v) {}
    Attribute(std::string_view n, const std::string& v) : name(n), value(v) {}
    Attribute(std::string_view n, double v) : name(n), value(svg_number(v)) {}
    template <std::integral T>
    Attribute(std::string_view n, T v) : name(n), value(std::to_string(v)) {}
    std::string_view name;
    std::string value;  ///< not yet escaped
  };
  using Attributes = std::initializer_list<Attribute>;

  /// <name ...>, to be closed by close().
  SvgWriter& open(std::string_view name, Attributes attributes = {});
  /// <name .../>
  SvgWriter& leaf(std::string_view name, Attributes attributes = {});
  /// <name ...>text</name>
  SvgWriter& element(std::string_view name, Attributes attributes, std::string_view text);
  SvgWriter& text(std::string_view text);   ///< escaped
  SvgWriter& raw(std::string_view markup);  ///< as it is: own markup only
  SvgWriter& close();

  size_t depth() const { return names_.size(); }
  /// The text, with every open element closed; the writer is empty afterwards.
  std::string take();

 private:
  void tag(std::string_view name, Attributes attributes);
  std::string out_;
  std::vector<std::string> names_;
};

}  // namespace jalon
