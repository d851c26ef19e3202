#include "core/base/decimal.h"

char *
qn_write_decimal (char *out, int32_t number)
{
  QN_ASSERT (number >= 0);
  char digits[QN_DECIMAL_SIZE];
  int32_t count = 0;
  do
    digits[count++] = (char) ('0' + number % 10);
  while ((number /= 10) > 0);

  while (count > 0)
    *out++ = digits[--count];
  *out = '\0';
  return out;
}
