#include "stress/run.h"

#include "stress/cases.h"
#include "stress/checks.h"

#include "core/limit/limit.h"
#include "core/path/analysis.h"
#include "io/project/project.h"
#include "support/auto-clear.h"
#include "support/walls.h"

#include <math.h>
#include <time.h>

typedef struct Structure {
  QnModel model;
  QnContacts contacts;
} Structure;

static double
cpu_seconds (void)
{
  return (double) clock () / CLOCKS_PER_SEC;
}

static void
build (const StressCase *c, StressFlow flow, bool mirrored, QnModel *model)
{
  c->build (c, model);
  for (size_t i = 0; i < model->law_count; i++)
    model->laws[i].dilatancy = flow == STRESS_ASSOCIATIVE ? model->laws[i].friction : 0;
  for (size_t i = 0; i < model->live_load_count && mirrored; i++) {
    g_assert_cmpint (model->live_loads[i].kind, ==, QN_LOAD_WEIGHT);
    model->live_loads[i].vector.x *= -1;
  }
  model->analysis.all_forces = true;
}

/* A structure that can be analysed; otherwise the problem that the core sees in it. */
static QnProblem
structure_init (Structure *s, const StressCase *c, StressFlow flow, bool mirrored)
{
  QnDiag diag = { 0 };

  *s = (Structure){ 0 };
  build (c, flow, mirrored, &s->model);
  if (qn_model_prepare (&s->model, &diag) == QN_OK
      && qn_contacts_detect (&s->model, &s->contacts, &diag) == QN_OK
      && qn_contacts_require_sound (&s->model, &s->contacts, &diag) == QN_OK)
    return QN_PROBLEM_NONE;
  return diag.problem;
}

static void
structure_clear (Structure *s)
{
  qn_contacts_clear (&s->contacts);
  qn_model_clear (&s->model);
}

G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC (Structure, structure_clear)

static bool
within_budget (const QnProgress *progress, void *user_data)
{
  (void) user_data;
  return progress->iterations <= STRESS_MOST_ITERATIONS;
}

/* At the verge itself any proof would be one of rounding. */
static void
run_limit (const Structure *s, bool verge, StressRow *row)
{
  StressSolve *solve = &row->limit;
  QnLimitSolution solution;
  QnDiag diag = { 0 };
  double start = cpu_seconds ();

  if (qn_limit_associative (&s->model, &s->contacts, within_budget, NULL, &solution,
                            &diag)
      != QN_OK) {
    row->problem = diag.problem;
    return;
  }
  solve->solved = true;
  solve->seconds = cpu_seconds () - start;
  solve->outcome = solution.outcome;
  solve->iterations = solution.effort.iterations;
  solve->factorizations = solution.effort.factorizations;
  row->lower = solution.lower_bound;
  row->upper = solution.upper_bound;
  if (solution.outcome == QN_OUTCOME_NOT_CONVERGED)
    solve->faults |= STRESS_NO_ANSWER;
  else if (!verge && !stress_limit_is_proved (&s->model, &s->contacts, &solution))
    solve->faults |= STRESS_LIMIT;
  qn_limit_solution_clear (&solution);
}

static void
run_path (const Structure *s, StressSolve *solve)
{
  QnResult result;
  double start = cpu_seconds ();

  *solve = (StressSolve){ .multiplier = NAN, .first_limit = NAN };
  if (qn_analysis_run (&s->model, &s->contacts, within_budget, NULL, &result, NULL)
      != QN_OK) {
    solve->faults |= STRESS_REFUSED;
    return;
  }
  solve->solved = true;
  solve->seconds = cpu_seconds () - start;
  solve->outcome = result.outcome;
  solve->steps = (int32_t) result.step_count;
  solve->iterations = result.statistics.iterations;
  solve->factorizations = result.statistics.factorizations;
  if (result.step_count > 0)
    solve->multiplier = result.steps[result.step_count - 1].multiplier;
  if (result.has_first_limit_multiplier)
    solve->first_limit = result.first_limit_multiplier;
  solve->check = stress_check_result (&s->model, &s->contacts, &result);
  solve->faults |= stress_check_faults (&solve->check);
  if (!stress_path_is_consistent (&result))
    solve->faults |= STRESS_PATH;
  if (result.outcome == QN_OUTCOME_CANCELLED)
    solve->faults |= STRESS_BUDGET;
  if (result.outcome == QN_OUTCOME_NOT_CONVERGED)
    solve->faults |= STRESS_NO_ANSWER;
  qn_result_clear (&result);
}

