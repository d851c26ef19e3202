#include "cli/verify/verify-cases.h"

#include <glib/gi18n.h>
#include <math.h>

#define COLLAPSE(label, file, value, allowed, published)                                 \
  {                                                                                      \
    .name = label, .model = file, .reference = value, .tolerance = allowed,              \
    .paper = published                                                                   \
  }
#define MEASURE(label, file, value, allowed, ...)                                        \
  {                                                                                      \
    .name = label, .model = file, .reference = value, .tolerance = allowed,              \
    .quantity = __VA_ARGS__                                                              \
  }

/* The reference of the non-associative walls is the rigid-block limit analysis that the paper
 * compares itself with; wall 6 has several equilibria close to its collapse. */
static const QnVerifyCase walls[] = {
  COLLAPSE (N_ ("Wall 1"), "ferris-tin-loi/wall1.quoin", 0.643, 0.01, 0.641),
  COLLAPSE (N_ ("Wall 2"), "ferris-tin-loi/wall2.quoin", 0.564, 0.01, 0.556),
  COLLAPSE (N_ ("Wall 3"), "ferris-tin-loi/wall3.quoin", 0.356, 0.01, 0.298),
  COLLAPSE (N_ ("Wall 4"), "ferris-tin-loi/wall4.quoin", 0.264, 0.01, 0.263),
  COLLAPSE (N_ ("Wall 5"), "ferris-tin-loi/wall5.quoin", 0.216, 0.01, 0.215),
  COLLAPSE (N_ ("Wall 6"), "ferris-tin-loi/wall6.quoin", 0.297, 0.015, 0.174),
};

/* With dilatancy = friction the collapse multiplier is unique: the optimum of a linear
 * program, a theory of its own. */
static const QnVerifyCase associative_walls[] = {
  COLLAPSE (N_ ("Wall 1"), "ferris-tin-loi/wall1.quoin", 0.64285900, 1e-3, 0),
  COLLAPSE (N_ ("Wall 2"), "ferris-tin-loi/wall2.quoin", 0.57999861, 1e-3, 0),
  COLLAPSE (N_ ("Wall 3"), "ferris-tin-loi/wall3.quoin", 0.40369410, 1e-3, 0),
  COLLAPSE (N_ ("Wall 4"), "ferris-tin-loi/wall4.quoin", 0.33194840, 1e-3, 0),
  COLLAPSE (N_ ("Wall 5"), "ferris-tin-loi/wall5.quoin", 0.23964253, 1e-3, 0),
  COLLAPSE (N_ ("Wall 6"), "ferris-tin-loi/wall6.quoin", 0.34782456, 1e-3, 0),
};

/* Sliding at mu; overturning at b/h, (b - 2r)/h; on a slope at tan (phi - theta) with
 * tan phi = mu = 0.65, tan theta = 7/24; the stack overturns at its base; a tower
 * whose toe is crushed at (b - W/fc t)/h, in pairs 20 mm apart; walls that a thrust turns
 * about their outer edge at (W b/2 + N z)/(H y), N what the anchor of the tie holds. */
static const QnVerifyCase closed_forms[] = {
  COLLAPSE (N_ ("Block slides"), "01-sliding-block.quoin", 0.4, 1e-6, 0),
  COLLAPSE (N_ ("Block overturns"), "02-overturning-block.quoin", 0.5, 1e-6, 0),
  COLLAPSE (N_ ("Rounded block overturns"), "03-rounded-block.quoin", 0.4, 1e-6, 0),
  COLLAPSE (N_ ("Block on a slope"), "04-block-on-slope.quoin",
            (0.65 - 7. / 24.) / (1 + 0.65 * 7. / 24.), 1e-6, 0),
  COLLAPSE (N_ ("Stack overturns"), "05-stack.quoin", 0.4, 1e-6, 0),
  COLLAPSE (N_ ("Tower, toe crushed"), "26-crushing-tower.quoin", 0.08, 1e-4, 0),
  COLLAPSE (N_ ("Walls with a tie"), "38-tied-walls.quoin", (10 + 4.5 * 3.25) / 2.75,
            1e-5, 0),
};

