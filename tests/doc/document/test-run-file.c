#include "doc/document/document.h"

#include "doc/fixture.h"
#include "io/result/result-file.h"
#include "support/edit-model.h"
#include "support/room.h"

#include <glib/gstdio.h>
#include <string.h>

typedef struct Place {
  char *folder, *result, *project;
} Place;

static void
place_set_up (Place *place, gconstpointer data)
{
  (void) data;
  place->folder = g_dir_make_tmp ("quoin-XXXXXX", NULL);
  place->result = g_build_filename (place->folder, "kept.json", NULL);
  place->project = g_build_filename (place->folder, "wall.quoin", NULL);
}

static void
place_tear_down (Place *place, gconstpointer data)
{
  (void) data;
  g_unlink (place->result);
  g_unlink (place->project);
  g_rmdir (place->folder);
  g_free (place->folder);
  g_free (place->result);
  g_free (place->project);
}

static gboolean
edit_friction (QnModel *model, gpointer data, GError **error)
{
  (void) error;
  model->laws[0].friction = *(const double *) data;
  return TRUE;
}

static gboolean
change (QnDocument *document, double friction)
{
  return edit_model (document, "Friction", NULL, edit_friction, &friction, NULL);
}

/* Written, and read again by another document of the same file, a run is what it was. */
static void
test_round_trip (Place *place, gconstpointer data)
{
  (void) data;
  g_autoptr (QnDocument) document = open_example ("ferris-tin-loi/wall3.quoin");
  const QnRun *run = solve_example (document);
  g_autoptr (GError) error = NULL;
  g_assert_true (qn_document_write_result (document, run, place->result, &error));
  g_assert_no_error (error);

  g_assert_true (qn_is_result_file (place->result));
  g_assert_false (qn_is_result_file (document->path));
  g_assert_false (qn_is_result_file (place->folder));

  g_autoptr (QnDocument) again = open_example ("ferris-tin-loi/wall3.quoin");
  g_assert_true (qn_document_open_result (again, place->result, &error));
  g_assert_no_error (error);
  const QnRun *read = again->run;
  g_assert_cmpuint (again->runs->len, ==, 1);
  g_assert_cmpstr (read->name, ==, "kept.json");
  g_assert_false (qn_document_is_stale (again, read));
  g_assert_cmpfloat (read->result.collapse_multiplier, ==,
                     run->result.collapse_multiplier);
  g_assert_cmpuint (read->result.step_count, ==, run->result.step_count);
  g_assert_cmpuint (read->contacts.face_count, ==, run->contacts.face_count);
  g_assert_nonnull (read->result.mechanism);

  /* An edit makes it outdated as any other run, undoing makes it current. */
  g_assert_true (change (again, 0.4));
  g_assert_true (qn_document_is_stale (again, read));
  g_assert_true (qn_document_undo (again));
  g_assert_false (qn_document_is_stale (again, read));
}

/* The file says how a run differs from the project; it is still of the same model. */
static void
test_other_procedure (Place *place, gconstpointer data)
{
  (void) data;
  g_autoptr (QnDocument) document = open_example ("02-overturning-block.quoin");
  g_assert_true (qn_document_analyse_with (document, QN_PROCEDURE_LIMIT,
                                           QN_FLOW_NON_ASSOCIATIVE, NULL));
  wait_for_job (document);
  g_autoptr (GError) error = NULL;
  g_assert_true (
    qn_document_write_result (document, document->run, place->result, &error));
  g_assert_no_error (error);
  QnResultFile file;
  g_assert_true (qn_result_file_read (place->result, &file, &error));
  g_assert_true (
    g_strv_contains ((const char *const *) file.overrides, "analysis.procedure=limit"));
  g_assert_true (g_strv_contains ((const char *const *) file.overrides,
                                  "analysis.flow=non-associative"));
  qn_result_file_clear (&file);
  g_assert_true (qn_document_open_result (document, place->result, &error));
  g_assert_no_error (error);
  const QnRun *read = document->run;
  g_assert_cmpint (read->model.analysis.procedure, ==, QN_PROCEDURE_LIMIT);
  g_assert_false (qn_document_is_stale (document, read));
}

