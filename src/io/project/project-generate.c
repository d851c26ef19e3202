#include "io/project/project-generate.h"

#include "io/project/project-facade.h"
#include "io/text/io-error.h"
#include "io/text/number-text.h"

#include <glib/gi18n-lib.h>
#include <string.h>

typedef struct Kind Kind;

/* Makes a project of the keys that the user has given. */
typedef gboolean (*Maker) (const Kind *kind, const char *const *keys, double friction,
                           QnProject *project, GError **error);

struct Kind {
  const char *name;
  Maker make;
  /* What masonry is where the user says nothing else. */
  const char *parameters; /* JSON members */
  const char *choice;     /* one more, or NULL, */
  const char *instead;    /* unless a key that begins like this is given */
  const char
    *poisson; /* of the elastic material that its cells are of; NULL: dry joints */
};

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
    if (**keys == '=' || strchr (*keys, '=') == NULL) {
      g_set_error (error, QN_IO_ERROR, QN_IO_ERROR_OVERRIDE,
                   _ ("expected KEY=VALUE, not \"%s\""), *keys);
      return FALSE;
    }
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

static gboolean
make_facade (const Kind *kind, const char *const *keys, double friction,
             QnProject *project, GError **error)
{
  g_autoptr (GPtrArray) given = g_ptr_array_new_with_free_func (g_free);
  if (!add_overrides (given, "", keys, error))
    return FALSE;
  g_autofree char *text =
    qn_facade_dup_project ((const char *const *) given->pdata, friction, error);
  return text != NULL
         && qn_project_parse (text, strlen (text), kind->name, NULL, project, error);
}

/* clang-format off */
static const Kind kinds[] = {
  { "wall", make_masonry, "\"length\": 4, \"height\": 2.4, \"unit\": [0.4, 0.2], \"bond\": \"running\"", NULL, NULL, NULL },
  { "arch", make_masonry, "\"shape\": \"circular\", \"span\": 4, \"ring\": 0.5, \"voussoirs\": 15", "\"rise\": 2", "springing", NULL },
  { "column", make_masonry, "\"height\": 3, \"width\": [0.8, 0.7], \"drums\": 6", NULL, NULL, NULL },
  { "buttress", make_masonry, "\"height\": 3, \"width\": [1.5, 0.6], \"courses\": 10, \"side\": \"right\"", NULL, NULL, NULL },
  { "portal", make_masonry, "\"span\": 2, \"pier\": [0.6, 2.4], \"courses\": 6", "\"lintel\": 0.4", "arch", NULL },
  { "rubble", make_masonry, "\"width\": [3, 3], \"height\": 3, \"stone\": 0.4, \"irregularity\": 0.4, \"seed\": 1", NULL, NULL, NULL },
  { "grid", make_masonry, "\"size\": [3, 3], \"cells\": [12, 12]", NULL, NULL, "0.2" },
  { "voronoi", make_masonry, "\"size\": [3, 3], \"cell\": 0.3, \"seed\": 1", NULL, NULL, "0" },
  { .name = "facade-strip", .make = make_facade },
};
/* clang-format on */

static const Kind *
find_kind (const char *name)
{
  for (gsize i = 0; i < G_N_ELEMENTS (kinds); i++)
    if (strcmp (kinds[i].name, name) == 0)
      return &kinds[i];
  return NULL;
}

/* Warnings about unknown keys are errors here: the user has just typed them. */
gboolean
qn_project_generate (const char *kind_name, const char *const *keys, double friction,
                     QnProject *project, GError **error)
{
  const Kind *kind = find_kind (kind_name);
  if (kind == NULL) {
    g_set_error (error, QN_IO_ERROR, QN_IO_ERROR_OVERRIDE,
                 _ ("%s: not one of wall, arch, column, buttress, portal, rubble, grid, "
                    "voronoi, facade-strip"),
                 kind_name);
    return FALSE;
  }
  if (!kind->make (kind, keys, friction, project, error))
    return FALSE;
  if (project->warnings->len == 0)
    return TRUE;
  g_set_error_literal (error, QN_IO_ERROR, QN_IO_ERROR_OVERRIDE,
                       project->warnings->pdata[0]);
  qn_project_clear (project);
  return FALSE;
}
