#include "doc/edit/edit.h"

#include <glib/gi18n.h>
#include <stdlib.h>
#include <string.h>

gboolean
qn_edit_add_force (QnModel *model, QnId block, gboolean live, QnVec2 force, QnVec2 at,
                   GError **error)
{
  QnLoad *load = live ? qn_model_add_live_load (model) : qn_model_add_dead_load (model);
  if (load == NULL)
    return qn_edit_no_memory (error);
  load->kind = QN_LOAD_FORCE;
  load->block = block;
  load->vector = force;
  load->has_at = true;
  load->at = at;
  return TRUE;
}

static void
remove_load (QnLoad *loads, size_t *count, size_t index)
{
  memmove (loads + index, loads + index + 1, (*count - index - 1) * sizeof *loads);
  (*count)--;
}

gboolean
qn_edit_delete_load (QnModel *model, gboolean live, QnId id, GError **error)
{
  size_t *count = live ? &model->live_load_count : &model->dead_load_count;
  if (id < 0 || (size_t) id >= *count) {
    g_set_error_literal (error, QN_EDIT_ERROR, QN_EDIT_ERROR_NOTHING,
                         _ ("There is no such load"));
    return FALSE;
  }
  remove_load (live ? model->live_loads : model->dead_loads, count, (size_t) id);
  return TRUE;
}

gboolean
qn_edit_set_weight_load (QnModel *model, gboolean live, QnVec2 direction, GError **error)
{
  size_t *count = live ? &model->live_load_count : &model->dead_load_count;
  QnLoad *loads = live ? model->live_loads : model->dead_loads;
  gboolean wanted = direction.x != 0.0 || direction.y != 0.0, found = FALSE;
  for (size_t i = *count; i > 0; i--) {
    if (loads[i - 1].kind != QN_LOAD_WEIGHT || loads[i - 1].set != 0)
      continue;
    if (wanted && !found)
      loads[i - 1].vector = direction;
    else
      remove_load (loads, count, i - 1);
    found = TRUE;
  }
  if (!wanted || found)
    return TRUE;
  QnLoad *load = live ? qn_model_add_live_load (model) : qn_model_add_dead_load (model);
  if (load == NULL)
    return qn_edit_no_memory (error);
  load->kind = QN_LOAD_WEIGHT;
  load->vector = direction;
  return TRUE;
}

gboolean
qn_edit_add_law (QnModel *model, QnId like, const char *name, GError **error)
{
  if (qn_model_find_law (model, name) != QN_NONE) {
    g_set_error (error, QN_EDIT_ERROR, QN_EDIT_ERROR_IMPOSSIBLE,
                 _ ("There is a law named “%s” already"), name);
    return FALSE;
  }
  QnLaw *law = qn_model_add_law (model, name);
  if (law == NULL)
    return qn_edit_no_memory (error);
  char *kept = law->name;
  *law = model->laws[like];
  law->name = kept;
  law->note = 0;
  return TRUE;
}

/* Calls for every place of the model that names a law. */
static void
each_law (QnModel *model, void (*visit) (QnId *law, gpointer data), gpointer data)
{
  visit (&model->contact.law, data);
  for (gsize i = 0; i < model->bar_count; i++)
    visit (&model->bars[i].law, data);
  for (gsize i = 0; i < model->block_count; i++)
    if (model->blocks[i].wall == QN_NONE)
      visit (&model->blocks[i].law, data);
  for (gsize i = 0; i < model->wall_count; i++)
    visit (&model->walls[i].law, data);
  for (gsize i = 0; i < model->override_count; i++)
    visit (&model->overrides[i].law, data);
}

typedef struct Uses {
  QnId law, by;
  guint count;
} Uses;

static void
count_use (QnId *law, gpointer data)
{
  Uses *uses = data;
  uses->count += *law == uses->law;
}

guint
qn_edit_count_law_uses (const QnModel *model, QnId law)
{
  Uses uses = { .law = law };
  each_law ((QnModel *) model, count_use, &uses);
  return uses.count;
}

static void
shift_law (QnId *law, gpointer data)
{
  const Uses *uses = data;
  if (*law == uses->law)
    *law = uses->by;
  if (*law > uses->law)
    (*law)--;
}

gboolean
qn_edit_delete_law (QnModel *model, QnId id, QnId by, GError **error)
{
  if (by == QN_NONE && model->contact.law == id) {
    g_set_error_literal (error, QN_EDIT_ERROR, QN_EDIT_ERROR_IMPOSSIBLE,
                         _ ("The law of all other contacts cannot be removed; choose "
                            "another one for them first"));
    return FALSE;
  }
  for (gsize i = 0; by == QN_NONE && i < model->bar_count; i++) {
    if (model->bars[i].law == id) {
      g_set_error_literal (error, QN_EDIT_ERROR, QN_EDIT_ERROR_IMPOSSIBLE,
                           _ ("The law of a reinforcing bar cannot be removed"));
      return FALSE;
    }
  }
  Uses uses = { .law = id, .by = by };
  each_law (model, shift_law, &uses);
  for (gsize i = 0; i < model->block_count; i++)
    if (model->blocks[i].wall != QN_NONE)
      shift_law (&model->blocks[i].law, &uses);
  qn_law_clear (&model->laws[id]);
  memmove (model->laws + id, model->laws + id + 1,
           (model->law_count - (gsize) id - 1) * sizeof *model->laws);
  model->law_count--;
  return TRUE;
}