/* Cantilever L = 3 m, 0.2 x 0.5 m, E = 30 GPa, nu = 0: PL^3/3EI + PL/kGA; fy bh^2/4L in kN; and
 * with 4 cm2 of steel above and below, what plane sections give at a curvature of 0.2 / m. */
static const QnVerifyCase members[] = {
  MEASURE (N_ ("Cantilever, end (m)"), "07-cantilever.quoin", -0.01464, 0.005,
           QN_VERIFY_DISPLACEMENT, .block = "b19", .dof = QN_DOF_UY),
  COLLAPSE (N_ ("Plastic cantilever"), "08-plastic-cantilever.quoin", 83.333333, 0.01, 0),
  COLLAPSE (N_ ("Reinforced cantilever"), "09-reinforced-cantilever.quoin", 29.1125, 0.01,
            0),
};

/* A bar of 2 m, 0.01 m2, E = 200 GPa, yield 200 MPa, hardening 0.1, between the centroids of its
 * first and last block; plastic strain (F - Fy) (1/0.1 - 1)/EA. */
static const QnVerifyCase stages[] = {
  COLLAPSE (N_ ("Load on top, then push"), "16-load-stages.quoin", 29 * 0.3 / 1.375, 1e-5,
            0),
  MEASURE (N_ ("Bar released (m)"), "17-unloading.quoin", 0.0036, 1e-6,
           QN_VERIFY_DISPLACEMENT, .block = "b10", .dof = QN_DOF_UX, .number = 2),
  MEASURE (N_ ("Bar pulled again (m)"), "17-unloading.quoin", 0.008, 1e-6,
           QN_VERIFY_DISPLACEMENT, .block = "b10", .dof = QN_DOF_UX, .number = 3),
  MEASURE (N_ ("Bar yields back (m)"), "17-unloading.quoin", 0.002, 1e-6,
           QN_VERIFY_DISPLACEMENT, .block = "b10", .dof = QN_DOF_UX, .number = 4),
  MEASURE (N_ ("Thrust, arch spread (N)"), "18-spreading-arch.quoin", -47880.15621, 1e-6,
           QN_VERIFY_REACTION, .block = "right abutment", .dof = QN_DOF_UX),
};

/* Panel J4D of Raijmakers & Vermeltfoort, 0.3 MPa, at 1 mm, where its load is highest: a plot, read to
 * 8 kN. Bricks neither crack nor crush here, so beyond it the load does not fall. */
static const QnVerifyCase panel[] = {
  MEASURE (N_ ("Shear force at 1 mm (N)"), "48-shear-panel.quoin", 57e3, 8. / 57,
           QN_VERIFY_REACTION, .block = "beam", .dof = QN_DOF_UX),
};

/* pi^2 EI/(2L)^2, pi^2 EI/L^2, 4 pi^2 EI/L^2 in kN; L = 4 m, 0.2 x 0.2 m, E = 30 GPa. */
static const QnVerifyCase columns[] = {
  MEASURE (N_ ("Clamped and free"), "20-column-free.quoin", 616.850275, 0.01,
           QN_VERIFY_CRITICAL),
  MEASURE (N_ ("Pinned"), "21-column-pinned.quoin", 2467.401100, 0.01,
           QN_VERIFY_CRITICAL),
  MEASURE (N_ ("Clamped"), "22-column-clamped.quoin", 9869.604401, 0.01,
           QN_VERIFY_CRITICAL),
};

/* Tip of a cantilever of length 1 under P L^2/EI = 1, 2, 5, 10 in four stages: down, in, turned. */
#define ELASTICA_TIP(file, body, label, component, value, stage)                         \
  MEASURE (label, file, value, 0.005, QN_VERIFY_DISPLACEMENT, .block = body,             \
           .dof = component, .number = stage)
