/* Analyses in time: what choosing one adds, ground motions added and removed, undone. */
#include "doc/edit/edit-dynamic.h"

#include "doc/fixture.h"
#include "support/room.h"

#include <glib/gstdio.h>
#include <string.h>

/* A block on a fixed one. */
static void
init (QnModel *model)
{
  const QnVec2 ground[] = { { -1, -1 }, { 1, -1 }, { 1, 0 }, { -1, 0 } };
  const QnVec2 stone[] = { { -0.5, 0 }, { 0.5, 0 }, { 0.5, 2 }, { -0.5, 2 } };
  qn_model_init (model);
  QnLaw *law = qn_model_add_law (model, "joint");
  law->kind = QN_LAW_COULOMB;
  law->kn = law->ks = 1e7;
  law->friction = 0.6;
  model->contact.law = 0;
  for (int i = 0; i < 2; i++) {
    QnBlock *block =
      qn_model_add_block (model, i == 0 ? "ground" : "stone", i == 0 ? ground : stone, 4);
    block->thickness = 1;
    block->unit_weight = 1e4;
    for (int dof = 0; dof < QN_DOF_COUNT; dof++)
      block->support[dof] = i == 0;
  }
}

static void
test_choose (void)
{
  QnModel model;
  init (&model);
  g_assert_true (qn_edit_choose_dynamic (&model, NULL));
  g_assert_cmpint (model.analysis.procedure, ==, QN_PROCEDURE_DYNAMIC);
  g_assert_cmpint (model.analysis.geometry, ==, QN_GEOMETRY_NONLINEAR);
  g_assert_cmpuint (model.ground_count, ==, 1);
  g_assert_cmpint (qn_model_prepare (&model, NULL), ==, QN_OK);
  qn_model_clear (&model);

  /* What is there stays. */
  init (&model);
  model.analysis.dynamic.duration = 3;
  model.analysis.dynamic.time_step = 0.01;
  model.analysis.geometry = QN_GEOMETRY_LINEAR;
  qn_model_add_initial_motion (&model)->block = 1;
  g_assert_true (qn_edit_choose_dynamic (&model, NULL));
  g_assert_cmpfloat (model.analysis.dynamic.duration, ==, 3);
  g_assert_cmpfloat (model.analysis.dynamic.time_step, ==, 0.01);
  g_assert_cmpint (model.analysis.geometry, ==, QN_GEOMETRY_LINEAR);
  g_assert_cmpuint (model.ground_count, ==, 0);
  qn_model_clear (&model);
}

static void
test_motions (void)
{
  g_autofree char *folder = g_dir_make_tmp ("quoin-XXXXXX", NULL);
  g_autofree char *path = g_build_filename (folder, "r.csv", NULL);
  g_autoptr (GError) error = NULL;
  QnModel model;
  g_assert_true (g_file_set_contents (
    path, "time [s],acceleration [g]\n0,0\n0.5,0.1\n1,-0.2\n", -1, NULL));
  init (&model);
  g_assert_true (qn_edit_add_pulse (&model, NULL));
  g_assert_true (qn_edit_add_record (&model, path, &error));
  g_assert_cmpuint (model.ground_count, ==, 2);
  g_assert_cmpint (model.ground[1].kind, ==, QN_SIGNAL_POINTS);
  g_assert_cmpuint (model.ground[1].point_count, ==, 3);
  g_assert_cmpfloat_with_epsilon (model.ground[1].points[2].y, -0.2 * 9.80665, 1e-12);
  g_autofree char *pulse = qn_ground_motion_dup_text (&model.ground[0]);
  g_autofree char *record = qn_ground_motion_dup_text (&model.ground[1]);
  g_assert_nonnull (strstr (pulse, "half sine"));
  g_assert_nonnull (strstr (record, "3 points, 1.96"));
  g_assert_true (qn_edit_remove_ground_motion (&model, 0, NULL));
  g_assert_cmpuint (model.ground_count, ==, 1);
  g_assert_cmpint (model.ground[0].kind, ==, QN_SIGNAL_POINTS);

  /* Without a unit nothing is guessed, and nothing added. */
  g_assert_true (g_file_set_contents (path, "0 0\n0.5 0.1\n", -1, NULL));
  g_assert_false (qn_edit_add_record (&model, path, &error));
  g_assert_nonnull (strstr (error->message, "unit"));
  g_assert_cmpuint (model.ground_count, ==, 1);
  g_assert_true (qn_edit_remove_ground_motion (&model, 0, NULL));
  g_assert_cmpuint (model.ground_count, ==, 0);
  qn_model_clear (&model);
  g_remove (path);
  g_remove (folder);
}

QN_TESTS
{
  g_test_add_func ("/edit-dynamic/choose", test_choose);
  g_test_add_func ("/edit-dynamic/motions", test_motions);
}
