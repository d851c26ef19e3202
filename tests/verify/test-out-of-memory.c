/* Every allocation of one whole cycle (read, override, detect, solve along the load path or by
 * limit analysis, write, read the result, check it, clear) fails once, alone and with all after
 * it: no crash, no leak (the sanitizers look), and either the answer or a refusal for want of
 * memory. Of the sequences of programs of non-associative limit analysis, every 29th. */
#include "core/path/analysis.h"
#include "io/result/result-check.h"
#include "io/text/io-error.h"
#include "support/failing-memory.h"

#include <glib.h>
#include <glib/gstdio.h>
#include <string.h>

/* Two blocks and a wall on a ground, so that walls, faces of several kinds and a path with
 * sliding and rocking are met. */
static const char text[] =
  "{ \"format\": \"quoin\", \"version\": 1, \"title\": \"t\",\n"
  "\"laws\": [ { \"name\": \"joint\", \"kind\": \"coulomb\", \"basis\": \"contact\",\n"
  "  \"kn\": 1e7, \"ks\": 1e7, \"friction\": 0.65 } ],\n"
  "\"blocks\": [ { \"name\": \"ground\", \"thickness\": 1, \"unit_weight\": 1e4,\n"
  "  \"vertices\": [[-1, -0.5], [2, -0.5], [2, 0], [-1, 0]],\n"
  "  \"support\": [true, true, true] } ],\n"
  "\"walls\": [ { \"name\": \"w\", \"origin\": [0, 0], \"unit\": [0.4, 0.2],\n"
  "  \"thickness\": 1, \"unit_weight\": 1e4, \"courses\": [[1, 0.5], [0.5, 1]] } ],\n"
  "\"contact\": { \"law\": \"joint\" },\n"
  "\"loads\": { \"dead\": [ { \"kind\": \"weight\", \"direction\": [0, -1] } ],\n"
  "  \"live\": [ { \"kind\": \"weight\", \"direction\": [1, 0] } ] },\n"
  "\"analysis\": { \"increments\": 4, \"multiplier_tolerance\": 0.01 } }\n";

/* Where the cycle writes its result. */
static char *result_path;

/* Overrides take the way through the tree of the document. */
static const char *const load_path[] = { "analysis.snap=jump", "view.zoom=[1, 2]",
                                         "laws[0].cohesion=0", NULL };
/* A post on a block of the wall, held by a hinged stay. */
static const char *const beams[] = {
  "sections=[{\"name\": \"s\", \"young\": 1e9, \"width\": 0.1, \"height\": 0.1,"
  " \"yield\": 1e7}]",
  "nodes=[{\"name\": \"foot\", \"block\": \"w.2.1\", \"side\": \"top\"},"
  " {\"name\": \"head\", \"at\": [0.1, 1]},"
  " {\"name\": \"far\", \"at\": [-1, 0], \"support\": [true, true, false]}]",
  "beams=[{\"name\": \"post\", \"nodes\": [\"foot\", \"head\"], \"section\": \"s\","
  " \"elements\": 2},"
  " {\"name\": \"stay\", \"nodes\": [\"head\", \"far\"], \"section\": \"s\","
  " \"hinges\": [true, true]}]",
  NULL
};
static const char *const limit[] = { "analysis.procedure=limit", NULL };
static const char *const fixed_points[] = { "analysis.procedure=limit",
                                            "analysis.flow=non-associative", NULL };

static bool
is_refusal (GError *error)
{
  g_assert_error (error, QN_IO_ERROR, QN_IO_ERROR_NO_MEMORY);
  g_error_free (error);
  return true;
}

/* Reads the written result and checks it without the solver; false where memory was refused. */
static bool
read_back (const QnProject *project, double multiplier)
{
  QnResultFile file;
  QnResultCheck check;
  GError *error = NULL;
  if (!qn_result_file_read (result_path, &file, &error))
    return !is_refusal (error);
  g_assert_cmpfloat (file.result.collapse_multiplier, ==, multiplier);
  bool checked = qn_result_check (&file, project, &check, &error) || !is_refusal (error);
  if (checked)
    g_assert_cmpfloat (check.out_of_balance, <, 1e-6);
  qn_result_file_clear (&file);
  return checked;
}

