#include "doc/view/recipe.h"

#include "core/base/integer.h"
#include "io/project/project-members.h"
#include "io/project/project.h"
#include "io/text/io-error.h"
#include "io/text/json-text.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

/* By QnBackend. */
static const char *const backend_names[] = {
  [QN_BACKEND_CAIRO] = "cairo", [QN_BACKEND_GL] = "gl"
};

/* What is known alone is read and written by code. */
static const QnMember members[] = {
  QN_KNOWN ("name"),
  QN_KNOWN ("view"),
  QN_KNOWN ("file"),
  QN_STRING ("result", OPTIONAL, QnRecipe, result),
  QN_STRING ("title", OPTIONAL, QnRecipe, title),
  QN_STRING ("caption", OPTIONAL, QnRecipe, caption),
  QN_CHOICE ("field", OPTIONAL, qn_field_names, QnRecipe, view.field),
  QN_CHOICE ("diagram", READ, qn_diagram_names, QnRecipe, view.diagram),
  QN_KNOWN ("step"),
  QN_KNOWN ("scale"),
  QN_BOOL ("ghost", OPTIONAL, QnRecipe, view.ghost),
  QN_BOOL ("symbols", OPTIONAL, QnRecipe, view.symbols),
  QN_BOOL ("loads", OPTIONAL, QnRecipe, view.loads),
  QN_BOOL ("dimensions", OPTIONAL, QnRecipe, view.dimensions),
  QN_BOOL ("names", OPTIONAL, QnRecipe, view.names),
  QN_BOOL ("values", OPTIONAL, QnRecipe, view.values),
  QN_BOOL ("legend", OPTIONAL, QnRecipe, view.legend),
  QN_BOOL ("titles", OPTIONAL, QnRecipe, view.titles),
  QN_BOOL ("monochrome", OPTIONAL, QnRecipe, view.monochrome),
  QN_KNOWN ("size"),
  QN_NUMBER ("dpi", OPTIONAL, POSITIVE, QnRecipe, output.dpi),
  QN_BOOL ("transparent", OPTIONAL, QnRecipe, output.transparent),
  QN_CHOICE ("backend", OPTIONAL, backend_names, QnRecipe, output.backend),
  QN_STRING ("model_digest", OPTIONAL, QnRecipe, digest),
  { 0 },
};

QnRecipe *
qn_recipe_new (const char *name, QnView view)
{
  QnRecipe *recipe = g_new0 (QnRecipe, 1);
  recipe->name = g_strdup (name);
  recipe->file = g_strconcat (name, ".png", NULL);
  qn_view_options_init (&recipe->view, view);
  qn_output_init (&recipe->output);
  return recipe;
}

void
qn_recipe_free (QnRecipe *recipe)
{
  if (recipe == NULL)
    return;
  g_free (recipe->name);
  g_free (recipe->file);
  g_free (recipe->result);
  g_free (recipe->title);
  g_free (recipe->caption);
  g_free (recipe->digest);
  g_free (recipe);
}

/* ---- reading --------------------------------------------------------------------------- */

/* A member that is a number or one word with a meaning of its own ("last", "auto"). */
static gboolean
read_number_or (const QnJsonValue *object, const char *key, const char *word,
                double *number)
{
  QnJsonValue place = qn_json_value_member (object, key);
  const char *text = NULL;
  if (place.json == NULL)
    return TRUE;
  if (place.json->type == cJSON_String) {
    if (!qn_member_string (object, key, QN_REQUIRED, &text))
      return FALSE;
    return strcmp (text, word) == 0
           || qn_json_value_failf (&place, _ ("must be a number or \"%s\""), word);
  }
  return qn_json_value_number (&place, QN_RANGE_NOT_NEGATIVE, number);
}

static gboolean
read_size (const QnJsonValue *object, QnOutput *output)
{
  const char *size = NULL;
  g_autoptr (GError) error = NULL;
  QnPage page;
  if (!qn_member_string (object, "size", QN_OPTIONAL, &size))
    return FALSE;
  if ((size == NULL || qn_output_parse_size (output, size, &error))
      && qn_output_page (output, &page, &error))
    return TRUE;
  QnJsonValue place = qn_json_value_member (object, size != NULL ? "size" : "dpi");
  return qn_json_value_fail (&place, error->message);
}

static gboolean
read_step_and_scale (const QnJsonValue *object, QnViewOptions *view)
{
  double step = QN_STEP_LAST;
  view->scale = QN_SCALE_AUTO;
  if (!read_number_or (object, "step", "last", &step)
      || !read_number_or (object, "scale", "auto", &view->scale))
    return FALSE;
  QnJsonValue place = qn_json_value_member (object, "step");
  if (step > G_MAXINT32 || step != floor (step))
    return qn_json_value_fail (&place, _ ("must be a whole number"));
  view->step = (int32_t) qn_to_integer (step, G_MININT32, G_MAXINT32);
  return TRUE;
}

/* A name becomes a file name where the recipe has no other: no folders in it. */
static gboolean
check_name (const QnJsonValue *object, const char *name, GHashTable *known)
{
  QnJsonValue place = qn_json_value_member (object, "name");
  if (*name == '\0' || strchr (name, G_DIR_SEPARATOR) != NULL || *name == '.')
    return qn_json_value_fail (&place, _ ("must be a name without folders"));
  return g_hash_table_add (known, (gpointer) name)
         || qn_json_value_fail (&place, _ ("name is used twice"));
}