/* What multipliers may differ by although they are to be equal. */
static double
allowance (const StressCase *c, const QnAnalysisSettings *settings, double relative,
           double multiplier)
{
  double verge = c->expectation == STRESS_EXPECT_VERGE ? relative : 0;
  return relative * fabs (multiplier)
         + fmax (verge, 1e-3 * settings->multiplier_tolerance);
}

/* Whether joints have a bond. It breaks along the path, while limit analysis takes it as ductile: then its
 * optimum bounds the path from above and is no longer its end. */
static bool
is_bonded (const QnModel *model)
{
  for (size_t i = 0; i < model->law_count; i++)
    if (model->laws[i].cohesion > 0 || model->laws[i].tension > 0)
      return true;
  return false;
}

/* A path that claims collapse, beside the optimum of limit analysis. */
static guint
compare_collapse (const StressCase *c, StressFlow flow, const StressRow *row,
                  const QnModel *model)
{
  const QnAnalysisSettings *settings = &model->analysis;
  double found = row->paths[flow].multiplier;
  double tolerance = fmax (settings->multiplier_tolerance, STRESS_LIMIT_ACCURACY);
  guint faults = 0;

  if (row->limit.outcome == QN_OUTCOME_UNBOUNDED)
    return flow == STRESS_ASSOCIATIVE ? STRESS_OUTCOME : 0;
  if (!(found <= row->upper + allowance (c, settings, tolerance, row->upper)))
    faults |= STRESS_ABOVE;
  if (flow == STRESS_ASSOCIATIVE && !is_bonded (model)
      && !(fabs (found - row->upper)
           <= allowance (c, settings, STRESS_AGREEMENT, row->upper)))
    faults |= STRESS_DIFFERS;
  return faults;
}

/* Whether a path's outcome and multiplier agree with what limit analysis has proved. */
static guint
compare (const StressCase *c, StressFlow flow, const StressRow *row, const QnModel *model)
{
  const QnAnalysisSettings *settings = &model->analysis;
  const StressSolve *path = &row->paths[flow];
  QnOutcome limit = row->limit.outcome;
  bool verge = c->expectation == STRESS_EXPECT_VERGE;
  guint faults = 0;

  if (row->limit.faults != 0 || !row->limit.solved || !path->solved)
    return 0;
  switch (path->outcome) {
  case QN_OUTCOME_COLLAPSE:
    if (limit == QN_OUTCOME_DEAD_LOAD_UNSTABLE)
      return verge ? 0 : STRESS_OUTCOME;
    faults = compare_collapse (c, flow, row, model);
    break;
  case QN_OUTCOME_DEAD_LOAD_UNSTABLE:
    /* True friction may let fall what dilatancy would hold. */
    if (limit != QN_OUTCOME_DEAD_LOAD_UNSTABLE && !verge && flow == STRESS_ASSOCIATIVE)
      faults |= STRESS_OUTCOME;
    break;
  case QN_OUTCOME_TARGET_REACHED:
  case QN_OUTCOME_UNBOUNDED:
    if (limit != QN_OUTCOME_UNBOUNDED
        && !(limit == QN_OUTCOME_COLLAPSE && row->upper > path->multiplier))
      faults |= STRESS_OUTCOME;
    break;
  case QN_OUTCOME_CANCELLED:
  case QN_OUTCOME_NOT_CONVERGED:
    break;
  case QN_OUTCOME_SNAP:
  case QN_OUTCOME_REST:
  case QN_OUTCOME_COUNT:
    faults |= STRESS_OUTCOME;
  }
  if (flow == STRESS_ASSOCIATIVE && path->check.uncertain && !is_bonded (model))
    faults |= STRESS_UNCERTAIN;
  if (!isnan (c->exact[flow])
      && !(fabs (path->multiplier - c->exact[flow])
           <= allowance (c, settings, STRESS_AGREEMENT, c->exact[flow])))
    faults |= STRESS_STATICS;
  return faults;
}

