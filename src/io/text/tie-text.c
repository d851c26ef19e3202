#include "io/text/tie-text.h"

#include "io/text/text-format.h"

#include <glib/gi18n-lib.h>
#include <math.h>

/* Ties named one by one; the rest are counted. */
#define TIES_IN_WORDS 4

const char *
qn_tie_state_text (QnTieState state)
{
  static const char *const words[QN_TIE_STATE_COUNT] = {
    [QN_TIE_SLACK] = N_ ("slack"),
    [QN_TIE_ELASTIC] = N_ ("elastic"),
    [QN_TIE_YIELDS] = N_ ("yields"),
    [QN_TIE_ANCHOR] = N_ ("anchor gives"),
  };
  return _ (words[state]);
}

gssize
qn_tie_worst_step (const QnResult *result, gsize tie)
{
  gssize worst = -1;
  double most = -INFINITY;
  for (gsize s = 0; s < result->step_count; s++) {
    const QnTieResult *ties = qn_result_step_ties (result, s);
    if (ties != NULL && ties[tie].force > most) {
      most = ties[tie].force;
      worst = (gssize) s;
    }
  }
  return worst;
}

double
qn_tie_utilisation (const QnTie *tie, double force)
{
  return force / qn_tie_strength (tie);
}

typedef struct Worst {
  const QnTie *tie;
  QnTieResult at;
} Worst;

static int
compare_worst (gconstpointer a, gconstpointer b)
{
  const Worst *x = a, *y = b;
  double u = qn_tie_utilisation (x->tie, x->at.force),
         v = qn_tie_utilisation (y->tie, y->at.force);
  if (u != v)
    return u > v ? -1 : 1;
  return (x->at.force < y->at.force) - (x->at.force > y->at.force);
}

static void
append_worst (GString *text, const Worst *worst)
{
  g_string_append (text, text->len > 0 ? _ (", ") : "");
  g_string_append_printf (text, _ ("“%s” %.5g kN"), worst->tie->name,
                          1e-3 * worst->at.force);
  double used = qn_tie_utilisation (worst->tie, worst->at.force);
  if (used > 0)
    g_string_append_printf (text, _ (", %.0f %% of its strength"), 100 * used);
  if (worst->at.state >= QN_TIE_YIELDS)
    g_string_append_printf (text, " (%s)", qn_tie_state_text (worst->at.state));
}

/* How much of the soil has its mobilised strength at the last step; NULL where that is not known. */
static char *
dup_soil_text (const QnModel *model, const QnResult *result)
{
  const QnTieResult *ties =
    result->step_count > 0 && result->tie_count == qn_model_tie_count (model)
      ? qn_result_step_ties (result, result->step_count - 1)
      : NULL;
  guint full = 0;
  for (gsize i = 0; ties != NULL && i < model->soil_tie_count; i++)
    full += ties[model->tie_count + i].state == QN_TIE_YIELDS;
  return ties != NULL && model->soil_tie_count > 0
           ? g_strdup_printf (_ ("The soil presses %u of %u faces with all of its "
                                 "mobilised pressure."),
                              full, (guint) model->soil_tie_count)
           : NULL;
}

char *
qn_ties_dup_text (const QnModel *model, const QnResult *result)
{
  g_autoptr (GArray) all = g_array_new (FALSE, FALSE, sizeof (Worst));
  for (gsize i = 0;
       result->tie_count == qn_model_tie_count (model) && i < model->tie_count; i++) {
    gssize step = qn_tie_worst_step (result, i);
    if (step < 0)
      break;
    Worst worst = { &model->ties[i], qn_result_step_ties (result, (gsize) step)[i] };
    g_array_append_val (all, worst);
  }
  g_autofree char *soil = dup_soil_text (model, result);
  if (all->len == 0)
    return g_steal_pointer (&soil);
  g_array_sort (all, compare_worst);
  g_autoptr (GString) text = g_string_new (NULL);
  for (guint i = 0; i < MIN (all->len, TIES_IN_WORDS); i++)
    append_worst (text, &g_array_index (all, Worst, i));
  if (all->len > TIES_IN_WORDS)
    g_string_append (text, "…");
  g_autofree char *largest = g_strdup_printf (
    ngettext ("Largest force of the tie: %s.", "Ties at most: %s.", all->len), text->str);
  return g_strjoin (soil != NULL ? " " : NULL, largest, soil, NULL);
}

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
