#include "io/project/project-vehicle.h"

#include "io/json/json-value.h"
#include "io/project/project-members.h"
#include "io/project/project-parts.h"
#include "io/text/file-read.h"

#include <gio/gio.h>
#include <glib/gi18n-lib.h>

/* Made by Meson of data/vehicles.json. */
GResource *qn_io_get_resource (void);

static const QnMember vehicle_members[] = {
  QN_KNOWN ("name"),
  QN_STRING ("source", OPTIONAL, QnVehicle, source),
  QN_TWO ("patch", REQUIRED, QnVehicle, patch),
  QN_NUMBER ("track", REQUIRED, NOT_NEGATIVE, QnVehicle, track),
  QN_ROWS ("axles", OPTIONAL, QN_MAX_AXLES, 2, QnVehicle, axles, axle_count),
  QN_ROWS ("lines", OPTIONAL, QN_MAX_LINES, 3, QnVehicle, lines, line_count),
  { 0 },
};

static gboolean
check_name (const QnJsonValue *place, QnModel *model, gpointer entity)
{
  const QnVehicle *vehicle = entity;
  return &model->vehicles[qn_model_find_vehicle (model, vehicle->name)] == vehicle
         || qn_json_value_fail (place, _ (qn_problem_text (QN_PROBLEM_NAME_TAKEN)));
}

static gboolean
read_text (const char *name, const char *text, gsize length, QnModel *model,
           GError **error)
{
  QnReader reader = { .name = name, .text = text, .length = length };
  cJSON *document = qn_json_parse (text, length, name, &reader.error);
  QnJsonValue root = qn_json_value_root (&reader, document);
  gboolean done =
    document != NULL && qn_read_list (&root, &qn_vehicle_list, QN_REQUIRED, model);
  cJSON_Delete (document);
  if (reader.warnings != NULL)
    g_ptr_array_unref (reader.warnings);
  if (!done)
    g_propagate_error (error, reader.error);
  return done;
}

/* The built-in vehicles in a model of their own. */
static gboolean
read_built_in (QnModel *model)
{
  g_autoptr (GBytes) bytes = g_resource_lookup_data (
    qn_io_get_resource (), "/io/github/quoin/vehicles.json", 0, NULL);
  gsize length;
  const char *text = g_bytes_get_data (bytes, &length);
  qn_model_init (model);
  return read_text ("vehicles.json", text, length, model, NULL);
}

char **
qn_dup_vehicle_names (const QnModel *model)
{
  QnModel list;
  GPtrArray *names = g_ptr_array_new ();
  for (gsize i = 0; model != NULL && i < model->vehicle_count; i++)
    g_ptr_array_add (names, g_strdup (model->vehicles[i].name));
  gboolean known = read_built_in (&list);
  for (gsize i = 0; known && i < list.vehicle_count; i++)
    if (model == NULL || qn_model_find_vehicle (model, list.vehicles[i].name) == QN_NONE)
      g_ptr_array_add (names, g_strdup (list.vehicles[i].name));
  g_ptr_array_add (names, NULL);
  qn_model_clear (&list);
  return (char **) g_ptr_array_free (names, FALSE);
}

QnId
qn_model_take_vehicle (QnModel *model, const char *name)
{
  QnModel list;
  QnId found = qn_model_find_vehicle (model, name);
  if (found != QN_NONE)
    return found;
  QnId known = read_built_in (&list) ? qn_model_find_vehicle (&list, name) : QN_NONE;
  QnVehicle *added = known != QN_NONE ? qn_model_add_vehicle (model, name) : NULL;
  if (added != NULL) {
    QnVehicle swapped = *added;
    *added = list.vehicles[known];
    list.vehicles[known] = swapped;
    added->built_in = true;
    found = (QnId) model->vehicle_count - 1;
  }
  qn_model_clear (&list);
  return found;
}

gboolean
qn_read_vehicle_file (const char *path, QnModel *model, GError **error)
{
  gsize length;
  g_autofree char *text = qn_file_read (path, &length, error);
  return text != NULL && read_text (path, text, length, model, error);
}

static bool
is_built_in (const QnModel *model, size_t index)
{
  return model->vehicles[index].built_in;
}

const QnList qn_vehicle_list = { QN_LIST ("vehicles", QnVehicle, vehicles, vehicle_count),
                                 .naming = QN_NAMING_REQUIRED, .members = vehicle_members,
                                 .read = check_name, .is_left_out = is_built_in };
