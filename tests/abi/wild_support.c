/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Running and judging the cases: one child process each. */
#include "wild_support.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

enum { kSeconds = 60 }; /* no case may take longer, even under a sanitizer */

static unsigned char slots[kSlots][kSlotBytes];
static unsigned char preset[kSlots]; /* bytes at the start of a slot that the caller wrote */

/* Written by the child, read by the parent. */
struct verdict {
  int done, failed;
  char why[1400];
};
static struct verdict* verdict;
static const char *function_name, *case_label;
static int expectation_failed, cases, cases_failed, functions_passed, functions_failed;

void* slot(int i) { return slots[i]; }

void* sized_slot(int i, uint32_t struct_size) {
  memcpy(slots[i], &struct_size, sizeof struct_size);
  preset[i] = sizeof struct_size;
  return slots[i];
}

int slot_written(int i, size_t bytes) {
  for (size_t b = 0; b < bytes; ++b)
    if (slots[i][b] != kPoison) return 1;
  return 0;
}

void case_fail(const char* why) {
  if (verdict->failed) return;
  verdict->failed = 1;
  snprintf(verdict->why, sizeof verdict->why, "%s", why);
}

void see_text(int i, int needed) {
  const char* text;
  if (!slot_written(i, sizeof text)) {
    if (needed) case_fail("a text was not written");
    return;
  }
  memcpy(&text, slots[i], sizeof text);
  if (text == NULL) case_fail("a text is NULL");
  else if (strlen(text) > 1000000) case_fail("a text has no end");
}

void see_texts(int i, int n, int needed) {
  const char* const* texts;
  uint64_t count;
  if (!slot_written(i, sizeof texts) || !slot_written(n, sizeof count)) {
    if (needed) case_fail("texts were not written");
    return;
  }
  memcpy(&texts, slots[i], sizeof texts);
  memcpy(&count, slots[n], sizeof count);
  for (uint64_t k = 0; k < count; ++k)
    if (texts[k] == NULL || strlen(texts[k]) > 1000000) case_fail("a text is NULL or has no end");
}

void see_view(int i, int needed) {
  jalon_array_view view;
  static volatile unsigned char sink;
  if (!slot_written(i, sizeof view)) {
    if (needed) case_fail("a view was not written");
    return;
  }
  memcpy(&view, slots[i], sizeof view);
  if (view.count == 0) return;
  sink = *(const unsigned char*)view.data;
  sink = *((const unsigned char*)view.data + (view.count - 1) * view.stride_bytes);
  (void)sink;
}

void function_begin(const char* name) {
  if (verdict == NULL) {
    verdict =
        mmap(NULL, sizeof *verdict, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    memset(slots, kPoison, sizeof slots);
  }
  function_name = name;
  expectation_failed = 0;
}

static void tell(const char* why) {
  ++expectation_failed;
  ++cases_failed;
  printf("    %s, %s: %s\n", function_name, case_label, why);
}

int case_begin(const char* label) {
  const char* only = getenv("JALON_WILD_ONLY"); /* one function's name, for a debugger */
  if (only != NULL && strcmp(only, function_name) != 0) return 0;
  case_label = label;
  ++cases;
  memset(verdict, 0, sizeof *verdict);
  fflush(NULL);
  const pid_t child = fork();
  if (child == 0) {
    alarm(kSeconds);
    return 1;
  }
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child) {
    tell("no child process");
  } else if (WIFSIGNALED(status)) {
    char why[80];
    snprintf(why, sizeof why,
             WTERMSIG(status) == SIGALRM ? "took longer than %d s" : "ended by signal %d",
             WTERMSIG(status) == SIGALRM ? kSeconds : WTERMSIG(status));
    tell(why);
  } else if (!verdict->done) {
    tell("the process ended inside the call (sanitizer report or exit)");
  } else if (verdict->failed) {
    tell(verdict->why);
  }
  return 0;
}

static int known(jalon_status status) {
  return status == JALON_OK ||
         (status <= JALON_ERROR_INVALID_ARGUMENT && status >= JALON_ERROR_LIMIT) ||
         status == JALON_ERROR_INTERNAL;
}

static void judge_failure(jalon_status status) {
  const char* message = jalon_last_error_message();
  char why[1300];
  if (message[0] == 0) case_fail("a failure without a message");
  for (const char* c = message; *c != 0; ++c)
    if ((unsigned char)*c < 0x20 || *c == 0x7F) case_fail("the message is not one line of text");
  if (strlen(message) > 1023) case_fail("the message is too long");
  if (status == JALON_ERROR_INTERNAL) {
    snprintf(why, sizeof why, "internal error: %s", message);
    case_fail(why);
  }
  for (int i = 0; i < kSlots; ++i)
    for (int b = preset[i]; b < kSlotBytes; ++b)
      if (slots[i][b] != kPoison) {
        snprintf(why, sizeof why, "output %d was written at byte %d although the call failed (%s)",
                 i, b, message);
        case_fail(why);
        break;
      }
}

void case_end(jalon_status status, int expectation, after_success after) {
  char why[1300];
  if (!known(status)) {
    snprintf(why, sizeof why, "status %d is in no header", (int)status);
    case_fail(why);
  }
  if (status == JALON_OK) {
    if (expectation == kMustFail || expectation == kMustBeInvalid) case_fail("succeeded");
    if (after != NULL) after(strcmp(case_label, "valid arguments") == 0);
  } else {
    if (expectation == kMustPass) {
      snprintf(why, sizeof why, "failed: %s: %s", jalon_status_name(status),
               jalon_last_error_message());
      case_fail(why);
    } else if (expectation == kMustBeInvalid && status != JALON_ERROR_INVALID_ARGUMENT) {
      snprintf(why, sizeof why, "gave \"%s\" for an invalid argument: %s",
               jalon_status_name(status), jalon_last_error_message());
      case_fail(why);
    }
    judge_failure(status);
  }
  verdict->done = 1;
  _exit(0);
}

void case_end_truth(int truth) {
  if (!truth) case_fail("not as promised");
  verdict->done = 1;
  _exit(0);
}

void function_end(void) {
  if (expectation_failed) {
    ++functions_failed;
    printf("not ok - wild: %s (%d)\n", function_name, expectation_failed);
  } else {
    ++functions_passed;
    printf("ok - wild: %s takes NULL and wild values\n", function_name);
  }
}

int wild_report(void) {
  printf("    %d calls, %d of them wrong\n", cases, cases_failed);
  printf("%d passed, %d failed, 0 skipped\n", functions_passed, functions_failed);
  return functions_failed ? 1 : 0;
}
