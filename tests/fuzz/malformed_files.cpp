// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "malformed_files.h"

#include <cstring>
#include <limits>

#include "malformed_edits.h"

namespace malformed {

namespace {

struct Field {
  size_t at, bytes;
};

// Header fields of LAS 1.4 (LAS 1.4 R15, table 3); earlier versions have the first ones.
constexpr Field kLasFields[] = {{4, 2},   {6, 2},   {24, 1},  {25, 1},  {94, 2},
                                {96, 4},  {100, 4}, {104, 1}, {105, 2}, {107, 4},
                                {131, 8}, {139, 8}, {147, 8}, {155, 8}, {163, 8},
                                {171, 8}, {227, 8}, {235, 8}, {243, 4}, {247, 8}};

// A small valid file: three points, a described extra dimension, a WKT record, an extended record
// in 1.4.
std::string las_seed(unsigned minor, unsigned format, size_t record) {
  const size_t header = minor == 4 ? 375 : minor == 3 ? 235 : 227;
  constexpr size_t kExtra = 4, kPoints = 3;
  std::string wkt = "PROJCS[\"p\",GEOGCS[\"g\",UNIT[\"degree\",0.0174]],UNIT[\"metre\",1]]";
  std::string out(header, '\0');
  const auto add_record = [&](const char* user, uint16_t id, const std::string& data, size_t head) {
    const size_t at = out.size();
    out.resize(at + head);
    std::memcpy(out.data() + at + 2, user, std::strlen(user));
    put<uint16_t>(out, at + 18, id);
    put<uint16_t>(out, at + 20, static_cast<uint16_t>(data.size()));
    out += data;
  };
  std::string descriptor(192, '\0');
  descriptor[2] = 5;
  std::memcpy(descriptor.data() + 4, "label", 5);
  add_record("LASF_Spec", 4, descriptor, 54);
  add_record("LASF_Projection", 2112, wkt, 54);
  std::memcpy(out.data(), "LASF", 4);
  out[24] = 1;
  out[25] = static_cast<char>(minor);
  put<uint16_t>(out, 94, static_cast<uint16_t>(header));
  put<uint32_t>(out, 96, static_cast<uint32_t>(out.size()));
  put<uint32_t>(out, 100, 2);
  out[104] = static_cast<char>(format);
  put<uint16_t>(out, 105, static_cast<uint16_t>(record + kExtra));
  put<uint32_t>(out, 107, kPoints);
  for (size_t k = 0; k < 3; ++k) put<double>(out, 131 + 8 * k, 0.01);
  for (size_t i = 0; i < kPoints * (record + kExtra); ++i) out += static_cast<char>(i * 37);
  if (minor == 4) {
    put<uint64_t>(out, 247, kPoints);
    put<uint64_t>(out, 235, out.size());
    put<uint32_t>(out, 243, 1);
    add_record("own", 7, "some bytes", 60);
  }
  return out;
}

void add_field_limits(std::vector<File>& out, const std::string& seed, Field field,
                      const std::string& name) {
  const uint64_t all = field.bytes == 8 ? ~uint64_t{0} : (uint64_t{1} << (8 * field.bytes)) - 1;
  const uint64_t sign = uint64_t{1} << (8 * field.bytes - 1);
  for (const uint64_t value : {uint64_t{0}, uint64_t{1}, all, all - 1, sign, sign - 1}) {
    std::string bytes = seed;
    std::memcpy(bytes.data() + field.at, &value, field.bytes);
    out.push_back({name, bytes});
  }
  if (field.bytes != 8) return;
  for (const double value : {std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity(), 1e308, -1e-320}) {
    std::string bytes = seed;
    put<double>(bytes, field.at, value);
    out.push_back({name, bytes});
  }
}

}  // namespace

std::vector<File> las_files() {
  std::vector<File> out;
  const std::string v14 = las_seed(4, 7, 36), v12 = las_seed(2, 3, 34), v13 = las_seed(3, 5, 63);
  for (size_t end = 0; end < 375; ++end) out.push_back({"cut14.las", v14.substr(0, end)});
  for (size_t end = 375; end < v14.size(); end += 3)
    out.push_back({"cut14.las", v14.substr(0, end)});
  for (size_t end = 0; end < v12.size(); end += 7) out.push_back({"cut12.las", v12.substr(0, end)});
  for (const std::string& seed : {v14, v12, v13})
    for (const Field& field : kLasFields)
      if (field.at + field.bytes <= (seed[25] == 4 ? 375u : 227u))
        add_field_limits(out, seed, field, "field.las");
  // Record headers: lengths, ids; the descriptor of the extra dimension.
  for (const Field field :
       {Field{375 + 18, 2}, Field{375 + 20, 2}, Field{375 + 54 + 2, 1}, Field{375 + 54 + 3, 1},
        Field{375 + 54 + 192 + 20, 2}, Field{v14.size() - 10 - 40, 8}})
    add_field_limits(out, v14, field, "record.las");
  for (unsigned type = 0; type < 256; ++type) {
    std::string bytes = v14;
    bytes[375 + 56] = static_cast<char>(type);
    bytes[375 + 57] = static_cast<char>(type * 7);
    out.push_back({"type.las", bytes});
  }
  {  // swapped offsets, deep and endless WKT
    std::string bytes = v14;
    put<uint64_t>(bytes, 235, 100);
    out.push_back({"swap.las", bytes});
    put<uint32_t>(bytes, 96, 376);
    out.push_back({"swap.las", bytes});
    for (const char* piece : {"PROJCS[", "UNIT[\"", "\"", "]", "UNIT[\"f\",0.3048", "("}) {
      std::string wkt = repeated(piece, 60000 / std::strlen(piece));
      std::string deep(227 + 54, '\0');
      deep.replace(0, 227, las_seed(2, 0, 20).substr(0, 227));
      std::memcpy(deep.data() + 229, "LASF_Projection", 15);
      put<uint16_t>(deep, 227 + 18, 2112);
      put<uint16_t>(deep, 227 + 20, static_cast<uint16_t>(wkt.size()));
      deep += wkt;
      put<uint32_t>(deep, 96, static_cast<uint32_t>(deep.size()));
      put<uint32_t>(deep, 100, 1);
      deep += std::string(72, '\1');
      out.push_back({"wkt.las", deep});
    }
  }
  return out;
}

std::vector<File> ply_files() {
  std::vector<File> out;
  const std::string properties = "property float x\nproperty float y\nproperty float z\n";
  const std::string faces = "element face 1\nproperty list uchar int vertex_indices\n";
  const auto binary = [](size_t n) {
    std::string bytes;
    for (size_t i = 0; i < n; ++i) bytes += static_cast<char>(i * 11);
    return bytes;
  };
  const std::string body = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  const std::string ascii = "ply\nformat ascii 1.0\ncomment c\nelement vertex 3\n" + properties +
                            faces + "end_header\n" + body;
  std::string little = "ply\nformat binary_little_endian 1.0\nelement vertex 3\n" + properties +
                       faces + "end_header\n" + std::string(36, '\0');
  little += std::string("\3\0\0\0\0\1\0\0\0\2\0\0\0", 13);
  for (const std::string& seed : {ascii, little}) {
    for (size_t end = 0; end < seed.size(); ++end) out.push_back({"cut.ply", seed.substr(0, end)});
    for (size_t at = 0; at < seed.size(); at += 3) {
      std::string bytes = seed;
      bytes[at] = static_cast<char>(bytes[at] ^ 0x80);
      out.push_back({"flip.ply", bytes});
    }
  }
  for (const char* count :
       {"0", "1", "4", "4294967295", "4294967296", "9223372036854775807", "9223372036854775808",
        "18446744073709551615", "18446744073709551616", "-1", "1e3", "x", ""})
    for (const char* form : {"ascii", "binary_little_endian", "binary_big_endian"}) {
      const std::string head = std::string("ply\nformat ") + form + " 1.0\n";
      const std::string n = count;
      out.push_back(
          {"count.ply", head + "element vertex " + n + "\n" + properties + "end_header\n" + body});
      out.push_back({"empty.ply", head + "element nothing " + n + "\nelement vertex 1\n" +
                                      properties + "end_header\n" + body});
      out.push_back({"before.ply", head + "element other " + n +
                                       "\nproperty uchar a\nelement vertex 1\n" + properties +
                                       "end_header\n" + body});
      out.push_back({"faces.ply", head + "element vertex 3\n" + properties + "element face " + n +
                                      "\nproperty list uint int vertex_indices\nend_header\n" +
                                      (form[0] == 'a' ? body : binary(200))});
      out.push_back({"vlist.ply", head + "element vertex " + n +
                                      "\nproperty list uint double bomb\n" + properties +
                                      "end_header\n" + binary(300)});
    }
  for (const char* type : {"char", "uchar", "short", "ushort", "int", "uint", "float", "double",
                           "int64", "uint64", "list", "what"}) {
    const std::string t = type;
    for (const char* form : {"ascii", "binary_little_endian", "binary_big_endian"}) {
      const std::string head = std::string("ply\nformat ") + form + " 1.0\nelement vertex 2\n";
      out.push_back({"type.ply", head + "property " + t + " x\nproperty " + t + " y\nproperty " +
                                     t + " z\nend_header\n255 -1 1e400\n1 2 3\n" + binary(64)});
      out.push_back({"list.ply", head + properties + "property list " + t + " " + t +
                                     " l\nend_header\n" + std::string(200, '\xff')});
    }
  }
  out.push_back({"many.ply", "ply\nformat ascii 1.0\n" + repeated("element e 1\n", 100000)});
  out.push_back({"wide.ply", "ply\nformat ascii 1.0\nelement vertex 1\n" +
                                 repeated("property float x\n", 60000) + "end_header\n"});
  out.push_back({"same.ply", "ply\nformat ascii 1.0\nelement vertex 1\n" +
                                 repeated("property uchar a\n", 4000) + properties +
                                 "end_header\n" + repeated("1 ", 4003)});
  out.push_back({"token.ply", "ply\nformat ascii 1.0\nelement vertex 1\n" + properties +
                                  "end_header\n" + std::string(3000000, '1') + " 0 0\n"});
  out.push_back({"blank.ply", "ply\nformat ascii 1.0\nelement vertex 1\n" + properties +
                                  "end_header\n" + std::string(3000000, ' ')});
  out.push_back({"line.ply", "ply\n" + std::string(3000000, 'c')});
  out.push_back(
      {"polygon.ply",
       "ply\nformat ascii 1.0\nelement vertex 1\n" + properties +
           "element face 1\nproperty list int int vertex_index\nend_header\n0 0 0\n500000 " +
           repeated("0 ", 500000)});
  return out;
}

std::vector<File> text_files() {
  std::vector<File> out;
  const std::string seed = "# x y z intensity\n1.5 2.5 3.5 7\n-1 2e3 +3 8\n";
  for (size_t end = 0; end < seed.size(); ++end) out.push_back({"cut.xyz", seed.substr(0, end)});
  for (size_t at = 0; at < seed.size(); ++at)
    for (const char bad : {'\0', '\xff', ';', '"'}) {
      std::string bytes = seed;
      bytes[at] = bad;
      out.push_back({"flip.xyz", bytes});
    }
  for (const char* bad : {"nan",
                          "inf",
                          "-inf",
                          "1e999",
                          "-1e-999",
                          "1e99999999999999999999",
                          "0x10",
                          "1.2.3",
                          "--1",
                          "+-1",
                          ".",
                          "-",
                          "e5",
                          "1e",
                          "1e+",
                          "99999999999999999999999999999999",
                          "1,5",
                          "\"1\"",
                          "\"1",
                          "1;",
                          "\xF0\x9F\x98\x80"})
    for (size_t column = 0; column < 4; ++column) {
      std::string line;
      for (size_t c = 0; c < 4; ++c)
        line += (c == column ? std::string(bad) : std::string("1")) + " ";
      out.push_back({"token.txt", "1 2 3 4\n" + line + "\n"});
      out.push_back({"token.csv", "x,y,z,i\n" + line + "\n"});
    }
  out.push_back({"long.xyz", std::string(3000000, '1')});
  out.push_back({"long.xyz", "1 2 3\n" + std::string(3000000, '7')});
  out.push_back({"wide.xyz", repeated("1 ", 500000)});
  out.push_back({"wide.xyz", repeated("1 ", 5000) + "\n"});
  out.push_back({"semi.csv", repeated(";", 500000)});
  out.push_back({"comment.xyz", repeated("#\n", 500000)});
  out.push_back({"blank.xyz", std::string(2000000, '\n')});
  out.push_back({"header.txt", repeated("a ", 300000) + "\n1 2 3\n"});
  out.push_back({"counts.pts", repeated("5\n", 300000)});
  out.push_back({"utf16.txt", std::string("\xFF\xFE"
                                          "1\0 \0",
                                          6)});
  out.push_back({"names.csv", repeated("a,", 3000) + "x,y,z\n" + repeated("1,", 3000) + "1,2,3\n"});
  return out;
}

std::vector<File> obj_files() {
  std::vector<File> out;
  const std::string seed = "o a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1//1 2/2 3/3/3\nf -1 -2 -3\n";
  for (size_t end = 0; end < seed.size(); ++end) out.push_back({"cut.obj", seed.substr(0, end)});
  for (size_t at = 0; at < seed.size(); at += 2)
    for (const char bad : {'\0', '\xff', '\\', '9'}) {
      std::string bytes = seed;
      bytes[at] = bad;
      out.push_back({"flip.obj", bytes});
    }
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (const char* face : {"0 1 2", "1 2 4", "-4 1 2", "1 2", "1", "", "18446744073709551615 1 2",
                           "9223372036854775807 1 2", "-9223372036854775808 1 2", "4294967297 1 2",
                           "1.5 2 3", "a b c", "1/ 2/ 3/", "/1 /2 /3", "1 1 1", "1e1 2 3"})
    out.push_back({"face.obj", vertices + "f " + face + "\n"});
  for (const char* number : {"nan", "inf", "1e999", "", "x", "--1", "1e"})
    out.push_back({"vertex.obj", vertices + "v 0 0 " + number + "\nf 1 2 3\n"});
  out.push_back({"polygon.obj", vertices + "f " + repeated("1 2 3 ", 80000) + "\n"});
  std::string tangle;
  for (int i = 0; i < 500; ++i)
    tangle +=
        "v " + std::to_string(i * 7919 % 503) + " " + std::to_string(i * 104729 % 509) + " 0\n";
  for (int f = 0; f < 100; ++f) {
    tangle += "f";
    for (int i = 0; i < 500; ++i) tangle += " " + std::to_string((i * 211 + f) % 500 + 1);
    tangle += "\n";
  }
  out.push_back({"tangle.obj", tangle});
  out.push_back({"line.obj", vertices + "f " + std::string(3000000, '1')});
  out.push_back({"continued.obj", vertices + repeated("f 1 2 \\\n", 400000)});
  out.push_back({"groups.obj", vertices + repeated("g a\nf 1 2 3\n", 50000)});
  std::string names = vertices;
  for (int i = 0; i < 30000; ++i) names += "g n" + std::to_string(i) + "\n";
  out.push_back({"names.obj", names});
  out.push_back({"name.obj", vertices + "g " + std::string(900000, '\xfe') + "\nf 1 2 3\n"});
  return out;
}

}  // namespace malformed
