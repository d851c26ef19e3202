#include "app/forms/form.h"

#include "core/base/integer.h"
#include "doc/view/pair-text.h"

int
qn_value_int (const QnValue *value)
{
  return (int) qn_to_integer (value->number, 0, G_MAXINT32);
}

void
qn_value_take_row (QnValue *value, char *row)
{
  const guint count = value->row_count++;
  if ((count & (count + 1)) == 0) /* room for twice as many */
    value->rows = g_renew (char *, value->rows, 2 * count + 2);
  value->rows[count] = row;
  value->rows[count + 1] = NULL;
}

void
qn_value_add_row (QnValue *value, const char *row)
{
  qn_value_take_row (value, g_strdup (row));
}

void
qn_value_set_icon (QnValue *value, const char *icon)
{
  value->icons = g_renew (const char *, value->icons, value->row_count);
  value->icons[value->row_count - 1] = icon;
}

void
qn_value_set_laws (QnValue *value, const QnModel *model, const char *first, QnId law)
{
  if (first != NULL)
    qn_value_add_row (value, first);
  for (gsize i = 0; i < model->law_count; i++)
    qn_value_add_row (value, model->laws[i].name);
  value->number = law == QN_NONE ? 0 : law + (first != NULL ? 1 : 0);
}

QnId
qn_value_get_law (const QnValue *value)
{
  return value->number > 0.0 ? (QnId) value->number - 1 : QN_NONE;
}

void
qn_value_set_sections (QnValue *value, const QnModel *model, QnId section)
{
  for (gsize i = 0; i < model->section_count; i++)
    qn_value_add_row (value, model->sections[i].name);
  value->number = section != QN_NONE ? section : 0;
}

gboolean
qn_value_set_pairs (QnValue *value, const QnModel *model, const QnPairRule *rule,
                    QnId law, QnPairField field)
{
  const gboolean given = rule->placement == QN_PLACEMENT_EXPLICIT;
  switch (field) {
  case QN_PAIRS_PLACEMENT:
    value->number = rule->placement;
    return TRUE;
  case QN_PAIRS_OFFSET:
    value->number = rule->offset;
    return rule->placement <= QN_PLACEMENT_LOBATTO;
  case QN_PAIRS_COUNT:
    value->number = qn_pair_rule_shown_count (rule, model, law);
    return rule->placement >= QN_PLACEMENT_LOBATTO && !given;
  case QN_PAIRS_POSITIONS: /* without any those of the ends are there to start from */
    value->text = qn_pair_rule_dup_positions (rule);
    return given;
  case QN_PAIRS_WEIGHTS:
    value->text = qn_pair_rule_dup_weights (rule);
    return given;
  }
  return TRUE;
}

void
qn_value_clear (QnValue *value)
{
  g_free (value->text);
  g_strfreev (value->rows);
  g_free (value->icons);
}
