/* Contact forces of every step in a result file: `forces`, two numbers a pair, `states`, a letter a
 * pair, and `damage`, the number of a pair whose bond is damaged and by how much, in turns. */
#pragma once

#include "core/result/result.h"
#include "io/json/json-tokens.h"
#include "io/text/file-writer.h"

/* Adds these members to a step that is being written, where the result has them. */
void qn_result_forces_write (QnFileWriter *writer, const QnResult *result, size_t step);

/* Reads them of a step, at these tokens (0: none), into a result with steps and pairs: all steps have
 * forces and states or none, and some have damage. */
gboolean qn_result_forces_read (QnJson *json, gsize at, gsize forces, gsize states,
                                gsize damage, QnResult *result, size_t step);
