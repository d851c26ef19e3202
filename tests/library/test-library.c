/* libquoin as a program sees it that links to nothing else of Quoin. */
#include "library/sliding-block.h"
#include "support/room.h"
#include "support/scratch.h"

#include <glib.h>
#include <math.h>
#include <quoin.h>
#include <string.h>

static char *
wall_path (int number)
{
  g_autofree char *name = g_strdup_printf ("wall%d.quoin", number);
  return g_build_filename (g_getenv ("QUOIN_EXAMPLES"), "ferris-tin-loi", name, NULL);
}

static QuoinModel *
open_wall (int number)
{
  g_autofree char *path = wall_path (number);
  QuoinError *error = NULL;
  QuoinModel *model = quoin_model_open (path, NULL, &error);
  g_assert_nonnull (model);
  g_assert_null (error);
  return model;
}

static void
test_model (void)
{
  QuoinModel *model = open_wall (1);
  size_t count, a, b;
  double ends[4];
  g_assert_cmpuint (quoin_model_get_block_count (model), ==, 34);
  g_assert_cmpuint (quoin_model_get_face_count (model), ==, 83);
  g_assert_cmpuint (quoin_model_get_pair_count (model), ==, 166);
  g_assert_cmpuint (quoin_model_get_warning_count (model), ==, 0);
  g_assert_true (quoin_model_is_block_fixed (model, 0, 2));
  g_assert_false (quoin_model_is_block_fixed (model, 1, 0));

  const double *vertices = quoin_model_get_block_vertices (model, 1, &count);
  g_assert_cmpuint (count, ==, 4);
  double area = 0, x = 0;
  for (size_t i = 0; i < count; i++) {
    const double *p = vertices + 2 * i, *q = vertices + 2 * ((i + 1) % count);
    area += 0.5 * (p[0] * q[1] - q[0] * p[1]);
    x += p[0] / 4;
  }
  g_assert_cmpfloat_with_epsilon (area, quoin_model_get_block_area (model, 1), 1e-12);
  g_assert_cmpfloat_with_epsilon (x, quoin_model_get_block_centroid (model, 1)[0], 1e-12);
  g_assert_cmpfloat_with_epsilon (quoin_model_get_block_weight (model, 1), 1e4 * area,
                                  1e-6);

  for (size_t i = 0; i < quoin_model_get_face_count (model); i++) {
    quoin_model_get_face_blocks (model, i, &a, &b);
    quoin_model_get_face_ends (model, i, ends);
    g_assert_cmpuint (a, <, b);
    g_assert_cmpfloat (hypot (ends[2] - ends[0], ends[3] - ends[1]), >, 0.1);
  }
  g_assert_cmpuint (quoin_model_get_pair_face (model, 165), ==, 82);
  quoin_model_unref (model);
}

/* The first line names the place in every part. */
static void
test_error_names_the_place (void)
{
  static const char text[] = "{ \"format\": \"quoin\", \"version\": 1,\n"
                             "  \"laws\": [ { \"name\": \"j\", \"kind\": \"coulomb\",\n"
                             "    \"kn\": -1, \"ks\": 1, \"friction\": 0.5 } ],\n"
                             "  \"contact\": { \"law\": \"j\" }, \"blocks\": [] }";
  QuoinError *error = NULL;
  g_assert_null (quoin_model_parse (text, strlen (text), "my model", NULL, &error));
  g_assert_cmpint (quoin_error_get_kind (error), ==, QUOIN_ERROR_INVALID);
  g_assert_cmpstr (quoin_error_get_file (error), ==, "my model");
  g_assert_cmpint (quoin_error_get_line (error), ==, 3);
  g_assert_cmpint (quoin_error_get_column (error), ==, 11);
  g_assert_cmpstr (quoin_error_get_key (error), ==, "laws[0].kn");
  quoin_error_free (error);

  error = NULL;
  g_assert_null (quoin_model_open ("/no/such/file.quoin", NULL, &error));
  g_assert_cmpint (quoin_error_get_kind (error), ==, QUOIN_ERROR_FILE);
  g_assert_cmpstr (quoin_error_get_file (error), ==, "/no/such/file.quoin");
  g_assert_cmpint (quoin_error_get_line (error), ==, 0);
  g_assert_null (quoin_error_get_key (error));
  quoin_error_free (error);

  g_assert_null (quoin_model_open ("/no/such/file.quoin", NULL, NULL));
}

