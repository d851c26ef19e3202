/* Does the answer depend on what must not matter? In linear geometry the multipliers of a wall are the
 * same whatever its increments, tolerance, joint stiffness, the order of its blocks and the direction in
 * which it stands. Seeded walls (support/walls.h), each with one of these changed at a time.
 *
 *   bench-variations [--seeds FIRST-LAST] [--least N] [--most N] [--variations NAMES]
 *                    [--factorizations N]
 *
 * One line for each wall and variation, then one for each wall: how far apart collapse multipliers and
 * first limit points are, as parts of the least one. The program fails where a path does not end in
 * collapse (or under the dead load), where collapse multipliers differ by more than 1 % or first limit points by more than 2 %,
 * where only some variations have a first limit point, or where all paths together take more than the
 * given number of factorisations. NAMES are separated by commas: see the table below. */
#include "bench/bench.h"
#include "core/path/analysis.h"
#include "support/models.h"
#include "support/walls.h"

#include <locale.h>
#include <math.h>

#define MOST_COLLAPSE    0.01
#define MOST_FIRST_LIMIT 0.02

/* The wall is turned by so much, rad. */
#define TURN 2.4

typedef enum { INCREMENTS, TOLERANCE, STIFFNESS, ORDER, TURNED } Subject;

static const struct {
  const char *name;
  Subject subject;
  double value;
} variations[] = {
  { "increments=10", INCREMENTS, 10 },
  { "increments=5", INCREMENTS, 5 },
  { "increments=14", INCREMENTS, 14 },
  { "increments=37", INCREMENTS, 37 },
  { "increments=100", INCREMENTS, 100 },
  { "increments=500", INCREMENTS, 500 },
  { "tolerance=1e-4", TOLERANCE, 1e-4 },
  { "tolerance=1e-5", TOLERANCE, 1e-5 },
  { "kn=1e5", STIFFNESS, 1e5 },
  { "kn=1e6", STIFFNESS, 1e6 },
  { "kn=1e7", STIFFNESS, 1e7 },
  { "kn=1e9", STIFFNESS, 1e9 },
  { "order", ORDER, 1 },
  { "turned", TURNED, TURN },
};

typedef struct Options {
  int first_seed, last_seed, least, most, factorizations;
  char **names; /* NULL: all */
} Options;

/* A wall that falls under its dead load has 0. */
typedef struct Spread {
  double least, most;
  int given, missing;
} Spread;

static const Spread no_spread = { .least = INFINITY };

static void
spread_add (Spread *spread, gboolean given, double value)
{
  spread->missing += !given;
  spread->given += given;
  if (given) {
    spread->least = fmin (spread->least, value);
    spread->most = fmax (spread->most, value);
  }
}

static double
spread_size (const Spread *spread)
{
  return spread->given > 0 && spread->most > 0 ? spread->most / spread->least - 1 : 0;
}

static void
shuffle (QnModel *model, guint32 seed)
{
  g_autoptr (GRand) rand = g_rand_new_with_seed (seed);

  for (size_t i = model->block_count - 1; i > 0; i--) {
    size_t other = (size_t) g_rand_int_range (rand, 0, (gint32) i + 1);
    QnBlock block = model->blocks[i];
    model->blocks[i] = model->blocks[other];
    model->blocks[other] = block;
  }
}

static void
vary (QnModel *model, gsize which, guint32 seed)
{
  double value = variations[which].value;

  switch (variations[which].subject) {
  case INCREMENTS:
    model->analysis.increments = (int32_t) value;
    break;
  case TOLERANCE:
    model->analysis.multiplier_tolerance = value;
    break;
  case STIFFNESS:
    model->laws[0].kn = model->laws[0].ks = value;
    break;
  case ORDER:
    shuffle (model, seed);
    break;
  case TURNED:
    test_model_rotate (model, value);
    break;
  }
  g_assert_cmpint (qn_model_prepare (model, NULL), ==, QN_OK);
}

static gboolean
is_wanted (const Options *options, gsize which)
{
  return options->names == NULL
         || g_strv_contains ((const char *const *) options->names,
                             variations[which].name);
}

static void
solve (guint32 seed, gsize which, const Options *options, QnResult *result,
       size_t *blocks)
{
  g_auto (QnModel) model;
  g_auto (QnContacts) contacts;

  test_wall_draw_sized (&model, seed, options->least, options->most);
  vary (&model, which, seed);
  g_assert_cmpint (qn_contacts_detect (&model, &contacts, NULL), ==, QN_OK);
  g_assert_cmpint (qn_analysis_run (&model, &contacts, NULL, NULL, result, NULL), ==,
                   QN_OK);
  *blocks = model.block_count;
}

