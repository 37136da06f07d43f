/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* What the generated program wild_calls.c stands on. Every case runs in a child process of its own, so that a crash
 * costs one case and has a name, and that every case meets the same fresh handles. */
#ifndef WILD_SUPPORT_H
#define WILD_SUPPORT_H

#include <jalon/jalon.h>
#include <math.h>
#include <string.h>

enum { kSlots = 10, kSlotBytes = 65536, kPoison = 0xA5, kArrayItems = 4096 };

/* What a case must end in. */
enum { kAny, kMustPass, kMustFail, kMustBeInvalid };

/* Handles and data that are valid. */
extern jalon_cloud *fx_cloud, *fx_small, *fx_empty, *fx_one, *fx_two, *fx_equal, *fx_collinear,
    *fx_far, *fx_nan_field, *fx_ball;
extern jalon_cloud* fx_clouds[3];
extern jalon_cloud_builder *fx_builder, *fx_builder_ready;
extern jalon_fields* fx_fields;
extern jalon_fields* fx_changed; /* points of change regions */
extern jalon_model *fx_model, *fx_mesh, *fx_bare, *fx_block;
extern jalon_segmenter* fx_segmenter;
extern jalon_segmentation *fx_segmentation, *fx_no_segments, *fx_start;
extern jalon_evaluation* fx_evaluation;
extern jalon_model_evaluation* fx_model_evaluation;
extern jalon_modeller* fx_modeller;
extern jalon_comparer* fx_comparer;
extern jalon_comparer* fx_m3c2;
extern jalon_comparison* fx_comparison;
extern jalon_registrar* fx_registrar;
extern jalon_registration* fx_registration;
extern jalon_noise_law* fx_law;
extern jalon_scanner *fx_scanner, *fx_mobile;
extern jalon_model* fx_strips;
extern jalon_trajectory *fx_trajectory, *fx_bare_trajectory, *fx_driven;
extern jalon_cloud* fx_driven_cloud;
extern jalon_model* fx_driven_strips;
extern jalon_adjustment* fx_adjustment;
extern jalon_network* fx_network;
extern jalon_sections* fx_sections;
extern jalon_task *fx_task, *fx_task_own;
extern jalon_params* fx_typed[7];    /* a set with a row of each type ... */
extern const char* fx_typed_name[7]; /* ... and that row's name */
extern double fx_double_value;
extern int64_t fx_int64_value;
extern const char* fx_text_value;
extern double fx_xyz[3 * kArrayItems];
extern uint64_t fx_indices[kArrayItems];
extern uint32_t fx_triangles[kArrayItems];
extern const double fx_square[8], fx_picks[24], fx_areas[8], fx_ranges[8];
extern const jalon_transform fx_identity, fx_zero, fx_nan_transform, fx_inf_transform,
    fx_big_transform;
extern const jalon_transform fx_poses[8], fx_wild_poses[8];
extern const jalon_gauge_piece fx_pieces[8], fx_wild_pieces[8];
extern const jalon_target fx_targets[8], fx_wild_targets[8];
extern const jalon_box fx_box, fx_reversed_box, fx_nan_box;
extern const jalon_vec3 fx_foot, fx_top, fx_nan_vec, fx_inf_vec;
extern char* fx_long_text; /* 70 000 letters */
extern char* fx_deep_json; /* 20 000 brackets */

/* The options of an operation; NULL name gives those of another one. */
jalon_params* fx_options(const char* operation);
/* A path in the test's own folder; an existing readable file of that kind when it is "scan.las", "model.obj" ... */
const char* fx_path(const char* name);
/* The bytes of a fixture, by its noun ("cloud"), good until those of another are asked for. */
jalon_bytes* fx_bytes_of(const char* noun);
const uint8_t* fx_data(const char* noun);
uint64_t fx_size(const char* noun);
int32_t fx_progress(double fraction, const char* stage, void* user);
void fx_log(int32_t level, const char* text, void* user);

void fx_begin(void);
void fx_end(void);

/* Output slots, filled with the poison before each call. */
void* slot(int i);
/* The slot with a struct_size written into its start. */
void* sized_slot(int i, uint32_t struct_size);

/* Function and case bookkeeping; case_begin is true in the child that makes the call. */
void function_begin(const char* name);
int case_begin(const char* label);
typedef void (*after_success)(int all_outputs_given);
void case_end(jalon_status status, int expectation, after_success after);
/* For functions without a status: truth is whether the result was as promised. */
void case_end_truth(int truth);
void function_end(void);
int wild_report(void); /* prints the closing line; the exit code */

/* Looks at an output after a success: it must have been written when needed, and be readable. */
void see_text(int i, int needed);
/* Texts in slot i, their number in slot n. */
void see_texts(int i, int n, int needed);
void see_view(int i, int needed);
#define SEE_HANDLE(i, needed, type, release)                \
  do {                                                      \
    type* handle_;                                          \
    memcpy(&handle_, slot(i), sizeof handle_);              \
    if (slot_written(i, sizeof handle_)) release(handle_);  \
    else if (needed) case_fail("a handle was not written"); \
  } while (0)
int slot_written(int i, size_t bytes);
void case_fail(const char* why);

#define CASE(label, expectation, after, call)                        \
  do {                                                               \
    if (case_begin(label)) case_end((call), (expectation), (after)); \
  } while (0)
#define TRUTH(label, expression)                       \
  do {                                                 \
    if (case_begin(label)) case_end_truth(expression); \
  } while (0)

#endif
