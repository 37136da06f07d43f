// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "malformed_edits.h"
#include "malformed_files.h"

namespace malformed {

namespace {

std::string pairs(const std::string& words) {
  std::string out;
  for (const char c : words) out += c == ' ' ? '\n' : c;
  return out + "\n";
}

// One of each kind that is read.
std::string drawing() {
  return pairs(
      "0 SECTION 2 HEADER 9 $INSUNITS 70 4 0 ENDSEC "
      "0 SECTION 2 BLOCKS 0 BLOCK 8 0 2 b 10 0 20 0 30 0 "
      "0 LWPOLYLINE 8 0 90 3 70 1 10 0 20 0 42 0.5 10 9 20 0 10 9 20 9 0 INSERT 2 c 0 ENDBLK 8 0 "
      "0 BLOCK 8 0 2 c 10 0 20 0 30 0 0 CIRCLE 10 1 20 1 40 2 0 ENDBLK 8 0 0 ENDSEC "
      "0 SECTION 2 ENTITIES "
      "0 POLYLINE 8 A 66 1 70 16 71 2 72 2 0 VERTEX 10 0 20 0 30 0 0 VERTEX 10 1 20 0 30 0 "
      "0 VERTEX 10 0 20 1 30 0 0 VERTEX 10 1 20 1 30 1 0 SEQEND "
      "0 POLYLINE 8 A 66 1 70 64 0 VERTEX 10 0 20 0 30 0 70 192 0 VERTEX 10 1 20 0 30 0 70 192 "
      "0 VERTEX 10 0 20 1 30 0 70 192 0 VERTEX 70 128 71 1 72 2 73 3 0 SEQEND "
      "0 3DFACE 8 F 10 0 20 0 30 0 11 1 21 0 31 0 12 1 22 1 32 0 13 0 23 1 33 0 "
      "0 MESH 8 M 92 3 10 0 20 0 30 0 10 1 20 0 30 0 10 0 20 1 30 0 93 4 90 3 90 0 90 1 90 2 94 0 "
      "0 INSERT 8 I 2 b 10 5 20 5 41 2 42 1 50 30 70 2 71 2 44 3 45 3 "
      "0 LWPOLYLINE 8 W 90 3 70 1 10 0 20 0 10 4 20 0 10 4 20 4 1001 JALON 1000 face=1 1000 part=w "
      "1000 number=0 1000 class=wall 0 ENDSEC 0 EOF");
}

}  // namespace

std::vector<File> dxf_files() {
  std::vector<File> out;
  const std::string whole = drawing();
  for (size_t end = 0; end < whole.size(); end += 3)
    out.push_back({"cut.dxf", whole.substr(0, end)});
  for (size_t at = 0; at < whole.size(); at += 3)
    for (const char bad : {'\0', '\xff', '9', '-', '\n'}) {
      std::string bytes = whole;
      bytes[at] = bad;
      out.push_back({"flip.dxf", bytes});
    }
  // Counts and numbers that lie.
  for (const char* count :
       {"-1", "0", "32767", "2147483647", "9223372036854775807", "99999999999999999999"}) {
    for (const char* group : {"\n71\n2\n", "\n72\n2\n", "\n70\n2\n71\n2\n", "\n73\n3\n",
                              "\n93\n4\n", "\n90\n3\n90\n0\n"}) {
      const std::string code = std::string(group).substr(0, std::string(group).find('\n', 1) + 1);
      out.push_back({"count.dxf", replaced(whole, group, code + count + "\n")});
    }
  }
  for (const char* number : {"nan", "inf", "1e308", "-1e308", "1e-320", "x", ""})
    for (const char* group : {"\n41\n2\n", "\n50\n30\n", "\n40\n2\n", "\n42\n0.5\n", "\n44\n3\n"}) {
      const std::string code = std::string(group).substr(0, std::string(group).find('\n', 1) + 1);
      out.push_back({"number.dxf", replaced(whole, group, code + number + "\n")});
    }
  // A block in itself, in one another, and arrays of arrays that stand for more than any machine holds.
  out.push_back({"self.dxf", replaced(whole, "2\nc\n0\nENDBLK", "2\nb\n0\nENDBLK")});
  std::string arrays = pairs("0 SECTION 2 BLOCKS 0 BLOCK 2 b0 0 CIRCLE 40 1 0 ENDBLK");
  for (int level = 1; level < 30; ++level)
    arrays += pairs("0 BLOCK 2 b" + std::to_string(level) + " 0 INSERT 2 b" +
                    std::to_string(level - 1) + " 70 32767 71 32767 0 ENDBLK");
  arrays += pairs("0 ENDSEC 0 SECTION 2 ENTITIES 0 INSERT 2 b29 0 ENDSEC 0 EOF");
  out.push_back({"arrays.dxf", arrays});
  std::string deep = "0\nSECTION\n";
  for (int k = 0; k < 20000; ++k) deep += "2\nENTITIES\n";
  out.push_back({"deep.dxf", deep});
  return out;
}

}  // namespace malformed
