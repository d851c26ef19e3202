#include "core/base/integer.h"
#include "core/base/word.h"
#include "io/exchange/record.h"
#include "io/json/json-path.h"
#include "io/json/json-value.h"
#include "io/project/project-members.h"
#include "io/text/file-read.h"
#include "io/text/text-format.h"
#include "study/plan/sample.h"
#include "study/plan/study.h"

#include <glib/gi18n-lib.h>
#include <gsl/gsl_errno.h>
#include <math.h>
#include <string.h>

/* Parameters of a Sobol sequence of GSL: two dimensions for each. */
#define SOBOL_PARAMETERS 20

/* Numbers of an array, at least one. */
static gboolean
read_numbers (const QnJsonValue *list, QnRange range, GArray *numbers)
{
  QnJsonValue element = { 0 };
  double number;
  if (!qn_json_value_array (list))
    return FALSE;
  while (qn_json_value_next (list, &element)) {
    if (!qn_json_value_number (&element, range, &number))
      return FALSE;
    g_array_append_val (numbers, number);
  }
  if (numbers->len == 0)
    return qn_json_value_fail (list, _ ("expected at least one number"));
  if (numbers->len > QN_STUDY_MAX_VALUES)
    return qn_json_value_failf (list, _ ("more than %d values"), QN_STUDY_MAX_VALUES);
  return TRUE;
}

static gboolean
read_values (const QnJsonValue *list, const QnJsonValue *weights, QnDistribution *d)
{
  g_autoptr (GArray) values = g_array_new (FALSE, FALSE, sizeof (double));
  g_autoptr (GArray) shares = g_array_new (FALSE, FALSE, sizeof (double));
  if (!read_numbers (list, QN_RANGE_FINITE, values))
    return FALSE;
  if (weights != NULL && weights->json != NULL) {
    double sum = 0;
    if (!read_numbers (weights, QN_RANGE_NOT_NEGATIVE, shares))
      return FALSE;
    for (guint i = 0; i < shares->len; i++)
      sum += g_array_index (shares, double, i);
    if (shares->len != values->len || !(sum > 0) || !isfinite (sum))
      return qn_json_value_fail (weights,
                                 _ ("expected one weight for every value, at least "
                                    "one above 0"));
  }
  qn_distribution_set_values (d, (double *) (void *) values->data,
                              shares->len > 0 ? (double *) (void *) shares->data : NULL,
                              values->len);
  return TRUE;
}

/* [low, high, count]: equally spaced values, both ends included. */
static gboolean
read_range (const QnJsonValue *list, QnDistribution *d)
{
  g_autoptr (GArray) ends = g_array_new (FALSE, FALSE, sizeof (double));
  if (!read_numbers (list, QN_RANGE_FINITE, ends))
    return FALSE;
  const double *end = (double *) (void *) ends->data;
  if (ends->len != 3 || !(end[0] < end[1]) || !isfinite (end[1] - end[0]) || end[2] < 2
      || end[2] != floor (end[2]) || end[2] > QN_STUDY_MAX_VALUES)
    return qn_json_value_fail (list,
                               _ ("expected [least, greatest, number of values], at "
                                  "least 2 values"));
  gsize count = (gsize) qn_to_integer (end[2], 0, QN_STUDY_MAX_VALUES);
  g_autofree double *values = g_new (double, count);
  for (gsize i = 0; i < count; i++)
    values[i] = end[0] + (end[1] - end[0]) * (double) i / (double) (count - 1);
  values[count - 1] = end[1];
  qn_distribution_set_values (d, values, NULL, count);
  return TRUE;
}

/* What a file says of a distribution, of which each kind has a part. */
typedef struct Stated {
  double min, max, mean, cov, deviation, mode, scale, shape;
} Stated;

#define ENDS(use)                                                                        \
  QN_KNOWN ("kind"), QN_NUMBER ("min", use, FINITE, Stated, min),                        \
    QN_NUMBER ("max", use, FINITE, Stated, max)
#define MOMENTS(range)                                                                   \
  ENDS (OPTIONAL), QN_NUMBER ("mean", REQUIRED, range, Stated, mean),                    \
    QN_NUMBER ("cov", OPTIONAL, POSITIVE, Stated, cov),                                  \
    QN_NUMBER ("deviation", OPTIONAL, POSITIVE, Stated, deviation)

