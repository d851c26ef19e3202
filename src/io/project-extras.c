#include "io/project-extras.h"

#include "io/io-error.h"

#include <cjson/cJSON.h>
#include <glib/gi18n.h>

cJSON *
qn_project_extras_with (const QnProject *project, const char *member, const char *json,
                        GError **error)
{
  cJSON *value = json != NULL ? cJSON_Parse (json) : NULL;
  if (json != NULL && value == NULL) {
    g_set_error (error, QN_IO_ERROR, QN_IO_ERROR_INVALID, _ ("%s: not JSON"), member);
    return NULL;
  }
  cJSON *extras = project->extras != NULL ? cJSON_Duplicate (project->extras, 1)
                                          : cJSON_CreateObject ();
  if (value == NULL)
    cJSON_DeleteItemFromObjectCaseSensitive (extras, member);
  else if (!cJSON_ReplaceItemInObjectCaseSensitive (extras, member, value))
    cJSON_AddItemToObject (extras, member, value);
  return extras;
}

void
qn_project_extras_free (cJSON *extras)
{
  cJSON_Delete (extras);
}

char *
qn_project_dup_extra (const QnProject *project, const char *member)
{
  const cJSON *value = cJSON_GetObjectItemCaseSensitive (project->extras, member);
  char *printed = value != NULL ? cJSON_PrintUnformatted (value) : NULL;
  char *json = g_strdup (printed);
  cJSON_free (printed);
  return json;
}
