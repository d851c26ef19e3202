/* The forces in one joint: normal force against shear force with the friction cone, and both along
 * the joint. Small, for a panel; the same marks as in pictures: hollow = open, square = slides. */
#pragma once

#include "render/figure/plot.h"

/* Plots of the forces at the pairs of a face: shear over normal force, and normal force over the place from
 * the face's start, in N and m. `pairs` are all of the contacts. Free each with qn_plot_free(); the first
 * one holds the numbers of both. */
void qn_joint_plots_init (QnPlot *plots[2], const QnModel *model,
                          const QnContacts *contacts, const QnPairResult *pairs,
                          QnId face);

/* Draws the two below each other; `unit`: px per typographic point. */
void qn_joint_plots_draw (QnPlot *const plots[2], cairo_t *cr, double width,
                          double height, double unit);
