#include "render/figure/joint-plot.h"

#include "render/drawing/paint.h"
#include "render/drawing/text.h"

#include <glib.h>

#include <math.h>
#include <stdlib.h>

#define MARGIN_PT 6.0
#define TEXT_PT   7.0
#define MARK_PT   2.6

typedef struct Area {
  double x, y, width, height; /* px */
} Area;

typedef struct JointDrawing {
  const QnJointPlot *plot;
  cairo_t *cr;
  double unit;
  QnColor ink, faint;
} JointDrawing;

/* ---- data ---- */

/* The weaker of the two springs bounds what a pair can carry. */
static void
fill_strength (QnJointPoint *point, const QnPairSprings *springs)
{
  const QnSpring *sides[] = { &springs->a, &springs->b };
  int count = springs->equal ? 1 : 2;
  point->friction = point->cohesion = point->cap = point->compression = INFINITY;
  for (int i = 0; i < count; i++) {
    QnStrengthRow rows[QN_STRENGTH_ROWS];
    int row_count = qn_spring_strength (sides[i], rows);
    for (const QnStrengthRow *row = rows; row < rows + row_count; row++) {
      if (row->shear > 0) {
        point->friction = fmin (point->friction, row->normal);
        point->cohesion = fmin (point->cohesion, row->limit);
        point->has_cone = true;
      } else if (row->normal > 0) {
        point->cap = fmin (point->cap, row->limit);
      } else {
        point->compression = fmin (point->compression, row->limit);
      }
    }
  }
}

bool
qn_joint_plot_fill (QnJointPlot *plot, const QnModel *model, const QnContacts *contacts,
                    const QnResult *result, int step, QnId face)
{
  const QnContactFace *f = &contacts->faces[face];
  plot->points = NULL;
  plot->count = 0;
  plot->length = f->length;
  if (result->pairs == NULL)
    return false;
  plot->points = calloc ((size_t) f->pair_count + 1, sizeof *plot->points);
  if (plot->points == NULL)
    return false;
  bool kept = step >= 0 && qn_result_has_forces (result, (size_t) step);
  for (int32_t i = 0; i < f->pair_count; i++) {
    size_t pair = (size_t) (f->first_pair + i);
    QnPairResult r =
      kept ? qn_result_pair_at (result, (size_t) step, pair) : result->pairs[pair];
    QnPairSprings springs = qn_contacts_pair_springs (model, contacts, pair);
    QnJointPoint *point = &plot->points[plot->count++];
    *point = (QnJointPoint){ .along = contacts->pairs[pair].abscissa,
                             .normal = r.normal_force,
                             .shear = r.shear_force,
                             .state = r.state };
    fill_strength (point, &springs);
  }
  return true;
}

/* ---- drawing ---- */

/* The ink of a state on this ground. */
static QnColor
state_ink (const JointDrawing *d, QnPairState state)
{
  switch (state) {
  case QN_PAIR_SLIP:
  case QN_PAIR_YIELD:
    return d->plot->dark ? qn_rgb (0xffb454) : qn_ink (QN_INK_SLIDE, false);
  case QN_PAIR_OPEN:
    return d->plot->dark ? qn_rgb (0xff8a80) : qn_ink (QN_INK_OPEN, false);
  case QN_PAIR_STICK:
  case QN_PAIR_STATE_COUNT:
    break;
  }
  return d->plot->dark ? qn_rgb (0x8ec7ff) : qn_ink (QN_INK_SELECTION, false);
}

/* Round: sticks; square: slips or yields; hollow: open. */
static void
draw_mark (const JointDrawing *d, double x, double y, QnPairState state)
{
  double r = MARK_PT * d->unit;
  qn_set_color (d->cr, state_ink (d, state), 1.0);
  cairo_new_path (d->cr);
  if (state == QN_PAIR_SLIP || state == QN_PAIR_YIELD)
    cairo_rectangle (d->cr, x - r, y - r, 2 * r, 2 * r);
  else
    cairo_arc (d->cr, x, y, r, 0, 2 * M_PI);
  if (state == QN_PAIR_OPEN) {
    cairo_set_line_width (d->cr, 1.2 * d->unit);
    cairo_stroke (d->cr);
  } else
    cairo_fill (d->cr);
}

