#include "io/project/project-generate.h"

#include "io/json/json-value.h"
#include "io/text/file-writer.h"
#include "io/text/io-error.h"
#include "io/text/text-format.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

typedef struct Kind {
  const char *name;
  /* What masonry is where the user says nothing else; a strip of a façade has keys of its own. */
  const char *parameters; /* JSON members, or NULL */
  const char *choice;     /* one more, or NULL, */
  const char *instead;    /* unless a key that begins like this is given */
  const char
    *poisson; /* of the elastic material that its cells are of; NULL: dry joints */
} Kind;

/* "0.4x.2" and "0.4,.2" mean [0.4, 0.2], and ".2" 0.2; everything else is left to JSON. */
static char *
dup_value (const char *text)
{
  g_autofree char *list = g_strdelimit (g_strdup (text), "xX", ',');
  if (*list == '\0' || strspn (list, "0123456789.,+-eE ") != strlen (list))
    return g_strdup (text);
  g_auto (GStrv) parts = g_strsplit (list, ",", -1);
  for (gsize i = 0; parts[i] != NULL; i++) {
    char number[QN_NUMBER_TEXT_SIZE], *end;
    double value = g_ascii_strtod (g_strstrip (parts[i]), &end);
    if (end == parts[i] || *end != '\0')
      return g_strdup (text);
    g_free (parts[i]);
    parts[i] = g_strdup (qn_number_text (value, number));
  }
  g_autofree char *all = g_strjoinv (",", parts);
  return strchr (list, ',') != NULL ? g_strconcat ("[", all, "]", NULL)
                                    : g_steal_pointer (&all);
}

/* "length=6" becomes "masonry[0].length=6", with `owner` "masonry[0].". */
static char *
dup_override (const char *owner, const char *argument)
{
  const char *equals = strchr (argument, '=');
  g_autofree char *key =
    g_strdelimit (g_strndup (argument, (gsize) (equals - argument)), "-", '_');
  g_autofree char *value = dup_value (equals + 1);
  return g_strdup_printf ("%s%s=%s", owner, key, value);
}

/* Those of all keys behind `overrides`, and NULL at the end. */
static gboolean
add_overrides (GPtrArray *overrides, const char *owner, const char *const *keys,
               GError **error)
{
  for (; *keys != NULL; keys++) {
    if (**keys == '=' || strchr (*keys, '=') == NULL)
      return qn_io_fail (error, QN_IO_ERROR_OVERRIDE,
                         _ ("expected KEY=VALUE, not \"%s\""), *keys);
    g_ptr_array_add (overrides, dup_override (owner, *keys));
  }
  g_ptr_array_add (overrides, NULL);
  return TRUE;
}

/* What a new project has, with the masonry and friction that are asked for before the keys of the
 * command. */
static char *
dup_document (const Kind *kind, double friction, const char *const *keys,
              GPtrArray *overrides, GError **error)
{
  gboolean chosen = kind->instead == NULL;
  for (gsize i = 0; !chosen && keys[i] != NULL; i++)
    chosen = g_str_has_prefix (keys[i], kind->instead);
  char number[QN_NUMBER_TEXT_SIZE];
  g_ptr_array_add (overrides,
                   g_strdup_printf ("masonry=[{ \"kind\": \"%s\", \"name\": \"%s\","
                                    " \"thickness\": 1, \"unit_weight\": 20000,"
                                    " \"foundation\": 0.2, %s%s%s }]",
                                    kind->name, kind->name, kind->parameters,
                                    chosen ? "" : ", ", chosen ? "" : kind->choice));
  if (kind->poisson == NULL) {
    g_ptr_array_add (overrides, g_strdup_printf ("laws[0].friction=%s",
                                                 qn_number_text (friction, number)));
  } else {
    g_ptr_array_add (overrides,
                     g_strdup_printf ("laws=[{ \"name\": \"concrete\", \"kind\": "
                                      "\"elastic\", \"basis\": \"material\","
                                      " \"elasticity\": 3e10, \"poisson\": %s,"
                                      " \"arrangement\": \"grid\" }]",
                                      kind->poisson));
    g_ptr_array_add (overrides, g_strdup ("contact.law=concrete"));
    g_ptr_array_add (overrides, g_strdup ("analysis.max_multiplier=1"));
  }
  QnProject begun;
  if (!qn_project_begin (&begun, "dry joint", error))
    return NULL;
  char *text = qn_project_to_text (&begun, NULL);
  qn_project_clear (&begun);
  return text;
}

