#include "io/project/project-parts.h"

#include "io/text/json-text.h"

#include <string.h>

/* Objects that there is one of. */
static const char *const singles[] = { "contact",
                                       "contact.pairs",
                                       "loads",
                                       "analysis",
                                       "analysis.control",
                                       "analysis.dynamic",
                                       "analysis.dynamic.damping",
                                       NULL };

/* What owners with a note are called; no path of a member begins like this. */
#define NOTE "note:"

static char *
dup_note_owner (int32_t note)
{
  return g_strdup_printf (NOTE "%d", (int) note);
}

int32_t
qn_read_note (const QnJsonValue *place)
{
  QnReader *reader = place->reader;
  cJSON *owner =
    reader->owners != NULL ? g_hash_table_lookup (reader->owners, place->json) : NULL;
  if (owner == NULL)
    return 0;
  const int32_t note = ++reader->notes;
  g_free (owner->string);
  owner->string = dup_note_owner (note);
  return note;
}

void
qn_project_keep_inner (QnProject *project, QnReader *reader)
{
  cJSON *kept = g_steal_pointer (&reader->unknown);
  for (cJSON *owner = kept != NULL ? kept->child : NULL, *next; owner != NULL;
       owner = next) {
    next = owner->next;
    if (!g_str_has_prefix (owner->string, NOTE)
        && !g_strv_contains (singles, owner->string))
      cJSON_Delete (cJSON_DetachItemViaPointer (kept, owner));
  }
  g_clear_pointer (&reader->owners, g_hash_table_unref);
  if (kept != NULL && kept->child != NULL)
    qn_project_put_extra (project, QN_INNER_MEMBER, kept);
  else
    cJSON_Delete (kept);
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
qn_json_append_inner (GString *json, GHashTable *inner, const char *owner)
{
  const cJSON *members = inner != NULL ? g_hash_table_lookup (inner, owner) : NULL;
  if (members == NULL)
    return;
  g_string_truncate (json, json->len - strlen (" }"));
  for (const cJSON *member = members->child; member != NULL; member = member->next) {
    qn_json_begin_member (json, member->string);
    qn_json_append_value (json, member, 6);
  }
  g_string_append (json, " }");
}

void
qn_json_append_note (GString *json, GHashTable *inner, int32_t note)
{
  if (inner == NULL || note == 0)
    return;
  g_autofree char *owner = dup_note_owner (note);
  qn_json_append_inner (json, inner, owner);
}
