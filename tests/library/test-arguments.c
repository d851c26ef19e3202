/* Calls of libquoin with NULL, numbers out of range, and errors that are set. */
#include "library/sliding-block.h"
#include "support/room.h"

#include <glib.h>
#include <math.h>
#include <string.h>

typedef struct Objects {
  QuoinBuilder *builder;
  QuoinModel *model;
  QuoinResult *result;
  QuoinFigure *figure;
  size_t far, count;
} Objects;

static QuoinError *error, *first;

/* The error of a call with NULL is one of usage. It is kept for the next call. */
static bool
is_usage (void)
{
  first = error;
  return error != NULL && quoin_error_get_kind (error) == QUOIN_ERROR_USAGE
         && strstr (quoin_error_get_message (error), "is NULL") != NULL;
}

/* The first error of two stays. */
static bool
is_first (void)
{
  bool same = error == first;
  quoin_error_free (error);
  error = NULL;
  return same;
}

#define REFUSED(...) (!(__VA_ARGS__) && is_usage () && !(__VA_ARGS__) && is_first ())

/* Every function of the library and what it does then. */
/* clang-format off */
#define RULES(X) \
  X (builder_add_block, (quoin_builder_add_block (NULL, "b", NULL, 4, 1, 1, true), true)) \
  X (builder_add_force, (quoin_builder_add_force (NULL, "b", 1, 0, 0, true), quoin_builder_add_force (o->builder, NULL, 1, 0, 0, true), true)) \
  X (builder_add_joint, (quoin_builder_add_joint (NULL, "j", 1, 1, 1, 0, 0, 0), quoin_builder_add_joint (o->builder, NULL, 1, 1, 1, 0, 0, 0), true)) \
  X (builder_add_live_weight, (quoin_builder_add_live_weight (NULL, 1, 0), true)) \
  X (builder_finish, REFUSED (quoin_builder_finish (NULL, &error))) \
  X (builder_free, (quoin_builder_free (NULL), true)) \
  X (builder_new, (quoin_builder_free (quoin_builder_new (NULL)), true)) \
  X (builder_set, (quoin_builder_set (NULL, "a", "1"), quoin_builder_set (o->builder, NULL, "1"), quoin_builder_set (o->builder, "a", NULL), true)) \
  X (capacity, REFUSED (quoin_capacity (NULL, NULL, NULL, NULL, NULL, &error))) \
  X (command, REFUSED (quoin_command (NULL, NULL, &error))) \
  X (command_watched, REFUSED (quoin_command_watched (NULL, NULL, NULL, NULL, &error))) \
  X (error_free, (quoin_error_free (NULL), true)) \
  X (error_get_column, quoin_error_get_column (NULL) == 0) \
  X (error_get_file, quoin_error_get_file (NULL) == NULL) \
  X (error_get_key, quoin_error_get_key (NULL) == NULL) \
  X (error_get_kind, quoin_error_get_kind (NULL) == QUOIN_ERROR_USAGE) \
  X (error_get_line, quoin_error_get_line (NULL) == 0) \
  X (error_get_message, quoin_error_get_message (NULL) == NULL) \
  X (figure_add, (quoin_figure_add (NULL, o->result), quoin_figure_add (o->figure, NULL), true)) \
  X (figure_encode, REFUSED (quoin_figure_encode (NULL, "png", &o->count, &error)) && REFUSED (quoin_figure_encode (o->figure, NULL, &o->count, &error)) && REFUSED (quoin_figure_encode (o->figure, "png", NULL, &error))) \
  X (figure_free, (quoin_figure_free (NULL), true)) \
  X (figure_new, REFUSED (quoin_figure_new (NULL, NULL, "model", &error)) && REFUSED (quoin_figure_new (o->model, NULL, NULL, &error))) \
  X (figure_set, REFUSED (quoin_figure_set (NULL, "dpi", "1", &error)) && REFUSED (quoin_figure_set (o->figure, NULL, "1", &error)) && REFUSED (quoin_figure_set (o->figure, "dpi", NULL, &error))) \
  X (figure_write, REFUSED (quoin_figure_write (NULL, "a.png", &error)) && REFUSED (quoin_figure_write (o->figure, NULL, &error))) \
  X (figure_write_watched, REFUSED (quoin_figure_write_watched (NULL, "a.png", NULL, NULL, &error)) && REFUSED (quoin_figure_write_watched (o->figure, NULL, NULL, NULL, &error))) \
  X (free, (quoin_free (NULL), true)) \
  X (limit_sensitivity, REFUSED (quoin_limit_sensitivity (NULL, &error))) \
  X (limit, REFUSED (quoin_limit (NULL, true, NULL, NULL, &error))) \
  X (modal, REFUSED (quoin_modal (NULL, 1, false, NULL, NULL, &error))) \
  X (model_check, quoin_model_check (NULL) == NULL) \
  X (model_generate, REFUSED (quoin_model_generate (NULL, NULL, 0.5, &error))) \
  X (model_get_block_area, isnan (quoin_model_get_block_area (NULL, 0)) && isnan (quoin_model_get_block_area (o->model, o->far))) \
  X (model_get_block_centroid, quoin_model_get_block_centroid (NULL, 0) == NULL && quoin_model_get_block_centroid (o->model, o->far) == NULL) \
  X (model_get_block_count, quoin_model_get_block_count (NULL) == 0) \
  X (model_get_block_name, quoin_model_get_block_name (NULL, 0) == NULL && quoin_model_get_block_name (o->model, o->far) == NULL) \
  X (model_get_block_thickness, isnan (quoin_model_get_block_thickness (NULL, 0)) && isnan (quoin_model_get_block_thickness (o->model, o->far))) \
  X (model_get_block_vertices, quoin_model_get_block_vertices (NULL, 0, &o->count) == NULL && o->count == 0 && quoin_model_get_block_vertices (o->model, o->far, NULL) == NULL && quoin_model_get_block_vertices (o->model, 0, NULL) != NULL) \
  X (model_get_block_weight, isnan (quoin_model_get_block_weight (NULL, 0)) && isnan (quoin_model_get_block_weight (o->model, o->far))) \
  X (model_get_face_blocks, (quoin_model_get_face_blocks (NULL, 0, NULL, NULL), quoin_model_get_face_blocks (o->model, o->far, NULL, NULL), quoin_model_get_face_blocks (o->model, 0, NULL, NULL), true)) \
  X (model_get_face_count, quoin_model_get_face_count (NULL) == 0) \
  X (model_get_face_ends, (quoin_model_get_face_ends (NULL, 0, NULL), quoin_model_get_face_ends (o->model, o->far, NULL), true)) \
  X (model_get_override, quoin_model_get_override (NULL, 0) == NULL && quoin_model_get_override (o->model, o->far) == NULL) \
  X (model_get_pair_count, quoin_model_get_pair_count (NULL) == 0) \
  X (model_get_pair_face, quoin_model_get_pair_face (NULL, 0) == SIZE_MAX && quoin_model_get_pair_face (o->model, o->far) == SIZE_MAX) \
  X (model_get_path, quoin_model_get_path (NULL) == NULL) \
  X (model_get_source, quoin_model_get_source (NULL, &o->count) == NULL && o->count == 0 && quoin_model_get_source (o->model, NULL) != NULL) \
  X (model_get_title, quoin_model_get_title (NULL) == NULL) \
  X (model_get_warning, quoin_model_get_warning (NULL, 0) == NULL && quoin_model_get_warning (o->model, o->far) == NULL) \
  X (model_get_warning_count, quoin_model_get_warning_count (NULL) == 0) \
  X (model_import, REFUSED (quoin_model_import (NULL, 0, 1, 1, 1, &error))) \
  X (model_import_with, REFUSED (quoin_model_import_with (NULL, NULL, NULL, &error))) \
  X (model_is_block_fixed, !quoin_model_is_block_fixed (NULL, 0, 0) && !quoin_model_is_block_fixed (o->model, o->far, 0) && !quoin_model_is_block_fixed (o->model, 0, 3) && !quoin_model_is_block_fixed (o->model, 0, -1)) \
  X (model_new, (quoin_model_unref (quoin_model_new (NULL)), true)) \
  X (model_open, REFUSED (quoin_model_open (NULL, NULL, &error))) \
  X (model_parse, REFUSED (quoin_model_parse (NULL, 1, "m", NULL, &error)) && REFUSED (quoin_model_parse ("{}", 2, NULL, NULL, &error))) \
  X (model_ref, quoin_model_ref (NULL) == NULL) \
  X (model_save, REFUSED (quoin_model_save (NULL, "m", &error)) && REFUSED (quoin_model_save (o->model, NULL, &error))) \
  X (model_to_text, quoin_model_to_text (NULL) == NULL) \
  X (model_unref, (quoin_model_unref (NULL), true)) \
  X (model_with, REFUSED (quoin_model_with (NULL, NULL, &error))) \
  X (modal_sliding, REFUSED (quoin_modal_sliding (NULL, 1, false, NULL, NULL, &error))) \
  X (modes_free, (quoin_modes_free (NULL), true)) \
  X (modes_get_body_count, quoin_modes_get_body_count (NULL) == 0) \
  X (modes_get_damping, (quoin_modes_get_damping (NULL, 0.05, NULL), true)) \
  X (modes_get_masses, quoin_modes_get_masses (NULL) == NULL) \
  X (modes_get_count, quoin_modes_get_count (NULL) == 0) \
  X (modes_get_omega, quoin_modes_get_omega (NULL) == NULL) \
  X (modes_get_shapes, quoin_modes_get_shapes (NULL) == NULL) \
  X (progress_get_done, isnan (quoin_progress_get_done ())) \
  X (progress_get_what, quoin_progress_get_what () == NULL) \
  X (result_check, REFUSED (quoin_result_check (NULL, NULL, &error))) \
  X (result_describe, quoin_result_describe (NULL) == NULL) \
  X (result_free, (quoin_result_free (NULL), true)) \
  X (result_get_beyond_linear_multiplier, isnan (quoin_result_get_beyond_linear_multiplier (NULL))) \
  X (result_get_body_count, quoin_result_get_body_count (NULL) == 0) \
  X (result_get_collapse_interval, (quoin_result_get_collapse_interval (NULL, NULL), quoin_result_get_collapse_interval (o->result, NULL), true)) \
  X (result_get_collapse_multiplier, isnan (quoin_result_get_collapse_multiplier (NULL))) \
  X (result_get_displacements, quoin_result_get_displacements (NULL) == NULL) \
  X (result_get_event_blocks, quoin_result_get_event_blocks (NULL, 0, &o->count) == NULL && o->count == 0 && quoin_result_get_event_blocks (o->result, o->far, NULL) == NULL) \
  X (result_get_event_count, quoin_result_get_event_count (NULL) == 0) \
  X (result_get_event_displacements, (quoin_result_get_event_displacements (NULL, 0, NULL), quoin_result_get_event_displacements (o->result, o->far, NULL), true)) \
  X (result_get_event_energy, isnan (quoin_result_get_event_energy (NULL, 0)) && isnan (quoin_result_get_event_energy (o->result, o->far))) \
  X (result_get_event_kind, quoin_result_get_event_kind (NULL, 0) == NULL && quoin_result_get_event_kind (o->result, o->far) == NULL) \
  X (result_get_event_multiplier, isnan (quoin_result_get_event_multiplier (NULL, 0)) && isnan (quoin_result_get_event_multiplier (o->result, o->far))) \
  X (result_get_factorizations, quoin_result_get_factorizations (NULL) == 0) \
  X (result_get_first_limit_multiplier, isnan (quoin_result_get_first_limit_multiplier (NULL))) \
  X (result_get_forces, quoin_result_get_forces (NULL) == NULL) \
  X (result_get_iterations, quoin_result_get_iterations (NULL) == 0) \
  X (result_get_lower_bound, isnan (quoin_result_get_lower_bound (NULL))) \
  X (result_get_mechanism, quoin_result_get_mechanism (NULL) == NULL) \
  X (result_get_model, quoin_result_get_model (NULL) == NULL) \
  X (result_get_multipliers, quoin_result_get_multipliers (NULL) == NULL) \
  X (result_get_outcome, quoin_result_get_outcome (NULL) == NULL) \
  X (result_get_pair_count, quoin_result_get_pair_count (NULL) == 0) \
  X (result_get_pair_state, quoin_result_get_pair_state (NULL, 0) == NULL && quoin_result_get_pair_state (o->result, o->far) == NULL) \
  X (result_get_solution_count, quoin_result_get_solution_count (NULL) == 0) \
  X (result_get_solution_displacement, isnan (quoin_result_get_solution_displacement (NULL, 0)) && isnan (quoin_result_get_solution_displacement (o->result, o->far))) \
  X (result_get_solution_found_by, quoin_result_get_solution_found_by (NULL, 0) == NULL && quoin_result_get_solution_found_by (o->result, o->far) == NULL) \
  X (result_get_solution_multiplier, isnan (quoin_result_get_solution_multiplier (NULL, 0)) && isnan (quoin_result_get_solution_multiplier (o->result, o->far))) \
  X (result_get_step_count, quoin_result_get_step_count (NULL) == 0) \
  X (result_get_tie, !quoin_result_get_tie (NULL, 0, 0, NULL, NULL) && !quoin_result_get_tie (o->result, o->far, 0, NULL, NULL) && !quoin_result_get_tie (o->result, 0, o->far, NULL, NULL)) \
  X (result_get_tie_count, quoin_result_get_tie_count (NULL) == 0) \
  X (result_get_tie_state, quoin_result_get_tie_state (NULL, 0, 0) == NULL && quoin_result_get_tie_state (o->result, o->far, 0) == NULL && quoin_result_get_tie_state (o->result, 0, o->far) == NULL) \
  X (result_get_upper_bound, isnan (quoin_result_get_upper_bound (NULL))) \
  X (result_is_beyond_linear, !quoin_result_is_beyond_linear (NULL)) \
  X (result_is_of_changed_model, !quoin_result_is_of_changed_model (NULL)) \
  X (result_parse, REFUSED (quoin_result_parse (NULL, "{}", 2, "r", &error)) && REFUSED (quoin_result_parse (o->model, NULL, 2, "r", &error)) && REFUSED (quoin_result_parse (o->model, "{}", 2, NULL, &error))) \
  X (result_read, REFUSED (quoin_result_read (NULL, "r", &error)) && REFUSED (quoin_result_read (o->model, NULL, &error))) \
  X (result_to_text, quoin_result_to_text (NULL) == NULL) \
  X (result_write, REFUSED (quoin_result_write (NULL, "r", &error)) && REFUSED (quoin_result_write (o->result, NULL, &error))) \
  X (solve, REFUSED (quoin_solve (NULL, NULL, NULL, &error))) \
  X (stability, REFUSED (quoin_stability (NULL, NULL, NULL, &error))) \
  X (version, quoin_version () != NULL)
