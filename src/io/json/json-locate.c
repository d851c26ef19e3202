#include "io/json/json-locate.h"

#include "io/json/json-path.h"
#include "io/json/json-tokens.h"

#include <stdlib.h>
#include <string.h>

/* Moves from the place of one offset to that of a later one. */
static void
advance (const char *text, gsize from, gsize to, QnJsonPlace *place)
{
  for (const char *c; (c = memchr (text + from, '\n', to - from)) != NULL;) {
    from = (gsize) (c - text) + 1;
    *place = (QnJsonPlace){ place->line + 1, 1 };
  }
  for (; from < to; from++)
    place->column += ((guchar) text[from] & 0xc0) != 0x80; /* not inside a character */
}

void
qn_json_position (const char *text, gsize offset, gsize *line, gsize *column)
{
  QnJsonPlace place = { 1, 1 };
  advance (text, 0, offset, &place);
  *line = place.line;
  *column = place.column;
}

/* The element of an array that was found last, of each of the first steps of a path: what follows it is
 * not searched from the first. */
#define REMEMBERED_STEPS 8

typedef struct Found {
  gsize array, index, at;
} Found;

static gsize
find_element (const QnJson *json, gsize array, gsize index, Found *found)
{
  if (json->tokens[array].type != QN_JSON_ARRAY)
    return 0;
  if (found->at == 0 || found->array != array || found->index > index)
    *found = (Found){ array, 0, array + 1 };
  while (found->index < index && found->at < json->tokens[array].next) {
    found->at = json->tokens[found->at].next;
    found->index++;
  }
  return found->at < json->tokens[array].next ? found->at : 0;
}

/* The value that a path leads to, or the last one on its way. */
static gsize
follow (const QnJson *json, const char *path, Found *found)
{
  gsize at = 0;
  GArray *steps = qn_json_path_parse (path);
  for (guint i = 0; steps != NULL && i < steps->len; i++) {
    const QnJsonStep *step = &g_array_index (steps, QnJsonStep, i);
    gsize next = step->key != NULL ? qn_json_member (json, at, step->key)
                                   : find_element (json, at, step->index,
                                                   &found[MIN (i, REMEMBERED_STEPS - 1)]);
    if (next == 0)
      break;
    at = next;
  }
  if (steps != NULL)
    g_array_unref (steps);
  return at;
}

typedef struct Wanted {
  gsize offset;
  guint path;
} Wanted;

static int
compare_offsets (const void *a, const void *b)
{
  const Wanted *v = a, *w = b;
  return (v->offset > w->offset) - (v->offset < w->offset);
}

QnJsonPlace *
qn_json_locate_all (const char *text, gsize length, const GPtrArray *paths)
{
  QnJson json;
  Found found[REMEMBERED_STEPS] = { 0 };
  gboolean scanned = qn_json_scan (&json, text, length, "");
  g_autofree Wanted *wanted = g_new (Wanted, paths->len + 1);
  for (guint i = 0; i < paths->len; i++) {
    gsize at = scanned ? follow (&json, paths->pdata[i], found) : 0;
    wanted[i] = (Wanted){ scanned ? json.tokens[at].start : 0, i };
  }
  qn_json_clear (&json);
  qsort (wanted, paths->len, sizeof *wanted, compare_offsets);

  QnJsonPlace *places = g_new (QnJsonPlace, paths->len + 1), place = { 1, 1 };
  for (guint i = 0; i < paths->len; i++) {
    advance (text, i > 0 ? wanted[i - 1].offset : 0, wanted[i].offset, &place);
    places[wanted[i].path] = place;
  }
  return places;
}

QnJsonPlace
qn_json_locate (const char *text, gsize length, const char *path)
{
  gpointer items[] = { (gpointer) path };
  const GPtrArray paths = { items, 1 };
  g_autofree QnJsonPlace *places = qn_json_locate_all (text, length, &paths);
  return places[0];
}
