/* Curves read off results. */
#include "render/figure/curve-plot.h"

#include <glib.h>
#include <math.h>
#include <string.h>

/* The step from which the path, or that of the last stage, first loses stability: the first that comes up to the
 * multiplier that the analysis reports, or the one before it goes beyond. Further on a path that descends
 * from its peak stays below. */
static ptrdiff_t
find_limit_point (const QnResult *result)
{
  double limit = result->first_limit_multiplier;
  const QnPathEvent *buckling = qn_result_find_buckling (result);

  if (buckling != NULL)
    return qn_result_buckling_step (result, buckling);
  if (!qn_result_has_felt_limit (result))
    return -1;
  double blur = 1e-9 * fabs (limit) + 1e-12;
  for (size_t s = 0; s < result->step_count; s++)
    if (result->stage > 0 && result->steps[s].stage == result->stage
        && fabs (result->steps[s].multiplier - limit) <= blur)
      return (ptrdiff_t) s;
    else if (result->stage == 0 && result->steps[s].multiplier >= limit - blur)
      return (ptrdiff_t) s - (result->steps[s].multiplier > limit + blur);
  return (ptrdiff_t) result->step_count - 1;
}

static ptrdiff_t
find_collapse (const QnResult *result)
{
  for (size_t s = result->step_count; s-- > 0;)
    if (result->steps[s].event == QN_EVENT_COLLAPSE)
      return (ptrdiff_t) s;
  return -1;
}

bool
qn_curve_shares_axes (const QnCurve *a, const QnCurve *b)
{
  if (a->in_time != b->in_time || a->settles != b->settles)
    return false;
  return a->in_time || a->settles
         || (g_strcmp0 (a->loads, b->loads) == 0
             && (a->bodies != b->bodies || g_strcmp0 (a->loaded, b->loaded) == 0));
}

/* The load sets that the last stage of a result drives, a bit each; 1: live loads. */
static uint32_t
driven_sets (const QnModel *model, const QnResult *result)
{
  bool staged = result->stage > 0 && (size_t) result->stage <= model->stage_count;
  return staged ? model->stages[result->stage - 1].sets : 1;
}

/* Adds a word to a list in order, once. */
static void
add_word (GPtrArray *words, char *word)
{
  guint i = 0;
  while (i < words->len && strcmp (words->pdata[i], word) < 0)
    i++;
  if (i < words->len && strcmp (words->pdata[i], word) == 0)
    g_free (word);
  else
    g_ptr_array_insert (words, (gint) i, word);
}

static char *
dup_words (GPtrArray *words)
{
  g_ptr_array_add (words, NULL);
  return g_strjoinv ("\n", (char **) words->pdata);
}

static bool
sums_up (QnLoadKind kind)
{
  return kind == QN_LOAD_WEIGHT || kind == QN_LOAD_FORCE || kind == QN_LOAD_NODE;
}

/* Loads on the weight and forces are summed up; of distributed ones what is given counts, not what it
 * comes to on this structure. */
