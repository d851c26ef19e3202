#include "doc/view/inspect.h"

#include "doc/fixture.h"
#include "support/room.h"
#include <string.h>

/* A shear force that is small beside the others of its step is told; one that rounding leaves is 0. */
static void
test_noise (void)
{
  g_autoptr (QnDocument) document = open_example ("05-stack.quoin");
  g_autoptr (QnViewState) state = qn_view_state_new (document);
  solve_example (document);
  QnStepView view;
  qn_view_state_set_view (state, QN_VIEW_DEFORMED);
  g_assert_true (qn_step_view_init (&view, state));
  const QnPick joint = { QN_PICK_FACE, 0 };
  g_assert_nonnull (view.pairs);
  for (gsize p = 0; p < view.contacts->pair_count; p++)
    view.pairs[p].shear_force = 1e-12 * view.force;
  g_autofree char *quiet = qn_inspect_dup_values (&view, joint, QN_UNITS_SI, FALSE);
  g_assert_nonnull (strstr (quiet, "T\t0\302\240N"));
  for (gsize p = 0; p < view.contacts->pair_count; p++)
    view.pairs[p].shear_force = 1e-6 * view.force;
  g_autofree char *told = qn_inspect_dup_values (&view, joint, QN_UNITS_SI, FALSE);
  g_assert_null (strstr (told, "T\t0\302\240N"));
  qn_step_view_clear (&view);
}

QN_TESTS
{
  g_test_add_func ("/doc/inspect/noise", test_noise);
}
