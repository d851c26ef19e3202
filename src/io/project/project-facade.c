#include "io/project/project-facade.h"

#include "io/text/file-writer.h"
#include "io/text/io-error.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#define MOST_STOREYS 20
#define MOST_COURSES 100

/* Numbers of a key; those of storeys above the last are like it. */
typedef struct List {
  double values[MOST_STOREYS];
  gsize count;
} List;

enum {
  STOREYS,
  THICKNESS,
  FLOORS,
  BEARING,
  FLOOR_FRICTION,
  FLOOR_INERTIA,
  HELD,
  TIES,
  THRUST,
  PARAPET,
  COURSES,
  WIDTH,
  UNIT_WEIGHT,
  KEY_COUNT
};

static const struct {
  const char *name, *usual;
  gboolean positive; /* or at least 0 */
} keys_of[KEY_COUNT] = {
  [STOREYS] = { "storeys", "3x3", TRUE },
  [THICKNESS] = { "thickness", "0.5", TRUE },
  [FLOORS] = { "floors", "0", FALSE },
  [BEARING] = { "bearing", "0.2", TRUE },
  [FLOOR_FRICTION] = { "floor_friction", "0", FALSE },
  [FLOOR_INERTIA] = { "floor_inertia", "1", FALSE },
  [HELD] = { "held", "0", FALSE },
  [TIES] = { "ties", "0", FALSE },
  [THRUST] = { "thrust", "0", FALSE },
  [PARAPET] = { "parapet", "0", FALSE },
  [COURSES] = { "courses", "4", TRUE },
  [WIDTH] = { "width", "1", TRUE },
  [UNIT_WEIGHT] = { "unit_weight", "18000", TRUE },
};

static gboolean
parse_list (const char *text, List *list)
{
  g_autofree char *plain = g_strdelimit (g_strdup (text), "xX[]", ',');
  g_auto (GStrv) parts = g_strsplit (plain, ",", -1);
  list->count = 0;
  for (gsize i = 0; parts[i] != NULL; i++) {
    char *end, *part = g_strstrip (parts[i]);
    double value = g_ascii_strtod (part, &end);
    if (*part == '\0')
      continue;
    if (*end != '\0' || !isfinite (value) || list->count == MOST_STOREYS)
      return FALSE;
    list->values[list->count++] = value;
  }
  return list->count > 0;
}

/* "bearing: …" */
static gboolean
refuse (GError **error, const char *what, const char *problem)
{
  g_set_error (error, QN_IO_ERROR, QN_IO_ERROR_OVERRIDE, "%s: %s", what, problem);
  return FALSE;
}

static double
at (const List *list, gsize storey)
{
  return list->values[MIN (storey, list->count - 1)];
}

static gboolean
check (const List *lists, GError **error)
{
  for (int k = 0; k < KEY_COUNT; k++)
    for (gsize i = 0; i < lists[k].count; i++)
      if (lists[k].values[i] < 0 || (keys_of[k].positive && lists[k].values[i] == 0))
        return refuse (error, keys_of[k].name, _ ("a number is too small"));
  for (gsize i = 0; i < lists[STOREYS].count; i++)
    if (at (&lists[BEARING], i) > at (&lists[THICKNESS], i))
      return refuse (error, "bearing", _ ("more than the thickness"));
  return at (&lists[COURSES], 0) <= MOST_COURSES
         || refuse (error, "courses", _ ("more than 100"));
}

static gboolean
read_keys (const char *const *keys, List *lists, GError **error)
{
  for (int k = 0; k < KEY_COUNT; k++)
    parse_list (keys_of[k].usual, &lists[k]);
  for (; *keys != NULL; keys++) {
    const char *equals = strchr (*keys, '=');
    int k = 0;
    if (equals == NULL)
      return refuse (error, *keys, _ ("expected KEY=VALUE"));
    g_autofree char *name =
      g_strdelimit (g_strndup (*keys, (gsize) (equals - *keys)), "-", '_');
    while (k < KEY_COUNT && strcmp (name, keys_of[k].name) != 0)
      k++;
    if (k == KEY_COUNT)
      return refuse (error, name, _ ("a façade strip has no such key"));
    if (!parse_list (equals + 1, &lists[k]))
      return refuse (error, name, _ ("not a list of numbers as 3x2.8"));
  }
  return check (lists, error);
}

static gboolean
is_held (const List *held, gsize storey)
{
  for (gsize i = 0; i < held->count; i++)
    if (held->values[i] == (double) storey + 1)
      return TRUE;
  return FALSE;
}

/* One block with its outer face on x = 0; "true" in `aside` holds it upright. */
static void
add_block (QnFileWriter *out, const char *name, double thickness, double foot, double top,
           const List *lists, gboolean held)
{
  qn_file_writer_json (
    out,
    ",\n    { \"name\": %s, \"vertices\": [[%f, %f], [0, %f], [0, %f], "
    "[%f, %f]], \"thickness\": %f, \"unit_weight\": %f",
    name, -thickness, foot, foot, top, -thickness, top, at (&lists[WIDTH], 0),
    at (&lists[UNIT_WEIGHT], 0));
  qn_file_writer_puts (out, held ? ", \"support\": [true, false, true] }" : " }");
}

/* A floor that holds the wall is the uppermost tenth of its storey. */
#define HELD_PART 0.1

static char *
dup_top (const List *lists, gsize storey)
{
  return is_held (&lists[HELD], storey)
           ? g_strdup_printf ("floor.%zu", storey + 1)
           : g_strdup_printf ("%zu.%d", storey + 1, (int) at (&lists[COURSES], 0));
}

