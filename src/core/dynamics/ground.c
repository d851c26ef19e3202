#include "core/dynamics/ground.h"

/* Part of a pulse's duration that is rounding of times. */
#define ROUNDING 1e-9

static double *
integrate (const QnGroundMotion *motion, QnPool *pool)
{
  double *velocity = qn_pool_alloc (pool, motion->point_count, sizeof *velocity);

  for (size_t i = 1; velocity != NULL && i < motion->point_count; i++) {
    QnVec2 a = motion->points[i - 1], b = motion->points[i];
    velocity[i] = velocity[i - 1] + 0.5 * (a.y + b.y) * (b.x - a.x);
  }
  return velocity;
}

bool
qn_ground_init (QnGround *ground, const QnModel *model)
{
  *ground = (QnGround){ .model = model };
  ground->velocities =
    qn_pool_alloc (&ground->pool, model->ground_count, sizeof *ground->velocities);
  for (size_t i = 0; ground->velocities != NULL && i < model->ground_count; i++) {
    const QnGroundMotion *motion = &model->ground[i];
    ground->end = fmax (ground->end, qn_ground_motion_end (motion));
    if (motion->kind != QN_SIGNAL_PULSE)
      ground->velocities[i] = integrate (motion, &ground->pool);
  }
  bool ok = !ground->pool.failed;
  if (!ok)
    qn_ground_clear (ground);
  return ok;
}

void
qn_ground_clear (QnGround *ground)
{
  qn_pool_clear (&ground->pool);
  *ground = (QnGround){ 0 };
}

/* --- Pulses ------------------------------------------------------------------------------ */

static double
pulse_acceleration (const QnPulse *pulse, double time)
{
  double a = pulse->amplitude, s = (time - pulse->start) / pulse->duration;
  double x = QN_PI * (s - 1);

  if (s <= ROUNDING)
    return 0;
  switch (pulse->kind) {
  case QN_PULSE_HALF_SINE:
    return s > 1 ? 0 : a * sin (QN_PI * s);
  case QN_PULSE_SINE:
    return s > 1 ? 0 : a * sin (2 * QN_PI * s);
  case QN_PULSE_RECTANGLE:
    return s > 1 + ROUNDING ? 0 : a;
  case QN_PULSE_RICKER:
    return s > 2 ? 0 : a * (1 - 2 * x * x) * exp (-x * x);
  case QN_PULSE_STEP_IMPULSE:
    return s > 3 + ROUNDING ? 0 : s <= 1 + ROUNDING ? a : -0.5 * a;
  case QN_PULSE_KIND_COUNT:
    break;
  }
  QN_ASSERT (false);
  return 0;
}

/* Integral of the pulse from its start. */
static double
pulse_velocity (const QnPulse *pulse, double time)
{
  double a = pulse->amplitude * pulse->duration;
  double s = fmax ((time - pulse->start) / pulse->duration, 0), x;

  switch (pulse->kind) {
  case QN_PULSE_HALF_SINE:
    return a / QN_PI * (1 - cos (QN_PI * fmin (s, 1)));
  case QN_PULSE_SINE:
    return a / (2 * QN_PI) * (1 - cos (2 * QN_PI * fmin (s, 1)));
  case QN_PULSE_RECTANGLE:
    return a * fmin (s, 1);
  case QN_PULSE_RICKER:
    x = QN_PI * (fmin (s, 2) - 1);
    return a / QN_PI * (x * exp (-x * x) + QN_PI * exp (-QN_PI * QN_PI));
  case QN_PULSE_STEP_IMPULSE:
    return a * (fmin (s, 1) - 0.5 * (fmin (fmax (s, 1), 3) - 1));
  case QN_PULSE_KIND_COUNT:
    break;
  }
  QN_ASSERT (false);
  return 0;
}

/* --- Points ------------------------------------------------------------------------------ */

