/* Part of the independent check of a result: the section forces of beams. */
#ifndef QN_IO_RESULT_CHECK_BEAMS_H
#define QN_IO_RESULT_CHECK_BEAMS_H

#include "io/result/result-check.h"

/* Adds what the ends of all elements exert on their bodies to the balance (a row of three for
 * every block and node; moments about centroids and nodes where they have moved to), and finds
 * the element whose end forces are least in balance with its own load. factors: of the load
 * sets. `deformation` is NULL where equilibrium is that of the undeformed structure. */
void qn_result_check_add_beams (const QnResultFile *file, const QnModel *model,
                                const double *deformation, const double *factors,
                                double *balance, QnResultCheck *check);

#endif