static void
add_blocks (QnFileWriter *out, const List *lists)
{
  double foot = 0;
  int courses = (int) at (&lists[COURSES], 0);
  for (gsize i = 0; i < lists[STOREYS].count; i++) {
    double height = at (&lists[STOREYS], i), thickness = at (&lists[THICKNESS], i);
    gboolean held = is_held (&lists[HELD], i);
    double wall = held ? (1 - HELD_PART) * height : height;
    for (int c = 0; c < courses; c++) {
      g_autofree char *name = g_strdup_printf ("%zu.%d", i + 1, c + 1);
      add_block (out, name, thickness, foot + wall * c / courses,
                 foot + wall * (c + 1) / courses, lists, FALSE);
    }
    g_autofree char *floor = dup_top (lists, i);
    if (held)
      add_block (out, floor, thickness, foot + wall, foot + height, lists, TRUE);
    foot += height;
  }
  if (lists[PARAPET].count == 2)
    add_block (out, "parapet", lists[PARAPET].values[1], foot,
               foot + lists[PARAPET].values[0], lists, FALSE);
}

static void
add_tie (QnFileWriter *out, const char *kind, gsize storey, const char *block, double x,
         double y, double anchor)
{
  g_autofree char *name = g_strdup_printf ("%s.%zu", kind, storey + 1);
  if (anchor > 0)
    qn_file_writer_json (
      out,
      ",\n    { \"name\": %s, \"ends\": [{ \"block\": %s, \"at\": [%f, %f] }, { \"at\": "
      "[%f, %f] }], \"area\": 0.0003, \"elasticity\": 2.1e11, \"anchor\": %f }",
      name, block, x, y, x - 4, y, anchor);
}

static void
add_ties (QnFileWriter *out, const List *lists)
{
  double level = 0;
  for (gsize i = 0; i < lists[STOREYS].count; i++) {
    g_autofree char *top = dup_top (lists, i);
    double inner = -at (&lists[THICKNESS], i);
    level += at (&lists[STOREYS], i);
    add_tie (out, "friction", i, top, inner, level,
             at (&lists[FLOOR_FRICTION], 0) * at (&lists[FLOORS], i));
    add_tie (out, "tie", i, top, inner, level, at (&lists[TIES], i));
  }
}

static void
add_force (QnFileWriter *out, const char *block, double x, double y, double along,
           double up)
{
  if (along != 0 || up != 0)
    qn_file_writer_json (out,
                         ",\n      { \"kind\": \"force\", \"block\": %s, \"value\": [%f, "
                         "%f], \"at\": [%f, %f] }",
                         block, along, up, x, y);
}

static void
add_loads (QnFileWriter *out, const List *lists, gboolean live)
{
  double level = 0;
  gsize last = lists[STOREYS].count - 1;
  for (gsize i = 0; i <= last; i++) {
    g_autofree char *top = dup_top (lists, i);
    double load = at (&lists[FLOORS], i), inner = -at (&lists[THICKNESS], i);
    double x = round (1e6 * (inner + at (&lists[BEARING], i) / 2)) / 1e6;
    level += at (&lists[STOREYS], i);
    if (live && !is_held (&lists[HELD], i))
      add_force (out, top, x, level, load * at (&lists[FLOOR_INERTIA], 0), 0);
    else if (!live)
      add_force (out, top, x, level, 0, -load);
    if (!live && i == last)
      add_force (out, top, inner, level, at (&lists[THRUST], 0), 0);
  }
}

char *
qn_facade_dup_project (const char *const *keys, double friction, GError **error)
{
  List lists[KEY_COUNT];
  if (!read_keys (keys, lists, error))
    return NULL;
  QnFileWriter *out = qn_file_writer_new_in_memory ();
  double inner = 0;
  for (gsize i = 0; i < lists[STOREYS].count; i++)
    inner = fmax (inner, at (&lists[THICKNESS], i));
  qn_file_writer_json (
    out,
    "{\n  \"format\": \"quoin\", \"version\": 1,\n  \"laws\": [\n    { \"name\": \"dry "
    "joint\", \"kind\": \"coulomb\", \"kn\": 1e9, \"ks\": 1e9, \"friction\": %f } ],\n"
    "  \"blocks\": [\n    { \"name\": \"ground\", \"vertices\": [[%f, -0.5], [1, -0.5], "
    "[1, 0], [%f, 0]], \"thickness\": %f, \"unit_weight\": %f, \"support\": [true, true, "
    "true] }",
    friction, -inner - 1, -inner - 1, at (&lists[WIDTH], 0), at (&lists[UNIT_WEIGHT], 0));
  add_blocks (out, lists);
  qn_file_writer_puts (out, " ],\n  \"ties\": [");
  add_ties (out, lists);
  qn_file_writer_puts (out, " ],\n  \"contact\": { \"law\": \"dry joint\" },\n  "
                            "\"loads\": {\n    \"dead\": [\n      { \"kind\": "
                            "\"weight\", \"direction\": [0, -1] }");
  add_loads (out, lists, FALSE);
  qn_file_writer_puts (out, " ],\n    \"live\": [\n      { \"kind\": \"weight\", "
                            "\"direction\": [1, 0] }");
  add_loads (out, lists, TRUE);
  qn_file_writer_puts (out, " ] },\n  \"analysis\": { \"procedure\": \"limit\" },\n  "
                            "\"capacity\": { \"mechanism\": true }\n}\n");
  gsize length;
  return qn_file_writer_steal (out, &length);
}
