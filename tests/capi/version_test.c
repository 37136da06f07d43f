/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
#include "support.h"

#include <sys/wait.h>
#include <unistd.h>

static void version__runs_with_the_headers_it_was_built_from(void** state) {
  (void)state;
  char text[32];
  assert_string_equal(jalon_version(), JALON_VERSION_STRING);
  assert_int_equal(jalon_version_number(), JALON_VERSION_NUMBER);
  snprintf(text, sizeof text, "%d.%d.%d", JALON_VERSION_MAJOR, JALON_VERSION_MINOR,
           JALON_VERSION_PATCH);
  assert_string_equal(text, JALON_VERSION_STRING);
}

static void version__at_least_compares_in_order(void** state) {
  (void)state;
  assert_true(
      JALON_VERSION_AT_LEAST(JALON_VERSION_MAJOR, JALON_VERSION_MINOR, JALON_VERSION_PATCH));
  assert_true(JALON_VERSION_AT_LEAST(0, 0, 0));
  assert_false(
      JALON_VERSION_AT_LEAST(JALON_VERSION_MAJOR, JALON_VERSION_MINOR, JALON_VERSION_PATCH + 1));
  assert_false(JALON_VERSION_AT_LEAST(JALON_VERSION_MAJOR, JALON_VERSION_MINOR + 1, 0));
  assert_false(JALON_VERSION_AT_LEAST(JALON_VERSION_MAJOR + 1, 0, 0));
}

static const char* own_path;

/* The environment is read once a process, so another process looks. */
static void instruction_set__baseline_can_be_asked_for(void** state) {
  (void)state;
  const pid_t child = fork();
  if (child == 0) {
    setenv("JALON_SIMD", "baseline", 1);
    execl(own_path, own_path, "--tell-instruction-set", (char*)NULL);
    _exit(9);
  }
  int status = 0;
  assert_int_equal(waitpid(child, &status, 0), child);
  assert_true(WIFEXITED(status));
  assert_int_equal(WEXITSTATUS(status), 1);
}

static void instruction_set__is_one_of_two(void** state) {
  (void)state;
  const char* set = jalon_instruction_set();
  assert_true(strcmp(set, "avx2") == 0 || strcmp(set, "baseline") == 0);
  assert_ptr_equal(set, jalon_instruction_set());
}

int main(int argc, char** argv) {
  if (argc == 2 && strcmp(argv[1], "--tell-instruction-set") == 0)
    return strcmp(jalon_instruction_set(), "baseline") == 0;
  own_path = argv[0];
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(version__runs_with_the_headers_it_was_built_from),
      cmocka_unit_test(version__at_least_compares_in_order),
      cmocka_unit_test(instruction_set__baseline_can_be_asked_for),
      cmocka_unit_test(instruction_set__is_one_of_two),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