#define ELASTICA(file, body)                                                             \
  {                                                                                      \
    ELASTICA_TIP (file, body, N_ ("a = 1, down"), QN_DOF_UY, -0.30172, 1),               \
      ELASTICA_TIP (file, body, N_ ("a = 1, in"), QN_DOF_UX, -0.05643, 1),               \
      ELASTICA_TIP (file, body, N_ ("a = 1, turned"), QN_DOF_RZ, -0.46135, 1),           \
      ELASTICA_TIP (file, body, N_ ("a = 2, down"), QN_DOF_UY, -0.49346, 2),             \
      ELASTICA_TIP (file, body, N_ ("a = 2, in"), QN_DOF_UX, -0.16064, 2),               \
      ELASTICA_TIP (file, body, N_ ("a = 2, turned"), QN_DOF_RZ, -0.78175, 2),           \
      ELASTICA_TIP (file, body, N_ ("a = 5, down"), QN_DOF_UY, -0.71379, 3),             \
      ELASTICA_TIP (file, body, N_ ("a = 5, in"), QN_DOF_UX, -0.38763, 3),               \
      ELASTICA_TIP (file, body, N_ ("a = 5, turned"), QN_DOF_RZ, -1.21537, 3),           \
      ELASTICA_TIP (file, body, N_ ("a = 10, down"), QN_DOF_UY, -0.81061, 4),            \
      ELASTICA_TIP (file, body, N_ ("a = 10, in"), QN_DOF_UX, -0.55500, 4),              \
      ELASTICA_TIP (file, body, N_ ("a = 10, turned"), QN_DOF_RZ, -1.43029, 4)           \
  }

static const QnVerifyCase elastica[] = ELASTICA ("23-elastica.quoin", "b50");
static const QnVerifyCase beam_elastica[] = ELASTICA ("31-beam-elastica.quoin", "tip");

/* tan (alpha - theta) at quarters of alpha, tan alpha = 1/2; errors relative to 1/2. */
#define ROCKING(label, value, stage)                                                     \
  MEASURE (label, "24-rocking-block.quoin", value, 0.005, QN_VERIFY_MULTIPLIER,          \
           .number = stage, .scale = 0.5)

static const QnVerifyCase rocking[] = {
  ROCKING (N_ ("A quarter turned over"), 0.362464609, 1),
  ROCKING (N_ ("Half"), 0.236067977, 2),
  ROCKING (N_ ("Three quarters"), 0.116433821, 3),
  ROCKING (N_ ("Diagonal upright"), 0, 4),
};

/* The resultant passes the edge where the centroid is mu h/2 before it; from then on the multiplier is
 * -x/y of the centroid from the edge, at x = -0.01 m. */
#define EDGE(label, value, stage)                                                        \
  MEASURE (label, "29-block-over-an-edge.quoin", value, 0.002, QN_VERIFY_MULTIPLIER,     \
           .number = stage, .scale = 0.3)

static const QnVerifyCase edge[] = {
  EDGE (N_ ("Slides"), 0.3, 1),
  EDGE (N_ ("Tips over the edge"), 0.0962250448, 2),
};

#define FREQUENCY(label, model, value, tolerance, mode)                                  \
  MEASURE (label, model, value, tolerance, QN_VERIFY_FREQUENCY, .number = mode)
#define HERTZ (2 * G_PI)

/* Timoshenko beam, and a wallet of four bricks whose mortar gaps are not known: its values
 * are reported, from a secondary source. */
static const QnVerifyCase vibrations[] = {
  FREQUENCY (N_ ("Beam, mode 1 (rad/s)"), "11-vibrating-beam.quoin", 315.819, 0.01, 1),
  FREQUENCY (N_ ("Beam, mode 2"), "11-vibrating-beam.quoin", 1151.685, 0.01, 2),
  FREQUENCY (N_ ("Beam, mode 3"), "11-vibrating-beam.quoin", 2304.893, 0.01, 3),
  FREQUENCY (N_ ("Four bricks, mode 1"), "25-four-bricks.quoin", 2496 * HERTZ, INFINITY,
             4),
  FREQUENCY (N_ ("Four bricks, mode 2"), "25-four-bricks.quoin", 3430 * HERTZ, INFINITY,
             5),
  FREQUENCY (N_ ("Four bricks, mode 3"), "25-four-bricks.quoin", 4184 * HERTZ, INFINITY,
             6),
};

/* LMGC90, discrete elements whose contacts are found anew as blocks move; the displacement is that of
 * the top right corner of the wall. At 300 mm, where the damping of both codes has kept blocks in place
 * that Quoin's have left, walls 1 and 2 are shown, not judged. */
