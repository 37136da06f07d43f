/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Statuses and messages. */
#include "support.h"

static void status__each_has_a_name_of_its_own(void** state) {
  (void)state;
  const int32_t numbers[] = {0, -1, -2, -3, -4, -5, -6, -7, -8, -9, -10, -11, -12, -99};
  for (size_t i = 0; i < 14; ++i) {
    assert_string_not_equal(jalon_status_name(numbers[i]), "unknown status");
    for (size_t j = 0; j < i; ++j)
      assert_string_not_equal(jalon_status_name(numbers[i]), jalon_status_name(numbers[j]));
  }
  assert_string_equal(jalon_status_name(-98), "unknown status");
  assert_string_equal(jalon_status_name(1), "unknown status");
}

static void message__stays_until_the_next_failure(void** state) {
  (void)state;
  char first[1024];
  uint64_t count;
  jalon_params* params;
  REFUSED(JALON_ERROR_NOT_FOUND, jalon_params_create("no such operation", &params));
  snprintf(first, sizeof first, "%s", jalon_last_error_message());
  assert_non_null(strstr(first, "no such operation"));
  MUST(jalon_params_operation_count(&count));
  assert_string_equal(jalon_last_error_message(), first);
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_params_operation_count(NULL));
  assert_string_not_equal(jalon_last_error_message(), first);
}

static void message__is_one_line_whatever_the_caller_wrote(void** state) {
  (void)state;
  jalon_params* params;
  REFUSED(JALON_ERROR_NOT_FOUND, jalon_params_create("two\nlines\tand \x1b[31mcolour", &params));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_params_create("not utf-8 \xC3(", &params));
  char text[60001];
  for (size_t i = 0; i < 60000; i += 2) memcpy(text + i, "\xC3\xA9", 2);
  text[60000] = 0;
  REFUSED(JALON_ERROR_NOT_FOUND, jalon_params_create(text, &params));
  assert_true(strlen(jalon_last_error_message()) < 1024);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(status__each_has_a_name_of_its_own),
      cmocka_unit_test(message__stays_until_the_next_failure),
      cmocka_unit_test(message__is_one_line_whatever_the_caller_wrote),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
