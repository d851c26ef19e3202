/* Processor time of limit analysis against Clp and the load path, on solid walls in running bond.
 *
 *   bench-limit [--path] [--alone] [--seconds N] [--check RATIO] BLOCKS…
 *
 * --check RATIO fails unless the multipliers agree to 1e-6 and Clp's best takes RATIO times as
 * long as Quoin. Methods of Clp that do not end within --seconds (300) count with that time. */
#include "bench/clp-limit.h"
#include "core/analysis.h"
#include "core/generate.h"
#include "core/limit.h"

#include <glib.h>
#include <locale.h>
#include <math.h>
#include <stdio.h>

static gboolean follow_path, alone;
static double most_seconds = 300;
static double required_ratio;

/* About `blocks` blocks, as wide as high. */
static void
build_wall (int blocks, QnModel *model, QnContacts *contacts)
{
  QnWallRecipe recipe = qn_wall_recipe_default ();
  recipe.length = (int32_t) lround (sqrt (blocks * recipe.unit.y / recipe.unit.x));
  recipe.courses = (int32_t) lround ((double) blocks / (recipe.length + 0.5));
  recipe.openings = 0;
  qn_model_init (model);
  g_assert_cmpint (qn_generate_wall (model, &recipe, NULL), ==, QN_OK);
  g_assert_cmpint (qn_model_prepare (model, NULL), ==, QN_OK);
  g_assert_cmpint (qn_contacts_detect (model, contacts, NULL), ==, QN_OK);
}

static double
run_clp (const QnModel *model, const QnContacts *contacts, double expected, gboolean *ok)
{
  QnLimitProblem limit;
  double best = INFINITY;

  g_assert_cmpint (qn_limit_problem_init (&limit, model, contacts, false, NULL), ==,
                   QN_OK);
  for (int method = 0; method < CLP_METHOD_COUNT; method++) {
    double spent;
    double found = clp_limit_solve (&limit, (ClpMethod) method, most_seconds, &spent);
    printf ("  Clp %-15s %10.8f %10.3f s\n", clp_method_name ((ClpMethod) method), found,
            spent);
    fflush (stdout);
    best = fmin (best, isnan (found) ? fmax (spent, most_seconds) : spent);
    if (isfinite (found) && fabs (found - expected) > 1e-6)
      *ok = FALSE;
  }
  qn_limit_problem_clear (&limit);
  return best;
}

static gboolean
run (int blocks)
{
  QnModel model;
  QnContacts contacts;
  QnLimitSolution solution;
  gboolean ok = TRUE;

  build_wall (blocks, &model, &contacts);
  double start = cpu_seconds ();
  g_assert_cmpint (qn_limit_associative (&model, &contacts, NULL, NULL, &solution, NULL),
                   ==, QN_OK);
  double ours = cpu_seconds () - start;
  printf ("%zu blocks, %zu faces\n  Quoin %-13s %10.8f %10.3f s (%d factorisations, gap "
          "%.1e)\n",
          model.block_count - 1, contacts.face_count, "limit", solution.lower_bound, ours,
          solution.effort.factorizations, solution.check.gap);
  fflush (stdout);
  ok = fabs (solution.upper_bound - solution.lower_bound) <= 1e-6;

  if (follow_path) {
    QnResult result;
    double begin = cpu_seconds ();
    model.analysis.procedure = QN_PROCEDURE_LOAD;
    g_assert_cmpint (qn_analysis_run (&model, &contacts, NULL, NULL, &result, NULL), ==,
                     QN_OK);
    printf ("  Quoin %-13s %10.8f %10.3f s (%d factorisations)\n", "path",
            result.collapse_multiplier, cpu_seconds () - begin,
            result.statistics.factorizations);
    qn_result_clear (&result);
  }
  if (!alone) {
    double best = run_clp (&model, &contacts, solution.lower_bound, &ok);
    printf ("  ratio %.1f%s\n", best / ours, ok ? "" : ", multipliers differ");
    ok = ok && (required_ratio == 0 || best >= required_ratio * ours);
  }
  qn_limit_solution_clear (&solution);
  qn_contacts_clear (&contacts);
  qn_model_clear (&model);
  return ok;
}

int
main (int argc, char **argv)
{
  const GOptionEntry entries[] = {
    { "path", 0, 0, G_OPTION_ARG_NONE, &follow_path, "Follow the load path as well",
      NULL },
    { "alone", 0, 0, G_OPTION_ARG_NONE, &alone, "Leave Clp out", NULL },
    { "seconds", 0, 0, G_OPTION_ARG_DOUBLE, &most_seconds, "Time for each method of Clp",
      "N" },
    { "check", 0, 0, G_OPTION_ARG_DOUBLE, &required_ratio, "Fail below this ratio",
      "RATIO" },
    G_OPTION_ENTRY_NULL,
  };
  g_autoptr (GOptionContext) context = g_option_context_new ("BLOCKS…");
  g_autoptr (GError) error = NULL;
  gboolean ok = TRUE;

  setlocale (LC_ALL, "C");
  g_option_context_add_main_entries (context, entries, NULL);
  if (!g_option_context_parse (context, &argc, &argv, &error)) {
    fprintf (stderr, "bench-limit: %s\n", error->message);
    return 2;
  }
  for (int i = 1; i < argc; i++)
    ok = run ((int) g_ascii_strtoll (argv[i], NULL, 10)) && ok;
  return ok ? 0 : 1;
}
