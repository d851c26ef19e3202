/* Every allocation of an analysis, a reader, a picture fails, alone and with all after it: a
 * refusal for lack of memory or the same answer as ever, no crash, and no leak (the sanitizers
 * look). What counts is our own code with SuiteSparse and cJSON; see failing-memory.h. */
#include "faults/fault-case.h"
#include "io/text/io-error.h"
#include "render/figure/figure.h"
#include "support/failing-memory.h"
#include "support/room.h"

#include <glib/gstdio.h>
#include <unistd.h>

/* Of programs that allocate more often only every so-manieth allocation fails, unless
 * thorough. */
#define MOST_FAILURES 250

/* Does one thing from beginning to end; a digest of what came of it, or NULL where it was
 * refused for lack of memory. */
typedef char *(*Program) (gconstpointer data);

static void
fail_allocations (Program program, gconstpointer data, long stride, bool onwards)
{
  g_autofree char *expected = program (data);
  g_assert_nonnull (expected);
  long number = 0, refused = 0;
  for (bool hit = true; hit; number += stride) {
    failing_memory_arm (number, onwards);
    g_autofree char *found = program (data);
    hit = failing_memory_disarm ();
    if (found != NULL && g_strcmp0 (found, expected) != 0)
      g_error ("another answer when allocation %ld%s fails (hit %d)", number,
               onwards ? " and all after it" : "", hit);
    if (!hit)
      g_assert_nonnull (found);
    refused += found == NULL;
  }
  g_test_message ("every %ld. of %ld allocations, %ld refusals", stride, number, refused);
}

static void
fail_all (Program program, gconstpointer data)
{
  long count = 0;
  failing_memory_arm (G_MAXLONG, false);
  g_free (program (data));
  count = G_MAXLONG - failing_memory_left ();
  failing_memory_disarm ();
  long stride = g_test_thorough () ? 1 : 1 + count / MOST_FAILURES;
  fail_allocations (program, data, stride, false);
  fail_allocations (program, data, stride, true);
}

/* --- Analyses ---------------------------------------------------------------------------- */

typedef struct Analysis {
  const FaultCase *self;
  QnProject project;
  QnContacts contacts;
} Analysis;

static char *
analyse (gconstpointer data)
{
  const Analysis *analysis = data;
  FaultAnswer answer;
  QnDiag diag = { 0 };
  QnStatus status = fault_case_run (analysis->self, &analysis->project,
                                    &analysis->contacts, NULL, NULL, &answer, &diag);
  if (status != QN_OK) {
    g_assert_cmpint (status, ==, QN_ERROR_NO_MEMORY);
    g_assert_cmpint (diag.problem, ==, QN_PROBLEM_NO_MEMORY);
    g_assert_cmpuint (answer.result.step_count, ==, 0);
    g_assert_null (answer.result.steps);
    g_assert_cmpuint (answer.modes.count, ==, 0);
    return NULL;
  }
  char *digest = fault_answer_dup_digest (&answer);
  fault_answer_clear (&answer);
  return digest;
}

static void
test_analysis (gconstpointer data)
{
  Analysis analysis = { .self = data };
  fault_case_load (data, &analysis.project, &analysis.contacts);
  fail_all (analyse, &analysis);
  qn_contacts_clear (&analysis.contacts);
  qn_project_clear (&analysis.project);
}

/* --- Readers ----------------------------------------------------------------------------- */

static char *
refusal (GError *error)
{
  g_assert_error (error, QN_IO_ERROR, QN_IO_ERROR_NO_MEMORY);
  g_error_free (error);
  return NULL;
}

static char *
digest_of_project (QnProject *project)
{
  g_autoptr (GString) text = g_string_new (NULL);
  const QnModel *model = &project->model;
  for (size_t i = 0; i < model->vertex_count; i++)
    g_string_append_printf (text, "%a %a\n", model->vertices[i].x, model->vertices[i].y);
  for (size_t i = 0; i < model->block_count; i++)
    g_string_append_printf (text, "%s %a\n", model->blocks[i].name,
                            model->blocks[i].weight);
  char *digest = g_compute_checksum_for_string (G_CHECKSUM_SHA256, text->str, -1);
  qn_project_clear (project);
  return digest;
}

static char *
read_project (gconstpointer path)
{
  QnProject project;
  GError *error = NULL;
  return qn_project_load (path, NULL, &project, &error) ? digest_of_project (&project)
                                                        : refusal (error);
}

