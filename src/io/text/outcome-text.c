#include "io/text/outcome-text.h"
#include "core/contact/pair-abscissae.h"
#include "core/path/path.h"
#include "io/text/fault-text.h"
#include "io/text/text-format.h"

#include <glib/gi18n-lib.h>
#include <math.h>

/* Most blocks that a sentence names before it says "and others". */
#define NAMES_IN_A_SENTENCE 5

/* A displacement has reached its target within this part of it. */
#define AT_TARGET 1e-6

/* What the procedure was asked to do: the stage that it ended in, or the analysis as one. */
static QnStage
task_of (const QnModel *model, const QnResult *result)
{
  const QnAnalysisSettings *a = &model->analysis;
  if (result->stage >= 1 && (size_t) result->stage <= model->stage_count)
    return model->stages[result->stage - 1];
  return (QnStage){ .procedure = a->procedure,
                    .sets = 1,
                    .has_target = isfinite (a->max_multiplier) != 0,
                    .control = a->control };
}

const char *
qn_outcome_text (QnOutcome outcome, gboolean in_time)
{
  static const char *const texts[QN_OUTCOME_COUNT] = {
    [QN_OUTCOME_COLLAPSE] = N_ ("Collapse"),
    [QN_OUTCOME_TARGET_REACHED] = N_ ("Target reached"),
    [QN_OUTCOME_SNAP] = N_ ("Stopped at a limit point"),
    [QN_OUTCOME_UNBOUNDED] = N_ ("No limit found"),
    [QN_OUTCOME_DEAD_LOAD_UNSTABLE] = N_ ("Dead load does not stand"),
    [QN_OUTCOME_CANCELLED] = N_ ("Cancelled"),
    [QN_OUTCOME_NOT_CONVERGED] = N_ ("Not converged"),
    [QN_OUTCOME_REST] = N_ ("At rest"),
  };
  if (in_time && outcome == QN_OUTCOME_COLLAPSE)
    return _ ("Overturns");
  if (in_time && (outcome == QN_OUTCOME_TARGET_REACHED || outcome == QN_OUTCOME_REST))
    return _ ("Stands");
  return _ (texts[outcome]);
}

char *
qn_stage_dup_name (const QnModel *model, int32_t stage)
{
  static const char *const ways[QN_CYCLE_LEGS] = { "0", "+", "\u2212" };
  const QnStage *s = &model->stages[stage - 1];
  if (s->leg > 0)
    return qn_text_printf ("%s%s%d%s%s", s->name != NULL ? s->name : "",
                           s->name != NULL ? " " : "", qn_stage_cycle (s),
                           s->leg % QN_CYCLE_LEGS == 0 ? " " : "",
                           ways[s->leg % QN_CYCLE_LEGS]);
  return s->name != NULL ? g_strdup (s->name) : qn_text_printf ("%d", stage);
}

char *
qn_outcome_dup_stages (const QnModel *model, const QnResult *result)
{
  g_autoptr (GString) text = g_string_new (NULL);
  for (int32_t i = 1; i <= result->stage && (size_t) i <= model->stage_count; i++) {
    QnStageFigures f;
    if (!qn_result_stage_figures (model, result, i, i, &f))
      continue;
    g_autofree char *name = qn_stage_dup_name (model, i);
    g_autofree char *line = qn_text_printf (
      _ ("stage %d, “%s”: ends at load multiplier %.5g; lowest %.5g, highest %.5g; "
         "work %.5g J"),
      i, name, f.multiplier, f.lowest, f.highest, f.work);
    g_string_append_printf (text, "%s%s", text->len > 0 ? "\n" : "", line);
    int32_t start = qn_result_cycle_start (model, result, i);
    if (start > 0 && qn_result_stage_figures (model, result, start, i, &f)) {
      g_autofree char *cycle = qn_text_printf (
        _ ("cycle %d: load multiplier from %.5g to %.5g; energy %.5g J"),
        qn_stage_cycle (&model->stages[i - 1]), f.lowest, f.highest, f.work);
      g_string_append_printf (text, "\n%s", cycle);
    }
  }
  return text->len > 0 ? g_strdup (text->str) : NULL;
}