static void
draw_joint_line (const JointDrawing *d, double x0, double y0, double x1, double y1,
                 QnColor color, double width)
{
  qn_set_color (d->cr, color, 1.0);
  cairo_set_line_width (d->cr, width * d->unit);
  cairo_move_to (d->cr, x0, y0);
  cairo_line_to (d->cr, x1, y1);
  cairo_stroke (d->cr);
}

static void
draw_text (const JointDrawing *d, const char *text, double x, double y, double align_x,
           double align_y, double angle)
{
  QnTextStyle style = { .size = TEXT_PT * d->unit };
  qn_text_draw (d->cr, &style, text, x, y, align_x, align_y, angle, d->ink);
}

static void
draw_force (const JointDrawing *d, double force, double x, double y, double align_x,
            double align_y)
{
  char *text = qn_label_number ("%.3g", force / d->plot->force_factor);
  draw_text (d, text, x, y, align_x, align_y, 0);
  g_free (text);
}

/* Largest compression, tension and shear, cone included. */
static void
ranges (const QnJointPlot *plot, double *press, double *pull, double *shear)
{
  *press = *pull = *shear = 0;
  for (size_t i = 0; i < plot->count; i++) {
    const QnJointPoint *p = &plot->points[i];
    *press = fmax (*press, -p->normal);
    *pull = fmax (*pull, p->normal);
    *shear = fmax (*shear, fabs (p->shear));
    if (p->has_cone && isfinite (p->cap))
      *pull = fmax (*pull, fmin (p->cap, 0.5 * *press));
  }
  if (!(*press > 0) && !(*pull > 0))
    *press = 1;
  *press *= 1.12;
  *pull *= 1.12;
  for (size_t i = 0; i < plot->count; i++) {
    const QnJointPoint *p = &plot->points[i];
    if (p->has_cone)
      *shear = fmax (*shear, fmin (p->cohesion + p->friction * *press, 3 * *press));
  }
  *shear = *shear > 0 ? 1.08 * *shear : *press;
}

/* Both sides of every cone that differs from the one before. */
static void
draw_cones (const JointDrawing *d, Area a, double press, double pull, double shear)
{
  double zero = a.x + a.width * press / (press + pull), middle = a.y + a.height / 2;
  double per_n = a.width / (press + pull), per_t = a.height / 2 / shear;
  const QnJointPoint *last = NULL;
  for (size_t i = 0; i < d->plot->count; i++) {
    const QnJointPoint *p = &d->plot->points[i];
    if (!p->has_cone
        || (last != NULL && last->friction == p->friction && last->cohesion == p->cohesion
            && last->cap == p->cap && last->compression == p->compression))
      continue;
    last = p;
    double cap = fmin (isfinite (p->cap) ? p->cap : pull, pull);
    double at_cap = fmax (p->cohesion - p->friction * cap, 0);
    double end = fmin (p->compression, press);
    double at_end = p->cohesion + p->friction * end, left = zero - end * per_n;
    cairo_save (d->cr);
    cairo_rectangle (d->cr, a.x, a.y, a.width, a.height);
    cairo_clip (d->cr);
    cairo_move_to (d->cr, left, middle - at_end * per_t);
    cairo_line_to (d->cr, zero + cap * per_n, middle - at_cap * per_t);
    cairo_line_to (d->cr, zero + cap * per_n, middle + at_cap * per_t);
    cairo_line_to (d->cr, left, middle + at_end * per_t);
    if (end < press)
      cairo_close_path (d->cr);
    qn_set_color (d->cr, d->ink, 0.07);
    cairo_fill_preserve (d->cr);
    qn_set_color (d->cr, d->ink, 0.8);
    cairo_set_line_width (d->cr, 0.9 * d->unit);
    cairo_stroke (d->cr);
    cairo_restore (d->cr);
  }
}

