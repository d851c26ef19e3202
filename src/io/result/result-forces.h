/* Contact forces of every step in a result file: `forces`, two numbers a pair, `states`, a letter a
 * pair, and `damage`, the number of a pair whose bond is damaged and by how much, in turns. */
#ifndef QN_IO_RESULT_FORCES_H
#define QN_IO_RESULT_FORCES_H

#include "core/result/result.h"
#include "io/json/json-stream.h"
#include "io/text/file-writer.h"

/* Adds these members to a step that is being written, where the result has them. */
void qn_result_forces_write (QnFileWriter *writer, const QnResult *result, size_t step);

/* What has been read of the steps so far. */
typedef struct QnStepForces {
  double *forces;
  uint8_t *states;
  struct {
    size_t step;
    double number;
  } * damage;
  size_t force_count, force_capacity, state_count, state_capacity;
  size_t damage_count, damage_capacity;
  size_t step; /* that is being read */
} QnStepForces;

/* One of the forces or of the damage, and all states of a step; `target` is QnStepForces * . */
gboolean qn_result_force_read (QnJsonStream *stream, gpointer target);
gboolean qn_result_damage_read (QnJsonStream *stream, gpointer target);
gboolean qn_result_states_read (QnJsonStream *stream, gpointer target);

/* Hands the forces over to the result. False where they are not those of all its pairs at all
 * its steps; none at all are right too. */
gboolean qn_result_forces_take (QnStepForces *forces, QnResult *result);

void qn_result_forces_clear (QnStepForces *forces);

#endif
