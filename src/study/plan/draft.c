#include "study/plan/draft.h"

#include "core/base/integer.h"
#include "core/base/word.h"
#include "io/json/json-value.h"
#include "io/text/file-read.h"
#include "io/text/file-writer.h"
#include "io/text/io-error.h"

#include <math.h>
#include <string.h>

/* Levels of a distribution where a plan needs some. */
#define USUAL_LEVELS 5
#define USUAL_COUNT  200

struct QnDraft {
  char *path;
  cJSON *tree;
  GPtrArray *steps; /* of char *: texts, the present one at `position` */
  guint position;
  char *saved; /* text of the file; NULL: none yet */
};

static cJSON *
member (const QnDraft *draft, const char *key)
{
  return cJSON_GetObjectItemCaseSensitive (draft->tree, key);
}

static cJSON *
parameter (const QnDraft *draft, guint index)
{
  return cJSON_GetArrayItem (member (draft, "parameters"), (int) index);
}

static void
set (cJSON *object, const char *key, cJSON *value)
{
  if (!cJSON_ReplaceItemInObjectCaseSensitive (object, key, value))
    cJSON_AddItemToObject (object, key, value);
}

/* The tree has changed: a step, unless it is as before. */
static void
record (QnDraft *draft)
{
  char *printed = cJSON_Print (draft->tree);
  char *text = g_strconcat (printed, "\n", NULL);
  cJSON_free (printed);
  if (draft->steps->len > 0
      && strcmp (text, g_ptr_array_index (draft->steps, draft->position)) == 0) {
    g_free (text);
    return;
  }
  if (draft->steps->len > 0)
    g_ptr_array_set_size (draft->steps, (int) draft->position + 1);
  g_ptr_array_add (draft->steps, text);
  draft->position = draft->steps->len - 1;
}

static QnDraft *
draft_of (const char *path, cJSON *tree)
{
  QnDraft *draft = g_new0 (QnDraft, 1);
  draft->path = g_strdup (path);
  draft->tree = tree;
  draft->steps = g_ptr_array_new_with_free_func (g_free);
  if (!cJSON_IsArray (member (draft, "parameters")))
    set (tree, "parameters", cJSON_CreateArray ());
  if (!cJSON_IsArray (member (draft, "outputs")))
    set (tree, "outputs", cJSON_CreateArray ());
  if (!cJSON_IsObject (member (draft, "plan")))
    set (tree, "plan", cJSON_CreateObject ());
  return draft;
}

static void
usual_outputs (QnDraft *draft, QnStudyRun run)
{
  static const QnAnalysisSettings settings = { .flow = QN_FLOW_ASSOCIATIVE };
  static const QnStudyOutput usual[] = {
    QN_STUDY_COLLAPSE_MULTIPLIER, QN_STUDY_ASSOCIATIVE_MULTIPLIER,
    QN_STUDY_COLLAPSED,           QN_STUDY_PEAK_DISPLACEMENT,
    QN_STUDY_MECHANISM_KIND,      QN_STUDY_MECHANISM_SHAPE,
    QN_STUDY_FREQUENCY_1
  };
  cJSON *outputs = cJSON_CreateArray ();
  for (gsize i = 0; i < G_N_ELEMENTS (usual); i++)
    if (qn_study_run_gives (run, &settings, usual[i]))
      cJSON_AddItemToArray (outputs,
                            cJSON_CreateString (qn_study_output_names[usual[i]]));
  set (draft->tree, "outputs", outputs);
}

QnDraft *
qn_draft_new (const char *path, const char *model, QnStudyRun run)
{
  cJSON *tree = cJSON_CreateObject ();
  set (tree, "format", cJSON_CreateString ("quoin-study"));
  set (tree, "version", cJSON_CreateNumber (1));
  set (tree, "model", cJSON_CreateString (model));
  set (tree, "run", cJSON_CreateString (qn_study_run_names[run]));
  QnDraft *draft = draft_of (path, tree);
  cJSON *plan = member (draft, "plan");
  set (plan, "kind", cJSON_CreateString (qn_plan_kind_names[QN_PLAN_LATIN_HYPERCUBE]));
  set (plan, "count", cJSON_CreateNumber (USUAL_COUNT));
  set (plan, "seed", cJSON_CreateNumber (1));
  usual_outputs (draft, run);
  record (draft);
  return draft;
}

