/* Vectors of the processor's own size.
 *
 * Inner loops are compiled once for vectors of two and of four numbers (`vectors` in
 * meson.build): the compiler splits vectors that are wider than the processor's, and keeps what it
 * has split in memory. Every width does the same operations on every number, and sums up in the
 * same order: results are equal to the bit.
 */
#pragma once

#include "core/base/base.h"

/* The loops `name` of all widths, narrow ones first: name_2, name_4 (AVX2). */
#ifdef QN_HAVE_X86_VECTORS
#define QN_ALL_WIDTHS(name)                                                              \
  {                                                                                      \
    &name##_2, &name##_4                                                                 \
  }
#else
#define QN_ALL_WIDTHS(name)                                                              \
  {                                                                                      \
    &name##_2                                                                            \
  }
#endif

/* Index into QN_ALL_WIDTHS of the widest loops that this processor supports, with at most `width` numbers
 * in a vector. */
int qn_vectors (int width);
