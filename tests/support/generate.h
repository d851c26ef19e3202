/* Ready-made structures: a bonded wall with openings, a semicircular arch.
 *
 * Each function fills an empty, initialised model with blocks on fixed supports, one frictional
 * contact law named "joint", the weights as dead load and the same weights along x as live load.
 * The model is not prepared yet. The same recipe gives the same model on every machine. Memory that
 * runs out aborts.
 */
#pragma once

#include "core/model/model.h"

/* Material that all recipes share. */
typedef struct QnGenerateMaterial {
  double thickness;   /* m, out of the plane, > 0 */
  double unit_weight; /* N/m3, >= 0 */
  double stiffness;   /* kn = ks of one spring, N/m, > 0 */
  double friction;    /* >= 0; dilatancy is 0 */
} QnGenerateMaterial;

/* A wall in running bond, every other course shifted by half a block. Openings are rectangles in
 * steps of half a block and one course, at places drawn from `seed`, each under a lintel that
 * bears half a block on either side; as many of them as find room. */
typedef struct QnWallRecipe {
  QnGenerateMaterial material;
  QnVec2 unit;      /* length and height of a full block, m */
  int32_t length;   /* of the wall in full blocks, >= 1 */
  int32_t courses;  /* >= 1 */
  int32_t openings; /* wanted, >= 0 */
  uint64_t seed;
} QnWallRecipe;

/* An arch of equal voussoirs about the origin with radial joints, between two fixed springers. */
typedef struct QnArchRecipe {
  QnGenerateMaterial material;
  double radius;    /* to the middle of the ring, m */
  double ring;      /* depth of the ring, m, < 2 radius */
  double embrace;   /* angle between the springings, rad, in (0, pi] */
  int32_t count;    /* voussoirs, >= 1 */
  int32_t segments; /* straight pieces along the curved sides of each, >= 1; 1 = chords */
} QnArchRecipe;

/* Recipes to start from: unit weight 20 kN/m3, friction 0.65, blocks 0.4 x 0.175 m. */
QnWallRecipe qn_wall_recipe_default (void);
QnArchRecipe qn_arch_recipe_default (void);

void qn_generate_wall (QnModel *model, const QnWallRecipe *recipe);
void qn_generate_arch (QnModel *model, const QnArchRecipe *recipe);
