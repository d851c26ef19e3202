/* Pictures of beams: what is drawn, picked and written, and two references pixel by pixel. */
#include "render/backend/draw-cairo.h"
#include "render/image-compare.h"
#include "render/scene/scene-build.h"
#include "support/room.h"
#include "support/run.h"

#include <glib.h>
#include <math.h>
#include <string.h>

static QnId
add_node (QnModel *model, const char *name, double x, double y)
{
  qn_model_add_node (model, name)->at = qn_vec2 (x, y);
  return (QnId) model->node_count - 1;
}

static void
add_beam (QnModel *model, const char *name, QnId first, QnId second, int32_t elements)
{
  QnBeam *beam = qn_model_add_beam (model, name);
  beam->nodes[0] = first;
  beam->nodes[1] = second;
  beam->section = 0;
  beam->element_count = elements;
}

/* A portal 4 x 3 m: clamped, pinned, hinged at its right corner; 12 kN/m on the beam, 9 kN at
 * the left corner. */
static void
portal_init (TestRun *p)
{
  QnModel *model = &p->model;
  qn_model_init (model);
  QnSection *section = qn_model_add_section (model, "s");
  section->young = 10e9;
  section->width = 0.2;
  section->height = 0.3;
  QnId a = add_node (model, "a", 0, 0), b = add_node (model, "b", 0, 3);
  QnId c = add_node (model, "c", 4, 3), d = add_node (model, "d", 4, 0);
  for (int i = 0; i < 3; i++)
    model->nodes[a].support[i] = true;
  model->nodes[d].support[0] = model->nodes[d].support[1] = true;
  add_beam (model, "left", a, b, 1);
  add_beam (model, "top", b, c, 2);
  add_beam (model, "right", d, c, 1);
  model->beams[1].hinge[1] = true;
  QnLoad *load = qn_model_add_live_load (model);
  load->kind = QN_LOAD_LINE;
  load->beam = 1;
  load->vector = qn_vec2 (0, -12e3);
  load = qn_model_add_live_load (model);
  load->kind = QN_LOAD_NODE;
  load->node = b;
  load->vector = qn_vec2 (9e3, 0);
  model->analysis.max_multiplier = 1;
  model->analysis.increments = 1;
  test_run_solve (p);
}

static QnScene *
build (const TestRun *p, QnView view, QnDiagram diagram)
{
  QnViewOptions options;
  GError *error = NULL;
  qn_view_options_init (&options, view);
  options.diagram = diagram;
  options.dimensions = false;
  QnScene *scene = qn_scene_build (&p->model, &p->contacts, &p->result, &options, &error);
  g_assert_no_error (error);
  return scene;
}

static void
test_picking (void)
{
  g_auto (TestRun) p;
  portal_init (&p);
  g_autoptr (QnScene) scene = build (&p, QN_VIEW_MODEL, QN_DIAGRAM_MOMENT);
  bool seen[3] = { false };
  for (size_t i = 0; i < scene->commands->len; i++)
    if (qn_scene_command (scene, i)->pick == QN_PICK_BEAM)
      seen[qn_scene_command (scene, i)->id] = true;
  g_assert_true (seen[0] && seen[1] && seen[2]);
}

/* Whether some text of the scene is a number near to this. */
static bool
says (const QnScene *scene, double number)
{
  for (size_t i = 0; i < scene->commands->len; i++) {
    const QnCommand *command = qn_scene_command (scene, i);
    if (command->kind == QN_COMMAND_TEXT
        && fabs (g_ascii_strtod (command->text, NULL) - number) < 2e-3 * fabs (number))
      return true;
  }
  return false;
}

/* Largest and end values stand at the diagrams, that between the ends of the beam as well. */
static void
test_labels (void)
{
  g_auto (TestRun) p;
  portal_init (&p);
  const QnBeamForces *f = qn_result_step_beam_forces (&p.result, p.result.step_count - 1);
  g_autoptr (QnScene) moments = build (&p, QN_VIEW_DIAGRAMS, QN_DIAGRAM_MOMENT);
  g_assert_true (says (moments, f[0].moment[0] / 1000));
  g_assert_true (says (moments, f[0].moment[1] / 1000));
  /* In the span: V = 0 at x = V1 / q from the left corner, M1 + V1^2 / 2q there. */
  double most = f[1].moment[0] + f[1].shear[0] * f[1].shear[0] / 24e3;
  g_test_message ("moment in the span %.4f", most / 1000);
  g_assert_true (says (moments, most / 1000));
  g_autoptr (QnScene) shears = build (&p, QN_VIEW_DIAGRAMS, QN_DIAGRAM_SHEAR);
  g_assert_true (says (shears, f[1].shear[0] / 1000));
  g_assert_true (says (shears, f[2].shear[1] / 1000));
  g_autoptr (QnScene) normals = build (&p, QN_VIEW_DIAGRAMS, QN_DIAGRAM_NORMAL);
  g_assert_true (says (normals, f[0].normal[0] / 1000));
}

/* Diagrams of a result without beams are refused with one sentence. */
static bool
has_text (const QnScene *scene, const char *text)
{
  for (size_t i = 0; i < scene->commands->len; i++) {
    const QnCommand *command = qn_scene_command (scene, i);
    if (command->kind == QN_COMMAND_TEXT && strcmp (command->text, text) == 0)
      return true;
  }
  return false;
}