static char *
multiplier_text (bool given, double multiplier)
{
  return given ? g_strdup_printf ("%.5f", multiplier) : g_strdup ("");
}

/* All variations of one wall; returns whether they agree. */
static gboolean
run (FILE *csv, guint32 seed, const Options *options, int *factorizations)
{
  Spread collapse = no_spread, first = no_spread;
  const char *family = test_wall_family (seed);

  for (gsize i = 0; i < G_N_ELEMENTS (variations); i++) {
    QnResult result;
    size_t blocks;
    if (!is_wanted (options, i))
      continue;
    solve (seed, i, options, &result, &blocks);
    g_autofree char *limit =
      multiplier_text (result.has_first_limit_multiplier, result.first_limit_multiplier);
    g_autofree char *multiplier =
      multiplier_text (result.has_collapse_multiplier, result.collapse_multiplier);
    bench_csv_row (csv, "%u,%s,%zu,%s,%s,%s,%s,%s,%d", seed, family, blocks,
                   variations[i].name, qn_outcome_names[result.outcome], multiplier,
                   limit, result.mechanism_uncertain ? "yes" : "no",
                   result.statistics.factorizations);
    bool falls = result.outcome == QN_OUTCOME_DEAD_LOAD_UNSTABLE;
    spread_add (&collapse, falls || result.outcome == QN_OUTCOME_COLLAPSE,
                falls ? 0 : result.collapse_multiplier);
    spread_add (&first, result.has_first_limit_multiplier, result.first_limit_multiplier);
    *factorizations += result.statistics.factorizations;
    qn_result_clear (&result);
  }
  gboolean agree = collapse.missing == 0 && spread_size (&collapse) <= MOST_COLLAPSE
                   && (first.given == 0 || first.missing == 0)
                   && spread_size (&first) <= MOST_FIRST_LIMIT;
  printf ("# %s %u (%s): collapse %.2f %% apart, %d without; first limit points %.2f %%, "
          "%d with, %d without\n",
          agree ? "wall" : "WALL", seed, family, 100 * spread_size (&collapse),
          collapse.missing, 100 * spread_size (&first), first.given, first.missing);
  fflush (stdout);
  return agree;
}

static gboolean
parse (int *argc, char ***argv, Options *options, GError **error)
{
  g_autofree char *seeds = NULL, *names = NULL;
  const GOptionEntry entries[] = {
    { "seeds", 0, 0, G_OPTION_ARG_STRING, &seeds, "Which walls (1-20)", "FIRST-LAST" },
    { "least", 0, 0, G_OPTION_ARG_INT, &options->least, "Fewest blocks (100)", "N" },
    { "most", 0, 0, G_OPTION_ARG_INT, &options->most, "Most blocks (500)", "N" },
    { "variations", 0, 0, G_OPTION_ARG_STRING, &names, "Which variations (all)",
      "NAMES" },
    { "factorizations", 0, 0, G_OPTION_ARG_INT, &options->factorizations,
      "Most of all paths together", "N" },
    G_OPTION_ENTRY_NULL,
  };
  g_autoptr (GOptionContext) context = g_option_context_new (NULL);
  g_option_context_add_main_entries (context, entries, NULL);
  if (!g_option_context_parse (context, argc, argv, error))
    return FALSE;
  if (names != NULL)
    options->names = g_strsplit (names, ",", -1);
  if ((seeds != NULL
       && !test_wall_parse_seeds (seeds, &options->first_seed, &options->last_seed))
      || options->least < 10 || options->most < options->least) {
    g_set_error (error, G_OPTION_ERROR, G_OPTION_ERROR_BAD_VALUE,
                 "seeds from 1, sizes from 10");
    return FALSE;
  }
  return TRUE;
}

int
main (int argc, char **argv)
{
  Options options = { .first_seed = 1,
                      .last_seed = 20,
                      .least = 100,
                      .most = 500,
                      .factorizations = G_MAXINT };
  int differ = 0, factorizations = 0;
  g_autoptr (GError) error = NULL;

  setlocale (LC_ALL, "C.UTF-8");
  if (!parse (&argc, &argv, &options, &error)) {
    fprintf (stderr, "bench-variations: %s\n", error->message);
    return 2;
  }
  FILE *csv = bench_csv_open (
    "variations",
    "seed,family,blocks,variation,outcome,collapse,first limit,uncertain,factorisations");
  for (int seed = options.first_seed; seed <= options.last_seed; seed++)
    differ += !run (csv, (guint32) seed, &options, &factorizations);
  fclose (csv);
  printf ("%d of %d walls differ; %d factorisations\n", differ,
          options.last_seed - options.first_seed + 1, factorizations);
  g_strfreev (options.names);
  return differ == 0 && factorizations <= options.factorizations ? 0 : 1;
}
