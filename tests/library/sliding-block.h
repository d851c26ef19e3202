/* Block a, of thickness 1, which is pushed off its base at friction 0.4. */
#pragma once

#include <quoin.h>

static inline QuoinBuilder *
library_build_sliding_block (void)
{
  static const double base[] = { 0, -1, 4, -1, 4, 0, 0, 0 };
  static const double block[] = { 1, 0, 2, 0, 2, 0.5, 1, 0.5 };
  QuoinBuilder *builder = quoin_builder_new ("Sliding block");
  quoin_builder_add_joint (builder, "dry", 1e7, 1e7, 0.4, 0, 0, 0);
  quoin_builder_add_block (builder, "base", base, 4, 1, 20000, true);
  quoin_builder_add_block (builder, "a", block, 4, 1, 20000, false);
  return builder;
}
