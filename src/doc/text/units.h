/* Conversion between the units of the window and the SI numbers of the model.
 *
 * Every field of the window shows its unit and accepts any other of the same quantity: "40",
 * "0,4 m" and "40 cm" are the same length. Both decimal signs are understood; the one of the
 * locale is written.
 */
#pragma once

#include "core/base/vec2.h"

#include <glib.h>

typedef enum {
  QN_QUANTITY_NUMBER,            /* no unit */
  QN_QUANTITY_LENGTH,            /* m */
  QN_QUANTITY_DIAMETER,          /* m; of reinforcing bars, shown in mm */
  QN_QUANTITY_ANGLE,             /* rad; shown in degrees */
  QN_QUANTITY_ROTATION,          /* rad; of what moves, shown in mrad */
  QN_QUANTITY_FORCE,             /* N */
  QN_QUANTITY_MOMENT,            /* N m */
  QN_QUANTITY_STRESS,            /* Pa */
  QN_QUANTITY_PRESSURE,          /* Pa; of loads on ground and structures, shown in kPa */
  QN_QUANTITY_STIFFNESS,         /* N/m */
  QN_QUANTITY_SURFACE_STIFFNESS, /* Pa/m */
  QN_QUANTITY_UNIT_WEIGHT,       /* N/m3 */
  QN_QUANTITY_DENSITY,           /* kg/m3 */
  QN_QUANTITY_TIME,              /* s */
  QN_QUANTITY_ENERGY,            /* J */
  QN_QUANTITY_SURFACE_ENERGY,    /* J/m2 */
  QN_QUANTITY_COUNT
} QnQuantity;

typedef enum { QN_LENGTH_M, QN_LENGTH_CM, QN_LENGTH_MM, QN_LENGTH_COUNT } QnLengthUnit;
typedef enum { QN_FORCE_N, QN_FORCE_KN, QN_FORCE_COUNT } QnForceUnit;
typedef enum { QN_STRESS_PA, QN_STRESS_KPA, QN_STRESS_MPA, QN_STRESS_COUNT } QnStressUnit;

typedef struct QnUnits {
  QnLengthUnit length;
  QnForceUnit force; /* of moments, stiffnesses and unit weights as well */
  QnStressUnit stress;
} QnUnits;

#define QN_UNITS_SI ((QnUnits){ QN_LENGTH_M, QN_FORCE_N, QN_STRESS_PA })

/* Symbol of the unit in which a quantity is shown, "" for plain numbers; a static string. */
const char *qn_units_symbol (QnUnits units, QnQuantity quantity);

/* The same for displacements, openings and slips, which are small: lengths in mm. */
QnUnits qn_units_of_motion (QnUnits units);

/* SI value of one displayed unit: 0.01 where lengths are shown in cm. */
double qn_units_factor (QnUnits units, QnQuantity quantity);

/* The number alone, with the locale's decimal sign and at most `digits` significant digits
 * (1 to 17), without a power of ten below a million; "∞" for infinity. The caller frees it. */
char *qn_units_format (QnUnits units, QnQuantity quantity, double value, int digits);

/* The number with its unit after a no-break space. The caller frees it. */
char *qn_units_format_full (QnUnits units, QnQuantity quantity, double value, int digits);

/* Two of them, as "0.2; 3 m". The caller frees it. */
char *qn_units_format_pair (QnUnits units, QnQuantity quantity, QnVec2 pair, int digits);

/* Reads a number with or without a unit; without one the displayed unit is meant. Sums, differences,
 * products, quotients and brackets are worked out: "0.4*3+0.01", "2*(40 cm + 1 cm)". "∞" and
 * "inf" give infinity, which callers that cannot use it refuse. `value` is in SI. */
gboolean qn_units_parse (QnUnits units, QnQuantity quantity, const char *text,
                         double *value, GError **error);

/* Numbers with ";" between them, of which there may be none: "4 m; 7.5 m". The caller frees it. */
char *qn_units_format_list (QnUnits units, QnQuantity quantity, const double *values,
                            gsize count, int digits);

/* Reads up to `most` of them, with or without a ";" behind the last; the rest of `values` is as before. */
gboolean qn_units_parse_list (QnUnits units, QnQuantity quantity, const char *text,
                              double *values, gsize most, gsize *count, GError **error);
