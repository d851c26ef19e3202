/* Random numbers that depend on a seed and a place alone, whatever the size of the object.
 *
 * splitmix64 (Steele, Lea & Flood, "Fast splittable pseudorandom number generators", 2014). */
#pragma once

#include <stdint.h>

/* A number in [-1, 1). */
static inline double
qn_noise (uint32_t seed, uint32_t a, uint32_t b, uint32_t direction)
{
  uint64_t z =
    ((uint64_t) seed << 32) ^ ((uint64_t) a << 17) ^ ((uint64_t) b << 1) ^ direction;
  for (int i = 0; i < 2; i++) {
    z += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    z ^= z >> 31;
  }
  return (double) (z >> 11) * 0x1p-52 - 1;
}
