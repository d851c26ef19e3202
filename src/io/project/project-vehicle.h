/* Vehicles of a project file, and those that are built in (data/vehicles.json). */
#pragma once

#include "core/model/model.h"
#include "io/json/json-value.h"

/* Names of the vehicles of a model (nullable), and of those that are built in behind them, ended by NULL:
 * g_strfreev(). */
char **qn_dup_vehicle_names (const QnModel *model);

/* The vehicle of a model with this name; a built-in one is added where the model has none. QN_NONE where
 * there is none, or without memory. */
QnId qn_model_take_vehicle (QnModel *model, const char *name);

/* Adds the vehicles of a file that consists of them; FALSE with `error` set. */
gboolean qn_read_vehicle_file (const char *path, QnModel *model, GError **error);
