/* Places of a project file ("laws[0].friction") in words: "Law “dry joint”: friction". */
#pragma once

#include "core/model/model.h"
#include <glib.h>

/* Names from the model; numbers count from one where there is none. The caller frees it. */
char *qn_path_dup_text (const QnModel *model, const char *path);

/* The message of an error about an override of that place without file, place and override, which the
 * window says otherwise. The caller frees it. */
char *qn_path_dup_reason (const char *message, const char *path);
