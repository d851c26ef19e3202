/* Any bytes as a record of ground motion, with and without the unit and the time step that a file
 * may not say. What is accepted has increasing, finite times and accelerations. */
#include "fuzz.h"
#include "io/exchange/record.h"

#include <math.h>

static void
check_record (const char *text, size_t size, const char *unit, double time_step)
{
  QnRecord record;
  GError *error = NULL;
  if (!qn_record_parse (text, size, "fuzz", unit, time_step, FALSE, &record, &error)) {
    fuzz_check_error (error);
    return;
  }
  for (gsize i = 0; i < record.count; i++) {
    g_assert_true (isfinite (record.points[i].x) && isfinite (record.points[i].y));
    g_assert_true (i == 0 || record.points[i].x > record.points[i - 1].x);
  }
  qn_record_facts (&record);
  qn_record_clear (&record);
}

int
LLVMFuzzerTestOneInput (const uint8_t *data, size_t size)
{
  g_autofree char *text = g_malloc (size + 1); /* as qn_file_read() gives it */
  memcpy (text, data, size);
  text[size] = '\0';
  check_record (text, size, NULL, 0);
  check_record (text, size, "g", 0.01);
  return 0;
}
