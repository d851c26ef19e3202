/* Parameters of the path. Numbers without a unit are ratios. Effects of other values: docs/experiments. */
#pragma once

/* Viscous steps of the shortest step, measure held. */
#define QN_RELAX_BUDGET_HELD 10000

/* After an easy step the next one is GROWTH times longer; STEADY times if the direction of motion changed by
 * less than TURN; 1 / CUT times if the structure cannot jump. Long steps may cause slip that is not on the
 * path. */
#define QN_PATH_GROWTH        1.5
#define QN_PATH_GROWTH_STEADY 2
#define QN_PATH_TURN          0.25

/* First load step, x the multiplier at which the largest live load on a block equals the largest dead load,
 * regardless of `increments`; after failures it is cut to RESTART_STEP of itself. */
#define QN_PATH_START 0.02

/* Longest step: LARGEST_STEP first steps in displacement control; LARGEST_MOTION characteristic lengths in
 * large displacements. Corners within two such steps are listed. */
#define QN_PATH_LARGEST_STEP   4
#define QN_PATH_LARGEST_MOTION 0.05

/* A step that fails or jumps is cut by CUT: in linear geometry MOST_CUTS times before relaxation; in large
 * displacements by Newton's method down to CUT^MOST_CUTS, by relaxation to SMALLEST_STEP of the largest step.
 * The next step is at least RESTART_STEP of the largest. */
#define QN_PATH_CUT           0.25
#define QN_PATH_MOST_CUTS     2
#define QN_PATH_SMALLEST_STEP (1.0 / 1024)
#define QN_PATH_RESTART_STEP  (1.0 / 64)

/* A motion of JUMP times the expected one is a jump. */
#define QN_PATH_JUMP 3

#define QN_PATH_LEAN 0.01 /* first motion from an unstable equilibrium / allowed motion */

/* Plateau of non-associative joints: the multiplier changes by at most PLATEAU, as it does where it does not
 * dip, while the motion grows PLATEAU_GROWTH times. */
#define QN_PATH_PLATEAU        1e-4
#define QN_PATH_PLATEAU_GROWTH 10

/* Motion beyond eq->runaway is collapse where so much is left to gain: where it may jump, and in tolerances. */
#define QN_PATH_NEARLY_SETTLED 5e-3
#define QN_PATH_SETTLED        0.1

/* A path whose multiplier gains at most CREEPS of itself for each doubling of the motion creeps. After DIRECT
 * factorisations its collapse is computed directly; the path ends there if that is at most SETTLES above, after
 * PATIENCE factorisations at any distance. The path ends after EFFORT, or where it gains at most SETTLES and no step
 * converges. {a, b, c}: a / blocks, at least b, at most c. */
#define QN_PATH_CREEPS  0.05
#define QN_PATH_SETTLES 0.03
#define QN_PATH_DIRECT  100
#define QN_PATH_PATIENCE                                                                 \
  {                                                                                      \
    1e6, 300, 3000                                                                       \
  }
#define QN_PATH_EFFORT                                                                   \
  {                                                                                      \
    1e7, 1000, 6000                                                                      \
  }

/* STEPS steps in a row lead to a direct collapse if the cosine between them and its motion is at least ALIGNED, and
 * their gain for a doubling of the motion, and that of the last doubling, DOUBLINGS times at least what is left. */
#define QN_PATH_LEADS_STEPS     3
#define QN_PATH_LEADS_ALIGNED   0.9
#define QN_PATH_LEADS_DOUBLINGS 6

/* A step of load control with a gain above IN_DOUBT is doubtful if at the part LATE of its straight way the
 * joints resist less than RESISTS x LATE of the gain (0.9 to 1.2 in most steps, 0.06 to 0.75 in four after
 * which walls fall). The load is then held once the multiplier has gained IN_DOUBT of itself. */
#define QN_PATH_LATE     0.85
#define QN_PATH_RESISTS  0.77
#define QN_PATH_IN_DOUBT 0.03

/* Large displacements: a motion of COLLAPSED characteristic lengths since the highest multiplier is collapse.
 * The load is held 1, 2, … MOST_ABOVE tolerances above that multiplier. */
#define QN_PATH_COLLAPSED  0.1
#define QN_PATH_MOST_ABOVE 4

/* End of a branch: unstable equilibria examined; bisections, of the lowest eigenvalue too, and inverse iterations
 * from it; ratio below which displacements are equal and the load is orthogonal to the motion. */
#define QN_PATH_MOST_LOOKS 5
#define QN_PATH_BISECTIONS 30
#define QN_PATH_NONE       1e-2

#define QN_PATH_RESOLUTION 1e-3 /* of the critical multiplier, in multiplier tolerances */

#define QN_PATH_FARTHEST_FIRST 1e3 /* largest first step, elastic displacements */
#define QN_PATH_MOST_STEPS     100000
