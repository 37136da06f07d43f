/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/**
 * @file io.h
 * Files. The format is told by content first and by extension second; paths are UTF-8. Text is read and written without
 * locale.
 *
 * Readers never trust a count in a header: memory grows with what has been read. A truncated or lying file is
 * JALON_ERROR_FORMAT, and the message names file, offset and reason. Writers write beside the target and rename: a
 * failed write never replaces a good file.
 *
 * Clouds: LAS 1.0-1.4 (point formats 0-10 read; 1.2 and 1.4 written; VLRs, EVLRs and CRS carried verbatim; other fields
 * as extra bytes), PLY (ASCII, both endians, all scalar properties), XYZ/TXT/CSV/PTS-like text. Meshes and models: OBJ,
 * PLY.
 */
#ifndef JALON_IO_H
#define JALON_IO_H

#include <jalon/cloud.h>
#include <jalon/model.h>

JALON_BEGIN_C

/** Reads a cloud. options: operation "read" (columns, drop_invalid, ...) or NULL. */
JALON_API JALON_CHECK jalon_status jalon_cloud_read(const char* path, const jalon_params* options,
                                        jalon_task* task, jalon_cloud** out);
/** Writes a cloud in the format of the extension. options: operation "write" or NULL. */
JALON_API JALON_CHECK jalon_status jalon_cloud_write(const jalon_cloud* cloud, const char* path,
                                         const jalon_params* options, jalon_task* task);
/** Reads a mesh or model (OBJ, PLY with faces). */
JALON_API JALON_CHECK jalon_status jalon_model_read(const char* path, const jalon_params* options,
                                        jalon_task* task, jalon_model** out);
/** Writes a model (OBJ; PLY as triangles). */
JALON_API JALON_CHECK jalon_status jalon_model_write(const jalon_model* model, const char* path,
                                         const jalon_params* options, jalon_task* task);
/** Number of formats in the registry. */
JALON_API JALON_CHECK jalon_status jalon_format_count(uint64_t* out);
/** Format i: name ("LAS"), extensions ("las"), and what it can do as text, e.g. "cloud read write". Each output may be
 * NULL. */
JALON_API JALON_CHECK jalon_status jalon_format_info(uint64_t i, const char** name, const char** extensions,
                                         const char** abilities);

JALON_END_C

#endif
