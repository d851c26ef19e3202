#include "io/project/project-masonry.h"
#include "io/project/project-parts.h"
#include "io/project/project.h"
#include "io/text/file-writer.h"
#include "io/text/json-text.h"

#include <cjson/cJSON.h>
#include <string.h>

/* ---- unknown members ---- */

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

/* By owner; NULL where there are none. */
static GHashTable *
index_inner (const QnProject *project)
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

static char *
entity_at (const QnModel *model, const QnList *list, size_t index)
{
  return G_STRUCT_MEMBER (char *, model, list->items) + index * list->size;
}

int32_t *
qn_list_note (const QnModel *model, const QnList *list, size_t index)
{
  return G_STRUCT_MEMBER_P (entity_at (model, list, index), list->note);
}

static void
append_entity (GString *json, const QnModel *model, GHashTable *inner, const QnList *list,
               size_t index)
{
  const char *entity = entity_at (model, list, index);
  const char *name = list->naming != QN_NAMING_NONE ? *(char *const *) entity : NULL;
  g_string_append_c (json, '{');
  if (name != NULL)
    qn_json_put_string (json, "name", name);
  if (list->append != NULL)
    list->append (json, model, index);
  else
    qn_members_write (json, list->members, model, entity, list->usual);
  g_string_append (json, " }");
  qn_json_append_note (json, inner, *qn_list_note (model, list, index));
}

void
qn_json_append_list (GString *json, const QnModel *model, GHashTable *inner,
                     const QnList *list)
{
  const size_t count = G_STRUCT_MEMBER (size_t, model, list->count);
  const char *key = list->path, *dot;
  int indent = 2;
  gboolean any = FALSE;
  for (; (dot = strchr (key, '.')) != NULL; key = dot + 1)
    indent += 2;
  for (size_t i = 0; i < count; i++) {
    if (list->is_left_out != NULL && list->is_left_out (model, i))
      continue;
    if (!any)
      g_string_append_printf (json, "%s%*s\"%s\": [", indent > 2 ? ",\n" : "", indent, "",
                              key);
    g_string_append_printf (json, "%s\n%*s", any ? "," : "", indent + 2, "");
    append_entity (json, model, inner, list, i);
    any = TRUE;
  }
  if (any)
    g_string_append (json, indent > 2 ? " ]" : " ],\n");
}

static gboolean
same_law (const QnModel *a, QnId law_a, const QnModel *b, QnId law_b)
{
  if (law_a == QN_NONE || law_b == QN_NONE)
    return law_a == law_b;
  return strcmp (a->laws[law_a].name, b->laws[law_b].name) == 0;
}

/* Whether two blocks are written alike. What the file says of a block besides is not compared. */
static gboolean
same_block (const QnModel *a, QnId id_a, const QnModel *b, QnId id_b)
{
  const QnBlock *x = &a->blocks[id_a], *y = &b->blocks[id_b];
  return strcmp (x->name, y->name) == 0 && x->note == 0 && y->note == 0
         && x->vertex_count == y->vertex_count && x->thickness == y->thickness
         && x->density == y->density
         && (x->density >= 0 || x->unit_weight == y->unit_weight)
         && memcmp (x->support, y->support, sizeof x->support) == 0
         && same_law (a, x->law, b, y->law) && x->ring == y->ring
         && same_law (a, x->ring_law, b, y->ring_law)
         && memcmp (qn_model_block_vertices (a, id_a), qn_model_block_vertices (b, id_b),
                    (gsize) x->vertex_count * sizeof (QnVec2))
              == 0;
}

/* Copies the text of an equal block. FALSE where there is none. */
static gboolean
append_same_block (GString *json, const QnModel *model, QnId id, const QnModel *like,
                   const QnProjectText *like_text)
{
  /* Mostly nothing before it has come or gone. */
  QnId same = id;
  if ((gsize) id >= like->block_count
      || strcmp (like->blocks[id].name, model->blocks[id].name) != 0)
    same = qn_model_find_block (like, model->blocks[id].name);
  if (same == QN_NONE || !same_block (model, id, like, same))
    return FALSE;
  const gsize *place = like_text->blocks[same];
  g_string_append_len (json, like_text->text + place[0], (gssize) (place[1] - place[0]));
  return place[1] > place[0];
}

/* Blocks of walls and of parametric masonry follow from these. */
static void
append_blocks (GString *json, const QnModel *model, GHashTable *inner,
               const QnProject *like, const QnProjectText *like_text, gsize (*places)[2])
{
  gboolean first = TRUE, known = like_text != NULL && like_text->blocks != NULL;
  g_string_append (json, "  \"blocks\": [");
  for (size_t i = 0; i < model->block_count; i++) {
    if (qn_block_list.is_left_out (model, i))
      continue;
    g_string_append (json, first ? "\n    " : ",\n    ");
    first = FALSE;
    places[i][0] = json->len;
    if (!known || !append_same_block (json, model, (QnId) i, &like->model, like_text))
      append_entity (json, model, inner, &qn_block_list, i);
    places[i][1] = json->len;
  }
  g_string_append (json, " ],\n");
}

