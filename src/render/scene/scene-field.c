/* Fields by colour: displacements and mean stresses of blocks, opening, sliding and cracks of joints; and
 * crosses of principal stresses. */
#include "core/result/mechanism.h"
#include "render/drawing/text.h"
#include "render/scene/reading.h"
#include "render/scene/scene-builder.h"

#include <glib/gi18n-lib.h>

/* Lines of joints, pt; that of the widest crack. */
#define WIDTH_LEAST 1.2F
#define WIDTH_CRACK 4.5F

/* Part of the widest crack from which on one is drawn. */
#define LEAST_CRACK 0.01

/* Length of the arms of the cross of the largest principal stress, in blocks, and widths, pt. */
#define ARM_LENGTH    0.45
#define WIDTH_TENSION 2.0F
#define WIDTH_PRESSED 0.9F

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
  [QN_FIELD_STRESS_X] = { N_ ("Stress σxx (MPa)"), NULL, 1e-6, true, false },
  [QN_FIELD_STRESS_Y] = { N_ ("Stress σyy (MPa)"), NULL, 1e-6, true, false },
  [QN_FIELD_STRESS_XY] = { N_ ("Shear stress σxy (MPa)"), NULL, 1e-6, true, false },
  [QN_FIELD_OPENING] = { N_ ("Joint opening (mm)"), N_ ("Joint opening (relative)"), 1e3,
                         false, true },
  [QN_FIELD_SLIDING] = { N_ ("Joint sliding (mm)"), N_ ("Joint sliding (relative)"), 1e3,
                         false, true },
  [QN_FIELD_CRACK] = { "", NULL, 1e3, false, true },
};

/* The displacements a field is read from: those drawn, else those of the step. */
static const double *
field_displacements (const QnSceneBuilder *b)
{
  if (b->motion.displacements != NULL)
    return b->motion.displacements;
  return qn_result_step_displacements (b->result, b->step);
}

/* The mean stress of every block. Free with g_free(). */
static QnBlockReading *
read_stresses (const QnSceneBuilder *b)
{
  double factors[QN_MAX_LOAD_SETS];
  qn_result_load_factors (b->model, b->result, b->step, factors);
  return qn_block_readings (b->model, b->contacts, b->pairs, b->touches, b->touch_count,
                            factors);
}

/* Whether a block has a mean stress: what a support takes acts at no known place. */
static bool
has_stress (const QnBlock *block)
{
  return !qn_support_is_full (block->support);
}

/* Values that are not known are NAN. */
static void
block_stresses (const QnSceneBuilder *b, double *values)
{
  const QnField field = b->options->field;
  g_autofree QnBlockReading *readings = read_stresses (b);
  for (size_t i = 0; i < b->model->block_count; i++) {
    if (!has_stress (&b->model->blocks[i]))
      values[i] = NAN;
    else if (field == QN_FIELD_STRESS)
      values[i] = readings[i].principal[0];
    else
      values[i] = readings[i].stress[field - QN_FIELD_STRESS_X];
  }
}

static void
block_values (const QnSceneBuilder *b, double *values)
{
  if (qn_field_is_stress (b->options->field)) {
    block_stresses (b, values);
    return;
  }
  const double *u = field_displacements (b);
  const QnField field = b->options->field;
  for (size_t i = 0; i < b->model->block_count; i++, u += QN_DOF_COUNT)
    values[i] = field == QN_FIELD_DISPLACEMENT_X   ? u[QN_DOF_UX]
                : field == QN_FIELD_DISPLACEMENT_Y ? u[QN_DOF_UY]
                : field == QN_FIELD_ROTATION       ? u[QN_DOF_RZ]
                                                   : hypot (u[QN_DOF_UX], u[QN_DOF_UY]);
}

