#include "io/project/project-vehicle.h"

#include "io/json/json-value.h"
#include "io/project/project-members.h"
#include "io/project/project-parts.h"
#include "io/text/file-read.h"
#include "io/text/json-text.h"

#include <gio/gio.h>
#include <glib/gi18n-lib.h>
#include <string.h>

/* Made by Meson of data/vehicles.json. */
GResource *qn_io_get_resource (void);

static const QnMember vehicle_members[] = {
  QN_KNOWN ("name"),
  QN_STRING ("source", OPTIONAL, QnVehicle, source),
  QN_TWO ("patch", REQUIRED, QnVehicle, patch),
  QN_NUMBER ("track", REQUIRED, NOT_NEGATIVE, QnVehicle, track),
  QN_KNOWN ("axles"),
  QN_KNOWN ("lines"),
  { 0 },
};

/* A list of rows of so many numbers. */
static gboolean
read_rows (const QnJsonValue *place, const char *key, int width, int most, double *rows,
           int32_t *count)
{
  QnJsonValue list, row = { 0 };
  *count = 0;
  if (!qn_member_array (place, key, QN_OPTIONAL, &list))
    return FALSE;
  while (qn_json_value_next (&list, &row)) {
    QnJsonValue number = { 0 };
    if (!qn_json_value_array (&row))
      return FALSE;
    if (cJSON_GetArraySize (row.json) != width || *count == most)
      return qn_json_value_failf (&row, _ ("expected up to %d rows of %d numbers"), most,
                                  width);
    while (qn_json_value_next (&row, &number))
      if (!qn_json_value_number (&number, QN_RANGE_FINITE,
                                 &rows[*count * width + (int) number.index]))
        return FALSE;
    (*count)++;
  }
  return TRUE;
}

static gboolean
read_vehicle (const QnJsonValue *place, QnModel *model, gpointer entity)
{
  QnVehicle *vehicle = entity;
  double axles[2 * QN_MAX_AXLES], lines[3 * QN_MAX_LINES];
  if (&model->vehicles[qn_model_find_vehicle (model, vehicle->name)] != vehicle)
    return qn_json_value_fail (place, _ (qn_problem_text (QN_PROBLEM_NAME_TAKEN)));
  if (!read_rows (place, "axles", 2, QN_MAX_AXLES, axles, &vehicle->axle_count)
      || !read_rows (place, "lines", 3, QN_MAX_LINES, lines, &vehicle->line_count))
    return FALSE;
  for (int i = 0; i < vehicle->axle_count; i++)
    vehicle->axles[i] = (QnAxle){ axles[2 * i], axles[2 * i + 1] };
  for (int i = 0; i < vehicle->line_count; i++)
    vehicle->lines[i] = (QnLineLoad){ lines[3 * i], lines[3 * i + 1], lines[3 * i + 2] };
  return TRUE;
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

static void
put_rows (GString *json, const char *key, const double *rows, gsize width, gsize count)
{
  if (count == 0)
    return;
  qn_json_begin_member (json, key);
  for (gsize i = 0; i < count; i++) {
    g_string_append (json, i == 0 ? "[" : ", ");
    qn_json_append_numbers (json, rows + i * width, width);
  }
  g_string_append_c (json, ']');
}

static void
append_vehicle (GString *json, const QnModel *model, size_t index)
{
  const QnVehicle *vehicle = &model->vehicles[index];
  const QnVehicle usual = { .track = -1 };
  qn_members_write (json, vehicle_members, NULL, vehicle, &usual);
  put_rows (json, "axles", &vehicle->axles[0].at, 2, (gsize) vehicle->axle_count);
  put_rows (json, "lines", &vehicle->lines[0].from, 3, (gsize) vehicle->line_count);
}

static bool
is_built_in (const QnModel *model, size_t index)
{
  return model->vehicles[index].built_in;
}

const QnList qn_vehicle_list = { QN_LIST ("vehicles", QnVehicle, vehicles, vehicle_count),
                                 .naming = QN_NAMING_REQUIRED,
                                 .members = vehicle_members,
                                 .read = read_vehicle,
                                 .append = append_vehicle,
                                 .is_left_out = is_built_in };
