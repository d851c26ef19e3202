/* Blocks: fills, outlines, ghost, onion skin, names, and the photo behind them. */
#include "render/drawing/text.h"
#include "render/scene/scene-builder.h"

#include <glib/gi18n-lib.h>

const QnVec2 *
qn_builder_place_vertices (const QnSceneBuilder *b, const QnMotion *motion, QnId block,
                           GArray *out)
{
  const QnVec2 *vertices = qn_model_block_vertices (b->model, block);
  QnId count = b->model->blocks[block].vertex_count;
  g_array_set_size (out, (guint) count);
  for (QnId i = 0; i < count; i++)
    g_array_index (out, QnVec2, i) =
      qn_motion_place (motion, block, vertices[i], motion->scale);
  return (const QnVec2 *) (void *) out->data;
}

static double
smaller_side (const QnVec2 *points, QnId count)
{
  return qn_box_smaller_side (qn_box_of_points (points, (size_t) count));
}

/* Blocks that move less than this share of the fastest are left out of the onion skin, where
 * they would only double the outlines of the first result. */
#define LEAST_ONION 0.01

/* Share of a block's fill that covers a photo behind it. */
#define FILL_OVER_PHOTO 0.4

/* Blocks of one unit weight and law are of one material. */
static int
material_of (GArray *materials, const QnBlock *block)
{
  for (guint i = 0; i < materials->len; i++) {
    const QnBlock *known = g_array_index (materials, const QnBlock *, i);
    if (known->law == block->law
        && fabs (known->unit_weight - block->unit_weight) <= 1e-9 * known->unit_weight)
      return (int) i;
  }
  g_array_append_val (materials, block);
  return (int) materials->len - 1;
}

static void
add_material_legend (QnSceneBuilder *b, GArray *materials)
{
  if (b->options->view != QN_VIEW_MODEL)
    return;
  for (guint i = 0; i < materials->len; i++) {
    const QnBlock *block = g_array_index (materials, const QnBlock *, i);
    QnId law = block->law != QN_NONE ? block->law : b->model->contact.law;
    bool named = law != QN_NONE && (size_t) law < b->model->law_count
                 && b->model->laws[law].name != NULL;
    g_autofree char *number = qn_label_number ("%.4g", block->unit_weight / 1000);
    qn_scene_legend (b->scene, QN_COMMAND_FILL, 0,
                     qn_material_color ((int) i, b->options->monochrome), "%s kN/m³%s%s",
                     number, named ? ", " : "", named ? b->model->laws[law].name : "");
  }
}

void
qn_build_blocks (QnSceneBuilder *b, const QnColor *fills)
{
  const QnModel *model = b->model;
  QnColor line = qn_builder_ink (b, QN_INK_LINE);
  g_autoptr (GArray) points = g_array_new (FALSE, FALSE, sizeof (QnVec2));
  g_autoptr (GArray) materials = g_array_new (FALSE, FALSE, sizeof (QnBlock *));

  for (size_t i = 0; i < model->block_count; i++) {
    const QnBlock *block = &model->blocks[i];
    const QnVec2 *v = qn_builder_place_vertices (b, &b->motion, (QnId) i, points);
    size_t count = (size_t) block->vertex_count;
    QnColor fill = qn_builder_ink (b, QN_INK_SUPPORT);
    if (fills != NULL)
      fill = fills[i];
    else if (!qn_support_is_any (block->support))
      fill = qn_material_color (material_of (materials, block), b->options->monochrome);

    if (b->options->underlay.image != NULL)
      fill = qn_color_fade (fill, FILL_OVER_PHOTO);
    QnCommand *command = qn_scene_fill (b->scene, QN_LAYER_BLOCKS, v, count, fill);
    qn_command_set_pick (command, QN_PICK_BLOCK, (QnId) i);
    command = qn_scene_stroke (b->scene, QN_LAYER_OUTLINES, v, count, true,
                               QN_WIDTH_OUTLINE, line);
    qn_command_set_extent (command, smaller_side (v, block->vertex_count), 1.6f);
    qn_command_set_pick (command, QN_PICK_BLOCK, (QnId) i);
  }
  if (fills == NULL)
    add_material_legend (b, materials);
}

void
qn_build_ghost (QnSceneBuilder *b)
{
  const QnModel *model = b->model;
  QnColor line = qn_builder_ink (b, QN_INK_FAINT);
  bool any = false;
  for (size_t i = 0; i < model->block_count; i++) {
    const double *u = b->motion.displacements + i * QN_DOF_COUNT;
    if (u[0] == 0 && u[1] == 0 && u[2] == 0)
      continue;
    const QnVec2 *v = qn_model_block_vertices (model, (QnId) i);
    QnId count = model->blocks[i].vertex_count;
    QnCommand *command = qn_scene_stroke (b->scene, QN_LAYER_GHOST, v, (size_t) count,
                                          true, QN_WIDTH_GHOST, line);
    qn_command_set_extent (command, smaller_side (v, count), 2);
    any = true;
  }
  any |= qn_build_beam_ghosts (b);
  if (any)
    qn_scene_legend (b->scene, QN_COMMAND_STROKE, 0.7f, line, "%s", _ ("undeformed"));
}

