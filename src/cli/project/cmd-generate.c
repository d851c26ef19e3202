#include "cli/base/message.h"
#include "cli/base/subcommand.h"
#include "io/project/project-generate.h"
#include "io/project/project-masonry.h"

#include <glib/gi18n.h>
#include <string.h>

static char *generate_output, *generate_title;
static double generate_friction = 0.65;
static gboolean generate_plain;

static const GOptionEntry generate_entries[] = {
  { "output", 'o', 0, G_OPTION_ARG_FILENAME, &generate_output,
    N_ ("Project file to write"), N_ ("MODEL.quoin") },
  { "title", 0, 0, G_OPTION_ARG_STRING, &generate_title, N_ ("Title of the project"),
    N_ ("TEXT") },
  { "friction", 0, 0, G_OPTION_ARG_DOUBLE, &generate_friction,
    N_ ("Friction coefficient of the dry joints (0.65)"), N_ ("MU") },
  { "plain", 0, 0, G_OPTION_ARG_NONE, &generate_plain,
    N_ ("Write plain blocks instead of parameters"), NULL },
  G_OPTION_ENTRY_NULL,
};

/* "--length 6", "--length=6" and "length=6" say the same. */
static void
run_generate (char **arguments)
{
  g_autoptr (GPtrArray) keys = g_ptr_array_new_null_terminated (1, g_free, TRUE);
  for (char **key = arguments + 1; *key != NULL; key++) {
    const char *name = *key + (g_str_has_prefix (*key, "--") ? 2 : 0);
    gboolean whole = name == *key || strchr (name, '=') != NULL || key[1] == NULL;
    g_ptr_array_add (keys,
                     whole ? g_strdup (name) : g_strconcat (name, "=", *++key, NULL));
  }
  if (generate_output == NULL)
    qn_cli_usage_error (_ ("-o is missing"));
  QnProject *project = qn_cli_keep (g_new0 (QnProject, 1));
  qn_cli_must (qn_project_generate (arguments[0], (const char *const *) keys->pdata,
                                    generate_friction, project, QN_TROUBLE));
  if (generate_plain)
    qn_project_detach_masonry (project);
  if (generate_title != NULL) {
    free (project->model.title);
    project->model.title = strdup (generate_title);
  }
  qn_cli_must (qn_project_save (project, generate_output, QN_TROUBLE));
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
  .options = generate_entries,
  .many = TRUE,
  .keys = TRUE,
  .run = run_generate,
};
