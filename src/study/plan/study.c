#include "study/plan/study.h"

#include <glib/gi18n-lib.h>

const char *const qn_study_run_names[QN_STUDY_RUN_COUNT] = {
  [QN_STUDY_SOLVE] = "solve",
  [QN_STUDY_LIMIT] = "limit",
  [QN_STUDY_MODAL] = "modal",
  [QN_STUDY_DYNAMIC] = "dynamic",
};

QnStudyRun
qn_study_run_of (QnStudyRun run, const QnAnalysisSettings *analysis)
{
  return run == QN_STUDY_SOLVE && analysis->procedure == QN_PROCEDURE_DYNAMIC
           ? QN_STUDY_DYNAMIC
           : run;
}

const char *
qn_study_run_override (QnStudyRun run)
{
  return run == QN_STUDY_LIMIT     ? "analysis.procedure=\"limit\""
         : run == QN_STUDY_DYNAMIC ? "analysis.procedure=\"dynamic\""
                                   : NULL;
}

const char *const qn_plan_kind_names[QN_PLAN_COUNT] = {
  [QN_PLAN_GRID] = "grid",
  [QN_PLAN_ONE_AT_A_TIME] = "one-at-a-time",
  [QN_PLAN_MONTE_CARLO] = "monte-carlo",
  [QN_PLAN_LATIN_HYPERCUBE] = "latin-hypercube",
  [QN_PLAN_SOBOL] = "sobol",
  [QN_PLAN_COMBINATIONS] = "combinations",
};

gboolean
qn_plan_is_by_levels (QnPlanKind kind)
{
  return kind == QN_PLAN_GRID || kind == QN_PLAN_ONE_AT_A_TIME
         || kind == QN_PLAN_COMBINATIONS;
}

#define OUTPUT_NAME(name, text, key) key,
#define OUTPUT_TEXT(name, text, key) text,

const char *const qn_study_output_names[] = { QN_STUDY_OUTPUTS (OUTPUT_NAME) };

const char *
qn_study_output_text (QnStudyOutput output)
{
  static const char *const texts[] = { QN_STUDY_OUTPUTS (OUTPUT_TEXT) };
  return _ (texts[output]);
}

gboolean
qn_study_run_bounds (QnStudyRun run, const QnAnalysisSettings *analysis)
{
  return (run == QN_STUDY_LIMIT
          || (run == QN_STUDY_SOLVE && analysis->procedure == QN_PROCEDURE_LIMIT))
         && analysis->flow == QN_FLOW_ASSOCIATIVE;
}

gboolean
qn_study_run_gives (QnStudyRun run, const QnAnalysisSettings *analysis,
                    QnStudyOutput output)
{
  gboolean modal = output >= QN_STUDY_FREQUENCY_1 && output <= QN_STUDY_FREQUENCY_6;
  gboolean timed = output >= QN_STUDY_COLLAPSED && output <= QN_STUDY_ENERGY_ERROR;
  gboolean neutral =
    output == QN_STUDY_MECHANISM_KIND || output == QN_STUDY_MECHANISM_SHAPE
    || output == QN_STUDY_LARGEST_DISPLACEMENT || output == QN_STUDY_ITERATIONS;
  gboolean crack = output == QN_STUDY_WIDEST_CRACK || output == QN_STUDY_CRACK_MISFIT;
  if (run == QN_STUDY_MODAL)
    return modal;
  if (crack)
    return run == QN_STUDY_SOLVE && analysis->procedure != QN_PROCEDURE_LIMIT;
  if (output == QN_STUDY_COLLAPSE_MULTIPLIER && qn_study_run_bounds (run, analysis))
    return FALSE;
  if (timed)
    run = qn_study_run_of (run, analysis);
  return !modal && (neutral || timed == (run == QN_STUDY_DYNAMIC));
}