/* The objects that were not detached, with their key; nothing where there are none. */
static void
append_masonry (GString *json, const QnProject *project, const cJSON *list)
{
  gboolean first = TRUE;
  QnId index = 0;
  for (const cJSON *item = list->child; item != NULL; item = item->next, index++) {
    if (!qn_project_has_masonry (project, index))
      continue;
    g_string_append (json, first ? ",\n  \"" QN_MASONRY_MEMBER "\": [\n    " : ",\n    ");
    qn_json_append_value (json, item, 4);
    first = FALSE;
  }
  g_string_append (json, first ? "" : " ]");
}

QnProjectText *
qn_project_write (const QnProject *project, const QnProject *like,
                  const QnProjectText *like_text)
{
  const QnModel *model = &project->model;
  GString *json =
    g_string_sized_new (like_text != NULL ? like_text->length + 4096 : 4096);
  QnProjectText *text = g_new0 (QnProjectText, 1);
  text->blocks = g_malloc0_n (model->block_count + 1, sizeof *text->blocks);
  g_string_append (json, "{\n  \"format\": \"quoin\", \"version\": 1,\n");
  if (model->title != NULL) {
    g_string_append (json, "  \"title\": ");
    qn_json_append_string (json, model->title);
    g_string_append (json, ",\n");
  }
  if (qn_model_has_density (model)) {
    g_string_append (json, "  \"gravity\": ");
    qn_json_append_number (json, model->gravity);
    g_string_append (json, ",\n");
  }
  GHashTable *inner = index_inner (project);
  if (model->law_count == 0)
    g_string_append (json, "  \"laws\": [ ],\n");
  qn_json_append_list (json, model, inner, &qn_law_list);
  append_blocks (json, model, inner, like, like_text, text->blocks);
  qn_json_append_list (json, model, inner, &qn_wall_list);
  qn_json_append_list (json, model, inner, &qn_section_list);
  qn_json_append_list (json, model, inner, &qn_node_list);
  qn_json_append_list (json, model, inner, &qn_beam_list);
  qn_project_append_contact (json, model, inner);
  qn_json_append_inner (json, inner, "contact");
  g_string_append (json, ",\n");
  qn_json_append_list (json, model, inner, &qn_bar_list);
  qn_json_append_list (json, model, inner, &qn_tie_list);
  qn_json_append_list (json, model, inner, &qn_vehicle_list);
  qn_project_append_loads (json, model, inner);
  qn_json_append_inner (json, inner, "loads");
  g_string_append (json, ",\n");
  qn_project_append_analysis (json, model, inner);
  qn_json_append_inner (json, inner, "analysis");
  g_clear_pointer (&inner, g_hash_table_unref);

  const cJSON *extra = project->extras != NULL ? project->extras->child : NULL;
  for (; extra != NULL; extra = extra->next) {
    if (g_strcmp0 (extra->string, QN_MASONRY_MEMBER) == 0) {
      append_masonry (json, project, extra);
    } else if (g_strcmp0 (extra->string, QN_INNER_MEMBER) != 0) {
      g_string_append (json, ",\n  ");
      qn_json_append_string (json, extra->string);
      g_string_append (json, ": ");
      qn_json_append_value (json, extra, 2);
    }
  }
  g_string_append (json, "\n}\n");
  text->length = json->len;
  text->text = g_string_free (json, FALSE);
  return text;
}

void
qn_project_text_free (QnProjectText *text)
{
  if (text == NULL)
    return;
  g_free (text->text);
  g_free (text->blocks);
  g_free (text);
}

char *
qn_project_to_text (const QnProject *project, gsize *length)
{
  QnProjectText *written = qn_project_write (project, NULL, NULL);
  char *text = g_steal_pointer (&written->text);
  if (length != NULL)
    *length = written->length;
  qn_project_text_free (written);
  return text;
}

gboolean
qn_project_save (const QnProject *project, const char *path, GError **error)
{
  gsize length;
  g_autofree char *text = qn_project_to_text (project, &length);
  return qn_file_write (path, text, length, error);
}

char *
qn_model_digest (const QnProject *project, const QnProjectText *text)
{
  QnProject bare = *project;
  const cJSON *masonry =
    cJSON_GetObjectItemCaseSensitive (project->extras, QN_MASONRY_MEMBER);
  bare.extras = NULL;
  if (masonry != NULL) /* of what is besides the model, this is what blocks follow from */
    qn_project_put_extra (&bare, QN_MASONRY_MEMBER, cJSON_Duplicate (masonry, 1));
  bare.model.title = NULL;
  /* Neither title nor sources change an answer. */
  g_autofree QnLaw *laws =
    g_memdup2 (bare.model.laws, bare.model.law_count * sizeof *laws);
  for (gsize i = 0; i < bare.model.law_count; i++)
    laws[i].source = NULL;
  bare.model.laws = laws;
  QnProjectText *canonical = qn_project_write (&bare, project, text);
  cJSON_Delete (bare.extras);
  char *digest = g_compute_checksum_for_data (
    G_CHECKSUM_SHA256, (const guchar *) canonical->text, canonical->length);
  qn_project_text_free (canonical);
  return digest;
}

char *
qn_structure_digest (const QnProject *project, const QnProjectText *text)
{
  QnModel fresh;
  QnProject bare = *project;
  qn_model_init (&fresh);
  bare.model.analysis = fresh.analysis;
  qn_model_clear (&fresh);
  return qn_model_digest (&bare, text);
}
