/* libFuzzer's own mutations and, every other time, another number. */
#include "numbers.h"

size_t LLVMFuzzerMutate (uint8_t *data, size_t size, size_t most);
size_t LLVMFuzzerCustomMutator (uint8_t *data, size_t size, size_t most, unsigned seed);

size_t
LLVMFuzzerCustomMutator (uint8_t *data, size_t size, size_t most, unsigned seed)
{
  size_t changed = seed % 2 == 0 ? fuzz_mutate_number (data, size, most, seed / 2) : 0;
  return changed > 0 ? changed : LLVMFuzzerMutate (data, size, most);
}
