/* Pictures of reinforcing bars: they follow their blocks, in every view, and show their stress. */
#include "render/scene/reading.h"
#include "render/scene/scene-build.h"
#include "support/room.h"
#include "support/run.h"

#include <glib.h>
#include <string.h>

/* Three blocks of 1 m in a row, the first held, with a bar of 1e-4 m2 through their middles. */
#define AREA 1e-4

static void
add_law (QnModel *model, const char *name, double kn)
{
  QnLaw *law = qn_model_add_law (model, name);
  law->kind = QN_LAW_ELASTIC;
  law->basis = QN_BASIS_MATERIAL;
  law->kn = law->ks = kn;
}

static void
row_init (TestRun *row)
{
  QnModel *model = &row->model;
  qn_model_init (model);
  add_law (model, "stone", 1e9);
  add_law (model, "steel", 2e11);
  model->contact.law = 0;
  for (int i = 0; i < 3; i++) {
    QnVec2 v[4] = { { i, 0 }, { i + 1, 0 }, { i + 1, 1 }, { i, 1 } };
    g_autofree char *name = g_strdup_printf ("b%d", i);
    QnBlock *block = qn_model_add_block (model, name, v, 4);
    block->thickness = 1;
    block->unit_weight = 0;
    for (int dof = 0; dof < QN_DOF_COUNT; dof++)
      block->support[dof] = i == 0;
  }
  QnBar *bar = qn_model_add_bar (model);
  *bar = (QnBar){ .law = 1, .area = AREA, .start = { 2.9, 0.5 }, .end = { 0.1, 0.5 } };
  QnLoad *load = qn_model_add_live_load (model);
  load->kind = QN_LOAD_FORCE;
  load->block = 2;
  load->vector = qn_vec2 (1e6, 0);
  model->analysis.max_multiplier = 1;
  model->analysis.increments = 1;
  test_run_solve (row);
}

static QnScene *
build (const TestRun *row, QnView view, QnField field)
{
  QnViewOptions options;
  GError *error = NULL;
  qn_view_options_init (&options, view);
  options.field = field;
  options.scale = 1;
  QnScene *scene =
    qn_scene_build (&row->model, &row->contacts, &row->result, &options, &error);
  g_assert_no_error (error);
  return scene;
}

/* The index-th open line of this colour. */
static const QnCommand *
find_line (const QnScene *scene, QnColor color, int index)
{
  for (guint i = 0; i < scene->commands->len; i++) {
    const QnCommand *command = qn_scene_command (scene, i);
    if (command->kind == QN_COMMAND_STROKE && !command->closed
        && memcmp (&command->color, &color, sizeof color) == 0 && index-- == 0)
      return command;
  }
  return NULL;
}

static gboolean
has_legend (const QnScene *scene, const char *text)
{
  for (guint i = 0; i < scene->legend->len; i++)
    if (strstr (g_array_index (scene->legend, QnLegendEntry, i).text, text) != NULL)
      return TRUE;
  return FALSE;
}

/* Straight where blocks rest; at a joint it goes from where one block has moved to, to where the
 * other has. */
static void
test_follows (void)
{
  g_auto (TestRun) row = { 0 };
  row_init (&row);
  g_autoptr (QnScene) rest = build (&row, QN_VIEW_MODEL, QN_FIELD_NONE);
  const QnCommand *line = find_line (rest, qn_ink (QN_INK_BAR, false), 0);
  g_assert_nonnull (line);
  g_assert_cmpuint (line->count, ==, 6);
  const QnVec2 *p = qn_scene_points (rest, line);
  static const double x[] = { 2.9, 2, 2, 1, 1, 0.1 };
  for (int i = 0; i < 6; i++) {
    g_assert_cmpfloat_with_epsilon (p[i].x, x[i], 1e-12);
    g_assert_cmpfloat_with_epsilon (p[i].y, 0.5, 1e-12);
  }
  g_assert_true (has_legend (rest, "reinforcing bar, Ø 11.3 mm"));

  g_autoptr (QnScene) moved = build (&row, QN_VIEW_DEFORMED, QN_FIELD_NONE);
  line = find_line (moved, qn_ink (QN_INK_BAR, false), 0);
  g_assert_nonnull (line);
  p = qn_scene_points (moved, line);
  const double *u = qn_result_step_displacements (&row.result, row.result.step_count - 1);
  double third = u[2 * QN_DOF_COUNT], second = u[QN_DOF_COUNT];
  g_assert_cmpfloat (third, >, second);
  g_assert_cmpfloat (second, >, 0);
  const double shift[] = { third, third, second, second, 0, 0 };
  for (int i = 0; i < 6; i++)
    g_assert_cmpfloat_with_epsilon (p[i].x, x[i] + shift[i], 1e-12);
}

