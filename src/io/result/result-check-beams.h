/* Part of the independent check of a result: the section forces of beams, the forces of ties. */
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

/* The same of the ties, whose ends have moved with their blocks; and how much their forces are outside of
 * what they carry. */
void qn_result_check_add_ties (const QnResultFile *file, const QnModel *model,
                               const double *deformation, double *balance,
                               QnResultCheck *check);

#endif
