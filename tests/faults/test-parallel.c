/* Eight threads at once, each in its own order: contacts, every analysis, pictures. All of them
 * come to what one thread comes to, bit for bit; models and contacts are shared, results are
 * each thread's own. The thread sanitizer has its say on this program. */
#include "faults/fault-case.h"
#include "render/figure/figure.h"
#include "support/room.h"

#include <glib/gstdio.h>
#include <unistd.h>

#define THREADS 8

/* What one case came to. */
typedef struct Outcome {
  char *contacts, *answer, *picture; /* digests */
} Outcome;

typedef struct Shared {
  QnProject *projects;
  QnContacts *contacts;
  Outcome *expected;
  bool draws;
} Shared;

typedef struct Worker {
  const Shared *shared;
  guint number;
} Worker;

static char *
dup_contacts_digest (const QnContacts *contacts)
{
  g_autoptr (GString) text = g_string_new (NULL);
  for (size_t i = 0; i < contacts->face_count; i++) {
    const QnContactFace *face = &contacts->faces[i];
    g_string_append_printf (text, "%d %d %a %a %a %a\n", face->a, face->b, face->start.x,
                            face->start.y, face->end.x, face->end.y);
  }
  for (size_t i = 0; i < contacts->pair_count; i++)
    g_string_append_printf (text, "%a %a\n", contacts->pairs[i].abscissa,
                            contacts->pairs[i].tributary);
  char *digest = g_compute_checksum_for_string (G_CHECKSUM_SHA256, text->str, -1);
  return digest;
}

/* A PNG and an SVG of the answer; text takes Pango along. */
static char *
dup_picture_digest (const QnProject *project, const QnContacts *contacts,
                    const QnResult *result, guint worker)
{
  static const char *const endings[] = { "png", "svg" };
  GChecksum *sum = g_checksum_new (G_CHECKSUM_SHA256);
  for (size_t i = 0; i < G_N_ELEMENTS (endings); i++) {
    g_autofree char *path =
      g_strdup_printf ("%s/quoin-parallel-%d-%u.%s", g_get_tmp_dir (), (int) getpid (),
                       worker, endings[i]);
    g_autofree char *content = NULL;
    gsize length;
    GError *error = NULL;
    QnFigure figure;
    QnOutput output;
    QnMetadata metadata;
    qn_figure_init (&figure, &project->model, contacts, result,
                    result->step_count > 0 ? QN_VIEW_DEFORMED : QN_VIEW_MODEL);
    qn_output_init (&output);
    output.width = 320;
    output.height = 240;
    qn_metadata_init (&metadata);
    qn_figure_export (&figure, path, &output, &metadata, &error);
    g_assert_no_error (error);
    g_assert_true (g_file_get_contents (path, &content, &length, NULL));
    g_checksum_update (sum, (const guchar *) content, (gssize) length);
    g_unlink (path);
  }
  char *digest = g_strdup (g_checksum_get_string (sum));
  g_checksum_free (sum);
  return digest;
}

static Outcome
run_case (const Shared *shared, size_t index, guint worker)
{
  const QnProject *project = &shared->projects[index];
  QnContacts own;
  FaultAnswer answer;
  Outcome outcome = { 0 };
  g_assert_cmpint (qn_contacts_detect (&project->model, &own, NULL), ==, QN_OK);
  outcome.contacts = dup_contacts_digest (&own);
  qn_contacts_clear (&own);
  g_assert_cmpint (fault_case_run (&fault_cases[index], project, &shared->contacts[index],
                                   NULL, NULL, &answer, NULL),
                   ==, QN_OK);
  outcome.answer = fault_answer_dup_digest (&answer);
  if (shared->draws)
    outcome.picture =
      dup_picture_digest (project, &shared->contacts[index], &answer.result, worker);
  fault_answer_clear (&answer);
  return outcome;
}

static void
outcome_clear (Outcome *outcome)
{
  g_free (outcome->contacts);
  g_free (outcome->answer);
  g_free (outcome->picture);
}

static gpointer
work (gpointer data)
{
  const Worker *worker = data;
  for (size_t i = 0; i < fault_case_count; i++) {
    /* Neighbours start with the same case, so that it meets itself. */
    size_t index = (i + worker->number / 2) % fault_case_count;
    const Outcome *expected = &worker->shared->expected[index];
    Outcome outcome = run_case (worker->shared, index, worker->number);
    g_assert_cmpstr (outcome.contacts, ==, expected->contacts);
    g_assert_cmpstr (outcome.answer, ==, expected->answer);
    g_assert_cmpstr (outcome.picture, ==, expected->picture);
    outcome_clear (&outcome);
  }
  return NULL;
}

static void
test_parallel (gconstpointer draws)
{
  Shared shared = { .projects = g_new0 (QnProject, fault_case_count),
                    .contacts = g_new0 (QnContacts, fault_case_count),
                    .expected = g_new0 (Outcome, fault_case_count),
                    .draws = draws != NULL };
  Worker workers[THREADS];
  GThread *threads[THREADS];

  for (size_t i = 0; i < fault_case_count; i++) {
    fault_case_load (&fault_cases[i], &shared.projects[i], &shared.contacts[i]);
    shared.expected[i] = run_case (&shared, i, THREADS);
  }
  for (guint t = 0; t < THREADS; t++) {
    workers[t] = (Worker){ &shared, t };
    threads[t] = g_thread_new ("solve", work, &workers[t]);
  }
  for (guint t = 0; t < THREADS; t++)
    g_thread_join (threads[t]);

  for (size_t i = 0; i < fault_case_count; i++) {
    outcome_clear (&shared.expected[i]);
    qn_contacts_clear (&shared.contacts[i]);
    qn_project_clear (&shared.projects[i]);
  }
  g_free (shared.expected);
  g_free (shared.contacts);
  g_free (shared.projects);
}

QN_TESTS
{
  g_test_add_data_func ("/faults/parallel/analyses", NULL, test_parallel);
  g_test_add_data_func ("/faults/parallel/analyses-and-pictures", "", test_parallel);
}
