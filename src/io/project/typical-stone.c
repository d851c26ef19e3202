#include "io/project/typical-stone.h"

#include <glib/gi18n-lib.h>
#include <math.h>

const QnTypicalStone qn_typical_stones[QN_STONE_COUNT] = {
  { N_ ("Granite"), 28.5e3, N_ ("EN 1991-1-1, table A.2: 27 to 30 kN/m³") },
  { N_ ("Basalt"), 29e3, N_ ("EN 1991-1-1, table A.2: 27 to 31 kN/m³") },
  { N_ ("Sandstone"), 24e3, N_ ("EN 1991-1-1, table A.2: 21 to 27 kN/m³") },
  { N_ ("Dense limestone"), 24.5e3, N_ ("EN 1991-1-1, table A.2: 20 to 29 kN/m³") },
  { N_ ("Tuff, light limestone"), 20e3, N_ ("EN 1991-1-1, table A.2: 20 kN/m³") },
  { N_ ("Masonry of squared stone"), 22e3, N_ ("Circolare 7/2019, table C8.5.I") },
  { N_ ("Rubble masonry"), 19e3, N_ ("Circolare 7/2019, table C8.5.I") },
  { N_ ("Brick masonry"), 18e3, N_ ("Circolare 7/2019, table C8.5.I") },
};

int
qn_typical_stone_find (double unit_weight)
{
  for (int i = 0; i < QN_STONE_COUNT; i++)
    if (fabs (qn_typical_stones[i].unit_weight - unit_weight) <= 1e-9 * unit_weight)
      return i;
  return -1;
}
