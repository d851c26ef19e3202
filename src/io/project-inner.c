#include "io/project-inner.h"

#include "io/json-text.h"

#include <stdlib.h>
#include <string.h>

/* "blocks:base", or "analysis". */
static char *
dup_owner (const char *list, const char *name)
{
  return name != NULL ? g_strdup_printf ("%s:%s", list, name) : g_strdup (list);
}

/* Index in a path like "blocks[3]" where it leads to an element of that list; -1 otherwise. */
static gssize
element_of (const char *path, const char *list)
{
  gsize length = strlen (list);
  char *end;
  if (strncmp (path, list, length) != 0 || path[length] != '[')
    return -1;
  long index = strtol (path + length + 1, &end, 10);
  return strcmp (end, "]") == 0 ? (gssize) index : -1;
}

/* What the object at a path is called from now on; NULL where it is not kept. */
static char *
dup_owner_of_path (const QnModel *model, const char *path)
{
  static const char *const singles[] = { "contact", "loads", "analysis" };
  for (gsize i = 0; i < G_N_ELEMENTS (singles); i++)
    if (strcmp (path, singles[i]) == 0)
      return g_strdup (path);
  gssize index = element_of (path, "laws");
  if (index >= 0 && (gsize) index < model->law_count)
    return dup_owner ("laws", model->laws[index].name);
  index = element_of (path, "blocks");
  if (index >= 0 && (gsize) index < model->block_count)
    return dup_owner ("blocks", model->blocks[index].name);
  index = element_of (path, "walls");
  if (index >= 0 && (gsize) index < model->wall_count)
    return dup_owner ("walls", model->walls[index].name);
  return NULL;
}

gboolean
qn_project_keep_inner (QnProject *project, cJSON *unknown)
{
  cJSON *kept = unknown != NULL ? cJSON_CreateObject () : NULL;
  gboolean done = unknown == NULL || kept != NULL;
  while (done && unknown != NULL && unknown->child != NULL) {
    cJSON *members = cJSON_DetachItemViaPointer (unknown, unknown->child);
    char *owner = dup_owner_of_path (&project->model, members->string);
    if (owner != NULL)
      done = cJSON_AddItemToObject (kept, owner, members);
    if (owner == NULL || !done)
      cJSON_Delete (members);
    g_free (owner);
  }
  cJSON_Delete (unknown);
  if (done && kept != NULL && kept->child != NULL) {
    if (project->extras == NULL)
      project->extras = cJSON_CreateObject ();
    done = project->extras != NULL
           && cJSON_AddItemToObject (project->extras, QN_INNER_MEMBER, kept);
    if (done)
      kept = NULL;
  }
  cJSON_Delete (kept);
  return done;
}

gboolean
qn_project_has_inner_blocks (const QnProject *project)
{
  const cJSON *inner =
    cJSON_GetObjectItemCaseSensitive (project->extras, QN_INNER_MEMBER);
  for (const cJSON *owner = inner != NULL ? inner->child : NULL; owner != NULL;
       owner = owner->next)
    if (g_str_has_prefix (owner->string, "blocks:"))
      return TRUE;
  return FALSE;
}

GHashTable *
qn_project_index_inner (const QnProject *project)
{
  const cJSON *inner =
    cJSON_GetObjectItemCaseSensitive (project->extras, QN_INNER_MEMBER);
  if (inner == NULL)
    return NULL;
  GHashTable *index = g_hash_table_new (g_str_hash, g_str_equal);
  for (cJSON *owner = inner->child; owner != NULL; owner = owner->next)
    g_hash_table_insert (index, owner->string, owner);
  return index;
}

void
qn_json_append_inner (GString *json, GHashTable *inner, const char *owner,
                      const char *name)
{
  if (inner == NULL)
    return;
  char *key = dup_owner (owner, name);
  const cJSON *members = g_hash_table_lookup (inner, key);
  g_free (key);
  if (members == NULL)
    return;
  g_string_truncate (json, json->len - strlen (" }"));
  for (const cJSON *member = members->child; member != NULL; member = member->next) {
    qn_json_begin_member (json, member->string);
    qn_json_append_value (json, member, 6);
  }
  g_string_append (json, " }");
}
