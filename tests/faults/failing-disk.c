/* Preloaded into a program, makes its K-th call that changes a regular file or a folder fail:
 * opening to write, write, fsync, truncating, close, link, unlink, rename, making a folder. SQLite's
 * calls, with an offset and without times, are among them.
 *
 *   QUOIN_DISK_FAULT=K:ERRNO   which call, from 1, and with what; 0: the program is killed instead
 *   QUOIN_DISK_MARK=PATH       made when it has failed; PATH itself is left in peace
 *   QUOIN_DISK_NAMED=1         there are no files without a name, as on some file systems
 */
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

int qn_shim_open (const char *path, int flags, int mode) __asm__("open");
int qn_shim_open64 (const char *path, int flags, int mode) __asm__("open64");

static int calls;

/* Counts a call; whether it is the one that fails, with errno set. */
static bool
strikes (void)
{
  const char *fault = getenv ("QUOIN_DISK_FAULT"), *mark = getenv ("QUOIN_DISK_MARK");
  int number = 0, code = 0;

  if (fault == NULL || sscanf (fault, "%d:%d", &number, &code) != 2 || ++calls != number)
    return false;
  if (mark != NULL)
    syscall (SYS_close,
             (int) syscall (SYS_openat, AT_FDCWD, mark, O_CREAT | O_WRONLY, 0600));
  if (code == 0)
    kill (getpid (), SIGKILL);
  errno = code;
  return true;
}

static bool
is_output (int fd)
{
  struct stat status;
  int saved = errno;
  bool regular = fd > 2 && fstat (fd, &status) == 0 && S_ISREG (status.st_mode)
                 && (fcntl (fd, F_GETFL) & O_ACCMODE) != O_RDONLY;
  errno = saved;
  return regular;
}

static int
opened (const char *path, int flags, int mode)
{
  if ((flags & O_TMPFILE) == O_TMPFILE && getenv ("QUOIN_DISK_NAMED") != NULL) {
    errno = EOPNOTSUPP;
    return -1;
  }
  bool writes = (flags & O_ACCMODE) != O_RDONLY && strncmp (path, "/dev/", 5) != 0;
  if (writes && strikes ())
    return -1;
  return (int) syscall (SYS_openat, AT_FDCWD, path, flags, mode);
}

int
qn_shim_open (const char *path, int flags, int mode)
{
  return opened (path, flags, mode);
}

int
qn_shim_open64 (const char *path, int flags, int mode)
{
  return opened (path, flags | O_LARGEFILE, mode);
}

ssize_t
write (int fd, const void *bytes, size_t length)
{
  if (is_output (fd) && strikes ())
    return -1;
  /* Half of it, as a disk that fills up does. */
  return syscall (SYS_write, fd, bytes,
                  is_output (fd) && length > 1 ? length / 2 : length);
}

ssize_t
writev (int fd, const struct iovec *pieces, int count)
{
  return is_output (fd) && strikes () ? -1 : syscall (SYS_writev, fd, pieces, count);
}

ssize_t
pwrite64 (int fd, const void *bytes, size_t length, off64_t offset)
{
  return is_output (fd) && strikes () ? -1
                                      : syscall (SYS_pwrite64, fd, bytes, length, offset);
}

int
ftruncate64 (int fd, off64_t length)
{
  return is_output (fd) && strikes () ? -1 : (int) syscall (SYS_ftruncate, fd, length);
}

int
fsync (int fd)
{
  return is_output (fd) && strikes () ? -1 : (int) syscall (SYS_fsync, fd);
}

int
fdatasync (int fd)
{
  return is_output (fd) && strikes () ? -1 : (int) syscall (SYS_fdatasync, fd);
}

/* The descriptor is gone whatever it says. */
int
close (int fd)
{
  bool fails = is_output (fd) && strikes ();
  int code = errno, status = (int) syscall (SYS_close, fd);
  if (!fails)
    return status;
  errno = code;
  return -1;
}

int
linkat (int from, const char *old, int to, const char *new, int flags)
{
  return strikes () ? -1 : (int) syscall (SYS_linkat, from, old, to, new, flags);
}

int
unlink (const char *path)
{
  return strikes () ? -1 : (int) syscall (SYS_unlink, path);
}

int
rename (const char *old, const char *new)
{
  return strikes () ? -1 : (int) syscall (SYS_rename, old, new);
}

int
mkdir (const char *path, mode_t mode)
{
  return strikes () ? -1 : (int) syscall (SYS_mkdir, path, mode);
}
