/* analysis.dynamic: read, written and read again; what is refused, with its place; records that the
 * project names, and results that hold a history. */
#include "core/path/analysis.h"
#include "io/exchange/record.h"
#include "io/project-text.h"
#include "io/result/result-file.h"
#include "support/auto-clear.h"
#include "support/room.h"
#include "support/scratch.h"

#include <string.h>

static const char dynamic[] =
  "\"version\": 1, \"analysis\": { \"procedure\": \"dynamic\", \"geometry\": "
  "\"nonlinear\",\n"
  "  \"dynamic\": { \"duration\": 0.5, \"time_step\": 0.005, \"rho\": 0.9,\n"
  "    \"tolerance\": 1e-4, \"adaptive\": false, \"output_interval\": 0.05, \"mood\": "
  "1,\n"
  "    \"damping\": { \"mass\": 0.1, \"stiffness\": 1e-4, \"of\": \"initial\" },\n"
  "    \"ground\": [\n"
  "      { \"direction\": [1, 0], \"scale\": 0.5, \"record\": \"a.csv\", \"peak\": 3 },\n"
  "      { \"direction\": [0, 1], \"points\": [[0, 0], [0.1, 2.5], [0.2, 0]] },\n"
  "      { \"direction\": [1, 0], \"pulse\": { \"kind\": \"ricker\", \"amplitude\": 1,\n"
  "        \"duration\": 0.25, \"start\": 0.1 } } ],\n"
  "    \"initial\": [ { \"block\": \"top\", \"displacement\": [0, 0, 0.1],\n"
  "      \"velocity\": [0.5, 0, 0], \"why\": \"test\" } ],\n"
  "    \"track\": [ { \"block\": \"top\", \"component\": \"ux\" } ] } }";

static char *
text_with (const char *what, const char *by)
{
  g_autofree char *changed = test_replace (dynamic, what, by);
  return test_replace (test_project_text, "\"version\": 1", changed);
}

static void
check_model (const QnModel *model)
{
  const QnDynamicSettings *s = &model->analysis.dynamic;
  g_assert_cmpint (model->analysis.procedure, ==, QN_PROCEDURE_DYNAMIC);
  g_assert_cmpfloat (s->duration, ==, 0.5);
  g_assert_cmpfloat (s->time_step, ==, 0.005);
  g_assert_cmpfloat (s->rho, ==, 0.9);
  g_assert_cmpfloat (s->tolerance, ==, 1e-4);
  g_assert_cmpfloat (s->output_interval, ==, 0.05);
  g_assert_cmpfloat (s->mass_damping, ==, 0.1);
  g_assert_cmpfloat (s->joint_damping, ==, 1e-4);
  g_assert_cmpint (s->of, ==, QN_DAMPING_INITIAL);
  g_assert_false (s->adaptive);
  g_assert_cmpuint (model->ground_count, ==, 3);
  g_assert_cmpstr (model->ground[0].record, ==, "a.csv");
  g_assert_cmpfloat (model->ground[0].scale, ==, 0.5);
  g_assert_cmpfloat (model->ground[0].peak, ==, 3);
  g_assert_cmpuint (model->ground[1].point_count, ==, 3);
  g_assert_cmpfloat (model->ground[1].points[1].y, ==, 2.5);
  g_assert_cmpint (model->ground[2].pulse.kind, ==, QN_PULSE_RICKER);
  g_assert_cmpfloat (model->ground[2].pulse.start, ==, 0.1);
  g_assert_cmpuint (model->initial_count, ==, 1);
  g_assert_cmpfloat (model->initial[0].displacement[2], ==, 0.1);
  g_assert_cmpfloat (model->initial[0].velocity[0], ==, 0.5);
  g_assert_cmpuint (model->track_count, ==, 1);
  g_assert_cmpint (model->tracks[0].dof, ==, QN_DOF_UX);
}

static void
test_round_trip (void)
{
  g_auto (QnProject) project, again;
  gsize length;
  g_autofree char *text = text_with ("0.9", "0.9");
  test_parse (text, &project);
  check_model (&project.model);
  g_assert_cmpuint (project.warnings->len, ==, 2); /* mood, why */
  g_autofree char *first = qn_project_to_text (&project, &length);
  g_assert_nonnull (strstr (first, "\"mood\": 1"));
  g_assert_nonnull (strstr (first, "\"why\": \"test\""));
  test_parse (first, &again);
  check_model (&again.model);
  g_autofree char *second = qn_project_to_text (&again, &length);
  g_assert_cmpstr (first, ==, second);

  g_auto (QnModel) copy;
  g_assert_cmpint (qn_model_copy (&project.model, &copy, NULL), ==, QN_OK);
  check_model (&copy);
}