static const QnMember distribution_members[QN_DISTRIBUTION_COUNT][7] = {
  [QN_DISTRIBUTION_NORMAL] = { MOMENTS (FINITE) },
  [QN_DISTRIBUTION_LOGNORMAL] = { MOMENTS (POSITIVE) },
  [QN_DISTRIBUTION_UNIFORM] = { ENDS (REQUIRED) },
  [QN_DISTRIBUTION_TRIANGULAR] = { ENDS (REQUIRED),
                                   QN_NUMBER ("mode", REQUIRED, FINITE, Stated, mode) },
  [QN_DISTRIBUTION_WEIBULL] = { ENDS (OPTIONAL),
                                QN_NUMBER ("scale", REQUIRED, POSITIVE, Stated, scale),
                                QN_NUMBER ("shape", REQUIRED, POSITIVE, Stated, shape) },
  [QN_DISTRIBUTION_DISCRETE] = { QN_KNOWN ("kind"), QN_KNOWN ("values"),
                                 QN_KNOWN ("weights") },
};

static gboolean
read_distribution (const QnJsonValue *place, QnDistribution *d)
{
  Stated stated = { .min = -INFINITY, .max = INFINITY };
  if (!qn_json_value_object (place)
      || !qn_member_choice (place, "kind", QN_REQUIRED, qn_distribution_kind_names,
                            QN_DISTRIBUTION_COUNT, &d->kind)
      || !qn_members_read (place, distribution_members[d->kind], NULL, &stated))
    return FALSE;
  if (d->kind == QN_DISTRIBUTION_DISCRETE) {
    QnJsonValue values = qn_json_value_member (place, "values");
    QnJsonValue weights = qn_json_value_member (place, "weights");
    return read_values (&values, &weights, d);
  }
  const gboolean weibull = d->kind == QN_DISTRIBUTION_WEIBULL;
  d->min = stated.min;
  d->max = stated.max;
  d->first = weibull ? stated.scale : stated.mode;
  d->second = stated.shape;
  if (d->kind <= QN_DISTRIBUTION_LOGNORMAL) {
    /* Mean with either deviation or coefficient of variation. */
    const QnJsonValue by_share = qn_json_value_member (place, "cov");
    if ((stated.cov > 0) == (stated.deviation > 0))
      return qn_json_value_fail (place, _ ("expected either cov or deviation"));
    if (stated.cov > 0 && stated.mean == 0)
      return qn_json_value_fail (&by_share,
                                 _ ("a mean of 0 needs a deviation instead of cov"));
    d->first = stated.mean;
    d->second = stated.cov > 0 ? stated.cov * fabs (stated.mean) : stated.deviation;
    if (d->kind == QN_DISTRIBUTION_LOGNORMAL)
      qn_distribution_set_lognormal (d, d->first, d->second);
  }
  if (!(d->min < d->max))
    return qn_json_value_fail (place, _ ("min must be less than max"));
  if (d->kind == QN_DISTRIBUTION_TRIANGULAR
      && !(d->min <= d->first && d->first <= d->max))
    return qn_json_value_fail (place, _ ("the mode must lie between min and max"));
  return qn_distribution_is_possible (d)
         || qn_json_value_fail (place, _ ("no value lies between min and max"));
}

/* The number that a path leads to in the project, NaN where there is none; FALSE where something
 * else stands there. */
static gboolean
find_number (const cJSON *value, const char *path, double *number)
{
  g_autoptr (GArray) steps = qn_json_path_parse (path);
  *number = NAN;
  for (guint i = 0; steps != NULL && i < steps->len && value != NULL; i++) {
    const QnJsonStep *step = &g_array_index (steps, QnJsonStep, i);
    value = step->key != NULL ? cJSON_GetObjectItemCaseSensitive (value, step->key)
                              : cJSON_GetArrayItem (value, (int) step->index);
  }
  if (cJSON_IsNumber (value))
    *number = value->valuedouble;
  return value == NULL || cJSON_IsNumber (value);
}

