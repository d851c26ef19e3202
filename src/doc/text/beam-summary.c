#include "doc/text/beam-summary.h"

#include <glib/gi18n-lib.h>
#include <math.h>

/* Values below this part of the largest of their kind are rounding. */
#define ROUNDING 1e-9

static void
offer (QnBeamExtreme *best, double value, double x)
{
  if (fabs (value) > fabs (best->value))
    *best = (QnBeamExtreme){ value, x };
}

static void
offer_point (QnBeamSummary *summary, QnBeamPoint at, double x)
{
  offer (&summary->normal, at.normal, x);
  offer (&summary->shear, at.shear, x);
  offer (&summary->moment, at.moment, x);
}

/* Moments are largest at an end of an element, or inside where the shear force changes its
 * sign. */
static void
add_element (QnBeamSummary *summary, const QnBeamForces *forces, double length, double x)
{
  offer_point (summary, qn_beam_forces_at (forces, length, 0), x);
  offer_point (summary, qn_beam_forces_at (forces, length, 1), x + length);
  if (forces->shear[0] * forces->shear[1] < 0) {
    double s = forces->shear[0] / (forces->shear[0] - forces->shear[1]);
    offer_point (summary, qn_beam_forces_at (forces, length, s), x + s * length);
  }
}

static double
rounded (double value, QnBeamExtreme most)
{
  return fabs (value) > ROUNDING * fabs (most.value) ? value : 0;
}

bool
qn_beam_summary_fill (QnBeamSummary *summary, const QnModel *model,
                      const QnResult *result, size_t step, QnId beam)
{
  const QnBeamForces *forces =
    step < result->step_count ? qn_result_step_beam_forces (result, step) : NULL;
  const QnBeam *b = &model->beams[beam];
  *summary = (QnBeamSummary){ .length = qn_model_beam_length (model, beam) };
  if (forces == NULL || result->element_count != model->element_count)
    return false;
  double length = summary->length / b->element_count;
  for (int32_t i = 0; i < b->element_count; i++)
    add_element (summary, &forces[b->first_element + i], length, i * length);
  summary->ends[0] = qn_beam_forces_at (&forces[b->first_element], length, 0);
  summary->ends[1] =
    qn_beam_forces_at (&forces[b->first_element + b->element_count - 1], length, 1);
  for (int end = 0; end < 2; end++) {
    QnBeamPoint *at = &summary->ends[end];
    at->normal = rounded (at->normal, summary->normal);
    at->shear = rounded (at->shear, summary->shear);
    at->moment = rounded (at->moment, summary->moment);
  }
  return true;
}

static void
append_line (GString *text, QnUnits units, const char *name, QnQuantity quantity,
             double first, double second, QnBeamExtreme most)
{
  g_autofree char *a = qn_units_format (units, quantity, first, 4);
  g_autofree char *b = qn_units_format_full (units, quantity, second, 4);
  g_autofree char *m = qn_units_format_full (units, quantity, most.value, 4);
  g_autofree char *x = qn_units_format_full (units, QN_QUANTITY_LENGTH, most.x, 4);
  if (text->len > 0)
    g_string_append_c (text, '\n');
  g_string_append_printf (text, _ ("%s: %s to %s, largest %s at %s"), name, a, b, m, x);
}

char *
qn_beam_summary_dup_text (const QnBeamSummary *s, QnUnits units)
{
  GString *text = g_string_new (NULL);
  append_line (text, units, "N", QN_QUANTITY_FORCE, s->ends[0].normal, s->ends[1].normal,
               s->normal);
  append_line (text, units, "V", QN_QUANTITY_FORCE, s->ends[0].shear, s->ends[1].shear,
               s->shear);
  append_line (text, units, "M", QN_QUANTITY_MOMENT, s->ends[0].moment, s->ends[1].moment,
               s->moment);
  return g_string_free (text, FALSE);
}
