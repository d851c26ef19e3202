#include "library/library-private.h"

#include <cjson/cJSON.h>
#include <string.h>

/* A project file in the making: finishing reads it as any other, so that every rule stands in one
 * place. */
struct QuoinBuilder {
  cJSON *root, *laws, *blocks, *dead, *live;
  GPtrArray *overrides; /* of char *: "path=value" */
};

/* Adds a number to an object or, where `key` is NULL, to a list. */
static void
add_number (cJSON *parent, const char *key, double value)
{
  cJSON *number = cJSON_CreateNumber (value);
  if (key != NULL)
    cJSON_AddItemToObject (parent, key, number);
  else
    cJSON_AddItemToArray (parent, number);
}

static cJSON *
add_vector (cJSON *parent, const char *key, double x, double y)
{
  cJSON *vector = cJSON_CreateArray ();
  add_number (vector, NULL, x);
  add_number (vector, NULL, y);
  if (key != NULL)
    cJSON_AddItemToObject (parent, key, vector);
  else
    cJSON_AddItemToArray (parent, vector);
  return vector;
}

static cJSON *
add_load (cJSON *list, const char *kind)
{
  cJSON *load = cJSON_CreateObject ();
  cJSON_AddStringToObject (load, "kind", kind);
  cJSON_AddItemToArray (list, load);
  return load;
}

QuoinBuilder *
quoin_builder_new (const char *title)
{
  QuoinBuilder *builder = g_new0 (QuoinBuilder, 1);
  cJSON *root = builder->root = cJSON_CreateObject ();
  cJSON_AddStringToObject (root, "format", "quoin");
  add_number (root, "version", 1);
  if (title != NULL)
    cJSON_AddStringToObject (root, "title", title);
  builder->laws = cJSON_AddArrayToObject (root, "laws");
  builder->blocks = cJSON_AddArrayToObject (root, "blocks");
  cJSON *loads = cJSON_AddObjectToObject (root, "loads");
  builder->dead = cJSON_AddArrayToObject (loads, "dead");
  builder->live = cJSON_AddArrayToObject (loads, "live");
  add_vector (add_load (builder->dead, "weight"), "direction", 0, -1);
  builder->overrides = g_ptr_array_new_with_free_func (g_free);
  return builder;
}

void
quoin_builder_free (QuoinBuilder *builder)
{
  if (builder == NULL)
    return;
  cJSON_Delete (builder->root);
  g_ptr_array_unref (builder->overrides);
  g_free (builder);
}

void
quoin_builder_add_joint (QuoinBuilder *builder, const char *name, double kn, double ks,
                         double friction, double dilatancy, double cohesion,
                         double tension)
{
  if (!(builder != NULL && name != NULL))
    return;
  cJSON *law = cJSON_CreateObject ();
  cJSON_AddStringToObject (law, "name", name);
  cJSON_AddStringToObject (law, "kind", "coulomb");
  cJSON_AddStringToObject (law, "basis", "contact");
  add_number (law, "kn", kn);
  add_number (law, "ks", ks);
  add_number (law, "friction", friction);
  add_number (law, "dilatancy", dilatancy);
  add_number (law, "cohesion", cohesion);
  add_number (law, "tension", tension);
  cJSON_AddItemToArray (builder->laws, law);
  if (cJSON_GetArraySize (builder->laws) == 1)
    cJSON_AddStringToObject (cJSON_AddObjectToObject (builder->root, "contact"), "law",
                             name);
}

void
quoin_builder_add_block (QuoinBuilder *builder, const char *name, const double *vertices,
                         size_t count, double thickness, double unit_weight, bool fixed)
{
  if (builder == NULL)
    return;
  cJSON *block = cJSON_CreateObject ();
  if (name != NULL)
    cJSON_AddStringToObject (block, "name", name);
  cJSON *list = cJSON_AddArrayToObject (block, "vertices");
  for (size_t i = 0; vertices != NULL && i < count; i++)
    add_vector (list, NULL, vertices[2 * i], vertices[2 * i + 1]);
  add_number (block, "thickness", thickness);
  add_number (block, "unit_weight", unit_weight);
  if (fixed) {
    cJSON *support = cJSON_AddArrayToObject (block, "support");
    for (int dof = 0; dof < QN_DOF_COUNT; dof++)
      cJSON_AddItemToArray (support, cJSON_CreateTrue ());
  }
  cJSON_AddItemToArray (builder->blocks, block);
}

void
quoin_builder_add_live_weight (QuoinBuilder *builder, double x, double y)
{
  if (builder == NULL)
    return;
  add_vector (add_load (builder->live, "weight"), "direction", x, y);
}

void
quoin_builder_add_force (QuoinBuilder *builder, const char *block, double x, double y,
                         double moment, bool live)
{
  if (!(builder != NULL && block != NULL))
    return;
  cJSON *load = add_load (live ? builder->live : builder->dead, "force");
  cJSON_AddStringToObject (load, "block", block);
  add_vector (load, "value", x, y);
  add_number (load, "moment", moment);
}

void
quoin_builder_set (QuoinBuilder *builder, const char *path, const char *value)
{
  if (!(builder != NULL && path != NULL && value != NULL))
    return;
  g_ptr_array_add (builder->overrides, g_strconcat (path, "=", value, NULL));
}

QuoinModel *
quoin_builder_finish (const QuoinBuilder *builder, QuoinError **error)
{
  if (!quoin_library_given (builder, "builder", error))
    return NULL;
  char *text = cJSON_Print (builder->root);
  if (text == NULL) {
    quoin_library_set_error (error, QUOIN_ERROR_NO_MEMORY, "out of memory");
    return NULL;
  }
  g_autoptr (GPtrArray) overrides = g_ptr_array_new ();
  for (guint i = 0; i < builder->overrides->len; i++)
    g_ptr_array_add (overrides, g_ptr_array_index (builder->overrides, i));
  g_ptr_array_add (overrides, NULL);
  QuoinModel *model = quoin_model_parse (text, strlen (text), "model",
                                         (const char *const *) overrides->pdata, error);
  cJSON_free (text);
  return model;
}
