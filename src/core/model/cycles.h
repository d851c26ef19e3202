/* Cyclic protocols: each amplitude a some times to a, to -a and back to 0, every way a stage (QnStage.leg).
 * Protocols and ordinary stages are the entries of a project's list of stages, each known by the first of its
 * stages. */
#pragma once

#include "core/model/model.h"

/* How many stages an entry has; 1 of an ordinary one. */
size_t qn_stage_span (const QnModel *model, size_t first);

/* The amplitudes of a protocol, as few as say it, and how many cycles each has. `amplitudes` has room for
 * qn_stage_span(). Returns their number: 0 of an ordinary stage. */
size_t qn_stage_amplitudes (const QnModel *model, size_t first, double *amplitudes,
                            size_t *cycles);

/* Makes of an entry a protocol, its other settings and its name as those of its first stage; with count 0 an
 * ordinary stage. Amplitudes are not 0, m or rad where the first stage is controlled by a displacement and
 * multipliers where not. false: no memory. */
bool qn_model_set_cycles (QnModel *model, size_t first, const double *amplitudes,
                          size_t count, size_t cycles);