/* Whether loads of a set pull at a block or node that is not fixed altogether, or along beams. */
static gboolean
set_moves_anything (const QnModel *model, size_t set)
{
  const size_t count = qn_model_body_count (model) * QN_DOF_COUNT;
  g_autofree double *forces = g_new (double, count + 1);
  g_autofree QnVec2 *along = g_new (QnVec2, model->element_count + 1);
  double factors[QN_MAX_LOAD_SETS] = { 0 };
  gboolean any = FALSE;
  factors[set] = 1;
  qn_model_set_forces (model, factors, forces);
  qn_model_element_loads (model, factors, along);
  for (size_t i = 0; i < count; i++) {
    const size_t body = i / QN_DOF_COUNT;
    any |= forces[i] != 0
           && !qn_support_is_full (body < model->block_count
                                     ? model->blocks[body].support
                                     : model->nodes[body - model->block_count].support);
  }
  for (size_t i = 0; i < model->element_count; i++)
    any |= along[i].x != 0 || along[i].y != 0;
  return any;
}

/* To settle a support, be it by 0, is a load. */
gboolean
qn_model_lacks_live_load (const QnModel *model)
{
  gboolean any = FALSE;
  for (size_t i = 0; i < model->live_load_count; i++)
    any |= model->live_loads[i].kind == QN_LOAD_SETTLEMENT;
  for (size_t set = 0; set <= model->load_set_count && !any; set++)
    any = set_moves_anything (model, set);
  return !any;
}

static char *
explain_unstable (const QnModel *model, const QnResult *result)
{
  g_autoptr (GString) names = g_string_new (NULL);
  for (gsize i = 0; i < result->unstable_count && i < NAMES_IN_A_SENTENCE; i++) {
    QnId block = result->unstable_blocks[i];
    qn_text_append (names, "%s“%s”", i > 0 ? ", " : "",
                    (gsize) block < model->block_count ? model->blocks[block].name : "?");
  }
  if (result->unstable_count > NAMES_IN_A_SENTENCE) {
    gsize more = result->unstable_count - NAMES_IN_A_SENTENCE;
    qn_text_append (names, ngettext (" and %zu other", " and %zu others", (gulong) more),
                    more);
  }
  return qn_text_printf (
    _ ("No stable equilibrium was found under the dead load "
       "alone. What moves: %s. Support these blocks, close the gaps next to "
       "them, or give their joints more friction."),
    names->str);
}

static const QnStep *
last_step (const QnResult *result)
{
  return result->step_count > 0 ? &result->steps[result->step_count - 1] : NULL;
}

/* --- Collapse --------------------------------------------------------------------------- */

static char *
collapse_sentence (const QnResult *result)
{
  if (!result->has_collapse_multiplier)
    return g_strdup (_ ("The structure collapses."));
  double collapse = result->collapse_multiplier;
  double before = copysign (1, collapse) * result->first_limit_multiplier;
  if (qn_result_has_felt_limit (result) && before < (1 - 1e-3) * fabs (collapse))
    return qn_text_printf (_ ("Collapse at a load multiplier of %.4g. Before, at %.4g, "
                              "the path jumps to another equilibrium."),
                           result->collapse_multiplier, result->first_limit_multiplier);
  return qn_text_printf (_ ("Collapse at a load multiplier of %.4g."),
                         result->collapse_multiplier);
}

/* --- Answer ----------------------------------------------------------------------------- */

static const char *
found_by_words (const QnModel *model, QnProcedure procedure)
{
  static const char *const texts[QN_PROCEDURE_COUNT] = {
    [QN_PROCEDURE_LOAD] = N_ ("found by load control"),
    [QN_PROCEDURE_DISPLACEMENT] = N_ ("found by displacement control"),
    [QN_PROCEDURE_WORK] = N_ ("found by work control"),
    [QN_PROCEDURE_ARC_LENGTH] = N_ ("found by arc-length control"),
    [QN_PROCEDURE_LIMIT] = N_ ("found by limit analysis of rigid blocks"),
  };
  if (procedure == QN_PROCEDURE_WORK && model->analysis.procedure == QN_PROCEDURE_LOAD
      && model->stage_count == 0)
    return _ ("found by work control, which takes over where steps of the load converge "
              "slowly");
  return texts[procedure] != NULL ? _ (texts[procedure]) : "";
}

