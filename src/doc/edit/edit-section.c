#include "doc/edit/edit-frame.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <stdlib.h>

/* Plain concrete, where nothing is known. */
#define FIRST_YOUNG       30e9
#define FIRST_POISSON     0.2
#define FIRST_SIZE        0.2
#define FIRST_UNIT_WEIGHT 24e3

static gboolean
is_rectangle (const QnSection *section)
{
  return section->height > 0.0;
}

gboolean
qn_edit_set_section_shape (QnModel *model, QnId id, gboolean rectangle, GError **error)
{
  QnSection *section = &model->sections[id];
  if (rectangle == is_rectangle (section))
    return TRUE;
  if (rectangle) { /* of the same area and inertia */
    section->height = sqrt (12.0 * section->inertia / section->area);
    section->width = section->area / section->height;
  } else {
    section->area = section->width * section->height;
    section->inertia = section->area * section->height * section->height / 12.0;
    double plastic = qn_section_plastic_moment (section);
    section->plastic_moment = isfinite (plastic) ? plastic : 0.0;
    section->width = section->height = section->yield = 0.0;
  }
  return TRUE;
}

gboolean
qn_edit_add_section (QnModel *model, QnId like, GError **error)
{
  g_autofree char *name = qn_edit_dup_new_name (
    model, qn_model_find_section, _ ("section"), " ", model->section_count + 1);
  QnSection *section = qn_model_add_section (model, name);
  if (section == NULL)
    return qn_edit_no_memory (error);
  if (like != QN_NONE) {
    char *own = section->name;
    *section = model->sections[like];
    section->name = own;
    section->note = 0;
    return TRUE;
  }
  section->young = FIRST_YOUNG;
  section->poisson = FIRST_POISSON;
  section->width = section->height = FIRST_SIZE;
  section->unit_weight = FIRST_UNIT_WEIGHT;
  return TRUE;
}

gboolean
qn_edit_rename_section (QnModel *model, QnId id, const char *name, GError **error)
{
  if (qn_model_find_section (model, name) != QN_NONE)
    return qn_edit_refuse (error, _ ("There is a section named “%s” already"), name);
  return qn_edit_take_name (&model->sections[id].name, name, error);
}

void
qn_edit_remove_unused_sections (QnModel *model)
{
  g_autofree QnId *follow = g_new (QnId, model->section_count + 1);
  for (gsize i = 0; i < model->section_count; i++)
    follow[i] = QN_NONE;
  for (gsize i = 0; i < model->beam_count; i++)
    follow[model->beams[i].section] = 0;
  gsize kept = 0;
  for (gsize i = 0; i < model->section_count; i++) {
    if (follow[i] == QN_NONE) {
      free (model->sections[i].name);
      continue;
    }
    follow[i] = (QnId) kept;
    model->sections[kept++] = model->sections[i];
  }
  model->section_count = kept;
  for (gsize i = 0; i < model->beam_count; i++)
    model->beams[i].section = follow[model->beams[i].section];
}
