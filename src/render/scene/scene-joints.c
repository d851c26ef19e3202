/* What the joints do: open ones as filled gaps, hinges as rings, sliding ones as lines with
 * opposed half arrows, broken bonds as crosses. All differ in shape, not in colour alone. */
#include "render/scene/scene-builder.h"

#include <glib/gi18n-lib.h>

/* Joints shorter than this on paper get no symbol, pt. */
#define SYMBOL_LEAST 7

/* The gap between the two sides of an open joint as drawn. */
static void
add_gap (QnSceneBuilder *b, QnId index, const QnContactFace *face, QnColor color)
{
  QnVec2 a0 = qn_builder_place (b, face->a, face->start);
  QnVec2 a1 = qn_builder_place (b, face->a, face->end);
  QnVec2 b0 = qn_builder_place (b, face->b, face->start);
  QnVec2 b1 = qn_builder_place (b, face->b, face->end);
  /* Where a joint opens at one end and closes at the other, the sides may cross by the
   * elastic closing: the gap ends at the crossing. */
  double open0 = qn_vec2_dot (qn_vec2_sub (b0, a0), face->normal);
  double open1 = qn_vec2_dot (qn_vec2_sub (b1, a1), face->normal);
  if (open0 < 0 && open1 > 0) {
    double s = open0 / (open0 - open1);
    a0 = b0 = qn_vec2_lerp (a0, a1, s);
  } else if (open1 < 0 && open0 > 0) {
    double s = open0 / (open0 - open1);
    a1 = b1 = qn_vec2_lerp (a0, a1, s);
  }
  QnVec2 gap[4] = { a0, a1, b1, b0 };
  /* The hairline closes the seam that antialiasing leaves between neighbouring gaps. */
  qn_scene_stroke (b->scene, QN_LAYER_GAPS, gap, 4, true, 0.3, color);
  QnCommand *command = qn_scene_fill (b->scene, QN_LAYER_GAPS, gap, 4, color);
  qn_command_set_pick (command, QN_PICK_FACE, index);
}

static void
add_hinge (QnSceneBuilder *b, QnId index, const QnContactFace *face, bool at_start,
           QnColor color)
{
  QnVec2 at = qn_builder_place_joint (b, face, at_start ? face->start : face->end);
  QnCommand *command =
    qn_scene_marker (b->scene, QN_LAYER_SYMBOLS, QN_MARKER_RING, at, 4.2, 0, color);
  qn_command_set_pick (command, QN_PICK_FACE, index);
  qn_command_set_extent (command, face->length, SYMBOL_LEAST);
}

static void
add_sliding (QnSceneBuilder *b, QnId index, const QnContactFace *face,
             const QnJointMotion *joint, QnColor color)
{
  QnVec2 line[2] = { qn_builder_place_joint (b, face, face->start),
                     qn_builder_place_joint (b, face, face->end) };
  QnCommand *command =
    qn_scene_stroke (b->scene, QN_LAYER_JOINTS, line, 2, false, 1.5, color);
  qn_command_set_pick (command, QN_PICK_FACE, index);

  /* Seen along the tangent, block a is on the left and block b on the right. The left half
   * arrow of the symbol points forwards, which is right where b slips backwards. */
  QnVec2 d = qn_vec2_sub (line[1], line[0]);
  double angle = atan2 (d.y, d.x);
  command = qn_scene_marker (b->scene, QN_LAYER_SYMBOLS, QN_MARKER_SLIDE,
                             qn_vec2_lerp (line[0], line[1], 0.5), 11, angle, color);
  command->mirrored = joint->slip > 0;
  qn_command_set_pick (command, QN_PICK_FACE, index);
  qn_command_set_extent (command, face->length, 1.6f * SYMBOL_LEAST);
}

/* A cross at every pair whose bond is broken; returns how many. */
static int
add_broken (QnSceneBuilder *b, QnId index, const QnContactFace *face, QnColor color)
{
  int broken = 0;
  for (int32_t k = 0; k < face->pair_count && b->pairs != NULL; k++) {
    QnId pair = face->first_pair + k;
    if (b->pairs[pair].damage < 1)
      continue;
    QnVec2 at = qn_builder_place_joint (b, face, b->contacts->pairs[pair].point);
    QnCommand *command =
      qn_scene_marker (b->scene, QN_LAYER_SYMBOLS, QN_MARKER_CROSS, at, 5, 0, color);
    qn_command_set_pick (command, QN_PICK_FACE, index);
    qn_command_set_extent (command, face->length / face->pair_count, SYMBOL_LEAST);
    broken++;
  }
  return broken;
}

void
qn_build_joints (QnSceneBuilder *b)
{
  QnColor open = qn_builder_ink (b, QN_INK_OPEN);
  QnColor slide = qn_builder_ink (b, QN_INK_SLIDE);
  QnColor hinge = qn_builder_ink (b, QN_INK_HINGE);
  int gaps = 0, rings = 0, slips = 0, broken = 0; /* of each kind */
  for (size_t f = 0; f < b->contacts->face_count; f++) {
    const QnContactFace *face = &b->contacts->faces[f];
    const QnJointMotion *joint = &b->joints[f];
    if (b->left != NULL && b->left[f])
      continue;
    broken += add_broken (b, (QnId) f, face, qn_builder_ink (b, QN_INK_LINE));
    bool hinges =
      joint->kind == QN_JOINT_HINGE_START || joint->kind == QN_JOINT_HINGE_END;
    if (hinges || joint->kind == QN_JOINT_OPENING) {
      add_gap (b, (QnId) f, face, open);
      gaps++;
    }
    if (hinges) {
      add_hinge (b, (QnId) f, face, joint->kind == QN_JOINT_HINGE_START, hinge);
      rings++;
    }
    if (joint->slides && joint->kind != QN_JOINT_OPENING) {
      add_sliding (b, (QnId) f, face, joint, slide);
      slips++;
    }
  }
  /* Of a mechanism as many as its text counts, also where symbols are left out since joints are too short. */
  bool counts = b->options->view == QN_VIEW_MECHANISM && b->options->counts;
  g_autofree char *hinges =
    counts ? g_strdup_printf (_ ("hinge (%d)"), rings) : g_strdup (_ ("hinge"));
  g_autofree char *slides = counts ? g_strdup_printf (_ ("sliding joint (%d)"), slips)
                                   : g_strdup (_ ("sliding joint"));
  if (gaps > 0)
    qn_scene_legend (b->scene, QN_COMMAND_FILL, 0, open, "%s", _ ("open joint"));
  if (rings > 0)
    qn_scene_legend (b->scene, QN_COMMAND_MARKER, 4.2f, hinge, "%s", hinges)->marker =
      QN_MARKER_RING;
  if (slips > 0)
    qn_scene_legend (b->scene, QN_COMMAND_MARKER, 11, slide, "%s", slides)->marker =
      QN_MARKER_SLIDE;
  if (broken > 0)
    qn_scene_legend (b->scene, QN_COMMAND_MARKER, 5, qn_builder_ink (b, QN_INK_LINE),
                     "%s", _ ("broken bond"))
      ->marker = QN_MARKER_CROSS;
}