static void
run_mirrored (const StressCase *c, StressRow *row)
{
  const StressSolve *path = &row->paths[STRESS_SLIDING];
  StressSolve mirrored;
  g_auto (Structure) s;

  g_assert_cmpint (structure_init (&s, c, STRESS_SLIDING, true), ==, QN_PROBLEM_NONE);
  run_path (&s, &mirrored);
  row->mirrored = mirrored.multiplier;
  if (path->outcome != mirrored.outcome
      || !(fabs (path->multiplier - mirrored.multiplier)
           <= STRESS_MIRROR_AGREEMENT * path->multiplier))
    row->faults |= STRESS_MIRROR;
}

/* Friction without dilatancy has no unique answer: how far two ways up are apart is for the
 * table, no fault. */
static void
run_repeated (const StressCase *c, StressRow *row)
{
  StressSolve repeated;
  g_auto (Structure) s;

  g_assert_cmpint (structure_init (&s, c, STRESS_SLIDING, false), ==, QN_PROBLEM_NONE);
  s.model.analysis.increments = c->repeat;
  run_path (&s, &repeated);
  if (repeated.outcome == QN_OUTCOME_COLLAPSE)
    row->repeated = repeated.multiplier;
  row->faults |= repeated.faults;
}

/* What a project file says must be the model that it was written from, whatever its numbers. */
static void
check_file (const StressCase *c, const Structure *s, StressRow *row)
{
  g_autoptr (GError) error = NULL;
  QnProject written, read;
  QnContacts contacts = { 0 };
  gsize length;

  qn_project_init (&written);
  qn_model_clear (&written.model);
  build (c, STRESS_ASSOCIATIVE, false, &written.model);
  g_autofree char *text = qn_project_to_text (&written, &length);
  bool same = qn_project_parse (text, length, c->name, NULL, &read, &error)
              && qn_contacts_detect (&read.model, &contacts, NULL) == QN_OK
              && contacts.pair_count == s->contacts.pair_count;

  for (size_t p = 0; same && p < contacts.pair_count; p++)
    same = contacts.pairs[p].point.x == s->contacts.pairs[p].point.x
           && contacts.pairs[p].point.y == s->contacts.pairs[p].point.y;
  if (!same)
    row->faults |= STRESS_FILE;
  qn_contacts_clear (&contacts);
  if (error == NULL)
    qn_project_clear (&read);
  qn_project_clear (&written);
}

static void
describe (const StressCase *c, StressRow *row)
{
  if (c->build != stress_case_build_random)
    return;
  g_auto (QnModel) model;
  test_wall_draw_any (&model, (guint32) c->number, row->description,
                      sizeof row->description);
}

void
stress_run (const StressCase *c, StressRow *row)
{
  Structure s;

  *row = (StressRow){ .mirrored = NAN, .repeated = NAN, .lower = NAN, .upper = NAN };
  describe (c, row);
  for (int flow = 0; flow < STRESS_FLOW_COUNT; flow++) {
    row->problem = structure_init (&s, c, (StressFlow) flow, false);
    row->blocks = s.model.block_count;
    row->pairs = s.contacts.pair_count;
    if (row->problem == QN_PROBLEM_NONE && flow == STRESS_ASSOCIATIVE) {
      check_file (c, &s, row);
      run_limit (&s, c->expectation == STRESS_EXPECT_VERGE, row);
    }
    if (row->problem == QN_PROBLEM_NONE) {
      run_path (&s, &row->paths[flow]);
      row->paths[flow].faults |= compare (c, (StressFlow) flow, row, &s.model);
    }
    structure_clear (&s);
  }
  if (c->expectation == STRESS_EXPECT_REFUSED && row->problem != c->problem)
    row->faults |= STRESS_NOT_REFUSED;
  if (c->expectation != STRESS_EXPECT_REFUSED && row->problem != QN_PROBLEM_NONE)
    row->faults |= STRESS_REFUSED;
  if (c->symmetric && row->problem == QN_PROBLEM_NONE)
    run_mirrored (c, row);
  if (c->repeat > 0 && row->problem == QN_PROBLEM_NONE)
    run_repeated (c, row);
}

gboolean
stress_write_project (const StressCase *c, StressFlow flow, const char *path,
                      GError **error)
{
  QnProject project;

  qn_project_init (&project);
  qn_model_clear (&project.model);
  build (c, flow, false, &project.model);
  gboolean written = qn_project_save (&project, path, error);
  qn_project_clear (&project);
  return written;
}
