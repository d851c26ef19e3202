/* What must hold of every stereotomy that this layer makes. */
#pragma once

#include "core/model/model.h"

/* An empty model with the law "joint". */
void test_sound_init (QnModel *model);

/* Prepares the model and asserts: valid blocks whose areas add up to `area` (m2), no two of which
 * overlap, and whose joints are all detected as contact faces. The joints are measured by
 * comparing every edge with every other. Returns their length, m. */
double test_assert_sound (QnModel *model, double area);

/* Sum of the perimeters of all blocks of a prepared model, m. */
double test_sound_perimeters (const QnModel *model);
