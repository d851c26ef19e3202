#include "io/project/block-lines.h"

#include "io/project/project-inner.h"

#include <string.h>

#define HEAD   "\n  \"blocks\": [\n"
#define INDENT "    "

/* ---- finding ---- */

/* Blocks that the file lists, in its order: those of walls and of masonry follow from these. */
static void
rank_blocks (QnBlockLines *lines, const QnModel *model)
{
  lines->blocks = g_new (QnId, model->block_count + 1);
  lines->lines = g_new (QnId, model->block_count + 1);
  for (gsize i = 0; i < model->block_count; i++) {
    gboolean listed =
      model->blocks[i].wall == QN_NONE && model->blocks[i].masonry == QN_NONE;
    lines->lines[i] = listed ? (QnId) lines->count : QN_NONE;
    if (listed)
      lines->blocks[lines->count++] = (QnId) i;
  }
}

/* Starts of `count` lines that hold one object each, the last of them ending the list. */
static gboolean
find_starts (QnBlockLines *lines, const char *text)
{
  const char *at = strstr (text, HEAD), *end = text + lines->length;
  if (at == NULL)
    return FALSE;
  at += strlen (HEAD);
  for (gsize i = 0; i < lines->count; i++) {
    const char *newline = memchr (at, '\n', (gsize) (end - at));
    if (newline == NULL || strncmp (at, INDENT "{", strlen (INDENT "{")) != 0)
      return FALSE;
    lines->starts[i] = at + strlen (INDENT);
    gboolean last = i + 1 == lines->count;
    gboolean closes = newline - at > 4 && strncmp (newline - 4, "} ],", 4) == 0;
    if (closes != last || (!last && strncmp (newline - 2, "},", 2) != 0))
      return FALSE;
    at = newline + 1;
  }
  lines->starts[lines->count] = at;
  return TRUE;
}

gboolean
qn_block_lines_find (QnBlockLines *lines, const QnProject *project, const char *text)
{
  if (qn_project_has_inner_blocks (project))
    return FALSE;
  *lines = (QnBlockLines){ .project = project, .length = strlen (text) };
  rank_blocks (lines, &project->model);
  lines->starts = g_new (const char *, lines->count + 1);
  if (lines->count > 0 && find_starts (lines, text))
    return TRUE;
  qn_block_lines_clear (lines);
  return FALSE;
}

void
qn_block_lines_clear (QnBlockLines *lines)
{
  g_free (lines->starts);
  g_free (lines->blocks);
  g_free (lines->lines);
  *lines = (QnBlockLines){ 0 };
}

const char *
qn_block_lines_get (const QnBlockLines *lines, gsize line, gsize *length)
{
  const char *start = lines->starts[line], *newline = lines->starts[line + 1];
  gboolean last = line + 1 == lines->count;
  newline -= last ? 1 : 1 + strlen (INDENT);
  *length = (gsize) (newline - start) - (last ? strlen (" ],") : strlen (","));
  return start;
}

/* ---- writing ---- */

static gboolean
same_law (const QnModel *a, QnId law_a, const QnModel *b, QnId law_b)
{
  if (law_a == QN_NONE || law_b == QN_NONE)
    return law_a == law_b;
  return strcmp (a->laws[law_a].name, b->laws[law_b].name) == 0;
}

static gboolean
same_block (const QnModel *a, QnId id_a, const QnModel *b, QnId id_b)
{
  const QnBlock *x = &a->blocks[id_a], *y = &b->blocks[id_b];
  return x->vertex_count == y->vertex_count && x->thickness == y->thickness
         && x->density == y->density
         && (x->density >= 0 || x->unit_weight == y->unit_weight)
         && memcmp (x->support, y->support, sizeof x->support) == 0
         && same_law (a, x->law, b, y->law)
         && memcmp (qn_model_block_vertices (a, id_a), qn_model_block_vertices (b, id_b),
                    (gsize) x->vertex_count * sizeof (QnVec2))
              == 0;
}

gboolean
qn_block_lines_append_same (GString *json, const QnBlockLines *lines,
                            const QnModel *model, QnId block)
{
  const QnModel *like = &lines->project->model;
  /* Mostly nothing before it has come or gone. */
  QnId same = (gsize) block < like->block_count
                  && strcmp (like->blocks[block].name, model->blocks[block].name) == 0
                ? block
                : qn_model_find_block (like, model->blocks[block].name);
  if (same == QN_NONE || lines->lines[same] == QN_NONE
      || !same_block (model, block, like, same))
    return FALSE;
  gsize length;
  const char *line = qn_block_lines_get (lines, (gsize) lines->lines[same], &length);
  g_string_append_len (json, line, (gssize) length);
  return TRUE;
}