/* That the bound takes the bonds of joints as ductile, and what it is without them; NULL where there are none. */
static char *
dup_broken_bond (const QnModel *model, const QnResult *result)
{
  if (!result->has_broken_bound)
    return NULL;
  return qn_text_printf (
    qn_model_is_non_associative (model)
      ? _ ("The bound takes the bonds of joints as ductile, which they are not; with all "
           "of them broken it is %.4f, and joints that slide with less dilatancy than "
           "friction may carry less than that.")
      : _ ("The bound takes the bonds of joints as ductile, which they are not; with all "
           "of them broken it is %.4f, and only that is safe."),
    result->broken_bound);
}

/* That few pairs stand for what is left of a joint that has opened; NULL where none has, or there are many
 * pairs. See docs/method/contact-pairs.md. */
static char *
dup_coarse_pairs (const QnModel *model, const QnResult *result)
{
  int32_t least = 0;
  bool opens = false;
  for (gsize i = 0; i < model->law_count; i++) {
    QnPairRule rule = qn_pair_rule_by_law (&model->contact.pairs, &model->laws[i]);
    if ((model->analysis.geometry == QN_GEOMETRY_NONLINEAR || model->laws[i].tension > 0)
        && model->laws[i].basis != QN_BASIS_CONTACT
        && rule.placement == QN_PLACEMENT_LOBATTO && rule.count < QN_MOST_LOBATTO_PAIRS
        && (least == 0 || rule.count < least))
      least = rule.count;
  }
  for (gsize i = 0; result->pairs != NULL && i < result->pair_count; i++)
    opens |= result->pairs[i].state == QN_PAIR_OPEN;
  return least > 0 && opens
           ? qn_text_printf (_ ("Joints that open far have %d pairs, whose multipliers "
                                "have been found up to a tenth too high, with brittle "
                                "bonds up to a quarter: compare with %d pairs."),
                             least, QN_MOST_LOBATTO_PAIRS)
           : NULL;
}

char *
qn_outcome_dup_interval (const QnModel *model, const QnResult *result)
{
  QnProcedure found_by = QN_PROCEDURE_LOAD;
  double least, bound, greatest = -HUGE_VAL;
  qn_result_collapse_interval (result, &least, &found_by, &bound);
  if (isnan (least))
    return NULL;
  for (gint32 i = 0; i < result->solution_count; i++)
    greatest = MAX (greatest, result->solutions[i].multiplier);
  /* Of a path, one that it passes. */
  const gboolean passes = found_by == QN_PROCEDURE_LIMIT && !result->limit.given;
  g_autofree char *passed =
    passes
      ? qn_text_printf (_ ("Limit analysis finds forces and a mechanism at %.4f, too: "
                           "the path passes them, another history of loading may "
                           "not."),
                        least)
      : NULL;
  if (passes) {
    least = result->solutions[0].multiplier;
    found_by = result->solutions[0].found_by;
  }
  const char *found = found_by_words (model, found_by);
  const QnStep *last = last_step (result);
  const gboolean moves_on =
    result->stop == QN_STOP_PLATEAU && last != NULL
    && last->multiplier < (1 - QN_SETTLED) * result->collapse_multiplier;

  g_autofree char *from =
    moves_on ? qn_text_printf (
      _ ("The multiplier was %s: a peak, beyond which the structure moves on at %.4f;"),
      found, last->multiplier)
    : passes || result->solution_count == 1
      ? qn_text_printf (_ ("The multiplier was %s;"), found)
      : qn_text_printf (
        _ ("The multiplier was %s, the least of %d solutions up to %.4f;"), found,
        result->solution_count, greatest);
  g_autofree char *to =
    isnan (bound) ? g_strdup (_ ("what bounds it from above is not known."))
    : model->analysis.geometry == QN_GEOMETRY_NONLINEAR
      ? qn_text_printf (_ ("no equilibrium of the undeformed structure above %.4f, the "
                           "associative bound; displacements may lower it."),
                        bound)
      : qn_text_printf (_ ("no equilibrium above %.4f, the associative bound."), bound);
  g_autofree char *safe = dup_broken_bond (model, result);
  g_autofree char *coarse = dup_coarse_pairs (model, result);
  GString *text = g_string_new (from);
  const char *const more[] = { to, passed, safe, coarse };
  for (gsize i = 0; i < G_N_ELEMENTS (more); i++)
    if (more[i] != NULL)
      g_string_append_printf (text, " %s", more[i]);
  return g_string_free (text, FALSE);
}