/* Detects, solves and writes; false where memory was refused. */
static bool
solve (const QnProject *project, QnContacts *contacts, QnResult *result)
{
  QnDiag diag = { 0 };
  GError *error = NULL;
  QnStatus status = qn_contacts_detect (&project->model, contacts, &diag);
  if (status == QN_OK)
    status = qn_contacts_require_sound (&project->model, contacts, &diag);
  if (status == QN_OK)
    status = qn_analysis_run (&project->model, contacts, NULL, NULL, result, &diag);
  if (status != QN_OK) {
    g_assert_cmpint (status, ==, QN_ERROR_NO_MEMORY);
    g_assert_cmpint (diag.problem, ==, QN_PROBLEM_NO_MEMORY);
    return false;
  }
  g_assert_cmpint (result->outcome, ==, QN_OUTCOME_COLLAPSE);
  return qn_result_file_write (result_path, project, contacts, result, &error)
         || !is_refusal (error);
}

/* What a cycle came to: the multiplier, or -1 where memory was refused. */
static double
run_cycle (const char *const *overrides)
{
  QnProject project = { 0 };
  QnContacts contacts = { 0 };
  QnResult result = { 0 };
  GError *error = NULL;

  if (!qn_project_parse (text, strlen (text), "wall.quoin", overrides, &project,
                         &error)) {
    is_refusal (error);
    return -1;
  }
  bool done = solve (&project, &contacts, &result)
              && read_back (&project, result.collapse_multiplier);
  double multiplier = done ? result.collapse_multiplier : -1;
  qn_result_clear (&result);
  qn_contacts_clear (&contacts);
  qn_project_clear (&project);
  return multiplier;
}

static void
fail_allocations (const char *const *overrides, bool onwards)
{
  /* The sequences of programs repeat the same ten thousand requests of the factorisation. */
  const long stride = overrides == fixed_points ? 29 : 1;
  double expected = run_cycle (overrides);
  g_assert_cmpfloat (expected, >, 0);

  long number = 0;
  for (bool hit = true; hit; number += stride) {
    failing_memory_arm (number, onwards);
    double found = run_cycle (overrides);
    hit = failing_memory_disarm ();
    if (found >= 0)
      g_assert_cmpfloat (found, ==, expected);
    if (onwards && hit)
      g_assert_cmpfloat (found, ==, -1);
  }
  g_test_message ("%ld allocations failed", number / stride - 1);
  g_assert_cmpint (number, >, 20);
}

static void
test_one_fails (gconstpointer overrides)
{
  fail_allocations (overrides, false);
}

static void
test_all_fail_from_one_on (gconstpointer overrides)
{
  fail_allocations (overrides, true);
}

int
main (int argc, char **argv)
{
  g_test_init (&argc, &argv, NULL);
  g_test_add_data_func ("/verify/out-of-memory/path/one", load_path, test_one_fails);
  g_test_add_data_func ("/verify/out-of-memory/path/onwards", load_path,
                        test_all_fail_from_one_on);
  g_test_add_data_func ("/verify/out-of-memory/beams/one", beams, test_one_fails);
  g_test_add_data_func ("/verify/out-of-memory/beams/onwards", beams,
                        test_all_fail_from_one_on);
  g_test_add_data_func ("/verify/out-of-memory/limit/one", limit, test_one_fails);
  g_test_add_data_func ("/verify/out-of-memory/limit/onwards", limit,
                        test_all_fail_from_one_on);
  g_test_add_data_func ("/verify/out-of-memory/fixed-points/one", fixed_points,
                        test_one_fails);
  g_test_add_data_func ("/verify/out-of-memory/fixed-points/onwards", fixed_points,
                        test_all_fail_from_one_on);
  GError *error = NULL;
  g_autofree char *folder = g_dir_make_tmp ("quoin-XXXXXX", &error);
  g_assert_no_error (error);
  result_path = g_build_filename (folder, "result.json", NULL);
  int failed = g_test_run ();
  g_remove (result_path);
  g_rmdir (folder);
  g_free (result_path);
  return failed;
}
