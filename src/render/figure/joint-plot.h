/* The forces in one joint: normal force against shear force with the friction cone, and both along
 * the joint. Small, for a panel; the same marks as in pictures: hollow = open, square = slides. */
#pragma once

#include "core/contact/contacts.h"
#include "core/result/result.h"

#include <cairo.h>

typedef struct QnJointPoint {
  double along;         /* m from the face's start */
  double normal, shear; /* N, normal <= 0 in compression */
  QnPairState state;
  bool has_cone;                  /* strength by friction: */
  double friction, cohesion, cap; /* tangent, N, N; the weaker of the two springs */
  double compression;             /* N, INFINITY where it has no limit */
} QnJointPoint;

typedef struct QnJointPlot {
  QnJointPoint *points;
  size_t count;
  double length;        /* of the face, m */
  double force_factor;  /* N in a displayed unit of force */
  double length_factor; /* m in one of length */
  const char *normal_label, *shear_label, *along_label; /* axis titles */
} QnJointPlot;

/* Forces of the pairs of a face at a step, or at the last equilibrium where `step` is negative or
 * its forces were not kept; `result` is of these contacts. Free the points with free(). False
 * without memory, or where the result has no pairs. */
bool qn_joint_plot_fill (QnJointPlot *plot, const QnModel *model,
                         const QnContacts *contacts, const QnResult *result, int step,
                         QnId face);

/* Draws the two diagrams below each other; `unit`: px per typographic point. */
void qn_joint_plot_draw (const QnJointPlot *plot, cairo_t *cr, double width,
                         double height, double unit);
