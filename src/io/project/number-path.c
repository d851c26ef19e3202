#include "io/project/number-path.h"

#include "io/json/json-path.h"

#include <cjson/cJSON.h>
#include <math.h>

typedef struct Difference {
  GString *path; /* where the walk is */
  double value;  /* that was asked for */
  char
    *found; /* of the first number that differs, rather one that has the value; owned */
  double before;
  gboolean has_value; /* found has */
  guint count;        /* of what differs, but for … */
  guint companions;   /* … numbers that were not there and have another value */
} Difference;

static void compare (Difference *difference, const cJSON *before, const cJSON *after);

static void
compare_keys (Difference *difference, const cJSON *walked, const cJSON *before,
              const cJSON *after, gboolean new_keys)
{
  const cJSON *member;
  cJSON_ArrayForEach (member, walked)
  {
    gsize length = difference->path->len;
    const cJSON *b = cJSON_GetObjectItemCaseSensitive (before, member->string);
    if (new_keys && b != NULL)
      continue;
    qn_json_path_append (difference->path, member->string, 0);
    compare (difference, b, cJSON_GetObjectItemCaseSensitive (after, member->string));
    g_string_truncate (difference->path, length);
  }
}

/* A member that is written only where it is not as usual may be missing on one side. */
static void
compare (Difference *difference, const cJSON *before, const cJSON *after)
{
  const cJSON *there = after != NULL ? after : before;
  gboolean same_type =
    before == NULL || after == NULL || (before->type & 0xff) == (after->type & 0xff);
  if (!same_type) {
    difference->count++;
  } else if (cJSON_IsObject (there)) {
    compare_keys (difference, before, before, after, FALSE);
    compare_keys (difference, after, before, after, TRUE);
  } else if (cJSON_IsArray (there) && before != NULL && after != NULL) {
    const cJSON *b = before->child, *a = after->child;
    for (gsize i = 0; b != NULL && a != NULL; i++, b = b->next, a = a->next) {
      gsize length = difference->path->len;
      qn_json_path_append (difference->path, NULL, i);
      compare (difference, b, a);
      g_string_truncate (difference->path, length);
    }
    difference->count += b != NULL || a != NULL;
  } else if (!cJSON_Compare (before, after, TRUE)) {
    gboolean number = cJSON_IsNumber (there);
    gboolean has_value =
      number && after != NULL && after->valuedouble == difference->value;
    difference->count += !number || has_value || before != NULL || after == NULL;
    difference->companions += number && !has_value && before == NULL && after != NULL;
    if (number && (difference->found == NULL || (has_value && !difference->has_value))) {
      g_free (difference->found);
      difference->found = g_strdup (difference->path->str);
      difference->before = before != NULL ? before->valuedouble : NAN;
      difference->has_value = has_value;
    }
  }
}

/* Members that no analysis looks at. */
static gboolean
is_of_drawing (const char *path)
{
  static const char *const members[] = { "underlay", "guides", "view",      "figures",
                                         "history",  "report", "run_names", NULL };
  for (const char *const *member = members; *member != NULL; member++)
    if (qn_json_path_is_within (path, *member))
      return TRUE;
  return FALSE;
}

char *
qn_number_path_find (const char *before, const char *after, double value, double *number)
{
  Difference difference = { .path = g_string_new (NULL), .value = value, .before = NAN };
  cJSON *b = cJSON_Parse (before), *a = cJSON_Parse (after);
  if (b != NULL && a != NULL)
    compare (&difference, b, a);
  cJSON_Delete (b);
  cJSON_Delete (a);
  g_string_free (difference.path, TRUE);
  *number = difference.before;
  gboolean one = difference.has_value ? difference.count == 1
                                      : difference.count + difference.companions == 1;
  if (one && difference.found != NULL && !is_of_drawing (difference.found))
    return difference.found;
  g_free (difference.found);
  return NULL;
}
