/* Contact faces and pairs, and what was found amiss between blocks. */
#include "render/scene/scene-builder.h"

#include <glib/gi18n-lib.h>

/* Most pairs that get points A, B, C and springs to be seen on zoom; far more than fit a
 * picture in which they could be read. */
#define MAX_DETAILED_PAIRS 20000

/* Half distance at which A and B are drawn from C, in block sizes, at most, and in heights of
 * the lower block: both its joints need room. In the model the three points coincide. */
#define PAIR_SPREAD 0.075
#define LOW_SPREAD  0.2

/* Points wide enough to read on zoom, pt. */
#define DETAIL_LEAST 9

/* A spring as a zigzag from one point to another. */
static void
add_spring (QnSceneBuilder *b, QnVec2 from, QnVec2 to, QnId pair, double extent)
{
  QnVec2 along = qn_vec2_sub (to, from), across = qn_vec2_perp (along);
  QnVec2 points[8];
  for (int i = 0; i < 8; i++) {
    double s = i == 0 ? 0 : i == 7 ? 1 : 0.2 + 0.1 * i;
    double swing = i < 2 || i > 5 ? 0 : i % 2 == 0 ? 0.22 : -0.22;
    points[i] = qn_vec2_add_scaled (qn_vec2_add_scaled (from, s, along), swing, across);
  }
  QnCommand *command = qn_scene_stroke (b->scene, QN_LAYER_SYMBOLS, points, 8, false, 0.7,
                                        qn_builder_ink (b, QN_INK_LINE));
  qn_command_set_pick (command, QN_PICK_PAIR, pair);
  qn_command_set_extent (command, extent, DETAIL_LEAST);
}

/* Height of a block above its joint, m. */
static double
block_height (const QnModel *model, QnId block, const QnContactFace *face)
{
  const QnVec2 *v = qn_model_block_vertices (model, block);
  double largest = 0;
  for (QnId i = 0; i < model->blocks[block].vertex_count; i++)
    largest =
      fmax (largest, fabs (qn_vec2_dot (qn_vec2_sub (v[i], face->start), face->normal)));
  return largest;
}

static double
pair_spread (const QnSceneBuilder *b, const QnContactFace *face)
{
  double low =
    fmin (block_height (b->model, face->a, face), block_height (b->model, face->b, face));
  return fmin (fmin (PAIR_SPREAD * b->block_size, LOW_SPREAD * low),
               0.3 * face->length / MAX (face->pair_count, 1));
}

/* Points A, B and C drawn apart with their springs and letters. */
static void
add_pair_details (QnSceneBuilder *b, const QnContactFace *face, QnId pair, double spread)
{
  static const char *const letters[3] = { "A", "B", "C" };
  /* Where the details of a pair are drawn: a little inwards of the end of its face,
   * because in masonry the ends of several faces meet in one point. */
  double inwards = fmin (1.8 * spread, 0.25 * face->length);
  double s =
    fmin (fmax (b->contacts->pairs[pair].abscissa, inwards), face->length - inwards);
  QnVec2 c = qn_vec2_add_scaled (face->start, s, face->tangent);
  QnVec2 places[3] = { qn_vec2_add_scaled (c, -spread, face->normal),
                       qn_vec2_add_scaled (c, spread, face->normal), c };
  double extent = 2 * spread;
  for (int i = 0; i < 3; i++) {
    if (i < 2)
      add_spring (b, places[i], c, pair, extent);
    QnCommand *dot =
      qn_scene_marker (b->scene, QN_LAYER_SYMBOLS, i < 2 ? QN_MARKER_DOT : QN_MARKER_RING,
                       places[i], 3.2, 0, qn_builder_ink (b, QN_INK_FACE));
    qn_command_set_pick (dot, QN_PICK_PAIR, pair);
    qn_command_set_extent (dot, extent, DETAIL_LEAST);
    QnVec2 at = qn_vec2_add_scaled (places[i], 0.5 * spread, face->tangent);
    QnCommand *text = qn_scene_text (b->scene, QN_LAYER_LABELS, at, QN_SIZE_LABEL,
                                     letters[i], qn_builder_ink (b, QN_INK_LINE));
    qn_command_set_pick (text, QN_PICK_PAIR, pair);
    qn_command_set_extent (text, extent, 3 * DETAIL_LEAST);
  }
}

