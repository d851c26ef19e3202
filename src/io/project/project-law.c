/* The laws of a project file. Which numbers a kind has is the law's own knowledge. */
#include "io/project/project-members.h"
#include "io/project/project-parts.h"
#include "io/text/json-text.h"

#include <glib/gi18n-lib.h>

static void
add_keys (GPtrArray *keys, QnLawKind kind)
{
  size_t count;
  const QnLawParameter *parameters = qn_law_parameters (kind, &count);
  for (size_t i = 0; i < count; i++)
    g_ptr_array_add (keys, (gpointer) parameters[i].key);
  if (kind == QN_LAW_CURVE)
    g_ptr_array_add (keys, (gpointer) "points");
  if (qn_law_may_bond (kind))
    g_ptr_array_add (keys, (gpointer) "softening");
}

/* Keys of other kinds mean nothing to this one, keys of no kind nothing at all. */
static gboolean
check_keys (const QnJsonValue *place, QnLawKind kind)
{
  static const char *const common[] = { "name",        "source",  "kind",
                                        "basis",       "kn",      "ks",
                                        "elasticity",  "poisson", "arrangement",
                                        "shear_factor" };
  g_autoptr (GPtrArray) keys = g_ptr_array_new ();
  for (gsize i = 0; i < G_N_ELEMENTS (common); i++)
    g_ptr_array_add (keys, (gpointer) common[i]);
  add_keys (keys, kind);
  const guint own = keys->len;
  for (int other = 0; other < QN_LAW_KIND_COUNT; other++)
    add_keys (keys, (QnLawKind) other);
  for (const cJSON *child = place->json->child; child != NULL; child = child->next) {
    guint index = 0;
    QnJsonValue member = qn_json_value_child (place, child);
    if (g_ptr_array_find_with_equal_func (keys, child->string, g_str_equal, &index)
        && index >= own
        && !qn_json_value_idle (&member, _ ("has no effect for this kind of law")))
      return FALSE;
  }
  return qn_json_value_check_keys (place, (const char *const *) keys->pdata, keys->len);
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
  int softening = 0;
  if (qn_law_may_bond (law->kind)
      && !qn_member_choice (place, "softening", QN_OPTIONAL, qn_law_softening_names,
                            G_N_ELEMENTS (qn_law_softening_names), &softening))
    return FALSE;
  law->exponential = softening == 1;
  return law->kind != QN_LAW_CURVE
         || qn_member_rows (place, "points", QN_REQUIRED, 2, QN_MAX_CURVE_POINTS,
                            &law->points[0].x, &law->point_count);
}

/* Either stiffnesses, or the elasticity of a material from which they follow. */
static gboolean
read_stiffness (const QnJsonValue *place, QnLaw *law)
{
  QnJsonValue elasticity = qn_json_value_member (place, "elasticity");
  const gboolean derived = elasticity.json != NULL;
  static const char *const ours[] = { "poisson", "arrangement" }, *const theirs[] = {
    "kn", "ks"
  };
  for (gsize i = 0; i < G_N_ELEMENTS (ours); i++) {
    QnJsonValue member = qn_json_value_member (place, derived ? theirs[i] : ours[i]);
    if (member.json != NULL)
      return qn_json_value_fail (
        &member, derived ? _ ("elasticity excludes kn and ks")
                         : _ ("this belongs to elasticity, which is missing"));
  }
  if (!derived)
    return qn_member_number (place, "kn", QN_REQUIRED, QN_RANGE_POSITIVE, &law->kn)
           && qn_member_number (place, "ks", QN_REQUIRED, QN_RANGE_POSITIVE, &law->ks);
  if (law->basis != QN_BASIS_MATERIAL)
    return qn_json_value_fail (&elasticity,
                               _ ("elasticity needs the basis \"material\""));
  if (!qn_json_value_number (&elasticity, QN_RANGE_POSITIVE, &law->elasticity)
      || !qn_member_number (place, "poisson", QN_OPTIONAL, QN_RANGE_NOT_NEGATIVE,
                            &law->poisson)
      || !qn_member_choice (place, "arrangement", QN_OPTIONAL, qn_arrangement_names,
                            QN_ARRANGEMENT_COUNT, &law->arrangement))
    return FALSE;
  qn_law_derive (law);
  return TRUE;
}

/* A joint that opens has no energy of its own, and none of slip. */
static void
warn_of_brittle (const QnJsonValue *place, const QnLaw *law)
{
  QnJsonValue shear = qn_json_value_member (place, "fracture_energy_shear");
  if (law->fracture_energy_shear > 0 && !(law->fracture_energy_tension > 0)
      && law->tension > 0 && (law->cohesion > 0 || law->friction == 0))
    qn_json_value_warn (&shear,
                        _ ("counts in compression alone: a joint that opens loses "
                           "its bond at once without fracture_energy_tension"));
}

static const QnMember law_members[] = {
  QN_STRING ("source", OPTIONAL, QnLaw, source),
  QN_CHOICE ("kind", REQUIRED, qn_law_kind_names, QnLaw, kind),
  QN_CHOICE ("basis", WRITTEN, qn_basis_names, QnLaw, basis),
  { 0 },
};

static gboolean
read_law (const QnJsonValue *place, QnModel *model, gpointer entity)
{
  QnLaw *law = entity;
  if (!qn_members_take (place, law_members, model, law) || !check_keys (place, law->kind)
      || !read_stiffness (place, law)
      || !qn_member_number (place, "shear_factor", QN_OPTIONAL, QN_RANGE_POSITIVE,
                            &law->shear_factor)
      || !read_parameters (place, law))
    return FALSE;
  warn_of_brittle (place, law);
  return TRUE;
}

/* Parameters that are left out by default are left out where they have no effect. */
static void
append_law (GString *json, const QnModel *model, size_t index)
{
  const QnLaw *law = &model->laws[index];
  size_t count;
  const QnLawParameter *parameters = qn_law_parameters (law->kind, &count);
  qn_members_write (json, law_members, model, law, NULL);
  if (law->elasticity > 0) {
    qn_json_put_number (json, "elasticity", law->elasticity);
    qn_json_put_number (json, "poisson", law->poisson);
    qn_json_put_string (json, "arrangement", qn_arrangement_names[law->arrangement]);
  } else {
    qn_json_put_number (json, "kn", law->kn);
    qn_json_put_number (json, "ks", law->ks);
  }
  qn_json_put_unusual (json, "shear_factor", law->shear_factor, 0);
  for (size_t i = 0; i < count; i++) {
    double value = qn_law_get (law, &parameters[i]);
    if (value != 0 || !parameters[i].positive)
      qn_json_put_number (json, parameters[i].key, value);
  }
  if (law->exponential && qn_law_may_bond (law->kind))
    qn_json_put_string (json, "softening", qn_law_softening_names[1]);
  if (law->kind == QN_LAW_CURVE)
    qn_json_put_points (json, "points", law->points, (gsize) law->point_count);
}

const QnList qn_law_list = { QN_LIST ("laws", QnLaw, laws, law_count),
                             .naming = QN_NAMING_REQUIRED, .read = read_law,
                             .append = append_law };
