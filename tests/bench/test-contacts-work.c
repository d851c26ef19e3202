/* How the work of contact detection grows with the number of blocks, in instructions as callgrind
 * counts them: unlike times (bench-contacts) they are the same however busy the machine is.
 *
 *   test-contacts-work --detect KIND BLOCKS
 *
 * builds one structure and finds its contacts once: what runs under callgrind. */
#include "bench/scaling-case.h"
#include "support/instructions.h"
#include "support/models.h"

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

/* Blocks, and instructions within qn_contacts_detect; FALSE where none can be counted here. */
static gboolean
count_work (const char *kind, int asked, double *blocks, double *instructions)
{
  g_autofree char *number = g_strdup_printf ("%d", asked);
  const char *const arguments[] = { self, "--detect", kind, number, NULL };
  g_autofree char *said = NULL;
  *instructions = count_instructions (arguments, "qn_contacts_detect", &said);
  if (*instructions == 0)
    return FALSE;
  *blocks = number_after (said, "blocks");
  return TRUE;
}

static void
test_growth (gconstpointer data)
{
  const char *kind = data;
  double blocks[2], instructions[2];
  if (!count_work (kind, 1000, &blocks[0], &instructions[0])) {
    g_test_skip ("instructions cannot be counted here");
    return;
  }
  count_work (kind, 25000, &blocks[1], &instructions[1]);
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
