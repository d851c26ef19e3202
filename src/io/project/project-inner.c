#include "io/project/project-inner.h"

#include "io/json/json-path.h"
#include "io/project/project-parts.h"
#include "io/text/json-text.h"

#include <stdlib.h>
#include <string.h>

/* Objects that there is one of. */
static const char *const singles[] = {
  "contact",          "contact.pairs",           "loads", "analysis", "analysis.control",
  "analysis.dynamic", "analysis.dynamic.damping"
};

/* Index in a path like "blocks[3]" where it leads to an element of that list; -1 otherwise. */
static gssize
element_of (const char *path, const char *list, gsize count)
{
  gsize length = strlen (list);
  char *end;
  if (strncmp (path, list, length) != 0 || path[length] != '[')
    return -1;
  long index = strtol (path + length + 1, &end, 10);
  return strcmp (end, "]") == 0 && index >= 0 && (gsize) index < count ? (gssize) index
                                                                       : -1;
}

/* Where the loads of every set begin in the model, which was read set by set. */
typedef struct LoadStarts {
  gsize at[QN_MAX_LOAD_SETS + 1];
} LoadStarts;

/* The note of a load that is not dead. */
static int32_t *
note_of_live_load (QnModel *model, const LoadStarts *starts, const char *path)
{
  for (int32_t set = 0; set <= (int32_t) model->load_set_count; set++) {
    g_autoptr (GString) list = g_string_new (set == 0 ? "loads" : "loads.sets");
    qn_json_path_append_key (list, qn_model_load_set_name (model, set));
    gsize first = starts->at[set], count = starts->at[set + 1] - first;
    gssize index = element_of (path, list->str, count);
    if (index >= 0)
      return &model->live_loads[first + (gsize) index].note;
  }
  return NULL;
}

/* The note of what a path leads to; NULL where it is no entity. */
static int32_t *
note_of_path (QnModel *m, const LoadStarts *starts, const char *path)
{
  static const QnList dead =
    QN_LIST ("loads.dead", NULL, NULL, NULL, QnLoad, dead_loads, dead_load_count);
  const QnList *const lists[] = {
    &qn_law_list,  &qn_block_list, &qn_wall_list,   &qn_section_list, &qn_node_list,
    &qn_beam_list, &qn_bar_list,   &qn_tie_list,    &qn_vehicle_list, &qn_face_list,
    &dead,         &qn_stage_list, &qn_ground_list, &qn_initial_list, &qn_track_list,
  };
  for (gsize i = 0; i < G_N_ELEMENTS (lists); i++) {
    gssize index =
      element_of (path, lists[i]->path, G_STRUCT_MEMBER (size_t, m, lists[i]->count));
    if (index >= 0)
      return qn_list_note (m, lists[i], (gsize) index);
  }
  return note_of_live_load (m, starts, path);
}

static char *
dup_note_owner (int32_t note)
{
  return g_strdup_printf ("note:%d", (int) note);
}

/* What the object at a path is called from now on; NULL where it is not kept. An entity that had
 * no note gets one of this number. */
static char *
dup_owner_of_path (QnModel *model, const LoadStarts *starts, const char *path,
                   int32_t number)
{
  for (gsize i = 0; i < G_N_ELEMENTS (singles); i++)
    if (strcmp (path, singles[i]) == 0)
      return g_strdup (path);
  int32_t *note = note_of_path (model, starts, path);
  if (note == NULL)
    return NULL;
  *note = number;
  return dup_note_owner (number);
}

void
qn_project_keep_inner (QnProject *project, cJSON *unknown)
{
  cJSON *kept = cJSON_CreateObject ();
  int32_t number = 0;
  LoadStarts starts = { { 0 } };
  for (gsize i = 0; i < project->model.live_load_count; i++)
    starts.at[project->model.live_loads[i].set + 1]++;
  for (int set = 0; set < QN_MAX_LOAD_SETS; set++)
    starts.at[set + 1] += starts.at[set];
  while (unknown != NULL && unknown->child != NULL) {
    cJSON *members = cJSON_DetachItemViaPointer (unknown, unknown->child);
    g_autofree char *owner =
      dup_owner_of_path (&project->model, &starts, members->string, ++number);
    if (owner != NULL)
      cJSON_AddItemToObject (kept, owner, members);
    else
      cJSON_Delete (members);
  }
  cJSON_Delete (unknown);
  if (kept->child != NULL)
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
