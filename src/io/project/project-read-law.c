/* The laws of a project file. Which numbers a kind has is the law's own knowledge. */
#include "core/base/memory.h"
#include "io/project/project-read-parts.h"

#include <glib/gi18n-lib.h>
#include <string.h>

static gboolean
has_parameter (QnLawKind kind, const char *key)
{
  size_t count;
  const QnLawParameter *parameters = qn_law_parameters (kind, &count);
  for (size_t i = 0; i < count; i++)
    if (strcmp (parameters[i].key, key) == 0)
      return TRUE;
  return kind == QN_LAW_CURVE && strcmp (key, "points") == 0;
}

static gboolean
is_of_any_kind (const char *key)
{
  for (int kind = 0; kind < QN_LAW_KIND_COUNT; kind++)
    if (has_parameter ((QnLawKind) kind, key))
      return TRUE;
  return FALSE;
}

/* Keys of other kinds mean nothing to this one, keys of no kind nothing at all. */
static void
warn_of_keys (const QnJsonValue *place, QnLawKind kind)
{
  static const char *const common[] = { "name", "source", "kind",         "basis",
                                        "kn",   "ks",     "shear_factor", NULL };
  for (const cJSON *child = place->json->child; child != NULL; child = child->next) {
    if (g_strv_contains (common, child->string) || has_parameter (kind, child->string))
      continue;
    QnJsonValue member = qn_json_value_child (place, child);
    qn_json_value_warn (&member, is_of_any_kind (child->string)
                                   ? _ ("has no effect for this kind of law")
                                   : _ ("unknown key"));
    if (!is_of_any_kind (child->string))
      qn_json_value_keep_unknown (place, child);
  }
}

static gboolean
read_points (const QnJsonValue *place, QnLaw *law)
{
  QnJsonValue points, point = { 0 };
  if (!qn_member_array (place, "points", QN_REQUIRED, &points))
    return FALSE;
  if (cJSON_GetArraySize (points.json) > QN_MAX_CURVE_POINTS)
    return qn_json_value_fail (&points, _ (qn_problem_text (QN_PROBLEM_CURVE_COUNT)));

  while (qn_json_value_next (&points, &point)) {
    if (!qn_json_value_vec2 (&point, &law->points[law->point_count]))
      return FALSE;
    law->point_count++;
  }
  return TRUE;
}

static gboolean
read_parameters (const QnJsonValue *place, QnLaw *law)
{
  size_t count;
  const QnLawParameter *parameters = qn_law_parameters (law->kind, &count);
  for (size_t i = 0; i < count; i++) {
    const QnLawParameter *parameter = &parameters[i];
    if (!qn_member_number (
          place, parameter->key, parameter->required ? QN_REQUIRED : QN_OPTIONAL,
          parameter->positive ? QN_RANGE_POSITIVE : QN_RANGE_NOT_NEGATIVE,
          qn_law_at (law, parameter)))
      return FALSE;
  }
  return law->kind != QN_LAW_CURVE || read_points (place, law);
}

static gboolean
read_law (const QnJsonValue *place, QnModel *model)
{
  const char *name, *source = NULL;
  QnLawKind kind;
  QnBasis basis = QN_BASIS_CONTACT;
  if (!qn_json_value_object (place)
      || !qn_member_string (place, "name", QN_REQUIRED, &name)
      || !qn_member_string (place, "source", QN_OPTIONAL, &source)
      || !qn_member_choice (place, "kind", QN_REQUIRED, qn_law_kind_names,
                            QN_LAW_KIND_COUNT, &kind)
      || !qn_member_choice (place, "basis", QN_OPTIONAL, qn_basis_names, QN_BASIS_COUNT,
                            &basis))
    return FALSE;
  warn_of_keys (place, kind);

  if (name[0] == '\0') {
    QnJsonValue member = qn_json_value_member (place, "name");
    return qn_json_value_fail (&member, _ (qn_problem_text (QN_PROBLEM_NAME_MISSING)));
  }
  QnLaw *law = qn_model_add_law (model, name);
  if (law == NULL)
    return qn_json_value_no_memory (place);
  law->source = qn_strdup (source);
  if (law->source == NULL && source != NULL)
    return qn_json_value_no_memory (place);
  law->kind = kind;
  law->basis = basis;
  return qn_member_number (place, "kn", QN_REQUIRED, QN_RANGE_POSITIVE, &law->kn)
         && qn_member_number (place, "ks", QN_REQUIRED, QN_RANGE_POSITIVE, &law->ks)
         && qn_member_number (place, "shear_factor", QN_OPTIONAL, QN_RANGE_POSITIVE,
                              &law->shear_factor)
         && read_parameters (place, law);
}

gboolean
qn_read_laws (const QnJsonValue *root, QnNeed need, QnModel *model)
{
  if (!qn_read_each (root, "laws", need, read_law, model))
    return FALSE;
  QnJsonValue laws = qn_json_value_member (root, "laws");
  return model->law_count > 0 || need == QN_OPTIONAL
         || qn_json_value_fail (&laws, _ ("there must be at least one law"));
}

static gboolean
read_bar (const QnJsonValue *place, QnModel *model)
{
  static const char *const keys[] = { "law", "area", "start", "end" };
  if (!qn_json_value_object (place))
    return FALSE;
  qn_json_value_warn_unknown (place, keys, G_N_ELEMENTS (keys));

  QnBar *bar = qn_model_add_bar (model);
  if (bar == NULL)
    return qn_json_value_no_memory (place);
  return qn_read_name (place, "law", QN_REQUIRED, model, QN_NAMED_LAW, &bar->law)
         && qn_member_number (place, "area", QN_REQUIRED, QN_RANGE_POSITIVE, &bar->area)
         && qn_member_vec2 (place, "start", QN_REQUIRED, &bar->start)
         && qn_member_vec2 (place, "end", QN_REQUIRED, &bar->end);
}

gboolean
qn_read_bars (const QnJsonValue *root, QnModel *model)
{
  return qn_read_each (root, "bars", QN_OPTIONAL, read_bar, model);
}