/* A load of a case is written with the factor that it is multiplied by. */
static void
test_load_case (void)
{
  g_auto (TestRun) p;
  portal_init (&p);
  int32_t wind = qn_model_add_load_case (&p.model, "wind");
  p.model.load_cases[wind - 1].factor = 1.5;
  p.model.live_loads[0].load_case = wind;
  g_autoptr (QnScene) scene = build (&p, QN_VIEW_MODEL, QN_DIAGRAM_MOMENT);
  g_assert_true (has_text (scene, "12 kN/m × 1.5"));
  g_assert_true (has_text (scene, "9 kN"));
}

static void
test_refused (void)
{
  g_auto (TestRun) p;
  QnViewOptions options;
  GError *error = NULL;
  portal_init (&p);
  g_clear_pointer (&p.result.beam_forces, free);
  qn_view_options_init (&options, QN_VIEW_DIAGRAMS);
  g_assert_null (qn_scene_build (&p.model, &p.contacts, &p.result, &options, &error));
  g_assert_nonnull (strstr (error->message, "beams"));
  g_clear_error (&error);
}

/* A mechanism shows where beams yield and where they were, and its legend says so. */
static void
test_mechanism (void)
{
  g_auto (TestRun) p;
  GError *error = NULL;
  QnViewOptions options;
  portal_init (&p);
  size_t step = p.result.step_count - 1, bodies = qn_result_body_count (&p.result);
  double moment = fabs (qn_result_step_beam_forces (&p.result, step)[0].moment[1]);
  p.model.sections[0].plastic_moment = moment;
  for (size_t e = 0; e < p.model.element_count; e++)
    p.model.elements[e].yields[1] = e == 0;
  g_autofree double *mechanism =
    g_memdup2 (qn_result_step_displacements (&p.result, step),
               QN_DOF_COUNT * bodies * sizeof (double));
  p.result.mechanism = mechanism;
  qn_view_options_init (&options, QN_VIEW_MECHANISM);
  g_autoptr (QnScene) scene =
    qn_scene_build (&p.model, &p.contacts, &p.result, &options, &error);
  g_assert_no_error (error);
  p.result.mechanism = NULL;
  bool hinge = false, undeformed = false;
  for (guint i = 0; i < scene->legend->len; i++) {
    const char *text = g_array_index (scene->legend, QnLegendEntry, i).text;
    hinge |= strcmp (text, "plastic hinge") == 0;
    undeformed |= strcmp (text, "undeformed") == 0;
  }
  g_assert_true (hinge);
  g_assert_true (undeformed);
}

/* Dimensions stand where no load is in the way: of a load from the left on the right. */
static void
test_dimensions (void)
{
  g_auto (TestRun) p;
  QnViewOptions options;
  portal_init (&p);
  qn_view_options_init (&options, QN_VIEW_MODEL);
  options.loads = options.dimensions = true;
  for (int sign = -1; sign <= 1; sign += 2) {
    p.model.live_loads[1].vector.x = sign * 9e3;
    p.model.live_loads[1].node = sign > 0 ? 1 : 2;
    g_autoptr (QnScene) scene =
      qn_scene_build (&p.model, &p.contacts, &p.result, &options, NULL);
    int upright = 0;
    for (guint i = 0; i < scene->commands->len; i++) {
      const QnCommand *command = qn_scene_command (scene, i);
      if (command->layer != QN_LAYER_LABELS || command->angle == 0)
        continue;
      double x = qn_scene_points (scene, command)[0].x;
      g_assert_true (sign > 0 ? x > 4 : x < 0);
      upright++;
    }
    g_assert_cmpint (upright, ==, 1);
  }
}

static void
test_golden (void)
{
  static const struct {
    const char *name;
    QnView view;
    QnDiagram diagram;
  } pictures[] = { { "cairo-beams-model", QN_VIEW_MODEL, QN_DIAGRAM_MOMENT },
                   { "cairo-beams-deformed", QN_VIEW_DEFORMED, QN_DIAGRAM_MOMENT },
                   { "cairo-beams-moments", QN_VIEW_DIAGRAMS, QN_DIAGRAM_MOMENT } };
  g_auto (TestRun) p;
  portal_init (&p);
  for (gsize i = 0; i < G_N_ELEMENTS (pictures); i++) {
    g_autoptr (QnScene) scene = build (&p, pictures[i].view, pictures[i].diagram);
    QnCamera camera = { .width = 480, .height = 360, .unit = 2, .scale = 1 };
    qn_camera_fit (&camera, scene->box, 16);
    qn_camera_pan (&camera, qn_vec2 (0.1, 0.1)); /* off the pixel grid */
    cairo_surface_t *image = cairo_image_surface_create (CAIRO_FORMAT_ARGB32, 480, 360);
    cairo_t *cr = cairo_create (image);
    cairo_set_source_rgb (cr, 1, 1, 1);
    cairo_paint (cr);
    cairo_set_antialias (cr, CAIRO_ANTIALIAS_NONE);
    qn_draw_cairo (scene, &camera, QN_LAYERS_ALL & ~QN_LAYERS_CAIRO_ABOVE, cr);
    cairo_destroy (cr);
    image_assert_golden (pictures[i].name, image, IMAGE_EXACT);
    cairo_surface_destroy (image);
  }
}

QN_TESTS
{
  g_test_add_func ("/scene-beams/picking", test_picking);
  g_test_add_func ("/scene-beams/labels", test_labels);
  g_test_add_func ("/scene-beams/load-case", test_load_case);
  g_test_add_func ("/scene-beams/refused", test_refused);
  g_test_add_func ("/scene-beams/mechanism", test_mechanism);
  g_test_add_func ("/scene-beams/dimensions", test_dimensions);
  g_test_add_func ("/scene-beams/golden", test_golden);
}