/* Whether a path leads to a number of the project, which must read with one there. */
static gboolean
check_path (const QnJsonValue *place, const char *path, const QnStudy *study,
            const cJSON *document, const QnParameter *parameter, double *base)
{
  char number[QN_NUMBER_TEXT_SIZE];
  const QnProject *project = &study->project;
  if (!find_number (document, path, base))
    return qn_json_value_failf (place, _ ("%s: no number stands at %s"), project->name,
                                path);

  /* Where the project says nothing yet, any value that the parameter may have. */
  double value = *base;
  if (isnan (value))
    value = qn_distribution_quantile (&parameter->distribution, 0.5);
  if (parameter->whole)
    value = rint (value);
  g_autofree char *override =
    g_strdup_printf ("%s=%s", path, qn_number_text (value, number));
  const char *const overrides[] = { override, NULL };
  QnProject probe;
  GError *error = NULL;
  if (!qn_project_parse (project->text, project->text_length, project->name, overrides,
                         &probe, &error)) {
    qn_json_value_fail (place, error->message);
    g_error_free (error);
    return FALSE;
  }
  qn_project_clear (&probe);
  return TRUE;
}

/* Of two values for one place the last would count, and the other parameter seem to do nothing. */
static gboolean
varies_already (const QnStudy *study, const char *path)
{
  for (guint i = 0; i + 1 < study->parameters->len; i++)
    if (g_strv_contains ((const char *const *) qn_study_parameter (study, i)->paths,
                         path))
      return TRUE;
  return FALSE;
}

/* One path or an array of them. */
static gboolean
read_paths (const QnJsonValue *parameter, const QnStudy *study, const cJSON *document,
            QnParameter *target)
{
  QnJsonValue place = qn_json_value_member (parameter, "path");
  g_autoptr (GPtrArray) paths = g_ptr_array_new_with_free_func (g_free);
  const cJSON *item = cJSON_IsArray (place.json) ? place.json->child : place.json;
  gsize index = 0;
  for (; item != NULL; item = item != place.json ? item->next : NULL) {
    QnJsonValue element =
      item != place.json ? qn_json_value_element (&place, index, item) : place;
    double base = NAN;
    if (!cJSON_IsString (item))
      return qn_json_value_fail (&element,
                                 _ ("expected a path into the project, or an array "
                                    "of them"));
    if (varies_already (study, item->valuestring)
        || g_ptr_array_find_with_equal_func (paths, item->valuestring, g_str_equal, NULL))
      return qn_json_value_failf (&element, _ ("%s varies already"), item->valuestring);
    if (!check_path (&element, item->valuestring, study, document, target, &base))
      return FALSE;
    if (index++ == 0)
      target->base = base;
    g_ptr_array_add (paths, g_strdup (item->valuestring));
  }
  if (paths->len == 0)
    return qn_json_value_fail (&place, _ ("required key is missing"));
  g_ptr_array_add (paths, NULL);
  target->paths = (char **) g_ptr_array_steal (paths, NULL);
  return TRUE;
}

/* Names become columns of a table, beside those of outputs and of what every case has. */
static gboolean
check_name (const QnJsonValue *place, const char *name, const QnStudy *study)
{
  static const char *const taken[] = { "case",   "status",  "outcome",
                                       "reason", "seconds", "version" };
  gboolean used = *name == '\0';
  for (gsize i = 0; i < G_N_ELEMENTS (taken); i++)
    used |= g_ascii_strcasecmp (name, taken[i]) == 0;
  for (int i = 0; i < QN_STUDY_OUTPUT_COUNT; i++)
    used |= g_ascii_strcasecmp (name, qn_study_output_names[i]) == 0;
  for (guint i = 0; i + 1 < study->parameters->len; i++)
    used |= g_ascii_strcasecmp (name, qn_study_parameter (study, i)->name) == 0;
  QnJsonValue member = qn_json_value_member (place, "name");
  for (const char *c = name; *c != '\0'; c++)
    if ((guchar) *c < 0x20 || *c == '"')
      return qn_json_value_fail (&member,
                                 _ ("a name has neither quotes nor line breaks"));
  return !used
         || qn_json_value_fail (&member, _ ("this name is empty, used twice, or that of "
                                            "another column of the table"));
}

static const QnMember parameter_members[] = {
  QN_KNOWN ("name"),
  QN_KNOWN ("path"),
  QN_KNOWN ("distribution"),
  QN_KNOWN ("values"),
  QN_KNOWN ("range"),
  QN_COUNT ("levels", OPTIONAL, QN_STUDY_MAX_VALUES, QnParameter, levels),
  QN_BOOL ("whole", OPTIONAL, QnParameter, whole),
  { 0 },
};