static void
describe_loads (QnCurve *curve, const QnModel *model, uint32_t sets)
{
  g_autoptr (GPtrArray) loads = g_ptr_array_new_with_free_func (g_free),
                        loaded = g_ptr_array_new_with_free_func (g_free);
  double sums[QN_LOAD_KIND_COUNT][3] = { { 0 } };
  for (size_t i = 0; i < model->live_load_count; i++) {
    const QnLoad *l = &model->live_loads[i];
    const double f = qn_model_load_factor (model, l), *q = l->intensity;
    if ((sets >> l->set & 1) == 0 || f == 0)
      continue;
    sums[l->kind][0] += f * l->vector.x;
    sums[l->kind][1] += f * l->vector.y;
    sums[l->kind][2] += f * l->moment;
    if (l->kind == QN_LOAD_FORCE || l->kind == QN_LOAD_EDGE)
      add_word (loaded, g_strdup (model->blocks[l->block].name));
    else if (l->kind == QN_LOAD_NODE)
      add_word (loaded, g_strdup (model->nodes[l->node].name));
    else if (l->kind == QN_LOAD_LINE)
      add_word (loaded, g_strdup (model->beams[l->beam].name));
    if (!sums_up (l->kind))
      add_word (loads,
                g_strdup_printf ("%d %d %.6g %.6g %.6g %.6g %.6g %.6g %.6g", l->kind,
                                 l->side, f * l->vector.x, f * l->vector.y, f * q[0],
                                 f * q[1], f * l->pressure, f * l->unit_weight,
                                 qn_load_earth_coefficient (l)));
  }
  for (int k = 0; k < QN_LOAD_KIND_COUNT; k++)
    if (sums_up ((QnLoadKind) k))
      add_word (loads, g_strdup_printf ("%d %.6g %.6g %.6g", k, sums[k][0] + 0.0,
                                        sums[k][1] + 0.0, sums[k][2] + 0.0));
  curve->loads = dup_words (loads);
  curve->loaded = dup_words (loaded);
  curve->bodies = model->block_count + model->node_count;
}

void
qn_curve_from_result (QnCurve *curve, const QnModel *model, const QnResult *result,
                      QnCurveMotion motion)
{
  bool shown =
    motion.body != QN_NONE && (size_t) motion.body < qn_result_body_count (result);
  size_t count = shown ? result->step_count : 0;

  *curve = (QnCurve){ .limit_point = -1,
                      .collapse_point = -1,
                      .dot = -1,
                      .component = qn_dof_names[motion.dof],
                      .rotation = motion.dof == QN_DOF_RZ,
                      .in_time = result->history.width > 0 };
  const QnLoad *settlement = qn_result_settlement (model, result);
  const uint32_t sets = driven_sets (model, result);
  int set = 0;
  while (set + 1 < QN_MAX_LOAD_SETS && (sets >> set & 1) == 0)
    set++;
  describe_loads (curve, model, sets);
  curve->settles = settlement != NULL;
  if (set > 0 && !curve->settles && (size_t) set <= model->load_set_count)
    curve->set = g_strdup (model->load_sets[set - 1]);
  curve->x = g_new (double, MAX (count, 1));
  curve->y = g_new (double, MAX (count, 1));
  curve->count = count;
  if (model->analysis.geometry == QN_GEOMETRY_LINEAR && !curve->rotation) {
    QnBox box = qn_box_of_points (model->vertices, model->vertex_count);
    curve->size = fmax (box.max.x - box.min.x, box.max.y - box.min.y);
  }
  for (size_t s = 0; s < count; s++) {
    double u = qn_curve_motion_at (result, motion, s);
    curve->x[s] = curve->in_time ? result->steps[s].time : u;
    double factors[QN_MAX_LOAD_SETS] = { 0 };
    qn_result_load_factors (model, result, s, factors);
    curve->y[s] = curve->in_time ? u
                  : curve->settles
                    ? qn_result_settlement_reaction (model, result, settlement, s)
                  : result->stage > 0 ? factors[set]
                                      : result->steps[s].multiplier;
  }
  if (count == 0)
    return;
  QnCurveMotion total = { motion.body, motion.dof, false };
  curve->since_dead = motion.since_dead && qn_curve_motion_at (result, total, 0) != 0;
  curve->limit_point = curve->settles ? -1 : find_limit_point (result);
  curve->collapse_point = find_collapse (result);
}

/* Share of the peak from which on a multiplier counts as the peak. */
#define AT_PEAK 0.995

/* A path may end in one long step along its mechanism, in which the multiplier grows to so many
 * times what it was. */
#define LAST_STEP 1.03

/* A motion counts as unlimited where it exceeds so many times the displacement at the peak, and is
 * drawn up to this many times. */
#define RUNAWAY     4.0
#define BEYOND_PEAK 1.6

