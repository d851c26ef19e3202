/* A file that is replaced as a whole or not at all.
 *
 * Bytes go to a file without a name in the target's folder, which takes the target's place when
 * everything is on the disk. Until then a full disk, a kill or a power cut leaves the target as
 * it was and no trace in the folder: the system forgets a file without a name with the program
 * that writes it. Where the file system has no such files, and for the moment in which an existing
 * target is exchanged, the bytes bear the name ".TARGET.XXXXXX" beside it.
 *
 * Three targets are written directly, because replacing them would be wrong: "-" (standard
 * output), devices and pipes. The target of a symbolic link is replaced or, where there is none
 * yet, made, not the link; the mode of an existing file is carried over.
 *
 * All functions return 0 or the errno of what failed.
 */
#pragma once

#include <stddef.h>

typedef struct QnWholeFile {
  int fd;          /* to write to */
  char *target;    /* NULL where it is written directly */
  char *temporary; /* NULL as long as the bytes have no name */
} QnWholeFile;

/* Refuses folders (EISDIR) and what is write-protected. On failure there is nothing to close. */
int qn_whole_file_open (QnWholeFile *file, const char *path);

/* Appends all of the bytes, however many calls of the system that takes. */
int qn_whole_file_write (const QnWholeFile *file, const void *bytes, size_t length);

/* Puts the bytes in their place and closes; on failure the target is as it was before. */
int qn_whole_file_commit (QnWholeFile *file);

/* Closes and leaves the target as it was before. */
void qn_whole_file_discard (QnWholeFile *file);

/* All of it at once. */
int qn_whole_file_replace (const char *path, const void *bytes, size_t length);
