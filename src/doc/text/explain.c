#include "doc/text/explain.h"

#include "io/text/mechanism-text.h"
#include "io/text/outcome-text.h"

#include <glib/gi18n.h>

static const char *
entity_word (QnEntity entity)
{
  switch (entity) {
  case QN_ENTITY_LAW:
    return _ ("Law");
  case QN_ENTITY_BLOCK:
    return _ ("Block");
  case QN_ENTITY_WALL:
    return _ ("Wall");
  case QN_ENTITY_CONTACT:
    return _ ("Contacts");
  case QN_ENTITY_FACE_OVERRIDE:
    return _ ("Contact face");
  case QN_ENTITY_BAR:
    return _ ("Reinforcing bar");
  case QN_ENTITY_NODE:
    return _ ("Node");
  case QN_ENTITY_SECTION:
    return _ ("Section");
  case QN_ENTITY_BEAM:
    return _ ("Beam");
  case QN_ENTITY_DEAD_LOAD:
    return _ ("Dead load");
  case QN_ENTITY_LIVE_LOAD:
    return _ ("Live load");
  case QN_ENTITY_ANALYSIS:
    return _ ("Analysis");
  case QN_ENTITY_STAGE:
    return _ ("Load stage");
  case QN_ENTITY_GROUND_MOTION:
    return _ ("Ground motion");
  case QN_ENTITY_INITIAL_MOTION:
    return _ ("Initial motion");
  case QN_ENTITY_TRACK:
    return _ ("Tracked displacement");
  case QN_ENTITY_MASONRY:
    return _ ("Masonry");
  case QN_ENTITY_MODEL:
    break;
  }
  return _ ("Model");
}

static const char *
entity_name (const QnModel *model, QnEntity entity, QnId index)
{
  if (model == NULL || index < 0)
    return NULL;
  gsize i = (gsize) index;
  if (entity == QN_ENTITY_BLOCK && i < model->block_count)
    return model->blocks[i].name;
  if (entity == QN_ENTITY_WALL && i < model->wall_count)
    return model->walls[i].name;
  if (entity == QN_ENTITY_LAW && i < model->law_count)
    return model->laws[i].name;
  if (entity == QN_ENTITY_NODE && i < model->node_count)
    return model->nodes[i].name;
  if (entity == QN_ENTITY_SECTION && i < model->section_count)
    return model->sections[i].name;
  if (entity == QN_ENTITY_BEAM && i < model->beam_count)
    return model->beams[i].name;
  return NULL;
}

char *
qn_explain_diag (const QnModel *model, const QnDiag *diag)
{
  const char *text = _ (qn_problem_text (diag->problem));
  const char *word = entity_word (diag->entity);
  const char *name = entity_name (model, diag->entity, diag->index);
  const char *other = entity_name (model, diag->entity, diag->other);
  if (name != NULL && other != NULL)
    return g_strdup_printf (_ ("%s “%s” and “%s”: %s"), word, name, other, text);
  if (name != NULL)
    return g_strdup_printf (_ ("%s “%s”: %s"), word, name, text);
  if (diag->index >= 0 && diag->entity != QN_ENTITY_MODEL)
    return g_strdup_printf (_ ("%s %d: %s"), word, diag->index + 1, text);
  return g_strdup_printf (_ ("%s: %s"), word, text);
}

char *
qn_explain_finding (const QnModel *model, const QnFinding *finding)
{
  const char *a = entity_name (model, QN_ENTITY_BLOCK, finding->block_a);
  const char *b = entity_name (model, QN_ENTITY_BLOCK, finding->block_b);
  const char *text = _ (qn_problem_text (finding->problem));
  g_autofree char *width = finding->value > 0.0
                             ? g_strdup_printf (" (%.3g mm)", finding->value * 1e3)
                             : g_strdup ("");
  if (a != NULL && b != NULL)
    return g_strdup_printf (_ ("%s – %s: %s%s"), a, b, text, width);
  return g_strdup_printf (_ ("%s: %s%s"), a != NULL ? a : _ ("Model"), text, width);
}

const char *
qn_explain_outcome_label (QnOutcome outcome)
{
  switch (outcome) {
  case QN_OUTCOME_COLLAPSE:
    return _ ("Collapse");
  case QN_OUTCOME_TARGET_REACHED:
    return _ ("Target reached");
  case QN_OUTCOME_SNAP:
    return _ ("Stopped at a limit point");
  case QN_OUTCOME_UNBOUNDED:
    return _ ("No limit");
  case QN_OUTCOME_DEAD_LOAD_UNSTABLE:
    return _ ("Dead load cannot stand");
  case QN_OUTCOME_CANCELLED:
    return _ ("Cancelled");
  case QN_OUTCOME_NOT_CONVERGED:
    return _ ("Not converged");
  case QN_OUTCOME_REST:
    return _ ("At rest");
  case QN_OUTCOME_COUNT:
    break;
  }
  return "";
}

const char *
qn_explain_pair_state (QnPairState state)
{
  switch (state) {
  case QN_PAIR_STICK:
    return _ ("sticks");
  case QN_PAIR_SLIP:
    return _ ("slides");
  case QN_PAIR_OPEN:
    return _ ("open");
  case QN_PAIR_YIELD:
    return _ ("yields");
  case QN_PAIR_STATE_COUNT:
    break;
  }
  return "";
}

char *
qn_explain_outcome (const QnModel *model, const QnResult *result)
{
  return qn_outcome_dup_reason (model, result);
}

char *
qn_explain_mechanism (const QnModel *model, const QnContacts *contacts,
                      const QnResult *result)
{
  return qn_collapse_dup_text (model, contacts, result);
}

char *
qn_explain_mechanism_briefly (const QnModel *model, const QnContacts *contacts,
                              const QnResult *result)
{
  if (result->mechanism == NULL)
    return NULL;
  QnMechanism mechanism;
  if (qn_mechanism_init (&mechanism, model, contacts, result->mechanism, NULL) != QN_OK)
    return NULL;
  g_autofree char *title = qn_mechanism_dup_title (&mechanism);
  qn_mechanism_clear (&mechanism);
  if (result->mechanism_uncertain)
    return g_strdup_printf (_ ("%s (last motion)"), title);
  return g_steal_pointer (&title);
}