/* Compression as bars downwards, shear as marks to the same scale. */
static void
draw_along_diagram (const JointDrawing *d, Area a)
{
  double most = 0, u = d->unit;
  for (size_t i = 0; i < d->plot->count; i++)
    most = fmax (
      most, fmax (fabs (d->plot->points[i].normal), fabs (d->plot->points[i].shear)));
  most = most > 0 ? 1.1 * most : 1;
  double middle = a.y + a.height / 2, per_force = a.height / 2 / most;
  double scale = d->plot->length > 0 ? a.width / d->plot->length : 0;
  draw_joint_line (d, a.x, middle, a.x + a.width, middle, d->ink, 0.8);
  for (size_t i = 0; i < d->plot->count; i++) {
    const QnJointPoint *p = &d->plot->points[i];
    double x = a.x + p->along * scale;
    draw_joint_line (d, x, middle, x, middle - p->normal * per_force,
                     state_ink (d, p->state), 2.4);
    draw_joint_line (d, x - 3 * u, middle - p->shear * per_force, x + 3 * u,
                     middle - p->shear * per_force, d->ink, 1.4);
    draw_mark (d, x, middle - p->normal * per_force, p->state);
  }
  draw_text (d, d->plot->along_label, a.x + a.width / 2, a.y + a.height + 2 * u, 0.5, 0,
             0);
  draw_force (d, -most, a.x + 6 * u, a.y + a.height, 0, 1);
}

void
qn_joint_plot_draw (const QnJointPlot *plot, cairo_t *cr, double width, double height,
                    double unit)
{
  JointDrawing d = { plot, cr, unit, qn_ink (QN_INK_LINE, false),
                     qn_ink (QN_INK_FAINT, false) };
  if (plot->dark) {
    d.ink = qn_rgb (0xe6e6e6);
    d.faint = qn_rgb (0x8a8a8a);
  }
  double margin = MARGIN_PT * unit, label = (TEXT_PT + 4) * unit;
  double upper = 0.58 * (height - 3 * margin - label);
  Area cone = { margin, margin, width - 2 * margin, upper };
  Area along = { margin + 4 * unit, 2 * margin + upper, width - 2 * margin - 8 * unit,
                 height - upper - 3 * margin - label };
  if (cone.width <= 0 || upper <= 0 || along.height <= 0)
    return;
  /* Compression to the left, so that the cone opens that way. */
  double press, pull, shear;
  ranges (d.plot, &press, &pull, &shear);
  double zero = cone.x + cone.width * press / (press + pull),
         middle = cone.y + cone.height / 2;
  draw_cones (&d, cone, press, pull, shear);
  draw_joint_line (&d, cone.x, middle, cone.x + cone.width, middle, d.faint, 0.5);
  draw_joint_line (&d, zero, cone.y, zero, cone.y + cone.height, d.faint, 0.5);
  for (size_t i = 0; i < d.plot->count; i++) {
    const QnJointPoint *p = &d.plot->points[i];
    draw_mark (&d, zero + p->normal * cone.width / (press + pull),
               middle - p->shear * cone.height / 2 / shear, p->state);
  }
  double u = d.unit;
  draw_force (&d, -press, cone.x, middle + 2 * u, 0, 0);
  draw_force (&d, shear, zero - 3 * u, cone.y + (TEXT_PT + 2) * u, 1, 0);
  draw_force (&d, -shear, zero - 3 * u, cone.y + cone.height, 1, 1);
  draw_text (&d, d.plot->normal_label, cone.x, middle - 2 * u, 0, 1, 0);
  draw_text (&d, d.plot->shear_label, zero - 3 * u, cone.y, 1, 0, 0);
  draw_along_diagram (&d, along);
}
