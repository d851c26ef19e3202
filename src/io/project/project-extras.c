#include "io/project/project-extras.h"

#include "io/json/json-parse.h"
#include "io/text/io-error.h"
#include "io/text/json-text.h"

#include <glib/gi18n-lib.h>
#include <string.h>

/* The value of a JSON text, or NULL with an error that starts with the member's name. */
cJSON *
qn_project_extras_with (const QnProject *project, const char *member, const char *json,
                        GError **error)
{
  cJSON *value = json != NULL ? qn_json_parse (json, strlen (json), member, error) : NULL;
  if (json != NULL && value == NULL)
    return NULL;

  cJSON *extras = project->extras != NULL ? cJSON_Duplicate (project->extras, 1)
                                          : cJSON_CreateObject ();
  gboolean done = extras != NULL;
  if (done && value == NULL)
    cJSON_DeleteItemFromObjectCaseSensitive (extras, member);
  else if (done)
    done = cJSON_ReplaceItemInObjectCaseSensitive (extras, member, value)
           || cJSON_AddItemToObject (extras, member, value);
  if (done)
    return extras;

  cJSON_Delete (value);
  cJSON_Delete (extras);
  g_set_error (error, QN_IO_ERROR, QN_IO_ERROR_NO_MEMORY, "%s: %s", member,
               _ ("not enough memory"));
  return NULL;
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
  if (value == NULL)
    return NULL;
  GString *json = g_string_new (NULL);
  qn_json_append_value (json, value, 0);
  return g_string_free (json, FALSE);
}
