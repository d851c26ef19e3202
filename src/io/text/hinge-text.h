/* Plastic hinges of beams in words, translated. */
#pragma once

#include "core/model/model.h"
#include "core/result/result.h"

#include <glib.h>

/* "2 plastic hinges: “beam” at “left corner”, “right” at “right corner”.", as they are at the last
 * step; NULL where no beam yields or its section forces are not known. Free with g_free(). */
char *qn_hinges_dup_text (const QnModel *model, const QnResult *result);