#define BRANCH(label, wall, controlled, moved, value, allowed)                           \
  MEASURE (label, "ferris-tin-loi/" wall "-rounded.quoin", value, allowed,               \
           QN_VERIFY_BRANCH, .block = controlled, .at = moved)

static const QnVerifyCase branches[] = {
  BRANCH (N_ ("Wall 1 at 50 mm"), "wall1", "w.6.5", 0.05, 0.544, 0.06),
  BRANCH (N_ ("Wall 1 at 100 mm"), "wall1", "w.6.5", 0.1, 0.48, 0.06),
  BRANCH (N_ ("Wall 1 at 200 mm"), "wall1", "w.6.5", 0.2, 0.345, 0.06),
  BRANCH (N_ ("Wall 1 at 300 mm"), "wall1", "w.6.5", 0.3, 0.231, INFINITY),
  BRANCH (N_ ("Wall 2 at 50 mm"), "wall2", "w.10.5", 0.05, 0.502, 0.06),
  BRANCH (N_ ("Wall 2 at 100 mm"), "wall2", "w.10.5", 0.1, 0.463, 0.06),
  BRANCH (N_ ("Wall 2 at 200 mm"), "wall2", "w.10.5", 0.2, 0.399, 0.06),
  BRANCH (N_ ("Wall 2 at 300 mm"), "wall2", "w.10.5", 0.3, 0.308, INFINITY),
  BRANCH (N_ ("Wall 3 at 50 mm"), "wall3", "w.11.4", 0.05, 0.315, 0.06),
  BRANCH (N_ ("Wall 3 at 100 mm"), "wall3", "w.11.4", 0.1, 0.285, 0.06),
  BRANCH (N_ ("Wall 3 at 200 mm"), "wall3", "w.11.4", 0.2, 0.229, 0.06),
  BRANCH (N_ ("Wall 3 at 300 mm"), "wall3", "w.11.4", 0.3, 0.173, 0.06),
};

/* Cantilever: PL^3/3EI + PL/kGA, PL^2/2EI. Column: pi^2 EI/(2L)^2 in kN. Mast: 20 kN x 0.5 m
 * over 3 m. Timoshenko beam, simply supported, its ends axially fixed: its third mode after the first one
 * of stretching, pi sqrt (E / rho) / L. */
static const QnVerifyCase beams[] = {
  MEASURE (N_ ("Cantilever, end (m)"), "30-beam-cantilever.quoin", -0.01464, 1e-9,
           QN_VERIFY_DISPLACEMENT, .block = "tip", .dof = QN_DOF_UY),
  MEASURE (N_ ("Cantilever, turned"), "30-beam-cantilever.quoin", -0.0072, 1e-9,
           QN_VERIFY_DISPLACEMENT, .block = "tip", .dof = QN_DOF_RZ),
  MEASURE (N_ ("Column, Euler (kN)"), "35-beam-column.quoin", 616.850275, 1e-3,
           QN_VERIFY_CRITICAL),
  COLLAPSE (N_ ("Mast overturns its block"), "36-mast-on-block.quoin", 10. / 3, 1e-5, 0),
  FREQUENCY (N_ ("Rod, mode 1 (rad/s)"), "37-beam-vibrating.quoin", 315.819, 1e-3, 1),
  FREQUENCY (N_ ("Rod, mode 2"), "37-beam-vibrating.quoin", 1151.685, 1e-3, 2),
  FREQUENCY (N_ ("Rod, mode 3"), "37-beam-vibrating.quoin", 2304.893, 1e-3, 4),
};

/* Sway of the frame 3 x 3 m under H = 4 kN: H h^3/6EIc + H h^2 L/12EIb in bending (4.5 mm), in
 * shear H h/2kGAc + H h^2/L kGAb, by the columns' shortening 2 H h^3/L^2 EAc, and half of the
 * beam's, H L/4EAb. Collapse: H h = 2 Mp of the beam. */
#define SWAY(label, file)                                                                \
  MEASURE (label, file, 0.00455190, 0.01, QN_VERIFY_DISPLACEMENT,                        \
           .block = "left corner", .dof = QN_DOF_UX)

