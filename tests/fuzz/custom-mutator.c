/* libFuzzer's own mutations and, two times of three, another number or a piece of the text moved. */
#include "numbers.h"
#include "pieces.h"

#include <string.h>

size_t LLVMFuzzerMutate (uint8_t *data, size_t size, size_t most);
size_t LLVMFuzzerCustomMutator (uint8_t *data, size_t size, size_t most, unsigned seed);
size_t LLVMFuzzerCustomCrossOver (const uint8_t *first, size_t first_size,
                                  const uint8_t *second, size_t second_size, uint8_t *out,
                                  size_t most, unsigned seed);

size_t
LLVMFuzzerCustomMutator (uint8_t *data, size_t size, size_t most, unsigned seed)
{
  size_t changed = 0;
  if (seed % 3 == 0)
    changed = fuzz_mutate_number (data, size, most, seed / 3);
  else if (seed % 3 == 1)
    changed = fuzz_splice_piece (data, size, most, data, size, seed / 3);
  return changed > 0 ? changed : LLVMFuzzerMutate (data, size, most);
}

size_t
LLVMFuzzerCustomCrossOver (const uint8_t *first, size_t first_size, const uint8_t *second,
                           size_t second_size, uint8_t *out, size_t most, unsigned seed)
{
  if (first_size > most)
    return 0;
  memcpy (out, first, first_size);
  return fuzz_splice_piece (out, first_size, most, second, second_size, seed);
}
