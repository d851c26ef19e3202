/* What fuzz targets have in common: the one function, as libFuzzer calls it, and what every refusal
 * must be. */
#pragma once

#include "io/text/io-error.h"

#include <stdint.h>
#include <string.h>

int LLVMFuzzerTestOneInput (const uint8_t *data, size_t size);

/* Aborts unless the error, which is freed, is one line of reading and writing. */
static inline void
fuzz_check_error (GError *error)
{
  g_assert_nonnull (error);
  g_assert_true (error->domain == QN_IO_ERROR);
  g_assert_null (strchr (error->message, '\n'));
  g_error_free (error);
}
