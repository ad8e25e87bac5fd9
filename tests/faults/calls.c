// SPDX-License-Identifier: GPL-3.0-or-later
// For LD_PRELOAD: writes every open, fsync, fdatasync and rename of the program into the file EHD_CALLS, a line each.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define REAL(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))

static void say(const char *what, const char *path) {
  const char *log = getenv("EHD_CALLS");
  if (!log) return;
  char line[9000];
  const int length = snprintf(line, sizeof line, "%s %s\n", what, path);
  const int file = REAL(open)(log, O_WRONLY | O_APPEND | O_CREAT, 0600);
  if (file < 0 || length < 0) return;
  if (write(file, line, (size_t)length) < 0) abort();
  close(file);
}

static void say_descriptor(const char *what, int descriptor) {
  char link[64], path[4096];
  snprintf(link, sizeof link, "/proc/self/fd/%d", descriptor);
  const ssize_t length = readlink(link, path, sizeof path - 1);
  path[length < 0 ? 0 : length] = 0;
  say(what, path);
}

int open(const char *path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = flags & O_CREAT ? va_arg(rest, mode_t) : 0;
  va_end(rest);
  const int made = O_CREAT | O_EXCL | O_NOFOLLOW;
  if (flags & O_CREAT) say((flags & made) == made ? "made" : "made-carelessly", path);
  return REAL(open)(path, flags, mode);
}

int fsync(int descriptor) {
  say_descriptor("synced", descriptor);
  return REAL(fsync)(descriptor);
}

int fdatasync(int descriptor) {
  say_descriptor("synced", descriptor);
  return REAL(fdatasync)(descriptor);
}

int rename(const char *from, const char *to) {
  say("renamed", from);
  return REAL(rename)(from, to);
}