/* Ties of a file: forces at every step, none of the rigid blocks before their collapse. */
static void
test_ties (void)
{
  g_autofree char *path =
    g_build_filename (g_getenv ("QUOIN_EXAMPLES"), "38-tied-walls.quoin", NULL);
  QuoinError *error = NULL;
  QuoinModel *model = quoin_model_open (path, NULL, &error);
  g_assert_nonnull (model);
  QuoinResult *result = quoin_solve (model, NULL, NULL, &error);
  size_t last = quoin_result_get_step_count (result) - 1;
  double force, elongation;
  g_assert_cmpuint (quoin_result_get_tie_count (result), ==, 1);
  g_assert_true (quoin_result_get_tie (result, 0, 0, &force, &elongation));
  g_assert_cmpfloat_with_epsilon (force, 1000, 1e-6);
  g_assert_true (quoin_result_get_tie (result, last, 0, &force, &elongation));
  g_assert_cmpfloat_with_epsilon (force, 4500, 1e-6);
  g_assert_cmpfloat (elongation, >, 0);
  g_assert_cmpstr (quoin_result_get_tie_state (result, last, 0), ==, "anchor");
  quoin_result_free (result);
  result = quoin_limit (model, true, NULL, NULL, &error);
  g_assert_false (quoin_result_get_tie (result, 0, 0, &force, &elongation));
  g_assert_null (quoin_result_get_tie_state (result, 0, 0));
  quoin_result_free (result);
  quoin_model_unref (model);
}

/* Loads on edges and factors of cases arrive with the file: a retaining wall under soil and traffic,
 * whose closed forms are in tests/verify/test-loads.c. */
static void
test_edge_loads (void)
{
  /* b = 1.2 m, h = 3 m of 24 kN/m3, K = 1/3: stone b h b/2 over K (soil h^3/6 + f q h^2/2). */
  static const char *const factors[] = { "1.5", "0" };
  g_autofree char *path =
    g_build_filename (g_getenv ("QUOIN_EXAMPLES"), "27-retaining-wall.quoin", NULL);
  for (gsize i = 0; i < G_N_ELEMENTS (factors); i++) {
    g_autofree char *set = g_strconcat ("loads.cases.traffic=", factors[i], NULL);
    const char *const sets[] = { set, NULL };
    const double traffic = g_ascii_strtod (factors[i], NULL) * 10000;
    const double expected =
      24000.0 * 1.2 * 3 * 0.6 / ((18000.0 * 27 / 6 + traffic * 9 / 2) / 3);
    QuoinError *error = NULL;
    QuoinModel *model = quoin_model_open (path, sets, &error);
    g_assert_nonnull (model);
    QuoinResult *result = quoin_solve (model, NULL, NULL, &error);
    g_assert_nonnull (result);
    g_assert_cmpfloat_with_epsilon (quoin_result_get_collapse_multiplier (result),
                                    expected, 1e-3 * expected);
    quoin_result_free (result);
    quoin_model_unref (model);
  }
}

static void
test_builder (void)
{
  QuoinError *error = NULL;
  QuoinBuilder *builder = library_build_sliding_block ();
  quoin_builder_add_live_weight (builder, 1, 0);
  quoin_builder_set (builder, "analysis.increments", "20");
  QuoinModel *model = quoin_builder_finish (builder, &error);
  g_assert_nonnull (model);
  QuoinResult *result = quoin_solve (model, NULL, NULL, &error);
  g_assert_nonnull (result);
  g_assert_cmpstr (quoin_result_get_outcome (result), ==, "collapse");
  g_assert_cmpfloat_with_epsilon (quoin_result_get_collapse_multiplier (result), 0.4,
                                  1e-4);
  quoin_result_free (result);

  /* The text is a project file, and reads back as the same model. */
  char *text = quoin_model_to_text (model);
  QuoinModel *again = quoin_model_parse (text, strlen (text), "again", NULL, &error);
  char *same = quoin_model_to_text (again);
  g_assert_cmpstr (text, ==, same);
  quoin_free (text);
  quoin_free (same);
  quoin_model_unref (again);
  quoin_model_unref (model);

  quoin_builder_set (builder, "laws[0].friction", "-1");
  g_assert_null (quoin_builder_finish (builder, &error));
  g_assert_cmpstr (quoin_error_get_key (error), ==, "laws[0].friction");
  quoin_error_free (error);
  quoin_builder_free (builder);
}

/* A force of half the weight at the centroid pushes the block at twice the friction. */
static void
test_builder_forces (void)
{
  QuoinError *error = NULL;
  QuoinBuilder *builder = library_build_sliding_block ();
  quoin_builder_add_force (builder, "a", 5000, 0, 0, true);
  QuoinModel *model = quoin_builder_finish (builder, &error);
  g_assert_nonnull (model);
  QuoinResult *result = quoin_limit (model, false, NULL, NULL, &error);
  g_assert_nonnull (result);
  g_assert_cmpfloat_with_epsilon (quoin_result_get_collapse_multiplier (result), 0.8,
                                  1e-5);
  quoin_result_free (result);
  quoin_model_unref (model);
  quoin_builder_free (builder);
}

