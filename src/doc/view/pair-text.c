#include "doc/view/pair-text.h"

#include "core/contact/pair-abscissae.h"
#include "doc/edit/edit.h"
#include "doc/text/units.h"

#include <glib/gi18n-lib.h>
#include <math.h>

/* Numbers between these characters; -1 where one cannot be read or there are more than `most`. */
static int
parse_numbers (const char *text, const char *between, double *values, int most,
               GError **error)
{
  g_auto (GStrv) words = g_strsplit_set (text, between, -1);
  int count = 0;
  for (gsize i = 0; words[i] != NULL; i++) {
    if (*words[i] == '\0')
      continue;
    if (count == most) {
      qn_edit_refuse (error, _ ("There are too many contact pairs at given positions"));
      return -1;
    }
    if (!qn_units_parse (QN_UNITS_SI, QN_QUANTITY_NUMBER, words[i], &values[count++],
                         error))
      return -1;
  }
  return count;
}

static int
parse_list (const char *text, double *values, GError **error)
{
  return parse_numbers (text, "; \t", values, QN_MAX_EXPLICIT_PAIRS, error);
}

gboolean
qn_pair_rule_parse (QnPairRule *rule, const char *positions, const char *weights,
                    GError **error)
{
  QnPairRule draft = *rule;
  draft.placement = QN_PLACEMENT_EXPLICIT;
  draft.count = parse_list (positions, draft.positions, error);
  if (draft.count < 0)
    return FALSE;
  if (draft.count == 0) {
    draft.count = 2;
    draft.positions[0] = 0.0;
    draft.positions[1] = 1.0;
  }
  int given = parse_list (weights, draft.weights, error);
  if (given < 0)
    return FALSE;
  if (given != 0 && given != draft.count)
    return qn_edit_refuse (error,
                           _ ("There must be a weight for each contact pair, or none"));
  double sum = 0.0;
  for (int i = 0; i < draft.count; i++) {
    if (given == 0)
      draft.weights[i] = 1.0;
    sum += draft.weights[i];
  }
  for (int i = 0; i < draft.count; i++)
    draft.weights[i] /= sum;
  *rule = draft;
  return TRUE;
}

int
qn_pair_rule_shown_count (const QnPairRule *rule, const QnModel *model, QnId law)
{
  return law == QN_NONE ? MAX (rule->count, 1)
                        : MAX (qn_pair_rule_by_law (rule, &model->laws[law]).count, 1);
}

char *
qn_pair_rule_dup_text (const QnPairRule *rule, const QnLaw *law, QnUnits units)
{
  static const char *const texts[QN_PLACEMENT_COUNT] = {
    [QN_PLACEMENT_ENDS] = N_ ("at the ends"),
    [QN_PLACEMENT_LOBATTO] = N_ ("at Gauss–Lobatto points"),
    [QN_PLACEMENT_UNIFORM] = N_ ("evenly spaced"),
    [QN_PLACEMENT_GAUSS] = N_ ("at Gauss points"),
    [QN_PLACEMENT_EXPLICIT] = N_ ("at given places"),
  };
  const QnPairRule own = qn_pair_rule_by_law (rule, law);
  GString *text = g_string_new (NULL);
  g_string_append_printf (text, _ ("%d per joint, %s"), (int) qn_pair_rule_count (&own),
                          _ (texts[own.placement]));
  if (own.offset > 0 && own.placement <= QN_PLACEMENT_LOBATTO) {
    g_autofree char *offset =
      qn_units_format_full (units, QN_QUANTITY_LENGTH, own.offset, 4);
    g_string_append_printf (text, _ (", the outer ones %s from the corners"), offset);
  }
  return g_string_free (text, FALSE);
}

static char *
dup_list (const QnPairRule *rule, const double *values)
{
  return qn_units_format_list (
    QN_UNITS_SI, QN_QUANTITY_NUMBER, values,
    rule->placement == QN_PLACEMENT_EXPLICIT ? (gsize) rule->count : 0, 6);
}

char *
qn_pair_rule_dup_positions (const QnPairRule *rule)
{
  return dup_list (rule, rule->positions);
}

char *
qn_pair_rule_dup_weights (const QnPairRule *rule)
{
  for (int i = 1; i < rule->count; i++)
    if (ABS (rule->weights[i] - rule->weights[0]) > 1e-12)
      return dup_list (rule, rule->weights);
  return g_strdup ("");
}

gboolean
qn_points_parse (const char *text, QnVec2 *points, int32_t most, int32_t *count)
{
  g_auto (GStrv) parts = g_strsplit (text, ";", -1);
  *count = 0;
  for (gsize i = 0; parts[i] != NULL; i++) {
    if (*g_strstrip (parts[i]) == '\0')
      continue;
    double place[2];
    if (*count == most || parse_numbers (parts[i], " \t", place, 2, NULL) != 2
        || !isfinite (place[0]) || !isfinite (place[1]))
      return FALSE;
    points[(*count)++] = qn_vec2 (place[0], place[1]);
  }
  return *count > 0;
}

char *
qn_points_dup_text (const QnVec2 *points, int32_t count)
{
  GString *text = g_string_new (NULL);
  for (int32_t i = 0; i < 2 * count; i++) {
    const QnVec2 at = points[i / 2];
    g_autofree char *number =
      qn_units_format (QN_UNITS_SI, QN_QUANTITY_NUMBER, i % 2 == 0 ? at.x : at.y, 9);
    g_string_append_printf (text, "%s%s", i == 0 ? "" : i % 2 == 0 ? "; " : " ", number);
  }
  return g_string_free (text, FALSE);
}
