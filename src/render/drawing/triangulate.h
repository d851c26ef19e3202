/* Triangles that cover a simple polygon, for back ends that draw only triangles. */
#pragma once

#include "core/base/vec2.h"

#include <stddef.h>
#include <stdint.h>

/* Writes 3 (count - 2) indices of a polygon of either orientation and returns their number;
 * less where vertices are degenerate. `order` is scratch for `count` indices. Ears are cut
 * one by one, O(count^2): masonry blocks have few vertices. */
size_t qn_triangulate (const QnVec2 *points, uint32_t count, uint32_t *indices,
                       uint32_t *order);