/* Where the path has left a branch that lost its stability; NULL where it has not. */
static char *
explain_buckling (const QnResult *result)
{
  const QnPathEvent *event = qn_result_find_buckling (result);
  if (event == NULL)
    return NULL;
  if (event->stage < result->stage)
    return qn_text_printf (
      _ ("Stability was lost in stage %d, at a load multiplier of %.5g: the structure "
         "buckled, and all that follows is the path of the buckled structure."),
      event->stage, event->multiplier);
  return qn_text_printf (_ ("Stability is lost at a load multiplier of %.5g: the "
                            "structure buckles, and what follows is the path of the "
                            "buckled structure."),
                         event->multiplier);
}

/* Where linear geometry ends, and what to do; NULL where it holds. */
static char *
explain_linearity (const QnResult *result)
{
  if (result->linearity != QN_LINEARITY_BEYOND)
    return NULL;
  if (result->history.width > 0)
    return g_strdup (
      _ ("Blocks move by more than a tenth of their least width, so that linear geometry "
         "may not hold: solve in large displacements (nonlinear geometry)."));
  return qn_text_printf (
    _ ("At a load multiplier of %.4g a block has moved by a tenth of the least width of "
       "the blocks; linear geometry may not hold beyond: solve in large displacements "
       "(nonlinear geometry)."),
    result->beyond_linear_multiplier);
}

/* --- Target reached --------------------------------------------------------------------- */

static gboolean
is_controlled_displacement_reached (const QnModel *model, const QnStage *task,
                                    const QnResult *result)
{
  size_t body = qn_model_controlled_body (model, &task->control);
  if (result->step_count == 0 || body >= qn_result_body_count (result))
    return FALSE;
  double u = qn_result_step_displacements (
    result, result->step_count - 1)[QN_DOF_COUNT * body + (size_t) task->control.dof];
  double size = fabs (task->control.target);
  return task->procedure != QN_PROCEDURE_LOAD
         && fabs (u - task->control.target) <= AT_TARGET * (size > 0 ? size : 1);
}

/* Which displacement it was and how far it went. */
static char *
explain_controlled (const QnModel *model, const QnStage *task, double reached)
{
  const QnControl *control = &task->control;
  const gboolean node = control->node != QN_NONE;
  return qn_text_printf (
    node ? _ ("%s of node “%s” has reached its target of %.4g %s, at a load multiplier "
              "of %.4g.")
         : _ ("%s of block “%s” has reached its target of %.4g %s, at a load multiplier "
              "of %.4g."),
    qn_dof_names[control->dof],
    node ? model->nodes[control->node].name : model->blocks[control->block].name,
    control->target, control->dof == QN_DOF_RZ ? "rad" : "m", reached);
}

/* --- Ends ----------------------------------------------------------------------------- */

/* Each claim that the check has refused, and what stands all the same. */
static char *
explain_refused (const QnModel *model, const QnResult *result)
{
  g_autoptr (GString) text = g_string_new (
    _ ("The check of this result refused a part of it, so no conclusion is drawn."));
  for (gint32 i = 0; i < result->refused_count; i++) {
    g_autofree char *fault = qn_fault_dup_text (model, NULL, &result->refused[i]);
    qn_text_append (text, "%s%s", i == 0 ? " " : "; ", fault);
  }
  if (result->refused_count > 0)
    g_string_append (text,
                     _ (". The steps before the first of these are proved and kept."));
  if (result->has_unproved_multiplier)
    qn_text_append (text, _ (" Collapse at a load multiplier of %.4g: not proved."),
                    result->unproved_multiplier);
  return g_string_free (g_steal_pointer (&text), FALSE);
}

/* What may be known of an end. */
typedef enum {
  ANYHOW,
  IN_TIME,
  BY_LOAD,
  BY_LIMIT,
  ASSOCIATIVE,
  UNCERTAIN, /* the mechanism is */
  FELL,
  NO_STEPS,
  SPENT, /* nothing of the load is left */
  FAR,   /* followed until it has moved by its own size */
  NO_LIVE_LOAD,
  HAS_END,
  SETTLED, /* supports move, and nothing else grows */
  ALL_FACTORIZATIONS,
  ALL_TIME,
  ALL_STEPS,
  FACT_COUNT
} Fact;

