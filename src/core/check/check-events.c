/* Events between the steps of a path.
 *
 * An event begins at the highest multiplier so far, which is that of a step, and ends where the path
 * climbs above it again. Where motion is prescribed every state in between is a step, and the event is
 * recomputed from them. Under load control these states are not kept: then its displacement at the end
 * and its energy are compared with its kind and its sign alone, and the blocks of a collapse are those of
 * the mechanism. */
#include "core/check/check-parts.h"

#include <math.h>

/* Multipliers and displacements that stand in a result twice. */
#define SAME 1e-9

/* Whether a block takes part is not told by rounding. */
#define NEARLY 1e-6

/* The steps of a stage: the one that it begins with, and the last. */
typedef struct {
  int32_t stage;
  size_t base, last;
  double origin; /* multiplier where it begins */
  double sense;  /* -1: it falls */
  uint32_t sets; /* of loads, that it drives */
  bool by_load;  /* the multiplier is prescribed */
} Stretch;

static bool
same (double a, double b)
{
  return qn_check_agrees (a, b, SAME * (1e-6 + fabs (b)));
}

static double
multiplier_at (const QnCheck *check, const Stretch *stretch, size_t step)
{
  return step == stretch->base ? stretch->origin : check->result->steps[step].multiplier;
}

static Stretch
find_stretch (const QnCheck *check, int32_t number)
{
  const QnResult *r = check->result;
  const QnModel *model = check->model;
  Stretch stretch = { .stage = number, .last = r->step_count - 1, .sense = 1, .sets = 1 };
  double factors[QN_MAX_LOAD_SETS] = { 0 };
  QnProcedure procedure = model->analysis.procedure;

  if (number > 0 && (size_t) number <= model->stage_count) {
    const QnStage *stage = &model->stages[number - 1];
    int set = QN_MAX_LOAD_SETS - 1;
    while (number < r->stage && stretch.last > 0
           && r->steps[stretch.last].stage != number)
      stretch.last--;
    stretch.sets = stage->sets;
    stretch.base = stretch.last;
    while (stretch.base > 0 && r->steps[stretch.base].stage == number)
      stretch.base--;
    qn_result_load_factors (model, r, stretch.base, factors);
    while (set > 0 && (stage->sets >> set & 1) == 0)
      set--;
    stretch.origin = factors[set];
    procedure = stage->procedure;
  }
  stretch.by_load = procedure == QN_PROCEDURE_LOAD;
  if (stretch.last > stretch.base)
    stretch.sense = qn_check_sense (check, stretch.base + 1, stretch.origin);
  return stretch;
}

/* How far a body moves from one step to another, rotations and what rides on blocks aside, m. */
static double
shift (const QnCheck *check, size_t body, size_t from, size_t to)
{
  const int32_t *unknown = check->assembly.unknown + QN_DOF_COUNT * body;
  size_t row = QN_DOF_COUNT * body;
  const double *a = qn_result_step_displacements (check->result, from) + row;
  const double *b = qn_result_step_displacements (check->result, to) + row;

  return hypot (unknown[0] != QN_NONE ? b[0] - a[0] : 0,
                unknown[1] != QN_NONE ? b[1] - a[1] : 0);
}

static double
largest_shift (const QnCheck *check, size_t from, size_t to)
{
  double largest = 0;

  for (size_t body = 0; body < qn_result_body_count (check->result); body++)
    largest = fmax (largest, shift (check, body, from, to));
  return largest;
}

/* The step that an event begins at, which has its multiplier, the highest so far; or -1. */
static ptrdiff_t
find_start (const QnCheck *check, const Stretch *stretch, const QnPathEvent *event)
{
  double highest = stretch->origin;

  for (size_t i = stretch->base; i <= stretch->last; i++) {
    double at = multiplier_at (check, stretch, i);
    if (stretch->sense * at < stretch->sense * highest && !same (at, highest))
      continue;
    highest = at;
    if (same (event->multiplier, at)
        && same (event->displacement_before, largest_shift (check, stretch->base, i)))
      return (ptrdiff_t) i;
  }
  return -1;
}

/* An equilibrium is known no better than what it may lack: a multiplier that is higher by less is the same
 * one, as where whole courses slide. */
static double
least_climb (const QnCheck *check, const Stretch *stretch, double from)
{
  return check->model->analysis.residual_tolerance * fabs (from - stretch->origin);
}

/* The first step above the one that an event begins at, or the last one. */
static size_t
find_end (const QnCheck *check, const Stretch *stretch, size_t start)
{
  double from = multiplier_at (check, stretch, start);
  double least = least_climb (check, stretch, from);

  for (size_t i = start + 1; i < stretch->last; i++)
    if (stretch->sense * (check->result->steps[i].multiplier - from) > least)
      return i;
  return stretch->last;
}

static bool
climbs_after (const QnCheck *check, const Stretch *stretch, size_t start)
{
  double highest = multiplier_at (check, stretch, start);
  double least = least_climb (check, stretch, highest);

  for (size_t i = start + 1; i <= stretch->last; i++) {
    double at = check->result->steps[i].multiplier;
    if (stretch->sense * (at - highest) > least && !same (at, highest))
      return true;
  }
  return false;
}

