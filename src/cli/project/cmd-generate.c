#include "cli/base/message.h"
#include "cli/base/subcommand.h"
#include "io/project/project-masonry.h"
#include "io/text/number-text.h"

#include <glib/gi18n.h>
#include <string.h>

typedef struct Options {
  char *output;
  char *title;
  double friction;
  gboolean plain;
} Options;

/* What a kind is where the user says nothing else. */
typedef struct Kind {
  const char *name;
  const char *parameters; /* JSON members */
  const char *choice;     /* one more, or NULL, */
  const char *instead;    /* unless a key that begins like this is given */
  const char
    *poisson; /* of the elastic material that its cells are of; NULL: dry joints */
} Kind;

/* clang-format off */
static const Kind kinds[] = {
  { "wall", "\"length\": 4, \"height\": 2.4, \"unit\": [0.4, 0.2], \"bond\": \"running\"", NULL, NULL, NULL },
  { "arch", "\"shape\": \"circular\", \"span\": 4, \"rise\": 2, \"ring\": 0.5, \"voussoirs\": 15", NULL, NULL, NULL },
  { "column", "\"height\": 3, \"width\": [0.8, 0.7], \"drums\": 6", NULL, NULL, NULL },
  { "buttress", "\"height\": 3, \"width\": [1.5, 0.6], \"courses\": 10, \"side\": \"right\"", NULL, NULL, NULL },
  { "portal", "\"span\": 2, \"pier\": [0.6, 2.4], \"courses\": 6", "\"lintel\": 0.4", "arch", NULL },
  { "rubble", "\"width\": [3, 3], \"height\": 3, \"stone\": 0.4, \"irregularity\": 0.4, \"seed\": 1", NULL, NULL, NULL },
  { "grid", "\"size\": [3, 3], \"cells\": [12, 12]", NULL, NULL, "0.2" },
  { "voronoi", "\"size\": [3, 3], \"cell\": 0.3, \"seed\": 1", NULL, NULL, "0" },
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

/* "length=6" becomes "masonry[0].length=6". NULL where it is not of that form. */
static char *
dup_override (const char *argument)
{
  const char *equals = strchr (argument, '=');
  if (equals == NULL || equals == argument)
    return NULL;
  g_autofree char *key =
    g_strdelimit (g_strndup (argument, (gsize) (equals - argument)), "-", '_');
  g_autofree char *value = dup_value (equals + 1);
  return g_strdup_printf ("masonry[0].%s=%s", key, value);
}

/* What a new project has, with the masonry and friction that are asked for before the keys of the
 * command. */
static char *
dup_document (const Kind *kind, const Options *options, char **arguments,
              GPtrArray *overrides, GError **error)
{
  gboolean chosen = kind->instead == NULL;
  for (gsize i = 0; !chosen && arguments[i] != NULL; i++)
    chosen = g_str_has_prefix (arguments[i], kind->instead);
  char friction[G_ASCII_DTOSTR_BUF_SIZE];
  g_ascii_dtostr (friction, sizeof friction, options->friction);
  g_ptr_array_add (overrides,
                   g_strdup_printf ("masonry=[{ \"kind\": \"%s\", \"name\": \"%s\","
                                    " \"thickness\": 1, \"unit_weight\": 20000,"
                                    " \"foundation\": 0.2, %s%s%s }]",
                                    kind->name, kind->name, kind->parameters,
                                    chosen ? "" : ", ", chosen ? "" : kind->choice));
  if (kind->poisson == NULL) {
    g_ptr_array_add (overrides, g_strdup_printf ("laws[0].friction=%s", friction));
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

/* Warnings about unknown keys are errors here: the user has just typed them. */
static QnExit
write_project (QnProject *project, const Options *options)
{
  if (project->warnings->len > 0) {
    qn_cli_error ("%s", (const char *) project->warnings->pdata[0]);
    return QN_EXIT_USAGE;
  }
  if (options->plain)
    qn_project_detach_masonry (project, 0);
  if (options->title != NULL) {
    free (project->model.title);
    project->model.title = strdup (options->title);
  }
  GError *error = NULL;
  qn_project_save (project, options->output, &error);
  return qn_cli_end (error);
}

static QnExit
generate (const QnSubcommand *self, const Options *options, const Kind *kind,
          char **arguments)
{
  GError *error = NULL;
  g_autoptr (GPtrArray) overrides = g_ptr_array_new_with_free_func (g_free);
  g_autofree char *document = dup_document (kind, options, arguments, overrides, &error);
  if (document == NULL)
    return qn_cli_fail (error);
  for (gsize i = 0; arguments[i] != NULL; i++) {
    char *override = dup_override (arguments[i]);
    if (override == NULL)
      return qn_cli_usage_error (self->name, _ ("expected KEY=VALUE, not \"%s\""),
                                 arguments[i]);
    g_ptr_array_add (overrides, override);
  }
  g_ptr_array_add (overrides, NULL);

  QnProject project;
  if (!qn_project_parse (document, strlen (document), kind->name,
                         (const char *const *) overrides->pdata, &project, &error))
    return qn_cli_fail (error);
  QnExit code = write_project (&project, options);
  qn_project_clear (&project);
  return code;
}

/* Whether an argument that begins with -- is an option of the subcommand itself. */
static gboolean
is_option (const char *argument, const GOptionEntry *entries)
{
  g_autofree char *name = g_strndup (argument + 2, strcspn (argument + 2, "="));
  for (; entries->long_name != NULL; entries++)
    if (strcmp (name, entries->long_name) == 0)
      return TRUE;
  return name[0] == '\0' || strcmp (name, "help") == 0 || strcmp (name, "help-all") == 0
         || strcmp (argument, QN_DESCRIBE) == 0;
}

/* "--length 6", "--length=6" and "length=6" say the same. Options of the subcommand itself stay
 * what they are. */
static GPtrArray *
join_keys (int argc, char **argv, const GOptionEntry *entries)
{
  GPtrArray *joined = g_ptr_array_new_with_free_func (g_free);
  for (int i = 0; i < argc; i++) {
    const char *argument = argv[i];
    gboolean mine = !g_str_has_prefix (argument, "--") || is_option (argument, entries);
    if (mine)
      g_ptr_array_add (joined, g_strdup (argument));
    else if (strchr (argument, '=') != NULL || i + 1 == argc)
      g_ptr_array_add (joined, g_strdup (argument + 2));
    else
      g_ptr_array_add (joined, g_strdup_printf ("%s=%s", argument + 2, argv[++i]));
  }
  g_ptr_array_add (joined, NULL);
  return joined;
}

static QnExit
run (const QnSubcommand *self, int argc, char **argv)
{
  Options options = { .friction = 0.65 };
  const GOptionEntry entries[] = {
    { "output", 'o', 0, G_OPTION_ARG_FILENAME, &options.output,
      N_ ("Project file to write"), N_ ("MODEL.quoin") },
    { "title", 0, 0, G_OPTION_ARG_STRING, &options.title, N_ ("Title of the project"),
      N_ ("TEXT") },
    { "friction", 0, 0, G_OPTION_ARG_DOUBLE, &options.friction,
      N_ ("Friction coefficient of the dry joints (0.65)"), N_ ("MU") },
    { "plain", 0, 0, G_OPTION_ARG_NONE, &options.plain,
      N_ ("Write plain blocks instead of parameters"), NULL },
    G_OPTION_ENTRY_NULL,
  };
  GPtrArray *joined = join_keys (argc, argv, entries);
  /* The parser reorders the vector; the strings stay owned by `joined`. */
  g_autofree char **arguments = g_memdup2 (joined->pdata, joined->len * sizeof (char *));
  char **rest = arguments;
  int count = (int) joined->len - 1;
  QnExit code = QN_EXIT_USAGE;
  if (qn_subcommand_parse (self, entries, 1, 1000, &count, &rest)) {
    rest[count] = NULL;
    const Kind *kind = find_kind (rest[1]);
    if (kind == NULL)
      qn_cli_usage_error (self->name, _ ("expected wall, arch, column, buttress, portal, "
                                         "rubble, grid or voronoi first"));
    else if (options.output == NULL)
      qn_cli_usage_error (self->name, _ ("-o is missing"));
    else
      code = generate (self, &options, kind, rest + 2);
  }
  g_ptr_array_unref (joined);
  qn_subcommand_free_values (entries);
  return code;
}

const QnSubcommand qn_cmd_generate = {
  .name = "generate",
  .arguments =
    "wall|arch|column|buttress|portal|rubble|grid|voronoi [KEY=VALUE]… -o MODEL.quoin",
  .summary = N_ ("Write a project with parametric masonry"),
  .help =
    N_ ("Keys are those of the object in the project file, as KEY=VALUE or --KEY VALUE: "
        "length=6, --bond english, unit=0.4x0.2, "
        "openings='[{\"at\": [1, 0], \"width\": 1, \"height\": 2}]'. What is not given "
        "has a default. Lengths are m, angles rad."),
  .run = run,
};
