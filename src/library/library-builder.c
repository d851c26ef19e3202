#include "io/text/file-writer.h"
#include "library/library-private.h"

#include <string.h>

/* A project file in the making: finishing reads it as any other, so that every rule stands in one
 * place. */
enum { HEAD, LAWS, BLOCKS, DEAD, LIVE, PART_COUNT };

struct QuoinBuilder {
  QnFileWriter *parts[PART_COUNT]; /* members before the lists; entries of these */
  GPtrArray *overrides;            /* of char *: "path=value" */
};

/* The writer of a list, behind the entries that it has. */
static QnFileWriter *
next_entry (QuoinBuilder *builder, int list)
{
  const GString *before = qn_file_writer_buffer (builder->parts[list]);
  qn_file_writer_puts (builder->parts[list], before->len > 0 ? ",\n" : "");
  return builder->parts[list];
}

static void
add_weight (QuoinBuilder *builder, int list, double x, double y)
{
  qn_file_writer_json (next_entry (builder, list),
                       "{\"kind\": \"weight\", \"direction\": [%f, %f]}", x, y);
}

QuoinBuilder *
quoin_builder_new (const char *title)
{
  QuoinBuilder *builder = g_new0 (QuoinBuilder, 1);
  for (int i = 0; i < PART_COUNT; i++)
    builder->parts[i] = qn_file_writer_new_in_memory ();
  qn_file_writer_puts (builder->parts[HEAD], "{ \"format\": \"quoin\", \"version\": 1");
  if (title != NULL)
    qn_file_writer_json (builder->parts[HEAD], ", \"title\": %s", title);
  add_weight (builder, DEAD, 0, -1);
  builder->overrides = g_ptr_array_new_null_terminated (0, g_free, TRUE);
  return builder;
}

void
quoin_builder_free (QuoinBuilder *builder)
{
  gsize length;
  if (builder == NULL)
    return;
  for (int i = 0; i < PART_COUNT; i++)
    g_free (qn_file_writer_steal (builder->parts[i], &length));
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
  if (qn_file_writer_buffer (builder->parts[LAWS])->len == 0)
    qn_file_writer_json (builder->parts[HEAD], ", \"contact\": {\"law\": %s}", name);
  qn_file_writer_json (next_entry (builder, LAWS),
                       "{\"name\": %s, \"kind\": \"coulomb\", \"basis\": \"contact\", "
                       "\"kn\": %f, \"ks\": %f, \"friction\": %f, \"dilatancy\": %f, "
                       "\"cohesion\": %f, \"tension\": %f}",
                       name, kn, ks, friction, dilatancy, cohesion, tension);
}

void
quoin_builder_add_block (QuoinBuilder *builder, const char *name, const double *vertices,
                         size_t count, double thickness, double unit_weight, bool fixed)
{
  if (builder == NULL)
    return;
  QnFileWriter *blocks = next_entry (builder, BLOCKS);
  if (name != NULL)
    qn_file_writer_json (blocks, "{\"name\": %s, \"vertices\": [", name);
  else
    qn_file_writer_puts (blocks, "{\"vertices\": [");
  for (size_t i = 0; vertices != NULL && i < count; i++)
    qn_file_writer_json (blocks, i > 0 ? ", [%f, %f]" : "[%f, %f]", vertices[2 * i],
                         vertices[2 * i + 1]);
  qn_file_writer_json (blocks, "], \"thickness\": %f, \"unit_weight\": %f", thickness,
                       unit_weight);
  qn_file_writer_puts (blocks, fixed ? ", \"support\": [true, true, true]}" : "}");
}

void
quoin_builder_add_live_weight (QuoinBuilder *builder, double x, double y)
{
  if (builder != NULL)
    add_weight (builder, LIVE, x, y);
}

void
quoin_builder_add_force (QuoinBuilder *builder, const char *block, double x, double y,
                         double moment, bool live)
{
  if (builder != NULL && block != NULL)
    qn_file_writer_json (next_entry (builder, live ? LIVE : DEAD),
                         "{\"kind\": \"force\", \"block\": %s, \"value\": [%f, %f], "
                         "\"moment\": %f}",
                         block, x, y, moment);
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
  const char *parts[PART_COUNT];
  for (int i = 0; i < PART_COUNT; i++)
    parts[i] = qn_file_writer_buffer (builder->parts[i])->str;
  g_autofree char *text = g_strdup_printf (
    "%s,\n\"laws\": [%s],\n\"blocks\": [%s],\n\"loads\": { \"dead\": [%s], \"live\": "
    "[%s] } }\n",
    parts[HEAD], parts[LAWS], parts[BLOCKS], parts[DEAD], parts[LIVE]);
  return quoin_model_parse (text, strlen (text), "model",
                            (const char *const *) builder->overrides->pdata, error);
}
