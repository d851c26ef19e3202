#include "cli/base/input.h"
#include "cli/base/message.h"
#include "cli/base/picture.h"
#include "cli/base/shown-text.h"
#include "cli/base/subcommand.h"
#include "doc/view/recipe.h"
#include "io/text/file-read.h"

#include <glib/gi18n.h>
#include <string.h>

typedef struct FiguresOptions {
  char *folder;
  char **names; /* make only these; NULL: all */
  gboolean list;
  QnInputOptions input;
} FiguresOptions;

/* The project with what was computed for its figures so far. */
typedef struct Workshop {
  const char *path;    /* of the project */
  char *folder;        /* where pictures go */
  char *result_folder; /* where results that recipes name are looked for */
  QnInput *input;      /* the project, and its own result once solved */
  gboolean is_solved;
  const QnInputOptions *options;
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
  const gboolean outside = shop->options->allow_outside;
  const QnInput *input = shop->input;
  QnFigure figure;
  g_autofree char *path =
    qn_file_inside (shop->folder, recipe->file, outside, QN_TROUBLE);
  must (recipe, path != NULL);
  if (recipe->result != NULL) {
    g_autofree char *result =
      qn_file_inside (shop->result_folder, recipe->result, outside, QN_TROUBLE);
    must (recipe, result != NULL);
    input = qn_input_load_with_result (shop->path, result, shop->options);
  } else if (qn_recipe_needs_result (recipe) && !shop->is_solved) {
    /* One analysis serves all figures that need one. */
    qn_input_solve (shop->input, shop->options);
    shop->is_solved = TRUE;
  }
  qn_recipe_fill (recipe, &input->project.model, &input->contacts,
                  recipe->result != NULL || shop->is_solved ? &input->file.result : NULL,
                  &figure);
  must (recipe, qn_picture_figure (&figure, input, shop->options, path, &recipe->output));
  qn_print ("%s\n", path);
  if (qn_recipe_is_stale (recipe, &shop->input->project))
    qn_cli_warning (_ ("figure \"%s\": the model changed since the figure was stored"),
                    recipe->name);
}

/* Given names that no figure has are reported first. */
static void
check_names (const GPtrArray *recipes, const FiguresOptions *options)
{
  for (char **name = options->names; name != NULL && *name != NULL; name++) {
    gboolean found = FALSE;
    for (guint i = 0; i < recipes->len; i++)
      found |= strcmp (((QnRecipe *) g_ptr_array_index (recipes, i))->name, *name) == 0;
    if (!found)
      qn_cli_fail (QN_EXIT_USAGE, _ ("the project has no figure \"%s\""), *name);
  }
}

static void
make_all (const GPtrArray *recipes, const FiguresOptions *options, Workshop *shop)
{
  const char *const *names = (const char *const *) options->names;
  check_names (recipes, options);
  qn_cli_must (options->list || qn_recipes_check_files (recipes, names, QN_TROUBLE));
  if (recipes->len == 0)
    qn_cli_warning (_ ("%s: the project has no figures"), shop->path);
  for (guint i = 0; i < recipes->len; i++) {
    const QnRecipe *recipe = g_ptr_array_index (recipes, i);
    if (names != NULL && !g_strv_contains (names, recipe->name))
      continue;
    if (!options->list)
      make (recipe, shop);
    else
      qn_print (
        "%s\t%s\t%s\t%s\n", recipe->name, qn_view_names[recipe->view.view], recipe->file,
        qn_recipe_is_stale (recipe, &shop->input->project) ? _ ("the model changed")
                                                           : _ ("current"));
  }
}

static void
run_figures (const QnSubcommand *self, int argc, char **argv)
{
  FiguresOptions options = { 0 };
  const GOptionEntry entries[] = {
    { "output", 'o', 0, G_OPTION_ARG_FILENAME, &options.folder,
      N_ ("Write the pictures here instead of beside the project"), N_ ("FOLDER") },
    { "figure", 0, 0, G_OPTION_ARG_STRING_ARRAY, &options.names,
      N_ ("Make this figure only; may be given many times"), N_ ("NAME") },
    { "list", 0, 0, G_OPTION_ARG_NONE, &options.list,
      N_ ("Only list the figures and whether the model changed since"), NULL },
    QN_INPUT_ENTRIES (options.input),
    G_OPTION_ENTRY_NULL,
  };
  if (!qn_subcommand_parse (self, entries, 1, 1, &argc, &argv))
    return;
  Workshop shop = { .path = argv[1],
                    .result_folder = qn_cli_keep (g_path_get_dirname (argv[1])),
                    .input = qn_input_load (argv[1], &options.input),
                    .options = &options.input };
  shop.folder = options.folder != NULL ? options.folder : shop.result_folder;
  g_autoptr (GPtrArray) recipes = qn_recipes_read (&shop.input->project, QN_TROUBLE);
  qn_cli_must (recipes != NULL);
  make_all (recipes, &options, &shop);
}

const QnSubcommand qn_cmd_figures = {
  .name = "figures",
  .arguments = "MODEL",
  .summary = N_ ("Make every figure stored in the project again"),
  .help = N_ ("A figure that names no result is drawn from a new analysis; one analysis "
              "serves them all."),
  .run = run_figures,
};