/* Of a motion in linear geometry that exceeds the structure so many of its sizes are drawn. */
#define SHOWN_SIZE 0.25

/* End of the informative part of a curve: a displacement a little beyond the peak, if from there on the
 * multiplier is constant while the displacement grows many times; a part of the size of the structure, if
 * a motion in linear geometry exceeds it. False: show the whole curve, for example one that descends from
 * its peak. */
static bool
find_end (const QnCurve *curve, double *end)
{
  double peak = 0, before = 0, at_peak = 0, farthest = 0;
  size_t first = 0;
  if (curve->in_time || curve->settles)
    return false;
  for (size_t i = 0; i < curve->count; i++) {
    double x = curve->x[i] - curve->x[0];
    if (curve->size > 0 && fabs (x) > curve->size) {
      *end = curve->x[0] + copysign (SHOWN_SIZE * curve->size, x);
      return true;
    }
    before = peak;
    peak = fmax (peak, curve->y[i]);
  }
  if (peak <= LAST_STEP * before)
    peak = before;
  while (first < curve->count && !(curve->y[first] >= AT_PEAK * peak))
    first++;
  if (!(peak > 0))
    return false;
  for (size_t i = 0; i < curve->count; i++) {
    if (i > first && curve->y[i] < AT_PEAK * peak)
      return false;
    if (i <= first)
      at_peak = fmax (at_peak, fabs (curve->x[i] - curve->x[0]));
    else if (fabs (curve->x[i] - curve->x[0]) > fabs (farthest))
      farthest = curve->x[i] - curve->x[0];
  }
  *end = curve->x[0] + copysign (BEYOND_PEAK * at_peak, farthest);
  return at_peak > 0 && fabs (farthest) > RUNAWAY * at_peak;
}

/* Moves the first point beyond x = edge back onto it, and ends the curve there. */
static void
cut_at (QnCurve *curve, size_t beyond, double edge)
{
  double share =
    (edge - curve->x[beyond - 1]) / (curve->x[beyond] - curve->x[beyond - 1]);
  curve->y[beyond] =
    curve->y[beyond - 1] + share * (curve->y[beyond] - curve->y[beyond - 1]);
  curve->x[beyond] = edge;
  curve->count = beyond + 1;
}

void
qn_curve_cut (QnCurve *curve, double until)
{
  size_t i = 0;
  while (i < curve->count && fabs (curve->x[i]) <= until)
    i++;
  if (until <= 0 || i == 0 || i == curve->count)
    return;
  cut_at (curve, i, copysign (until, curve->x[i]));
  if (curve->limit_point >= (ptrdiff_t) i)
    curve->limit_point = -1;
  if (curve->collapse_point >= (ptrdiff_t) i)
    curve->collapse_point = -1;
}

void
qn_curve_cut_runaway (QnCurve *curve)
{
  double end = 0;
  if (!find_end (curve, &end))
    return;
  size_t i = 1;
  while (fabs (curve->x[i] - curve->x[0]) <= fabs (end - curve->x[0]))
    i++;
  cut_at (curve, i, end);
  ptrdiff_t *marks[] = { &curve->limit_point, &curve->collapse_point, &curve->dot };
  for (size_t k = 0; k < G_N_ELEMENTS (marks); k++)
    *marks[k] = MIN (*marks[k], (ptrdiff_t) i);
  curve->runs_on = true;
}

bool
qn_reference_line_parse (const char *text, QnReferenceLine *line)
{
  char *end;
  line->y = g_ascii_strtod (text, &end);
  line->label = *end == '=' ? end + 1 : NULL;
  return end != text && (*end == '\0' || *end == '=') && isfinite (line->y);
}

void
qn_curve_clear (QnCurve *curve)
{
  g_free (curve->x);
  g_free (curve->y);
  g_free (curve->set);
  g_free (curve->loads);
  g_free (curve->loaded);
  *curve = (QnCurve){ .limit_point = -1, .collapse_point = -1, .dot = -1 };
}
