/* Preloaded into the program: at its Nth change of a file (write, change of length, rename, removal) it dies as
 * by kill -9 before it is made, or the change fails as on a full disk. FAIL_AT=N, FAIL_HOW=kill, torn (half of
 * a write is made first), full (this change and all that need room after it), count (only count, to FAIL_COUNT). */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <unistd.h>

static long changes = 0;

static int how(const char* word)
{
  const char* wanted = getenv("FAIL_HOW");
  return wanted != NULL && strcmp(wanted, word) == 0;
}

/* Whether this change is the one, or on a full disk one after it. */
static int due(void)
{
  const char* at = getenv("FAIL_AT");
  ++changes;
  if (at == NULL) return 0;
  return how("full") ? changes >= atol(at) : changes == atol(at);
}

static void die(void) { raise(SIGKILL); }

__attribute__((destructor)) static void report(void)
{
  const char* path = getenv("FAIL_COUNT");
  FILE* file = path != NULL ? fopen(path, "w") : NULL;
  if (file != NULL) {
    fprintf(file, "%ld\n", changes);
    fclose(file);
  }
}

#define REAL(type, name, ...) \
  static type (*real)(__VA_ARGS__) = NULL; \
  if (real == NULL) *(void**)&real = dlsym(RTLD_NEXT, name)

/* The standard streams are not files of the run. */
static int is_stream(int fd) { return fd <= STDERR_FILENO; }

#define NO_ROOM \
  do { \
    errno = ENOSPC; \
    return -1; \
  } while (0)

ssize_t write(int fd, const void* data, size_t size)
{
  REAL(ssize_t, "write", int, const void*, size_t);
  if (!is_stream(fd) && due()) {
    if (how("full")) NO_ROOM;
    if (how("torn")) (void)!real(fd, data, size / 2);
    die();
  }
  return real(fd, data, size);
}

ssize_t writev(int fd, const struct iovec* parts, int count)
{
  REAL(ssize_t, "writev", int, const struct iovec*, int);
  if (!is_stream(fd) && due()) {
    if (how("full")) NO_ROOM;
    if (how("torn")) (void)!real(fd, parts, 1);
    die();
  }
  return real(fd, parts, count);
}

#define PWRITE(symbol) \
  ssize_t symbol(int fd, const void* data, size_t size, off64_t at) \
  { \
    REAL(ssize_t, #symbol, int, const void*, size_t, off64_t); \
    if (due()) { \
      if (how("full")) { /* there is room where the file is already */ \
        if (at + (off64_t)size > lseek64(fd, 0, SEEK_END)) NO_ROOM; \
        return real(fd, data, size, at); \
      } \
      if (how("torn")) { /* the kernel looks for a signal between two pages of the file */ \
        const size_t page = 4096, end = (at + size - 1) / page * page; \
        if ((off64_t)end > at) (void)!real(fd, data, end - at, at); \
      } \
      die(); \
    } \
    return real(fd, data, size, at); \
  }
PWRITE(pwrite)
PWRITE(pwrite64)

#define FTRUNCATE(symbol) \
  int symbol(int fd, off64_t length) \
  { \
    REAL(int, #symbol, int, off64_t); \
    if (due() && !how("full")) die(); /* a full disk lets files be cut */ \
    return real(fd, length); \
  }
FTRUNCATE(ftruncate)
FTRUNCATE(ftruncate64)

#define FALLOCATE(symbol) \
  int symbol(int fd, off64_t at, off64_t length) \
  { \
    REAL(int, #symbol, int, off64_t, off64_t); \
    if (due()) { \
      if (how("full")) return ENOSPC; \
      die(); \
    } \
    return real(fd, at, length); \
  }
FALLOCATE(posix_fallocate)
FALLOCATE(posix_fallocate64)

int rename(const char* from, const char* to)
{
  REAL(int, "rename", const char*, const char*);
  if (due() && !how("full")) die();
  return real(from, to);
}

int unlink(const char* path)
{
  REAL(int, "unlink", const char*);
  if (due() && !how("full")) die();
  return real(path);
}

int remove(const char* path)
{
  REAL(int, "remove", const char*);
  if (due() && !how("full")) die();
  return real(path);
}

int fsync(int fd)
{
  REAL(int, "fsync", int);
  if (due() && !how("full")) die();
  return real(fd);
}
