#include "core/path/path-events.h"

#include "core/base/memory.h"

#include <string.h>

bool
qn_path_events_init (QnPathEvents *events, QnPath *path, double unit)
{
  const QnEquilibrium *eq = &path->equilibrium;
  size_t n = (size_t) eq->assembly.unknown_count;

  QnPool *pool = &path->trace_pool;

  *events =
    (QnPathEvents){ .path = path,
                    .rest = qn_pool_alloc (pool, n, sizeof *events->rest),
                    .highest_u = qn_pool_alloc (pool, n, sizeof *events->highest_u),
                    .least = eq->committed.multiplier + eq->tolerance * unit,
                    .highest = eq->committed.multiplier };
  if (pool->failed)
    return false;
  memcpy (events->rest, eq->committed.u, n * sizeof *events->rest);
  memcpy (events->highest_u, eq->committed.u, n * sizeof *events->highest_u);
  return true;
}

/* How far a body has moved, rotations aside, m; or, where `from` is NULL, how fast it moves. */
static double
shift (const QnAssembly *as, size_t body, const double *from, const double *to)
{
  double d[2] = { 0, 0 };

  for (size_t i = 0; i < 2; i++) {
    int32_t unknown = as->unknown[QN_DOF_COUNT * body + i];
    if (unknown != QN_NONE)
      d[i] = to[unknown] - (from != NULL ? from[unknown] : 0);
  }
  return hypot (d[0], d[1]);
}

static double
largest_shift (const QnPath *path, const double *from, const double *to)
{
  size_t count = qn_model_body_count (path->model);
  double largest = 0;

  for (size_t body = 0; body < count; body++)
    largest = fmax (largest, shift (&path->equilibrium.assembly, body, from, to));
  return largest;
}

/* The blocks that move from one state to another; returns how many. blocks: block_count. */
static size_t
list_movers (const QnPath *path, const double *from, const double *to, QnId *blocks)
{
  double least = QN_TAKES_PART * largest_shift (path, from, to);
  size_t count = 0;

  for (size_t b = 0; b < path->model->block_count; b++) {
    double moved = shift (&path->equilibrium.assembly, b, from, to);
    if (moved > 0 && moved >= least)
      blocks[count++] = (QnId) b;
  }
  return count;
}

static bool
add (QnPathEvents *events, QnEventKind kind, double multiplier, double before,
     double after)
{
  QnPath *path = events->path;
  QnId *blocks = qn_alloc (path->model->block_count, sizeof *blocks);
  QnPathEvent event = { .kind = kind,
                        .stage = path->stage,
                        .multiplier = path->origin + path->scale * multiplier,
                        .displacement_before = before,
                        .displacement_after = after,
                        .energy = fmax (0, events->energy),
                        .blocks = blocks };

  if (blocks == NULL)
    return false;
  event.block_count = list_movers (path, events->highest_u, path->equilibrium.u, blocks);
  return qn_result_add_event (path->result, event);
}

/* Size of the jump from the one displacement to the other. */
static double
jump_size (double before, double after)
{
  return after > 0 ? (after - before) / after : 0;
}

bool
qn_path_events_climbs (const QnPathEvents *events)
{
  const QnEquilibrium *eq = &events->path->equilibrium;

  return eq->multiplier - events->highest > eq->tolerance * fabs (events->highest);
}

bool
qn_path_events_observe (QnPathEvents *events, bool jumped, bool *snap)
{
  const QnEquilibrium *eq = &events->path->equilibrium;
  double before = events->highest_displacement, last = events->displacement;
  double now = largest_shift (events->path, events->rest, eq->u);
  double from = eq->committed.multiplier, to = eq->multiplier;

  *snap = false;
  events->displacement = now;
  events->energy += (events->highest - 0.5 * (from + to))
                    * qn_equilibrium_live_work (eq, eq->committed.u);
  if (!qn_path_events_climbs (events)) {
    events->below = events->below || to < (1 - QN_PATH_PLATEAU) * events->highest;
    return true;
  }
  if ((events->below || jumped) && events->highest > events->least) {
    /* The highest multiplier is reached again somewhere on this step. */
    double part = from < events->highest ? (events->highest - from) / (to - from) : 0;
    double after = jumped ? now : last + part * (now - last);
    double size = jump_size (before, after);
    *snap = size >= QN_JUMP_SNAP;
    if (size >= QN_JUMP_LEAST
        && !add (events, *snap ? QN_EVENT_KIND_SNAP : QN_EVENT_KIND_LOCAL,
                 events->highest, before, after))
      return false;
  }
  events->highest = to;
  events->highest_displacement = now;
  events->energy = 0;
  events->below = false;
  memcpy (events->highest_u, eq->u, (size_t) eq->assembly.unknown_count * sizeof *eq->u);
  return true;
}

bool
qn_path_events_has_snapped (const QnPathEvents *events)
{
  double now = largest_shift (events->path, events->rest, events->path->equilibrium.u);

  return jump_size (events->highest_displacement, now) >= QN_JUMP_SNAP;
}

bool
qn_path_events_collapse (QnPathEvents *events)
{
  return add (events, QN_EVENT_KIND_COLLAPSE, events->highest,
              events->highest_displacement, events->displacement);
}

bool
qn_path_events_buckle (QnPathEvents *events, const double *motion)
{
  events->energy = 0;
  if (!add (events, QN_EVENT_KIND_BUCKLING, events->highest, events->highest_displacement,
            events->highest_displacement))
    return false;
  qn_path_events_take_mechanism (events, motion);
  return true;
}

void
qn_path_events_take_mechanism (QnPathEvents *events, const double *velocity)
{
  QnResult *result = events->path->result;
  QnPathEvent *last = &result->events[result->event_count - 1];

  last->block_count = list_movers (events->path, NULL, velocity, last->blocks);
}
