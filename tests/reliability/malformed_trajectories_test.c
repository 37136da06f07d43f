/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Broken trajectories, always the same ones: text, SBET and the sigmas beside it, cut at every byte, with numbers that
 * are none or too large, records swapped and repeated. Each is read or refused in one line, with little memory. */
#include <math.h>

#include "lying_files.h"

enum { kEpochs = 6, kMiB = 1 << 20, kSbetNumbers = 17, kSigmaNumbers = 10 };
static jalon_task* task;
static jalon_params* options; /* where the positions of SBET are */
static int files, refused;

static void judge(const char* path, const char* sigmas, size_t bytes, const char* what,
                  int number) {
  jalon_trajectory* trajectory = NULL;
  uint64_t peak = 0;
  const jalon_status status = jalon_trajectory_read(path, sigmas, options, task, &trajectory);
  ++files;
  if (status != JALON_OK) {
    ++refused;
    expect_one_line();
    if (status == JALON_ERROR_INTERNAL || status == JALON_ERROR_OUT_OF_MEMORY || trajectory != NULL)
      fail_msg("%s %d: %s", what, number, jalon_last_error_message());
  }
  jalon_trajectory_release(trajectory);
  MUST(jalon_task_memory_peak(task, &peak));
  if (peak > 4 * bytes + 64 * (uint64_t)kMiB)
    fail_msg("%s %d takes %d MiB", what, number, (int)(peak >> 20));
}

static const double wild[] = {NAN, INFINITY, -INFINITY, 1e308, -1e308, 5e-324,
                              -1,  0,        1e15,      4e9,   3.2,    -2147483649.0};
enum { kWild = sizeof wild / sizeof *wild };

/* `broken` is read as the one or the other of the two files; the good one stands beside it. */
static void judge_binary(content good, const char* sbet, const char* sigmas, int is_sigmas,
                         size_t numbers) {
  const char *path = is_sigmas ? sigmas : sbet, *beside = is_sigmas ? sigmas : NULL,
             *what = is_sigmas ? "smrmsg" : "SBET";
  content c = {malloc(2 * good.count), good.count};
  for (size_t cut = 0; cut < good.count; cut += cut < 8 * numbers ? 1 : 7) {
    write_file(path, good.bytes, cut);
    judge(sbet, beside, cut, what, (int)cut);
  }
  for (size_t n = 0; n < numbers * kEpochs; ++n)
    for (int w = 0; w < kWild; ++w) {
      memcpy(c.bytes, good.bytes, good.count);
      memcpy(c.bytes + 8 * n, &wild[w], 8);
      write_file(path, c.bytes, good.count);
      judge(sbet, beside, good.count, what, (int)(n * kWild) + w);
    }
  const size_t record = 8 * numbers;
  for (size_t from = 0; from < kEpochs; ++from)
    for (size_t to = 0; to < kEpochs;
         ++to) { /* a record in another's place, and once more at the end */
      memcpy(c.bytes, good.bytes, good.count);
      memcpy(c.bytes + to * record, good.bytes + from * record, record);
      memcpy(c.bytes + good.count, good.bytes + from * record, record);
      write_file(path, c.bytes, good.count + (to % 2) * record);
      judge(sbet, beside, good.count, what, (int)(from * kEpochs + to));
    }
  write_file(path, good.bytes, good.count);
  free(c.bytes);
}

static void judge_text(content good, const char* path) {
  static const char* const words[] = {
      "nan",  "inf", "-1e999", "1e400", "x",       "",      "-",    "1,5",
      "\"",   "#",   "0x1p3",  "--1",   "1e",      "\t",    "\xFF", "99999999999999999999",
      "time", ";",   "1 2",    "\n",    "1e-400 ", "0.0.0", "+",    "\\"};
  int number = 0;
  for (size_t cut = 0; cut < good.count; cut += 3) {
    write_file(path, good.bytes, cut);
    judge(path, NULL, cut, "text cut at", (int)cut);
  }
  for (size_t at = 0; at < good.count; ++at) { /* the word that begins here */
    if (good.bytes[at] == ' ' || good.bytes[at] == '\n' ||
        (at > 0 && good.bytes[at - 1] != ' ' && good.bytes[at - 1] != '\n'))
      continue;
    size_t end = at;
    while (end < good.count && good.bytes[end] != ' ' && good.bytes[end] != '\n') ++end;
    const char* word = words[number % (int)(sizeof words / sizeof *words)];
    content c = {malloc(good.count + 64), 0};
    memcpy(c.bytes, good.bytes, at);
    memcpy(c.bytes + at, word, strlen(word));
    memcpy(c.bytes + at + strlen(word), good.bytes + end, good.count - end);
    c.count = good.count - (end - at) + strlen(word);
    write_file(path, c.bytes, c.count);
    judge(path, NULL, c.count, "text with another word", number++);
    free(c.bytes);
  }
}

