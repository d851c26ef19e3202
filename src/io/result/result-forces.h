/* Contact forces of every step in a result file: `forces`, two numbers a pair, and `states`, a
 * letter a pair. */
#ifndef QN_IO_RESULT_FORCES_H
#define QN_IO_RESULT_FORCES_H

#include "core/result/result.h"
#include "io/json/json-stream.h"
#include "io/text/file-writer.h"

/* Adds both members to a step that is being written, where the result has them. */
void qn_result_forces_write (QnFileWriter *writer, const QnResult *result, size_t step);

/* What has been read of the steps so far. */
typedef struct QnStepForces {
  double *forces;
  uint8_t *states;
  size_t force_count, force_capacity, state_count, state_capacity;
} QnStepForces;

/* One of the forces, and all states of a step; `target` is QnStepForces * . */
gboolean qn_result_force_read (QnJsonStream *stream, gpointer target);
gboolean qn_result_states_read (QnJsonStream *stream, gpointer target);

/* Hands the forces over to the result. False where they are not those of all its pairs at all
 * its steps; none at all are right too. */
gboolean qn_result_forces_take (QnStepForces *forces, QnResult *result);

void qn_result_forces_clear (QnStepForces *forces);

#endif
