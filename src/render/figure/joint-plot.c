#include "render/figure/joint-plot.h"

#include "render/figure/plot.h"

#include <math.h>
#include <stdlib.h>

/* Share of the height that the upper diagram has, and sizes, pt. */
#define UPPER_SHARE  0.58
#define JOINT_MARGIN 4.0
#define JOINT_MARK   5.2

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

/* Round: sticks; square: slips or yields; hollow: open. `x` and `y` have a place for every point. */
static void
add_joint_points (QnPlot *plot, const QnJointPlot *joint, const double *x,
                  const double *y)
{
  static const struct {
    QnMarker marker;
    int series;
  } looks[QN_PAIR_STATE_COUNT] = {
    [QN_PAIR_STICK] = { QN_MARKER_DOT, 0 },
    [QN_PAIR_OPEN] = { QN_MARKER_RING, 0 },
    [QN_PAIR_SLIP] = { QN_MARKER_SQUARE, 1 },
    [QN_PAIR_YIELD] = { QN_MARKER_SQUARE, 1 },
  };
  for (size_t i = 0; i < joint->count; i++)
    qn_plot_points (plot, NULL, looks[joint->points[i].state].series, x + i, y + i, 1,
                    looks[joint->points[i].state].marker, JOINT_MARK);
}

/* Largest compression and tension; a cone is shown a little beyond. */
static void
find_joint_ranges (const QnJointPlot *joint, double *press, double *pull)
{
  *press = *pull = 0;
  for (size_t i = 0; i < joint->count; i++) {
    const QnJointPoint *p = &joint->points[i];
    *press = fmax (*press, -p->normal);
    *pull = fmax (*pull, p->normal);
    if (p->has_cone && isfinite (p->cap))
      *pull = fmax (*pull, fmin (p->cap, 0.5 * *press));
  }
  if (!(*press > 0) && !(*pull > 0))
    *press = 1;
  *press *= 1.12;
  *pull *= 1.12;
}

/* Both sides of every cone that differs from the one before. */
static void
add_cones (QnPlot *plot, const QnJointPlot *joint)
{
  const QnJointPoint *last = NULL;
  double press, pull;
  find_joint_ranges (joint, &press, &pull);
  for (size_t i = 0; i < joint->count; i++) {
    const QnJointPoint *p = &joint->points[i];
    if (!p->has_cone
        || (last != NULL && last->friction == p->friction && last->cohesion == p->cohesion
            && last->cap == p->cap && last->compression == p->compression))
      continue;
    last = p;
    double cap = fmin (isfinite (p->cap) ? p->cap : pull, pull);
    double end = fmin (p->compression, press);
    double at_cap = fmax (p->cohesion - p->friction * cap, 0);
    double at_end = p->cohesion + p->friction * end;
    const double corners[2][5] = { { -end, cap, cap, -end, -end },
                                   { at_end, at_cap, -at_cap, -at_end, at_end } };
    double *x = qn_plot_keep (plot, g_memdup2 (corners, sizeof corners));
    qn_plot_mark (plot, QN_MARKS_LINE, NULL, QN_SERIES_INK, x, x + 5,
                  end < press ? 5 : 4);
  }
}

/* Normal forces as bars, shear as crosses to the same scale. */
static void
add_joint_bars (QnPlot *plot, const QnJointPlot *joint, const double *along,
                const double *normal, const double *shear)
{
  double *x = qn_plot_keep (plot, g_new (double, 6 * joint->count)),
         *y = x + 3 * joint->count;
  for (size_t i = 0; i < joint->count; i++) {
    x[3 * i] = x[3 * i + 1] = x[3 * i + 2] = along[i];
    y[3 * i] = 0;
    y[3 * i + 1] = normal[i];
    y[3 * i + 2] = NAN;
  }
  qn_plot_mark (plot, QN_MARKS_LINE, NULL, 0, x, y, 3 * joint->count);
  qn_plot_points (plot, NULL, QN_SERIES_INK, along, shear, joint->count, QN_MARKER_CROSS,
                  JOINT_MARK);
}

void
qn_joint_plot_draw (const QnJointPlot *joint, cairo_t *cr, double width, double height,
                    double unit)
{
  const double margin = JOINT_MARGIN * unit, upper = UPPER_SHARE * (height - 3 * margin);
  const QnFrame frames[] = { { margin, margin, width - 2 * margin, upper },
                             { margin, 2 * margin + upper, width - 2 * margin,
                               height - upper - 3 * margin } };
  QnPlot *cone = qn_plot_new (joint->normal_label, joint->shear_label);
  QnPlot *along = qn_plot_new (joint->along_label, joint->normal_label);
  double *x = qn_plot_keep (cone, g_new (double, 3 * joint->count));
  double *normal = x + joint->count, *shear = normal + joint->count;
  for (size_t i = 0; i < joint->count; i++) {
    x[i] = joint->points[i].along;
    normal[i] = joint->points[i].normal;
    shear[i] = joint->points[i].shear;
  }
  cone->x.factor = cone->y.factor = along->y.factor = 1 / joint->force_factor;
  along->x.factor = 1 / joint->length_factor;
  add_cones (cone, joint);
  add_joint_points (cone, joint, normal, shear);
  add_joint_bars (along, joint, x, normal, shear);
  add_joint_points (along, joint, x, normal);
  qn_plot_draw (cone, cr, unit, &frames[0], NULL);
  qn_plot_draw (along, cr, unit, &frames[1], NULL);
  qn_plot_free (along);
  qn_plot_free (cone);
}
