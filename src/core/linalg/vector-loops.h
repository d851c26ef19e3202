/* Macros of files that are compiled once for each width of vectors: see vectors.h. */
#pragma once

#include "core/base/base.h"

/* Doubles per SIMD vector; 2, which every processor has, unless the build says otherwise. */
#ifndef QN_VECTOR_LANES
#define QN_VECTOR_LANES 2
#endif
#define LANES QN_VECTOR_LANES

#if defined __x86_64__ && LANES == 4 && !defined __AVX2__
#error "These vectors would be split: the compiler is not asked for what they need."
#endif

typedef double Vector __attribute__ ((vector_size (8 * LANES), aligned (8), may_alias));
typedef int64_t Mask __attribute__ ((vector_size (8 * LANES), aligned (8), may_alias));

#if defined __clang__ || __GNUC__ >= 12
#define SHUFFLE(a, b, ...) __builtin_shufflevector (a, b, __VA_ARGS__)
#else
#define SHUFFLE(a, b, ...) __builtin_shuffle (a, b, (Mask){ __VA_ARGS__ })
#endif

/* Indices of SHUFFLE: the even or the odd elements of two vectors, or every second pair of elements. */
#if LANES == 2
#define EVEN 0, 2
#define ODD  1, 3
#else
#define EVEN     0, 2, 4, 6
#define ODD      1, 3, 5, 7
#define TWO_EVEN 0, 1, 4, 5
#define TWO_ODD  2, 3, 6, 7
#endif

/* Always inlined: there the counts of vectors and columns are constants. */
#define PART static inline __attribute__ ((always_inline))

/* The name of this width's loops. */
#define WITH_NUMBER(name, lanes) name##_##lanes
#define WITH_LANES(name, lanes)  WITH_NUMBER (name, lanes)
#define WITH_WIDTH(name)         WITH_LANES (name, LANES)
