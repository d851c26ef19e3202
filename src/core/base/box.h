/* Axis-parallel boxes. */
#pragma once

#include "core/base/numbers.h"
#include "core/base/vec2.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct QnBox {
  QnVec2 min, max; /* m; empty where min > max */
} QnBox;

#define QN_BOX_EMPTY                                                                     \
  ((QnBox){ { (double) INFINITY, (double) INFINITY },                                    \
            { -(double) INFINITY, -(double) INFINITY } })

static inline bool
qn_box_is_empty (QnBox box)
{
  return !(box.min.x <= box.max.x && box.min.y <= box.max.y);
}

/* Smallest box around both; of numbers that are not NaN. */
static inline QnBox
qn_box_union (QnBox a, QnBox b)
{
  return (QnBox){ { qn_min (a.min.x, b.min.x), qn_min (a.min.y, b.min.y) },
                  { qn_max (a.max.x, b.max.x), qn_max (a.max.y, b.max.y) } };
}

/* Makes a box large enough for a point; a coordinate that is NaN changes nothing. */
static inline void
qn_box_add_point (QnBox *box, QnVec2 p)
{
  box->min.x = fmin (box->min.x, p.x);
  box->min.y = fmin (box->min.y, p.y);
  box->max.x = fmax (box->max.x, p.x);
  box->max.y = fmax (box->max.y, p.y);
}

/* The same for a box, which may be empty. */
static inline void
qn_box_add_box (QnBox *box, QnBox other)
{
  if (!qn_box_is_empty (other))
    *box = qn_box_union (*box, other);
}

/* Smallest box around two points. */
static inline QnBox
qn_box_of_segment (QnVec2 p, QnVec2 q)
{
  return (QnBox){ { qn_min (p.x, q.x), qn_min (p.y, q.y) },
                  { qn_max (p.x, q.x), qn_max (p.y, q.y) } };
}

/* Smallest box around points, none of them NaN. */
static inline QnBox
qn_box_of_points (const QnVec2 *points, size_t count)
{
  QnBox box = QN_BOX_EMPTY;

  for (size_t i = 0; i < count; i++)
    box = qn_box_union (box, (QnBox){ points[i], points[i] });
  return box;
}

static inline QnBox
qn_box_grow (QnBox box, double margin)
{
  return (QnBox){ { box.min.x - margin, box.min.y - margin },
                  { box.max.x + margin, box.max.y + margin } };
}

/* The smaller of width and height, m. */
static inline double
qn_box_smaller_side (QnBox box)
{
  return qn_min (box.max.x - box.min.x, box.max.y - box.min.y);
}

/* The larger of width and height, m; 0 where empty. */
static inline double
qn_box_size (QnBox box)
{
  return box.max.x < box.min.x ? 0 : fmax (box.max.x - box.min.x, box.max.y - box.min.y);
}

static inline double
qn_box_diagonal (QnBox box)
{
  return qn_box_is_empty (box) ? 0 : qn_vec2_length (qn_vec2_sub (box.max, box.min));
}

/* Whether two boxes have a point in common. All four comparisons in one: which of them fails cannot
 * be predicted. */
static inline bool
qn_box_meets (QnBox a, QnBox b)
{
  return (a.min.x <= b.max.x) & (b.min.x <= a.max.x) & (a.min.y <= b.max.y)
         & (b.min.y <= a.max.y);
}

/* The same where each may be off by half the margin, m. */
static inline bool
qn_box_meets_within (QnBox a, QnBox b, double margin)
{
  return a.min.x <= b.max.x + margin && b.min.x <= a.max.x + margin
         && a.min.y <= b.max.y + margin && b.min.y <= a.max.y + margin;
}
