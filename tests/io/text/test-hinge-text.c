#include "io/text/mechanism-text.h"

#include "io/project/project.h"
#include "support/models.h"
#include "support/room.h"

/* A beam of three elements, clamped at both ends, with two nodes between. */
static const char text[] =
  "{ \"format\": \"quoin\", \"version\": 1, \"gravity\": 10,\n"
  "  \"sections\": [ { \"name\": \"iron\", \"young\": 2e11, \"poisson\": 0.3,\n"
  "    \"width\": 0.1, \"height\": 0.2, \"plastic_moment\": 1000 } ],\n"
  "  \"nodes\": [\n"
  "    { \"name\": \"a\", \"at\": [0, 0], \"support\": [true, true, true] },\n"
  "    { \"name\": \"b\", \"at\": [3, 0], \"support\": [true, true, true] } ],\n"
  "  \"beams\": [ { \"name\": \"girder\", \"nodes\": [\"a\", \"b\"],\n"
  "    \"section\": \"iron\", \"elements\": 3 } ],\n"
  "  \"loads\": { \"live\": [ { \"kind\": \"line\", \"beam\": \"girder\",\n"
  "    \"value\": [0, -1] } ] } }\n";

/* The words for given moments at both ends of the three elements. */
static char *
words_for (const double moments[6])
{
  g_auto (QnProject) project;
  g_autoptr (GError) error = NULL;
  qn_project_parse (text, sizeof text - 1, "beam.quoin", NULL, &project, &error);
  g_assert_no_error (error);
  g_assert_cmpuint (project.model.element_count, ==, 3);
  QnBeamForces forces[3] = { 0 };
  for (int i = 0; i < 6; i++)
    forces[i / 2].moment[i % 2] = moments[i];
  QnStep step = { 0 };
  const QnResult result = {
    .steps = &step, .step_count = 1, .beam_forces = forces, .element_count = 3
  };
  char *words = qn_hinges_dup_text (&project.model, &result);
  return words;
}

static void
test_places (void)
{
  const double elastic[6] = { -990, 500, 500, 500, 500, -990 };
  g_assert_null (words_for (elastic));
  const double one[6] = { -1000, 400, 400, 400, 400, -990 };
  g_autofree char *first = words_for (one);
  g_assert_cmpstr (first, ==, "1 plastic hinge: “girder” at “a”.");
  const double three[6] = { -1000, 500, 500, 1000, 1000, -1000 };
  g_autofree char *all = words_for (three);
  g_assert_cmpstr (
    all, ==,
    "3 plastic hinges: “girder” at “a”, “girder” at “girder.2”, “girder” at “b”.");
}

/* A result without section forces, or of another model, says nothing. */
static void
test_unknown (void)
{
  g_auto (QnProject) project;
  g_autoptr (GError) error = NULL;
  qn_project_parse (text, sizeof text - 1, "beam.quoin", NULL, &project, &error);
  g_assert_no_error (error);
  QnStep step = { 0 };
  QnBeamForces forces[1] = { { .moment = { 1e6, 1e6 } } };
  QnResult result = { .steps = &step, .step_count = 1 };
  g_assert_null (qn_hinges_dup_text (&project.model, &result));
  result.beam_forces = forces;
  result.element_count = 1;
  g_assert_null (qn_hinges_dup_text (&project.model, &result));
  result.step_count = 0;
  g_assert_null (qn_hinges_dup_text (&project.model, &result));
}

/* Ties at their worst step, the most used first and four of them; one without strength by its force. */
static void
test_ties (void)
{
  enum { TIES = 6 };
  QnModel model;
  QnStep steps[2] = { { 0 } };
  QnTieResult ties[2 * TIES] = { { 0 } };
  QnResult result = { .steps = steps, .step_count = 2, .ties = ties };
  test_model_init_stack (&model, 2, 1, 0.5);
  for (int i = 0; i < TIES; i++) {
    g_autofree char *name = g_strdup_printf ("t%d", i + 1);
    QnTie *tie = qn_model_add_tie (&model, name);
    tie->area = 1e-4;
    tie->yield = i == 1 ? 0 : 1e8;                      /* 10 kN */
    g_assert_null (qn_ties_dup_text (&model, &result)); /* of another model */
    result.tie_count = (size_t) i + 1;
    ties[i] = (QnTieResult){ .force = 9e3 };
    for (int k = 0; k <= i; k++)
      ties[i + 1 + k] = (QnTieResult){ .force = 1e3 * (k + 1), .state = QN_TIE_ELASTIC };
    ties[i + 1 + i] = (QnTieResult){ .force = 1e4, .state = QN_TIE_YIELDS };
    g_autofree char *words = qn_ties_dup_text (&model, &result);
    g_autofree char *worst =
      i == 1 ? g_strdup ("“t2” 10 kN")
             : g_strdup_printf ("“t%d” 10 kN, 100 %% of its strength (yields)", i + 1);
    g_assert_nonnull (strstr (words, worst));
    g_assert_cmpint (strstr (words, "…") != NULL, ==, i >= 4);
    g_assert_cmpint (g_str_has_prefix (words, "Largest force of the tie"), ==, i == 0);
  }
  result.step_count = 0;
  g_assert_null (qn_ties_dup_text (&model, &result));
  qn_model_clear (&model);
}

QN_TESTS
{
  g_test_add_func ("/tie-text/ties", test_ties);
  g_test_add_func ("/io/hinge-text/places", test_places);
  g_test_add_func ("/io/hinge-text/unknown", test_unknown);
}
