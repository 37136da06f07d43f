/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* The calls to the operating system that touch files go through here: the k-th of them, from any thread, meets a fault
 * once. What the program defines stands before what libc does, for the library too. */
#ifndef JALON_TEST_IO_FAULTS_H
#define JALON_TEST_IO_FAULTS_H

#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <sys/stat.h>
#include <unistd.h>

enum fault { kNoFault, kEio, kEnospc, kEintr, kShort, kFaults };
static const char* const fault_names[] = {"none", "EIO", "ENOSPC", "EINTR", "short"};
/* What kinds of calls can meet which fault: an interrupted or a short transfer is not an error. */
enum call_kind { kOpens, kTransfers, kNames };

static int io_armed, io_lost_sync; /* the latter: a file was not taken by the disk */
static long io_calls, io_fault_at, io_faults_met;
static enum fault io_fault;

static int applies(enum fault fault, enum call_kind kind) {
  if (fault == kShort) return kind == kTransfers;
  if (fault == kEintr) return kind != kNames;
  return 1;
}

/* The fault of this call, if it is its turn. */
static enum fault next_fault(enum call_kind kind) {
  if (!__atomic_load_n(&io_armed, __ATOMIC_ACQUIRE)) return kNoFault;
  const long call = __atomic_add_fetch(&io_calls, 1, __ATOMIC_RELAXED);
  if (call != io_fault_at || !applies(io_fault, kind)) return kNoFault;
  __atomic_add_fetch(&io_faults_met, 1, __ATOMIC_RELAXED);
  errno = io_fault == kEio ? EIO : io_fault == kEnospc ? ENOSPC : EINTR;
  return io_fault;
}

static void arm(enum fault fault, long at) {
  io_fault = fault;
  io_fault_at = at;
  io_calls = io_faults_met = io_lost_sync = 0;
  __atomic_store_n(&io_armed, 1, __ATOMIC_RELEASE);
}
static void disarm(void) { __atomic_store_n(&io_armed, 0, __ATOMIC_RELEASE); }

#define REAL(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))
#define TRANSFER(name, bytes, ...)                                   \
  const enum fault fault = next_fault(kTransfers);                   \
  if (fault != kNoFault && fault != kShort) return -1;               \
  const size_t n = fault == kShort && bytes > 1 ? bytes / 2 : bytes; \
  return REAL(name)(__VA_ARGS__)
#define NAMED(name, ...) return next_fault(kNames) != kNoFault ? -1 : REAL(name)(__VA_ARGS__)

#pragma GCC visibility push(default) /* the libraries must see them */
#define OPENS(name)                                \
  int name(const char* path, int flags, ...) {     \
    va_list arguments;                             \
    va_start(arguments, flags);                    \
    const int mode = va_arg(arguments, int);       \
    va_end(arguments);                             \
    if (next_fault(kOpens) != kNoFault) return -1; \
    return REAL(name)(path, flags, mode);          \
  }
OPENS(open)
OPENS(open64)
ssize_t pread(int file, void* to, size_t bytes, off_t at) {
  TRANSFER(pread, bytes, file, to, n, at);
}
ssize_t read(int file, void* to, size_t bytes) { TRANSFER(read, bytes, file, to, n); }
ssize_t write(int file, const void* from, size_t bytes) { TRANSFER(write, bytes, file, from, n); }
ssize_t pwrite(int file, const void* from, size_t bytes, off_t at) {
  TRANSFER(pwrite, bytes, file, from, n, at);
}
int fsync(int file) {
  struct stat info;
  const int is_file = REAL(fstat)(file, &info) == 0 && S_ISREG(info.st_mode);
  if (next_fault(kNames) == kNoFault) return REAL(fsync)(file);
  if (is_file) io_lost_sync = 1;
  return -1;
}
int rename(const char* from, const char* to) { NAMED(rename, from, to); }
int mkdir(const char* path, mode_t mode) { NAMED(mkdir, path, mode); }
int access(const char* path, int how) { NAMED(access, path, how); }
int flock(int file, int how) { NAMED(flock, file, how); }
int fstat(int file, struct stat* out) { NAMED(fstat, file, out); }
int stat(const char* path, struct stat* out) { NAMED(stat, path, out); }
int lstat(const char* path, struct stat* out) { NAMED(lstat, path, out); }
#pragma GCC visibility pop

#endif
