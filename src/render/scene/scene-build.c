/* Chooses, checks and runs the builders of one view. */
#include "render/drawing/render-error.h"
#include "render/drawing/text.h"
#include "render/scene/reading.h"
#include "render/scene/scene-builder.h"

#include <glib/gi18n-lib.h>

static bool
result_fits (const QnSceneBuilder *b, const QnResult *result, GError **error)
{
  if (result->block_count != b->model->block_count)
    return qn_render_refuse (error, _ ("the result has %zu blocks, the model %zu"),
                             result->block_count, b->model->block_count);
  bool bodies = b->options->field == QN_FIELD_BODIES;
  if ((b->options->view == QN_VIEW_MECHANISM || bodies) && result->mechanism == NULL)
    return qn_render_refuse (error, _ ("the result has no mechanism"));
  if (b->options->view != QN_VIEW_MECHANISM && result->step_count == 0)
    return qn_render_refuse (error, _ ("the result has no steps"));
  return true;
}

/* A field is read off a result; stresses and forces off its contact forces as well. */
static bool
forces_fit (const QnSceneBuilder *b, GError **error)
{
  bool wanted =
    b->options->view == QN_VIEW_FORCES || qn_field_needs_forces (b->options->field);
  if (!wanted)
    return true;
  if (b->contacts == NULL || b->result->pair_count == 0
      || b->result->pair_count != b->contacts->pair_count)
    return qn_render_refuse (error, _ ("the result has no contact forces of this model"));
  if (!qn_result_has_forces (b->result, b->step))
    return qn_render_refuse (
      error, b->result->limit.given
               ? _ ("limit analysis has contact forces at its last step only")
               : _ ("the result has the contact forces of its last step alone; "
                    "solve --detail steps keeps all"));
  return true;
}

static bool
choose_step (QnSceneBuilder *b, GError **error)
{
  const QnViewOptions *options = b->options;
  if (b->result == NULL || b->result->step_count == 0)
    return true;
  if (options->step == QN_STEP_LAST) {
    b->step = b->result->step_count - 1;
    return true;
  }
  if (options->step < 0 || (size_t) options->step >= b->result->step_count)
    return qn_render_refuse (error, _ ("the result has no step %d (0 to %zu)"),
                             options->step, b->result->step_count - 1);
  b->step = (size_t) options->step;
  return true;
}

static bool
check (QnSceneBuilder *b, GError **error)
{
  const QnViewOptions *options = b->options;
  bool wants_result =
    qn_view_needs_result (options->view) || options->field != QN_FIELD_NONE;
  if (wants_result && b->result == NULL)
    return qn_render_refuse (error, _ ("the view \"%s\" needs a result"),
                             qn_view_names[options->view]);
  bool wants_contacts =
    options->view == QN_VIEW_CONTACTS || options->field == QN_FIELD_OPENING
    || options->field == QN_FIELD_SLIDING || options->field == QN_FIELD_BODIES;
  if (wants_contacts && b->contacts == NULL)
    return qn_render_refuse (error, _ ("the view \"%s\" needs contacts"),
                             qn_view_names[options->view]);
  if (!isfinite (options->scale) || options->scale < 0 || !isfinite (options->phase))
    return qn_render_refuse (error,
                             _ ("the scale of displacements must be a positive number"));
  if (wants_result && !result_fits (b, b->result, error))
    return false;
  if (options->onion != NULL && !result_fits (b, options->onion, error))
    return false;
  if (options->view == QN_VIEW_DIAGRAMS && b->result->beam_forces == NULL)
    return qn_render_refuse (
      error, _ ("diagrams need beams and a result that holds their forces"));
  return choose_step (b, error) && (!wants_result || forces_fit (b, error));
}

/* Whether forces balance where the blocks have moved to, and are drawn there. */
static bool
forces_act_displaced (const QnModel *model, const QnResult *result,
                      const QnViewOptions *options)
{
  return options->view == QN_VIEW_FORCES && result != NULL && result->step_count > 0
         && !result->limit.given && model->analysis.geometry != QN_GEOMETRY_LINEAR;
}

/* The displacements that a view shows, without their factor. */
static QnMotion
find_motion (const QnModel *model, const QnResult *result, const QnViewOptions *options,
             size_t step)
{
  QnMotion motion = { .model = model, .linear = true, .scale = 0 };
  if (options->view == QN_VIEW_MECHANISM) {
    motion.displacements = result->mechanism;
    motion.base = qn_mechanism_base (model, result);
  } else if (options->view == QN_VIEW_DEFORMED
             || forces_act_displaced (model, result, options)) {
    motion.displacements = qn_result_step_displacements (result, step);
    motion.linear = model->analysis.geometry == QN_GEOMETRY_LINEAR;
  }
  return motion;
}

static void
choose_motion (QnSceneBuilder *b)
{
  const QnViewOptions *options = b->options;
  b->motion = find_motion (b->model, b->result, options, b->step);
  if (options->view != QN_VIEW_MECHANISM && options->view != QN_VIEW_DEFORMED) {
    b->motion.scale = b->motion.displacements != NULL ? 1 : 0;
    return;
  }
  double scale = options->scale;
  if (!(scale > 0))
    scale = options->view == QN_VIEW_DEFORMED
              ? qn_motion_result_scale (b->model, b->result)
              : qn_motion_auto_scale (&b->motion);
  b->scene->scale = scale;
  b->motion.scale = scale * options->phase;
}

