#include "disk/whole-file.h"

#include <errno.h>
#include <fcntl.h>
#include <glib.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

/* A long name leaves no room for the suffix in the file system's limit of 255 bytes. */
#define LONGEST_BASE 200

#define MOST_NAMES 100

/* Links one behind the other, as the system follows them. */
#define MOST_LINKS 40

/* Finds a name beside the target that `take` can have. */
static int
take_name (QnWholeFile *file, int (*take) (QnWholeFile *file, const char *name))
{
  g_autofree char *folder = g_path_get_dirname (file->target);
  g_autofree char *base = g_path_get_basename (file->target);
  int trouble = EEXIST;

  for (int attempt = 0; attempt < MOST_NAMES && trouble == EEXIST; attempt++) {
    /* Six digits that no other writer is likely to choose: the time, in other bits the process. */
    struct timespec now;
    clock_gettime (CLOCK_MONOTONIC, &now);
    unsigned digits =
      (unsigned) now.tv_nsec ^ (unsigned) (getpid () << 8) ^ (unsigned) attempt;
    g_autofree char *name =
      g_strdup_printf ("%s/.%.*s.%06x", folder, LONGEST_BASE, base, digits & 0xffffff);
    trouble = take (file, name) == 0 ? 0 : errno;
    if (trouble == 0)
      file->temporary = g_steal_pointer (&name);
  }
  return trouble;
}

static int
create (QnWholeFile *file, const char *name)
{
  file->fd = open (name, O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  return file->fd >= 0 ? 0 : -1;
}

/* Gives the file without a name this one; fails where the name is taken. */
static int
give_name (QnWholeFile *file, const char *name)
{
  char descriptor[40];
  snprintf (descriptor, sizeof descriptor, "/proc/self/fd/%d", file->fd);
  return linkat (AT_FDCWD, descriptor, AT_FDCWD, name, AT_SYMLINK_FOLLOW);
}

/* Opens a file without a name in the target's folder; EOPNOTSUPP where there are none. */
static int
open_nameless (QnWholeFile *file)
{
  int trouble = EOPNOTSUPP;
#ifdef O_TMPFILE
  g_autofree char *folder = g_path_get_dirname (file->target);
  /* Without /proc it could not be given its name. */
  if (access ("/proc/self/fd", X_OK) == 0) {
    file->fd = open (folder, O_RDWR | O_TMPFILE | O_CLOEXEC, 0666);
    trouble = file->fd >= 0 ? 0 : errno;
  }
  /* How systems that do not know of such files take the request. */
  if (trouble == EISDIR || trouble == EINVAL || trouble == ENOENT)
    trouble = EOPNOTSUPP;
#endif
  return trouble;
}

/* Where a file that is not there yet is to be: where links that lead to nothing point. NULL with an
 * errno. */
static char *
follow_links (const char *path)
{
  char *at = g_strdup (path);
  struct stat status;
  for (int links = 0; lstat (at, &status) == 0 && S_ISLNK (status.st_mode); links++) {
    g_autofree char *link = at;
    g_autofree char *folder = g_path_get_dirname (link);
    g_autofree char *to = links < MOST_LINKS ? g_file_read_link (link, NULL) : NULL;
    if (to == NULL) {
      errno = ELOOP;
      return NULL;
    }
    at = g_path_is_absolute (to) ? g_steal_pointer (&to)
                                 : g_build_filename (folder, to, NULL);
  }
  return at;
}

static int
open_target (QnWholeFile *file, const char *path)
{
  struct stat status;
  bool exists = stat (path, &status) == 0;

  if (exists && S_ISDIR (status.st_mode))
    return EISDIR;
  if (exists && !S_ISREG (status.st_mode)) {
    file->fd = open (path, O_WRONLY | O_CLOEXEC);
    return file->fd >= 0 ? 0 : errno;
  }
  /* Renaming over a write-protected file would succeed, but the file must not be replaced. */
  if (exists && access (path, W_OK) != 0)
    return errno;
  file->target = exists ? realpath (path, NULL) : follow_links (path);
  if (file->target == NULL)
    return errno;
  const struct stat *existing = exists ? &status : NULL;
  int trouble = open_nameless (file);

  if (trouble == EOPNOTSUPP)
    trouble = take_name (file, create);
  /* Where the mode cannot be carried over, the new file has that of a new file. */
  if (trouble == 0 && existing != NULL)
    (void) !fchmod (file->fd, existing->st_mode & 07777);
  return trouble;
}

static void
clear (QnWholeFile *file)
{
  g_free (file->target); /* of realpath() or GLib, which has its memory from malloc() */
  g_free (file->temporary);
  *file = (QnWholeFile){ .fd = -1 };
}

int
qn_whole_file_open (QnWholeFile *file, const char *path)
{
  int trouble = 0;

  *file = (QnWholeFile){ .fd = -1 };
  if (strcmp (path, "-") == 0)
    file->fd = STDOUT_FILENO;
  else
    trouble = open_target (file, path);
  if (trouble != 0)
    clear (file);
  return trouble;
}

int
qn_whole_file_write (const QnWholeFile *file, const void *bytes, size_t length)
{
  const char *at = bytes;

  while (length > 0) {
    ssize_t count = write (file->fd, at, length);
    if (count >= 0) {
      at += count;
      length -= (size_t) count;
    } else if (errno != EINTR) {
      return errno;
    }
  }
  return 0;
}

static int
close_descriptor (QnWholeFile *file)
{
  return file->fd == STDOUT_FILENO || close (file->fd) == 0 ? 0 : errno;
}

/* A target that does not exist gets its bytes in one stroke; one that does is exchanged. */
static int
put_in_place (QnWholeFile *file, bool *placed)
{
  if (file->temporary != NULL)
    return 0;
  *placed = give_name (file, file->target) == 0;
  if (*placed)
    return 0;
  return errno == EEXIST ? take_name (file, give_name) : errno;
}

int
qn_whole_file_commit (QnWholeFile *file)
{
  bool placed = file->target == NULL;
  int trouble = 0, closing;

  if (file->target != NULL && fsync (file->fd) != 0)
    trouble = errno;
  if (trouble == 0 && file->target != NULL)
    trouble = put_in_place (file, &placed);
  closing = close_descriptor (file);
  if (trouble == 0)
    trouble = closing;
  if (trouble == 0 && !placed && rename (file->temporary, file->target) != 0)
    trouble = errno;
  if (trouble != 0 && file->target != NULL && placed)
    unlink (file->target); /* there was none before */
  if (trouble != 0 && file->temporary != NULL)
    unlink (file->temporary);
  clear (file);
  return trouble;
}

void
qn_whole_file_discard (QnWholeFile *file)
{
  if (file->fd >= 0)
    close_descriptor (file);
  if (file->temporary != NULL)
    unlink (file->temporary);
  clear (file);
}

int
qn_whole_file_replace (const char *path, const void *bytes, size_t length)
{
  QnWholeFile file;
  int trouble = qn_whole_file_open (&file, path);

  if (trouble != 0)
    return trouble;
  trouble = qn_whole_file_write (&file, bytes, length);
  if (trouble == 0)
    return qn_whole_file_commit (&file);
  qn_whole_file_discard (&file);
  return trouble;
}