static void good_files(const char* text, const char* sbet, const char* sigmas) {
  double times[kEpochs], xyz[3 * kEpochs], attitude[3 * kEpochs], sigma[3 * kEpochs];
  for (int i = 0; i < kEpochs; ++i) {
    times[i] = 1000 + 0.1 * i;
    xyz[3 * i] = 652000 + i, xyz[3 * i + 1] = 6862000 + 2 * i, xyz[3 * i + 2] = 40;
    attitude[3 * i] = 0.01 * i, attitude[3 * i + 1] = -0.01, attitude[3 * i + 2] = 0.5;
    for (int k = 0; k < 3; ++k) sigma[3 * i + k] = 0.01 + 0.001 * i;
  }
  jalon_trajectory* trajectory = NULL;
  jalon_params* axes = NULL;
  MUST(jalon_params_create("trajectory", &axes));
  MUST(jalon_params_from_json(axes, "{\"axes\": \"ned\"}"));
  MUST(jalon_trajectory_create(times, xyz, attitude, sigma, sigma, sigma, kEpochs, "EPSG:2154",
                               axes, &trajectory));
  MUST(jalon_trajectory_write(trajectory, text, NULL, NULL, NULL));
  MUST(jalon_trajectory_write(trajectory, sbet, sigmas, options, NULL));
  jalon_trajectory_release(trajectory);
  jalon_params_release(axes);
}

static content taken(const char* path) {
  content c = {NULL, 0};
  c.bytes = content_of(path, &c.count);
  assert_non_null(c.bytes);
  return c;
}

static void trajectories__that_are_broken_are_refused_or_read(void** state) {
  (void)state;
  char text[560], sbet[560], sigmas[560];
  snprintf(text, sizeof text, "%s", temporary("drive.txt"));
  snprintf(sbet, sizeof sbet, "%s", temporary("drive.sbet"));
  snprintf(sigmas, sizeof sigmas, "%s", temporary("drive.smrmsg"));
  good_files(text, sbet, sigmas);
  content of_text = taken(text), of_sbet = taken(sbet), of_sigmas = taken(sigmas);
  assert_int_equal(of_sbet.count, 8 * kSbetNumbers * kEpochs);
  assert_int_equal(of_sigmas.count, 8 * kSigmaNumbers * kEpochs);
  judge(sbet, sigmas, of_sbet.count, "good", 0);
  judge(text, NULL, of_text.count, "good", 1);
  assert_int_equal(refused, 0);
  judge_text(of_text, text);
  const int of_texts = files;
  judge_binary(of_sbet, sbet, sigmas, 0, kSbetNumbers);
  const int of_sbets = files - of_texts;
  judge_binary(of_sigmas, sbet, sigmas, 1, kSigmaNumbers);
  printf("FIGURE malformed trajectories: %d of text, %d SBET, %d smrmsg, %d refused\n", of_texts,
         of_sbets, files - of_texts - of_sbets, refused);
  assert_true(of_texts >= 100 && of_sbets >= 400 && files - of_texts - of_sbets >= 400);
  assert_true(refused > files / 4);
  free(of_text.bytes), free(of_sbet.bytes), free(of_sigmas.bytes);
  remove(text), remove(sbet), remove(sigmas);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(trajectories__that_are_broken_are_refused_or_read),
  };
  MUST(jalon_params_create("trajectory_file", &options));
  MUST(jalon_params_from_json(options, "{\"projection\": \"lambert93\"}"));
  MUST(jalon_task_create(&task));
  MUST(jalon_task_set_threads(task, 1));
  if (jalon_task_set_memory_limit(task, UINT64_MAX) != JALON_OK) {
    printf("skipped: memory is not counted here\n");
    return 77;
  }
  const int failed = cmocka_run_group_tests_name("malformed_trajectories", tests, NULL, NULL);
  jalon_task_release(task);
  jalon_params_release(options);
  return failed;
}