QnDraft *
qn_draft_load (const char *path, GError **error)
{
  gsize length;
  g_autofree char *text = qn_file_read (path, &length, error);
  if (text == NULL)
    return NULL;
  cJSON *tree = qn_json_parse (text, length, path, error);
  if (!cJSON_IsObject (tree)) {
    if (tree != NULL)
      g_set_error (error, QN_IO_ERROR, QN_IO_ERROR_INVALID, "%s:1:1: {…}?", path);
    cJSON_Delete (tree);
    return NULL;
  }
  QnDraft *draft = draft_of (path, tree);
  record (draft);
  /* Its own layout is no change. */
  draft->saved = g_strdup (g_ptr_array_index (draft->steps, 0));
  return draft;
}

void
qn_draft_free (QnDraft *draft)
{
  if (draft == NULL)
    return;
  cJSON_Delete (draft->tree);
  g_ptr_array_unref (draft->steps);
  g_free (draft->saved);
  g_free (draft->path);
  g_free (draft);
}

static const char *
get_text (const QnDraft *draft)
{
  return g_ptr_array_index (draft->steps, draft->position);
}

gboolean
qn_draft_save (QnDraft *draft, GError **error)
{
  const char *text = get_text (draft);
  if (g_strcmp0 (text, draft->saved) == 0)
    return TRUE;
  if (!qn_file_write (draft->path, text, strlen (text), error))
    return FALSE;
  g_free (draft->saved);
  draft->saved = g_strdup (text);
  return TRUE;
}

gboolean
qn_draft_save_as (QnDraft *draft, const char *path, const char *model, GError **error)
{
  set (draft->tree, "model", cJSON_CreateString (model));
  g_ptr_array_set_size (draft->steps, 0);
  record (draft);
  g_free (draft->path);
  draft->path = g_strdup (path);
  g_clear_pointer (&draft->saved, g_free);
  return qn_draft_save (draft, error);
}

const char *
qn_draft_get_path (const QnDraft *draft)
{
  return draft->path;
}

gboolean
qn_draft_can_undo (const QnDraft *draft)
{
  return draft->position > 0;
}

gboolean
qn_draft_can_redo (const QnDraft *draft)
{
  return draft->position + 1 < draft->steps->len;
}

static void
go_to (QnDraft *draft, guint position)
{
  draft->position = position;
  cJSON_Delete (draft->tree);
  draft->tree = cJSON_Parse (get_text (draft));
}

void
qn_draft_undo (QnDraft *draft)
{
  if (qn_draft_can_undo (draft))
    go_to (draft, draft->position - 1);
}

void
qn_draft_redo (QnDraft *draft)
{
  if (qn_draft_can_redo (draft))
    go_to (draft, draft->position + 1);
}

/* ---- parameters ---- */

guint
qn_draft_count (const QnDraft *draft)
{
  return (guint) cJSON_GetArraySize (member (draft, "parameters"));
}

static double
number_at (const cJSON *object, const char *key)
{
  const cJSON *item = cJSON_GetObjectItemCaseSensitive (object, key);
  return cJSON_IsNumber (item) ? item->valuedouble : NAN;
}

static const char *
text_at (const cJSON *object, const char *key)
{
  return cJSON_GetStringValue (cJSON_GetObjectItemCaseSensitive (object, key));
}

static int
count_at (const cJSON *object, const char *key)
{
  double number = number_at (object, key);
  return isnan (number) ? 0 : (int) qn_to_integer (number, 0, QN_STUDY_MAX_CASES);
}

/* Distributions that a form shows, and the keys of their two numbers. */
static const struct {
  QnDistributionKind distribution;
  const char *first, *second;
} form_kinds[] = {
  [QN_DRAFT_UNIFORM] = { QN_DISTRIBUTION_UNIFORM, "min", "max" },
  [QN_DRAFT_NORMAL] = { QN_DISTRIBUTION_NORMAL, "mean", "deviation" },
  [QN_DRAFT_LOGNORMAL] = { QN_DISTRIBUTION_LOGNORMAL, "mean", "deviation" },
};