/* The first one of an outcome whose two facts hold is told. A number in it is the multiplier or, in time, the time. */
static const struct {
  QnOutcome outcome;
  Fact fact, other;
  const char *text;
} sentences[] = {
  { QN_OUTCOME_COLLAPSE, IN_TIME, ANYHOW,
    N_ ("Overturned at %.4g s: a block has turned by a right angle or has fallen out "
        "of its contacts.") },
  { QN_OUTCOME_TARGET_REACHED, IN_TIME, ANYHOW,
    N_ ("Followed to the end of the duration, %.4g s.") },
  { QN_OUTCOME_REST, IN_TIME, ANYHOW,
    N_ ("At rest at %.4g s: the ground has stopped and nothing moves any more.") },
  { QN_OUTCOME_CANCELLED, IN_TIME, ANYHOW,
    N_ ("Cancelled at %.4g s; what was followed by then is kept.") },
  { QN_OUTCOME_NOT_CONVERGED, IN_TIME, ALL_FACTORIZATIONS,
    N_ ("Stopped at %.4g s, after as many factorisations as max_factorizations "
        "allows; what had converged is kept.") },
  { QN_OUTCOME_NOT_CONVERGED, IN_TIME, ALL_TIME,
    N_ ("Stopped at %.4g s, after the time that max_seconds allows; what had "
        "converged is kept.") },
  { QN_OUTCOME_NOT_CONVERGED, IN_TIME, ANYHOW,
    N_ ("At %.4g s no step converged, however short. Try another spectral radius, "
        "some damping, or a coarser residual tolerance.") },
  { QN_OUTCOME_COLLAPSE, BY_LOAD, UNCERTAIN,
    N_ ("No equilibrium was found above the collapse multiplier. How the structure "
        "moves further was not determined: the mechanism shown is its last motion.") },
  { QN_OUTCOME_COLLAPSE, BY_LOAD, FELL,
    N_ ("Under a load that is held a little above, the structure falls. There are "
        "equilibria at larger multipliers, to which a load that grows slowly does "
        "not lead.") },
  { QN_OUTCOME_COLLAPSE, BY_LOAD, ANYHOW,
    N_ ("Above the collapse multiplier the structure moves on along its mechanism "
        "and does not come to rest.") },
  { QN_OUTCOME_COLLAPSE, BY_LIMIT, ASSOCIATIVE,
    N_ ("No forces that the joints can carry balance more, and a mechanism needs no "
        "more.") },
  { QN_OUTCOME_COLLAPSE, BY_LIMIT, ANYHOW,
    N_ ("It is the lowest multiplier found at which a mechanism with the friction of "
        "the joints can move.") },
  { QN_OUTCOME_COLLAPSE, FELL, ANYHOW,
    N_ ("Beyond the last equilibrium blocks fall out of their contacts, although the "
        "controlled motion is held.") },
  { QN_OUTCOME_COLLAPSE, SPENT, ANYHOW,
    N_ ("The path was followed beyond its peak until nothing of the load was left.") },
  { QN_OUTCOME_COLLAPSE, ANYHOW, ANYHOW,
    N_ ("The structure keeps moving under a constant load.") },
  { QN_OUTCOME_TARGET_REACHED, NO_LIVE_LOAD, ANYHOW,
    N_ ("No live load acts on any free block, so there is no path to follow: what "
        "was found is the equilibrium under the dead load.") },
  { QN_OUTCOME_TARGET_REACHED, SETTLED, ANYHOW,
    N_ ("The supports have settled to their targets without collapse.") },
  { QN_OUTCOME_TARGET_REACHED, HAS_END, ANYHOW,
    N_ ("The load multiplier has reached its end value of %.4g without collapse.") },
  { QN_OUTCOME_TARGET_REACHED, ANYHOW, ANYHOW,
    N_ ("The target was reached at a load multiplier of %.4g without collapse.") },
  { QN_OUTCOME_SNAP, ANYHOW, ANYHOW,
    N_ ("Stopped at the first limit point, load multiplier %.4g.") },
  { QN_OUTCOME_UNBOUNDED, BY_LIMIT, ANYHOW,
    N_ ("By the associative theorem, with joints that dilate as much as they slide, "
        "rigid blocks carry any multiple of the live load. Check its direction, or "
        "limit the strength of the joints.") },
  { QN_OUTCOME_UNBOUNDED, FAR, ANYHOW,
    N_ ("The structure carries every multiple of the live load: joints of unlimited "
        "strength connect it to fixed blocks. It was followed to a load multiplier "
        "of %.4g, where it has moved by its own size. Limit the strength of the "
        "joints.") },
  { QN_OUTCOME_UNBOUNDED, ANYHOW, ANYHOW,
    N_ ("No collapse up to a load multiplier of %.4g, where the path ends. Check the "
        "direction of the live load, or limit the strength of the joints.") },
  { QN_OUTCOME_CANCELLED, ANYHOW, ANYHOW,
    N_ ("Cancelled at a load multiplier of %.4g; what had converged is kept.") },
  { QN_OUTCOME_NOT_CONVERGED, ALL_FACTORIZATIONS, ANYHOW,
    N_ ("Stopped at a load multiplier of %.4g, after as many factorisations as "
        "max_factorizations allows; what had converged is kept.") },
  { QN_OUTCOME_NOT_CONVERGED, ALL_TIME, ANYHOW,
    N_ ("Stopped at a load multiplier of %.4g, after the time that max_seconds "
        "allows; what had converged is kept.") },
  { QN_OUTCOME_NOT_CONVERGED, BY_LIMIT, ANYHOW,
    N_ ("The optimisation of limit analysis did not converge.") },
  { QN_OUTCOME_NOT_CONVERGED, NO_STEPS, ANYHOW,
    N_ ("The iteration did not converge under the dead load: the structure neither "
        "comes to rest nor clearly falls. Try a coarser residual tolerance.") },
  { QN_OUTCOME_NOT_CONVERGED, BY_LOAD, ANYHOW,
    N_ ("Beyond a load multiplier of %.4g neither an equilibrium nor a mechanism was "
        "found. Try displacement control or a coarser tolerance.") },
  { QN_OUTCOME_NOT_CONVERGED, ALL_STEPS, ANYHOW,
    N_ ("The path was stopped at a load multiplier of %.4g, after the largest number "
        "of steps. Use fewer increments or a nearer target.") },
  { QN_OUTCOME_NOT_CONVERGED, ANYHOW, ANYHOW,
    N_ ("The path ends at a load multiplier of %.4g: beyond it no equilibrium was "
        "found, even with the shortest step. Try more increments, another controlled "
        "displacement or a coarser tolerance.") },
};

