// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <cstring>

#include "malformed_files.h"

namespace malformed {

namespace {

constexpr size_t kBombBytes = size_t{2} << 20, kMostBytes = size_t{16} << 20;
constexpr const char* kRootFile = "ept-hierarchy/0-0-0-0.json";

// Of three points, as the definition (entwine.io/entwine-point-tile.html) has it.
constexpr const char* kIndex =
    "{\"bounds\":[0,0,0,8,8,8],\"boundsConforming\":[0,0,0,1,1,1],\"dataType\":\"binary\","
    "\"hierarchyType\":\"json\",\"points\":3,\"schema\":["
    "{\"name\":\"X\",\"type\":\"signed\",\"size\":4,\"scale\":0.01,\"offset\":5},"
    "{\"name\":\"Y\",\"type\":\"signed\",\"size\":4},{\"name\":\"Z\",\"type\":\"float\",\"size\":4}"
    ","
    "{\"name\":\"Intensity\",\"type\":\"unsigned\",\"size\":2}],\"span\":128,"
    "\"srs\":{\"authority\":\"EPSG\",\"horizontal\":\"2154\"},\"version\":\"1.0.0\"}";
constexpr size_t kRecord = 14;

std::string records(size_t points) { return std::string(points * kRecord, '\1'); }

std::string repeated(const std::string& head, const std::string& unit, size_t bytes) {
  std::string out = head;
  while (out.size() + unit.size() <= bytes) out += unit;
  return out;
}

std::string with(const char* from, const std::string& to) {
  std::string out = kIndex;
  return out.replace(out.find(from), std::strlen(from), to);
}

class Sets {
 public:
  void index(const std::string& text) {
    sets_.push_back({"ept.json", text, "", {{kRootFile, "{\"0-0-0-0\":3}"}, data(3)}});
  }
  void hierarchy(const std::string& root, const std::string& below = "") {
    File set{"ept.json", kIndex, "", {{kRootFile, root}, data(3)}};
    if (!below.empty()) set.parts.push_back({"ept-hierarchy/1-0-0-0.json", below});
    sets_.push_back(set);
  }
  void parts(const std::vector<Part>& all) { sets_.push_back({"ept.json", kIndex, "", all}); }
  static Part data(size_t points) { return {"ept-data/0-0-0-0.bin", records(points)}; }
  std::vector<File> take() { return std::move(sets_); }

