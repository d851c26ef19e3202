/* Runs a fuzz target without libFuzzer: every file of the corpus as it is, and a fixed number
 * of changes to it, the same in every run.
 *
 *   fuzz-project FOLDER [CHANGES [numbers]]      or      fuzz-project FILE
 */
#include "fuzz.h"
#include "numbers.h"
#include "pieces.h"

#include <glib.h>
#include <stdio.h>
#include <stdlib.h>

/* Another number in the place of one that is there, or a piece of the text moved. */
static void
mutate_text (GByteArray *bytes, GRand *random, gboolean numbers)
{
  guint size = bytes->len;
  guint seed = g_rand_int (random);
  g_byte_array_set_size (bytes, 2 * size + 40); /* room for a number and any piece */
  gsize changed =
    numbers ? fuzz_mutate_number (bytes->data, size, bytes->len, seed)
            : fuzz_splice_piece (bytes->data, size, bytes->len, bytes->data, size, seed);
  g_byte_array_set_size (bytes, changed > 0 ? (guint) changed : size);
}

/* One random change to the bytes: another byte, a hole, a piece twice, or an early end. */
static void
mutate (GByteArray *bytes, GRand *random)
{
  if (bytes->len == 0)
    return;
  guint at = (guint) g_rand_int_range (random, 0, (gint32) bytes->len);
  guint longest = bytes->len - at;
  guint length = (guint) g_rand_int_range (random, 1, 20); /* MIN() would draw twice */
  length = MIN (length, longest);
  switch (g_rand_int_range (random, 0, 5)) {
  case 0:
    bytes->data[at] = (guint8) g_rand_int (random);
    break;
  case 1:
    bytes->data[at] =
      (guint8) "{}[]\",:0123456789-+.eE\\"[g_rand_int_range (random, 0, 23)];
    break;
  case 2:
    g_byte_array_remove_range (bytes, at, length);
    break;
  case 3: {
    guint8 *piece = g_memdup2 (bytes->data + at, length);
    g_byte_array_append (bytes, piece, length);
    g_free (piece);
    break;
  }
  default:
    g_byte_array_set_size (bytes, at);
    break;
  }
}

static void
run_file (const char *path, int changes, gboolean numbers)
{
  char *content;
  gsize length;
  if (!g_file_get_contents (path, &content, &length, NULL)) {
    fprintf (stderr, "%s: cannot be read\n", path);
    exit (1);
  }
  LLVMFuzzerTestOneInput ((const uint8_t *) content, length);

  GRand *random = g_rand_new_with_seed ((guint32) length);
  for (int i = 0; i < changes; i++) {
    GByteArray *bytes = g_byte_array_new ();
    g_byte_array_append (bytes, (const guint8 *) content, (guint) length);
    /* Two times of three in numbers or pieces alone, so that text often stays well-formed. */
    for (int k = g_rand_int_range (random, 1, 4); k > 0; k--)
      if (i % 3 == 0 && numbers)
        mutate_text (bytes, random, TRUE);
      else if (i % 3 == 1)
        mutate_text (bytes, random, FALSE);
      else
        mutate (bytes, random);
    LLVMFuzzerTestOneInput (bytes->data, bytes->len);
    g_byte_array_unref (bytes);
  }
  g_rand_free (random);
  g_free (content);
}

int
main (int argc, char **argv)
{
  int changes = argc > 2 ? atoi (argv[2]) : 0;
  GDir *folder = argc > 1 ? g_dir_open (argv[1], 0, NULL) : NULL;
  if (argc < 2) {
    fprintf (stderr, "usage: %s FILE | FOLDER [CHANGES [numbers]]\n", argv[0]);
    return 2;
  }
  if (folder == NULL) {
    run_file (argv[1], changes, FALSE);
    return 0;
  }

  int files = 0;
  const char *name;
  while ((name = g_dir_read_name (folder)) != NULL) {
    char *path = g_build_filename (argv[1], name, NULL);
    run_file (path, changes, argc > 3);
    g_free (path);
    files++;
  }
  g_dir_close (folder);
  printf ("%d files, %d changes to each\n", files, changes);
  return files > 0 ? 0 : 1;
}
