/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/**
 * @file bytes.h
 * Objects as bytes and back: for another process, a queue, a cache, a database. What comes back is the same object,
 * bit by bit (NaN payloads included), with its fields, names, units, stations and CRS; not the index of a cloud, which
 * is built anew when it is needed. A result brings what it looks at: the cloud of a segmentation is within its bytes.
 *
 * The bytes are little-endian, the same on every machine. They begin with a header of 32 bytes, which stays as it is
 * for ever:
 *
 * - byte 0: 89 4A 4C 4E 0D 0A 1A 0A
 * - byte 8: uint32, layout of what follows the header; 1 today
 * - byte 12: uint32, kind of object
 * - byte 16: uint64, bytes that follow the header
 * - byte 24: uint32, checksum: the CRC-32 of bytes 0 to 23 and then of the CRC-32 of each MiB that follows
 * - byte 28: uint32, 0
 *
 * A release reads the layouts of all releases before it. The bytes of a later one are JALON_ERROR_UNSUPPORTED with a
 * line that says so; those of another kind of object are JALON_ERROR_INVALID_ARGUMENT; bytes that are cut, damaged or
 * made up are JALON_ERROR_FORMAT with the byte where they are wrong. No count in them is believed: memory grows with
 * what is there. They are data, never code; still, as with any file, read them only from where you would take a file.
 *
 * Reading and writing are O(size) and parallel. A function that writes looks at the object as it is at that moment;
 * threads as for the object.
 */
#ifndef JALON_BYTES_H
#define JALON_BYTES_H

#include <jalon/cloud.h>
#include <jalon/comparer.h>
#include <jalon/evaluate.h>
#include <jalon/field_tools.h>
#include <jalon/modeller.h>
#include <jalon/registrar.h>
#include <jalon/scanner.h>
#include <jalon/segmenter.h>

JALON_BEGIN_C

/** The bytes of an object: immutable, readable by many threads. */
typedef struct jalon_bytes jalon_bytes;

JALON_API jalon_bytes* jalon_bytes_retain(jalon_bytes* bytes);
JALON_API void jalon_bytes_release(jalon_bytes* bytes);
/** All of them, uint8, header first. No copy; lives as long as the handle. */
JALON_API JALON_CHECK jalon_status jalon_bytes_view(const jalon_bytes* bytes,
                                                    jalon_array_view* out);

/** The cloud as bytes. The caller releases them. */
JALON_API JALON_CHECK jalon_status jalon_cloud_to_bytes(const jalon_cloud* cloud, jalon_task* task,
                                                        jalon_bytes** out);
/** A cloud from its bytes, which are copied. */
JALON_API JALON_CHECK jalon_status jalon_cloud_from_bytes(const uint8_t* bytes, uint64_t byte_count,
                                                          jalon_task* task, jalon_cloud** out);

/** The table as bytes. The caller releases them. */
JALON_API JALON_CHECK jalon_status jalon_fields_to_bytes(const jalon_fields* fields,
                                                         jalon_task* task, jalon_bytes** out);
/** A table from its bytes, which are copied. */
JALON_API JALON_CHECK jalon_status jalon_fields_from_bytes(const uint8_t* bytes,
                                                           uint64_t byte_count, jalon_task* task,
                                                           jalon_fields** out);

/**
 * The parameters as bytes: the operation, or the method of a worker, and all values by name, also those that are at
 * their defaults. The caller releases them.
 */
JALON_API JALON_CHECK jalon_status jalon_params_to_bytes(const jalon_params* params,
                                                         jalon_bytes** out);
/**
 * Parameters from their bytes: a set of their own, also where they were those of a worker. A value that this release
 * does not know, or that lies out of its range here, is JALON_ERROR_FORMAT; parameters that are new here have their
 * defaults.
 */
JALON_API JALON_CHECK jalon_status jalon_params_from_bytes(const uint8_t* bytes,
                                                           uint64_t byte_count, jalon_params** out);

/* ---- models and results ---- */

/** The model as bytes. The caller releases them. */
JALON_API JALON_CHECK jalon_status jalon_model_to_bytes(const jalon_model* model, jalon_task* task,
                                                        jalon_bytes** out);
/** A model from its bytes, which are copied. */
JALON_API JALON_CHECK jalon_status jalon_model_from_bytes(const uint8_t* bytes, uint64_t byte_count,
                                                          jalon_task* task, jalon_model** out);

/** The segmentation as bytes, with its cloud. The caller releases them. */
JALON_API JALON_CHECK jalon_status jalon_segmentation_to_bytes(
    const jalon_segmentation* segmentation, jalon_task* task, jalon_bytes** out);
/** A segmentation from its bytes, which are copied. */
JALON_API JALON_CHECK jalon_status jalon_segmentation_from_bytes(const uint8_t* bytes,
                                                                 uint64_t byte_count,
                                                                 jalon_task* task,
                                                                 jalon_segmentation** out);