gsize
qn_study_record_count (const QnStudy *study)
{
  const QnModel *model = &study->project.model;
  return qn_study_run_of (study->run, &model->analysis) == QN_STUDY_DYNAMIC
           ? model->ground_count
           : 0;
}

gboolean
qn_study_output_is_number (QnStudyOutput output)
{
  return output != QN_STUDY_MECHANISM_KIND && output != QN_STUDY_MECHANISM_SHAPE;
}

gsize
qn_parameter_level_count (const QnParameter *parameter)
{
  return parameter->distribution.kind == QN_DISTRIBUTION_DISCRETE
           ? parameter->distribution.count
           : (gsize) parameter->levels;
}

double
qn_parameter_level (const QnParameter *parameter, gsize level)
{
  const QnDistribution *d = &parameter->distribution;
  if (d->kind == QN_DISTRIBUTION_DISCRETE)
    return d->values[level];
  return qn_distribution_quantile (d, ((double) level + 0.5) / parameter->levels);
}

/* Beyond the most that a study may have, one more than that. */
gsize
qn_study_case_count (const QnStudy *study)
{
  gsize count = 1, width = study->parameters->len;
  switch (study->plan) {
  case QN_PLAN_GRID:
  case QN_PLAN_COMBINATIONS:
    for (gsize i = 0; i < width && count <= QN_STUDY_MAX_CASES; i++)
      count *= qn_parameter_level_count (qn_study_parameter (study, i));
    break;
  case QN_PLAN_ONE_AT_A_TIME:
    for (gsize i = 0; i < width; i++)
      count += qn_parameter_level_count (qn_study_parameter (study, i));
    break;
  case QN_PLAN_MONTE_CARLO:
  case QN_PLAN_LATIN_HYPERCUBE:
    count = study->count;
    break;
  case QN_PLAN_SOBOL:
    count = study->count * (width + 2);
    break;
  case QN_PLAN_COUNT:
    g_assert_not_reached ();
  }
  return MIN (count, QN_STUDY_MAX_CASES + 1);
}

const QnCombination *
qn_study_combination (const QnStudy *study, gsize parameter, double value)
{
  if (study->combinations == NULL || parameter + 1 != study->parameters->len
      || !(value >= 1 && value <= study->combinations->len))
    return NULL;
  return study->combinations->pdata[(gsize) value - 1];
}

static void
clear_parameter (gpointer data)
{
  QnParameter *parameter = data;
  g_free (parameter->name);
  g_strfreev (parameter->paths);
  qn_distribution_clear (&parameter->distribution);
}

static void
clear_crack (gpointer data)
{
  QnMeasuredCrack *crack = data;
  g_free (crack->blocks[0]);
  g_free (crack->blocks[1]);
}

void
qn_study_init (QnStudy *study)
{
  *study = (QnStudy){ .seed = 1, .seconds = QN_STUDY_SECONDS };
  study->parameters = g_array_new (FALSE, TRUE, sizeof (QnParameter));
  g_array_set_clear_func (study->parameters, clear_parameter);
  study->cracks = g_array_new (FALSE, TRUE, sizeof (QnMeasuredCrack));
  g_array_set_clear_func (study->cracks, clear_crack);
  study->outputs = g_array_new (FALSE, FALSE, sizeof (QnStudyOutput));
  study->warnings = g_ptr_array_new_with_free_func (g_free);
}

void
qn_study_clear (QnStudy *study)
{
  g_free (study->name);
  g_free (study->title);
  g_free (study->model);
  g_free (study->text);
  g_free (study->sha256);
  g_free (study->folder);
  g_free (study->correlation);
  qn_project_clear (&study->project);
  g_clear_pointer (&study->parameters, g_array_unref);
  g_clear_pointer (&study->cracks, g_array_unref);
  g_clear_pointer (&study->outputs, g_array_unref);
  g_clear_pointer (&study->combinations, g_ptr_array_unref);
  g_clear_pointer (&study->warnings, g_ptr_array_unref);
  *study = (QnStudy){ 0 };
}
