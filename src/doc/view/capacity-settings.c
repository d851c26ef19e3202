#include "doc/view/capacity-settings.h"

#include "io/project/project-extras.h"
#include "io/project/project-members.h"

static const QnMember members[] = {
  QN_STRING ("control", OPTIONAL, QnCapacitySettings, control),
  QN_STRING ("spectrum", OPTIONAL, QnCapacitySettings, spectrum),
  QN_NUMBER ("ag", OPTIONAL, POSITIVE, QnCapacitySettings, ag),
  QN_STRING ("soil", OPTIONAL, QnCapacitySettings, soil),
  QN_NUMBER ("damping", OPTIONAL, POSITIVE, QnCapacitySettings, damping),
  QN_STRING ("unit", OPTIONAL, QnCapacitySettings, unit),
  QN_NUMBER ("confidence", OPTIONAL, POSITIVE, QnCapacitySettings, confidence),
  { 0 },
};

gboolean
qn_capacity_settings_read (const QnProject *project, QnCapacitySettings *settings,
                           GError **error)
{
  QnReader reader = qn_project_reader (project);
  *settings = (QnCapacitySettings){ 0 };
  QnJsonValue root = qn_json_value_root (&reader, project->extras);
  QnJsonValue place = qn_json_value_member (&root, QN_CAPACITY_MEMBER);
  if (place.json == NULL || qn_members_read (&place, members, NULL, settings))
    return TRUE;
  qn_capacity_settings_clear (settings);
  g_propagate_error (error, reader.error);
  return FALSE;
}

char *
qn_capacity_settings_to_json (const QnCapacitySettings *s)
{
  const QnCapacitySettings usual = { 0 };
  GString *json = g_string_new ("{");
  qn_members_write (json, members, NULL, s, &usual);
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
