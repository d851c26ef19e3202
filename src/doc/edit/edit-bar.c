#include "doc/edit/edit-bar.h"

#include "core/base/polygon.h"
#include "doc/text/law-trace.h"
#include <glib/gi18n-lib.h>
#include <math.h>

#define BAR_DIAMETER 0.016

/* From the edge of the blocks to the end of a bar, in parts of the shorter side of their box. */
#define COVER 0.05

static gboolean
find_metal (QnModel *model, QnId *law, GError **error)
{
  static const QnLawKind metals[] = { QN_LAW_STEEL, QN_LAW_ELASTIC_PLASTIC,
                                      QN_LAW_BILINEAR };
  for (gsize k = 0; k < G_N_ELEMENTS (metals); k++)
    for (gsize i = 0; i < model->law_count; i++)
      if (model->laws[i].kind == metals[k] && model->laws[i].basis != QN_BASIS_CONTACT) {
        *law = (QnId) i;
        return TRUE;
      }
  g_autofree char *name =
    qn_model_find_law (model, _ ("steel")) == QN_NONE
      ? g_strdup (_ ("steel"))
      : qn_edit_dup_new_name (model, qn_model_find_law, _ ("steel"), " ", 2);
  QnLaw *added = qn_model_add_law (model, name);
  if (added == NULL)
    return qn_edit_no_memory (error);
  char *kept = added->name;
  *added = qn_law_preset (QN_LAW_STEEL)->law;
  added->name = kept;
  *law = (QnId) model->law_count - 1;
  return TRUE;
}

static QnBox
box_of (const QnModel *model, QnBlockSet set)
{
  QnBox box = QN_BOX_EMPTY;
  for (guint i = 0; i < set.count; i++)
    qn_box_add_box (&box, qn_model_block_box (model, set.ids[i]));
  return box;
}

/* Whether a level line through the middle meets more of the blocks than an upright one. */
static gboolean
lies_level (const QnModel *model, QnBlockSet set, QnVec2 middle, QnVec2 size)
{
  guint level = 0, upright = 0;
  for (guint i = 0; i < set.count; i++) {
    QnBox box = qn_model_block_box (model, set.ids[i]);
    level += box.min.y < middle.y && middle.y < box.max.y;
    upright += box.min.x < middle.x && middle.x < box.max.x;
  }
  return level > upright || (level == upright && size.x >= size.y);
}

gboolean
qn_edit_draw_bar (QnModel *model, QnVec2 start, QnVec2 end, GError **error)
{
  QnId law = QN_NONE;
  if (!find_metal (model, &law, error))
    return FALSE;
  QnBar *bar = qn_model_add_bar (model);
  if (bar == NULL)
    return qn_edit_no_memory (error);
  *bar = (QnBar){
    .law = law, .area = qn_bar_get_area (BAR_DIAMETER), .start = start, .end = end
  };
  return TRUE;
}

gboolean
qn_edit_add_bar (QnModel *model, QnBlockSet set, GError **error)
{
  QnBox box = box_of (model, set);
  if (set.count == 0)
    return qn_edit_refuse_nothing (error,
                                   _ ("Select the blocks that the bar goes through"));
  QnVec2 size = qn_vec2_sub (box.max, box.min);
  QnVec2 middle = qn_vec2_lerp (box.min, box.max, 0.5);
  double cover = COVER * fmin (size.x, size.y);
  QnVec2 half = lies_level (model, set, middle, size)
                  ? qn_vec2 (0.5 * size.x - cover, 0.0)
                  : qn_vec2 (0.0, 0.5 * size.y - cover);
  return qn_edit_draw_bar (model, qn_vec2_sub (middle, half), qn_vec2_add (middle, half),
                           error);
}

static gboolean
has_bar (const QnModel *model, QnId bar, GError **error)
{
  return (bar >= 0 && (gsize) bar < model->bar_count)
         || qn_edit_refuse_nothing (error, _ ("There is no such bar"));
}

gboolean
qn_edit_remove_bar (QnModel *model, QnId bar, GError **error)
{
  if (!has_bar (model, bar, error))
    return FALSE;
  qn_edit_drop (model->bars, &model->bar_count, sizeof *model->bars, (gsize) bar);
  return TRUE;
}

gboolean
qn_edit_duplicate_bar (QnModel *model, QnId bar, GError **error)
{
  if (!has_bar (model, bar, error))
    return FALSE;
  QnBar *added = qn_model_add_bar (model);
  if (added == NULL)
    return qn_edit_no_memory (error);
  *added = model->bars[bar];
  QnVec2 along = qn_vec2_sub (added->end, added->start);
  QnVec2 aside =
    qn_vec2_scale (4.0 * qn_bar_get_diameter (added->area) / qn_vec2_length (along),
                   qn_vec2 (-along.y, along.x));
  for (int32_t i = 0; i < added->via_count; i++)
    added->via[i] = qn_vec2_add (added->via[i], aside);
  added->start = qn_vec2_add (added->start, aside);
  added->end = qn_vec2_add (added->end, aside);
  return TRUE;
}

QnId
qn_model_find_bar (const QnModel *model, QnVec2 at, double reach)
{
  QnId nearest = QN_NONE;
  for (gsize i = 0; i < model->bar_count; i++) {
    for (gsize k = 0; k < qn_bar_line_count (&model->bars[i]); k++) {
      QnVec2 ends[2];
      qn_bar_line (&model->bars[i], k, ends);
      double distance = qn_segment_distance (ends[0], ends[1], at);
      if (distance > reach)
        continue;
      reach = distance;
      nearest = (QnId) i;
    }
  }
  return nearest;
}

static char *
dup_place (QnUnits units, QnVec2 at)
{
  g_autofree char *x = qn_units_format (units, QN_QUANTITY_LENGTH, at.x, 4);
  g_autofree char *y = qn_units_format_full (units, QN_QUANTITY_LENGTH, at.y, 4);
  return g_strdup_printf ("%s; %s", x, y);
}

char *
qn_bar_dup_text (const QnModel *model, const QnBar *bar, QnUnits units)
{
  g_autofree char *diameter = qn_units_format_full (units, QN_QUANTITY_DIAMETER,
                                                    qn_bar_get_diameter (bar->area), 3);
  g_autofree char *start = dup_place (units, bar->start);
  g_autofree char *end = dup_place (units, bar->end);
  return g_strdup_printf ("%s, Ø %s: %s – %s", model->laws[bar->law].name, diameter,
                          start, end);
}
