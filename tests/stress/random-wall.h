/* Walls drawn from a seed: bonds, openings, arches, rubble, leaning or turned, under loads from
 * either side. The same seed gives the same wall on every machine. */
#pragma once

#include "core/model/model.h"

#include <glib.h>

/* Most blocks that a wall has, and the fewest, its fixed ones counted. */
#define STRESS_MOST_BLOCKS   90
#define STRESS_FEWEST_BLOCKS 8

/* Fills `model`, which is not prepared yet, and says what it is in `description`: its kind first,
 * up to a comma. */
void stress_random_wall (guint32 seed, QnModel *model, char *description, gsize size);
