/* Small models for tests, built in plain C. None is prepared yet unless said so: add loads,
 * change settings, then qn_model_prepare(). Every one has a law "joint" (coulomb, contact basis,
 * kn = ks = 1e7 N/m, friction 0.65, nothing else) as its contact law, two pairs at the ends
 * without offset, unit weight 10 kN/m3 and thickness 1 m, and no loads. Memory failures abort. */
#pragma once

#include "support/auto-clear.h"

#define TEST_WALL_COUNT 6

/* What is published about the six walls of Ferris & Tin-Loi (2001). */
typedef struct TestWall {
  const char *courses; /* "E U E U", from the bottom */
  const char *E, *U, *w,
    *v;                   /* lengths in full blocks, negative = opening; NULL = unused */
  size_t blocks, faces;   /* the fixed base counted */
  double associative;     /* multiplier, friction = dilatancy (linear program) */
  double non_associative; /* multiplier, dilatancy 0 (limit analysis in the seed paper) */
} TestWall;

extern const TestWall test_walls[TEST_WALL_COUNT];

/* An empty model with the law "joint". */
void test_model_init (QnModel *model);

/* A rectangular block with its lower left corner at (x, y). */
QnBlock *test_model_add_rectangle (QnModel *model, const char *name, double x, double y,
                                   double width, double height);

/* The same, fixed in all three degrees of freedom. */
QnBlock *test_model_add_base (QnModel *model, double x, double y, double width,
                              double height);

/* A node at (x, y) that is held where `supports` has an x, y or r; returns its number. */
QnId test_model_add_node (QnModel *model, const char *name, double x, double y,
                          const char *supports);

/* "base" (fixed) under "block", width x height, centred at x = 0, standing on y = 0. */
void test_model_init_block_on_plane (QnModel *model, double width, double height);

/* "base" under "b1" … "bN", each width x height. */
void test_model_init_stack (QnModel *model, int count, double width, double height);

/* One of the six walls, number 1 to 6: "base" (fixed) under the wall "w", dead load -W, live load
 * +W along x. Dilatancy as given: 0 or 0.65. */
void test_model_init_wall (QnModel *model, int number, double dilatancy);

/* Gives every other block joints so many times softer, under a second law. Walls are expanded
 * first. */
void test_model_soften_every_other_block (QnModel *model, double times);

/* Dead load: one weight downwards. Live load: one weight along x times `direction`. */
void test_model_add_weight_loads (QnModel *model, double direction);

/* The structure turned by an angle (rad), moved, or scaled in length, with its loads, supports
 * excepted: use them where all supports are fixed in all degrees of freedom. Walls are expanded
 * first and forgotten. Scaling keeps unit weights; contact offset and control target, being
 * lengths, are scaled too. */
void test_model_rotate (QnModel *model, double angle);
void test_model_translate (QnModel *model, double dx, double dy);
void test_model_scale (QnModel *model, double factor);

/* Mirrored about the y axis, weight loads too. */
void test_model_mirror (QnModel *model);

/* The same structure with its blocks in another, random order, and the first vertices changed. */
void test_model_renumber (QnModel *model, unsigned seed);