static gboolean
read_parameter (const QnJsonValue *place, QnStudy *study, const cJSON *document)
{
  static const char *const kinds[] = { "distribution", "values", "range" };
  const char *name = NULL;
  if (!qn_json_value_object (place)
      || !qn_member_string (place, "name", QN_REQUIRED, &name)
      || !qn_members_check (place, parameter_members, NULL, NULL))
    return FALSE;
  g_array_set_size (study->parameters, study->parameters->len + 1);
  QnParameter *parameter =
    &g_array_index (study->parameters, QnParameter, study->parameters->len - 1);
  parameter->name = g_strdup (name);
  if (!check_name (place, name, study))
    return FALSE;

  QnJsonValue given[G_N_ELEMENTS (kinds)];
  guint count = 0;
  for (gsize i = 0; i < G_N_ELEMENTS (kinds); i++) {
    given[i] = qn_json_value_member (place, kinds[i]);
    count += given[i].json != NULL;
  }
  if (count != 1)
    return qn_json_value_fail (
      place, _ ("expected one of \"distribution\", \"values\", \"range\""));
  QnDistribution *d = &parameter->distribution;
  if (!(given[0].json != NULL   ? read_distribution (&given[0], d)
        : given[1].json != NULL ? read_values (&given[1], NULL, d)
                                : read_range (&given[2], d))
      || !qn_members_take (place, parameter_members, NULL, parameter))
    return FALSE;
  return read_paths (place, study, document, parameter);
}

/* The last parameter of a plan of combinations: their numbers, from 1. */
static gboolean
add_combinations (const QnJsonValue *root, QnStudy *study)
{
  GError *error = NULL;
  QnParameter parameter = { .name = g_strdup ("combination"),
                            .paths = g_new0 (char *, 1),
                            .base = NAN };
  study->combinations = qn_combinations_make (&study->project, &error);
  if (study->combinations == NULL) {
    QnJsonValue plan = qn_json_value_member (root, "plan");
    qn_json_value_fail (&plan, error->message);
    g_error_free (error);
  }
  gsize count = study->combinations != NULL ? study->combinations->len : 1;
  g_autofree double *numbers = g_new (double, count);
  for (gsize i = 0; i < count; i++)
    numbers[i] = (double) i + 1;
  qn_distribution_set_values (&parameter.distribution, numbers, NULL, count);
  g_array_append_val (study->parameters, parameter);
  return study->combinations != NULL && check_name (root, parameter.name, study);
}

static gboolean
read_parameters (const QnJsonValue *root, QnStudy *study)
{
  QnJsonValue list = qn_json_value_member (root, "parameters");
  const cJSON *plan = qn_json_value_member (root, "plan").json;
  const char *kind = cJSON_GetStringValue (cJSON_GetObjectItem (plan, "kind"));
  gboolean combined = g_strcmp0 (kind, qn_plan_kind_names[QN_PLAN_COMBINATIONS]) == 0;
  if (combined && (list.json == NULL || cJSON_GetArraySize (list.json) == 0))
    return add_combinations (root, study);
  if (!qn_json_value_array (&list))
    return FALSE;
  if (cJSON_GetArraySize (list.json) < 1
      || cJSON_GetArraySize (list.json) > QN_STUDY_MAX_PARAMETERS)
    return qn_json_value_failf (&list, _ ("expected 1 to %d parameters"),
                                QN_STUDY_MAX_PARAMETERS);
  cJSON *document =
    qn_json_parse (study->project.text, study->project.text_length, "", NULL);
  if (document == NULL)
    return qn_json_value_no_memory (&list);
  QnJsonValue element = { 0 };
  gboolean ok = TRUE;
  while (ok && qn_json_value_next (&list, &element))
    ok = read_parameter (&element, study, document);
  cJSON_Delete (document);
  return ok && (!combined || add_combinations (root, study));
}

static gboolean
find_parameter (const QnJsonValue *place, const QnStudy *study, guint *index)
{
  for (guint i = 0; cJSON_IsString (place->json) && i < study->parameters->len; i++)
    if (strcmp (place->json->valuestring, qn_study_parameter (study, i)->name) == 0) {
      *index = i;
      return TRUE;
    }
  return qn_json_value_fail (place, _ ("no parameter has this name"));
}

