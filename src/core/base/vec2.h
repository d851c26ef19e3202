/* Plane vectors. Counter-clockwise is positive; the z component of a cross product is a scalar. */
#pragma once

#include <math.h>

typedef struct QnVec2 {
  double x;
  double y;
} QnVec2;

static inline QnVec2
qn_vec2 (double x, double y)
{
  return (QnVec2){ x, y };
}

static inline QnVec2
qn_vec2_add (QnVec2 a, QnVec2 b)
{
  return (QnVec2){ a.x + b.x, a.y + b.y };
}

/* a - b */
static inline QnVec2
qn_vec2_sub (QnVec2 a, QnVec2 b)
{
  return (QnVec2){ a.x - b.x, a.y - b.y };
}

static inline QnVec2
qn_vec2_scale (double s, QnVec2 a)
{
  return (QnVec2){ s * a.x, s * a.y };
}

/* a + s b */
static inline QnVec2
qn_vec2_add_scaled (QnVec2 a, double s, QnVec2 b)
{
  return (QnVec2){ a.x + s * b.x, a.y + s * b.y };
}

static inline double
qn_vec2_dot (QnVec2 a, QnVec2 b)
{
  return a.x * b.x + a.y * b.y;
}

/* z component of a x b */
static inline double
qn_vec2_cross (QnVec2 a, QnVec2 b)
{
  return a.x * b.y - a.y * b.x;
}

/* a turned by +90 degrees */
static inline QnVec2
qn_vec2_perp (QnVec2 a)
{
  return (QnVec2){ -a.y, a.x };
}

static inline double
qn_vec2_length (QnVec2 a)
{
  return hypot (a.x, a.y);
}

static inline QnVec2
qn_vec2_lerp (QnVec2 a, QnVec2 b, double s)
{
  return (QnVec2){ a.x + s * (b.x - a.x), a.y + s * (b.y - a.y) };
}

/* How far a turns away from itself, (R - 1) a, without the loss of digits of R a - a where the
 * angle is small: cos - 1 = -2 sin^2(angle / 2). */
static inline QnVec2
qn_vec2_turn_away (QnVec2 a, double angle)
{
  double half = sin (0.5 * angle);

  return qn_vec2_add_scaled (qn_vec2_scale (-2 * half * half, a), sin (angle),
                             qn_vec2_perp (a));
}

/* a turned by an angle whose cosine and sine are given */
static inline QnVec2
qn_vec2_rotate (QnVec2 a, double cosine, double sine)
{
  return (QnVec2){ cosine * a.x - sine * a.y, sine * a.x + cosine * a.y };
}