static gboolean
make_masonry (const Kind *kind, const char *const *keys, double friction,
              QnProject *project, GError **error)
{
  g_autoptr (GPtrArray) overrides = g_ptr_array_new_with_free_func (g_free);
  g_autofree char *text = dup_document (kind, friction, keys, overrides, error);
  return text != NULL && add_overrides (overrides, "masonry[0].", keys, error)
         && qn_project_parse (text, strlen (text), kind->name,
                              (const char *const *) overrides->pdata, project, error);
}

static gboolean make_facade (const char *const *keys, double friction, QnProject *project,
                             GError **error);

/* clang-format off */
static const Kind kinds[] = {
  { "wall", "\"length\": 4, \"height\": 2.4, \"unit\": [0.4, 0.2], \"bond\": \"running\"", NULL, NULL, NULL },
  { "arch", "\"shape\": \"circular\", \"span\": 4, \"ring\": 0.5, \"voussoirs\": 15", "\"rise\": 2", "springing", NULL },
  { "column", "\"height\": 3, \"width\": [0.8, 0.7], \"drums\": 6", NULL, NULL, NULL },
  { "buttress", "\"height\": 3, \"width\": [1.5, 0.6], \"courses\": 10, \"side\": \"right\"", NULL, NULL, NULL },
  { "portal", "\"span\": 2, \"pier\": [0.6, 2.4], \"courses\": 6", "\"lintel\": 0.4", "arch", NULL },
  { "rubble", "\"width\": [3, 3], \"height\": 3, \"stone\": 0.4, \"irregularity\": 0.4, \"seed\": 1", NULL, NULL, NULL },
  { "grid", "\"size\": [3, 3], \"cells\": [12, 12]", NULL, NULL, "0.2" },
  { "voronoi", "\"size\": [3, 3], \"cell\": 0.3, \"seed\": 1", NULL, NULL, "0" },
  { .name = "facade-strip" },
};
/* clang-format on */

/* Warnings about unknown keys are errors here: the user has just typed them. */
gboolean
qn_project_generate (const char *kind_name, const char *const *keys, double friction,
                     QnProject *project, GError **error)
{
  const Kind *kind = kinds;
  while (kind < kinds + G_N_ELEMENTS (kinds) && strcmp (kind->name, kind_name) != 0)
    kind++;
  if (kind == kinds + G_N_ELEMENTS (kinds))
    return qn_io_fail (
      error, QN_IO_ERROR_OVERRIDE,
      _ ("%s: not one of wall, arch, column, buttress, portal, rubble, grid, "
         "voronoi, facade-strip"),
      kind_name);
  if (kind->parameters == NULL ? !make_facade (keys, friction, project, error)
                               : !make_masonry (kind, keys, friction, project, error))
    return FALSE;
  if (project->warnings->len == 0)
    return TRUE;
  g_set_error_literal (error, QN_IO_ERROR, QN_IO_ERROR_OVERRIDE,
                       project->warnings->pdata[0]);
  qn_project_clear (project);
  return FALSE;
}

#define MOST_STOREYS 20
#define MOST_COURSES 100

/* A floor that holds the wall is the uppermost tenth of its storey. */
#define HELD_PART 0.1

/* Numbers of a key; those of storeys above the last are like it. */
typedef struct List {
  double values[MOST_STOREYS];
  gsize count;
} List;