static gboolean
choose_limit (QnModel *model, gpointer data, GError **error)
{
  (void) data;
  (void) error;
  model->analysis.procedure = QN_PROCEDURE_LIMIT;
  return TRUE;
}

/* Limit analysis after an edit is that with the joints' own dilatancy, not the associative bound. */
static void
test_live_limit (Place *place, gconstpointer data)
{
  (void) place;
  (void) data;
  g_autoptr (QnDocument) document = open_example ("ferris-tin-loi/wall3.quoin");
  g_autoptr (GError) error = NULL;
  edit_model (document, "Limit", NULL, choose_limit, NULL, &error);
  g_assert_no_error (error);
  g_assert_true (qn_document_analyse_live (document, &error));
  wait_for_job (document);
  const QnResult *result = &document->run->result;
  g_assert_cmpfloat_with_epsilon (result->collapse_multiplier, 0.3558, 1e-3);
  g_assert_cmpfloat_with_epsilon (result->associative_bound, 0.4037, 1e-3);
}

/* Of a saved state that was changed afterwards: shown, and told to be outdated. */
static void
test_outdated (Place *place, gconstpointer data)
{
  (void) data;
  g_autoptr (QnDocument) document = open_example ("02-overturning-block.quoin");
  g_autoptr (GError) error = NULL;
  g_assert_true (change (document, 0.7));
  g_assert_true (qn_document_save (document, place->project, NULL));
  const QnRun *run = solve_example (document);
  g_assert_true (qn_document_write_result (document, run, place->result, &error));
  g_assert_true (qn_document_open_result (document, place->result, &error));
  g_assert_false (qn_document_is_stale (document, document->run));
  g_assert_true (change (document, 0.8));
  g_assert_false (qn_document_write_result (document, run, place->result, &error));
  g_assert_nonnull (error);
  g_clear_error (&error);
  g_assert_true (qn_document_open_result (document, place->result, &error));
  g_assert_no_error (error);
  g_assert_true (qn_document_is_stale (document, document->run));
}

/* Nothing changes where the result is of other blocks, or no result. */
static void
test_refuses (Place *place, gconstpointer data)
{
  (void) data;
  g_autoptr (QnDocument) document = open_example ("02-overturning-block.quoin");
  g_autoptr (GError) error = NULL;
  g_assert_true (
    qn_document_write_result (document, solve_example (document), place->result, NULL));
  g_autoptr (QnDocument) other = open_example ("05-stack.quoin");
  g_assert_false (qn_document_open_result (other, place->result, &error));
  g_assert_nonnull (strstr (error->message, "kept.json"));
  g_clear_error (&error);
  g_assert_true (g_file_set_contents (place->result, "{ }", -1, NULL));
  g_assert_false (qn_document_open_result (document, place->result, &error));
  g_assert_nonnull (error);
  g_clear_error (&error);
  g_assert_false (qn_document_open_result (document, place->folder, &error));
  g_assert_nonnull (error);
  g_clear_error (&error);
  g_assert_cmpuint (other->runs->len, ==, 0);
  g_assert_cmpuint (document->runs->len, ==, 1);

  g_autoptr (QnDocument) empty = qn_document_new ();
  g_assert_false (qn_document_open_result (empty, place->result, &error));
  g_clear_error (&error);

  g_autoptr (QnDocument) column = open_example ("21-column-pinned.quoin");
  g_assert_true (qn_document_find_stability (column, NULL));
  wait_for_job (column);
  const QnRun *run = column->run;
  g_assert_cmpint (run->kind, ==, QN_RUN_STABILITY);
  g_assert_false (qn_document_write_result (column, run, place->result, &error));
  g_assert_nonnull (error);
}

QN_TESTS
{
  static const struct {
    const char *name;
    void (*test) (Place *place, gconstpointer data);
  } tests[] = { { "/doc/run-file/round-trip", test_round_trip },
                { "/doc/run-file/live-limit", test_live_limit },
                { "/doc/run-file/other-procedure", test_other_procedure },
                { "/doc/run-file/outdated", test_outdated },
                { "/doc/run-file/refuses", test_refuses } };
  for (gsize i = 0; i < G_N_ELEMENTS (tests); i++)
    g_test_add (tests[i].name, Place, NULL, place_set_up, tests[i].test, place_tear_down);
}
