#include "cli/base/input.h"
#include "cli/base/message.h"
#include "cli/base/picture.h"
#include "cli/base/subcommand.h"
#include "doc/view/recipe.h"
#include "io/text/file-read.h"

#include <glib/gi18n.h>
#include <string.h>

static char *figures_folder;
static char **figures_names; /* make only these; NULL: all */
static gboolean figures_list;

/* The project with what was computed for its figures so far. */
typedef struct Workshop {
  const char *path;    /* of the project */
  char *folder;        /* where pictures go */
  char *result_folder; /* where results that recipes name are looked for */
  QnInput *input;      /* the project, and its own result once solved */
  gboolean is_solved;
} Workshop;

static void
must (const QnRecipe *recipe, gboolean done)
{
  if (!done)
    g_prefix_error (QN_TROUBLE, _ ("figure \"%s\": "), recipe->name);
  qn_cli_must (done);
}

static void
make (const QnRecipe *recipe, Workshop *shop)
{
  const QnInput *input = shop->input;
  QnFigure figure;
  g_autofree char *path =
    qn_file_inside (shop->folder, recipe->file, qn_allow_outside, QN_TROUBLE);
  must (recipe, path != NULL);
  if (recipe->result != NULL) {
    g_autofree char *result =
      qn_file_inside (shop->result_folder, recipe->result, qn_allow_outside, QN_TROUBLE);
    must (recipe, result != NULL);
    input = qn_input_load_with_result (shop->path, result);
  } else if (qn_recipe_needs_result (recipe) && !shop->is_solved) {
    /* One analysis serves all figures that need one. */
    qn_input_solve (shop->input);
    shop->is_solved = TRUE;
  }
  qn_recipe_fill (recipe, &input->project.model, &input->contacts,
                  recipe->result != NULL || shop->is_solved ? &input->file.result : NULL,
                  &figure);
  must (recipe, qn_picture_figure (&figure, input, path, &recipe->output));
  qn_print ("%s\n", path);
  if (qn_recipe_is_stale (recipe, &shop->input->project))
    qn_cli_warning (_ ("figure \"%s\": the model changed since the figure was stored"),
                    recipe->name);
}

static const GOptionEntry figures_entries[] = {
  { "output", 'o', 0, G_OPTION_ARG_FILENAME, &figures_folder,
    N_ ("Write the pictures here instead of beside the project"), N_ ("FOLDER") },
  { "figure", 0, 0, G_OPTION_ARG_STRING_ARRAY, &figures_names,
    N_ ("Make this figure only; may be given many times"), N_ ("NAME") },
  { "list", 0, 0, G_OPTION_ARG_NONE, &figures_list,
    N_ ("Only list the figures and whether the model changed since"), NULL },
  QN_INPUT_ENTRIES,
  G_OPTION_ENTRY_NULL,
};

static void
run_figures (char **arguments)
{
  Workshop shop = { .path = arguments[0],
                    .result_folder = qn_cli_keep (g_path_get_dirname (arguments[0])),
                    .input = qn_input_load (arguments[0]) };
  shop.folder = figures_folder != NULL ? figures_folder : shop.result_folder;
  g_autoptr (GPtrArray) recipes = qn_recipes_read (&shop.input->project, QN_TROUBLE);
  qn_cli_must (recipes != NULL);
  const char *const *names = (const char *const *) figures_names;
  /* Given names that no figure has are reported first. */
  for (char **name = figures_names; name != NULL && *name != NULL; name++) {
    gboolean found = FALSE;
    for (guint i = 0; i < recipes->len; i++)
      found |= strcmp (((QnRecipe *) g_ptr_array_index (recipes, i))->name, *name) == 0;
    if (!found)
      qn_cli_fail (QN_EXIT_USAGE, _ ("the project has no figure \"%s\""), *name);
  }
  qn_cli_must (figures_list || qn_recipes_check_files (recipes, names, QN_TROUBLE));
  if (recipes->len == 0)
    qn_cli_warning (_ ("%s: the project has no figures"), shop.path);
  for (guint i = 0; i < recipes->len; i++) {
    const QnRecipe *recipe = g_ptr_array_index (recipes, i);
    if (names != NULL && !g_strv_contains (names, recipe->name))
      continue;
    if (!figures_list)
      make (recipe, &shop);
    else
      qn_print (
        "%s\t%s\t%s\t%s\n", recipe->name, qn_view_names[recipe->view.view], recipe->file,
        qn_recipe_is_stale (recipe, &shop.input->project) ? _ ("the model changed")
                                                          : _ ("current"));
  }
}

const QnSubcommand qn_cmd_figures = {
  .name = "figures",
  .arguments = "MODEL",
  .summary = N_ ("Make every figure stored in the project again"),
  .help = N_ ("A figure that names no result is drawn from a new analysis; one analysis "
              "serves them all."),
  .options = figures_entries,
  .run = run_figures,
};
