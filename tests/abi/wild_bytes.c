/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* The bytes of the fixtures, by their nouns. */
#include "wild_support.h"

#include <stdio.h>
#include <stdlib.h>

static jalon_bytes* held;
static const char* held_noun = "";

static jalon_status written(const char* noun, jalon_bytes** out) {
  if (strcmp(noun, "cloud") == 0) return jalon_cloud_to_bytes(fx_cloud, NULL, out);
  if (strcmp(noun, "fields") == 0) return jalon_fields_to_bytes(fx_fields, NULL, out);
  if (strcmp(noun, "params") == 0) return jalon_params_to_bytes(fx_typed[JALON_PARAM_DOUBLE], out);
  if (strcmp(noun, "model") == 0) return jalon_model_to_bytes(fx_model, NULL, out);
  if (strcmp(noun, "segmentation") == 0)
    return jalon_segmentation_to_bytes(fx_segmentation, NULL, out);
  if (strcmp(noun, "comparison") == 0) return jalon_comparison_to_bytes(fx_comparison, NULL, out);
  if (strcmp(noun, "registration") == 0)
    return jalon_registration_to_bytes(fx_registration, NULL, out);
  if (strcmp(noun, "evaluation") == 0) return jalon_evaluation_to_bytes(fx_evaluation, out);
  if (strcmp(noun, "model_evaluation") == 0)
    return jalon_model_evaluation_to_bytes(fx_model_evaluation, out);
  if (strcmp(noun, "noise_law") == 0) return jalon_noise_law_to_bytes(fx_law, out);
  if (strcmp(noun, "segmenter") == 0) return jalon_segmenter_to_bytes(fx_segmenter, out);
  if (strcmp(noun, "modeller") == 0) return jalon_modeller_to_bytes(fx_modeller, out);
  if (strcmp(noun, "comparer") == 0) return jalon_comparer_to_bytes(fx_comparer, out);
  if (strcmp(noun, "registrar") == 0) return jalon_registrar_to_bytes(fx_registrar, out);
  if (strcmp(noun, "scanner") == 0) return jalon_scanner_to_bytes(fx_scanner, out);
  return JALON_ERROR_NOT_FOUND;
}

jalon_bytes* fx_bytes_of(const char* noun) {
  if (strcmp(noun, held_noun) == 0) return held;
  jalon_bytes_release(held);
  held = NULL;
  held_noun = noun;
  if (written(noun, &held) != JALON_OK) {
    printf("not ok - wild: no bytes of %s: %s\n", noun, jalon_last_error_message());
    exit(1);
  }
  return held;
}

const uint8_t* fx_data(const char* noun) {
  jalon_array_view view = {0};
  return jalon_bytes_view(fx_bytes_of(noun), &view) == JALON_OK ? view.data : NULL;
}

uint64_t fx_size(const char* noun) {
  jalon_array_view view = {0};
  return jalon_bytes_view(fx_bytes_of(noun), &view) == JALON_OK ? view.count : 0;
}
