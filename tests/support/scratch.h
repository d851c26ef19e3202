/* Folders for the files that a test makes. */
#pragma once

#include <glib.h>

/* A new empty folder; what must not fail fails the test. */
char *test_scratch_new (void);

/* Removes all that is in a folder; and the folder too, and frees the path. */
void test_scratch_empty (const char *folder);
void test_scratch_free (char *folder);

/* In front of a local variable: such a folder goes at the end of the block. */
#define test_autoscratch __attribute__ ((cleanup (test_scratch_clear)))
static inline void
test_scratch_clear (char **folder)
{
  test_scratch_free (*folder);
}

/* The path of a file that is not there yet, in such a folder: a fixture of g_test_add (). */
typedef struct TestScratchFile {
  char *folder, *path;
} TestScratchFile;

void test_scratch_file_set_up (TestScratchFile *file, gconstpointer data);
void test_scratch_file_tear_down (TestScratchFile *file, gconstpointer data);

/* Number of entries in a folder. */
guint test_scratch_count (const char *folder);

/* Fails unless the file is this text. */
void test_scratch_expect (const char *path, const char *text);