/* How fast a body moves in the mechanism, likewise. */
static double
speed (const QnCheck *check, size_t body)
{
  const int32_t *unknown = check->assembly.unknown + QN_DOF_COUNT * body;
  const double *v = check->result->mechanism + QN_DOF_COUNT * body;

  return hypot (unknown[0] != QN_NONE ? v[0] : 0, unknown[1] != QN_NONE ? v[1] : 0);
}

/* Whether the blocks of an event are those that move between two steps; of a collapse under load control
 * those of the mechanism. */
static bool
has_blocks (const QnCheck *check, const QnPathEvent *event, bool by_mechanism,
            size_t start, size_t end)
{
  double fastest = 0;
  size_t next = 0;

  for (size_t b = 0; by_mechanism && b < qn_result_body_count (check->result); b++)
    fastest = fmax (fastest, speed (check, b));
  double least =
    QN_TAKES_PART * (by_mechanism ? fastest : largest_shift (check, start, end));
  for (size_t b = 0; b < check->model->block_count; b++) {
    double moved = by_mechanism ? speed (check, b) : shift (check, b, start, end);
    bool told = next < event->block_count && event->blocks[next] == (QnId) b;
    next += told;
    if (fabs (moved - least) > NEARLY * least && told != (moved > least))
      return false;
  }
  return next == event->block_count;
}

static bool
suits_kind (const QnPathEvent *event)
{
  double after = event->displacement_after;
  double size = after > 0 ? (after - event->displacement_before) / after : 0;

  switch (event->kind) {
  case QN_EVENT_KIND_LOCAL:
    return size >= QN_JUMP_LEAST * (1 - NEARLY) && size < QN_JUMP_SNAP * (1 + NEARLY);
  case QN_EVENT_KIND_SNAP:
    return size >= QN_JUMP_SNAP * (1 - NEARLY);
  case QN_EVENT_KIND_BUCKLING:
    return same (after, event->displacement_before) && event->energy == 0;
  case QN_EVENT_KIND_COLLAPSE:
  case QN_EVENT_KIND_COUNT:
    break;
  }
  return true;
}

/* Energy that the live load sets free from one step to another. */
static double
find_energy (QnCheck *check, const Stretch *stretch, size_t start, size_t end)
{
  QnAssembly *as = &check->assembly;
  double none[QN_MAX_LOAD_SETS] = { 0 }, live[QN_MAX_LOAD_SETS] = { 0 };
  const QnResult *r = check->result;
  double held = multiplier_at (check, stretch, start), energy = 0;

  for (int set = 0; set < QN_MAX_LOAD_SETS; set++)
    live[set] = stretch->sets >> set & 1;
  qn_assembly_set_loads (as, none, live);
  qn_check_gather (as, qn_result_step_displacements (r, start), check->velocity);
  for (size_t i = start + 1; i <= end; i++) {
    double work = 0;
    double mean = 0.5 * (multiplier_at (check, stretch, i - 1) + r->steps[i].multiplier);
    qn_check_gather (as, qn_result_step_displacements (r, i), check->residual);
    qn_assembly_update_kinematics (as, check->residual);
    for (int32_t k = 0; k < as->unknown_count; k++) {
      work += as->live[k] * (check->residual[k] - check->velocity[k]);
      check->velocity[k] = check->residual[k];
    }
    energy += (held - mean) * work;
  }
  return fmax (0, energy);
}

/* Where motion is prescribed: the displacement at which the multiplier is that of the start again, and
 * the energy. What the outcome has written over the last step is not known. */
static bool
is_recomputed (QnCheck *check, const Stretch *stretch, const QnPathEvent *event,
               size_t start, size_t end)
{
  const QnResult *r = check->result;
  double held = stretch->sense * multiplier_at (check, stretch, start);
  double from = stretch->sense * multiplier_at (check, stretch, end - 1);
  double to = stretch->sense * r->steps[end].multiplier;
  double last = largest_shift (check, stretch->base, end - 1);
  double now = largest_shift (check, stretch->base, end);
  double part = from < held && to > from ? (held - from) / (to - from) : 0;
  double after = last + part * (now - last);
  bool jumped =
    event->kind == QN_EVENT_KIND_COLLAPSE || r->steps[end].event != QN_EVENT_NONE;
  double energy = find_energy (check, stretch, start, end);

  if (!same (event->displacement_after, jumped ? now : after)
      && !(end == stretch->last && same (event->displacement_after, after)))
    return false;
  return qn_check_agrees (event->energy, energy,
                          NEARLY * energy + SAME * check->scale * now);
}

/* Blocks ascend, and none of them is held altogether. */
static bool
has_movers (const QnCheck *check, const QnPathEvent *event)
{
  bool is_one = true;

  for (size_t i = 0; is_one && i < event->block_count; i++) {
    const int32_t *unknown = check->assembly.unknown + QN_DOF_COUNT * event->blocks[i];
    is_one = (i == 0 || event->blocks[i] > event->blocks[i - 1])
             && (unknown[0] != QN_NONE || unknown[1] != QN_NONE);
  }
  return is_one;
}

