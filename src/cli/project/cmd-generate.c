#include "cli/base/message.h"
#include "cli/base/subcommand.h"
#include "io/project/project-generate.h"
#include "io/project/project-masonry.h"

#include <glib/gi18n.h>
#include <string.h>

typedef struct GenerateOptions {
  char *output;
  char *title;
  double friction;
  gboolean plain;
} GenerateOptions;

static void
generate (const GenerateOptions *options, char **arguments)
{
  QnProject *project = qn_cli_keep (g_new0 (QnProject, 1));
  qn_cli_must (qn_project_generate (arguments[0], (const char *const *) arguments + 1,
                                    options->friction, project, QN_TROUBLE));
  if (options->plain)
    qn_project_detach_masonry (project);
  if (options->title != NULL) {
    free (project->model.title);
    project->model.title = strdup (options->title);
  }
  qn_cli_must (qn_project_save (project, options->output, QN_TROUBLE));
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

static void
run_generate (const QnSubcommand *self, int argc, char **argv)
{
  GenerateOptions options = { .friction = 0.65 };
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
  g_autoptr (GPtrArray) joined = join_keys (argc, argv, entries);
  /* The parser reorders the vector; the strings stay owned by `joined`. */
  g_autofree char **arguments = g_memdup2 (joined->pdata, joined->len * sizeof (char *));
  char **rest = arguments;
  int count = (int) joined->len - 1;
  if (!qn_subcommand_parse (self, entries, 1, 1000, &count, &rest))
    return;
  rest[count] = NULL;
  if (options.output == NULL)
    qn_cli_usage_error (_ ("-o is missing"));
  generate (&options, rest + 1);
}

const QnSubcommand qn_cmd_generate = {
  .name = "generate",
  .arguments =
    "wall|arch|column|buttress|portal|rubble|grid|voronoi|facade-strip [KEY=VALUE]… "
    "-o MODEL.quoin",
  .summary = N_ ("Write a project with parametric masonry"),
  .help = N_ (
    "Keys are those of the object in the project file, as KEY=VALUE or --KEY VALUE: "
    "length=6, --bond english, unit=0.4x0.2, "
    "openings='[{\"at\": [1, 0], \"width\": 1, \"height\": 2}]'. What is not given "
    "has a default. Lengths are m, angles rad. facade-strip has keys of its own: "
    "storeys=3.2x3, thickness=0.5x0.4, floors=12000x8000, bearing, floor-friction, "
    "floor-inertia, held, ties, thrust, parapet, courses, width, unit-weight; N and m, "
    "from the bottom."),
  .run = run_generate,
};
