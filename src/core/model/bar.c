#include "core/model/bar.h"

#include <math.h>

#define PI 3.14159265358979323846

double
qn_bar_get_area (double diameter)
{
  return 0.25 * PI * diameter * diameter;
}

double
qn_bar_get_diameter (double area)
{
  return sqrt (4.0 * area / PI);
}
