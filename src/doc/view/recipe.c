#include "doc/view/recipe.h"

#include "core/base/integer.h"
#include "doc/document/digest.h"
#include "io/project/project-extras.h"
#include "io/text/io-error.h"
#include "io/text/json-text.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

static const char *const keys[] = {
  "name",    "file",        "view",    "field",        "step",       "scale",
  "size",    "dpi",         "title",   "caption",      "result",     "ghost",
  "symbols", "loads",       "legend",  "names",        "dimensions", "monochrome",
  "titles",  "transparent", "backend", "model_digest", "diagram",    "values",
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

/* By QnBackend. */
static const char *const backend_names[] = {
  [QN_BACKEND_CAIRO] = "cairo", [QN_BACKEND_GL] = "gl"
};

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
read_output (const QnJsonValue *object, QnOutput *output)
{
  const char *size = NULL;
  QnBackend backend = QN_BACKEND_CAIRO;
  GError *error = NULL;
  QnPage page;
  if (!qn_member_string (object, "size", QN_OPTIONAL, &size)
      || !qn_member_number (object, "dpi", QN_OPTIONAL, QN_RANGE_POSITIVE, &output->dpi)
      || !qn_member_bool (object, "transparent", QN_OPTIONAL, &output->transparent)
      || !qn_member_choice (object, "backend", QN_OPTIONAL, backend_names, 2, &backend))
    return FALSE;
  output->backend = backend;
  if ((size != NULL && !qn_output_parse_size (output, size, &error))
      || !qn_output_page (output, &page, &error)) {
    QnJsonValue place = qn_json_value_member (object, size != NULL ? "size" : "dpi");
    qn_json_value_fail (&place, error->message);
    g_clear_error (&error);
    return FALSE;
  }
  return TRUE;
}

static gboolean
read_view (const QnJsonValue *object, QnViewOptions *view)
{
  QnField field = QN_FIELD_NONE;
  QnDiagram diagram = QN_DIAGRAM_MOMENT;
  double step = QN_STEP_LAST, scale = QN_SCALE_AUTO;
  if (!qn_member_choice (object, "field", QN_OPTIONAL, qn_field_names, QN_FIELD_COUNT,
                         &field)
      || !qn_member_choice (object, "diagram", QN_OPTIONAL, qn_diagram_names,
                            QN_DIAGRAM_COUNT, &diagram)
      || !read_number_or (object, "step", "last", &step)
      || !read_number_or (object, "scale", "auto", &scale))
    return FALSE;
  if (step > G_MAXINT32 || step != floor (step)) {
    QnJsonValue place = qn_json_value_member (object, "step");
    return qn_json_value_fail (&place, _ ("must be a whole number"));
  }
  view->field = field;
  view->diagram = diagram;
  view->step = (int32_t) qn_to_integer (step, G_MININT32, G_MAXINT32);
  view->scale = scale;
  for (size_t i = 0; qn_view_switches[i] != NULL; i++)
    if (!qn_member_bool (object, qn_view_switches[i], QN_OPTIONAL,
                         qn_view_switch (view, qn_view_switches[i])))
      return FALSE;
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
  const char *name, *title = NULL, *caption = NULL, *result = NULL, *digest = NULL;
  QnView view = QN_VIEW_MODEL;
  if (!qn_json_value_object (object)
      || !qn_member_string (object, "name", QN_REQUIRED, &name)
      || !check_name (object, name, known)
      || !qn_member_choice (object, "view", QN_OPTIONAL, qn_view_names, QN_VIEW_COUNT,
                            &view))
    return NULL;
  g_autoptr (QnRecipe) recipe = qn_recipe_new (name, view);
  if (!read_file (object, recipe) || !read_view (object, &recipe->view)
      || !read_output (object, &recipe->output)
      || !qn_member_string (object, "title", QN_OPTIONAL, &title)
      || !qn_member_string (object, "caption", QN_OPTIONAL, &caption)
      || !qn_member_string (object, "result", QN_OPTIONAL, &result)
      || !qn_member_string (object, "model_digest", QN_OPTIONAL, &digest))
    return NULL;
  recipe->title = g_strdup (title);
  recipe->caption = g_strdup (caption);
  recipe->result = g_strdup (result);
  recipe->digest = g_strdup (digest);
  qn_json_value_warn_unknown (object, keys, G_N_ELEMENTS (keys));
  return g_steal_pointer (&recipe);
}

GPtrArray *
qn_recipes_read (const QnProject *project, GPtrArray *warnings, GError **error)
{
  g_autoptr (GPtrArray) recipes =
    g_ptr_array_new_with_free_func ((GDestroyNotify) qn_recipe_free);
  g_autoptr (GHashTable) known = g_hash_table_new (g_str_hash, g_str_equal);
  QnReader reader = qn_project_reader (project);
  reader.warnings = warnings;
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
append_key (GString *json, const char *key)
{
  if (json->str[json->len - 1] != '{')
    g_string_append (json, ", ");
  qn_json_append_string (json, key);
  g_string_append (json, ": ");
}

static void
append_text (GString *json, const char *key, const char *text)
{
  if (text == NULL)
    return;
  append_key (json, key);
  qn_json_append_string (json, text);
}

static void
append_number (GString *json, const char *key, double number)
{
  append_key (json, key);
  qn_json_append_number (json, number);
}

static void
append_bool (GString *json, const char *key, bool flag)
{
  append_key (json, key);
  g_string_append (json, flag ? "true" : "false");
}

static void
append_recipe (GString *json, const QnRecipe *recipe)
{
  QnRecipe *plain = qn_recipe_new (recipe->name, recipe->view.view);
  const QnOutput *output = &recipe->output;
  QnViewOptions view = recipe->view;
  g_string_append_c (json, '{');
  append_text (json, "name", recipe->name);
  append_text (json, "view", qn_view_names[view.view]);
  if (strcmp (recipe->file, plain->file) != 0)
    append_text (json, "file", recipe->file);
  append_text (json, "result", recipe->result);
  append_text (json, "title", recipe->title);
  append_text (json, "caption", recipe->caption);
  if (view.field != QN_FIELD_NONE)
    append_text (json, "field", qn_field_names[view.field]);
  if (view.view == QN_VIEW_DIAGRAMS)
    append_text (json, "diagram", qn_diagram_names[view.diagram]);
  if (view.step != QN_STEP_LAST)
    append_number (json, "step", view.step);
  if (view.scale > 0)
    append_number (json, "scale", view.scale);
  for (size_t i = 0; qn_view_switches[i] != NULL; i++) {
    bool flag = *qn_view_switch (&view, qn_view_switches[i]);
    if (flag != *qn_view_switch (&plain->view, qn_view_switches[i]))
      append_bool (json, qn_view_switches[i], flag);
  }
  char width[G_ASCII_DTOSTR_BUF_SIZE], height[G_ASCII_DTOSTR_BUF_SIZE];
  const char *unit = output->millimetres ? "mm" : "";
  g_ascii_formatd (width, sizeof width, "%.10g", output->width);
  g_ascii_formatd (height, sizeof height, "%.10g", output->height);
  g_autofree char *size = g_strdup_printf ("%s%sx%s%s", width, unit, height, unit);
  append_text (json, "size", size);
  if (output->dpi > 0)
    append_number (json, "dpi", output->dpi);
  if (output->transparent)
    append_bool (json, "transparent", true);
  if (output->backend == QN_BACKEND_GL)
    append_text (json, "backend", "gl");
  append_text (json, "model_digest", recipe->digest);
  g_string_append_c (json, '}');
  qn_recipe_free (plain);
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
    g_set_error (error, QN_IO_ERROR, QN_IO_ERROR_INVALID,
                 _ ("figure \"%s\": another figure is the same file, %s"), recipe->name,
                 recipe->file);
    return FALSE;
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
  return recipe->view.view == QN_VIEW_DEFORMED || recipe->view.view == QN_VIEW_MECHANISM
         || recipe->view.view == QN_VIEW_FORCES || recipe->view.view == QN_VIEW_DIAGRAMS
         || recipe->view.field != QN_FIELD_NONE;
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
  g_autofree char *digest = qn_model_digest (project);
  return strcmp (digest, recipe->digest) != 0;
}