/* What wall 3 says beside its multiplier. */
static void
assert_answer (const QuoinResult *result)
{
  double collapse = quoin_result_get_collapse_multiplier (result);
  double interval[2], moved[2];
  size_t solutions = quoin_result_get_solution_count (result), count;
  size_t events = quoin_result_get_event_count (result);

  g_assert_cmpuint (solutions, >=, 1);
  for (size_t i = 0; i < solutions; i++)
    g_assert_cmpfloat (quoin_result_get_solution_multiplier (result, i), >=, collapse);
  g_assert_cmpstr (quoin_result_get_solution_found_by (result, 0), ==, "work");
  g_assert_cmpfloat (quoin_result_get_solution_displacement (result, 0), >, 0);
  quoin_result_get_collapse_interval (result, interval);
  g_assert_cmpfloat (interval[0], ==, collapse);
  g_assert_cmpfloat (interval[1], >, collapse);
  g_assert_cmpint (quoin_result_is_beyond_linear (result), ==,
                   !isnan (quoin_result_get_beyond_linear_multiplier (result)));

  g_assert_cmpuint (events, >=, 1);
  g_assert_cmpstr (quoin_result_get_event_kind (result, events - 1), ==, "collapse");
  g_assert_cmpfloat (quoin_result_get_event_multiplier (result, events - 1), ==,
                     collapse);
  quoin_result_get_event_displacements (result, events - 1, moved);
  g_assert_cmpfloat (moved[0], >, 0);
  g_assert_cmpfloat (moved[1], >, moved[0]);
  g_assert_cmpfloat (quoin_result_get_event_energy (result, events - 1), >=, 0);
  const int32_t *blocks = quoin_result_get_event_blocks (result, events - 1, &count);
  g_assert_cmpuint (count, >, 0);
  g_assert_cmpint (blocks[count - 1], <, 47);
}

static void
test_results (void)
{
  QuoinError *error = NULL;
  QuoinModel *model = open_wall (3);
  QuoinResult *result = quoin_solve (model, NULL, NULL, &error);
  size_t steps = quoin_result_get_step_count (result);
  size_t bodies = quoin_result_get_body_count (result);
  g_assert_cmpuint (bodies, ==, quoin_model_get_block_count (model));
  g_assert_cmpuint (quoin_result_get_pair_count (result), ==,
                    quoin_model_get_pair_count (model));
  const double *multipliers = quoin_result_get_multipliers (result);
  g_assert_cmpfloat (multipliers[0], ==, 0);
  g_assert_cmpfloat (multipliers[steps - 1], ==,
                     quoin_result_get_collapse_multiplier (result));
  g_assert_nonnull (quoin_result_get_mechanism (result));
  g_assert_true (isnan (quoin_result_get_lower_bound (result)));
  assert_answer (result);

  /* Every open pair is without force. */
  const double *forces = quoin_result_get_forces (result);
  for (size_t i = 0; i < quoin_result_get_pair_count (result); i++) {
    g_assert_cmpfloat (forces[2 * i], <=, 0);
    if (strcmp (quoin_result_get_pair_state (result, i), "open") == 0)
      g_assert_true (forces[2 * i] == 0 && forces[2 * i + 1] == 0);
  }

  /* What is written reads back. */
  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *path = g_build_filename (folder, "r.json", NULL);
  g_assert_true (quoin_result_write (result, path, &error));
  QuoinResult *read = quoin_result_read (model, path, &error);
  g_assert_nonnull (read);
  g_assert_cmpuint (quoin_result_get_step_count (read), ==, steps);
  assert_answer (read);
  g_assert_cmpmem (quoin_result_get_displacements (read), steps * bodies * 24,
                   quoin_result_get_displacements (result), steps * bodies * 24);
  quoin_result_free (read);

  QuoinModel *other = open_wall (4);
  g_assert_null (quoin_result_read (other, path, &error));
  g_assert_cmpint (quoin_error_get_kind (error), ==, QUOIN_ERROR_INVALID);
  quoin_error_free (error);
  quoin_model_unref (other);
  quoin_result_free (result);
  quoin_model_unref (model);
}

