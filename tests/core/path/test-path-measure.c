#include "core/path/path-measure.h"
#include "support/models.h"
#include "support/room.h"

#include <glib.h>
#include <math.h>

/* A block on a plane under its weight, pushed by it, with a path that stands at the dead
 * load. */
typedef struct {
  QnModel model;
  QnContacts contacts;
  QnResult result;
  QnPath path;
} Fixture;

static void
set_up (Fixture *fixture, QnProcedure procedure, bool controlled)
{
  QnModel *model = &fixture->model;
  bool stands = false;
  test_model_init_block_on_plane (model, 0.4, 1);
  test_model_add_weight_loads (model, 1);
  g_assert_cmpint (qn_model_prepare (model, NULL), ==, QN_OK);
  model->analysis.procedure = procedure;
  model->analysis.increments = 50;
  model->analysis.control.block =
    controlled ? qn_model_find_block (model, "block") : QN_NONE;
  model->analysis.control.dof = QN_DOF_RZ;
  model->analysis.control.target = -0.1;
  g_assert_cmpint (qn_contacts_detect (model, &fixture->contacts, NULL), ==, QN_OK);
  g_assert_cmpint (qn_path_setup (&fixture->path, model, &fixture->contacts, NULL, NULL,
                                  &fixture->result, NULL),
                   ==, QN_OK);
  g_assert_cmpint (qn_path_apply_dead_load (&fixture->path, &stands, NULL), ==, QN_OK);
  g_assert_true (stands);
}

static void
tear_down (Fixture *fixture)
{
  qn_path_clear (&fixture->path);
  qn_result_clear (&fixture->result);
  qn_contacts_clear (&fixture->contacts);
  qn_model_clear (&fixture->model);
}

/* A rotation is scaled like its unknown; the way is cut into the increments asked for. */
static void
test_displacement (void)
{
  Fixture fixture;
  QnPathMeasure measure;
  set_up (&fixture, QN_PROCEDURE_DISPLACEMENT, true);
  QnEquilibrium *eq = &fixture.path.equilibrium;
  double end = -0.1 * fixture.model.characteristic_length;
  g_assert_true (qn_path_measure_setup (&measure, &fixture.path));

  g_assert_cmpint (measure.unknown, ==, 2);
  g_assert_cmpfloat (measure.end, ==, end);
  g_assert_cmpfloat (measure.first, ==, end / 50);
  for (int i = 0; i < 3; i++)
    g_assert_cmpfloat (measure.direction[i], ==, i == 2);
  g_assert_cmpfloat_with_epsilon (qn_path_measure_share_to_end (&measure, end / 2), 2,
                                  1e-9);
  g_assert_false (qn_path_measure_is_at_end (&measure));
  eq->u[2] = end;
  g_assert_true (qn_path_measure_is_at_end (&measure));
  tear_down (&fixture);
}

/* The first step of an arc is as long as the first increment of load control would be, that
 * of work does the work of that increment; the live load is one weight along x. */
static void
test_first_steps (void)
{
  static const QnProcedure procedures[] = { QN_PROCEDURE_ARC_LENGTH, QN_PROCEDURE_WORK };
  for (size_t i = 0; i < G_N_ELEMENTS (procedures); i++) {
    Fixture fixture;
    QnPathMeasure measure;
    double rate[3], length = 0;
    set_up (&fixture, procedures[i], false);
    QnEquilibrium *eq = &fixture.path.equilibrium;
    g_assert_cmpint (qn_equilibrium_rate (eq, rate), ==, QN_SOLVE_CONVERGED);
    for (int d = 0; d < 3; d++)
      length = hypot (length, rate[d]);

    g_assert_true (qn_path_measure_setup (&measure, &fixture.path));
    g_assert_cmpint (measure.unknown, ==, QN_NONE);
    g_assert_true (isinf (qn_path_measure_share_to_end (&measure, 1)));
    g_assert_false (qn_path_measure_is_at_end (&measure));
    if (procedures[i] == QN_PROCEDURE_WORK)
      g_assert_cmpfloat_with_epsilon (measure.first, 4000 * rate[0] / 50,
                                      1e-9 * measure.first);
    else
      g_assert_cmpfloat_with_epsilon (measure.first, length / 50, 1e-9 * length);
    tear_down (&fixture);
  }
}

/* The arc turns into the direction of the step just taken. */
static void
test_follow (void)
{
  Fixture fixture;
  QnPathMeasure measure;
  set_up (&fixture, QN_PROCEDURE_ARC_LENGTH, false);
  QnEquilibrium *eq = &fixture.path.equilibrium;
  g_assert_true (qn_path_measure_setup (&measure, &fixture.path));

  g_assert_cmpfloat (qn_equilibrium_motion (eq), ==, 0);
  qn_path_measure_keep_last (&measure);
  eq->u[0] += 3e-3;
  eq->u[1] -= 4e-3;
  g_assert_cmpfloat_with_epsilon (qn_equilibrium_motion (eq), 5e-3, 1e-15);
  qn_path_measure_follow (&measure);
  g_assert_cmpfloat_with_epsilon (measure.direction[0], 0.6, 1e-12);
  g_assert_cmpfloat_with_epsilon (measure.direction[1], -0.8, 1e-12);
  g_assert_cmpfloat_with_epsilon (measure.direction[2], 0, 1e-12);
  tear_down (&fixture);
}

QN_TESTS
{
  g_test_add_func ("/path-measure/displacement", test_displacement);
  g_test_add_func ("/path-measure/first-steps", test_first_steps);
  g_test_add_func ("/path-measure/follow", test_follow);
}
