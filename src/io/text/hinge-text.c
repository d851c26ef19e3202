#include "io/text/hinge-text.h"
#include "io/text/text-format.h"

#include <glib/gi18n-lib.h>
#include <math.h>

/* Hinges named one by one; the rest are counted. */
#define HINGES_IN_WORDS 4

/* A moment within this part of the plastic one is that of a plastic hinge. */
#define YIELDS 1e-3

static gboolean
yields_at (const QnModel *model, const QnBeamForces *forces, size_t element, int end)
{
  const QnBeamElement *e = &model->elements[element];
  double plastic =
    qn_section_plastic_moment (&model->sections[model->beams[e->beam].section]);
  return e->yields[end] && !e->hinge[end] && isfinite (plastic)
         && fabs (forces[element].moment[end]) >= (1 - YIELDS) * plastic;
}

char *
qn_hinges_dup_text (const QnModel *model, const QnResult *result)
{
  const QnBeamForces *forces =
    result->step_count > 0 ? qn_result_step_beam_forces (result, result->step_count - 1)
                           : NULL;
  if (forces == NULL || result->element_count != model->element_count)
    return NULL;
  g_autoptr (GString) places = g_string_new (NULL);
  int count = 0;
  for (size_t i = 0; i < model->element_count; i++)
    for (int end = 0; end < 2; end++)
      if (yields_at (model, forces, i, end) && count++ < HINGES_IN_WORDS) {
        const QnBeamElement *e = &model->elements[i];
        g_string_append (places, places->len > 0 ? _ (", ") : "");
        qn_text_append (places, _ ("“%s” at “%s”"), model->beams[e->beam].name,
                        model->nodes[e->nodes[end]].name);
      }
  if (count == 0)
    return NULL;
  if (count > HINGES_IN_WORDS)
    g_string_append (places, "…");
  return qn_text_printf (
    ngettext ("%d plastic hinge: %s.", "%d plastic hinges: %s.", (gulong) count), count,
    places->str);
}
