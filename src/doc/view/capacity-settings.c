#include "doc/view/capacity-settings.h"

#include "io/project/project-extras.h"
#include "io/text/json-text.h"

static gboolean
read_members (const QnJsonValue *place, QnCapacitySettings *s)
{
  static const char *const keys[] = { "control", "spectrum",   "ag",  "soil",
                                      "damping", "confidence", "unit" };
  const char *control = NULL, *spectrum = NULL, *soil = NULL, *unit = NULL;
  if (!qn_json_value_object (place)
      || !qn_member_string (place, "control", QN_OPTIONAL, &control)
      || !qn_member_string (place, "spectrum", QN_OPTIONAL, &spectrum)
      || !qn_member_string (place, "soil", QN_OPTIONAL, &soil)
      || !qn_member_string (place, "unit", QN_OPTIONAL, &unit)
      || !qn_member_number (place, "ag", QN_OPTIONAL, QN_RANGE_POSITIVE, &s->ag)
      || !qn_member_number (place, "damping", QN_OPTIONAL, QN_RANGE_POSITIVE, &s->damping)
      || !qn_member_number (place, "confidence", QN_OPTIONAL, QN_RANGE_POSITIVE,
                            &s->confidence))
    return FALSE;
  qn_json_value_warn_unknown (place, keys, G_N_ELEMENTS (keys));
  s->control = g_strdup (control);
  s->spectrum = g_strdup (spectrum);
  s->soil = g_strdup (soil);
  s->unit = g_strdup (unit);
  return TRUE;
}

gboolean
qn_capacity_settings_read (const QnProject *project, QnCapacitySettings *settings,
                           GError **error)
{
  QnReader reader = qn_project_reader (project);
  *settings = (QnCapacitySettings){ 0 };
  QnJsonValue root = qn_json_value_root (&reader, project->extras);
  QnJsonValue place = qn_json_value_member (&root, QN_CAPACITY_MEMBER);
  if (place.json == NULL || read_members (&place, settings))
    return TRUE;
  g_propagate_error (error, reader.error);
  return FALSE;
}

static void
put_string (GString *json, const char *key, const char *text)
{
  if (text != NULL)
    qn_json_put_string (json, key, text);
}

static void
put_number (GString *json, const char *key, double number)
{
  if (number > 0)
    qn_json_put_number (json, key, number);
}

char *
qn_capacity_settings_to_json (const QnCapacitySettings *s)
{
  GString *json = g_string_new ("{");
  put_string (json, "control", s->control);
  put_string (json, "spectrum", s->spectrum);
  put_number (json, "ag", s->ag);
  put_string (json, "soil", s->soil);
  put_number (json, "damping", s->damping);
  put_string (json, "unit", s->unit);
  put_number (json, "confidence", s->confidence);
  g_string_append (json, " }");
  return g_string_free (json, FALSE);
}

void
qn_capacity_settings_clear (QnCapacitySettings *s)
{
  g_free (s->control);
  g_free (s->spectrum);
  g_free (s->soil);
  g_free (s->unit);
  *s = (QnCapacitySettings){ 0 };
}