static void
test_refused (void)
{
  static const struct {
    const char *what, *by, *message;
  } cases[] = {
    { "\"duration\": 0.5", "\"duration\": -1", "analysis.dynamic.duration: " },
    { "\"time_step\": 0.005, ", "", "analysis.dynamic.time_step: " },
    { "\"duration\": 0.5, \"time_step\": 0.005, \"rho\": 0.9,",
      "\"time_step\": 0.005, \"rho\": 0.9, \"ground\": [] }, \"x\": {",
      "analysis.dynamic.duration: without ground motion" },
    { "\"rho\": 0.9", "\"rho\": 1.1", "analysis.dynamic.rho: spectral radius" },
    { "\"ricker\"", "\"wave\"", "analysis.dynamic.ground[2].pulse.kind: " },
    { "[0.1, 2.5]", "[0.3, 2.5]", "analysis.dynamic.ground[1].points[2]: times of" },
    { "[0.1, 2.5]", "[0.1]", "analysis.dynamic.ground[1].points[1]: " },
    { "[[0, 0], [0.1, 2.5], [0.2, 0]]", "[]", "analysis.dynamic.ground[1].points: " },
    { "\"record\": \"a.csv\", ", "", "analysis.dynamic.ground[0]: expected one of" },
    { "\"direction\": [0, 1]", "\"direction\": [0, 0]", "ground[1].direction: " },
    { "\"block\": \"top\", \"disp", "\"block\": \"base\", \"disp", "initial[0]." },
    { "[0, 0, 0.1]", "[0, 0]", "analysis.dynamic.initial[0].displacement: " },
    { "\"block\": \"top\", \"comp", "\"block\": \"ghost\", \"comp", "track[0].block: " },
    { "\"of\": \"initial\"", "\"of\": \"past\"", "analysis.dynamic.damping.of: " },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (cases); i++) {
    g_autofree char *text = text_with (cases[i].what, cases[i].by);
    g_autofree char *message = test_parse_error (text, NULL);
    if (strstr (message, cases[i].message) == NULL)
      g_error ("'%s' is not in '%s'", cases[i].message, message);
  }
  g_autofree char *bare = test_replace (test_project_text, "\"version\": 1",
                                        "\"version\": 1, \"analysis\": { \"procedure\": "
                                        "\"dynamic\" }");
  g_autofree char *message = test_parse_error (bare, NULL);
  g_assert_nonnull (strstr (message, "needs a time_step"));
}

