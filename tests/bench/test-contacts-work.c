/* How the work of contact detection grows with the number of blocks, in instructions as callgrind
 * counts them: unlike times (bench-contacts) they are the same however busy the machine is.
 *
 *   test-contacts-work --detect KIND BLOCKS
 *
 * builds one structure and finds its contacts once: what runs under callgrind. */
#include "bench/scaling-case.h"
#include "support/models.h"

#include <glib/gstdio.h>
#include <locale.h>
#include <math.h>
#include <stdio.h>

/* Growth exponent that is demanded of the time too. */
#define MOST_GROWTH 1.1

static const char *self;

static int
detect (const char *kind, int blocks)
{
  ScalingCase c;
  scaling_case_init (&c, blocks, !g_str_equal (kind, "wall"));
  if (g_str_equal (kind, "turned-facade"))
    test_model_rotate (&c.model, 1);
  g_assert_cmpint (qn_model_prepare (&c.model, NULL), ==, QN_OK);
  scaling_case_detect (&c);
  printf ("blocks: %zu\n", c.blocks);
  scaling_case_clear (&c);
  return 0;
}

/* The number that follows a word at the beginning of a line. */
static double
number_after (const char *text, const char *word)
{
  g_autofree char *pattern = g_strdup_printf ("(?m)^%s: *(\\d+)", word);
  g_autoptr (GRegex) regex = g_regex_new (pattern, 0, 0, NULL);
  g_autoptr (GMatchInfo) match = NULL;
  g_assert_true (g_regex_match (regex, text, 0, &match));
  g_autofree char *digits = g_match_info_fetch (match, 1);
  return g_ascii_strtod (digits, NULL);
}

/* Blocks, and instructions within qn_contacts_detect. */
static void
count_work (const char *valgrind, const char *kind, int asked, double *blocks,
            double *instructions)
{
  g_autofree char *folder = g_dir_make_tmp ("quoin-work-XXXXXX", NULL);
  g_autofree char *path = g_build_filename (folder, "callgrind.out", NULL);
  g_autofree char *out_file = g_strconcat ("--callgrind-out-file=", path, NULL);
  g_autofree char *number = g_strdup_printf ("%d", asked);
  const char *arguments[] = {
    valgrind, "--quiet", "--tool=callgrind", "--toggle-collect=qn_contacts_detect",
    out_file, self,      "--detect",         kind,
    number,   NULL
  };
  g_autofree char *said = NULL, *counted = NULL;
  g_autoptr (GError) error = NULL;
  int status;
  g_spawn_sync (NULL, (char **) arguments, NULL, G_SPAWN_DEFAULT, NULL, NULL, &said, NULL,
                &status, &error);
  g_assert_no_error (error);
  g_spawn_check_wait_status (status, &error);
  g_assert_no_error (error);
  g_file_get_contents (path, &counted, NULL, &error);
  g_assert_no_error (error);
  *blocks = number_after (said, "blocks");
  *instructions = number_after (counted, "totals");
  g_remove (path);
  g_rmdir (folder);
}

static void
test_growth (gconstpointer data)
{
  const char *kind = data;
  g_autofree char *valgrind = g_find_program_in_path ("valgrind");
  double blocks[2], instructions[2];
  if (valgrind == NULL) {
    g_test_skip ("valgrind is not installed");
    return;
  }
  count_work (valgrind, kind, 1000, &blocks[0], &instructions[0]);
  count_work (valgrind, kind, 25000, &blocks[1], &instructions[1]);
  double growth = log (instructions[1] / instructions[0]) / log (blocks[1] / blocks[0]);
  g_test_message ("%s: %.0f and %.0f instructions a block, exponent %.3f", kind,
                  instructions[0] / blocks[0], instructions[1] / blocks[1], growth);
  g_assert_cmpfloat (instructions[0], >, 100 * blocks[0]); /* something was counted */
  g_assert_cmpfloat (growth, <=, MOST_GROWTH);
}

int
main (int argc, char **argv)
{
  static const char *const kinds[] = { "wall", "facade", "turned-facade" };
  if (argc == 4 && g_str_equal (argv[1], "--detect"))
    return detect (argv[2], (int) g_ascii_strtoll (argv[3], NULL, 10));
  setlocale (LC_ALL, "C.UTF-8");
  self = argv[0];
  g_test_init (&argc, &argv, NULL);
  for (size_t i = 0; i < G_N_ELEMENTS (kinds); i++) {
    g_autofree char *path = g_strconcat ("/bench/contacts-work/", kinds[i], NULL);
    g_test_add_data_func (path, kinds[i], test_growth);
  }
  return g_test_run ();
}
