#include "io/json/json-parse.h"

#include "io/json/json-locate.h"
#include "io/json/json-path.h"
#include "io/json/json-scan.h"
#include "io/text/io-error.h"

#include <glib/gi18n-lib.h>

/* Objects with more members than this find duplicate keys by a table. */
#define MANY_MEMBERS 32

/* An array or object that is not complete yet. */
typedef struct Frame {
  cJSON *container;
  char *key;   /* object: key whose value comes next, or NULL */
  gsize count; /* values so far */
  GHashTable *keys;
} Frame;

typedef struct Parser {
  QnJsonScanner scanner;
  cJSON *root;
  Frame frames[QN_JSON_MAX_DEPTH];
  guint depth;
  QnJsonProblem *problem;
} Parser;

static void
close_frame (Parser *parser)
{
  Frame *frame = &parser->frames[--parser->depth];
  g_free (frame->key);
  g_clear_pointer (&frame->keys, g_hash_table_unref);
}

static char *
dup_path (const Parser *parser)
{
  GString *path = g_string_new (NULL);
  for (guint i = 0; i < parser->depth; i++) {
    const Frame *frame = &parser->frames[i];
    if (frame->key != NULL)
      qn_json_path_append_key (path, frame->key);
    else if (cJSON_IsArray (frame->container))
      qn_json_path_append_index (path, frame->count);
  }
  return g_string_free (path, FALSE);
}

static gboolean
fail (Parser *parser, const char *message)
{
  parser->problem->message = message;
  parser->problem->offset = parser->scanner.start;
  parser->problem->path = dup_path (parser);
  return FALSE;
}

static gboolean
key_is_taken (Frame *frame)
{
  if (frame->count <= MANY_MEMBERS)
    return cJSON_GetObjectItemCaseSensitive (frame->container, frame->key) != NULL;
  if (frame->keys == NULL) {
    frame->keys = g_hash_table_new (g_str_hash, g_str_equal);
    for (const cJSON *child = frame->container->child; child != NULL; child = child->next)
      g_hash_table_add (frame->keys, child->string);
  }
  return g_hash_table_contains (frame->keys, frame->key);
}

static gboolean
take_key (Parser *parser)
{
  Frame *frame = &parser->frames[parser->depth - 1];
  frame->key = qn_json_dup_string (&parser->scanner);
  return !key_is_taken (frame) || fail (parser, _ ("key is given twice"));
}

/* Hands `value` (owned, NULL when out of memory) to the innermost container, and opens it where
 * it is a container itself. */
static gboolean
take_value (Parser *parser, cJSON *value)
{
  Frame *frame = parser->depth > 0 ? &parser->frames[parser->depth - 1] : NULL;
  gboolean kept = value != NULL;
  if (kept && frame == NULL)
    parser->root = value;
  else if (kept && frame->key != NULL)
    kept = cJSON_AddItemToObject (frame->container, frame->key, value);
  else if (kept)
    kept = cJSON_AddItemToArray (frame->container, value);
  if (!kept) {
    cJSON_Delete (value);
    parser->problem->no_memory = TRUE;
    return FALSE;
  }

  if (cJSON_IsObject (value) || cJSON_IsArray (value)) {
    parser->frames[parser->depth++] = (Frame){ .container = value };
  } else if (frame != NULL) {
    frame->count++;
    if (frame->keys != NULL)
      g_hash_table_add (frame->keys, value->string);
    g_clear_pointer (&frame->key, g_free);
  }
  return TRUE;
}

/* The container that ended is one more value of the one around it. */
static void
end_container (Parser *parser)
{
  close_frame (parser);
  if (parser->depth == 0)
    return;
  Frame *frame = &parser->frames[parser->depth - 1];
  frame->count++;
  if (frame->keys != NULL)
    g_hash_table_add (frame->keys, frame->container->child->prev->string);
  g_clear_pointer (&frame->key, g_free);
}

static cJSON *
create_string (const QnJsonScanner *scanner)
{
  char *text = qn_json_dup_string (scanner);
  cJSON *value = cJSON_CreateString (text);
  g_free (text);
  return value;
}

static gboolean
take_token (Parser *parser, QnJsonToken token)
{
  switch (token) {
  case QN_JSON_BEGIN_OBJECT:
    return take_value (parser, cJSON_CreateObject ());
  case QN_JSON_BEGIN_ARRAY:
    return take_value (parser, cJSON_CreateArray ());
  case QN_JSON_END_OBJECT:
  case QN_JSON_END_ARRAY:
    end_container (parser);
    return TRUE;
  case QN_JSON_KEY:
    return take_key (parser);
  case QN_JSON_STRING:
    return take_value (parser, create_string (&parser->scanner));
  case QN_JSON_NUMBER:
    return take_value (parser, cJSON_CreateNumber (qn_json_number (&parser->scanner)));
  case QN_JSON_TRUE:
  case QN_JSON_FALSE:
    return take_value (parser, cJSON_CreateBool (token == QN_JSON_TRUE));
  case QN_JSON_NULL:
    return take_value (parser, cJSON_CreateNull ());
  case QN_JSON_END:
  case QN_JSON_ERROR:
    break;
  }
  return fail (parser, parser->scanner.problem);
}

cJSON *
qn_json_parse (const char *text, gsize length, QnJsonProblem *problem)
{
  *problem = (QnJsonProblem){ .message = NULL };
  Parser parser = { .problem = problem };
  qn_json_scanner_init (&parser.scanner, text, length);

  gboolean going = TRUE;
  while (going && qn_json_next (&parser.scanner) != QN_JSON_END)
    going = take_token (&parser, parser.scanner.token);
  if (going)
    return parser.root;

  while (parser.depth > 0)
    close_frame (&parser);
  cJSON_Delete (parser.root);
  return NULL;
}

GError *
qn_json_problem_to_error (const QnJsonProblem *problem, const char *name,
                          const char *text)
{
  gsize line, column;
  if (problem->no_memory)
    return g_error_new (QN_IO_ERROR, QN_IO_ERROR_NO_MEMORY, "%s: %s", name,
                        _ ("not enough memory"));
  qn_json_position (text, problem->offset, &line, &column);
  gboolean inside = problem->path != NULL && problem->path[0] != '\0';
  return g_error_new (QN_IO_ERROR, QN_IO_ERROR_INVALID,
                      "%s:%" G_GSIZE_FORMAT ":%" G_GSIZE_FORMAT ": %s%s%s", name, line,
                      column, inside ? problem->path : "", inside ? ": " : "",
                      problem->message);
}
