/* Fields by colour: displacements and mean stresses of blocks, opening and sliding of joints. */
#include "core/result/mechanism.h"
#include "render/scene/reading.h"
#include "render/scene/scene-builder.h"

#include <glib/gi18n-lib.h>

/* Strength of the fill of a body. */
#define BODY_FILL 0.45

typedef struct FieldSpec {
  const char *title; /* to be translated */
  const char
    *relative_title; /* of a mechanism's scaled velocities; NULL: not of velocities */
  double factor;     /* from SI to the unit of the title */
  bool diverging;
  bool joints;
} FieldSpec;

static const FieldSpec specs[QN_FIELD_COUNT] = {
  [QN_FIELD_NONE] = { "", "", 1, false, false },
  [QN_FIELD_DISPLACEMENT] = { N_ ("Displacement (mm)"), N_ ("Velocity (relative)"), 1e3,
                              false, false },
  [QN_FIELD_DISPLACEMENT_X] = { N_ ("Displacement ux (mm)"),
                                N_ ("Velocity ux (relative)"), 1e3, true, false },
  [QN_FIELD_DISPLACEMENT_Y] = { N_ ("Displacement uy (mm)"),
                                N_ ("Velocity uy (relative)"), 1e3, true, false },
  [QN_FIELD_ROTATION] = { N_ ("Rotation (mrad)"), N_ ("Rotation rate (relative)"), 1e3,
                          true, false },
  [QN_FIELD_STRESS] = { N_ ("Least principal stress (MPa)"), NULL, 1e-6, true, false },
  [QN_FIELD_OPENING] = { N_ ("Joint opening (mm)"), N_ ("Joint opening (relative)"), 1e3,
                         false, true },
  [QN_FIELD_SLIDING] = { N_ ("Joint sliding (mm)"), N_ ("Joint sliding (relative)"), 1e3,
                         false, true },
};

/* The displacements a field is read from: those drawn, else those of the step. */
static const double *
field_displacements (const QnSceneBuilder *b)
{
  if (b->motion.displacements != NULL)
    return b->motion.displacements;
  return qn_result_step_displacements (b->result, b->step);
}

/* Least principal value of the mean stress of every block. */
static void
block_stresses (const QnSceneBuilder *b, double *values)
{
  g_autofree QnBlockReading *readings =
    qn_block_readings (b->model, b->contacts, b->pairs, b->touches, b->touch_count, NULL);
  for (size_t i = 0; i < b->model->block_count; i++)
    values[i] = readings[i].principal[0];
}

static void
block_values (const QnSceneBuilder *b, double *values)
{
  if (b->options->field == QN_FIELD_STRESS) {
    block_stresses (b, values);
    return;
  }
  const double *u = field_displacements (b);
  for (size_t i = 0; i < b->model->block_count; i++, u += QN_DOF_COUNT) {
    switch (b->options->field) {
    case QN_FIELD_DISPLACEMENT_X:
      values[i] = u[QN_DOF_UX];
      break;
    case QN_FIELD_DISPLACEMENT_Y:
      values[i] = u[QN_DOF_UY];
      break;
    case QN_FIELD_ROTATION:
      values[i] = u[QN_DOF_RZ];
      break;
    case QN_FIELD_NONE:
    case QN_FIELD_DISPLACEMENT:
    case QN_FIELD_STRESS:
    case QN_FIELD_OPENING:
    case QN_FIELD_SLIDING:
    case QN_FIELD_BODIES:
    case QN_FIELD_COUNT:
      values[i] = hypot (u[QN_DOF_UX], u[QN_DOF_UY]);
    }
  }
}

static void
joint_values (const QnSceneBuilder *b, double *values)
{
  QnMotion motion = b->motion;
  motion.displacements = field_displacements (b);
  for (size_t f = 0; f < b->contacts->face_count; f++) {
    QnJoint joint = qn_motion_joint (&motion, &b->contacts->faces[f]);
    values[f] = b->options->field == QN_FIELD_OPENING
                  ? fmax (fmax (joint.opening_start, joint.opening_end), 0)
                  : fabs (joint.slip);
    if (b->left != NULL && b->left[f])
      values[f] = 0;
  }
}