QnDraftParameter
qn_draft_parameter (const QnDraft *draft, guint index)
{
  const cJSON *item = parameter (draft, index);
  const cJSON *path = cJSON_GetObjectItemCaseSensitive (item, "path");
  const cJSON *range = cJSON_GetObjectItemCaseSensitive (item, "range");
  const cJSON *distribution = cJSON_GetObjectItemCaseSensitive (item, "distribution");
  const char *kind = text_at (distribution, "kind"), *name = text_at (item, "name");
  const char *first = cJSON_GetStringValue (cJSON_IsArray (path) ? path->child : path);
  QnDraftParameter result = { .name = name != NULL ? name : "",
                              .path = first != NULL ? first : "",
                              .kind = QN_DRAFT_OTHER,
                              .levels = count_at (item, "levels") };
  if (cJSON_GetArraySize (range) == 3) {
    result.kind = QN_DRAFT_RANGE;
    result.first = cJSON_GetNumberValue (range->child);
    result.second = cJSON_GetNumberValue (range->child->next);
    result.levels = (int) qn_to_integer (cJSON_GetNumberValue (range->child->next->next),
                                         0, QN_STUDY_MAX_VALUES);
    return result;
  }
  for (gsize i = 0; kind != NULL && i < G_N_ELEMENTS (form_kinds); i++) {
    if (strcmp (kind, qn_distribution_kind_names[form_kinds[i].distribution]) != 0)
      continue;
    result.first = number_at (distribution, form_kinds[i].first);
    result.second = number_at (distribution, form_kinds[i].second);
    if (isnan (result.second)) /* a normal one by its cov */
      result.second = number_at (distribution, "cov") * fabs (result.first);
    if (!isnan (result.first) && !isnan (result.second))
      result.kind = (QnDraftKind) i;
  }
  return result;
}

/* Of the standard normal distribution. */
#define FRACTILE_95 1.6448536269514722

static gboolean
has_limits (QnDraftKind kind)
{
  return kind == QN_DRAFT_UNIFORM || kind == QN_DRAFT_RANGE;
}

void
qn_draft_get_fractiles (const QnDraftParameter *parameter, double *low, double *high)
{
  QnDistribution lognormal = { 0 };
  *low = *high = NAN;
  if (has_limits (parameter->kind)) {
    *low = parameter->first;
    *high = parameter->second;
  } else if (parameter->kind == QN_DRAFT_NORMAL) {
    *low = parameter->first - FRACTILE_95 * parameter->second;
    *high = parameter->first + FRACTILE_95 * parameter->second;
  } else if (parameter->kind == QN_DRAFT_LOGNORMAL) {
    qn_distribution_set_lognormal (&lognormal, parameter->first, parameter->second);
    *low = exp (lognormal.first - FRACTILE_95 * lognormal.second);
    *high = exp (lognormal.first + FRACTILE_95 * lognormal.second);
  }
}

/* A name that no parameter has: the path's last key, then the path. */
static const char *
name_of (const QnDraft *draft, const char *path)
{
  const char *dot = strrchr (path, '.');
  const char *last = dot != NULL ? dot + 1 : path;
  for (guint i = 0; i < qn_draft_count (draft); i++)
    if (g_strcmp0 (text_at (parameter (draft, i), "name"), last) == 0)
      return path;
  return last;
}

gboolean
qn_draft_vary (QnDraft *draft, const char *path, double base, gboolean whole)
{
  double low = base - 0.1 * fabs (base), high = base + 0.1 * fabs (base);
  for (guint i = 0; i < qn_draft_count (draft); i++)
    if (strcmp (qn_draft_parameter (draft, i).path, path) == 0)
      return FALSE;
  cJSON *item = cJSON_CreateObject ();
  set (item, "name", cJSON_CreateString (name_of (draft, path)));
  set (item, "path", cJSON_CreateString (path));
  cJSON_AddItemToArray (member (draft, "parameters"), item);
  if (g_str_has_suffix (path, "seed")) {
    set (item, "whole", cJSON_CreateTrue ());
    low = 1;
    high = 1000;
  } else if (whole) {
    set (item, "whole", cJSON_CreateTrue ());
    low = fmin (floor (low), base - 1);
    low = base >= 1 ? fmax (low, 1) : low;
    high = fmax (ceil (high), base + 1);
  }
  guint added = qn_draft_count (draft) - 1;
  if (!(low < high)) {
    low = 0;
    high = 1;
  }
  qn_draft_set_values (draft, added, QN_DRAFT_UNIFORM, low, high, 0);
  return TRUE;
}

void
qn_draft_remove (QnDraft *draft, guint index)
{
  cJSON_DeleteItemFromArray (member (draft, "parameters"), (int) index);
  record (draft);
}

void
qn_draft_set_name (QnDraft *draft, guint index, const char *name)
{
  set (parameter (draft, index), "name", cJSON_CreateString (name));
  record (draft);
}

void
qn_draft_set_kind (QnDraft *draft, guint index, QnDraftKind kind)
{
  QnDraftParameter old = qn_draft_parameter (draft, index);
  double first = old.first, second = old.second, low, high;
  qn_draft_get_fractiles (&old, &low, &high);
  if (has_limits (kind)) {
    first = low;
    second = high;
  } else if (has_limits (old.kind) && kind == QN_DRAFT_LOGNORMAL && low > 0.0) {
    double mean = 0.5 * log (low * high),
           deviation = 0.5 * log (high / low) / FRACTILE_95;
    first = exp (mean + 0.5 * deviation * deviation);
    second = first * sqrt (expm1 (deviation * deviation));
  } else if (has_limits (old.kind)) {
    first = 0.5 * (low + high);
    second = 0.5 * (high - low) / FRACTILE_95;
  }
  qn_draft_set_values (draft, index, kind, first, second, old.levels);
}

