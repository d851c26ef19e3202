#include "cli/base/input.h"
#include "cli/base/message.h"
#include "cli/base/picture.h"
#include "cli/base/shown-text.h"
#include "cli/base/subcommand.h"
#include "cli/figure/sheet-input.h"
#include "doc/document/underlay.h"
#include "doc/view/recipe.h"
#include "doc/view/sheet.h"
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
  QnSheetItem solved;  /* the project, and its own result once solved */
  gboolean is_solved;
  const QnInputOptions *options;
} Workshop;

static QnExit
fail (const QnRecipe *recipe, GError *error)
{
  g_prefix_error (&error, _ ("figure \"%s\": "), recipe->name);
  return qn_cli_fail (error);
}

static QnExit
draw_recipe (const QnRecipe *recipe, const QnInput *input, const QnResult *result,
             const Workshop *shop, const char *path)
{
  QnFigure figure;
  QnMetadata metadata;
  GError *error = NULL;
  qn_recipe_fill (recipe, &input->project.model, &input->contacts, result, &figure);
  qn_project_get_metadata (&input->project, &metadata);
  bool done = qn_underlay_read (&input->project, shop->options->allow_outside,
                                &figure.options.underlay, &error)
              && qn_figure_export (&figure, path, &recipe->output, &metadata, &error);
  g_clear_pointer (&figure.options.underlay.image, cairo_surface_destroy);
  if (done)
    return QN_EXIT_DONE;
  return fail (recipe, error);
}

/* With the result file that the recipe names. */
static QnExit
draw_with_file (const QnRecipe *recipe, const Workshop *shop, const char *path)
{
  QnSheetItem item;
  GError *error = NULL;
  g_autofree char *result = qn_file_inside (shop->result_folder, recipe->result,
                                            shop->options->allow_outside, &error);
  if (result == NULL)
    return fail (recipe, error);
  QnExit code = qn_sheet_item_load (&item, shop->path, result, shop->options);
  if (code != QN_EXIT_DONE)
    return code;
  code = draw_recipe (recipe, &item.input, &item.file.result, shop, path);
  qn_sheet_item_clear (&item);
  return code;
}

static QnExit
make (const QnRecipe *recipe, Workshop *shop)
{
  GError *error = NULL;
  g_autofree char *path =
    qn_file_inside (shop->folder, recipe->file, shop->options->allow_outside, &error);
  if (path == NULL)
    return fail (recipe, error);
  QnExit code = QN_EXIT_DONE;
  if (recipe->result != NULL) {
    code = draw_with_file (recipe, shop, path);
  } else {
    /* One analysis serves all figures that need one. */
    if (qn_recipe_needs_result (recipe) && !shop->is_solved) {
      code = qn_sheet_item_solve (&shop->solved, shop->options);
      shop->is_solved = code == QN_EXIT_DONE;
    }
    if (code == QN_EXIT_DONE)
      code = draw_recipe (recipe, &shop->solved.input,
                          shop->is_solved ? &shop->solved.file.result : NULL, shop, path);
  }
  if (code != QN_EXIT_DONE)
    return code;
  qn_print ("%s\n", path);
  if (qn_recipe_is_stale (recipe, &shop->solved.input.project))
    qn_cli_warning (_ ("figure \"%s\": the model changed since the figure was stored"),
                    recipe->name);
  return QN_EXIT_DONE;
}

/* Given names that no figure has are reported first. */
static QnExit
check_names (const GPtrArray *recipes, const FiguresOptions *options)
{
  for (char **name = options->names; name != NULL && *name != NULL; name++) {
    gboolean found = FALSE;
    for (guint i = 0; i < recipes->len; i++)
      found |= strcmp (((QnRecipe *) g_ptr_array_index (recipes, i))->name, *name) == 0;
    if (!found) {
      qn_cli_error (_ ("the project has no figure \"%s\""), *name);
      return QN_EXIT_USAGE;
    }
  }
  return QN_EXIT_DONE;
}

static QnExit
make_all (const GPtrArray *recipes, const FiguresOptions *options, Workshop *shop)
{
  const char *const *names = (const char *const *) options->names;
  GError *error = NULL;
  QnExit code = check_names (recipes, options);
  if (code == QN_EXIT_DONE && !options->list
      && !qn_recipes_check_files (recipes, names, &error))
    code = qn_cli_fail (error);
  if (code == QN_EXIT_DONE && recipes->len == 0)
    qn_cli_warning (_ ("%s: the project has no figures"), shop->path);
  for (guint i = 0; i < recipes->len && code == QN_EXIT_DONE; i++) {
    const QnRecipe *recipe = g_ptr_array_index (recipes, i);
    if (names != NULL && !g_strv_contains (names, recipe->name))
      continue;
    if (!options->list) {
      code = make (recipe, shop);
      continue;
    }
    qn_print (
      "%s\t%s\t%s\t%s\n", recipe->name, qn_view_names[recipe->view.view], recipe->file,
      qn_recipe_is_stale (recipe, &shop->solved.input.project) ? _ ("the model changed")
                                                               : _ ("current"));
  }
  return code;
}

static QnExit
run_with (const FiguresOptions *options, const char *path)
{
  Workshop shop = { .path = path,
                    .result_folder = g_path_get_dirname (path),
                    .options = &options->input };
  shop.folder = g_strdup (options->folder != NULL ? options->folder : shop.result_folder);
  QnExit code = qn_input_load (&shop.solved.input, path, &options->input);
  if (code == QN_EXIT_DONE) {
    GError *error = NULL;
    g_autoptr (GPtrArray) recipes = qn_recipes_read (&shop.solved.input.project, &error);
    code = recipes != NULL ? make_all (recipes, options, &shop) : qn_cli_fail (error);
    qn_sheet_item_clear (&shop.solved);
  }
  g_free (shop.folder);
  g_free (shop.result_folder);
  return code;
}

static QnExit
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
  QnExit code = QN_EXIT_USAGE;
  if (qn_subcommand_parse (self, entries, 1, 1, &argc, &argv))
    code = run_with (&options, argv[1]);
  qn_subcommand_free_values (entries);
  return code;
}

const QnSubcommand qn_cmd_figures = {
  .name = "figures",
  .arguments = "MODEL",
  .summary = N_ ("Make every figure stored in the project again"),
  .help = N_ ("A figure that names no result is drawn from a new analysis; one analysis "
              "serves them all."),
  .run = run_figures,
};
