/* Pieces of JSON text. */
#ifndef QN_IO_JSON_TEXT_H
#define QN_IO_JSON_TEXT_H

#include <glib.h>

/* Appends `text` (UTF-8) as a JSON string with its quotes. */
void qn_json_append_string (GString *json, const char *text);

#endif
