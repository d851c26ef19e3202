/* Independent check of a result: is the written state an equilibrium that the joints can carry?
 *
 * It uses nothing of the solver. From the result file it takes the contact points, normals,
 * forces, the section forces of beams and the multiplier; from the project file the blocks,
 * nodes, loads and laws. It sums forces and moments on every free degree of freedom and compares
 * every pair's force (n > 0 in tension) with |t| <= c - mu n and n <= ft of the laws on both of
 * its sides.
 */
#ifndef QN_IO_RESULT_CHECK_H
#define QN_IO_RESULT_CHECK_H

#include "io/result/result-file.h"

typedef struct QnResultCheck {
  double multiplier; /* of the equilibrium that was checked */

  double out_of_balance; /* largest over the free degrees of freedom, over `force_scale`;
                            moments count with the arm sqrt(block area) */
  QnId unbalanced_block; /* where, or QN_NONE when nothing, or something else, is */
  QnId unbalanced_node;  /* the same for a node of beams, */
  QnId unbalanced_element;       /* or for an element of a beam under its own load */
  double element_out_of_balance; /* N: the largest of these */
  double beam_scale; /* N: largest end force of an element, or force of a tie */
  double tie_excess; /* N: most that a tie has above its strength, or below none */
  double
    force_scale; /* N: largest weight of a free block, or load where they are weightless, or
                        force of a contact or beam */

  double
    yield_violation; /* largest over the pairs, over `contact_scale`; of the ties, over the
                             largest force */
  QnId violating_pair;  /* where, or QN_NONE */
  double contact_scale; /* N: largest contact force */

  double
    point_distance;  /* m: largest distance of a contact point from the outline of either
                            of its blocks */
  QnId distant_pair; /* where, or QN_NONE */
} QnResultCheck;

/* Checks `file` against the project it was computed from, loaded with the file's overrides. In
 * nonlinear geometry the blocks are taken where the last step has moved them. False with an
 * error where the two do not belong together, or where there is nothing to check. */
gboolean qn_result_check (const QnResultFile *file, const QnProject *project,
                          QnResultCheck *check, GError **error);

#endif
