// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace malformed {

struct Part {
  std::string name, bytes;
};

struct File {
  std::string name;  ///< extension included
  std::string bytes;
  std::string beside = {};       ///< of the file of stations beside it; "" = none
  std::vector<Part> parts = {};  ///< of a data set of many files: names with the folder they are in
};

/// Files that break rules of their format, always the same ones: cut at every byte of the header,
/// every header field at its limits, counts that lie, numbers that are none, lists and tokens
/// without end.
std::vector<File> las_files();
std::vector<File> ply_files();
std::vector<File> text_files();
std::vector<File> obj_files();
/// OBJ files with the notes of our own writer.
std::vector<File> noted_obj_files();
std::vector<File> stl_files();
std::vector<File> city_files();
std::vector<File> dxf_files();
std::vector<File> ptx_files();
std::vector<File> pts_files();
std::vector<File> pcd_files();
/// Good points with bad stations: in a record of LAS, in a comment of PLY, in a file beside text.
std::vector<File> station_files();
/// Of our own writer, with check sums mended or not; none where the library was built without libpng.
std::vector<File> png_files();
/// Of our own writer, read by box too; none where the library was built without LAZ.
std::vector<File> copc_files();
/// Data sets of EPT, read by box too: an index, the files of the hierarchy and the points.
std::vector<File> ept_sets();
/// Damaged files of others, from the folder of shared data; none where that is absent.
std::vector<File> laz_files();
/// Our own, of point format 4 ("auto") or 9 ("1.4"); "" where LAZ was not built.
std::string laz_with_waves(const char* las_version);
/// Our own, of point format 8; "" likewise.
std::string laz_with_layers();
std::vector<File> e57_files();

}  // namespace malformed
