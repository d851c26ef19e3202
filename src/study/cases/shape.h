/* The shape of a mechanism, in a form that is comparable between cases with different blocks.
 *
 * The field of velocities is taken at the points of a grid over the box around the structure, at
 * each from the block that is nearest, and its components are rounded to 63 levels of the
 * largest speed. Two fields are alike as the cosine between them is close to 1.
 */
#pragma once

#include "core/model/model.h"

#include <glib.h>

/* Points of the grid in each direction. */
#define QN_SHAPE_POINTS 12

/* Characters of a shape: two for every point. */
#define QN_SHAPE_LENGTH (2 * QN_SHAPE_POINTS * QN_SHAPE_POINTS)

/* Mechanisms whose shapes have this cosine with the first of their group or more fall into one
 * group: the angle of render/figure/compare-sheet.h. */
#define QN_SHAPE_ALIKE 0.95

/* The shape of a mechanism (velocities: block_count x 3): letters, digits, '-' and '_'. NULL where
 * nothing moves. Free with g_free(). */
char *qn_shape_dup (const QnModel *model, const double *velocities);

/* Cosine of two shapes, -1 to 1; 0 where one of them is no shape. */
double qn_shape_cosine (const char *a, const char *b);