static void
test_limit_bounds (void)
{
  QuoinError *error = NULL;
  QuoinModel *model = open_wall (1);
  QuoinResult *bound = quoin_limit (model, true, NULL, NULL, &error);
  g_assert_nonnull (bound);
  g_assert_cmpfloat_with_epsilon (quoin_result_get_lower_bound (bound), 0.642859, 1e-6);
  g_assert_cmpfloat (quoin_result_get_lower_bound (bound), <=,
                     quoin_result_get_upper_bound (bound));
  /* The model itself is as it was. */
  const char *const friction[] = { "laws[0].friction=0.5", NULL };
  QuoinModel *slippery = quoin_model_with (model, friction, &error);
  QuoinResult *less = quoin_limit (slippery, true, NULL, NULL, &error);
  g_assert_cmpfloat (quoin_result_get_upper_bound (less), <,
                     quoin_result_get_lower_bound (bound));
  quoin_result_free (less);
  quoin_model_unref (slippery);
  quoin_result_free (bound);
  quoin_model_unref (model);
}

static bool
cancel_at_third (double multiplier, int32_t steps, int32_t iterations, void *data)
{
  int *calls = data;
  g_assert_true (isfinite (multiplier) && steps >= 0 && iterations >= 0);
  return ++*calls < 3;
}

static void
test_cancel (void)
{
  int calls = 0;
  QuoinModel *model = open_wall (6);
  QuoinResult *result = quoin_solve (model, cancel_at_third, &calls, NULL);
  g_assert_cmpint (calls, ==, 3);
  g_assert_cmpstr (quoin_result_get_outcome (result), ==, "cancelled");
  g_assert_true (isnan (quoin_result_get_collapse_multiplier (result)));
  quoin_result_free (result);
  quoin_model_unref (model);
}

/* A block on two springs: omega^2 = 2 kn / 2 / m for the vertical motion. */
static void
test_modes (void)
{
  QuoinError *error = NULL;
  QuoinBuilder *builder = library_build_sliding_block ();
  QuoinModel *model = quoin_builder_finish (builder, &error);
  QuoinModes *modes = quoin_modal (model, 3, false, NULL, NULL, &error);
  g_assert_nonnull (modes);
  g_assert_cmpuint (quoin_modes_get_count (modes), ==, 3);
  double mass = quoin_model_get_block_weight (model, 1) / 9.81;
  double vertical = sqrt (1e7 / mass), nearest = INFINITY;
  for (size_t i = 0; i < 3; i++)
    nearest = fmin (nearest, fabs (quoin_modes_get_omega (modes)[i] / vertical - 1));
  g_assert_cmpfloat (nearest, <, 1e-9);
  /* Effective masses of all modes are the mass of the block, whose modes move it as a whole. */
  const double *masses = quoin_modes_get_masses (modes),
               *omega = quoin_modes_get_omega (modes);
  double sums[2] = { 0 }, damping[2] = { 0 };
  for (size_t i = 0; i < 3; i++)
    for (int k = 0; k < 2; k++)
      sums[k] += masses[3 * i + 1 + (size_t) k];
  for (int k = 0; k < 2; k++)
    g_assert_cmpfloat_with_epsilon (sums[k] / mass, 1, 1e-9);
  quoin_modes_get_damping (modes, 0.05, damping);
  for (size_t i = 0; i < 3; i += 2)
    g_assert_cmpfloat_with_epsilon (damping[0] + damping[1] * omega[i] * omega[i],
                                    0.1 * omega[i], 1e-9 * omega[i]);
  quoin_modes_free (modes);
  /* No joint slides: the tangent is that of closed joints. */
  modes = quoin_modal_sliding (model, 3, false, NULL, NULL, &error);
  g_assert_cmpuint (quoin_modes_get_count (modes), ==, 3);
  quoin_modes_free (modes);
  quoin_model_unref (model);
  quoin_builder_free (builder);
}

