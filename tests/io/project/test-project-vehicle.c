/* Fill and vehicles: read, written and read again; built-in ones are not written. */
#include "io/project-text.h"
#include "io/project/project-vehicle.h"
#include "support/auto-clear.h"
#include "support/room.h"

#include <string.h>

static const char text[] =
  "{ \"format\": \"quoin\", \"version\": 1,\n"
  "  \"laws\": [{ \"name\": \"joint\", \"kind\": \"coulomb\", \"kn\": 1e9, \"ks\": 1e9,\n"
  "    \"friction\": 0.6 }, { \"name\": \"bed\", \"kind\": \"coulomb\", \"kn\": 1e9,\n"
  "    \"ks\": 1e9, \"friction\": 0.3 }],\n"
  "  \"blocks\": [\n"
  "    { \"name\": \"base\", \"vertices\": [[-2, -1], [2, -1], [2, 0], [-2, 0]],\n"
  "      \"thickness\": 1, \"unit_weight\": 1, \"support\": [true, true, true],\n"
  "      \"ring\": 1, \"ring_law\": \"bed\" },\n"
  "    { \"name\": \"stone\", \"vertices\": [[0, 0], [1, 0], [1, 2], [0, 2]],\n"
  "      \"thickness\": 1, \"unit_weight\": 20000, \"ring\": 2, \"ring_law\": \"bed\" } "
  "],\n"
  "  \"vehicles\": [ { \"name\": \"cart\", \"source\": \"weighed\", \"axles\": [[0, "
  "2e4],\n"
  "    [1.5, 3e4]], \"lines\": [[-1, 2, 500]], \"patch\": [0.2, 0.1], \"track\": 1.2 } "
  "],\n"
  "  \"contact\": { \"law\": \"joint\" },\n"
  "  \"loads\": { \"dead\": [{ \"kind\": \"weight\", \"direction\": [0, -1] },\n"
  "      { \"kind\": \"fill\", \"surface\": [[-9, 2], [0, 3], [9, 2.5]], "
  "\"unit_weight\": "
  "18000,\n"
  "        \"friction_angle\": 0.5, \"mobilisation\": 0.4, \"stiffness\": 2e7, "
  "\"bottom\": "
  "-1 }],\n"
  "    \"live\": [{ \"kind\": \"vehicle\", \"vehicle\": \"cart\", \"position\": 0.5,\n"
  "        \"reversed\": true, \"convoy\": 2, \"headway\": 3, \"dispersal\": "
  "\"en-1991-2\",\n"
  "        \"width\": 4, \"effective_width\": 2.5 },\n"
  "      { \"kind\": \"vehicle\", \"vehicle\": \"LM1 tandem\", \"position\": 0.5 }] } "
  "}\n";

static void
test_round_trip (void)
{
  g_auto (QnProject) project, again;
  test_parse (text, &project);
  const QnModel *model = &project.model;
  g_assert_cmpuint (model->vehicle_count, ==, 2);
  g_assert_true (model->vehicles[1].built_in);
  g_assert_cmpfloat (model->vehicles[1].axles[1].load, ==, 300e3);
  g_assert_cmpuint (model->soil_tie_count, ==, 2);
  g_assert_cmpint (qn_model_side_law (model, 0, 1), ==, 1);
  g_autofree char *written = qn_project_to_text (&project, NULL);
  g_assert_null (strstr (written, "\"source\": \"EN"));
  g_assert_null (strstr (written, "soil."));
  test_parse (written, &again);
  g_autofree char *rewritten = qn_project_to_text (&again, NULL);
  g_assert_cmpstr (written, ==, rewritten);
  const QnVehicle *cart = &again.model.vehicles[0];
  g_assert_cmpstr (cart->source, ==, "weighed");
  g_assert_cmpfloat (cart->axles[1].at, ==, 1.5);
  g_assert_cmpfloat (cart->lines[0].from, ==, -1);
  g_assert_cmpfloat (cart->patch[1], ==, 0.1);
  for (size_t i = 0; i < 2; i++) {
    const QnLoad *a = &model->live_loads[i], *b = &again.model.live_loads[i];
    g_assert_true (a->reversed == b->reversed && a->convoy == b->convoy);
    g_assert_cmpint (a->dispersal, ==, b->dispersal);
    g_assert_cmpfloat (a->headway, ==, b->headway);
    g_assert_cmpfloat (a->width, ==, b->width);
    g_assert_cmpfloat (a->effective, ==, b->effective);
  }
  const QnLoad *fill = &again.model.dead_loads[1];
  g_assert_cmpint (fill->surface_count, ==, 3);
  g_assert_cmpfloat (fill->surface[2].y, ==, 2.5);
  g_assert_cmpfloat (fill->mobilisation, ==, 0.4);
  g_assert_cmpfloat (fill->stiffness, ==, 2e7);
  g_assert_cmpfloat (fill->span[0], ==, -1);
}

/* Every built-in vehicle is sound, and says where it comes from. */
static void
test_built_in (void)
{
  g_auto (GStrv) names = qn_dup_vehicle_names (NULL);
  g_assert_cmpuint (g_strv_length (names), >, 10);
  for (guint i = 0; names[i] != NULL; i++) {
    g_auto (QnProject) project;
    g_autofree char *with = test_replace (text, "LM1 tandem", names[i]);
    test_parse (with, &project);
    g_assert_cmpstr (project.model.vehicles[1].name, ==, names[i]);
    g_assert_nonnull (project.model.vehicles[1].source);
  }
}

QN_TESTS
{
  g_test_add_func ("/project/vehicle/round-trip", test_round_trip);
  g_test_add_func ("/project/vehicle/built-in", test_built_in);
}
