/* Cyclic protocols: each amplitude a some times to a, to -a and back to 0, every way a stage (QnStage.leg).
 * Protocols and ordinary stages are the entries of a project's list of stages, each known by the first of its
 * stages. */
#pragma once

#include "core/model/model.h"

/* Number of stages of an entry; 1: an ordinary stage. */
size_t qn_stage_span (const QnModel *model, size_t first);

/* The shortest list of amplitudes of a protocol, and the number of cycles of each. `amplitudes` has room for
 * qn_stage_span(). Returns the number of amplitudes; 0: an ordinary stage. */
size_t qn_stage_amplitudes (const QnModel *model, size_t first, double *amplitudes,
                            size_t *cycles);

/* Replaces an entry by a protocol with the settings and the name of its first stage; with count 0 by an
 * ordinary stage. Amplitudes are not 0; m or rad under displacement control, else multipliers. False when
 * memory runs out. */
bool qn_model_set_cycles (QnModel *model, size_t first, const double *amplitudes,
                          size_t count, size_t cycles);
