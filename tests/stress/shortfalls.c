#include "stress/shortfalls.h"

typedef struct Shortfall {
  const char *name; /* of the case */
  guint faults;
} Shortfall;

static const Shortfall shortfalls[] = {
  { NULL, 0 },
};

guint
stress_shortfalls (const char *name)
{
  for (const Shortfall *s = shortfalls; s->name != NULL; s++)
    if (g_str_equal (s->name, name))
      return s->faults;
  return 0;
}