static gboolean
read_file (const QnJsonValue *object, QnRecipe *recipe)
{
  const char *file = NULL;
  QnFormat format;
  GError *error = NULL;
  if (!qn_member_string (object, "file", QN_OPTIONAL, &file))
    return FALSE;
  if (file == NULL)
    return TRUE;
  g_free (recipe->file);
  recipe->file = g_strdup (file);
  if (strcmp (file, "-") != 0 && qn_format_of_path (file, &format, &error))
    return TRUE;
  QnJsonValue place = qn_json_value_member (object, "file");
  qn_json_value_fail (&place, error != NULL ? error->message
                                            : _ ("must be the name of a picture"));
  g_clear_error (&error);
  return FALSE;
}

/* known: names of the recipes before, borrowed from the tree. */
static QnRecipe *
read_recipe (const QnJsonValue *object, GHashTable *known)
{
  const char *name;
  QnView view = QN_VIEW_MODEL;
  if (!qn_members_check (object, members, NULL, NULL)
      || !qn_member_string (object, "name", QN_REQUIRED, &name)
      || !check_name (object, name, known)
      || !qn_member_choice (object, "view", QN_OPTIONAL, qn_view_names, QN_VIEW_COUNT,
                            &view))
    return NULL;
  g_autoptr (QnRecipe) recipe = qn_recipe_new (name, view);
  if (!read_file (object, recipe) || !qn_members_take (object, members, NULL, recipe)
      || !read_step_and_scale (object, &recipe->view)
      || !read_size (object, &recipe->output))
    return NULL;
  return g_steal_pointer (&recipe);
}

GPtrArray *
qn_recipes_read (const QnProject *project, GError **error)
{
  g_autoptr (GPtrArray) recipes =
    g_ptr_array_new_with_free_func ((GDestroyNotify) qn_recipe_free);
  g_autoptr (GHashTable) known = g_hash_table_new (g_str_hash, g_str_equal);
  QnReader reader = qn_project_reader (project);
  QnJsonValue root = qn_json_value_root (&reader, project->extras);
  QnJsonValue list, element = { 0 };
  gboolean sound = qn_member_array (&root, "figures", QN_OPTIONAL, &list);
  while (sound && qn_json_value_next (&list, &element)) {
    QnRecipe *recipe = read_recipe (&element, known);
    sound = recipe != NULL;
    if (sound)
      g_ptr_array_add (recipes, recipe);
  }
  if (sound)
    return g_steal_pointer (&recipes);
  g_propagate_error (error, reader.error);
  return NULL;
}

/* ---- writing --------------------------------------------------------------------------- */

static void
append_recipe (GString *json, const QnRecipe *recipe)
{
  g_autoptr (QnRecipe) plain = qn_recipe_new (recipe->name, recipe->view.view);
  const QnOutput *output = &recipe->output;
  const QnViewOptions *view = &recipe->view;
  g_string_append_c (json, '{');
  qn_json_put_string (json, "name", recipe->name);
  qn_json_put_string (json, "view", qn_view_names[view->view]);
  if (strcmp (recipe->file, plain->file) != 0)
    qn_json_put_string (json, "file", recipe->file);
  if (view->view == QN_VIEW_DIAGRAMS)
    qn_json_put_string (json, "diagram", qn_diagram_names[view->diagram]);
  if (view->step != QN_STEP_LAST)
    qn_json_put_number (json, "step", view->step);
  if (view->scale > 0)
    qn_json_put_number (json, "scale", view->scale);
  char width[G_ASCII_DTOSTR_BUF_SIZE], height[G_ASCII_DTOSTR_BUF_SIZE];
  const char *unit = output->millimetres ? "mm" : "";
  g_ascii_formatd (width, sizeof width, "%.10g", output->width);
  g_ascii_formatd (height, sizeof height, "%.10g", output->height);
  g_autofree char *size = g_strdup_printf ("%s%sx%s%s", width, unit, height, unit);
  qn_json_put_string (json, "size", size);
  qn_members_write (json, members, NULL, recipe, plain);
  g_string_append (json, " }");
}

gboolean
qn_recipes_check_files (const GPtrArray *recipes, const char *const *names,
                        GError **error)
{
  g_autoptr (GHashTable) taken =
    g_hash_table_new_full (g_str_hash, g_str_equal, g_free, NULL);
  for (guint i = 0; i < recipes->len; i++) {
    const QnRecipe *recipe = g_ptr_array_index (recipes, i);
    if ((names != NULL && !g_strv_contains (names, recipe->name))
        || g_hash_table_add (taken, g_canonicalize_filename (recipe->file, "/")))
      continue;
    return qn_io_fail (error, QN_IO_ERROR_INVALID,
                       _ ("figure \"%s\": another figure is the same file, %s"),
                       recipe->name, recipe->file);
  }
  return TRUE;
}

char *
qn_recipes_to_json (const GPtrArray *recipes)
{
  GString *json = g_string_new ("[");
  for (guint i = 0; i < recipes->len; i++) {
    if (i > 0)
      g_string_append (json, ", ");
    append_recipe (json, g_ptr_array_index (recipes, i));
  }
  g_string_append_c (json, ']');
  return g_string_free (json, FALSE);
}

/* ---- drawing --------------------------------------------------------------------------- */

bool
qn_recipe_needs_result (const QnRecipe *recipe)
{
  return qn_view_needs_result (recipe->view.view) || recipe->view.field != QN_FIELD_NONE;
}

void
qn_recipe_fill (const QnRecipe *recipe, const QnModel *model, const QnContacts *contacts,
                const QnResult *result, QnFigure *figure)
{
  qn_figure_init (figure, model, contacts, result, recipe->view.view);
  figure->options = recipe->view;
  figure->title = recipe->title;
  figure->caption = recipe->caption;
}

bool
qn_recipe_is_stale (const QnRecipe *recipe, const QnProject *project)
{
  if (recipe->digest == NULL)
    return false;
  g_autofree char *digest = qn_model_digest (project, NULL);
  return strcmp (digest, recipe->digest) != 0;
}