/* Under load control no state below the highest is a step. Where the path was not followed beyond it,
 * nothing has moved. */
static bool
suits_end (const QnPathEvent *event)
{
  double before = event->displacement_before, after = event->displacement_after;

  return !same (after, before) || event->energy == 0;
}

/* Returns whether an event is one of the steps; *start is where it begins. */
static bool
is_true (QnCheck *check, const Stretch *stretch, const QnPathEvent *event, size_t *start)
{
  const QnResult *r = check->result;
  ptrdiff_t found = find_start (check, stretch, event);
  bool collapses = event->kind == QN_EVENT_KIND_COLLAPSE;

  *start = (size_t) found;
  if (found < 0 || event->stage != stretch->stage || !suits_kind (event)
      || !(event->energy >= 0) || !(event->displacement_after >= 0)
      || !has_movers (check, event))
    return false;
  if (event->kind == QN_EVENT_KIND_BUCKLING)
    return true;
  if (collapses && (!r->has_collapse_multiplier || climbs_after (check, stretch, *start)))
    return false;
  if (stretch->by_load && collapses)
    return suits_end (event)
           && (r->mechanism == NULL || has_blocks (check, event, true, 0, 0));
  if (*start == stretch->last)
    return collapses;
  size_t end = collapses ? stretch->last : find_end (check, stretch, *start);
  return has_blocks (check, event, false, *start, end)
         && (stretch->by_load || is_recomputed (check, stretch, event, *start, end));
}

/* Whether an event of this kind is told that ends at a step under load control. */
static bool
is_told (QnCheck *check, const Stretch *stretch, size_t step)
{
  const QnResult *r = check->result;

  for (size_t i = 0; i < r->event_count; i++)
    if (r->events[i].kind == QN_EVENT_KIND_SNAP
        && same (r->events[i].multiplier, multiplier_at (check, stretch, step - 1)))
      return true;
  return false;
}

/* The first snap is the first limit point, unless the analysis stops where it loses its stability. */
static void
check_first_snap (QnCheck *check)
{
  const QnResult *r = check->result;
  double first = NAN;

  for (size_t i = r->event_count; i-- > 0;)
    if (r->events[i].kind == QN_EVENT_KIND_SNAP)
      first = r->events[i].multiplier;
  if (r->outcome != QN_OUTCOME_SNAP && r->outcome != QN_OUTCOME_NOT_CONVERGED
      && (r->has_first_limit_multiplier != !isnan (first)
          || (!isnan (first) && !same (r->first_limit_multiplier, first))))
    qn_check_tell_model (check, QN_CLAIM_FIRST_LIMIT, QN_NONE,
                         r->has_first_limit_multiplier ? r->first_limit_multiplier : NAN,
                         first);
}

void
qn_check_events (QnCheck *check)
{
  const QnResult *r = check->result;
  int collapses = 0;

  if (r->events_unknown || r->stability != QN_STABILITY_UNKNOWN || r->limit.given
      || r->history.width > 0 || r->step_count == 0)
    return;
  Stretch stretch = find_stretch (check, r->stage);
  for (size_t i = 0; i < r->event_count; i++) {
    const QnPathEvent *event = &r->events[i];
    size_t start;
    bool earlier = event->stage < r->stage && event->kind == QN_EVENT_KIND_BUCKLING;
    Stretch own = earlier ? find_stretch (check, event->stage) : stretch;
    collapses += event->kind == QN_EVENT_KIND_COLLAPSE;
    bool in_order = (i == 0 || event->stage > r->events[i - 1].stage
                     || stretch.sense * event->multiplier
                          >= stretch.sense * r->events[i - 1].multiplier)
                    && (event->kind != QN_EVENT_KIND_COLLAPSE || i + 1 == r->event_count);
    if (!in_order || !is_true (check, &own, event, &start)) {
      qn_check_tell (check, QN_CLAIM_EVENTS, QN_NONE, QN_ENTITY_ANALYSIS, (QnId) i,
                     event->multiplier, NAN);
      return;
    }
    if (stretch.by_load && event->kind == QN_EVENT_KIND_SNAP && start + 1 < stretch.last
        && r->steps[start + 1].event != QN_EVENT_SNAP)
      qn_check_tell_model (check, QN_CLAIM_EVENTS, (QnId) (start + 1), NAN, NAN);
  }
  if (collapses != r->has_collapse_multiplier)
    qn_check_tell_model (check, QN_CLAIM_EVENTS, (QnId) (stretch.last),
                         r->has_collapse_multiplier ? r->collapse_multiplier : NAN, NAN);
  bool stops = r->outcome == QN_OUTCOME_SNAP;
  for (size_t i = stretch.base + 1; stretch.by_load && i + stops <= stretch.last; i++)
    if (r->steps[i].event == QN_EVENT_SNAP && !is_told (check, &stretch, i))
      qn_check_tell_model (check, QN_CLAIM_EVENTS, (QnId) (i), NAN, NAN);
  check_first_snap (check);
}