static gboolean
read_correlation (const QnJsonValue *root, QnStudy *study)
{
  QnJsonValue list = qn_json_value_member (root, "correlation"), element = { 0 };
  guint width = study->parameters->len;
  if (list.json == NULL)
    return TRUE;
  if (!qn_json_value_array (&list))
    return FALSE;
  if (study->plan != QN_PLAN_MONTE_CARLO && study->plan != QN_PLAN_LATIN_HYPERCUBE)
    return qn_json_value_failf (&list, _ ("a plan \"%s\" has independent parameters"),
                                qn_plan_kind_names[study->plan]);
  study->correlation = g_new0 (double, width *width);
  while (qn_json_value_next (&list, &element)) {
    guint a = 0, b = 0;
    double value;
    if (!qn_json_value_array (&element))
      return FALSE;
    if (cJSON_GetArraySize (element.json) != 3)
      return qn_json_value_fail (&element, _ ("expected [name, name, rank correlation]"));
    QnJsonValue item = { 0 };
    qn_json_value_next (&element, &item);
    if (!find_parameter (&item, study, &a) || !qn_json_value_next (&element, &item)
        || !find_parameter (&item, study, &b) || !qn_json_value_next (&element, &item)
        || !qn_json_value_number (&item, QN_RANGE_FINITE, &value))
      return FALSE;
    if (a == b || study->correlation[a * width + b] != 0)
      return qn_json_value_fail (&element,
                                 _ ("expected two parameters, and each pair once"));
    if (!(fabs (value) < 1))
      return qn_json_value_fail (&item, _ ("a correlation lies between -1 and 1"));
    study->correlation[a * width + b] = study->correlation[b * width + a] = value;
  }
  for (guint i = 0; i < width; i++)
    study->correlation[i * width + i] = 1;
  if (!qn_correlation_is_possible (study->correlation, width))
    return qn_json_value_fail (
      &list, _ ("no variables have these correlations at once: the matrix "
                "is not positive definite"));
  if (study->plan == QN_PLAN_LATIN_HYPERCUBE && (guint) study->count < 2 * width + 2)
    return qn_json_value_failf (&list, _ ("correlated layers need at least %u cases"),
                                2 * width + 2);
  return TRUE;
}

static gboolean
read_plan (const QnJsonValue *root, QnStudy *study)
{
  static const QnMember members[] = {
    QN_CHOICE ("kind", REQUIRED, qn_plan_kind_names, QnStudy, plan),
    QN_COUNT ("count", OPTIONAL, QN_STUDY_MAX_CASES, QnStudy, count),
    QN_SEED ("seed", OPTIONAL, QnStudy, seed),
    { 0 },
  };
  QnJsonValue plan = qn_json_value_member (root, "plan");
  if (!qn_members_read (&plan, members, NULL, study))
    return FALSE;
  const gboolean levels = qn_plan_is_by_levels (study->plan);
  int32_t count;
  if (!levels && !qn_member_count (&plan, "count", QN_REQUIRED, G_MAXINT32, &count))
    return FALSE;
  if (levels) {
    QnJsonValue list = qn_json_value_member (root, "parameters");
    for (guint i = 0; i < study->parameters->len - (study->combinations != NULL); i++) {
      const QnParameter *parameter = qn_study_parameter (study, i);
      QnJsonValue element =
        qn_json_value_element (&list, i, cJSON_GetArrayItem (list.json, (int) i));
      if (qn_parameter_level_count (parameter) == 0)
        return qn_json_value_failf (
          &element, _ ("a distribution in a plan \"%s\" needs \"levels\""),
          qn_plan_kind_names[study->plan]);
      if (study->plan == QN_PLAN_ONE_AT_A_TIME && isnan (parameter->base))
        return qn_json_value_failf (
          &element,
          _ ("the plan begins with the project's own values, and %s "
             "gives none here"),
          study->project.name);
    }
  }
  if (study->plan == QN_PLAN_SOBOL && study->parameters->len > SOBOL_PARAMETERS)
    return qn_json_value_failf (&plan, _ ("a plan \"sobol\" has at most %d parameters"),
                                SOBOL_PARAMETERS);
  return qn_study_case_count (study) <= QN_STUDY_MAX_CASES
         || qn_json_value_failf (&plan, _ ("the plan has more than %d cases"),
                                 QN_STUDY_MAX_CASES);
}