static void
add_face (QnSceneBuilder *b, QnId index)
{
  const QnContactFace *face = &b->contacts->faces[index];
  QnColor color = qn_builder_ink (b, QN_INK_FACE);
  /* A little shorter than the face, so that neighbours on one line stay apart. */
  QnVec2 line[2] = { qn_vec2_lerp (face->start, face->end, 0.03),
                     qn_vec2_lerp (face->start, face->end, 0.97) };
  QnCommand *command =
    qn_scene_stroke (b->scene, QN_LAYER_JOINTS, line, 2, false, QN_WIDTH_FACE, color);
  qn_command_set_pick (command, QN_PICK_FACE, index);

  QnVec2 middle = qn_vec2_lerp (face->start, face->end, 0.5);
  double length = fmin (0.30 * b->block_size, 0.35 * face->length);
  QnVec2 tip = qn_vec2_add_scaled (middle, length, face->normal);
  qn_scene_arrow (b->scene, QN_LAYER_JOINTS, middle, tip, 0.6, color, QN_PICK_FACE, index,
                  length);
}

void
qn_build_contacts (QnSceneBuilder *b)
{
  const QnContacts *contacts = b->contacts;
  QnColor dot = qn_builder_ink (b, QN_INK_PAIR);
  bool detailed = contacts->pair_count <= MAX_DETAILED_PAIRS;

  for (size_t f = 0; f < contacts->face_count; f++) {
    add_face (b, (QnId) f);
    const QnContactFace *face = &contacts->faces[f];
    double spread = detailed ? pair_spread (b, face) : 0;
    for (int32_t k = 0; k < face->pair_count; k++) {
      QnId pair = face->first_pair + k;
      if (detailed)
        add_pair_details (b, face, pair, spread);
      QnCommand *command = qn_scene_marker (b->scene, QN_LAYER_SYMBOLS, QN_MARKER_DOT,
                                            contacts->pairs[pair].point, 3.4, 0, dot);
      qn_command_set_pick (command, QN_PICK_PAIR, pair);
      qn_command_set_extent (command, face->length / face->pair_count, 2.5);
    }
  }
  if (contacts->face_count > 0) {
    qn_scene_legend (
      b->scene, QN_COMMAND_STROKE, QN_WIDTH_FACE, qn_builder_ink (b, QN_INK_FACE),
      ngettext ("%zu contact face", "%zu contact faces", contacts->face_count),
      contacts->face_count);
    qn_scene_legend (b->scene, QN_COMMAND_MARKER, 0.6f, qn_builder_ink (b, QN_INK_FACE),
                     "%s", _ ("normal of a face"))
      ->marker = QN_MARKER_ARROW_HEAD;
    qn_scene_legend (
      b->scene, QN_COMMAND_MARKER, 3.4f, dot,
      ngettext ("%zu contact pair", "%zu contact pairs", contacts->pair_count),
      contacts->pair_count);
  }
}

void
qn_build_findings (QnSceneBuilder *b)
{
  const QnFindings *findings = &b->contacts->findings;
  QnColor color = qn_builder_ink (b, QN_INK_OPEN);
  bool used[QN_PROBLEM_COUNT] = { false };
  for (size_t i = 0; i < findings->count; i++) {
    const QnFinding *finding = &findings->items[i];
    if (!qn_finding_has_place (finding))
      continue;
    QnMarker marker = finding->problem == QN_PROBLEM_NEAR_MISS_GAP   ? QN_MARKER_DIAMOND
                      : finding->problem == QN_PROBLEM_POINT_CONTACT ? QN_MARKER_RING
                                                                     : QN_MARKER_CROSS;
    QnCommand *command =
      qn_scene_marker (b->scene, QN_LAYER_SYMBOLS, marker, finding->at, 9, 0, color);
    qn_command_set_pick (command, QN_PICK_BLOCK, finding->block_a);
    if (used[finding->problem])
      continue;
    used[finding->problem] = true;
    qn_scene_legend (b->scene, QN_COMMAND_MARKER, 9, color, "%s",
                     _ (qn_problem_text (finding->problem)))
      ->marker = (uint8_t) marker;
  }
}