QnMotion
qn_scene_motion (const QnScene *scene, const QnModel *model, const QnResult *result,
                 const QnViewOptions *options)
{
  size_t last = result != NULL && result->step_count > 0 ? result->step_count - 1 : 0;
  size_t step = options->step == QN_STEP_LAST ? last : (size_t) options->step;
  QnMotion motion = find_motion (model, result, options, step);
  if (motion.displacements != NULL)
    motion.scale = scene->scale > 0 ? scene->scale * options->phase : 1;
  return motion;
}

/* Where the analysis does not state the states of joints, they follow from the motion. */
static bool
find_joints (QnSceneBuilder *b, GError **error)
{
  if (b->motion.displacements == NULL || b->contacts == NULL
      || b->options->view == QN_VIEW_FORCES)
    return true;
  if (b->options->view != QN_VIEW_MECHANISM) {
    b->joints = qn_motion_joints (&b->motion, b->contacts, b->pairs);
    return true;
  }
  QnMechanism mechanism;
  if (qn_mechanism_of_result (&mechanism, b->model, b->contacts, b->result, NULL)
      != QN_OK) {
    g_set_error_literal (error, QN_RENDER_ERROR, QN_RENDER_ERROR_FAILED,
                         _ ("not enough memory"));
    return false;
  }
  b->joints = g_steal_pointer (&mechanism.joints);
  b->scene->mechanism = mechanism.kind;
  qn_mechanism_clear (&mechanism);
  return true;
}

static void
build_view (QnSceneBuilder *b)
{
  const QnViewOptions *options = b->options;
  bool moving = b->motion.displacements != NULL && options->view != QN_VIEW_FORCES;

  qn_build_underlay (b);
  qn_build_soil (b);
  g_autofree char *scale = qn_motion_dup_scale (b->scene->scale);
  if (options->view == QN_VIEW_DEFORMED
      && !options->titles) /* what else the caption says */
    qn_scene_legend (b->scene, QN_COMMAND_TEXT, 0, qn_builder_ink (b, QN_INK_LINE), "%s",
                     scale);
  if (moving && options->ghost)
    qn_build_ghost (b);
  g_autofree QnColor *fills = qn_build_field (b);
  qn_build_blocks (b, fills);
  qn_build_supports (b);
  qn_build_beams (b);
  qn_build_bars (b);
  qn_build_ties (b);
  if (options->view == QN_VIEW_CONTACTS)
    qn_build_contacts (b);
  if (options->view == QN_VIEW_CONTACTS && options->symbols)
    qn_build_findings (b);
  if (b->joints != NULL && options->symbols)
    qn_build_joints (b);
  if ((options->view == QN_VIEW_DEFORMED || options->view == QN_VIEW_FORCES)
      && options->symbols)
    qn_build_found (b);
  if (options->view == QN_VIEW_FORCES && b->pairs != NULL)
    qn_build_forces (b);
  if (options->view == QN_VIEW_DIAGRAMS)
    qn_build_diagrams (b);
  if (moving && options->onion != NULL)
    qn_build_onion (b);
  if (options->loads)
    qn_build_loads (b);
  if (options->dimensions)
    qn_build_dimensions (b);
  if (options->names)
    qn_build_names (b);
  if (options->numbered != NULL && b->contacts != NULL)
    qn_build_numbers (b);
}

QnScene *
qn_scene_build (const QnModel *model, const QnContacts *contacts, const QnResult *result,
                const QnViewOptions *options, GError **error)
{
  QnSceneBuilder b = { .model = model,
                       .contacts = contacts,
                       .result = result,
                       .options = options,
                       .box = qn_box_of_points (model->vertices, model->vertex_count) };
  if (!check (&b, error))
    return NULL;

  b.scene = qn_scene_new ();
  b.scene->monochrome = options->monochrome;
  for (size_t i = 0; i < model->node_count; i++)
    qn_box_add_point (&b.box, model->nodes[i].at);
  for (size_t i = 0; i < 2 * model->tie_count; i++)
    qn_box_add_point (&b.box, model->ties[i / 2].ends[i % 2].at);
  for (size_t i = 0; i < model->dead_load_count; i++)
    for (int32_t k = 0; k < model->dead_loads[i].surface_count; k++)
      qn_box_add_point (&b.box, model->dead_loads[i].surface[k]);
  b.block_size = model->characteristic_length;
  if (model->block_count == 0) /* what follows beams' lengths is no size for symbols */
    b.block_size = 0.08 * qn_box_diagonal (b.box);
  if (!(b.block_size > 0))
    b.block_size = 0.1 * qn_box_diagonal (b.box);
  b.scene->fineness = 0.7 * b.block_size; /* of a block twice as long as tall */
  choose_motion (&b);
  /* Contact forces of the step shown. */
  bool steps = b.result != NULL && b.result->step_count > 0;
  if (b.result != NULL && b.contacts != NULL)
    b.pairs = qn_step_pairs (b.contacts, b.result, b.step);
  if (steps && b.contacts != NULL)
    b.left = qn_step_left (b.contacts, b.result, b.step);
  if (steps && (b.contacts != NULL || b.options->view == QN_VIEW_DEFORMED))
    b.touches = qn_step_touches (b.model, b.result, b.step, &b.touch_count);
  if (find_joints (&b, error)) {
    build_view (&b);
    qn_scene_finish (b.scene);
  } else {
    g_clear_pointer (&b.scene, qn_scene_free);
  }
  g_free (b.joints);
  g_free (b.left);
  g_free (b.touches);
  g_free (b.pairs);
  return b.scene;
}
