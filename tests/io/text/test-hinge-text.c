#include "io/text/tie-text.h"

#include "io/project/project.h"
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

QN_TESTS
{
  g_test_add_func ("/io/hinge-text/places", test_places);
  g_test_add_func ("/io/hinge-text/unknown", test_unknown);
}