 private:
  std::vector<File> sets_;
};

void add_cut(Sets& sets) {
  const std::string index = kIndex, root = "{\"0-0-0-0\":3,\"1-0-0-0\":0}";
  for (size_t end = 0; end < index.size(); end += 3) sets.index(index.substr(0, end));
  for (size_t end = 0; end < root.size(); ++end) sets.hierarchy(root.substr(0, end));
}

// Each value of the index, and each number of the hierarchy, is another.
void add_values(Sets& sets) {
  const char* const values[] = {"0",       "-1",     "1e308", "-1e308", "18446744073709551615",
                                "1e999",   "NaN",    "null",  "\"\"",   "[]",
                                "{}",      "1e-320", "3.5",   "true",   "\"\\n\"",
                                "\"../a\""};
  const char* const places[] = {"[0,0,0,8,8,8]",
                                "8,8,8]",
                                "\"binary\"",
                                "\"json\"",
                                "[{\"name\":\"X\"",
                                "\"X\"",
                                "\"signed\"",
                                "4,\"scale\"",
                                "0.01",
                                "5}",
                                "2}",
                                "128",
                                "\"EPSG\"",
                                "\"2154\"",
                                "{\"authority\":\"EPSG\",\"horizontal\":\"2154\"}"};
  for (const char* const place : places)
    for (const std::string value : values) {
      const std::string at = place;
      const std::string closing = at == "8,8,8]"                       ? ",8,8]"
                                  : at == "4,\"scale\""                ? ",\"scale\""
                                  : at == "[{\"name\":\"X\""           ? ",{\"name\":\"X\""
                                  : at.back() == '}' && at.size() == 2 ? "}"
                                                                       : "";
      sets.index(
          with(place, at[0] == '[' && at[1] == '{' ? "[" + value + closing : value + closing));
    }
  for (const std::string value : values) {
    sets.hierarchy("{\"0-0-0-0\":" + value + "}");
    sets.hierarchy("{\"0-0-0-0\":3,\"1-0-0-0\":" + value + "}");
  }
}

// Names that are no nodes, and those that would lead out of the folder.
void add_names(Sets& sets) {
  for (const char* const name :
       {"..",          "../0-0-0-0",        "../../etc/passwd",
        "/etc/passwd", "1-0-0-0/../../ept", "0-0-0-0\\u0000",
        "00-0-0-0",    "-0-0-0-0",          "1-0-0-00",
        "1-0-0-+0",    "1-2-0-0",           "1--1-0-0",
        "32-0-0-0",    "2147483648-0-0-0",  "99999999999999999999-0-0-0",
        "1-0-0",       "1-0-0-0-0",         "",
        "a\\nb",       "\\ud83d\\ude00",    "31-2147483647-2147483647-2147483647",
        "1-0-0-0 ",    " 1-0-0-0",          "CON",
        "..\\\\a"})
    for (const char* const count : {"-1", "0", "1", "3"})
      sets.hierarchy("{\"0-0-0-0\":3,\"" + std::string(name) + "\":" + count + "}");
  for (const char* const dimension : {"..", "", "a\\nb", "X", "NormalX", "\\u0000"})
    sets.index(with("\"Intensity\"", "\"" + std::string(dimension) + "\""));
}

// Files of the hierarchy that name themselves or each other, nodes that stand twice or nowhere, counts that lie.
void add_loops(Sets& sets) {
  sets.hierarchy("{\"0-0-0-0\":-1}");
  sets.hierarchy("{\"0-0-0-0\":3,\"1-0-0-0\":-1}");  // no such file
  sets.hierarchy("{\"0-0-0-0\":3,\"1-0-0-0\":-1}", "{\"0-0-0-0\":-1}");
  sets.hierarchy("{\"0-0-0-0\":3,\"1-0-0-0\":-1}", "{\"1-0-0-0\":-1}");
  sets.hierarchy("{\"0-0-0-0\":3,\"1-0-0-0\":-1}", "{\"0-0-0-0\":3}");
  sets.hierarchy("{\"0-0-0-0\":3,\"1-0-0-0\":-1,\"1-0-0-0\":-1}", "{\"1-0-0-0\":0}");
  sets.hierarchy("{\"0-0-0-0\":3,\"0-0-0-0\":3}");
  for (const char* const count : {"2", "4", "1000000", "4294967296", "9223372036854775807"})
    sets.hierarchy(std::string("{\"0-0-0-0\":") + count + "}");
  sets.parts({});
  sets.parts({Sets::data(3)});
  sets.parts({{kRootFile, "{\"0-0-0-0\":3}"}});
  for (size_t bytes = 0; bytes < 3 * kRecord; bytes += 5)
    sets.parts({{kRootFile, "{\"0-0-0-0\":3}"}, {"ept-data/0-0-0-0.bin", std::string(bytes, 1)}});
  sets.parts({{"ept-hierarchy/0-0-0-0.json/a", ""}, Sets::data(3)});  // a folder in its place
  sets.parts({{kRootFile, "{\"0-0-0-0\":3}"}, {"ept-data/0-0-0-0.bin/a", ""}});
}

// Texts of many values, of one, and of brackets: what is not needed must not be held.
void add_bombs(Sets& sets) {
  for (const char* const unit : {"0,", "[", "{\"a\":", "\"\",", "{},", "9"}) {
    for (const char* const member :
         {"{\"a\":[", "{\"schema\":[", "{\"bounds\":[", "{\"srs\":", "{\"jalon\":["})
      sets.index(repeated(member, unit, kBombBytes));
    sets.hierarchy(repeated("{\"0-0-0-0\":", unit, kBombBytes));
    sets.hierarchy(repeated("", unit, kBombBytes));
  }
  sets.index(repeated("{\"a\":[", "0,", kMostBytes));
  sets.index(repeated("", " ", kMostBytes + 1));
  std::string schema = "[";
  while (schema.size() < kBombBytes) schema += "{\"name\":\"a\",\"type\":\"float\",\"size\":8},";
  sets.index(with("[{\"name\":\"X\"", schema + "{\"name\":\"X\""));
  std::string nodes = "{\"0-0-0-0\":3";
  for (int i = 0; nodes.size() < kMostBytes - 32; ++i)
    nodes += ",\"30-" + std::to_string(i) + "-0-0\":0";
  sets.hierarchy(nodes + "}");
}

}  // namespace

std::vector<File> ept_sets() {
  Sets sets;
  sets.index(
      kIndex);  // is read: so what refuses the others is not the way in which they are written
  add_cut(sets);
  add_values(sets);
  add_names(sets);
  add_loops(sets);
  add_bombs(sets);
  return sets.take();
}

}  // namespace malformed