/* clang-format on */

#define DEFINE_RULE(name, rule)                                                          \
  static bool rule_##name (Objects *o)                                                   \
  {                                                                                      \
    (void) o;                                                                            \
    return rule;                                                                         \
  }
RULES (DEFINE_RULE)

static const struct {
  const char *name;
  bool (*holds) (Objects *o);
} rules[] = {
#define LIST_RULE(name, rule) { "quoin_" #name, rule_##name },
  RULES (LIST_RULE)
#undef LIST_RULE
};

static void
test_wrong_arguments (void)
{
  QuoinBuilder *builder = library_build_sliding_block ();
  Objects o = { .builder = builder, .far = SIZE_MAX };
  quoin_builder_add_live_weight (builder, 1, 0);
  o.model = quoin_builder_finish (builder, &error);
  o.result = quoin_limit (o.model, true, NULL, NULL, &error);
  o.figure = quoin_figure_new (o.model, NULL, "model", &error);
  g_assert_null (error);
  for (gsize i = 0; i < G_N_ELEMENTS (rules); i++) {
    g_test_message ("%s", rules[i].name);
    g_assert_true (rules[i].holds (&o));
  }
  o.far = 2; /* just behind the last block */
  g_assert_null (quoin_model_get_block_name (o.model, o.far));

  /* None is left out. */
  g_autofree char *map = NULL;
  g_assert_true (g_file_get_contents (g_getenv ("QUOIN_MAP"), &map, NULL, NULL));
  gsize listed = 0;
  for (const char *at = map; (at = strstr (at, " quoin_")) != NULL; at++)
    listed++;
  g_assert_cmpuint (listed, ==, G_N_ELEMENTS (rules));
  quoin_figure_free (o.figure);
  quoin_result_free (o.result);
  quoin_model_unref (o.model);
  quoin_builder_free (builder);
}

QN_TESTS
{
  g_test_add_func ("/library/wrong-arguments", test_wrong_arguments);
}
