#include "disk/file-group.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

/* Name of the hidden folder, as mkdtemp() takes it. */
#define PATTERN ".gather.XXXXXX"

static char *
join (const char *folder, const char *name)
{
  size_t room = strlen (folder) + strlen (name) + 2;
  char *path = malloc (room);
  if (path != NULL)
    snprintf (path, room, "%s/%s", folder, name);
  return path;
}

/* Makes the hidden folder and locks it, which tells others that it is in use. */
static int
make_hidden (QnFileGroup *group)
{
  char *name = group->hidden + strlen (group->hidden) - strlen (PATTERN);
  struct stat status;

  do {
    strcpy (name, PATTERN);
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
  DIR *left = lock >= 0 && flock (lock, LOCK_EX | LOCK_NB) == 0 ? fdopendir (lock) : NULL;

  if (left == NULL) {
    if (lock >= 0)
      close (lock);
    return;
  }
  for (struct dirent *entry = readdir (left); entry != NULL; entry = readdir (left))
    (void) !unlinkat (lock, entry->d_name, 0); /* "." and ".." are no files */
  (void) !rmdir (path);
  closedir (left);
}

/* A program that was killed leaves its hidden folder: the next one in the same place removes it. */
static void
remove_all_left (const char *folder)
{
  DIR *entries = opendir (folder);

  for (struct dirent *entry = entries != NULL ? readdir (entries) : NULL; entry != NULL;
       entry = readdir (entries)) {
    if (strlen (entry->d_name) != strlen (PATTERN)
        || strncmp (entry->d_name, PATTERN, strlen (PATTERN) - 6) != 0)
      continue;
    char *path = join (folder, entry->d_name);
    if (path != NULL)
      remove_left (path);
    free (path);
  }
  if (entries != NULL)
    closedir (entries);
}

int
qn_file_group_open (QnFileGroup *group, const char *folder)
{
  *group =
    (QnFileGroup){ .folder = strdup (folder[0] != '\0' ? folder : "."), .lock = -1 };
  group->hidden = group->folder != NULL ? join (group->folder, PATTERN) : NULL;
  if (group->hidden != NULL)
    remove_all_left (group->folder);
  int trouble = group->hidden != NULL ? make_hidden (group) : ENOMEM;
  if (trouble != 0) {
    free (group->folder);
    free (group->hidden);
    *group = (QnFileGroup){ 0 };
  }
  return trouble;
}

/* Why nothing may take this place. */
static int
refuse_place (const QnFileGroup *group, const char *name)
{
  struct stat status;
  char *place = join (group->folder, name);
  int trouble = 0;

  if (place == NULL)
    trouble = ENOMEM;
  else if (stat (place, &status) == 0 && S_ISDIR (status.st_mode))
    trouble = EISDIR;
  else if (access (place, W_OK) != 0 && errno != ENOENT)
    trouble = errno;
  free (place);
  return trouble;
}

int
qn_file_group_add (QnFileGroup *group, const char *name, char **path)
{
  int trouble = refuse_place (group, name);
  char **names = NULL;

  *path = NULL;
  if (trouble != 0)
    return trouble;
  names = realloc (group->names, (group->count + 1) * sizeof *names);
  if (names == NULL)
    return ENOMEM;
  group->names = names;
  names[group->count] = strdup (name);
  *path = names[group->count] != NULL ? join (group->hidden, name) : NULL;
  if (*path != NULL)
    group->count++;
  else
    free (names[group->count]);
  return *path != NULL ? 0 : ENOMEM;
}

/* Lets a file and what stands in its place change places. */
static int
exchange (const QnFileGroup *group, const char *name)
{
  char *from = join (group->hidden, name), *to = join (group->folder, name);
  int trouble = from != NULL && to != NULL ? 0 : ENOMEM;

  if (trouble == 0) {
    bool first = access (to, F_OK) != 0;
    if (first)
      trouble = rename (from, to) == 0 ? 0 : errno;
    else if (renameat2 (AT_FDCWD, from, AT_FDCWD, to, RENAME_EXCHANGE) != 0)
      trouble = errno;
    /* Some file systems cannot; there the old file is gone. */
    if (!first && (trouble == EINVAL || trouble == ENOSYS))
      trouble = rename (from, to) == 0 ? 0 : errno;
  }
  free (from);
  free (to);
  return trouble;
}

void
qn_file_group_discard (QnFileGroup *group)
{
  for (size_t i = 0; i < group->count; i++) {
    char *path = join (group->hidden, group->names[i]);
    if (path != NULL)
      unlink (path); /* may not be there */
    free (path);
    free (group->names[i]);
  }
  if (group->hidden != NULL) {
    rmdir (group->hidden);
    close (group->lock);
  }
  free (group->names);
  free (group->folder);
  free (group->hidden);
  *group = (QnFileGroup){ 0 };
}

int
qn_file_group_commit (QnFileGroup *group)
{
  size_t done = 0;
  int trouble = 0;

  while (done < group->count && trouble == 0) {
    trouble = exchange (group, group->names[done]);
    if (trouble == 0)
      done++;
  }
  while (trouble != 0 && done > 0) {
    /* Reverses an exchange; a file that replaced no other moves back. */
    const char *name = group->names[--done];
    char *from = join (group->hidden, name), *to = join (group->folder, name);

    if (from != NULL && to != NULL && access (from, F_OK) == 0)
      (void) !rename (from, to);
    else if (to != NULL)
      unlink (to);
    free (from);
    free (to);
  }
  qn_file_group_discard (group);
  return trouble;
}