/* The end that a sentence needs more for than one number; NULL: it does not. */
static char *
explain_by_names (const QnModel *model, const QnStage *task, const QnResult *result,
                  gboolean is_path)
{
  if (result->outcome == QN_OUTCOME_DEAD_LOAD_UNSTABLE)
    return explain_unstable (model, result);
  if (result->outcome == QN_OUTCOME_NOT_CONVERGED && result->stop == QN_STOP_CHECK)
    return explain_refused (model, result);
  if (result->outcome == QN_OUTCOME_NOT_CONVERGED && task->procedure == QN_PROCEDURE_LIMIT
      && result->has_associative_bound)
    return qn_text_printf (
      _ ("No collapse with the dilatancy of the joints was found in %d factorisations. "
         "What is known: no equilibrium above a load multiplier of %.4g, the associative "
         "bound. The load path may tell more."),
      (int) result->statistics.factorizations, result->associative_bound);
  return result->outcome == QN_OUTCOME_TARGET_REACHED && is_path
             && is_controlled_displacement_reached (model, task, result)
           ? explain_controlled (model, task, last_step (result)->multiplier)
           : NULL;
}

static char *
explain (const QnModel *model, const QnStage *task, const QnResult *result)
{
  const QnOutcome outcome = result->outcome;
  const QnStep *last = last_step (result);
  const gboolean target = outcome == QN_OUTCOME_TARGET_REACHED;
  double number = last != NULL ? last->multiplier : 0;
  const gboolean holds[FACT_COUNT] = {
    [ANYHOW] = TRUE,
    [IN_TIME] = result->history.width > 0,
    [BY_LOAD] = task->procedure == QN_PROCEDURE_LOAD,
    [BY_LIMIT] = task->procedure == QN_PROCEDURE_LIMIT,
    [ASSOCIATIVE] = model->analysis.flow == QN_FLOW_ASSOCIATIVE,
    [UNCERTAIN] = result->mechanism_uncertain,
    [FELL] = result->stop == QN_STOP_FALL,
    [NO_STEPS] = last == NULL,
    [SPENT] = last != NULL && last->multiplier <= 0,
    [FAR] = model->analysis.geometry == QN_GEOMETRY_NONLINEAR
            && number < (1 - AT_TARGET) * QN_UNBOUNDED,
    [NO_LIVE_LOAD] = target && result->stage == 0 && qn_model_lacks_live_load (model),
    [HAS_END] = task->has_target,
    [SETTLED] =
      target && !task->has_target && !qn_model_sets_have_force (model, task->sets),
    [ALL_FACTORIZATIONS] = result->stop == QN_STOP_FACTORIZATIONS,
    [ALL_TIME] = result->stop == QN_STOP_TIME,
    [ALL_STEPS] = result->stop == QN_STOP_STEPS,
  };
  char *by_names =
    explain_by_names (model, task, result, !holds[IN_TIME] && !holds[NO_LIVE_LOAD]);
  if (by_names != NULL)
    return by_names;
  if (holds[IN_TIME])
    number = outcome == QN_OUTCOME_COLLAPSE ? result->history.collapse_time
                                            : result->history.end;
  else if (outcome == QN_OUTCOME_SNAP && result->has_first_limit_multiplier)
    number = result->first_limit_multiplier;
  for (gsize i = 0; i < G_N_ELEMENTS (sentences); i++)
    if (sentences[i].outcome == outcome && holds[sentences[i].fact]
        && holds[sentences[i].other])
      return qn_text_with_number (_ (sentences[i].text), number);
  return g_strdup ("");
}