/* Along the joint between two columns of blocks a bar goes half-way between them: no point of it is farther
 * to a side than they are. */
static void
test_between_columns (void)
{
  g_auto (TestRun) run = { 0 };
  QnModel *model = &run.model;
  qn_model_init (model);
  add_law (model, "stone", 1e9);
  add_law (model, "steel", 2e11);
  model->contact.law = 0;
  for (int i = 0; i < 6; i++) {
    const double x = i % 2, y = i / 2;
    QnVec2 v[4] = { { x, y }, { x + 1, y }, { x + 1, y + 1 }, { x, y + 1 } };
    g_autofree char *name = g_strdup_printf ("b%d", i);
    QnBlock *block = qn_model_add_block (model, name, v, 4);
    block->thickness = 1;
    block->unit_weight = 0;
    for (int dof = 0; dof < QN_DOF_COUNT; dof++)
      block->support[dof] = i < 2;
  }
  QnBar *bar = qn_model_add_bar (model);
  *bar = (QnBar){ .law = 1, .area = AREA, .start = { 1, 0.2 }, .end = { 1, 2.8 } };
  QnLoad *load = qn_model_add_live_load (model);
  load->kind = QN_LOAD_FORCE;
  load->block = 5;
  load->vector = qn_vec2 (1e8, 1e7);
  model->analysis.max_multiplier = 1;
  model->analysis.increments = 1;
  test_run_solve (&run);
  g_autoptr (QnScene) scene = build (&run, QN_VIEW_DEFORMED, QN_FIELD_NONE);
  const QnCommand *line = find_line (scene, qn_ink (QN_INK_BAR, false), 0);
  g_assert_nonnull (line);
  const QnVec2 *p = qn_scene_points (scene, line);
  g_assert_cmpuint (line->count, ==, 6); /* both ends, and two at each of two joints */
  for (uint32_t i = 1; i < line->count; i++)
    g_assert_cmpfloat (p[i].x, >=, p[i - 1].x - 1e-9);
}

/* Bars of several diameters stand in one row of the legend. */
static void
test_diameters (void)
{
  g_auto (TestRun) row = { 0 };
  row_init (&row);
  QnBar *thick = qn_model_add_bar (&row.model);
  *thick = row.model.bars[0];
  thick->area = 4.0 * AREA;
  g_autoptr (QnScene) scene = build (&row, QN_VIEW_MODEL, QN_FIELD_NONE);
  g_assert_true (has_legend (scene, "reinforcing bars, Ø 11.3–22.6 mm"));
}

/* Bar and joint share the load like their stiffnesses; the legend tells the stress of the bar. */
static void
test_stress (void)
{
  g_auto (TestRun) row = { 0 };
  row_init (&row);
  g_autoptr (QnScene) scene = build (&row, QN_VIEW_DEFORMED, QN_FIELD_STRESS);
  QnColor most = qn_map_diverging (1, false);
  g_assert_nonnull (find_line (scene, most, 0));
  g_assert_nonnull (find_line (scene, most, 1)); /* a piece for each of two joints */
  g_assert_null (find_line (scene, most, 2));
  /* The strain is 1e6 / (1e9 x 1 + 2e11 x 1e-4), times E of the bar. */
  g_autofree char *text =
    g_strdup_printf ("tension up to %.3g MPa", 2e11 / 1.02e3 * 1e-6);
  g_assert_true (has_legend (scene, text));
  g_assert_false (has_legend (scene, "compression up to"));
  g_assert_false (has_legend (scene, "reinforcing bar"));
}

/* A joint that opens is a crack, as wide as the bar across it is long; one that is stretched elastically, or
 * yields as steel does, is none. Concrete that softens from 0.1 MPa to nothing at 0.2 m is as wide as it has
 * lengthened by beyond what its tension strains. Picture and table agree. */
