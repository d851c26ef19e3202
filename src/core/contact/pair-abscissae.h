/* Positions and weights of the contact pairs of a face.
 *
 * Both are parts of the face's length; weights add up to 1. Polynomials of normal stress along the face
 * whose force and moment the sum over the pairs gives exactly:
 *
 *   ends       2 pairs, weight 1/2 each, `offset` from the corners: constant stress only; of a
 *              linear one (bending) the moment is 3 (1 - 2 offset)^2 times the true one
 *   lobatto    n pairs, the ends among them, at the abscissae of Gauss and Lobatto: polynomials up
 *              to degree 2n - 3, so bending from n = 3 on, and rocking about the corners; with
 *              an offset they all move inwards in proportion, (1 - 2 offset)^2 times the moment
 *   uniform    n pairs in the middle of n equal parts, the outer ones with a little more weight,
 *              the inner ones with a little less (+1.8 % and -1.2 % at n = 10), so that from n = 3 on
 *              linear stress has the right force and the right moment, cubic stress too; equal
 *              weights would lose 1/n^2 of the moment, which they do for n = 2. Yield of the whole
 *              section: 1 + 5/(16 n^2) times for large even n
 *   gauss      n pairs at the abscissae of Gauss and Legendre: polynomials up to degree 2n - 1,
 *              so that 2 pairs already have the stiffness of the continuous section
 *   explicit   as given: whatever the positions and weights integrate
 */
#pragma once

#include "core/model/model.h"

/* Completes a rule that leaves placement or number to the law. The functions below require complete
 * rules. */
QnPairRule qn_pair_rule_by_law (const QnPairRule *rule, const QnLaw *law);

/* Number of pairs that the rule puts on a face. */
size_t qn_pair_rule_count (const QnPairRule *rule);

/* Position and weight of pair i of a face of this length (m), ascending. */
void qn_pair_rule_place (const QnPairRule *rule, double length, size_t i,
                         double *position, double *weight);

/* Elastic bending stiffness by the pairs over the true one, of a face of this length. */
double qn_pair_rule_bending (const QnPairRule *rule, double length);

/* Largest factor by which the pairs overstate the moment capacity of a crushed face: maximum over all
 * normal forces N of the moment by pairs (those nearest to one end at their full strength fc b w_i) over
 * that of a stress block, N (b - N / fc) / 2 (thickness 1). The maximum is at a kink of the moment by
 * pairs. `per_pair`: all pairs have the same strength. */
double qn_pair_rule_crushing (const QnPairRule *rule, double length, bool per_pair);

/* Abscissa and weight number i of n on [-1, 1], ascending; weights add up to 2. */
void qn_gauss_legendre (size_t n, size_t i, double *abscissa, double *weight);