/* The range of the values, with zero in it. */
static void
set_bar (QnSceneBuilder *b, const FieldSpec *spec, const double *values, size_t count)
{
  QnColorBar *bar = &b->scene->bar;
  bool relative = b->options->view == QN_VIEW_MECHANISM && spec->relative_title != NULL;
  bar->shown = true;
  bar->diverging = spec->diverging;
  bar->factor = relative ? 1 : spec->factor;
  bar->title = g_strdup (relative ? _ (spec->relative_title) : _ (spec->title));
  for (size_t i = 0; i < count; i++) {
    bar->min = fmin (bar->min, values[i]);
    bar->max = fmax (bar->max, values[i]);
  }
}

static void
add_joint_lines (QnSceneBuilder *b, const double *values)
{
  for (size_t f = 0; f < b->contacts->face_count; f++) {
    const QnContactFace *face = &b->contacts->faces[f];
    if (b->left != NULL && b->left[f])
      continue;
    QnVec2 line[2] = { qn_builder_place_joint (b, face, face->start),
                       qn_builder_place_joint (b, face, face->end) };
    double share = b->scene->bar.max > 0 ? values[f] / b->scene->bar.max : 0;
    QnCommand *command = qn_scene_stroke (
      b->scene, QN_LAYER_JOINTS, line, 2, false, 1.2 + 2.4 * share,
      qn_color_bar_color (&b->scene->bar, values[f], b->options->monochrome));
    qn_command_set_pick (command, QN_PICK_FACE, (QnId) f);
  }
}

/* Bodies of a mechanism that are named in the legend. */
#define NAMED_BODIES 6

/* The bodies of the mechanism, each in a colour, and those centres of rotation that are near. */
static QnColor *
build_bodies (QnSceneBuilder *b)
{
  QnMechanism mechanism;
  const int grey = b->options->monochrome;
  const QnColor mark = qn_builder_ink (b, QN_INK_HINGE);
  const QnBox near = qn_box_grow (b->box, 0.25 * qn_box_diagonal (b->box));
  bool turns = false;
  if (qn_mechanism_of_result (&mechanism, b->model, b->contacts, b->result, NULL)
      != QN_OK)
    return NULL;
  QnColor *colors = g_new (QnColor, MAX (b->model->block_count, 1));
  for (size_t i = 0; i < b->model->block_count; i++) {
    QnId body = mechanism.body_of_block[i];
    colors[i] = body == QN_NONE
                  ? qn_builder_ink (b, QN_INK_SUPPORT)
                  : qn_color_fade (qn_series_color ((int) body, grey), BODY_FILL);
  }
  for (size_t i = 0; i < mechanism.body_count; i++) {
    const QnMechanismBody *body = &mechanism.bodies[i];
    if (i < NAMED_BODIES)
      qn_scene_legend (b->scene, QN_COMMAND_FILL,
                       qn_color_fade (qn_series_color ((int) i, grey), BODY_FILL),
                       _ ("body %d"), (int) i + 1);
    if (!body->turns
        || !qn_box_meets (near, qn_box_of_segment (body->centre, body->centre)))
      continue;
    qn_scene_marker (b->scene, QN_LAYER_SYMBOLS, QN_MARKER_CROSS, body->centre, 5, 0,
                     mark);
    turns = true;
  }
  if (turns)
    qn_scene_legend_marker (b->scene, QN_MARKER_CROSS, 4.2f, mark, "%s",
                            _ ("centre of rotation"));
  qn_mechanism_clear (&mechanism);
  return colors;
}

QnColor *
qn_build_field (QnSceneBuilder *b)
{
  QnField field = b->options->field;
  if (field == QN_FIELD_NONE)
    return NULL;
  if (field == QN_FIELD_BODIES)
    return build_bodies (b);
  const FieldSpec *spec = &specs[field];
  size_t count = spec->joints ? b->contacts->face_count : b->model->block_count;
  g_autofree double *values = g_new0 (double, MAX (count, 1));
  if (spec->joints) {
    joint_values (b, values);
    set_bar (b, spec, values, count);
    add_joint_lines (b, values);
    return NULL;
  }
  block_values (b, values);
  set_bar (b, spec, values, count);
  QnColor *colors = g_new (QnColor, MAX (count, 1));
  for (size_t i = 0; i < count; i++)
    colors[i] = qn_color_bar_color (&b->scene->bar, values[i], b->options->monochrome);
  return colors;
}
