/* A mutation that knows numbers: bytes changed at random hardly ever give 1e155, and every digit of
 * such a number must be right at once. */
#pragma once

#include <stddef.h>
#include <stdint.h>

/* Replaces one of the numbers in a text by another of the same text or by one that arithmetic has
 * trouble with, both chosen by `seed`. Returns the new size, at most `most`, or 0 where the text has
 * no number or the new one has no room. */
size_t fuzz_mutate_number (uint8_t *data, size_t size, size_t most, unsigned seed);