enum {
  STOREYS,
  THICKNESS,
  BEARING,
  COURSES,
  WIDTH,
  UNIT_WEIGHT,
  FLOORS, /* from here on 0 is a number too */
  FLOOR_FRICTION,
  FLOOR_INERTIA,
  HELD,
  TIES,
  FLANKS,
  THRUST,
  PARAPET,
  KEY_COUNT
};

static const char *const strip_keys[KEY_COUNT] = {
  "storeys",     "thickness", "bearing",        "courses",       "width",
  "unit_weight", "floors",    "floor_friction", "floor_inertia", "held",
  "ties",        "flanks",    "thrust",         "parapet",
};

static const char usual_strip[] =
  "{ \"storeys\": [3, 3], \"thickness\": 0.5, \"bearing\": 0.2, \"courses\": 4, "
  "\"width\": 1, \"unit_weight\": 18000, \"floors\": 0, \"floor_friction\": 0, "
  "\"floor_inertia\": 1, \"held\": 0, \"ties\": 0, \"flanks\": 0, \"thrust\": 0, "
  "\"parapet\": 0 }";

/* One storey as all keys make it: levels and places in m, forces in N. */
typedef struct Storey {
  double foot, wall, top; /* courses are from foot to wall, a floor that holds above */
  double inner, bearing;  /* x of the inner face, and of what the floor brings */
  double floor, tie;
  gboolean held;
  char name[32]; /* of the block below the floor */
} Storey;

static double
at (const List *list, gsize storey)
{
  return list->values[MIN (storey, list->count - 1)];
}

static gboolean
read_list (const QnJsonValue *keys, int key, List *list)
{
  const QnJsonValue value = qn_json_value_member (keys, strip_keys[key]);
  const QnRange range = key < FLOORS ? QN_RANGE_POSITIVE : QN_RANGE_NOT_NEGATIVE;
  list->count = 1;
  if (!cJSON_IsArray (value.json))
    return qn_json_value_number (&value, range, list->values);
  list->count = (gsize) cJSON_GetArraySize (value.json);
  if (list->count == 0 || list->count > MOST_STOREYS)
    return qn_json_value_failf (&value, _ ("expected up to %d numbers"), MOST_STOREYS);
  return qn_json_value_numbers (&value, range, 1, list->values);
}

/* Numbers that a key may have; 0: one for each storey. */
static const gsize most_numbers[KEY_COUNT] = {
  [STOREYS] = MOST_STOREYS, [COURSES] = 1,       [WIDTH] = 1,  [UNIT_WEIGHT] = 1,
  [FLOOR_FRICTION] = 1,     [FLOOR_INERTIA] = 1, [THRUST] = 1, [PARAPET] = 2,
};

/* Nothing that is given is left out in silence. */
static gboolean
check_list (const QnJsonValue *keys, int key, const List *lists)
{
  const QnJsonValue value = qn_json_value_member (keys, strip_keys[key]);
  const List *list = &lists[key];
  const gsize most = most_numbers[key] > 0 ? most_numbers[key] : lists[STOREYS].count;
  const double *last = &list->values[list->count - 1];
  if (list->count > most)
    return qn_json_value_failf (&value, _ ("expected up to %d numbers"), (int) most);
  if (key == PARAPET && *last > 0 && (list->count < 2 || !(list->values[0] > 0)))
    return qn_json_value_fail (&value, _ ("expected two numbers"));
  const int whole = key == HELD ? (int) lists[STOREYS].count : MOST_COURSES;
  for (gsize i = 0; (key == HELD || key == COURSES) && i < list->count; i++)
    if (list->values[i] != floor (list->values[i]) || list->values[i] > whole)
      return qn_json_value_failf (&value, _ ("expected a whole number from 1 to %d"),
                                  whole);
  return TRUE;
}