/* The last point that is not later than `time`. */
static size_t
find_point (const QnGroundMotion *motion, double time)
{
  size_t low = 0, high = motion->point_count - 1;

  while (high - low > 1) {
    size_t middle = low + (high - low) / 2;
    if (motion->points[middle].x <= time)
      low = middle;
    else
      high = middle;
  }
  return low;
}

static double
points_acceleration (const QnGroundMotion *motion, double time)
{
  const QnVec2 *points = motion->points;

  if (time <= points[0].x || time > points[motion->point_count - 1].x)
    return 0;
  size_t i = find_point (motion, time);
  double part = (time - points[i].x) / (points[i + 1].x - points[i].x);
  return points[i].y + part * (points[i + 1].y - points[i].y);
}

static double
points_velocity (const QnGroundMotion *motion, const double *velocity, double time)
{
  const QnVec2 *points = motion->points;
  size_t last = motion->point_count - 1;

  if (time <= points[0].x)
    return 0;
  if (time >= points[last].x)
    return velocity[last];
  size_t i = find_point (motion, time);
  double since = time - points[i].x;
  return velocity[i] + 0.5 * since * (points[i].y + points_acceleration (motion, time));
}

/* --- All together ------------------------------------------------------------------------ */

static double
acceleration (const QnGroundMotion *motion, double time)
{
  return motion->kind == QN_SIGNAL_PULSE ? pulse_acceleration (&motion->pulse, time)
                                         : points_acceleration (motion, time);
}

/* Integral of the acceleration squared: exact for points, by midpoints for pulses. */
static double
integrate_square (const QnGroundMotion *motion, double from, double to)
{
  enum { SAMPLES = 2000 };
  double sum = 0;

  if (motion->kind == QN_SIGNAL_PULSE) {
    double h = (to - from) / SAMPLES;
    for (int i = 0; i < SAMPLES; i++) {
      double a = pulse_acceleration (&motion->pulse, from + (i + 0.5) * h);
      sum += h * a * a;
    }
    return sum;
  }
  for (size_t i = 1; i < motion->point_count; i++) {
    QnVec2 p = motion->points[i - 1], q = motion->points[i];
    double start = fmax (p.x, from), end = fmin (q.x, to);
    double slope = (q.y - p.y) / (q.x - p.x);
    double a = p.y + slope * (start - p.x), b = p.y + slope * (end - p.x);
    if (start < end)
      sum += (end - start) * (a * a + a * b + b * b) / 3;
  }
  return sum;
}

double
qn_ground_motion_share_after (const QnGroundMotion *motion, double time)
{
  double end = qn_ground_motion_end (motion);
  double all = integrate_square (motion, 0, end);
  return time < end && all > 0 ? integrate_square (motion, time, end) / all : 0;
}

QnVec2
qn_ground_acceleration (const QnGround *ground, double time)
{
  QnVec2 sum = { 0, 0 };

  for (size_t i = 0; i < ground->model->ground_count; i++) {
    const QnGroundMotion *motion = &ground->model->ground[i];
    sum = qn_vec2_add_scaled (sum, motion->scale * acceleration (motion, time),
                              motion->direction);
  }
  return sum;
}

QnVec2
qn_ground_mean (const QnGround *ground, double start, double end)
{
  QnVec2 sum = { 0, 0 };

  for (size_t i = 0; i < ground->model->ground_count; i++) {
    const QnGroundMotion *motion = &ground->model->ground[i];
    double change =
      motion->kind == QN_SIGNAL_PULSE
        ? pulse_velocity (&motion->pulse, end) - pulse_velocity (&motion->pulse, start)
        : points_velocity (motion, ground->velocities[i], end)
            - points_velocity (motion, ground->velocities[i], start);
    sum =
      qn_vec2_add_scaled (sum, motion->scale * change / (end - start), motion->direction);
  }
  return sum;
}

QnVec2
qn_ground_change (const QnGround *ground, double start, double end)
{
  return qn_vec2_sub (qn_ground_acceleration (ground, end),
                      qn_ground_acceleration (ground, start));
}