void
qn_build_onion (QnSceneBuilder *b)
{
  const QnResult *onion = b->options->onion;
  QnMotion motion = b->motion;
  double multiplier = onion->collapse_multiplier;
  bool known = onion->has_collapse_multiplier;
  if (b->options->view == QN_VIEW_MECHANISM) {
    motion.displacements = onion->mechanism;
  } else {
    size_t step = b->options->step == QN_STEP_LAST ? onion->step_count - 1
                                                   : MIN (b->step, onion->step_count - 1);
    motion.displacements = qn_result_step_displacements (onion, step);
    multiplier = onion->steps[step].multiplier;
    known = true;
  }
  QnColor line = qn_series_color (3, b->options->monochrome);
  g_autoptr (GArray) points = g_array_new (FALSE, FALSE, sizeof (QnVec2));
  double least = LEAST_ONION * qn_motion_largest (&motion);
  for (size_t i = 0; i < b->model->block_count; i++) {
    if (qn_motion_of_block (&motion, (QnId) i) < least)
      continue;
    const QnVec2 *v = qn_builder_place_vertices (b, &motion, (QnId) i, points);
    QnCommand *command =
      qn_scene_stroke (b->scene, QN_LAYER_ONION, v, points->len, true, 0.9, line);
    command->dashed = true;
    qn_command_set_extent (command, smaller_side (v, (QnId) points->len), 3);
  }
  g_autofree char *number = qn_label_number ("%.4f", multiplier);
  g_autofree char *label = known ? g_strdup_printf (_ ("second result, λ = %s"), number)
                                 : g_strdup (_ ("second result"));
  qn_scene_legend (b->scene, QN_COMMAND_STROKE, 1.5, line, "%s", label)->dashed = true;
}

/* In the middle; above an arrow of a load there that lies, beside one that stands. Shown where the block
 * is wide and tall enough. */
void
qn_build_names (QnSceneBuilder *b)
{
  QnVec2 arrow = b->weight_arrow;
  for (size_t i = 0; i < b->model->block_count; i++) {
    const QnBlock *block = &b->model->blocks[i];
    if (block->name == NULL || *block->name == '\0')
      continue;
    QnVec2 at = qn_builder_place (b, (QnId) i, block->centroid);
    QnCommand *command = qn_scene_text (b->scene, QN_LAYER_LABELS, at, QN_SIZE_LABEL,
                                        block->name, qn_builder_ink (b, QN_INK_LINE));
    QnBox box = qn_model_block_box (b->model, (QnId) i);
    bool marked = !qn_support_is_full (block->support);
    bool beside = marked && fabs (arrow.y) > fabs (arrow.x);
    bool above = marked && !beside && arrow.x != 0;
    double letters = (double) g_utf8_strlen (block->name, -1);
    double width = (box.max.x - box.min.x) / ((beside ? 2 : 1) * (0.62 * letters + 1));
    double height = (box.max.y - box.min.y) / (above ? 3 : 1.3);
    command->align_x = beside ? -0.1f : 0.5f;
    command->align_y = above ? -0.2f : 0.5f;
    qn_command_set_extent (command, fmin (width, height), QN_SIZE_LABEL);
    qn_command_set_pick (command, QN_PICK_BLOCK, (QnId) i);
  }
}

/* Numbers of joints, as tables name them: small, since every joint of a wall may have one. */
void
qn_build_numbers (QnSceneBuilder *b)
{
  for (size_t f = 0; f < b->contacts->face_count; f++) {
    const QnContactFace *face = &b->contacts->faces[f];
    if (!b->options->numbered[f])
      continue;
    QnVec2 ends[2] = { qn_builder_place_joint (b, face, face->start),
                       qn_builder_place_joint (b, face, face->end) };
    char number[24];
    g_snprintf (number, sizeof number, "%zu", f);
    qn_scene_stroke (b->scene, QN_LAYER_SYMBOLS, ends, 2, false, 1.5,
                     qn_builder_ink (b, QN_INK_FACE));
    QnCommand *command =
      qn_scene_text (b->scene, QN_LAYER_LABELS, qn_vec2_lerp (ends[0], ends[1], 0.5),
                     0.7 * QN_SIZE_LABEL, number, qn_builder_ink (b, QN_INK_LINE));
    command->align_y = -0.1f;
    qn_command_set_pick (command, QN_PICK_FACE, (QnId) f);
  }
}

void
qn_build_underlay (QnSceneBuilder *b)
{
  const QnUnderlay *underlay = &b->options->underlay;
  QnVec2 corners[4];
  if (!qn_underlay_corners (underlay, corners))
    return;
  QnColor tint = qn_color_fade (qn_rgb (0xffffff), underlay->opacity);
  qn_scene_fill (b->scene, QN_LAYER_UNDERLAY, corners, 4, tint)->kind = QN_COMMAND_IMAGE;
  b->scene->image = cairo_surface_reference (underlay->image);
}
