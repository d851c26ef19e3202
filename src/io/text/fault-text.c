#include "io/text/fault-text.h"
#include "io/text/text-format.h"

#include <glib/gi18n-lib.h>
#include <math.h>

static const struct {
  const char *name, *sentence;
  const char *unit; /* of both numbers; NULL: they say nothing to a reader */
} claims[QN_CLAIM_COUNT] = {
  [QN_CLAIM_NUMBERS] = { "numbers", N_ ("a number is not finite"), NULL },
  [QN_CLAIM_STEPS] = { "steps",
                       N_ ("the steps are not in order, or one is out of balance"), "" },
  [QN_CLAIM_DISPLACEMENTS] = { "displacements",
                               N_ ("a support, or a node on a block, has a wrong "
                                   "displacement"),
                               "m" },
  [QN_CLAIM_FORCES] = { "forces",
                        N_ ("the force is not the one that the displacements cause"),
                        "N" },
  [QN_CLAIM_BEAM_FORCES] = { "beam-forces",
                             N_ (
                               "the section force is not the one that the displacements "
                               "cause"),
                             "N" },
  [QN_CLAIM_STRENGTH] = { "strength", N_ ("the force is above the strength of the joint"),
                          "N" },
  [QN_CLAIM_STATES] = { "states", N_ ("the state of the joint is not that of its force"),
                        NULL },
  [QN_CLAIM_BALANCE] = { "balance", N_ ("forces and loads are out of balance"), "N" },
  [QN_CLAIM_TIES] = { "ties",
                      N_ ("force, elongation or state of the tie is not that of its "
                          "ends, or exceeds its strength"),
                      "N" },
  [QN_CLAIM_REACTIONS] = { "reactions",
                           N_ ("the reaction is not what forces and loads leave"), "N" },
  [QN_CLAIM_OUTCOME] = { "outcome", N_ ("the outcome is not that of the steps"), NULL },
  [QN_CLAIM_COLLAPSE] = { "collapse-multiplier",
                          N_ ("the collapse multiplier is not that of the steps"), "" },
  [QN_CLAIM_FIRST_LIMIT] = { "first-limit-multiplier",
                             N_ ("no step has the multiplier of the first limit point"),
                             "" },
  [QN_CLAIM_OVERLAP] = { "mechanism-overlap",
                         N_ ("blocks move into each other in the mechanism"), "m" },
  [QN_CLAIM_FLOW] = { "mechanism-flow",
                      N_ ("the mechanism moves where the joints cannot yield"), "m" },
  [QN_CLAIM_WORK] = { "mechanism-work", N_ ("the loads do no work on the mechanism"),
                      "J" },
  [QN_CLAIM_STABILITY] = { "stability", N_ ("the step is not stable"), NULL },
  [QN_CLAIM_MODE] = { "mode", N_ ("the mode is not one of the stiffness at this step"),
                      "" },
  [QN_CLAIM_LOWER_BOUND] = { "lower-bound",
                             N_ ("the lower bound is not the multiplier that the forces "
                                 "carry"),
                             "" },
  [QN_CLAIM_UPPER_BOUND] = { "upper-bound",
                             N_ ("the upper bound is not that of the mechanism"), "" },
  [QN_CLAIM_INTERVAL] = { "interval",
                          N_ ("the interval is not that of the solutions, or these are "
                              "not those of the steps"),
                          "" },
  [QN_CLAIM_LINEARITY] = { "linearity",
                           N_ ("linear geometry ends at another multiplier than stated"),
                           "" },
  [QN_CLAIM_HISTORY] = { "history", N_ ("the history is not that of the steps"), "" },
};

const char *
qn_claim_name (QnClaim claim)
{
  return claims[claim].name;
}

/* "pair 3 between “a” and “b”"; NULL for what the model does not have. */
static char *
dup_place (const QnModel *model, const QnContacts *contacts, const QnFault *fault)
{
  const size_t at = (size_t) fault->index;
  if (fault->index < 0)
    return NULL;
  if (fault->entity == QN_ENTITY_CONTACT) {
    if (contacts == NULL || at >= contacts->pair_count)
      return qn_text_printf (_ ("pair %d"), fault->index);
    const QnContactFace *face = &contacts->faces[contacts->pairs[at].face];
    return qn_text_printf (_ ("pair %d between “%s” and “%s”"), fault->index,
                           model->blocks[face->a].name, model->blocks[face->b].name);
  }
  if (fault->entity == QN_ENTITY_BLOCK && at < model->block_count)
    return qn_text_printf (_ ("block “%s”"), model->blocks[at].name);
  if (fault->entity == QN_ENTITY_NODE && at < model->node_count)
    return qn_text_printf (_ ("node “%s”"), model->nodes[at].name);
  if (fault->entity == QN_ENTITY_BEAM && at < model->beam_count)
    return qn_text_printf (_ ("beam “%s”"), model->beams[at].name);
  if (fault->entity == QN_ENTITY_TIE && at < qn_model_tie_count (model))
    return qn_text_printf (_ ("tie “%s”"), qn_model_tie (model, at)->name);
  return qn_text_printf (_ ("number %d"), fault->index);
}

QnClaim
qn_claim_from_name (const char *name)
{
  int claim = 0;
  while (claim < QN_CLAIM_COUNT && g_strcmp0 (name, claims[claim].name) != 0)
    claim++;
  return (QnClaim) claim;
}

char *
qn_fault_dup_text (const QnModel *model, const QnContacts *contacts, const QnFault *fault)
{
  GString *text = g_string_new (NULL);
  g_autofree char *place = dup_place (model, contacts, fault);
  const char *unit = claims[fault->claim].unit;

  if (fault->step != QN_NONE)
    qn_text_append (text, _ ("step %d: "), fault->step);
  if (place != NULL)
    qn_text_append (text, _ ("%s: "), place);
  g_string_append (text, _ (claims[fault->claim].sentence));
  if (unit != NULL && !isnan (fault->stated)) {
    qn_text_append (text, _ (": %.8g"), fault->stated);
    if (!isnan (fault->found) && fault->found != 0)
      qn_text_append (text, _ (" instead of %.8g"), fault->found);
    qn_text_append (text, unit[0] != '\0' ? " %s" : "%s", unit);
  }
  return g_string_free (text, FALSE);
}