static const QnVerifyCase frame_sway[] = {
  SWAY (N_ ("Beams only"), "32-frame-beams.quoin"),
  SWAY (N_ ("Blocks only"), "33-frame-blocks.quoin"),
  SWAY (N_ ("Blocks where it yields"), "34-frame-hybrid.quoin"),
};

static const QnVerifyCase frame_collapse[] = {
  COLLAPSE (N_ ("Beams only"), "32-frame-beams.quoin", 80. / 3, 1e-5, 0),
  COLLAPSE (N_ ("Blocks only"), "33-frame-blocks.quoin", 80. / 3, 0.02, 0),
  COLLAPSE (N_ ("Blocks where it yields"), "34-frame-hybrid.quoin", 80. / 3, 0.02, 0),
};

#define GROUP(name, title, source, cases, bounded, ...)                                  \
  {                                                                                      \
    name, title, source, { __VA_ARGS__ }, cases, G_N_ELEMENTS (cases), bounded           \
  }

static const QnVerifyGroup groups[] = {
  GROUP ("walls", N_ ("Six masonry walls, dilatancy 0"),
         N_ ("limit analysis: Ferris & Tin-Loi 2001, Gilbert, Casapulla & Ahmed 2006"),
         walls, TRUE, NULL),
  GROUP ("associative", N_ ("Six masonry walls, dilatancy = friction"),
         N_ ("optimum of the linear program of limit analysis"), associative_walls, TRUE,
         "laws[0].dilatancy=0.65", NULL),
  GROUP ("closed-forms", N_ ("Closed forms"), N_ ("statics of rigid blocks"),
         closed_forms, FALSE, NULL),
  GROUP ("members", N_ ("Continuous members, material basis"),
         N_ ("beam theory, plastic hinges, plane sections"), members, FALSE, NULL),
  GROUP ("stages", N_ ("Load stages and settlements"),
         N_ ("statics; plasticity of a bar; least thrust by limit analysis"), stages,
         FALSE, NULL),
  GROUP ("panel", N_ ("Brick panel of 990 x 1000 mm under shear and compression"),
         N_ ("test J4D, Raijmakers & Vermeltfoort 1992, secondary source"), panel, FALSE,
         NULL),
  GROUP ("columns", N_ ("Stability of columns, 31 blocks"), N_ ("Euler loads, kN"),
         columns, FALSE, NULL),
  GROUP ("elastica", N_ ("Large displacements of a cantilever, 51 blocks"),
         N_ ("elastica, elliptic integrals"), elastica, FALSE, NULL),
  GROUP ("rocking", N_ ("Block turned over, nonlinear geometry"),
         N_ ("statics of a rigid block"), rocking, FALSE, NULL),
  GROUP ("edge", N_ ("Block over the edge of a table, contacts that follow"),
         N_ ("statics of a rigid block"), edge, FALSE, NULL),
  GROUP ("vibrations", N_ ("Frequencies"),
         N_ ("Timoshenko beam; discrete elements, secondary source"), vibrations, FALSE,
         NULL),
  GROUP ("branches", N_ ("Walls with corners rounded by 20 mm, far beyond the peak"),
         N_ ("LMGC90, secondary source"), branches, FALSE, NULL),
  GROUP ("beams", N_ ("Beam elements, by themselves and on blocks"),
         N_ ("beam theory, statics"), beams, FALSE, NULL),
  GROUP ("beam-elastica", N_ ("Large displacements of a cantilever, 40 beam elements"),
         N_ ("elastica, elliptic integrals"), beam_elastica, FALSE, NULL),
  GROUP ("frame-sway", N_ ("Frame 3 x 3 m three ways: sway under 4 kN (m)"),
         N_ ("beam theory"), frame_sway, FALSE, "analysis.max_multiplier=4", NULL),
  GROUP ("frame-collapse", N_ ("Frame 3 x 3 m three ways: collapse (kN)"),
         N_ ("plastic hinges, first order"), frame_collapse, FALSE, NULL),
};

const QnVerifyGroup *
qn_verify_groups (gsize *count)
{
  *count = G_N_ELEMENTS (groups);
  return groups;
}
