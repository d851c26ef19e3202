/* Overrides of single values of a JSON document: analysis.increments=37. */
#pragma once

#include <cjson/cJSON.h>
#include <glib.h>

/* Replaces or adds one value of `root`, whose members and elements keep their order. The part
 * behind the first "=" is JSON, or else taken as a plain string. Missing objects on the way
 * are added; elements of arrays must be there. Errors: QN_IO_ERROR (_OVERRIDE where the path
 * leads nowhere), their messages starting with the override. */
gboolean qn_json_override (cJSON *root, const char *override, GError **error);

/* The path part of a well-formed override as qn_json_path_append_ writes it, or NULL; free with
 * g_free(). */
char *qn_json_override_dup_path (const char *override);
