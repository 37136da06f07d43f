// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <cstring>
#include <limits>

#include "malformed_edits.h"
#include "malformed_files.h"

namespace malformed {

namespace {

template <class T>
void append(std::string& out, T value) {
  char bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);  // little-endian machines only
  out.append(bytes, sizeof bytes);
}

// Every start of the text, and each of its bytes as something else.
void add_cuts_and_flips(std::vector<File>& out, const std::string& seed,
                        const std::string& extension, size_t step) {
  for (size_t end = 0; end < seed.size(); end += step)
    out.push_back({"cut." + extension, seed.substr(0, end)});
  for (size_t at = 0; at < seed.size(); at += step)
    for (const char bad : {'\0', '\xff', '9', '-', '"', ']'}) {
      std::string bytes = seed;
      bytes[at] = bad;
      out.push_back({"flip." + extension, bytes});
    }
}

std::string binary_stl(const std::string& head, uint32_t stated, size_t triangles,
                       float value = 1) {
  std::string out = head;
  out.resize(80, ' ');
  append(out, stated);
  for (size_t t = 0; t < triangles; ++t) {
    for (int i = 0; i < 12; ++i) append(out, i == 7 ? value : static_cast<float>(i * (t + 1)));
    append<uint16_t>(out, 0);
  }
  return out;
}

// What other programs write, small: two objects, a solid and surfaces with semantics, and our own attributes.
const char* const kCity =
    R"({"type":"CityJSON","version":"2.0","transform":{"scale":[0.001,0.001,0.001],"translate":[0,0,5]},
"metadata":{"referenceSystem":"https://www.opengis.net/def/crs/EPSG/0/2154"},
"CityObjects":{"a":{"type":"Building",
"attributes":{"part":0,"name":"x","class":"building","groups":[{"part":1,"part_of":0}]},
"geometry":[{"type":"Solid","lod":"3","boundaries":[[[[0,2,1]],[[0,1,3]],[[1,2,3]],[[2,0,3]]]],
"semantics":{"surfaces":[{"type":"WallSurface","part":2,"part_of":1,"children":[1]},{"type":"Window","part":3,
"part_of":2,"parent":0,"sigma_m":[0.1,2],"face":[7,8],"closes_opening":true}],"values":[[0,1,null,0]]}}]},
"b":{"type":"BuildingPart","parents":["a"],
"geometry":[{"type":"MultiSurface","lod":1,"boundaries":[[[0,1,2],[1,2,3]]]}]}},
"vertices":[[0,0,0],[9,0,0],[0,9,0],[0,0,9]]})";

}  // namespace

std::vector<File> stl_files() {
  std::vector<File> out;
  const std::string binary = binary_stl("solid", 3, 3);
  for (size_t end = 0; end < binary.size(); ++end)
    out.push_back({"cut.stl", binary.substr(0, end)});
  for (const uint32_t stated : {0u, 1u, 2u, 4u, 0x7FFFFFFFu, 0x80000000u, 0xFFFFFFFFu})
    out.push_back({"count.stl", binary_stl("", stated, 3)});
  for (const float value :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
        -std::numeric_limits<float>::infinity(), 3e38f, -0.0f})
    out.push_back({"number.stl", binary_stl("", 2, 2, value)});
  for (const char* shift :
       {"nan 0 0", "inf 0 0", "1e999 0 0", "1e308 1e308 1e308", "1 2", "a b c", "1 2 3 4", ""})
    out.push_back({"shift.stl", binary_stl(std::string("Jalon, metres, add ") + shift, 1, 1)});
  const std::string ascii =
      "solid a b\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1e0 "
      "0\nendloop\nendfacet\n"
      "endsolid a b\n";
  add_cuts_and_flips(out, ascii, "stl", 2);
  for (const char* number : {"nan", "inf", "1e999", "", "x", "--1", "1e", "1,5"})
    out.push_back({"vertex.stl", replaced(ascii, "1e0", number)});
  out.push_back({"open.stl", "solid\n" + repeated("vertex 0 0 0\n", 40001)});
  out.push_back({"solids.stl", repeated("solid\n", 300000)});
  out.push_back({"facets.stl", "solid\n" + repeated("facet\n", 300000)});
  out.push_back({"line.stl", "solid " + std::string(3000000, 'x')});
  out.push_back({"number.stl", "solid\nvertex " + std::string(900000, '1')});
  out.push_back({"word.stl", "solid\n" + std::string(900000, 'v')});
  return out;
}

