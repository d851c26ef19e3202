/* Walls and arches of any size, and walls drawn from seeds. The same seed gives the same wall on every
 * machine; tests and published figures name seeds, so that draws must not change their order.
 *
 * Each function fills a model as those of models.h do: law "joint", the weights as dead load, the same
 * weights along x as live load. Unit weight is 20 kN/m3. Memory that runs out aborts.
 */
#pragma once

#include "core/model/model.h"

#include <glib.h>

/* A common block, m. */
#define TEST_UNIT qn_vec2 (0.4, 0.175)

/* Running bond of so many blocks of size `unit`, on a fixed base, every other course shifted by half a
 * block. Openings are rectangles in steps of half a block and one course, at places drawn from `seed`,
 * each under a lintel that bears half a block on either side; as many of them as find room. */
void test_bond_init (QnModel *model, QnVec2 unit, int length, int courses, int openings,
                     guint64 seed);

/* Half a ring of middle radius 1 m with radial joints, `ring` deep, that stands on a fixed base. The
 * curved sides of each voussoir are so many straight pieces, 1: chords. */
void test_arch_init (QnModel *model, double ring, int voussoirs, int segments);

/* Adds courses to a wall: blocks of least to 1.5 units, the last one up to `last`, as long as what is
 * left. */
void test_wall_add_courses (QnWall *wall, GRand *rand, int courses, double length,
                            double least, double last);

/* One of six families, which take turns:
 *   solid      running bond, lap of a half, a third or a quarter, no openings
 *   lintels    a façade in running bond, openings under lintels
 *   arches     a façade in running bond, openings under segmental and semicircular arches of
 *              voussoirs and under flat arches
 *   bonded     English, Flemish, header or stack bond with openings under lintels
 *   ashlar     courses of different heights, blocks of different lengths, openings under lintels
 *   rubble     irregular stones, battered, rougher by 0.2 than the others
 * Size, proportions, units, friction (0.55 to 0.75), bays, storeys and every opening's place and size are
 * drawn. Flow is without dilatancy. The wall has between `least` and `most` blocks, a few percent more or
 * fewer; consecutive seeds are spread evenly over the logarithm of that range. The model is prepared. */
void test_wall_draw_sized (QnModel *model, guint32 seed, int least, int most);

/* The family that a seed belongs to. */
const char *test_wall_family (guint32 seed);

/* Reads "FIRST-LAST", or one seed alone; false where they do not count upwards from 1. */
bool test_wall_parse_seeds (const char *text, int *first, int *last);

/* Most blocks of the walls below, and the fewest, the fixed ones counted. */
#define TEST_WALL_MOST   90
#define TEST_WALL_FEWEST 8

/* Extremes: bonds, openings, random courses, rubble, arches, portals, buttresses; leaning or turned, soft
 * or stiff, loaded from either side. `description` says what it is: its kind first, up to a comma. The
 * model is prepared; laws and loads may be changed before it is prepared again. */
void test_wall_draw_any (QnModel *model, guint32 seed, char *description, gsize size);