static void
test_figure (void)
{
  QuoinError *error = NULL;
  QuoinModel *model = open_wall (3);
  QuoinResult *result = quoin_limit (model, true, NULL, NULL, &error);
  QuoinFigure *figure = quoin_figure_new (model, result, "mechanism", &error);
  g_assert_nonnull (figure);
  quoin_model_unref (model); /* the figure holds what it draws */
  quoin_result_free (result);
  g_assert_true (quoin_figure_set (figure, "size", "400x300", &error));
  g_assert_true (quoin_figure_set (figure, "loads", "off", &error));
  static const char *const wrong[][2] = { { "size", "400" },   { "step", "7" },
                                          { "loads", "yes" },  { "field", "colour" },
                                          { "scale", "-1" },   { "dpi", "nan" },
                                          { "colour", "red" }, { "step", "0.5" } };
  for (size_t i = 0; i < G_N_ELEMENTS (wrong); i++) {
    error = NULL;
    g_assert_false (quoin_figure_set (figure, wrong[i][0], wrong[i][1], &error));
    g_assert_cmpint (quoin_error_get_kind (error), ==, QUOIN_ERROR_USAGE);
    quoin_error_free (error);
  }
  error = NULL;
  size_t length;
  char *svg = quoin_figure_encode (figure, "svg", &length, &error);
  g_assert_nonnull (g_strstr_len (svg, (gssize) length, "<svg"));
  quoin_free (svg);
  g_assert_null (quoin_figure_encode (figure, "bmp", &length, &error));
  g_assert_cmpint (quoin_error_get_kind (error), ==, QUOIN_ERROR_USAGE);
  quoin_error_free (error);

  test_autoscratch char *folder = test_scratch_new ();
  g_autofree char *path = g_build_filename (folder, "wall.png", NULL);
  g_autofree char *content = NULL;
  g_assert_true (quoin_figure_write (figure, path, NULL));
  g_assert_true (g_file_get_contents (path, &content, &length, NULL));
  g_assert_cmpmem (content, 4, "\x89PNG", 4);
  quoin_figure_free (figure);
}

static gpointer
solve_wall (gpointer model)
{
  QuoinResult *result = quoin_solve (model, NULL, NULL, NULL);
  double *multiplier = g_new (double, 1);
  *multiplier = quoin_result_get_collapse_multiplier (result);
  quoin_result_free (result);
  return multiplier;
}

/* One model in four threads gives the same bits four times. */
static void
test_threads (void)
{
  GThread *threads[4];
  double *multipliers[4];
  QuoinModel *model = open_wall (5);
  for (int i = 0; i < 4; i++)
    threads[i] = g_thread_new ("solve", solve_wall, model);
  for (int i = 0; i < 4; i++)
    multipliers[i] = g_thread_join (threads[i]);
  for (int i = 0; i < 4; i++) {
    g_assert_true (*multipliers[i] == *multipliers[0]);
    if (i > 0)
      g_free (multipliers[i]);
  }
  g_free (multipliers[0]);
  quoin_model_unref (model);
}

static QuoinError *error;

/* How much is done never falls, begins with 0 and ends with 1. */
static bool
watch_share (double multiplier, int32_t steps, int32_t iterations, void *data)
{
  double *last = data, done = quoin_progress_get_done ();
  (void) multiplier;
  (void) steps;
  (void) iterations;
  g_assert_true (isnan (*last) ? done == 0 : done >= *last && *last < 1);
  g_assert_nonnull (quoin_progress_get_what ());
  *last = done;
  return true;
}

static void
test_progress (void)
{
  QuoinModel *model = open_wall (1);
  double done = NAN;
  quoin_result_free (quoin_solve (model, watch_share, &done, &error));
  g_assert_true (done == 1);
  g_assert_null (quoin_progress_get_what ());
  quoin_model_unref (model);
}

/* A model is what it was read from, and a result is of the model with the overrides of its file. */
static void
test_read_again (void)
{
  const char *const fewer[] = { "analysis.increments=20", NULL };
  QuoinModel *wall = open_wall (1), *model = quoin_model_with (wall, fewer, &error);
  size_t length;
  const char *source = quoin_model_get_source (model, &length);
  g_assert_cmpstr (quoin_model_get_override (model, 0), ==, fewer[0]);
  g_assert_null (quoin_model_get_override (model, 1));
  QuoinModel *again =
    quoin_model_parse (source, length, quoin_model_get_path (model), fewer, &error);
  QuoinResult *result = quoin_limit (model, true, NULL, NULL, &error);
  g_autofree char *text = quoin_result_to_text (result);
  QuoinResult *read = quoin_result_parse (wall, text, strlen (text), "r", &error);
  g_assert_null (error);
  g_assert_false (quoin_result_is_of_changed_model (read));
  g_assert_cmpstr (quoin_model_get_override (quoin_result_get_model (read), 0), ==,
                   fewer[0]);
  quoin_result_free (read);
  quoin_result_free (result);

  /* Other values than its own on top of them. */
  result = quoin_solve (again, NULL, NULL, &error);
  quoin_free (text);
  text = quoin_result_to_text (result);
  const char *const slippery[] = { "laws[0].friction=0.5", NULL };
  QuoinModel *other = quoin_model_with (wall, slippery, &error);
  read = quoin_result_parse (other, text, strlen (text), "r", &error);
  g_assert_true (quoin_result_is_of_changed_model (read));
  quoin_result_free (read);
  quoin_result_free (result);
  quoin_model_unref (other);
  quoin_model_unref (again);
  quoin_model_unref (model);
  quoin_model_unref (wall);
}