/* Widths of cracks between two blocks. */
static gboolean
read_cracks (const QnJsonValue *root, QnStudy *study)
{
  typedef struct Crack {
    QnId blocks[2];
    double width;
  } Crack;
  static const QnMember members[] = {
    QN_NUMBER ("width", REQUIRED, NOT_NEGATIVE, Crack, width),
    QN_LIST_OF ("blocks", NAMES, REQUIRED, Crack, blocks, QN_NAMED_BLOCK,
                N_ ("expected the names of two blocks")),
    { 0 },
  };
  const QnModel *model = &study->project.model;
  QnJsonValue list, item = { 0 };
  if (!qn_member_array (root, "cracks", QN_OPTIONAL, &list))
    return FALSE;
  while (qn_json_value_next (&list, &item)) {
    Crack read;
    if (!qn_members_read (&item, members, model, &read))
      return FALSE;
    QnMeasuredCrack crack = { { g_strdup (model->blocks[read.blocks[0]].name),
                                g_strdup (model->blocks[read.blocks[1]].name) },
                              read.width };
    g_array_append_val (study->cracks, crack);
  }
  return TRUE;
}

static gboolean
read_outputs (const QnJsonValue *root, QnStudy *study)
{
  const QnAnalysisSettings *analysis = &study->project.model.analysis;
  gboolean bounds = qn_study_run_bounds (study->run, analysis);
  QnJsonValue list = qn_json_value_member (root, "outputs"), element = { 0 };
  if (!qn_json_value_array (&list))
    return FALSE;
  while (qn_json_value_next (&list, &element)) {
    const char *name = cJSON_GetStringValue (element.json);
    QnStudyOutput output = QN_STUDY_OUTPUT_COUNT;
    qn_find_word (name, qn_study_output_names, QN_STUDY_OUTPUT_COUNT, &output);
    /* What it gives is kept under the name of what it is. */
    gboolean renamed = bounds && output == QN_STUDY_COLLAPSE_MULTIPLIER;
    if (renamed) {
      qn_json_value_warn (
        &element,
        _ ("limit analysis with associative flow bounds the collapse multiplier "
           "from above: kept as associative_multiplier; the run \"solve\" "
           "gives the collapse multiplier"));
      output = QN_STUDY_ASSOCIATIVE_MULTIPLIER;
    }
    if (output == QN_STUDY_OUTPUT_COUNT
        || !qn_study_run_gives (study->run, analysis, output))
      return qn_json_value_failf (&element, _ ("a run \"%s\" has no such output"),
                                  qn_study_run_names[study->run]);
    if (output == QN_STUDY_CRACK_MISFIT && study->cracks->len == 0)
      return qn_json_value_fail (&element, _ ("no cracks are given"));
    guint same = 0;
    while (same < study->outputs->len && qn_study_output (study, same) != output)
      same++;
    if (same == study->outputs->len)
      g_array_append_val (study->outputs, output);
    else if (!bounds || output != QN_STUDY_ASSOCIATIVE_MULTIPLIER)
      return qn_json_value_fail (&element, _ ("this output is given twice"));
  }
  return study->outputs->len > 0
         || qn_json_value_fail (&list, _ ("expected at least one output"));
}

static gboolean
read_limits (const QnJsonValue *root, QnStudy *study)
{
  static const QnMember members[] = {
    QN_NUMBER ("seconds", OPTIONAL, POSITIVE, QnStudy, seconds),
    QN_COUNT ("factorizations", OPTIONAL, G_MAXINT32, QnStudy, factorizations),
    { 0 },
  };
  QnJsonValue limits = qn_json_value_member (root, "limits");
  return limits.json == NULL || qn_members_read (&limits, members, NULL, study);
}

/* Whether the project says what the run needs: without this every case would fail. */
static gboolean
check_run (const QnJsonValue *root, QnStudy *study)
{
  const QnProject *project = &study->project;
  const char *const overrides[] = { qn_study_run_override (study->run), NULL };
  QnProject probe;
  GError *error = NULL;
  if (overrides[0] == NULL)
    return TRUE;
  gboolean ok = qn_project_parse (project->text, project->text_length, project->name,
                                  overrides, &probe, &error);
  if (ok) {
    ok = qn_project_read_records (&probe, study->folder, FALSE, &error);
    qn_project_clear (&probe);
  }
  if (!ok) {
    QnJsonValue run = qn_json_value_member (root, "run");
    qn_json_value_fail (&run, error->message);
    run.reader->error->code = error->code;
    g_error_free (error);
  }
  return ok;
}

