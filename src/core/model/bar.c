#include "core/model/bar.h"
#include "core/base/base.h"

#include <math.h>

double
qn_bar_get_area (double diameter)
{
  return 0.25 * QN_PI * diameter * diameter;
}

double
qn_bar_get_diameter (double area)
{
  return sqrt (4.0 * area / QN_PI);
}
