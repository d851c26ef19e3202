#include "io/text/json-text.h"
#include "library/library-private.h"

#include <string.h>

/* A project file in the making: finishing reads it as any other, so that every rule stands in one
 * place. */
struct QuoinBuilder {
  GString *head;                        /* members before the lists */
  GString *laws, *blocks, *dead, *live; /* entries of these */
  GPtrArray *overrides;                 /* of char *: "path=value" */
};

static void
begin_entry (GString *list)
{
  g_string_append (list, list->len > 0 ? ",\n{" : "{");
}

/* "[x, y]", as a member or, where `key` is NULL, in a list. */
static void
put_vector (GString *json, const char *key, double x, double y)
{
  if (key != NULL)
    qn_json_begin_member (json, key);
  g_string_append_c (json, '[');
  qn_json_append_number (json, x);
  g_string_append (json, ", ");
  qn_json_append_number (json, y);
  g_string_append_c (json, ']');
}

static void
add_weight (GString *list, double x, double y)
{
  begin_entry (list);
  qn_json_put_string (list, "kind", "weight");
  put_vector (list, "direction", x, y);
  g_string_append_c (list, '}');
}

QuoinBuilder *
quoin_builder_new (const char *title)
{
  QuoinBuilder *builder = g_new0 (QuoinBuilder, 1);
  builder->head = g_string_new ("{ \"format\": \"quoin\", \"version\": 1");
  if (title != NULL)
    qn_json_put_string (builder->head, "title", title);
  builder->laws = g_string_new (NULL);
  builder->blocks = g_string_new (NULL);
  builder->dead = g_string_new (NULL);
  builder->live = g_string_new (NULL);
  add_weight (builder->dead, 0, -1);
  builder->overrides = g_ptr_array_new_with_free_func (g_free);
  return builder;
}

void
quoin_builder_free (QuoinBuilder *builder)
{
  if (builder == NULL)
    return;
  GString *const texts[] = { builder->head, builder->laws, builder->blocks, builder->dead,
                             builder->live };
  for (gsize i = 0; i < G_N_ELEMENTS (texts); i++)
    g_string_free (texts[i], TRUE);
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
  GString *laws = builder->laws;
  if (laws->len == 0) {
    g_string_append (builder->head, ", \"contact\": {");
    qn_json_put_string (builder->head, "law", name);
    g_string_append_c (builder->head, '}');
  }
  begin_entry (laws);
  qn_json_put_string (laws, "name", name);
  qn_json_put_string (laws, "kind", "coulomb");
  qn_json_put_string (laws, "basis", "contact");
  qn_json_put_number (laws, "kn", kn);
  qn_json_put_number (laws, "ks", ks);
  qn_json_put_number (laws, "friction", friction);
  qn_json_put_number (laws, "dilatancy", dilatancy);
  qn_json_put_number (laws, "cohesion", cohesion);
  qn_json_put_number (laws, "tension", tension);
  g_string_append_c (laws, '}');
}

void
quoin_builder_add_block (QuoinBuilder *builder, const char *name, const double *vertices,
                         size_t count, double thickness, double unit_weight, bool fixed)
{
  if (builder == NULL)
    return;
  GString *blocks = builder->blocks;
  begin_entry (blocks);
  if (name != NULL)
    qn_json_put_string (blocks, "name", name);
  qn_json_begin_member (blocks, "vertices");
  g_string_append_c (blocks, '[');
  for (size_t i = 0; vertices != NULL && i < count; i++) {
    g_string_append (blocks, i > 0 ? ", " : "");
    put_vector (blocks, NULL, vertices[2 * i], vertices[2 * i + 1]);
  }
  g_string_append_c (blocks, ']');
  qn_json_put_number (blocks, "thickness", thickness);
  qn_json_put_number (blocks, "unit_weight", unit_weight);
  g_string_append (blocks, fixed ? ", \"support\": [true, true, true]}" : "}");
}

void
quoin_builder_add_live_weight (QuoinBuilder *builder, double x, double y)
{
  if (builder != NULL)
    add_weight (builder->live, x, y);
}

void
quoin_builder_add_force (QuoinBuilder *builder, const char *block, double x, double y,
                         double moment, bool live)
{
  if (!(builder != NULL && block != NULL))
    return;
  GString *list = live ? builder->live : builder->dead;
  begin_entry (list);
  qn_json_put_string (list, "kind", "force");
  qn_json_put_string (list, "block", block);
  put_vector (list, "value", x, y);
  qn_json_put_number (list, "moment", moment);
  g_string_append_c (list, '}');
}

void
quoin_builder_set (QuoinBuilder *builder, const char *path, const char *value)
{
  if (builder != NULL && path != NULL && value != NULL)
    g_ptr_array_add (builder->overrides, g_strconcat (path, "=", value, NULL));
}

QuoinModel *
quoin_builder_finish (const QuoinBuilder *builder, QuoinError **error)
{
  if (!quoin_library_given (builder, "builder", error))
    return NULL;
  g_autofree char *text = g_strdup_printf (
    "%s,\n\"laws\": [%s],\n\"blocks\": [%s],\n\"loads\": { \"dead\": [%s], \"live\": "
    "[%s] } }\n",
    builder->head->str, builder->laws->str, builder->blocks->str, builder->dead->str,
    builder->live->str);
  g_autoptr (GPtrArray) overrides = g_ptr_array_new ();
  for (guint i = 0; i < builder->overrides->len; i++)
    g_ptr_array_add (overrides, g_ptr_array_index (builder->overrides, i));
  g_ptr_array_add (overrides, NULL);
  return quoin_model_parse (text, strlen (text), "model",
                            (const char *const *) overrides->pdata, error);
}
