// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "formats/drawings/svg_writer.h"

namespace jalon {

/// A page of HTML under construction.
class Page {
 public:
  void heading(std::string_view text) { svg_.element("h2", {}, text); }
  void note(std::string_view text) { svg_.element("p", {{"class", "note"}}, text); }
  // Text from outside stands in <bdi>, so that marks for writing direction stay inside.
  void foreign(const char* tag, std::string_view text) {
    svg_.open(tag).element("bdi", {}, text).close();
  }
  /// Opens a table with this heading, in a field that scrolls where it is wide; close_table() closes it.
  void open_table(const std::vector<const char*>& names) {
    svg_.open("div", {{"class", "scroll"}}).open("table").open("thead").open("tr");
    for (const char* name : names) svg_.element("th", {}, name);
    svg_.close().close().open("tbody");
  }
  void close_table() { svg_.close().close().close(); }
  void number(std::string_view text) { svg_.element("td", {{"class", "n"}}, text); }
  SvgWriter& html() { return svg_; }

 private:
  SvgWriter svg_;
};

}  // namespace jalon
