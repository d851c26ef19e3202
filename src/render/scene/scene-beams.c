/* Beams: their depth to scale, axis, nodes, hinges and supports, as they lie or as they bend. */
#include "render/scene/scene-builder.h"

#include <glib/gi18n-lib.h>

/* Straight pieces that the curve of an element is drawn by. */
#define PIECES 16

#define WIDTH_AXIS 1.3

/* Size of the symbols of supports, as a part of the structure's diagonal. */
#define SUPPORT_SHARE 0.022

/* A moment within this part of the plastic one is that of a plastic hinge. */
#define YIELDS 1e-3

/* --- Where elements are ------------------------------------------------------------------ */

void
qn_beam_drawing_init (QnBeamDrawing *drawing, const QnSceneBuilder *b)
{
  const QnModel *model = b->model;
  double factors[QN_MAX_LOAD_SETS];

  *drawing = (QnBeamDrawing){ .builder = b,
                              .bent = b->motion.displacements != NULL
                                      && b->options->view != QN_VIEW_MECHANISM };
  if (!qn_builder_shows_step (b) || b->result->beam_forces == NULL)
    return;
  drawing->forces = qn_result_step_beam_forces (b->result, b->step);
  drawing->loads = g_new0 (QnVec2, MAX (model->element_count, 1));
  g_autofree QnVec2 *dead = g_new0 (QnVec2, MAX (model->element_count, 1));
  qn_result_load_factors (model, b->result, b->step, factors);
  qn_model_element_loads (model, factors, drawing->loads);
  qn_model_element_loads (model, NULL, dead);
  for (size_t e = 0; e < model->element_count; e++)
    drawing->loads[e] = qn_vec2_add (drawing->loads[e], dead[e]);
}

void
qn_beam_drawing_clear (QnBeamDrawing *drawing)
{
  g_free (drawing->loads);
}

QnVec2
qn_builder_place_node (const QnSceneBuilder *b, QnId node)
{
  QnVec2 at = b->model->nodes[node].at;
  if (b->motion.displacements == NULL)
    return at;
  if (b->model->nodes[node].block
      != QN_NONE) /* as its block is drawn, whatever the scale */
    return qn_builder_place (b, b->model->nodes[node].block, at);
  const double *u =
    b->motion.displacements + QN_DOF_COUNT * (b->model->block_count + (size_t) node);
  return qn_vec2_add_scaled (at, b->motion.scale, qn_vec2 (u[QN_DOF_UX], u[QN_DOF_UY]));
}

/* Deflection of an element against its chord at x = s L, m; 0 where forces are not known. */
static double
deflection (const QnBeamDrawing *drawing, QnId element, double s)
{
  const QnModel *model = drawing->builder->model;
  if (drawing->forces == NULL || !drawing->bent)
    return 0;
  QnBeamProperties p = qn_beam_properties (model, element);
  QnVec2 y = qn_vec2_scale (1 / p.length, qn_vec2_perp (p.chord));
  return qn_beam_deflection (&p, drawing->forces[element].moment,
                             qn_vec2_dot (drawing->loads[element], y), s);
}

QnVec2
qn_beam_drawing_place (const QnBeamDrawing *drawing, QnId element, double s,
                       QnVec2 *across)
{
  const QnSceneBuilder *b = drawing->builder;
  const QnBeamElement *e = &b->model->elements[element];
  QnVec2 start = qn_builder_place_node (b, e->nodes[0]);
  QnVec2 end = qn_builder_place_node (b, e->nodes[1]);
  QnVec2 chord = qn_vec2_sub (end, start);
  double length = qn_vec2_length (chord);
  *across =
    length > 0 ? qn_vec2_scale (1 / length, qn_vec2_perp (chord)) : qn_vec2 (0, 1);
  return qn_vec2_add_scaled (qn_vec2_lerp (start, end, s),
                             b->motion.scale * deflection (drawing, element, s), *across);
}

/* --- Drawing ----------------------------------------------------------------------------- */

/* Depth of a section: of general ones that of the rectangle with the same radius of gyration. */
static double
depth_of (const QnSection *section)
{
  return section->height > 0 ? section->height
                             : sqrt (12 * section->inertia / section->area);
}

