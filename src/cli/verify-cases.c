#include "cli/verify-cases.h"

#include <glib/gi18n.h>

/* The reference of the non-associative walls is the rigid-block limit analysis that the paper
 * compares itself with; wall 6 has several equilibria close to its collapse. */
static const QnVerifyCase walls[] = {
  { N_ ("Wall 1"), "ferris-tin-loi/wall1.quoin", 0.643, 0.01, 0.641, NULL },
  { N_ ("Wall 2"), "ferris-tin-loi/wall2.quoin", 0.564, 0.01, 0.556, NULL },
  { N_ ("Wall 3"), "ferris-tin-loi/wall3.quoin", 0.356, 0.01, 0.298, NULL },
  { N_ ("Wall 4"), "ferris-tin-loi/wall4.quoin", 0.264, 0.01, 0.263, NULL },
  { N_ ("Wall 5"), "ferris-tin-loi/wall5.quoin", 0.216, 0.01, 0.215, NULL },
  { N_ ("Wall 6"), "ferris-tin-loi/wall6.quoin", 0.297, 0.015, 0.174, NULL },
};

/* With dilatancy = friction the collapse multiplier is unique: the optimum of a linear
 * program, a theory of its own. */
static const QnVerifyCase associative_walls[] = {
  { N_ ("Wall 1"), "ferris-tin-loi/wall1.quoin", 0.64285900, 1e-3, 0, NULL },
  { N_ ("Wall 2"), "ferris-tin-loi/wall2.quoin", 0.57999861, 1e-3, 0, NULL },
  { N_ ("Wall 3"), "ferris-tin-loi/wall3.quoin", 0.40369410, 1e-3, 0, NULL },
  { N_ ("Wall 4"), "ferris-tin-loi/wall4.quoin", 0.33194840, 1e-3, 0, NULL },
  { N_ ("Wall 5"), "ferris-tin-loi/wall5.quoin", 0.23964253, 1e-3, 0, NULL },
  { N_ ("Wall 6"), "ferris-tin-loi/wall6.quoin", 0.34782456, 1e-3, 0, NULL },
};

/* Sliding at mu; overturning at b/h, (b - 2r)/h; on a slope at tan (phi - theta) with
 * tan phi = mu = 0.65, tan theta = 7/24; the stack overturns at its base. */
static const QnVerifyCase closed_forms[] = {
  { N_ ("Block slides"), "01-sliding-block.quoin", 0.4, 1e-6, 0, NULL },
  { N_ ("Block overturns"), "02-overturning-block.quoin", 0.5, 1e-6, 0, NULL },
  { N_ ("Rounded block overturns"), "03-rounded-block.quoin", 0.4, 1e-6, 0, NULL },
  { N_ ("Block on a slope"), "04-block-on-slope.quoin",
    (0.65 - 7. / 24.) / (1 + 0.65 * 7. / 24.), 1e-6, 0, NULL },
  { N_ ("Stack overturns"), "05-stack.quoin", 0.4, 1e-6, 0, NULL },
};

/* Cantilever L = 3 m, 0.2 x 0.5 m, E = 30 GPa, nu = 0: PL^3/3EI + PL/kGA; fy bh^2/4L in kN; and
 * with 4 cm2 of steel above and below, what plane sections give at a curvature of 0.2 / m. */
static const QnVerifyCase members[] = {
  { N_ ("Cantilever, end (m)"), "07-cantilever.quoin", -0.01464, 0.005, 0, "b19" },
  { N_ ("Plastic cantilever"), "08-plastic-cantilever.quoin", 83.333333, 0.01, 0, NULL },
  { N_ ("Reinforced cantilever"), "09-reinforced-cantilever.quoin", 29.1125, 0.01, 0,
    NULL },
};

static const QnVerifyGroup groups[] = {
  { "walls",
    N_ ("Six masonry walls, dilatancy 0"),
    N_ ("limit analysis: Ferris & Tin-Loi 2001, Gilbert, Casapulla & Ahmed 2006"),
    { NULL },
    walls,
    G_N_ELEMENTS (walls),
    TRUE },
  { "associative",
    N_ ("Six masonry walls, dilatancy = friction"),
    N_ ("optimum of the linear program of limit analysis"),
    { "laws[0].dilatancy=0.65", NULL },
    associative_walls,
    G_N_ELEMENTS (associative_walls),
    TRUE },
  { "closed-forms",
    N_ ("Closed forms"),
    N_ ("statics of rigid blocks"),
    { NULL },
    closed_forms,
    G_N_ELEMENTS (closed_forms),
    FALSE },
  { "members",
    N_ ("Continuous members, material basis"),
    N_ ("beam theory, plastic hinges, plane sections"),
    { NULL },
    members,
    G_N_ELEMENTS (members),
    FALSE },
};

const QnVerifyGroup *
qn_verify_groups (gsize *count)
{
  *count = G_N_ELEMENTS (groups);
  return groups;
}