/* Options and report of an import, masonry, and what a check finds. */
static void
test_made_models (void)
{
  g_autofree char *drawing =
    g_build_filename (g_getenv ("QUOIN_EXAMPLES"), "dxf", "wall-mortar.dxf", NULL);
  const char *const options[] = { "unit=mm", "close-joints=0.02", "layer=SUPPORT=support",
                                  NULL };
  const char *const wrong[][2] = { { "unit", NULL },
                                   { "speed=3", NULL },
                                   { "unit=parsec", NULL },
                                   { "thickness=0", NULL } };
  char *report = NULL;
  QuoinModel *model = quoin_model_import_with (drawing, options, &report, &error);
  g_assert_null (error);
  g_assert_nonnull (strstr (report, "joints of mortar"));
  quoin_free (report);
  quoin_model_unref (model);
  for (gsize i = 0; i < G_N_ELEMENTS (wrong); i++) {
    g_assert_null (quoin_model_import_with (drawing, wrong[i], &report, &error));
    g_assert_null (report);
    g_assert_cmpint (quoin_error_get_kind (error), ==, QUOIN_ERROR_USAGE);
    quoin_error_free (error);
    error = NULL;
  }
  const char *const keys[] = { "length=3", "unit=0.5x0.25", NULL };
  model = quoin_model_generate ("wall", keys, 0.7, &error);
  g_assert_null (error);
  char *found = quoin_model_check (model);
  g_assert_nonnull (strstr (found, "\"sound\": true"));
  quoin_free (found);
  quoin_model_unref (model);
  g_assert_null (quoin_model_generate ("tower", NULL, 0.7, &error));
  g_assert_cmpint (quoin_error_get_kind (error), ==, QUOIN_ERROR_USAGE);
  quoin_error_free (error);
  error = NULL;
}

static bool
is_error (QuoinErrorKind kind, const char *part)
{
  bool is = error != NULL && quoin_error_get_kind (error) == kind
            && strstr (quoin_error_get_message (error), part) != NULL;
  quoin_error_free (error);
  error = NULL;
  return is;
}

/* Curves and mechanisms of two results, a report, and a short film. */
static void
test_sheets (void)
{
  const char *const slippery[] = { "laws[0].friction=0.5", NULL };
  QuoinModel *wall = open_wall (1), *other = quoin_model_with (wall, slippery, &error);
  QuoinResult *a = quoin_limit (wall, true, NULL, NULL, &error);
  QuoinResult *b = quoin_solve (other, NULL, NULL, &error);
  size_t length;
  static const char *const sheets[][3] = {
    { "curve", "svg", "title=Friction" },  { "curve", "csv", "label=rough" },
    { "compare", "pdf", "columns=1" },     { "compare", "csv", "monochrome=on" },
    { "report", "pdf", "sections=model" }, { "mechanism", "gif", "frames=2" },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (sheets); i++) {
    g_auto (GStrv) option = g_strsplit (sheets[i][2], "=", 2);
    QuoinFigure *figure = quoin_figure_new (other, b, sheets[i][0], &error);
    quoin_figure_add (figure, i == 2 || i == 3 ? a : b);
    g_assert_true (quoin_figure_set (figure, "size", "160x120", &error));
    g_assert_true (quoin_figure_set (figure, option[0], option[1], &error));
    char *content = quoin_figure_encode (figure, sheets[i][1], &length, &error);
    g_assert_null (error);
    g_assert_cmpuint (length, >, 100);
    if (i == 1)
      g_assert_nonnull (strstr (content, "\"Wall 1 (rough)\",0,0,0,"));
    if (i == 3)
      g_assert_nonnull (strstr (content, "Sliding"));
    quoin_free (content);
    g_assert_false (quoin_figure_set (figure, "columns", "0", &error));
    g_assert_true (is_error (QUOIN_ERROR_USAGE, "columns=0"));
    quoin_figure_free (figure);
  }
  QuoinFigure *figure = quoin_figure_new (wall, a, "energy", &error);
  g_assert_null (quoin_figure_encode (figure, "svg", &length, &error));
  g_assert_true (is_error (QUOIN_ERROR_INVALID, "in time"));
  quoin_figure_free (figure);
  g_assert_null (quoin_figure_new (wall, NULL, "curve", &error));
  g_assert_true (is_error (QUOIN_ERROR_USAGE, "needs a result"));
  quoin_result_free (a);
  quoin_result_free (b);
  quoin_model_unref (other);
  quoin_model_unref (wall);
}

