/* Reading a text that differs little from one that was read before. */
#include "io/json/json-parse.h"
#include "io/project/block-lines.h"
#include "io/project/project-read-parts.h"

#include <string.h>

/* Of more changed lines than this part of all, reading everything is as quick. */
#define MOST_CHANGED 4

typedef struct Difference {
  QnBlockLines before;
  GArray *lines;   /* of gsize: which differ */
  cJSON *document; /* { "blocks": [ the new ones ] } */
} Difference;

static void
difference_clear (Difference *d)
{
  qn_block_lines_clear (&d->before);
  g_clear_pointer (&d->lines, g_array_unref);
  cJSON_Delete (d->document);
}

/* Adds a changed line: an object that can be read. */
static gboolean
add_line (Difference *d, gsize number, const char *line, gsize length)
{
  QnJsonProblem problem;
  cJSON *block = qn_json_parse (line, length, &problem);
  g_free (problem.path);
  if (block == NULL
      || !cJSON_AddItemToArray (cJSON_GetObjectItem (d->document, "blocks"), block)) {
    cJSON_Delete (block);
    return FALSE;
  }
  g_array_append_val (d->lines, number);
  return TRUE;
}

/* One line of the new text against one of the old. `at` moves to the next line. */
static gboolean
compare_line (Difference *d, gsize number, const char **at, const char *end)
{
  gsize length;
  const char *old = qn_block_lines_get (&d->before, number, &length);
  const char *newline = memchr (*at, '\n', (gsize) (end - *at));
  gboolean last = number + 1 == d->before.count;
  const char *tail = last ? "} ]," : "},";
  gsize indent = 4, close = strlen (tail);
  if (newline == NULL || (gsize) (newline - *at) < indent + close + 1
      || strncmp (newline - close, tail, close) != 0 || (*at)[indent] != '{')
    return FALSE;
  gsize new_length = (gsize) (newline - *at) - indent - close + 1;
  const char *line = *at + indent;
  *at = newline + 1;
  return (new_length == length && memcmp (line, old, length) == 0)
         || add_line (d, number, line, new_length);
}

/* Everything but lines of blocks must be equal. */
static gboolean
compare (Difference *d, const char *text, gsize length, const char *like_text)
{
  gsize head = (gsize) (d->before.starts[0] - like_text);
  const char *rest = d->before.starts[d->before.count], *end = text + length;
  if (length < head || memcmp (text, like_text, head) != 0)
    return FALSE;
  const char *at = text + head - 4; /* the line's indentation */
  for (gsize i = 0; i < d->before.count; i++)
    if (!compare_line (d, i, &at, end)
        || d->lines->len * MOST_CHANGED > d->before.count + MOST_CHANGED)
      return FALSE;
  return strcmp (at, rest) == 0;
}

/* ---- reading ---- */

/* Names of laws are all that a block needs to know of them. */
static gboolean
copy_laws (const QnModel *like, QnModel *scratch)
{
  scratch->gravity = like->gravity;
  for (gsize i = 0; i < like->law_count; i++)
    if (qn_model_add_law (scratch, like->laws[i].name) == NULL)
      return FALSE;
  return TRUE;
}

/* Blocks of the same names in place of those that they were. */
static gboolean
put_blocks (const Difference *d, const QnModel *scratch, QnModel *model)
{
  for (gsize i = 0; i < d->lines->len; i++) {
    QnId id = d->before.blocks[g_array_index (d->lines, gsize, i)];
    const QnBlock *from = &scratch->blocks[i];
    QnBlock *to = &model->blocks[id];
    if (g_strcmp0 (from->name, to->name) != 0 || from->vertex_count != to->vertex_count)
      return FALSE;
    to->thickness = from->thickness;
    to->unit_weight = from->unit_weight;
    to->density = from->density;
    to->law = from->law;
    memcpy (to->support, from->support, sizeof to->support);
    memcpy (model->vertices + to->first_vertex,
            qn_model_block_vertices (scratch, (QnId) i),
            (gsize) to->vertex_count * sizeof (QnVec2));
  }
  return TRUE;
}

/* The changed blocks as a model of their own; FALSE where anything is wrong or unknown. */
static gboolean
read_changed (const Difference *d, const QnModel *like, QnModel *scratch)
{
  GPtrArray *warnings = g_ptr_array_new_with_free_func (g_free);
  QnReader reader = { .name = "", .warnings = warnings };
  QnJsonValue root = qn_json_value_root (&reader, d->document);
  gboolean done = copy_laws (like, scratch)
                  && qn_read_blocks (&root, QN_REQUIRED, scratch) && warnings->len == 0
                  && reader.error == NULL && scratch->block_count == d->lines->len;
  g_clear_error (&reader.error);
  cJSON_Delete (reader.unknown);
  g_ptr_array_unref (warnings);
  return done;
}

static gboolean
read_model (const Difference *d, const QnModel *like, QnModel *model)
{
  QnModel scratch;
  qn_model_init (&scratch);
  gboolean done = read_changed (d, like, &scratch);
  if (done && qn_model_copy (like, model, NULL) == QN_OK) {
    done = put_blocks (d, &scratch, model) && qn_model_prepare (model, NULL) == QN_OK;
    if (!done)
      qn_model_clear (model);
  } else
    done = FALSE;
  qn_model_clear (&scratch);
  return done;
}

/* What a project has besides its model. */
static gboolean
fill_project (QnProject *project, const char *text, gsize length, const char *name,
              const QnProject *like)
{
  project->extras = like->extras != NULL ? cJSON_Duplicate (like->extras, TRUE) : NULL;
  if (like->extras != NULL && project->extras == NULL)
    return FALSE;
  project->name = g_strdup (name);
  project->text = g_strndup (text, length);
  project->text_length = length;
  project->sha256 =
    g_compute_checksum_for_data (G_CHECKSUM_SHA256, (const guchar *) text, length);
  for (guint i = 0; like->warnings != NULL && i < like->warnings->len; i++)
    g_ptr_array_add (project->warnings, g_strdup (g_ptr_array_index (like->warnings, i)));
  return TRUE;
}

gboolean
qn_project_parse_like (const char *text, gsize length, const char *name,
                       const QnProject *like, const char *like_text, QnProject *project)
{
  Difference d = { 0 };
  if (!qn_block_lines_find (&d.before, like, like_text))
    return FALSE;
  d.lines = g_array_new (FALSE, FALSE, sizeof (gsize));
  d.document = cJSON_CreateObject ();
  gboolean done = d.document != NULL
                  && cJSON_AddArrayToObject (d.document, "blocks") != NULL
                  && compare (&d, text, length, like_text) && d.lines->len > 0;
  qn_project_init (project);
  if (done) {
    qn_model_clear (&project->model);
    done = read_model (&d, &like->model, &project->model);
  }
  done = done && fill_project (project, text, length, name, like);
  if (!done)
    qn_project_clear (project);
  difference_clear (&d);
  return done;
}