/** The comparison as bytes, with the points that its rows belong to. The caller releases them. */
JALON_API JALON_CHECK jalon_status jalon_comparison_to_bytes(const jalon_comparison* comparison,
                                                             jalon_task* task, jalon_bytes** out);
/** A comparison from its bytes, which are copied. */
JALON_API JALON_CHECK jalon_status jalon_comparison_from_bytes(const uint8_t* bytes,
                                                               uint64_t byte_count,
                                                               jalon_task* task,
                                                               jalon_comparison** out);

/** The registration as bytes, with the CRS of the reference. The caller releases them. */
JALON_API JALON_CHECK jalon_status jalon_registration_to_bytes(
    const jalon_registration* registration, jalon_task* task, jalon_bytes** out);
/** A registration from its bytes, which are copied. */
JALON_API JALON_CHECK jalon_status jalon_registration_from_bytes(const uint8_t* bytes,
                                                                 uint64_t byte_count,
                                                                 jalon_task* task,
                                                                 jalon_registration** out);

/** The evaluation as bytes. The caller releases them. */
JALON_API JALON_CHECK jalon_status jalon_evaluation_to_bytes(const jalon_evaluation* evaluation,
                                                             jalon_bytes** out);
/** An evaluation from its bytes, which are copied. */
JALON_API JALON_CHECK jalon_status jalon_evaluation_from_bytes(const uint8_t* bytes,
                                                               uint64_t byte_count,
                                                               jalon_evaluation** out);

/** The evaluation of a model as bytes. The caller releases them. */
JALON_API JALON_CHECK jalon_status
jalon_model_evaluation_to_bytes(const jalon_model_evaluation* evaluation, jalon_bytes** out);
/** An evaluation of a model from its bytes, which are copied. */
JALON_API JALON_CHECK jalon_status jalon_model_evaluation_from_bytes(const uint8_t* bytes,
                                                                     uint64_t byte_count,
                                                                     jalon_model_evaluation** out);

/** The law as bytes. The caller releases them. */
JALON_API JALON_CHECK jalon_status jalon_noise_law_to_bytes(const jalon_noise_law* law,
                                                            jalon_bytes** out);
/** A law from its bytes, which are copied. */
JALON_API JALON_CHECK jalon_status jalon_noise_law_from_bytes(const uint8_t* bytes,
                                                              uint64_t byte_count,
                                                              jalon_noise_law** out);

/* ---- workers: the method and the parameters; of a scanner also its stations ---- */

/** The segmenter as bytes. The caller releases them. */
JALON_API JALON_CHECK jalon_status jalon_segmenter_to_bytes(const jalon_segmenter* segmenter,
                                                            jalon_bytes** out);
/** A segmenter from its bytes; errors as of jalon_params_from_bytes. */
JALON_API JALON_CHECK jalon_status jalon_segmenter_from_bytes(const uint8_t* bytes,
                                                              uint64_t byte_count,
                                                              jalon_segmenter** out);

/** The modeller as bytes. The caller releases them. */
JALON_API JALON_CHECK jalon_status jalon_modeller_to_bytes(const jalon_modeller* modeller,
                                                           jalon_bytes** out);
/** A modeller from its bytes; errors as of jalon_params_from_bytes. */
JALON_API JALON_CHECK jalon_status jalon_modeller_from_bytes(const uint8_t* bytes,
                                                             uint64_t byte_count,
                                                             jalon_modeller** out);

/** The comparer as bytes. The caller releases them. */
JALON_API JALON_CHECK jalon_status jalon_comparer_to_bytes(const jalon_comparer* comparer,
                                                           jalon_bytes** out);
/** A comparer from its bytes; errors as of jalon_params_from_bytes. */
JALON_API JALON_CHECK jalon_status jalon_comparer_from_bytes(const uint8_t* bytes,
                                                             uint64_t byte_count,
                                                             jalon_comparer** out);

/** The registrar as bytes. The caller releases them. */
JALON_API JALON_CHECK jalon_status jalon_registrar_to_bytes(const jalon_registrar* registrar,
                                                            jalon_bytes** out);
/** A registrar from its bytes; errors as of jalon_params_from_bytes. */
JALON_API JALON_CHECK jalon_status jalon_registrar_from_bytes(const uint8_t* bytes,
                                                              uint64_t byte_count,
                                                              jalon_registrar** out);

/** The scanner as bytes. The caller releases them. */
JALON_API JALON_CHECK jalon_status jalon_scanner_to_bytes(const jalon_scanner* scanner,
                                                          jalon_bytes** out);
/** A scanner from its bytes; errors as of jalon_params_from_bytes. */
JALON_API JALON_CHECK jalon_status jalon_scanner_from_bytes(const uint8_t* bytes,
                                                            uint64_t byte_count,
                                                            jalon_scanner** out);

JALON_END_C

#endif
