/* Walls as varied as masonry is, from nothing but a number: the same seed and range of sizes give
 * the same wall on every machine.
 *
 * Six families take turns:
 *   solid      running bond, lap of a half, a third or a quarter, no openings
 *   lintels    a façade in running bond, openings under lintels
 *   arches     a façade in running bond, openings under segmental and semicircular arches of
 *              voussoirs and under flat arches
 *   bonded     English, Flemish, header or stack bond with openings under lintels
 *   ashlar     courses of different heights, blocks of different lengths, openings under lintels
 *   rubble     irregular stones, battered, rougher by 0.2 than the others
 * Size, proportions, units, friction (0.55 to 0.75), bays, storeys and every opening's place and
 * size are drawn. Weight is the dead load, weight along x the live load, flow is without
 * dilatancy, and the lowest course stands on a fixed base.
 */
#pragma once

#include "io/project/project.h"

/* Name of the family that a seed belongs to. */
const char *seeded_wall_family (guint32 seed);

/* The wall as a project, its masonry still parametric, its model prepared. It has between `least`
 * and `most` blocks, a few percent more or fewer; consecutive seeds are spread evenly over the
 * logarithm of that range. `project` is overwritten; clear it with qn_project_clear(). */
void seeded_wall_init (QnProject *project, guint32 seed, int least, int most);

/* Reads "FIRST-LAST", or one seed alone; FALSE where they do not count upwards from 1. */
gboolean seeded_wall_parse_range (const char *text, int *first, int *last);
