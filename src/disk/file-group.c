#include "disk/file-group.h"

#include <errno.h>
#include <fcntl.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

/* Name of the hidden folder, and as mkdtemp() takes it. */
#define PREFIX  ".gather."
#define PATTERN PREFIX "XXXXXX"

static void
clear_group (QnFileGroup *group)
{
  g_free (group->folder);
  g_free (group->hidden);
  g_ptr_array_unref (group->names);
  *group = (QnFileGroup){ 0 };
}

/* Makes the hidden folder and locks it, which tells others that it is in use. */
static int
make_hidden (QnFileGroup *group)
{
  struct stat status;

  do {
    g_free (group->hidden);
    group->hidden = g_build_filename (group->folder, PATTERN, NULL);
    if (mkdtemp (group->hidden) == NULL)
      return errno;
    group->lock = open (group->hidden, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (group->lock < 0) {
      int trouble = errno;
      rmdir (group->hidden);
      return trouble;
    }
    (void) !flock (group->lock,
                   LOCK_EX | LOCK_NB); /* no matter where there are no locks */
    /* Another writer may have taken it for one that was left, before the lock. */
  } while (fstat (group->lock, &status) == 0 && status.st_nlink == 0
           && close (group->lock) == 0);
  return 0;
}

/* Removes a hidden folder whose writer is no more: nobody holds its lock. */
static void
remove_left (const char *path)
{
  int lock = open (path, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  g_autoptr (GDir) left =
    lock >= 0 && flock (lock, LOCK_EX | LOCK_NB) == 0 ? g_dir_open (path, 0, NULL) : NULL;

  for (const char *name; left != NULL && (name = g_dir_read_name (left)) != NULL;)
    (void) !unlinkat (lock, name, 0);
  if (left != NULL)
    (void) !rmdir (path);
  if (lock >= 0)
    close (lock);
}

/* A program that was killed leaves its hidden folder: the next one in the same place removes it. */
static void
remove_all_left (const char *folder)
{
  g_autoptr (GDir) entries = g_dir_open (folder, 0, NULL);

  for (const char *name; entries != NULL && (name = g_dir_read_name (entries)) != NULL;)
    if (g_str_has_prefix (name, PREFIX) && strlen (name) == strlen (PATTERN)) {
      g_autofree char *path = g_build_filename (folder, name, NULL);
      remove_left (path);
    }
}

int
qn_file_group_open (QnFileGroup *group, const char *folder)
{
  *group = (QnFileGroup){ .folder = g_strdup (folder[0] != '\0' ? folder : "."),
                          .names = g_ptr_array_new_with_free_func (g_free),
                          .lock = -1 };
  remove_all_left (group->folder);
  int trouble = make_hidden (group);
  if (trouble != 0)
    clear_group (group);
  return trouble;
}

int
qn_file_group_add (QnFileGroup *group, const char *name, char **path)
{
  g_autofree char *place = g_build_filename (group->folder, name, NULL);
  struct stat status;

  *path = NULL;
  if (stat (place, &status) == 0 && S_ISDIR (status.st_mode))
    return EISDIR;
  if (access (place, W_OK) != 0 && errno != ENOENT)
    return errno;
  g_ptr_array_add (group->names, g_strdup (name));
  *path = g_build_filename (group->hidden, name, NULL);
  return 0;
}

/* Lets a file and what stands in its place change places. */
static int
exchange (const QnFileGroup *group, const char *name)
{
  g_autofree char *from = g_build_filename (group->hidden, name, NULL);
  g_autofree char *to = g_build_filename (group->folder, name, NULL);
  bool exists = access (to, F_OK) == 0;

  if (exists && renameat2 (AT_FDCWD, from, AT_FDCWD, to, RENAME_EXCHANGE) == 0)
    return 0;
  /* Some file systems cannot; there the old file is gone. */
  if (exists && errno != EINVAL && errno != ENOSYS)
    return errno;
  return rename (from, to) == 0 ? 0 : errno;
}

void
qn_file_group_discard (QnFileGroup *group)
{
  if (group->names == NULL) /* has been discarded */
    return;
  for (guint i = 0; i < group->names->len; i++) {
    g_autofree char *path =
      g_build_filename (group->hidden, group->names->pdata[i], NULL);
    unlink (path); /* may not be there */
  }
  rmdir (group->hidden);
  close (group->lock);
  clear_group (group);
}

int
qn_file_group_commit (QnFileGroup *group)
{
  guint done = 0;
  int trouble = 0;

  while (done < group->names->len && trouble == 0) {
    trouble = exchange (group, group->names->pdata[done]);
    if (trouble == 0)
      done++;
  }
  while (trouble != 0 && done > 0) {
    /* Reverses an exchange; a file that replaced no other moves back. */
    const char *name = group->names->pdata[--done];
    g_autofree char *from = g_build_filename (group->hidden, name, NULL);
    g_autofree char *to = g_build_filename (group->folder, name, NULL);

    if (access (from, F_OK) == 0)
      (void) !rename (from, to);
    else
      unlink (to);
  }
  qn_file_group_discard (group);
  return trouble;
}
