/* Every member of a project and of a result, one at a time, holds a value of another kind, or is left out.
 * A value of another kind is refused with its key path, and what is left out is a default or refused at a
 * place. */
#include "io/project/project.h"
#include "io/result/result-file.h"
#include "io/text/io-error.h"
#include "support/auto-clear.h"
#include "support/room.h"

#include <cjson/cJSON.h>
#include <stdio.h>
#include <string.h>

/* Of the folder tests/fuzz/corpus. */
static const char *const files[] = {
  "project/all-laws",
  "project/bars",
  "project/beams",
  "project/edge-loads",
  "project/every-key",
  "project/load-cases",
  "project/load-stages",
  "project/masonry-custom",
  "project/masonry-grid",
  "project/loads-of-all-kinds",
  "project/masonry-leaves",
  "project/masonry-others",
  "project/masonry-rubble",
  "project/masonry-wall",
  "project/masonry-voronoi",
  "project/rare-keys",
  "project/ties",
  "project/rocking-in-time",
  "result/beams",
  "result/found",
  "result/history",
  "result/result",
  "result/ties",
};

/* Members of any content, and those of results that follow from others: only `check` reads them. */
static const char *const free_members[] = { "view",
                                            "odd",
                                            "reason",
                                            "beams",
                                            "elements",
                                            "collapse_interval",
                                            "collapse_interval_ends",
                                            "stages",
                                            "mechanism_facts",
                                            "history",
                                            "ties",
                                            NULL };

typedef struct Walk {
  const char *name;
  cJSON *root;
  guint kinds, needed;
} Walk;

/* What the reader says, or NULL where it takes the text. */
static char *
dup_refusal (const Walk *walk)
{
  g_autoptr (GError) error = NULL;
  char *text = cJSON_PrintUnformatted (walk->root);
  if (g_str_has_prefix (walk->name, "result")) {
    g_auto (QnResultFile) file = { 0 };
    (void) qn_result_file_parse (text, strlen (text), "f", &file, &error);
  } else {
    g_auto (QnProject) project = { 0 };
    (void) qn_project_parse (text, strlen (text), "f", NULL, &project, &error);
  }
  cJSON_free (text);
  if (error == NULL)
    return NULL;
  g_assert_error (error, QN_IO_ERROR, QN_IO_ERROR_INVALID);
  return g_strdup (error->message);
}

static void
try_kind (Walk *walk, cJSON *item, const char *path)
{
  cJSON whole = *item;
  item->type = cJSON_IsBool (item) ? cJSON_Number : cJSON_True;
  item->child = NULL;
  item->valuedouble = 7;
  g_autofree char *message = dup_refusal (walk);
  g_autofree char *first = g_strndup (path, strcspn (path, ".[\n"));
  *item = whole;
  gboolean free_content = g_strv_contains (free_members, first);
  if (message == NULL && !free_content)
    g_error ("%s: another kind of value is accepted at %s", walk->name, path);
  /* Lists that go together are compared as a whole. */
  if (message != NULL && !free_content
      && strstr (message, g_str_has_prefix (path, "steps") ? "steps" : path) == NULL)
    g_error ("%s: %s: %s", walk->name, path, message);
  walk->kinds += message != NULL;
}

static void
try_without (Walk *walk, cJSON *item)
{
  char *key = item->string;
  guint line, column;
  item->string = (char *) "unknown";
  g_autofree char *message = dup_refusal (walk);
  item->string = key;
  if (message != NULL)
    g_assert_cmpint (sscanf (message, "f:%u:%u: ", &line, &column), ==, 2);
  walk->needed += message != NULL;
}

static void
walk_members (Walk *walk, cJSON *parent, const char *place)
{
  int index = 0;
  for (cJSON *item = parent->child; item != NULL; item = item->next, index++) {
    g_autofree char *path =
      item->string == NULL ? g_strdup_printf ("%s[%d]", place, index)
      : *place == '\0'     ? g_strdup (item->string)
                           : g_strdup_printf ("%s.%s", place, item->string);
    if (item->string == NULL && index > 1
        && !cJSON_IsObject (item)) /* like those before */
      continue;
    try_kind (walk, item, path);
    if (item->string != NULL)
      try_without (walk, item);
    walk_members (walk, item, path);
  }
}

static void
test_members (gconstpointer data)
{
  g_autofree char *path =
    g_build_filename (g_getenv ("G_TEST_SRCDIR"), "fuzz", "corpus", data, NULL);
  g_autofree char *text = NULL;
  g_assert_true (g_file_get_contents (path, &text, NULL, NULL));
  Walk walk = { .name = data, .root = cJSON_Parse (text) };
  walk_members (&walk, walk.root, "");
  cJSON_Delete (walk.root);
  g_assert_cmpuint (walk.kinds, >, 10);
  g_assert_cmpuint (walk.needed, >, 2);
}

QN_TESTS
{
  for (gsize i = 0; i < G_N_ELEMENTS (files); i++) {
    g_autofree char *path = g_strdup_printf ("/wrong-kinds/%s", files[i]);
    g_test_add_data_func (path, files[i], test_members);
  }
}
