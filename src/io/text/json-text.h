/* Pieces of JSON text. */
#pragma once

#include <glib.h>

struct cJSON;

/* Appends `text` (UTF-8) as a JSON string with its quotes. */
void qn_json_append_string (GString *json, const char *text);

/* Appends the shortest text of a number; see text-format.h. */
void qn_json_append_number (GString *json, double number);

/* Appends a tree: arrays and objects on one line where they fit, otherwise a line per value,
 * indented by two more spaces than `indent`. */
void qn_json_append_value (GString *json, const struct cJSON *value, guint indent);

/* Members of an object on one line: each puts a comma before itself unless it is the first, behind a
 * bracket or a space. The value follows qn_json_begin_member(). */
void qn_json_begin_member (GString *json, const char *key);
void qn_json_put_string (GString *json, const char *key, const char *text);
void qn_json_put_number (GString *json, const char *key, double number);