/* Blocks to faces and findings. */
static char *
detect (gconstpointer path)
{
  QnProject project;
  QnContacts contacts;
  QnDiag diag = { 0 };
  GError *error = NULL;
  if (!qn_project_load (path, NULL, &project, &error))
    return refusal (error);
  QnStatus status = qn_contacts_detect (&project.model, &contacts, &diag);
  char *digest = NULL;
  if (status == QN_OK) {
    digest =
      g_strdup_printf ("%zu %zu", contacts.face_count, (size_t) contacts.findings.count);
    qn_contacts_clear (&contacts);
  } else {
    g_assert_cmpint (status, ==, QN_ERROR_NO_MEMORY);
    g_assert_cmpint (diag.problem, ==, QN_PROBLEM_NO_MEMORY);
  }
  qn_project_clear (&project);
  return digest;
}

typedef struct Reading {
  Program program;
  const char *folder; /* variable that names it */
  const char *file;
} Reading;

static const Reading readings[] = {
  { read_project, "QUOIN_EXAMPLES", "38-tied-walls.quoin" },
  { read_project, "QUOIN_EXAMPLES", "16-load-stages.quoin" },
  { read_project, "QUOIN_EXAMPLES", "34-frame-hybrid.quoin" },
  { read_project, "QUOIN_CORPUS", "project/every-key" },
  /* A gap, an overlap, a touching corner, a floating block, an exception without a face. */
  { detect, "QUOIN_CORPUS", "project/findings" },
};

static void
test_reading (gconstpointer data)
{
  const Reading *reading = data;
  g_autofree char *path =
    g_build_filename (g_getenv (reading->folder), reading->file, NULL);
  fail_all (reading->program, path);
}

/* --- Pictures ---------------------------------------------------------------------------- */

typedef struct Drawing {
  QnProject project;
  QnContacts contacts;
  FaultAnswer answer;
  QnOutput output;
  QnView view;
  const char *ending;
} Drawing;

static char *
draw (gconstpointer data)
{
  const Drawing *drawing = data;
  g_autofree char *path = g_strdup_printf ("%s/quoin-memory-%d.%s", g_get_tmp_dir (),
                                           (int) getpid (), drawing->ending);
  g_autofree char *content = NULL;
  gsize length;
  GError *error = NULL;
  QnFigure figure;
  QnMetadata metadata;
  qn_figure_init (&figure, &drawing->project.model, &drawing->contacts,
                  &drawing->answer.result, drawing->view);
  qn_metadata_init (&metadata);
  if (!qn_figure_export (&figure, path, &drawing->output, &metadata, &error)) {
    g_assert_true (error->domain == QN_RENDER_ERROR);
    g_error_free (error);
    return NULL;
  }
  g_assert_true (g_file_get_contents (path, &content, &length, NULL));
  g_unlink (path);
  return g_compute_checksum_for_data (G_CHECKSUM_SHA256, (const guchar *) content,
                                      length);
}

static void
test_picture (gconstpointer data)
{
  static const FaultCase stack = { "", "05-stack.quoin", FAULT_SOLVE, { NULL } };
  static const QnView views[] = { QN_VIEW_CONTACTS, QN_VIEW_FORCES, QN_VIEW_MECHANISM };
  Drawing drawing = { .ending = "png" };
  fault_case_load (&stack, &drawing.project, &drawing.contacts);
  g_assert_cmpint (fault_case_run (&stack, &drawing.project, &drawing.contacts, NULL,
                                   NULL, &drawing.answer, NULL),
                   ==, QN_OK);
  qn_output_init (&drawing.output);
  drawing.output.width = 160;
  drawing.output.height = 120;
  drawing.output.backend = (QnBackend) GPOINTER_TO_INT (data);
  for (size_t i = 0; i < G_N_ELEMENTS (views); i++) {
    drawing.view = views[i];
    fail_all (draw, &drawing);
  }
  fault_answer_clear (&drawing.answer);
  qn_contacts_clear (&drawing.contacts);
  qn_project_clear (&drawing.project);
}

QN_TESTS
{
  for (size_t i = 0; i < fault_case_count; i++) {
    g_autofree char *path = g_strdup_printf ("/faults/memory/%s", fault_cases[i].name);
    g_test_add_data_func (path, &fault_cases[i], test_analysis);
  }
  for (size_t i = 0; i < G_N_ELEMENTS (readings); i++) {
    g_autofree char *name = g_strdelimit (g_strdup (readings[i].file), "/", '-');
    g_autofree char *path = g_strdup_printf ("/faults/memory/read/%s", name);
    g_test_add_data_func (path, &readings[i], test_reading);
  }
  g_test_add_data_func ("/faults/memory/picture/cairo",
                        GINT_TO_POINTER (QN_BACKEND_CAIRO), test_picture);
  g_test_add_data_func ("/faults/memory/picture/gl", GINT_TO_POINTER (QN_BACKEND_GL),
                        test_picture);
}
