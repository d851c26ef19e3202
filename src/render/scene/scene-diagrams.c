/* Diagrams of section forces along beams, drawn across their axes: moments on the side in
 * tension, normal and shear forces to the side of y where they are positive. */
#include "render/drawing/text.h"
#include "render/scene/scene-builder.h"

#include <glib/gi18n-lib.h>

/* Straight pieces of the diagram of an element. */
#define DIAGRAM_PIECES 24

/* Largest ordinate, as a part of the structure's diagonal. */
#define LARGEST 0.1

/* Values below this part of the largest have no label. */
#define LEAST_LABEL 0.02

/* Value at x = s L of an element; N and V change along it with its load, M with V. */
static double
value_at (const QnBeamDrawing *drawing, QnId element, double s)
{
  QnBeamProperties p = qn_beam_properties (drawing->builder->model, element);
  QnBeamPoint at = qn_beam_forces_at (&drawing->forces[element], p.length, s);
  QnDiagram diagram = drawing->builder->options->diagram;
  return diagram == QN_DIAGRAM_NORMAL  ? at.normal
         : diagram == QN_DIAGRAM_SHEAR ? at.shear
                                       : at.moment;
}

/* Moments are drawn on the side in tension, which is -y where they are positive. */
static QnVec2
ordinate (const QnBeamDrawing *drawing, QnId element, double s, double per_unit,
          QnVec2 *foot, QnVec2 *across)
{
  bool moment = drawing->builder->options->diagram == QN_DIAGRAM_MOMENT;
  double value = value_at (drawing, element, s);
  *foot = qn_beam_drawing_place (drawing, element, s, across);
  return qn_vec2_add_scaled (*foot, (moment ? -1 : 1) * per_unit * value, *across);
}

static void
add_area (QnSceneBuilder *b, const QnBeamDrawing *drawing, QnId element, double per_unit)
{
  QnColor color = qn_builder_ink (b, QN_INK_FORCE), fill = color;
  QnVec2 curve[DIAGRAM_PIECES + 1];
  fill.a = 64;
  for (int i = 0; i <= DIAGRAM_PIECES; i++) {
    QnVec2 foot, across, before;
    curve[i] =
      ordinate (drawing, element, (double) i / DIAGRAM_PIECES, per_unit, &foot, &across);
    if (i == 0)
      continue;
    /* Strip by strip: where the value changes its sign, the whole would cross itself. */
    ordinate (drawing, element, (double) (i - 1) / DIAGRAM_PIECES, per_unit, &before,
              &across);
    double low = qn_vec2_dot (qn_vec2_sub (curve[i - 1], before), across);
    double high = qn_vec2_dot (qn_vec2_sub (curve[i], foot), across);
    if (low * high < 0) {
      QnVec2 zero = qn_vec2_lerp (before, foot, low / (low - high));
      QnVec2 first[3] = { before, zero, curve[i - 1] },
             second[3] = { zero, foot, curve[i] };
      qn_scene_fill (b->scene, QN_LAYER_FORCES, first, 3, fill);
      qn_scene_fill (b->scene, QN_LAYER_FORCES, second, 3, fill);
    } else if (low != 0 || high != 0) {
      QnVec2 strip[4] = { before, foot, curve[i], curve[i - 1] };
      qn_scene_fill (b->scene, QN_LAYER_FORCES, strip, 4, fill);
    }
  }
  QnCommand *line = qn_scene_stroke (b->scene, QN_LAYER_FORCES, curve, DIAGRAM_PIECES + 1,
                                     false, 1.1, color);
  qn_command_set_pick (line, QN_PICK_BEAM, b->model->elements[element].beam);
}

