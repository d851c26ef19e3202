/* Decimal numbers in names; the core has no printf. */
#pragma once

#include "core/base/base.h"

/* Characters that a number may need, the terminating zero included. */
#define QN_DECIMAL_SIZE 11

/* Writes a number >= 0 and a terminating zero; returns the place of that zero. */
char *qn_write_decimal (char *out, int32_t number);