static void
add_element (const QnBeamDrawing *drawing, QnSceneBuilder *b, QnId element)
{
  const QnBeam *beam = &b->model->beams[b->model->elements[element].beam];
  double half = 0.5 * depth_of (&b->model->sections[beam->section]);
  QnVec2 axis[PIECES + 1], band[2 * (PIECES + 1)];
  QnColor fill = qn_builder_ink (b, QN_INK_BLOCK), line = qn_builder_ink (b, QN_INK_LINE);

  for (int i = 0; i <= PIECES; i++) {
    QnVec2 across;
    axis[i] = qn_beam_drawing_place (drawing, element, (double) i / PIECES, &across);
    band[i] = qn_vec2_add_scaled (axis[i], half, across);
    band[2 * PIECES + 1 - i] = qn_vec2_add_scaled (axis[i], -half, across);
  }
  fill.a = 140;
  QnCommand *command =
    qn_scene_fill (b->scene, QN_LAYER_BLOCKS, band, G_N_ELEMENTS (band), fill);
  qn_command_set_pick (command, QN_PICK_BEAM, b->model->elements[element].beam);
  qn_scene_stroke (b->scene, QN_LAYER_OUTLINES, band, PIECES + 1, false, QN_WIDTH_GHOST,
                   line);
  qn_scene_stroke (b->scene, QN_LAYER_OUTLINES, band + PIECES + 1, PIECES + 1, false,
                   QN_WIDTH_GHOST, line);
  command = qn_scene_stroke (b->scene, QN_LAYER_JOINTS, axis, PIECES + 1, false,
                             WIDTH_AXIS, line);
  qn_command_set_pick (command, QN_PICK_BEAM, b->model->elements[element].beam);
}

bool
qn_build_beam_ghosts (QnSceneBuilder *b)
{
  QnColor color = qn_builder_ink (b, QN_INK_FAINT);
  for (size_t i = 0; i < b->model->beam_count; i++) {
    const QnBeam *beam = &b->model->beams[i];
    QnVec2 line[2] = { b->model->nodes[beam->nodes[0]].at,
                       b->model->nodes[beam->nodes[1]].at };
    qn_scene_stroke (b->scene, QN_LAYER_GHOST, line, 2, false, QN_WIDTH_GHOST, color);
  }
  return b->model->beam_count > 0;
}

/* Hinges stand a little inside the beam, so that those of several beams at a node are told
 * apart; plastic ones are filled. */
static bool
add_hinges (const QnBeamDrawing *drawing, QnSceneBuilder *b, QnId element)
{
  const QnBeamElement *e = &b->model->elements[element];
  const QnSection *section = &b->model->sections[b->model->beams[e->beam].section];
  double plastic = qn_section_plastic_moment (section);
  bool yields = false;

  for (int end = 0; end < 2; end++) {
    QnVec2 across, at = qn_beam_drawing_place (drawing, element, end, &across);
    QnVec2 x = qn_vec2_perp (across); /* -x */
    at =
      qn_vec2_add_scaled (at, (end == 0 ? -1 : 1) * 0.008 * qn_box_diagonal (b->box), x);
    if (e->hinge[end])
      qn_scene_marker (b->scene, QN_LAYER_SYMBOLS, QN_MARKER_RING, at, 6, 0,
                       qn_builder_ink (b, QN_INK_LINE));
    else if (drawing->forces != NULL && e->yields[end]
             && fabs (drawing->forces[element].moment[end]) >= (1 - YIELDS) * plastic) {
      qn_scene_marker (b->scene, QN_LAYER_SYMBOLS, QN_MARKER_DOT, at, 7, 0,
                       qn_builder_ink (b, QN_INK_HINGE));
      yields = true;
    }
  }
  return yields;
}

/* The rigid link from the centroid of a block to a node that rides on it. */
static void
add_link (QnSceneBuilder *b, QnId node)
{
  const QnNode *n = &b->model->nodes[node];
  QnVec2 line[2] = { qn_builder_place (b, n->block, b->model->blocks[n->block].centroid),
                     qn_builder_place_node (b, node) };
  if (n->seat == QN_SEAT_CENTROID)
    return;
  qn_scene_stroke (b->scene, QN_LAYER_JOINTS, line, 2, false, 0.8,
                   qn_builder_ink (b, QN_INK_LINE))
    ->dashed = true;
}

