/* A mutation that knows pieces of text: a pair of brackets with what stands between them, a line,
 * two lines as in DXF, a word. Bytes changed at random seldom leave text well-formed beyond the
 * first rule that a reader checks. */
#pragma once

#include <stddef.h>
#include <stdint.h>

/* Puts a piece of `other` (which may be the text itself) in the place of a piece of the same kind or
 * before it, or removes it, all chosen by `seed`. Returns the new size, at most `most`, or 0 where
 * there is no such piece or no room. */
size_t fuzz_splice_piece (uint8_t *data, size_t size, size_t most, const uint8_t *other,
                          size_t other_size, unsigned seed);