std::vector<File> city_files() {
  std::vector<File> out;
  const std::string seed = kCity;
  const auto add = [&](const std::string& bytes) { out.push_back({"a.city.json", bytes}); };
  add_cuts_and_flips(out, seed, "city.json", 3);
  for (const char* number :
       {"-1", "4", "1.5", "1e3", "4294967295", "4294967296", "9223372036854775807",
        "9223372036854775808", "1e999", "NaN", "Infinity", "null", "\"0\"", "[0]", "{}", ""}) {
    for (const char* place :
         {"[[0,2,1]]", "[0,1,null", "[9,0,0]", "\"translate\":[0,", "\"parent\":0", "\"part\":0",
          "\"part_of\":1", "\"lod\":1", "\"face\":[7,", "\"scale\":[0.001"}) {
      std::string with = place;  // the last number of the place becomes this
      size_t digit = with.find_last_of("0123456789");
      size_t first = digit;
      while (first > 0 &&
             (with[first - 1] == '.' || (with[first - 1] >= '0' && with[first - 1] <= '9')))
        --first;
      add(replaced(seed, place, with.replace(first, digit + 1 - first, number)));
    }
  }
  for (const char* member : {"\"type\":\"CityJSON\",", "\"version\":\"2.0\",", "\"lod\":\"3\",",
                             "\"values\":[[0,1,null,0]]", "[0,1,null,0]", "\"parents\":[\"a\"],"})
    for (const char* with : {"", "[]", "{}", "null", "\"x\":1,"}) add(replaced(seed, member, with));
  for (const char* type : {"GeometryInstance", "MultiPoint", "MultiLineString", "CompositeSolid",
                           "MultiSurface", "Sphere", ""})
    add(replaced(seed, "\"Solid\"", std::string("\"") + type + "\""));
  add(replaced(seed, "\"parents\":[\"a\"]", "\"parents\":[\"b\"]"));
  add(replaced(seed, "\"type\":\"Building\",", "\"type\":\"Building\",\"parents\":[\"b\"],"));
  add(replaced(seed, "\"part_of\":0", "\"part_of\":3"));  // a ring of parts
  for (const char* open : {"[", "{\"a\":", "{\"vertices\":["}) {
    add(repeated(open, 200000));
    add(replaced(seed, "[[0,0,0]", repeated(open, 200)));
  }
  const std::string bare =
      "{\"type\":\"CityJSON\",\"version\":\"2.0\",\"CityObjects\":{},\"vertices\":";
  add(bare + "[" + repeated("0,", 900000) + "0]}");
  add(bare + "[[0,0," + std::string(2000000, '1') + "]]}");
  add(bare + "[[0,0,0]" + repeated(",[0,0,0]", 200000) + "]}");
  add(replaced(seed, "{\"type\":\"WallSurface\"",
               repeated("{},", 500000) + "{\"type\":\"WallSurface\""));
  add(replaced(seed, "[[0,1,2],[1,2,3]]", repeated("[[0,1,2]],", 50000) + "[[0,1,2]]"));
  add(replaced(seed, "[[0,1,2],[1,2,3]]", "[[0,1,2" + repeated(",1,2", 200000) + "]]"));
  add(replaced(seed, "[[0,1,2],[1,2,3]]", repeated("[[]],", 300000) + "[]"));
  add(replaced(seed, "[[0,1,2],[1,2,3]]", "[[0,1,2]" + repeated(",[1,2,3]", 30000) + "]"));
  std::string objects;
  for (int i = 0; i < 20000; ++i)
    objects += "\"o" + std::to_string(i) + "\":{\"type\":\"X\",\"parents\":[\"o" +
               std::to_string(i + 1) + "\"]},";
  add(replaced(seed, "\"CityObjects\":{", "\"CityObjects\":{" + objects));
  add(replaced(seed, "\"name\":\"x\"", "\"name\":\"" + std::string(2000000, 'n') + "\""));
  return out;
}

std::vector<File> noted_obj_files() {
  std::vector<File> out;
  const std::string seed =
      "# Jalon, coordinates in metres\n#: part 0 class wall name w\n#: part 1 of 0 class window "
      "depth 0.2 name x y\n"
      "v 0 0 0\nv 9 0 0\nv 0 9 0\nv 1 1 0\nv 1 2 0\nv 2 1 0\no w\ng plane_5\nf 1 2 3\no outlines\n"
      "#: face part 0 id 5 class 1 sigma 0.1\ng outline_5\nl 1 2 3 1\n#: hole part 1\nl 4 5 6 4\n"
      "#: solid part 0 first 0 count 1\n#: mesh\nf 4 5 6\n";
  add_cuts_and_flips(out, seed, "obj", 2);
  for (const char* place :
       {"part 0", "of 0", "hole part 1", "id 5", "class 1", "first 0", "count 1", "l 1"})
    for (const char* number : {"-1", "1", "7", "4294967295", "4294967296", "18446744073709551615",
                               "18446744073709551616", "nan", "1e999", "x", ""}) {
      std::string with = place;
      out.push_back({"note.obj", replaced(seed, place, with.substr(0, with.size() - 1) + number)});
    }
  out.push_back({"holes.obj", seed + repeated("#: hole part 1\n", 50000)});
  out.push_back({"rings.obj", seed + repeated("#: hole part 1\nl 4 5 6\n", 20000)});
  out.push_back({"faces.obj", seed + repeated("#: face part 0\nl 1 2 3\n", 20000)});
  out.push_back({"parts.obj", seed + repeated("#: part 2\n", 50000)});
  std::string chain = "# Jalon\n";
  for (int i = 0; i < 3000; ++i)
    chain += "#: part " + std::to_string(i) + " of " + std::to_string(i + 1) + " name p\n";
  out.push_back({"chain.obj", chain + "v 0 0 0\nv 1 0 0\nv 0 1 0\n#: face part 0\nl 1 2 3\n"});
  return out;
}

}  // namespace malformed
