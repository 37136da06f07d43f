// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace fuzz {

// Files (read_files.cpp).
void read_cloud(const char* extension, const uint8_t* data, size_t size);
void read_model(const char* extension, bool as_faces, const uint8_t* data, size_t size);
/// Whole, and by the nodes that a box touches.
void read_copc(const uint8_t* data, size_t size);
/// Whole, and by the nodes that a box touches. Behind zero bytes one after another: the file of the hierarchy's root,
/// that of the node 1-0-0-0, the points of both.
void read_ept(const uint8_t* data, size_t size);
/// The first line is the option "columns" for the text behind it.
void read_text_columns(const uint8_t* data, size_t size);
/// Of eight points in a file beside it.
void read_stations(const uint8_t* data, size_t size);
void read_trajectory_text(const uint8_t* data, size_t size);
void read_trajectory_sbet(const uint8_t* data, size_t size);
void read_smrmsg(const uint8_t* data, size_t size);
void read_m3c2_file(const uint8_t* data, size_t size);
/// The checksums of an E57 file's pages.
void mend_pages(std::string& bytes);

// Bytes of objects (read_objects.cpp). The first byte tells of which kind, or the format that they are written in.
void read_objects(const uint8_t* data, size_t size);
/// An operation of clouds, or a method of segmenting; the first byte tells which.
void run_clouds(const uint8_t* data, size_t size);
void write_clouds(const uint8_t* data, size_t size);
void write_models(const uint8_t* data, size_t size);
/// Kind, length and checksum of the header behind the first byte.
void mend_object(std::string& bytes);
void mend_cloud(std::string& bytes);
void mend_model(std::string& bytes);

// Texts (read_texts.cpp).
/// The first byte tells the operation.
void read_params(const uint8_t* data, size_t size);
void read_law(const uint8_t* data, size_t size);
/// Observations, a zero byte, points.
void read_network(const uint8_t* data, size_t size);
/// Codes of a survey, a zero byte, the table of what they mean; the first byte tells the method.
void read_codes(const uint8_t* data, size_t size);
void read_notes(const uint8_t* data, size_t size);

}  // namespace fuzz