/* The answer is that of the command line, and what is missing is said. */
static void
test_capacity (void)
{
  static const char *const code[] = { "spectrum=type1", "ag=0.25g", "soil=B",
                                      "control=w.6.5", NULL };
  static const char *const wrong[][2] = {
    { "spectrum=type1", "ag and soil" },
    { "ag=1", "spectrum is missing" },
    { "speed=1", "no such option" },
    { "confidence=0.5", "1 or more" },
  };
  QuoinModel *wall = open_wall (1);
  double done = NAN;
  char *text = quoin_capacity (wall, code, NULL, watch_share, &done, &error);
  g_assert_null (error);
  g_assert_true (done == 1);
  g_assert_nonnull (strstr (text, "\"control_block\": \"w.6.5\""));
  g_assert_nonnull (strstr (text, "\"code\": \"EN 1998-3\""));
  quoin_free (text);
  for (gsize i = 0; i < G_N_ELEMENTS (wrong); i++) {
    const char *const options[] = { wrong[i][0], NULL };
    g_assert_null (quoin_capacity (wall, options, NULL, NULL, NULL, &error));
    g_assert_true (is_error (QUOIN_ERROR_USAGE, wrong[i][1]));
  }
  const char *const nobody[] = { "control=nobody", NULL };
  g_assert_null (quoin_capacity (wall, nobody, NULL, NULL, NULL, &error));
  g_assert_true (is_error (QUOIN_ERROR_INVALID, "nobody"));
  quoin_model_unref (wall);
}

/* What the program prints, and its errors. */
static void
test_command (void)
{
  const char *const version[] = { "--version", NULL }, *const none[] = { "chek", NULL },
                    *const missing[] = { "check", "/no/such.quoin", NULL };
  char *output = NULL;
  g_assert_true (quoin_command (version, &output, &error));
  g_assert_nonnull (strstr (output, quoin_version ()));
  quoin_free (output);
  g_assert_false (quoin_command (none, &output, &error));
  g_assert_null (output);
  g_assert_true (is_error (QUOIN_ERROR_USAGE, "chek"));
  g_assert_false (quoin_command (missing, NULL, &error));
  g_assert_true (is_error (QUOIN_ERROR_FILE, "such.quoin"));
  g_autofree char *program = g_strdup (g_getenv ("QUOIN_CLI"));
  g_setenv ("QUOIN_CLI", "/no/such/program", TRUE);
  g_assert_false (quoin_command (version, NULL, &error));
  g_assert_true (is_error (QUOIN_ERROR_FILE, "/no/such/program"));
  g_setenv ("QUOIN_CLI", program, TRUE);
}

/* The change of the multiplier by the friction of the sliding block, tan phi, is 1 per 1. */
static void
test_sensitivity (void)
{
  QuoinBuilder *builder = library_build_sliding_block ();
  quoin_builder_add_live_weight (builder, 1, 0);
  QuoinModel *model = quoin_builder_finish (builder, &error);
  QuoinResult *result = quoin_limit (model, true, NULL, NULL, &error),
              *other = quoin_limit (model, false, NULL, NULL, &error);
  char *text = quoin_limit_sensitivity (result, &error);
  g_assert_null (error);
  const char *friction = strstr (text, "\"friction\": ");
  g_assert_nonnull (friction);
  g_assert_cmpfloat_with_epsilon (g_ascii_strtod (friction + 12, NULL), 1, 1e-6);
  quoin_free (text);
  g_assert_null (quoin_limit_sensitivity (other, &error));
  g_assert_true (is_error (QUOIN_ERROR_NO_ANSWER, "no collapse by associative"));
  quoin_result_free (result);
  quoin_result_free (other);
  quoin_model_unref (model);
  quoin_builder_free (builder);
}

/* An analysis in time reads its records as the command line does; without them it is refused, and the
 * model is there all the same. */
static void
test_records (void)
{
  g_autofree char *path =
    g_build_filename (g_getenv ("QUOIN_EXAMPLES"), "43-shaken-wall.quoin", NULL);
  const char *const shortened[] = { "analysis.dynamic.duration=0.05",
                                    "analysis.dynamic.ground[0].scale=0.1", NULL };
  const char *const missing[] = { "analysis.dynamic.ground[0].record=none.csv", NULL };
  QuoinModel *model = quoin_model_open (path, NULL, &error);
  g_assert_null (error);
  g_assert_cmpuint (quoin_model_get_warning_count (model), ==, 0);
  quoin_model_unref (model);

  model = quoin_model_open (path, missing, &error);
  g_assert_nonnull (model);
  g_assert_cmpuint (quoin_model_get_warning_count (model), ==, 1);
  g_assert_null (quoin_solve (model, NULL, NULL, &error));
  g_assert_cmpint (quoin_error_get_kind (error), ==, QUOIN_ERROR_FILE);
  quoin_error_free (error);
  error = NULL;
  quoin_model_unref (model);

  /* What the duration cuts off is refused likewise. */
  model = quoin_model_open (path, shortened, &error);
  g_assert_null (quoin_solve (model, NULL, NULL, &error));
  g_assert_nonnull (strstr (quoin_error_get_message (error), "Arias"));
  quoin_error_free (error);
  error = NULL;
  quoin_model_unref (model);
}