static gboolean
read_keys (const QnJsonValue *keys, List *lists)
{
  const QnJsonValue bearing = qn_json_value_member (keys, strip_keys[BEARING]);
  if (!qn_json_value_check_keys (keys, strip_keys, KEY_COUNT))
    return FALSE;
  for (int k = 0; k < KEY_COUNT; k++)
    if (!read_list (keys, k, &lists[k]) || !check_list (keys, k, lists))
      return FALSE;
  for (gsize i = 0; i < lists[STOREYS].count; i++)
    if (at (&lists[BEARING], i) > at (&lists[THICKNESS], i))
      return qn_json_value_fail (&bearing, _ ("more than the thickness"));
  return TRUE;
}

static void
make_storeys (const List *lists, Storey *storeys)
{
  double foot = 0;
  for (gsize i = 0; i < lists[STOREYS].count; i++) {
    Storey *s = &storeys[i];
    const double height = at (&lists[STOREYS], i), inner = -at (&lists[THICKNESS], i);
    *s = (Storey){
      .foot = foot,
      .top = foot + height,
      .inner = inner,
      .bearing = round (1e6 * (inner + at (&lists[BEARING], i) / 2)) / 1e6,
      .floor = at (&lists[FLOORS], i),
      .tie = at (&lists[TIES], i),
    };
    for (gsize k = 0; k < lists[HELD].count; k++)
      s->held |= lists[HELD].values[k] == (double) i + 1;
    s->wall = s->held ? (1 - HELD_PART) * height : height;
    if (s->held)
      g_snprintf (s->name, sizeof s->name, "floor.%zu", i + 1);
    else
      g_snprintf (s->name, sizeof s->name, "%zu.%d", i + 1,
                  (int) at (&lists[COURSES], 0));
    foot = s->top;
  }
}

/* One block with its outer face on x = 0; what is held stays upright. */
static void
put_block (QnFileWriter *out, const char *name, double inner, double foot, double top,
           const List *lists, gboolean held)
{
  qn_file_writer_json (
    out,
    ", { \"name\": %s, \"vertices\": [[%f, %f], [0, %f], [0, %f], [%f, %f]], "
    "\"thickness\": %f, \"unit_weight\": %f, \"support\": [%i, false, %i] }",
    name, inner, foot, foot, top, inner, top, at (&lists[WIDTH], 0),
    at (&lists[UNIT_WEIGHT], 0), held, held);
}

/* From a block at a level to the ground. */
static void
add_tie (QnFileWriter *out, const char *kind, gsize i, const Storey *s, const char *block,
         double level, double anchor)
{
  g_autofree char *name = g_strdup_printf ("%s.%zu", kind, i + 1);
  if (anchor > 0)
    qn_file_writer_json (
      out,
      ", { \"name\": %s, \"ends\": [{ \"block\": %s, \"at\": [%f, %f] }, { \"at\": "
      "[%f, %f] }], \"area\": 0.0003, \"elasticity\": 2.1e11, \"anchor\": %f }",
      name, block, s->inner, level, s->inner - 4, level, anchor);
}

static void
add_force (QnFileWriter *out, const Storey *s, double x, double along, double up)
{
  if (along != 0 || up != 0)
    qn_file_writer_json (out,
                         ", { \"kind\": \"force\", \"block\": %s, \"value\": [%f, %f], "
                         "\"at\": [%f, %f] }",
                         s->name, along, up, x, s->top);
}

