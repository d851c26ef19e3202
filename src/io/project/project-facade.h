/* The vertical strip of a façade, seen from its side, as a project: what `quoin-cli generate facade-strip`
 * writes. The outer face lies on x = 0, storeys stand above each other from y = 0, x points outwards.
 *
 *   storeys         m, heights from the bottom; [3, 3]
 *   thickness       m, of each storey; 0.5. Of lists the last number holds for those above
 *   floors          N, what the floor on top of each storey brings to the strip; 0
 *   bearing         m, from the inner face: the load stands in its middle; 0.2
 *   floor_friction  beams hold the wall with this part of their load; 0
 *   floor_inertia   part of their load whose mass moves with the wall; 1
 *   held            storeys whose floor holds the wall: a block there that goes up and down alone
 *   ties            N, what ties hold at each floor; 0
 *   flanks          N, what cross walls hold of each storey by friction, in its middle; 0
 *   thrust          N, of the roof, outwards; 0
 *   parapet         m, height and thickness; none
 *   courses         blocks of a storey; 4
 *   width           m, of the strip; 1
 *   unit_weight     N/m3; 18000
 *
 * Friction of floors and flanks and ties are `ties` with such anchors, for limit analysis and mechanisms by code. */
#pragma once

#include "io/project/project.h"

/* The text of a project, NULL with QN_IO_ERROR_OVERRIDE. `overrides`: KEY=JSON, ended by
 * NULL. */
char *qn_facade_dup_project (const char *const *overrides, double friction,
                             GError **error);