/* A triangle where a node is held against displacement, on rollers where in one direction
 * only; a bar across where it is held against rotation. */
static void
add_node_support (QnSceneBuilder *b, QnId node)
{
  const bool *held = b->model->nodes[node].support;
  const double size = SUPPORT_SHARE * qn_box_diagonal (b->box);
  QnVec2 at = b->model->nodes[node].at; /* supports do not move */
  QnColor color = qn_builder_ink (b, QN_INK_LINE),
          fill = qn_builder_ink (b, QN_INK_SUPPORT);
  const bool sideways = held[QN_DOF_UX] && !held[QN_DOF_UY];
  QnVec2 down = sideways ? qn_vec2 (-1, 0) : qn_vec2 (0, -1), along = qn_vec2_perp (down);
  QnVec2 foot = qn_vec2_add_scaled (at, size, down);

  const QnVec2 clamp[4] = { qn_vec2_add_scaled (at, -size, along),
                            qn_vec2_add_scaled (at, size, along),
                            qn_vec2_add_scaled (foot, size, along),
                            qn_vec2_add_scaled (foot, -size, along) };
  const QnVec2 triangle[3] = { at, qn_vec2_add_scaled (foot, -0.7 * size, along),
                               qn_vec2_add_scaled (foot, 0.7 * size, along) };
  const QnVec2 *shape = held[QN_DOF_RZ] ? clamp : triangle;
  const size_t corners = held[QN_DOF_RZ] ? 4 : 3;
  qn_scene_fill (b->scene, QN_LAYER_BLOCKS, shape, corners, fill);
  qn_scene_stroke (b->scene, QN_LAYER_OUTLINES, shape, corners, true, QN_WIDTH_OUTLINE,
                   color);
  if (held[QN_DOF_UX] && held[QN_DOF_UY])
    return;
  QnVec2 ground = qn_vec2_add_scaled (foot, 0.3 * size, down);
  QnVec2 line[2] = { qn_vec2_add_scaled (ground, -size, along),
                     qn_vec2_add_scaled (ground, size, along) };
  qn_scene_stroke (b->scene, QN_LAYER_OUTLINES, line, 2, false, QN_WIDTH_OUTLINE, color);
}

void
qn_build_beams (QnSceneBuilder *b)
{
  const QnModel *model = b->model;
  QnBeamDrawing drawing;
  bool yields = false;

  if (model->node_count == 0)
    return;
  qn_beam_drawing_init (&drawing, b);
  for (size_t e = 0; e < model->element_count; e++) {
    add_element (&drawing, b, (QnId) e);
    if (b->options->symbols)
      yields |= add_hinges (&drawing, b, (QnId) e);
  }
  for (size_t i = 0; i < b->model->node_count; i++) {
    const QnNode *node = &b->model->nodes[i];
    if (qn_support_is_any (node->support))
      add_node_support (b, (QnId) i);
    if (node->block != QN_NONE)
      add_link (b, (QnId) i);
    if (node->beam == QN_NONE && b->options->symbols)
      qn_scene_marker (b->scene, QN_LAYER_SYMBOLS, QN_MARKER_DOT,
                       qn_builder_place_node (b, (QnId) i), 3, 0,
                       qn_builder_ink (b, QN_INK_LINE));
  }
  if (yields)
    qn_scene_legend (b->scene, QN_COMMAND_MARKER, 7, qn_builder_ink (b, QN_INK_HINGE),
                     "%s", _ ("plastic hinge"));
  for (size_t i = 0; b->options->names && i < model->beam_count; i++) {
    QnVec2 across;
    QnId middle = model->beams[i].first_element + model->beams[i].element_count / 2;
    QnVec2 at = qn_beam_drawing_place (
      &drawing, middle, model->beams[i].element_count % 2 ? 0.5 : 0, &across);
    qn_scene_text (b->scene, QN_LAYER_LABELS, at, QN_SIZE_LABEL, model->beams[i].name,
                   qn_builder_ink (b, QN_INK_LINE))
      ->align_y = -0.4f;
  }
  qn_beam_drawing_clear (&drawing);
}