/* What ended an analysis: a result that was read does not state whether its budget did, but how
 * much was used. */
static QnStop
stop_of (const QnModel *model, const QnResult *result)
{
  if (result->stop != QN_STOP_UNKNOWN || result->outcome != QN_OUTCOME_NOT_CONVERGED)
    return result->stop;
  if (result->refused_count > 0)
    return QN_STOP_CHECK;
  if (result->statistics.factorizations >= qn_model_most_factorizations (model))
    return QN_STOP_FACTORIZATIONS;
  return result->statistics.seconds > model->analysis.max_seconds ? QN_STOP_TIME
                                                                  : QN_STOP_UNKNOWN;
}

/* A loss of stability comes first, then `what` (nullable). */
static char *
explain_in_stage (const QnModel *model, const QnResult *result, const char *what)
{
  QnStage task = task_of (model, result);
  QnResult told = *result;
  told.stop = stop_of (model, result);
  g_autofree char *outcome = explain (model, &task, &told);
  g_autofree char *linearity = explain_linearity (result);
  /* How many pairs have lost their bond; NULL where none has. */
  guint broken = 0, damaged = 0;
  for (gsize p = 0; p < result->pair_count && result->step_count > 0; p++) {
    broken += result->pairs[p].damage >= 1;
    damaged += result->pairs[p].damage > 0 && result->pairs[p].damage < 1;
  }
  g_autofree char *bonds =
    broken + damaged > 0
      ? qn_text_printf (_ ("At the last step the bond of %u contact pairs is broken, "
                           "and that of %u damaged."),
                        broken, damaged)
      : NULL;
  g_autofree char *buckling = explain_buckling (result);
  g_autofree char *text = g_strconcat (
    buckling != NULL ? buckling : "", buckling != NULL ? " " : "",
    what != NULL ? what : "", what != NULL ? " " : "", outcome, bonds != NULL ? " " : "",
    bonds != NULL ? bonds : "", linearity != NULL ? " " : "", linearity, NULL);
  if (result->stage < 1 || (size_t) result->stage > model->stage_count)
    return g_steal_pointer (&text);
  g_autofree char *name = qn_stage_dup_name (model, result->stage);
  return qn_text_printf (_ ("Stage %d of %u, “%s”. %s"), result->stage,
                         (guint) model->stage_count, name, text);
}

char *
qn_outcome_dup_reason (const QnModel *model, const QnResult *result)
{
  gboolean collapse =
    result->outcome == QN_OUTCOME_COLLAPSE && result->history.width == 0;
  g_autofree char *what = collapse ? collapse_sentence (result) : NULL;
  return explain_in_stage (model, result, what);
}

char *
qn_outcome_dup_cause (const QnModel *model, const QnResult *result)
{
  return explain_in_stage (model, result, NULL);
}
