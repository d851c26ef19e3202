/* What steers the path: name, value, and why. Numbers without a unit are parts. docs/experiments has
 * what other values do. */
#pragma once

/* Most iterations of Newton's method: before relaxation takes over, from where earlier equilibria predict
 * the next, and for the next step to grow. */
#define QN_NEWTON_BUDGET    20
#define QN_PREDICTED_BUDGET 6
#define QN_PATH_EASY        6

#define QN_CENTRAL_BUDGET    40    /* factorisations of one increment */
#define QN_RELAX_BUDGET_HINT 40    /* viscous steps where a hint is enough, and */
#define QN_RELAX_BUDGET_HELD 10000 /* with a measure held, where each ends somewhere */
#define QN_PATH_FALL_TOLD    50    /* under dead load, to tell of what falls */

/* How many times longer the next step is: friction without dilatancy may make the path turn, and a long
 * step finds slip that the path has not. If the direction hardly turned, hardly a joint slips anew. */
#define QN_PATH_GROWTH        1.5
#define QN_PATH_GROWTH_STEADY 2
#define QN_PATH_TURN          0.25
#define QN_PATH_GROWTH_SURE   4 /* nothing jumps */

/* First load step of joints under a dead load, in multipliers at which the largest live load on a block
 * equals the largest dead one, whatever `increments` says; where it fails it is cut to a part of that. */
#define QN_PATH_START       0.02
#define QN_PATH_LEAST_START (1.0 / 256)

/* Longest step of displacement control in first ones, for `increments` is to be seen; in large displacements
 * in characteristic lengths, for contacts stay where they were on their blocks. */
#define QN_PATH_LARGEST_STEP   4
#define QN_PATH_LARGEST_MOTION 0.05
#define QN_PATH_LIST_CONTACTS  0.1 /* so near corners are listed: two such steps */

/* A step that fails or jumps is cut to this part, so often in linear geometry before the structure is let
 * move. In large displacements the largest step cut as often is the least that Newton's method is worth;
 * relaxation goes on to a part of the largest. With RESTART of it the path goes on. */
#define QN_PATH_CUT           0.25
#define QN_PATH_MOST_CUTS     2
#define QN_PATH_SMALLEST_STEP (1.0 / 1024)
#define QN_PATH_RESTART_STEP  (1.0 / 64)

/* Motion so many times as far as before may be a jump; it is one if that part of it stays in a step cut. */
#define QN_PATH_JUMP       3
#define QN_PATH_JUMP_STAYS 0.5

#define QN_PATH_LEAN 0.01 /* out of an unstable equilibrium: of the way that it may go */

/* Without associativity a multiplier that changes by no more while the motion grows so many times is a
 * plateau. Where no step leads on it is one if the multiplier gained no more while the motion doubled. */
#define QN_PATH_PLATEAU        1e-4
#define QN_PATH_PLATEAU_GROWTH 10
#define QN_PATH_LEAST_GAIN     0.02
#define QN_PATH_STEADY         1e-2 /* of the motion: what joints may be pressed by on it */

/* Motion beyond eq->runaway is collapse where so much is left to gain: where it may jump, and in tolerances. */
#define QN_PATH_NEARLY_SETTLED 5e-3
#define QN_PATH_SETTLED        0.1

/* A path that gains no more while the motion doubles creeps: its collapse is sought directly once it has
 * taken as many factorisations as that does, and it ends there if it has come within REACH. From PATIENCE
 * factorisations on (over the blocks; at least, at most) however far that is, after EFFORT anyway. */
#define QN_PATH_CREEP  0.04
#define QN_PATH_DIRECT 60
#define QN_PATH_REACH  0.03
#define QN_PATH_PATIENCE                                                                 \
  {                                                                                      \
    1e6, 300, 3000                                                                       \
  }
#define QN_PATH_EFFORT                                                                   \
  {                                                                                      \
    1e7, 1000, 6000                                                                      \
  }

/* A step of load control is doubtful where joints, so far on the straight way, resist less than a part of the
 * gain there: most have 0.9 to 1.2, four in which walls fall 0.06 to 0.75. The load is held once the multiplier
 * has gained IN_DOUBT of itself. */
#define QN_PATH_LATE     0.85
#define QN_PATH_RESISTS  0.77
#define QN_PATH_IN_DOUBT 0.03

/* In large displacements what has moved so far, in characteristic lengths, since its highest multiplier has
 * collapsed. The load is held a tolerance above that, then twice as far, up to MOST_ABOVE. */
#define QN_PATH_COLLAPSED  0.1
#define QN_PATH_MOST_ABOVE 4

/* Unstable equilibria looked at for where the branch ends, bisections towards it, and what counts as
 * nothing there: of the displacement, and of the load across its motion. */
#define QN_PATH_MOST_LOOKS      5
#define QN_PATH_MOST_BISECTIONS 40
#define QN_PATH_SAME_BRANCH     1e-2

#define QN_PATH_RESOLUTION  1e-3 /* of the critical multiplier, in multiplier tolerances */
#define QN_PATH_EIGENVALUE  30   /* bisections of the lowest, */
#define QN_PATH_EIGENVECTOR 8    /* and inverse iterations from there */

/* Elastic displacements in a first step, for next to collapse the tangent knows no end; states that predict the
 * next one better than Newton's first iteration; what of the highest multiplier has turned down; times what
 * equilibrium may lack that are felt; and force beside the largest that a joint carries at a collapse. */
#define QN_PATH_FARTHEST_FIRST 1e3
#define QN_PATH_LEAST_STATES   2
#define QN_PATH_DIP            1e-4
#define QN_PATH_FELT           100
#define QN_PATH_LITTLE         1e-5

#define QN_PATH_MOST_STEPS 100000 /* of a path that nothing else ends */