static void
add_label (QnSceneBuilder *b, const QnBeamDrawing *drawing, QnId element, double s,
           double per_unit)
{
  QnVec2 foot, across, at = ordinate (drawing, element, s, per_unit, &foot, &across);
  g_autofree char *number =
    qn_label_number ("%.4g", value_at (drawing, element, s) / 1000);
  QnColor color = qn_builder_ink (b, QN_INK_FORCE);
  QnVec2 away = qn_vec2_sub (at, foot);
  QnCommand *label =
    qn_scene_text (b->scene, QN_LAYER_LABELS, at, QN_SIZE_LABEL, number, color);
  bool flat = fabs (away.y) >= fabs (away.x);
  label->align_x = flat ? 0.5f : away.x > 0 ? -0.1f : 1.1f;
  label->align_y = !flat ? 0.5f : away.y > 0 ? -0.2f : 1.2f;
}

/* The ends of a beam and the largest value between them, where it exceeds both. */
static void
label_beam (QnSceneBuilder *b, const QnBeamDrawing *drawing, const QnBeam *beam,
            double largest, double per_unit)
{
  QnId last = beam->first_element + beam->element_count - 1, best = beam->first_element;
  double ends[2] = { value_at (drawing, beam->first_element, 0),
                     value_at (drawing, last, 1) };
  double most = 0, place = 0;

  for (QnId e = beam->first_element; e <= last; e++)
    for (int i = 0; i <= DIAGRAM_PIECES; i++) {
      double value = fabs (value_at (drawing, e, (double) i / DIAGRAM_PIECES));
      if (value > most * (1 + 1e-9)) {
        most = value;
        best = e;
        place = (double) i / DIAGRAM_PIECES;
      }
    }
  bool even =
    fabs (ends[0] - ends[1]) <= 1e-6 * largest && most <= fabs (ends[0]) + 1e-6 * largest;
  if (even && most >= LEAST_LABEL * largest) { /* one label says it all */
    add_label (b, drawing, (beam->first_element + last) / 2,
               beam->element_count % 2 ? 0.5 : 1, per_unit);
    return;
  }
  if (fabs (ends[0]) >= LEAST_LABEL * largest)
    add_label (b, drawing, beam->first_element, 0, per_unit);
  if (fabs (ends[1]) >= LEAST_LABEL * largest)
    add_label (b, drawing, last, 1, per_unit);
  if (most > (1 + 1e-6) * fmax (fabs (ends[0]), fabs (ends[1]))
      && most >= LEAST_LABEL * largest)
    add_label (b, drawing, best, place, per_unit);
}

void
qn_build_diagrams (QnSceneBuilder *b)
{
  static const char *const names[QN_DIAGRAM_COUNT] = {
    [QN_DIAGRAM_NORMAL] = N_ ("normal force N, tension positive"),
    [QN_DIAGRAM_SHEAR] = N_ ("shear force V"),
    [QN_DIAGRAM_MOMENT] = N_ ("bending moment M, drawn on the side in tension"),
  };
  QnBeamDrawing drawing;
  qn_beam_drawing_init (&drawing, b);
  double largest = 0;
  for (size_t e = 0; e < b->model->element_count; e++)
    for (int i = 0; i <= DIAGRAM_PIECES; i++)
      largest =
        fmax (largest, fabs (value_at (&drawing, (QnId) e, (double) i / DIAGRAM_PIECES)));
  /* Rounding is no shear force. */
  if (largest > 1e-9) {
    double per_unit = LARGEST * qn_box_diagonal (b->box) / largest;
    for (size_t e = 0; e < b->model->element_count; e++)
      add_area (b, &drawing, (QnId) e, per_unit);
    for (size_t i = 0; i < b->model->beam_count; i++)
      label_beam (b, &drawing, &b->model->beams[i], largest, per_unit);
  }
  g_autofree char *number = qn_label_number ("%.4g", largest / 1000);
  qn_scene_legend (b->scene, QN_COMMAND_STROKE, 2, qn_builder_ink (b, QN_INK_FORCE),
                   _ ("%s, largest %s %s"), _ (names[b->options->diagram]), number,
                   b->options->diagram == QN_DIAGRAM_MOMENT ? "kN·m" : "kN");
  qn_beam_drawing_clear (&drawing);
}
