/* The answer of the current run: its multiplier, what that means, the mechanism in a sentence; what happened
 * on the path, every value that was found for the model, and how, behind expanders. */
#include "app/forms/panel.h"
#include "app/widgets/builder.h"
#include "app/widgets/settings.h"
#include "doc/document/bounds.h"
#include "doc/document/run.h"
#include "doc/text/explain.h"
#include "doc/view/load-text.h"
#include "doc/view/report-template.h"
#include "io/text/outcome-text.h"
#include <glib/gi18n.h>

typedef struct Card {
  QnDocument *document;
  GtkWidget *box;
} Card;

/* Where there is nothing to say the label goes. */
static void
set_text (Card *card, const char *id, const char *text)
{
  gtk_label_set_text (qn_part (card->box, id), text != NULL ? text : "");
  gtk_widget_set_visible (qn_part (card->box, id), text != NULL && text[0] != '\0');
}

/* What a run answers: the multiplier; where there is none, how it ended, of an analysis in time with the
 * time. */
static char *
dup_number (const QnRun *run)
{
  const QnResult *result = &run->result;
  if (run->kind == QN_RUN_ANALYSIS && result->has_collapse_multiplier)
    return g_strdup_printf ("%.4f", result->collapse_multiplier);
  if (result->has_unproved_multiplier)
    return g_strdup_printf (_ ("%.4f, not proved"), result->unproved_multiplier);
  if (qn_run_is_in_time (run) && result->outcome == QN_OUTCOME_COLLAPSE)
    return g_strdup_printf (_ ("Overturns at %.3g s"), result->history.collapse_time);
  return g_strdup (qn_explain_outcome_label (result));
}

/* What the multiplier means in words of the load, and whether it meets what the project asks for. */
static char *
dup_words (Card *card, const QnRun *run)
{
  double value = run->result.collapse_multiplier;
  QnReportTemplate plan;
  gboolean sound =
    qn_report_template_read (&plan, qn_document_get_project (card->document), NULL);
  double demand = sound ? plan.demand : 0.0;
  qn_report_template_clear (&plan);
  g_autofree char *amount =
    qn_live_loads_dup_amount (&run->model, value, qn_settings_get_units ());
  g_autofree char *words =
    amount != NULL ? g_strdup_printf (_ ("Load multiplier at collapse: %s."), amount)
                   : g_strdup (_ ("Load multiplier at collapse."));
  if (!(demand > 0.0))
    return g_steal_pointer (&words);
  return value >= demand
           ? g_strdup_printf (_ ("%s The demand of %.4g is met %.3g times."), words,
                              demand, value / demand)
           : g_strdup_printf (_ ("%s The demand of %.4g is not met: %.3g of it."), words,
                              demand, value / demand);
}

static void
update_values (Card *card, const QnRun *run, const char *bounds)
{
  const QnStatistics *s = &run->result.statistics;
  const QnCount counts[] = {
    { QN_COUNTED_STEPS, run->result.step_count },
    { QN_COUNTED_ITERATIONS, (gsize) s->iterations },
    { QN_COUNTED_FACTORISATIONS, (gsize) s->factorizations },
  };
  g_autofree char *work = qn_counts_dup_text (counts, G_N_ELEMENTS (counts), ", ");
  g_autofree char *cost = g_strdup_printf (_ ("%s, %.2f s"), work, s->seconds);
  g_autofree char *text = g_strconcat (bounds, cost, NULL);
  set_text (card, "values", text);
}

static void
update (Card *card)
{
  const QnRun *run = card->document->run;
  gtk_widget_set_visible (card->box, run != NULL);
  if (run == NULL)
    return;
  set_text (card, "stale",
            qn_run_age_text (qn_document_get_run_age (card->document, run)));
  g_autofree char *number = dup_number (run);
  set_text (card, "number", number);
  double bounds[QN_BOUND_KIND_COUNT];
  qn_bounds_collect (card->document, bounds);
  const gboolean analysed = run->kind == QN_RUN_ANALYSIS;
  g_autofree char *verdict = analysed ? qn_bounds_dup_verdict (bounds) : NULL;
  g_autofree char *numbers = analysed ? qn_bounds_dup_text (bounds) : g_strdup ("");
  set_text (card, "verdict", verdict);
  g_autofree char *sentence = qn_run_dup_mechanism_sentence (run);
  set_text (card, "mechanism", sentence);
  g_autofree char *whole =
    analysed ? qn_explain_mechanism (&run->model, &run->contacts, &run->result) : NULL;
  g_autofree char *outcome = qn_run_dup_explanation (run);
  g_autofree char *explanation =
    whole != NULL ? g_strdup_printf ("%s\n\n%s", outcome, whole) : g_strdup (outcome);
  gboolean given = analysed && run->result.has_collapse_multiplier;
  /* Where there is no number, the words are the answer. */
  g_autofree char *words = given ? dup_words (card, run) : NULL;
  set_text (card, "outcome", given ? words : outcome);
  set_text (card, "explanation", given ? explanation : whole);
  update_values (card, run, numbers);
  guint told;
  g_autofree char *events = qn_run_dup_events (run, qn_settings_get_units (), &told);
  gtk_widget_set_visible (qn_part (card->box, "events"), *events != '\0');
  g_autofree char *title = g_strdup_printf (
    ngettext ("%u _event on the path", "%u _events on the path", (gulong) told), told);
  gtk_expander_set_label (qn_part (card->box, "events"), title);
  set_text (card, "happened", events);
  g_autofree char *stages = qn_outcome_dup_stages (&run->model, &run->result);
  set_text (card, "led", stages);
  gtk_widget_set_visible (qn_part (card->box, "stages"), stages != NULL);
  /* Without a live load there is no multiplier that other methods could find. */
  gtk_widget_set_visible (qn_part (card->box, "others"),
                          !qn_model_lacks_live_load (&card->document->project.model));
}

GtkWidget *
qn_answer_card_new (QnDocument *document)
{
  g_autoptr (GtkBuilder) builder = qn_builder_new ("answer-card");
  Card *card = g_new (Card, 1);
  *card = (Card){ document, qn_builder_take_widget (builder, "card") };
  GtkWidget *box = card->box;
  qn_own (box, card);
  qn_watch (box, document, "runs-changed", G_CALLBACK (update), card);
  qn_watch (box, document, "changed", G_CALLBACK (update), card);
  qn_watch (box, qn_settings_get (), "changed", G_CALLBACK (update), card);
  update (card);
  return box;
}