static void
test_cracks (void)
{
  static const QnLawKind kinds[] = { QN_LAW_ELASTIC, QN_LAW_BILINEAR, QN_LAW_NO_TENSION,
                                     QN_LAW_CONCRETE };
  const double ft = 1e5, k = 1e9, wide = 0.2, bar = 2e11 * AREA,
               fall = ft / (wide - ft / k);
  const double whole = (1e6 - fall * wide) / (bar - fall);
  const double widths[] = { 0, 0, 1e6 / bar, whole - fall * (wide - whole) / k };
  for (size_t i = 0; i < G_N_ELEMENTS (kinds); i++) {
    g_auto (TestRun) row = { 0 };
    row_init (&row);
    qn_result_clear (&row.result);
    qn_contacts_clear (&row.contacts);
    QnLaw *law = &row.model.laws[0];
    law->kind = kinds[i];
    law->yield = ft;
    law->hardening = 0.01;
    law->strength = 1e8;
    law->tension = ft;
    law->fracture_energy = 0.5 * ft * wide;
    test_run_solve (&row);
    g_autoptr (QnScene) scene = build (&row, QN_VIEW_DEFORMED, QN_FIELD_CRACK);
    g_assert_cmpfloat_with_epsilon (scene->bar.max, widths[i], 1e-9);
    const bool opens = widths[i] > 0;
    g_assert_true (has_legend (scene, "crack, up to") == opens);
    g_assert_true ((find_line (scene, qn_ink (QN_INK_OPEN, false), 1) != NULL) == opens);
    g_autoptr (GArray) cracks = qn_result_cracks (&row.model, &row.contacts, &row.result,
                                                  row.result.step_count - 1);
    g_assert_cmpuint (cracks->len, ==, opens ? 2 : 0);
    for (guint c = 0; c < cracks->len; c++) {
      const QnCrack *crack = &g_array_index (cracks, QnCrack, c);
      g_assert_cmpfloat_with_epsilon (crack->width, widths[i], 1e-9);
      g_assert_cmpfloat_with_epsilon (crack->mean, widths[i], 1e-9);
    }
  }
}

/* A cross for each free block: the pull is along the row, 1e6 N on 1 m2, nothing across it. */
static void
test_principal (void)
{
  g_auto (TestRun) row = { 0 };
  row_init (&row);
  g_autoptr (QnScene) scene = build (&row, QN_VIEW_MODEL, QN_FIELD_PRINCIPAL);
  const QnCommand *arm = find_line (scene, qn_ink (QN_INK_OPEN, false), 0);
  g_assert_nonnull (arm);
  g_assert_null (find_line (scene, qn_ink (QN_INK_OPEN, false), 2));
  const QnVec2 *p = qn_scene_points (scene, arm);
  g_assert_cmpfloat (fabs (p[1].x - p[0].x), >, 0.5);
  g_assert_cmpfloat_with_epsilon (p[0].y, p[1].y, 1e-12);
  g_assert_true (has_legend (scene, "principal tension, up to"));
  g_assert_false (has_legend (scene, "principal compression"));
}

/* Pictures without contacts have bars from end to end by their corners, each picked as itself. */
static void
test_without_contacts (void)
{
  g_auto (TestRun) row = { 0 };
  row_init (&row);
  QnViewOptions options;
  qn_view_options_init (&options, QN_VIEW_MODEL);
  g_autoptr (QnScene) scene = qn_scene_build (&row.model, NULL, NULL, &options, NULL);
  const QnCommand *line = find_line (scene, qn_ink (QN_INK_BAR, false), 0);
  g_assert_nonnull (line);
  g_assert_null (find_line (scene, qn_ink (QN_INK_BAR, false), 1));
  g_assert_cmpint (line->pick, ==, QN_PICK_BAR);
  g_assert_cmpint (line->id, ==, 0);
  g_assert_cmpuint (line->count, ==, 2);
  const QnVec2 *p = qn_scene_points (scene, line);
  g_assert_cmpfloat (p[0].x, ==, 2.9);
  g_assert_cmpfloat (p[1].x, ==, 0.1);
  g_assert_cmpfloat (p[0].y, ==, 0.5);
  g_assert_cmpfloat (p[1].y, ==, 0.5);
}

QN_TESTS
{
  g_test_add_func ("/render/scene-bars/cracks", test_cracks);
  g_test_add_func ("/render/scene-bars/principal", test_principal);
  g_test_add_func ("/render/scene-bars/follows", test_follows);
  g_test_add_func ("/render/scene-bars/diameters", test_diameters);
  g_test_add_func ("/render/scene-bars/between-columns", test_between_columns);
  g_test_add_func ("/render/scene-bars/stress", test_stress);
  g_test_add_func ("/render/scene-bars/without-contacts", test_without_contacts);
}
