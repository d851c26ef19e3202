#include "render/figure/joint-plot.h"

#include <math.h>

/* Share of the height that the upper diagram has, and sizes, pt. */
#define UPPER_SHARE  0.58
#define JOINT_MARGIN 4.0
#define JOINT_MARK   5.2

/* What a pair carries: friction as a tangent, the others N; INFINITY: without limit. */
typedef struct Strength {
  bool has_cone; /* by friction: */
  double friction, cohesion, cap, compression;
} Strength;

/* That of the weaker of its two springs. */
static Strength
strength_of (const QnPairSprings *springs)
{
  const QnSpring *sides[] = { &springs->a, &springs->b };
  Strength strength = { false, INFINITY, INFINITY, INFINITY, INFINITY };
  for (int i = 0; i < (springs->equal ? 1 : 2); i++) {
    QnStrengthRow rows[QN_STRENGTH_ROWS];
    int row_count = qn_spring_strength (sides[i], rows);
    for (const QnStrengthRow *row = rows; row < rows + row_count; row++) {
      if (row->shear > 0) {
        strength.friction = fmin (strength.friction, row->normal);
        strength.cohesion = fmin (strength.cohesion, row->limit);
        strength.has_cone = true;
      } else if (row->normal > 0) {
        strength.cap = fmin (strength.cap, row->limit);
      } else {
        strength.compression = fmin (strength.compression, row->limit);
      }
    }
  }
  return strength;
}

/* Round: sticks; square: slips or yields; hollow: open. */
static void
add_joint_points (QnPlot *plot, const QnPairResult *pairs, size_t count, const double *x,
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
  for (size_t i = 0; i < count; i++)
    qn_plot_points (plot, NULL, looks[pairs[i].state].series, x + i, y + i, 1,
                    looks[pairs[i].state].marker, JOINT_MARK);
}

/* Largest compression and tension; a cone is shown a little beyond. */
static void
find_joint_ranges (const double *normal, const Strength *strengths, size_t count,
                   double *press, double *pull)
{
  *press = *pull = 0;
  for (size_t i = 0; i < count; i++) {
    *press = fmax (*press, -normal[i]);
    *pull = fmax (*pull, normal[i]);
    if (strengths[i].has_cone && isfinite (strengths[i].cap))
      *pull = fmax (*pull, fmin (strengths[i].cap, 0.5 * *press));
  }
  if (!(*press > 0) && !(*pull > 0))
    *press = 1;
  *press *= 1.12;
  *pull *= 1.12;
}

/* Both sides of every cone that differs from the one before. */
static void
add_cones (QnPlot *plot, const double *normal, const Strength *strengths, size_t count)
{
  const Strength *last = NULL;
  double press, pull;
  find_joint_ranges (normal, strengths, count, &press, &pull);
  for (const Strength *s = strengths; s < strengths + count; s++) {
    if (!s->has_cone
        || (last != NULL && last->friction == s->friction && last->cohesion == s->cohesion
            && last->cap == s->cap && last->compression == s->compression))
      continue;
    last = s;
    double cap = fmin (isfinite (s->cap) ? s->cap : pull, pull);
    double end = fmin (s->compression, press);
    double at_cap = fmax (s->cohesion - s->friction * cap, 0);
    double at_end = s->cohesion + s->friction * end;
    const double corners[2][5] = { { -end, cap, cap, -end, -end },
                                   { at_end, at_cap, -at_cap, -at_end, at_end } };
    double *x = qn_plot_keep (plot, g_memdup2 (corners, sizeof corners));
    qn_plot_mark (plot, QN_MARKS_LINE, NULL, QN_SERIES_INK, x, x + 5,
                  end < press ? 5 : 4);
  }
}

void
qn_joint_plots_init (QnPlot *plots[2], const QnModel *model, const QnContacts *contacts,
                     const QnPairResult *pairs, QnId face)
{
  const size_t first = (size_t) contacts->faces[face].first_pair;
  const size_t count = (size_t) contacts->faces[face].pair_count;
  QnPlot *cone = plots[0] = qn_plot_new (NULL, NULL);
  QnPlot *along = plots[1] = qn_plot_new (NULL, NULL);
  g_autofree Strength *strengths = g_new (Strength, count);
  double *x = qn_plot_keep (cone, g_new (double, 3 * count));
  double *normal = x + count, *shear = normal + count;
  for (size_t i = 0; i < count; i++) {
    const QnPairSprings springs = qn_contacts_pair_springs (model, contacts, first + i);
    strengths[i] = strength_of (&springs);
    x[i] = contacts->pairs[first + i].abscissa;
    normal[i] = pairs[first + i].normal_force;
    shear[i] = pairs[first + i].shear_force;
  }
  add_cones (cone, normal, strengths, count);
  add_joint_points (cone, pairs + first, count, normal, shear);
  /* Normal forces as bars, shear as crosses to the same scale. */
  double *across = qn_plot_keep (along, g_new (double, 6 * count)),
         *up = across + 3 * count;
  for (size_t i = 0; i < count; i++) {
    across[3 * i] = across[3 * i + 1] = across[3 * i + 2] = x[i];
    up[3 * i] = 0;
    up[3 * i + 1] = normal[i];
    up[3 * i + 2] = NAN;
  }
  qn_plot_mark (along, QN_MARKS_LINE, NULL, 0, across, up, 3 * count);
  qn_plot_points (along, NULL, QN_SERIES_INK, x, shear, count, QN_MARKER_CROSS,
                  JOINT_MARK);
  add_joint_points (along, pairs + first, count, x, normal);
}

void
qn_joint_plots_draw (QnPlot *const plots[2], cairo_t *cr, double width, double height,
                     double unit)
{
  const double margin = JOINT_MARGIN * unit, upper = UPPER_SHARE * (height - 3 * margin);
  const QnFrame frames[] = { { margin, margin, width - 2 * margin, upper },
                             { margin, 2 * margin + upper, width - 2 * margin,
                               height - upper - 3 * margin } };
  for (int i = 0; i < 2; i++)
    qn_plot_draw (plots[i], cr, unit, &frames[i], NULL);
}