/* The Euler load of a pinned column, as words and as a file; in linear geometry nothing buckles. */
static void
test_stability (void)
{
  g_autofree char *path =
    g_build_filename (g_getenv ("QUOIN_EXAMPLES"), "21-column-pinned.quoin", NULL);
  const char *const linear[] = { "analysis.geometry=linear", NULL };
  QuoinModel *model = quoin_model_open (path, linear, &error);
  g_assert_null (quoin_stability (model, NULL, NULL, &error));
  g_assert_cmpint (quoin_error_get_kind (error), ==, QUOIN_ERROR_INVALID);
  quoin_error_free (error);
  error = NULL;
  quoin_model_unref (model);

  model = quoin_model_open (path, NULL, &error);
  QuoinResult *result = quoin_stability (model, NULL, NULL, &error);
  g_assert_null (error);
  g_assert_cmpstr (quoin_result_get_outcome (result), ==, "snap");
  /* 2467.4 kN of Euler, in blocks */
  g_assert_cmpfloat_with_epsilon (quoin_result_get_first_limit_multiplier (result),
                                  2467.4, 5);
  g_autofree char *faults = NULL, *text = NULL;
  char *described = quoin_result_describe (result);
  g_test_message ("%s", described);
  g_assert_cmpuint (strlen (described), >, 20);
  quoin_free (described);
  g_assert_true (quoin_result_check (result, &faults, &error));
  g_assert_cmpstr (faults, ==, "");
  text = quoin_result_to_text (result);
  g_assert_nonnull (strstr (text, "\"outcome\": \"snap\""));
  g_assert_nonnull (strstr (text, "\"normal\": ["));
  quoin_result_free (result);
  quoin_model_unref (model);
}

/* Structures without supports vibrate too, with three rigid motions. */
static void
test_free_modes (void)
{
  g_autofree char *path =
    g_build_filename (g_getenv ("QUOIN_EXAMPLES"), "25-four-bricks.quoin", NULL);
  QuoinModel *model = quoin_model_open (path, NULL, &error);
  QuoinModes *modes = quoin_modal (model, 4, false, NULL, NULL, &error);
  g_assert_null (error);
  const double *omega = quoin_modes_get_omega (modes);
  g_assert_cmpuint (quoin_modes_get_count (modes), ==, 4);
  g_assert_cmpfloat (omega[2], <, 1e-3 * omega[3]);
  /* 2402.27 Hz */
  g_assert_cmpfloat_with_epsilon (omega[3] / (2 * G_PI), 2402.27, 0.01);
  quoin_modes_free (modes);
  quoin_model_unref (model);
}

QN_TESTS
{
  g_test_add_func ("/library/progress", test_progress);
  g_test_add_func ("/library/sensitivity", test_sensitivity);
  g_test_add_func ("/library/read-again", test_read_again);
  g_test_add_func ("/library/made-models", test_made_models);
  g_test_add_func ("/library/sheets", test_sheets);
  g_test_add_func ("/library/capacity", test_capacity);
  g_test_add_func ("/library/command", test_command);
  g_test_add_func ("/library/records", test_records);
  g_test_add_func ("/library/free-modes", test_free_modes);
  g_test_add_func ("/library/stability", test_stability);
  g_test_add_func ("/library/ties", test_ties);
  g_test_add_func ("/library/model", test_model);
  g_test_add_func ("/library/error-names-the-place", test_error_names_the_place);
  g_test_add_func ("/library/edge-loads", test_edge_loads);
  g_test_add_func ("/library/builder", test_builder);
  g_test_add_func ("/library/builder-forces", test_builder_forces);
  g_test_add_func ("/library/results", test_results);
  g_test_add_func ("/library/limit-bounds", test_limit_bounds);
  g_test_add_func ("/library/cancel", test_cancel);
  g_test_add_func ("/library/modes", test_modes);
  g_test_add_func ("/library/figure", test_figure);
  g_test_add_func ("/library/threads", test_threads);
}