/* The range of the values, with zero in it. */
static void
set_bar (QnSceneBuilder *b, const FieldSpec *spec, const double *values, size_t count)
{
  QnColorBar *bar = &b->scene->bar;
  bool relative = b->options->view == QN_VIEW_MECHANISM && spec->relative_title != NULL;
  bar->shown = b->options->field != QN_FIELD_CRACK;
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
  const bool cracks = b->options->field == QN_FIELD_CRACK;
  const QnColorBar *bar = &b->scene->bar;
  const QnColor ink = qn_builder_ink (b, QN_INK_OPEN);
  for (size_t f = 0; f < b->contacts->face_count; f++) {
    const QnContactFace *face = &b->contacts->faces[f];
    if ((b->left != NULL && b->left[f])
        || (cracks && !(values[f] > LEAST_CRACK * bar->max)))
      continue;
    QnVec2 line[2] = { qn_builder_place_joint (b, face, face->start),
                       qn_builder_place_joint (b, face, face->end) };
    double share = bar->max > 0 ? values[f] / bar->max : 0;
    QnCommand *command = qn_scene_stroke (
      b->scene, QN_LAYER_JOINTS, line, 2, false,
      WIDTH_LEAST + (cracks ? WIDTH_CRACK - WIDTH_LEAST : 2.4) * share,
      cracks ? ink : qn_color_bar_color (bar, values[f], b->options->monochrome));
    qn_command_set_pick (command, QN_PICK_FACE, (QnId) f);
  }
  if (!cracks || !(bar->max > 0))
    return;
  g_autofree char *most = qn_label_number ("%.3g", bar->max * bar->factor);
  qn_scene_legend (b->scene, QN_COMMAND_STROKE, WIDTH_CRACK, ink,
                   _ ("crack, up to %s mm wide"), most);
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
      qn_scene_legend (b->scene, QN_COMMAND_FILL, 0,
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
    qn_scene_legend (b->scene, QN_COMMAND_MARKER, 4.2f, mark, "%s",
                     _ ("centre of rotation"))
      ->marker = QN_MARKER_CROSS;
  qn_mechanism_clear (&mechanism);
  return colors;
}

/* One arm of the cross of a block: a principal stress along its direction. */
static void
add_arm (QnSceneBuilder *b, QnId block, double stress, double per_stress, QnVec2 along)
{
  const QnVec2 middle = qn_builder_place (b, block, b->model->blocks[block].centroid);
  const QnVec2 arm = qn_vec2_scale (fabs (stress) * per_stress, along);
  const QnVec2 line[2] = { qn_vec2_sub (middle, arm), qn_vec2_add (middle, arm) };
  const bool pulled = stress > 0;
  qn_scene_stroke (b->scene, QN_LAYER_FORCES, line, 2, false,
                   pulled ? WIDTH_TENSION : WIDTH_PRESSED,
                   qn_builder_ink (b, pulled ? QN_INK_OPEN : QN_INK_SLIDE));
}

static void
add_stress_legend (QnSceneBuilder *b, double stress)
{
  const bool pulled = stress > 0;
  g_autofree char *number = qn_label_number ("%.3g", 1e-6 * fabs (stress));
  qn_scene_legend (b->scene, QN_COMMAND_STROKE, pulled ? WIDTH_TENSION : WIDTH_PRESSED,
                   qn_builder_ink (b, pulled ? QN_INK_OPEN : QN_INK_SLIDE),
                   pulled ? _ ("principal tension, up to %s MPa")
                          : _ ("principal compression, up to %s MPa"),
                   number);
}

/* Crosses of the principal stresses; the longest arm is that of the largest of all. */
static void
build_principal (QnSceneBuilder *b)
{
  g_autofree QnBlockReading *readings = read_stresses (b);
  double least = 0, most = 0;
  for (size_t i = 0; i < b->model->block_count; i++) {
    if (!has_stress (&b->model->blocks[i]))
      continue;
    least = fmin (least, readings[i].principal[0]);
    most = fmax (most, readings[i].principal[1]);
  }
  const double per_stress = ARM_LENGTH * b->block_size / fmax (most, -least);
  if (!isfinite (per_stress))
    return;
  for (size_t i = 0; i < b->model->block_count; i++) {
    const QnBlockReading *r = &readings[i];
    if (!has_stress (&b->model->blocks[i]))
      continue;
    const double angle = 0.5 * atan2 (2 * r->stress[2], r->stress[0] - r->stress[1]);
    const QnVec2 along = { cos (angle), sin (angle) }; /* of the greatest */
    add_arm (b, (QnId) i, r->principal[1], per_stress, along);
    add_arm (b, (QnId) i, r->principal[0], per_stress, qn_vec2_perp (along));
  }
  if (most > 0)
    add_stress_legend (b, most);
  if (least < 0)
    add_stress_legend (b, least);
}

QnColor *
qn_build_field (QnSceneBuilder *b)
{
  QnField field = b->options->field;
  if (field == QN_FIELD_NONE)
    return NULL;
  if (field == QN_FIELD_BODIES)
    return build_bodies (b);
  if (qn_field_is_stress (field) && b->model->bar_count > 0)
    qn_scene_legend (b->scene, QN_COMMAND_TEXT, 0, qn_builder_ink (b, QN_INK_LINE), "%s",
                     _ ("stresses of blocks with the forces of bars"));
  if (field == QN_FIELD_PRINCIPAL) {
    build_principal (b);
    return NULL;
  }
  const FieldSpec *spec = &specs[field];
  size_t count = spec->joints ? b->contacts->face_count : b->model->block_count;
  g_autofree double *values = g_new0 (double, MAX (count, 1));
  if (spec->joints) {
    const QnMotion step = qn_step_motion (b->model, b->result, b->step);
    QnMotion motion = b->motion;
    motion.displacements = field_displacements (b);
    for (size_t f = 0; f < b->contacts->face_count; f++) {
      QnJointMotion joint = qn_motion_joint (&motion, &b->contacts->faces[f]);
      values[f] = b->options->field == QN_FIELD_CRACK
                    ? qn_joint_crack (b->contacts, (QnId) f, b->pairs, &step).width
                  : b->options->field == QN_FIELD_OPENING
                    ? fmax (fmax (joint.opening_start, joint.opening_end), 0)
                    : fabs (joint.slip);
      if (b->left != NULL && b->left[f])
        values[f] = 0;
    }
    set_bar (b, spec, values, count);
    add_joint_lines (b, values);
    return NULL;
  }
  block_values (b, values);
  set_bar (b, spec, values, count);
  QnColor *colors = g_new (QnColor, MAX (count, 1));
  for (size_t i = 0; i < count; i++)
    colors[i] = isnan (values[i]) ? qn_builder_ink (b, QN_INK_SUPPORT)
                                  : qn_color_bar_color (&b->scene->bar, values[i],
                                                        b->options->monochrome);
  return colors;
}