/* Records are read from beside the project, scaled to their peaks, and missed in one sentence. */
static void
test_records (void)
{
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *path = g_build_filename (folder, "p.quoin", NULL);
  g_autofree char *record = g_build_filename (folder, "a.csv", NULL);
  g_autofree char *text = text_with ("0.9", "0.9");
  GError *error = NULL;
  QnProject project;
  g_assert_true (g_file_set_contents (path, text, -1, NULL));
  g_assert_true (qn_project_load (path, NULL, &project, &error));
  g_assert_false (qn_project_read_records (&project, NULL, FALSE, &error));
  g_assert_nonnull (strstr (error->message, "analysis.dynamic.ground[0].record: "));
  g_clear_error (&error);

  g_assert_true (
    g_file_set_contents (record, "time [s],a [g]\n0,0\n0.1,2\n0.2,-4\n", -1, NULL));
  g_assert_false (qn_project_read_records (&project, NULL, FALSE, &error));
  g_assert_nonnull (strstr (error->message, "analysis.dynamic.ground[0].record: "));
  g_assert_nonnull (strstr (error->message, "ends at 0.2 s"));
  g_clear_error (&error);
  project.model.ground[2].pulse.duration = 0.05;
  project.model.analysis.dynamic.duration = 0.3; /* the last sample stands up to here */
  g_assert_true (qn_project_read_records (&project, NULL, FALSE, &error));
  project.model.analysis.dynamic.duration = 0.31;
  g_assert_false (qn_project_read_records (&project, NULL, FALSE, &error));
  g_clear_error (&error);
  project.model.ground[0].rests = true;
  g_assert_true (qn_project_read_records (&project, NULL, FALSE, &error));
  g_assert_cmpuint (project.model.ground[0].point_count, ==, 3);
  g_assert_cmpfloat_with_epsilon (project.model.ground[0].points[2].y, -3, 1e-12);

  /* A record that goes on is not cut without a word; 1 % of its Arias intensity does not count, and
   * without a duration the analysis follows the last motion to its end. */
  g_assert_true (g_file_set_contents (
    record, "time [s],a [g]\n0,0\n0.1,2\n0.2,-4\n0.9,0\n", -1, NULL));
  project.model.analysis.dynamic.duration = 0.5;
  g_assert_false (qn_project_read_records (&project, NULL, FALSE, &error));
  g_assert_nonnull (strstr (error->message, "analysis.dynamic.ground[0]: lasts 0.9 s"));
  g_assert_nonnull (strstr (error->message, "after the duration of 0.5 s"));
  g_clear_error (&error);
  project.model.analysis.dynamic.duration =
    0.8; /* (1/7)^3 of the last triangle is left */
  g_assert_true (qn_project_read_records (&project, NULL, FALSE, &error));
  project.model.analysis.dynamic.duration = 0;
  g_assert_true (qn_project_read_records (&project, NULL, FALSE, &error));
  g_assert_cmpfloat (qn_model_duration (&project.model), ==, 0.9);
  g_autofree char *written = qn_project_to_text (&project, NULL);
  g_assert_null (strstr (written, "\"time_step\": 0.005, \"duration\""));
  g_assert_nonnull (strstr (written, "\"dynamic\""));
  qn_project_clear (&project);

  g_autofree char *outside = text_with ("a.csv", "../a.csv");
  g_assert_true (g_file_set_contents (path, outside, -1, NULL));
  g_assert_true (qn_project_load (path, NULL, &project, &error));
  g_assert_false (qn_project_read_records (&project, NULL, FALSE, &error));
  g_assert_nonnull (strstr (error->message, "outside"));
  g_clear_error (&error);
  qn_project_clear (&project);
}

/* What a result file says of the history reads back to the last bit. */
static void
test_history (void)
{
  g_autofree char *text =
    text_with ("\"record\": \"a.csv\", \"peak\": 3", "\"points\": [[0, 1], [0.3, 1]]");
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *path = g_build_filename (folder, "r.json", NULL);
  g_auto (QnProject) project;
  g_auto (QnContacts) contacts;
  QnResult result;
  QnResultFile file;
  GError *error = NULL;
  test_parse (text, &project);
  g_assert_cmpint (qn_contacts_detect (&project.model, &contacts, NULL), ==, QN_OK);
  g_assert_cmpint (qn_analysis_run (&project.model, &contacts, NULL, NULL, &result, NULL),
                   ==, QN_OK);
  qn_result_file_write (path, &project, &contacts, &result, QN_DETAIL_FORCES, &error);
  g_assert_no_error (error);
  qn_result_file_read (path, &file, &error);
  g_assert_no_error (error);

  const QnHistory *a = &result.history, *b = &file.result.history;
  g_assert_cmpuint (a->row_count, ==, 101);
  g_assert_cmpuint (a->row_count, ==, b->row_count);
  g_assert_cmpuint (a->width, ==, b->width);
  for (gsize i = 0; i < a->row_count * a->width; i++)
    g_assert_cmpfloat (a->rows[i], ==, b->rows[i]);
  g_assert_cmpfloat (a->peaks[1], ==, b->peaks[1]);
  g_assert_cmpfloat (a->energy_error, ==, b->energy_error);
  g_assert_cmpint (a->steps, ==, b->steps);
  g_assert_cmpfloat (result.steps[2].time, >, 0);
  g_assert_cmpfloat (result.steps[2].time, ==, file.result.steps[2].time);
  qn_result_file_clear (&file);
  qn_result_clear (&result);

  /* A list that is too short is no history. */
  g_autofree char *bytes = NULL;
  gsize length;
  g_assert_true (g_file_get_contents (path, &bytes, &length, NULL));
  g_autofree char *cut = test_replace (bytes, "\"x\": [0, ", "\"x\": [");
  g_assert_false (qn_result_file_parse (cut, strlen (cut), "r", &file, &error));
  g_assert_nonnull (strstr (error->message, "history.ground.x: lists"));
  g_clear_error (&error);
}

QN_TESTS
{
  g_test_add_func ("/project-dynamic/round-trip", test_round_trip);
  g_test_add_func ("/project-dynamic/refused", test_refused);
  g_test_add_func ("/project-dynamic/records", test_records);
  g_test_add_func ("/project-dynamic/history", test_history);
}
