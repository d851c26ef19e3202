#include "doc/text/beam-summary.h"

#include <glib/gi18n-lib.h>
#include <math.h>

/* Values below this part of the largest of their kind are rounding. */
#define ROUNDING 1e-9

enum { NORMAL, SHEAR, MOMENT, KINDS };

/* The largest values, and where they are, m from the first node. */
typedef struct Largest {
  double value[KINDS], x[KINDS];
} Largest;

static void
offer (Largest *largest, QnBeamPoint at, double x)
{
  const double values[KINDS] = { at.normal, at.shear, at.moment };
  for (int k = 0; k < KINDS; k++)
    if (fabs (values[k]) > fabs (largest->value[k])) {
      largest->value[k] = values[k];
      largest->x[k] = x;
    }
}

/* Moments are largest at an end of an element, or inside where the shear force changes its
 * sign. */
static void
offer_element (Largest *largest, const QnBeamForces *forces, double length, double x)
{
  offer (largest, qn_beam_forces_at (forces, length, 0), x);
  offer (largest, qn_beam_forces_at (forces, length, 1), x + length);
  if (forces->shear[0] * forces->shear[1] < 0) {
    double s = forces->shear[0] / (forces->shear[0] - forces->shear[1]);
    offer (largest, qn_beam_forces_at (forces, length, s), x + s * length);
  }
}

char *
qn_beam_dup_summary (const QnModel *model, const QnResult *result, size_t step, QnId beam,
                     QnUnits units)
{
  static const char *const names[KINDS] = { "N", "V", "M" };
  static const QnQuantity quantities[KINDS] = { QN_QUANTITY_FORCE, QN_QUANTITY_FORCE,
                                                QN_QUANTITY_MOMENT };
  const QnBeamForces *forces =
    step < result->step_count ? qn_result_step_beam_forces (result, step) : NULL;
  const int32_t first = model->beams[beam].first_element,
                count = model->beams[beam].element_count;
  const double length = qn_model_beam_length (model, beam) / count;
  Largest largest = { 0 };
  if (forces == NULL || result->element_count != model->element_count)
    return NULL;
  for (int32_t i = 0; i < count; i++)
    offer_element (&largest, &forces[first + i], length, i * length);
  const QnBeamPoint from = qn_beam_forces_at (&forces[first], length, 0),
                    to = qn_beam_forces_at (&forces[first + count - 1], length, 1);
  const double ends[KINDS][2] = { { from.normal, to.normal },
                                  { from.shear, to.shear },
                                  { from.moment, to.moment } };
  GString *text = g_string_new (NULL);
  for (int k = 0; k < KINDS; k++) {
    const double least = ROUNDING * fabs (largest.value[k]);
    g_autofree char *a = qn_units_format (units, quantities[k],
                                          fabs (ends[k][0]) > least ? ends[k][0] : 0, 4);
    g_autofree char *b = qn_units_format_full (
      units, quantities[k], fabs (ends[k][1]) > least ? ends[k][1] : 0, 4);
    g_autofree char *m = qn_units_format_full (units, quantities[k], largest.value[k], 4);
    g_autofree char *x =
      qn_units_format_full (units, QN_QUANTITY_LENGTH, largest.x[k], 4);
    g_string_append (text, k > 0 ? "\n" : "");
    g_string_append_printf (text, _ ("%s: %s to %s, largest %s at %s"), names[k], a, b, m,
                            x);
  }
  return g_string_free (text, FALSE);
}
