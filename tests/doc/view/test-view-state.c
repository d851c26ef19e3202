#include "doc/view/view-state.h"

#include "doc/fixture.h"
#include "support/room.h"

static void
on_changed (gpointer counter)
{
  (*(int *) counter)++;
}

static void
test_without_result (void)
{
  g_autoptr (QnDocument) document = open_example ("02-overturning-block.quoin");
  g_autoptr (QnViewState) state = qn_view_state_new (document);
  int changes = 0;
  g_signal_connect_swapped (state, "changed", G_CALLBACK (on_changed), &changes);
  g_assert_cmpint (state->options.view, ==, QN_VIEW_MODEL);
  g_assert_cmpint (qn_view_state_get_step (state), ==, QN_STEP_LAST);
  qn_view_state_set_view (state, QN_VIEW_CONTACTS);
  qn_view_state_set_view (state, QN_VIEW_CONTACTS);
  g_assert_cmpint (changes, ==, 1);

  const QnModel *model;
  const QnContacts *contacts;
  const QnResult *result;
  g_assert_true (
    qn_view_state_get_content (state, state->options.view, &model, &contacts, &result));
  g_assert_true (model == &document->project.model);
  g_assert_null (result);
  g_assert_false (
    qn_view_state_get_content (state, QN_VIEW_MECHANISM, &model, &contacts, &result));
  g_assert_null (state->options.underlay.image);
}

static void
test_switches (void)
{
  g_autoptr (QnDocument) document = qn_document_new ();
  g_autoptr (QnViewState) state = qn_view_state_new (document);
  static const char *const names[] = { "ghost",      "symbols", "loads",
                                       "dimensions", "names",   "monochrome" };
  for (gsize i = 0; i < G_N_ELEMENTS (names); i++) {
    int changes = 0;
    gulong handler =
      g_signal_connect_swapped (state, "changed", G_CALLBACK (on_changed), &changes);
    gboolean before = qn_view_state_get_switch (state, names[i]);
    qn_view_state_set_switch (state, names[i], before);
    g_assert_cmpint (changes, ==, 0);
    qn_view_state_set_switch (state, names[i], !before);
    g_assert_cmpint (changes, ==, 1);
    g_assert_true (qn_view_state_get_switch (state, names[i]) == !before);
    g_signal_handler_disconnect (state, handler);
  }
}

/* Steps are clamped to those there are, another run starts at its end. */
static void
test_steps (void)
{
  g_autoptr (QnDocument) document = open_example ("02-overturning-block.quoin");
  g_autoptr (QnViewState) state = qn_view_state_new (document);
  const QnRun *run = solve_example (document);
  int count = (int) run->result.step_count;
  g_assert_cmpint (count, >, 3);
  qn_view_state_set_view (state, QN_VIEW_DEFORMED);
  double fitting = qn_view_state_get_shown_scale (state);
  g_assert_cmpfloat (fitting, >, 1.0);
  qn_view_state_set_step (state, 2);
  g_assert_cmpfloat (qn_view_state_get_shown_scale (state), ==, fitting);
  qn_view_state_set_scale (state, 1.0);
  g_assert_cmpfloat (qn_view_state_get_shown_scale (state), ==, 1.0);
  /* The true scale of displacements is none of a mechanism. */
  qn_view_state_set_view (state, QN_VIEW_MECHANISM);
  g_assert_cmpfloat (qn_view_state_get_options (state).scale, ==, QN_SCALE_AUTO);
  qn_view_state_set_view (state, QN_VIEW_DEFORMED);
  g_assert_cmpfloat (qn_view_state_get_options (state).scale, ==, 1.0);
  g_assert_cmpint (qn_view_state_get_step (state), ==, 2);
  g_assert_cmpint (qn_view_state_get_options (state).step, ==, 2);
  qn_view_state_set_step (state, count + 5);
  g_assert_cmpint (qn_view_state_get_step (state), ==, QN_STEP_LAST);
  qn_view_state_set_step (state, 1);
  solve_example (document);
  g_assert_cmpint (qn_view_state_get_step (state), ==, QN_STEP_LAST);

  /* The first run as an outline over the second, but not over itself. */
  g_assert_true (
    qn_document_analyse_with (document, QN_PROCEDURE_LIMIT, QN_FLOW_ASSOCIATIVE, NULL));
  wait_for_job (document);
  const GPtrArray *runs = document->runs;
  qn_view_state_set_onion (state, g_ptr_array_index (runs, 0));
  g_assert_true (qn_view_state_get_options (state).onion
                 == &((QnRun *) g_ptr_array_index (runs, 0))->result);
  qn_document_set_run (document, g_ptr_array_index (runs, 0));
  g_assert_null (qn_view_state_get_options (state).onion);

  /* Without runs only the model is left to be shown. */
  while (runs->len > 0)
    qn_document_remove_run (document, g_ptr_array_index (runs, 0));
  g_assert_cmpint (state->options.view, ==, QN_VIEW_MODEL);
  g_assert_null (state->onion);
}

QN_TESTS
{
  g_test_add_func ("/doc/view-state/without-result", test_without_result);
  g_test_add_func ("/doc/view-state/switches", test_switches);
  g_test_add_func ("/doc/view-state/steps", test_steps);
}