static gboolean
read_model (const QnJsonValue *root, const char *path, const char *model_path,
            QnStudy *study)
{
  const char *model = NULL;
  if (!qn_member_string (root, "model", QN_REQUIRED, &model))
    return FALSE;
  study->model = g_strdup (model);
  g_autofree char *folder = g_path_get_dirname (path);
  g_autofree char *beside = g_path_is_absolute (model) || strcmp (folder, ".") == 0
                              ? g_strdup (model)
                              : g_build_filename (folder, model, NULL);
  study->folder = g_path_get_dirname (model_path != NULL ? model_path : beside);
  return qn_project_load (model_path != NULL ? model_path : beside, NULL, &study->project,
                          &root->reader->error);
}

static gboolean
read_document (const QnJsonValue *root, const char *path, const char *model_path,
               QnStudy *study)
{
  static const char *const keys[] = { "format",      "version",    "title", "model",
                                      "run",         "parameters", "plan",  "outputs",
                                      "correlation", "limits",     "cracks" };
  const char *title = NULL;
  if (!qn_read_format (root, "quoin-study",
                       _ ("this is not a study: expected \"quoin-study\""))
      || !qn_json_value_check_keys (root, keys, G_N_ELEMENTS (keys))
      || !qn_member_string (root, "title", QN_OPTIONAL, &title)
      || !qn_member_choice (root, "run", QN_REQUIRED, qn_study_run_names,
                            QN_STUDY_RUN_COUNT, &study->run))
    return FALSE;
  study->title = g_strdup (title);
  return read_model (root, path, model_path, study) && check_run (root, study)
         && read_parameters (root, study) && read_plan (root, study)
         && read_correlation (root, study) && read_cracks (root, study)
         && read_outputs (root, study) && read_limits (root, study);
}

/* What the ground does belongs to a study in time. */
static gboolean
add_records (GChecksum *sum, const QnStudy *study, GError **error)
{
  for (gsize i = 0; i < qn_study_record_count (study); i++) {
    gsize length;
    g_autofree char *path =
      g_build_filename (study->folder, study->project.model.ground[i].record, NULL);
    g_autofree char *bytes = NULL;
    if (study->project.model.ground[i].kind != QN_SIGNAL_RECORD)
      continue;
    bytes = qn_file_read (path, &length, error);
    if (bytes == NULL)
      return FALSE;
    g_checksum_update (sum, (const guchar *) bytes, (gssize) length);
  }
  return TRUE;
}

gboolean
qn_study_read (const char *path, const char *model_path, QnStudy *study, GError **error)
{
  qn_study_init (study);
  /* Errors of GSL come back as values that are checked; it must not end the program. */
  gsl_set_error_handler_off ();
  study->name = g_strdup (path);
  study->text = qn_file_read (path, &study->length, error);
  if (study->text == NULL) {
    qn_study_clear (study);
    return FALSE;
  }
  QnReader reader = { .name = study->name,
                      .text = study->text,
                      .length = study->length,
                      .warnings = study->warnings,
                      .refuses_unknown = TRUE };
  cJSON *document =
    qn_json_parse (study->text, study->length, study->name, &reader.error);
  if (document != NULL) {
    QnJsonValue root = qn_json_value_root (&reader, document);
    read_document (&root, path, model_path, study);
  }
  cJSON_Delete (document);
  if (reader.error != NULL) {
    g_propagate_error (error, reader.error);
    qn_study_clear (study);
    return FALSE;
  }
  g_autoptr (GChecksum) sum = g_checksum_new (G_CHECKSUM_SHA256);
  g_checksum_update (sum, (const guchar *) study->text, (gssize) study->length);
  g_checksum_update (sum, (const guchar *) study->project.sha256, -1);
  if (!add_records (sum, study, error)) {
    qn_study_clear (study);
    return FALSE;
  }
  study->sha256 = g_strdup (g_checksum_get_string (sum));
  return TRUE;
}