static char *
dup_project (const List *lists, double friction)
{
  Storey storeys[MOST_STOREYS];
  QnFileWriter *out = qn_file_writer_new_in_memory ();
  const gsize count = lists[STOREYS].count;
  const double inertia = at (&lists[FLOOR_INERTIA], 0);
  double inner = 0;
  gsize length;
  make_storeys (lists, storeys);
  for (gsize i = 0; i < count; i++)
    inner = fmin (inner, storeys[i].inner);
  qn_file_writer_json (
    out,
    "{ \"format\": \"quoin\", \"version\": 1, \"laws\": [{ \"name\": \"dry joint\", "
    "\"kind\": \"coulomb\", \"kn\": 1e9, \"ks\": 1e9, \"friction\": %f }], \"blocks\": "
    "[{ \"name\": \"ground\", \"vertices\": [[%f, -0.5], [1, -0.5], [1, 0], [%f, 0]], "
    "\"thickness\": %f, \"unit_weight\": %f, \"support\": [true, true, true] }",
    friction, inner - 1, inner - 1, at (&lists[WIDTH], 0), at (&lists[UNIT_WEIGHT], 0));
  const int courses = (int) at (&lists[COURSES], 0);
  const double *parapet = lists[PARAPET].values, top = storeys[count - 1].top;
  for (gsize i = 0; i < count; i++) {
    const Storey *s = &storeys[i];
    for (int c = 0; c < courses; c++) {
      g_autofree char *name = g_strdup_printf ("%zu.%d", i + 1, c + 1);
      put_block (out, name, s->inner, s->foot + s->wall * c / courses,
                 s->foot + s->wall * (c + 1) / courses, lists, FALSE);
    }
    if (s->held)
      put_block (out, s->name, s->inner, s->foot + s->wall, s->top, lists, TRUE);
  }
  if (lists[PARAPET].count == 2)
    put_block (out, "parapet", -parapet[1], top, top + parapet[0], lists, FALSE);
  qn_file_writer_puts (out, "], \"ties\": [");
  for (gsize i = 0; i < count; i++) {
    const Storey *s = &storeys[i];
    g_autofree char *middle = g_strdup_printf ("%zu.%d", i + 1, (courses + 1) / 2);
    add_tie (out, "friction", i, s, s->name, s->top,
             at (&lists[FLOOR_FRICTION], 0) * s->floor);
    add_tie (out, "tie", i, s, s->name, s->top, s->tie);
    add_tie (out, "flank", i, s, middle, s->foot + s->wall / 2, at (&lists[FLANKS], i));
  }
  qn_file_writer_puts (out,
                       "], \"contact\": { \"law\": \"dry joint\" }, \"loads\": { "
                       "\"dead\": [{ \"kind\": \"weight\", \"direction\": [0, -1] }");
  for (gsize i = 0; i < count; i++)
    add_force (out, &storeys[i], storeys[i].bearing, 0, -storeys[i].floor);
  add_force (out, &storeys[count - 1], storeys[count - 1].inner, at (&lists[THRUST], 0),
             0);
  qn_file_writer_puts (out,
                       "], \"live\": [{ \"kind\": \"weight\", \"direction\": [1, 0] }");
  for (gsize i = 0; i < count; i++)
    if (!storeys[i].held)
      add_force (out, &storeys[i], storeys[i].bearing, storeys[i].floor * inertia, 0);
  qn_file_writer_puts (out, "] }, \"analysis\": { \"procedure\": \"limit\" }, "
                            "\"capacity\": { \"mechanism\": true } }");
  return qn_file_writer_steal (out, &length);
}

static gboolean
make_facade (const char *const *keys, double friction, QnProject *project, GError **error)
{
  List lists[KEY_COUNT];
  g_autoptr (GPtrArray) given = g_ptr_array_new_with_free_func (g_free);
  gboolean ok = add_overrides (given, "", keys, error);
  const char *const *overrides = (const char *const *) given->pdata;
  QnReader reader = { .name = "facade-strip", .overrides = overrides };
  cJSON *document = cJSON_Parse (usual_strip);
  for (; ok && *overrides != NULL; overrides++)
    ok = qn_json_override (document, *overrides, error);
  const QnJsonValue root = qn_json_value_root (&reader, document);
  if (ok && !read_keys (&root, lists)) {
    reader.error->code = QN_IO_ERROR_OVERRIDE; /* somebody has just typed it */
    g_propagate_error (error, reader.error);
    ok = FALSE;
  }
  cJSON_Delete (document);
  g_autofree char *text = ok ? dup_project (lists, friction) : NULL;
  return ok
         && qn_project_parse (text, strlen (text), "facade-strip", NULL, project, error);
}