void
qn_draft_set_values (QnDraft *draft, guint index, QnDraftKind kind, double first,
                     double second, int levels)
{
  g_return_if_fail (kind != QN_DRAFT_OTHER);
  cJSON *item = parameter (draft, index);
  int count;
  gboolean needed = qn_plan_is_by_levels (qn_draft_get_plan (draft, &count));
  static const char *const given[] = { "distribution", "values", "range", "levels" };
  for (gsize i = 0; i < G_N_ELEMENTS (given); i++)
    cJSON_DeleteItemFromObjectCaseSensitive (item, given[i]);
  if (levels <= 0 && (needed || kind == QN_DRAFT_RANGE))
    levels = USUAL_LEVELS;
  if (kind == QN_DRAFT_RANGE) {
    const double range[] = { first, second, levels };
    set (item, "range", cJSON_CreateDoubleArray (range, 3));
  } else {
    cJSON *distribution = cJSON_CreateObject ();
    const char *name = qn_distribution_kind_names[form_kinds[kind].distribution];
    set (distribution, "kind", cJSON_CreateString (name));
    set (distribution, form_kinds[kind].first, cJSON_CreateNumber (first));
    set (distribution, form_kinds[kind].second, cJSON_CreateNumber (second));
    set (item, "distribution", distribution);
    if (levels > 0)
      set (item, "levels", cJSON_CreateNumber (levels));
  }
  record (draft);
}

/* ---- plan, run, outputs ---- */

QnPlanKind
qn_draft_get_plan (const QnDraft *draft, int *count)
{
  const cJSON *plan = member (draft, "plan");
  const char *name = text_at (plan, "kind");
  *count = count_at (plan, "count");
  QnPlanKind kind = QN_PLAN_MONTE_CARLO;
  qn_find_word (name, qn_plan_kind_names, QN_PLAN_COUNT, &kind);
  return kind;
}

void
qn_draft_set_plan (QnDraft *draft, QnPlanKind kind, int count)
{
  cJSON *plan = member (draft, "plan");
  set (plan, "kind", cJSON_CreateString (qn_plan_kind_names[kind]));
  if (qn_plan_is_by_levels (kind))
    cJSON_DeleteItemFromObjectCaseSensitive (plan, "count");
  else
    set (plan, "count", cJSON_CreateNumber (count > 0 ? count : USUAL_COUNT));
  for (guint i = 0; qn_plan_is_by_levels (kind) && i < qn_draft_count (draft); i++) {
    cJSON *item = parameter (draft, i);
    if (cJSON_HasObjectItem (item, "distribution")
        && !cJSON_HasObjectItem (item, "levels"))
      set (item, "levels", cJSON_CreateNumber (USUAL_LEVELS));
  }
  record (draft);
}

QnStudyRun
qn_draft_get_run (const QnDraft *draft)
{
  const char *name = cJSON_GetStringValue (member (draft, "run"));
  QnStudyRun run = QN_STUDY_SOLVE;
  qn_find_word (name, qn_study_run_names, QN_STUDY_RUN_COUNT, &run);
  return run;
}

void
qn_draft_set_run (QnDraft *draft, QnStudyRun run)
{
  set (draft->tree, "run", cJSON_CreateString (qn_study_run_names[run]));
  usual_outputs (draft, run);
  record (draft);
}

static int
place_of (const QnDraft *draft, QnStudyOutput output)
{
  int place = 0;
  const cJSON *item;
  cJSON_ArrayForEach (item, member (draft, "outputs"))
  {
    if (g_strcmp0 (cJSON_GetStringValue (item), qn_study_output_names[output]) == 0)
      return place;
    place++;
  }
  return -1;
}

gboolean
qn_draft_has_output (const QnDraft *draft, QnStudyOutput output)
{
  return place_of (draft, output) >= 0;
}

void
qn_draft_set_output (QnDraft *draft, QnStudyOutput output, gboolean wanted)
{
  int place = place_of (draft, output);
  if (wanted && place < 0)
    cJSON_AddItemToArray (member (draft, "outputs"),
                          cJSON_CreateString (qn_study_output_names[output]));
  else if (!wanted && place >= 0)
    cJSON_DeleteItemFromArray (member (draft, "outputs"), place);
  record (draft);
}
