/* The selected blocks: what they are made of, and how they are held. */
#include "app/forms/form.h"
#include "app/forms/panel.h"
#include "app/widgets/settings.h"
#include "io/project/typical-joint.h"
#include <glib/gi18n.h>

#define CHANGE N_ ("Set Support")

#define FIELDS(FIELD, MEMBER)                                                            \
  FIELD (TITLE, "title", NULL)                                                           \
  FIELD (NAME, "name", N_ ("Rename Block"))                                              \
  FIELD (THICKNESS, "thickness", N_ ("Set Thickness"))                                   \
  FIELD (WEIGHT, "weight", N_ ("Set Unit Weight"))                                       \
  FIELD (STONE, "stone", N_ ("Set Unit Weight"))                                         \
  FIELD (STONE_SOURCE, "stone_source", NULL)                                             \
  FIELD (LAW, "law", N_ ("Set Law"))                                                     \
  FIELD (SUPPORTS, "supports", NULL)                                                     \
  FIELD (SUPPORT, "support_x", CHANGE)                                                   \
  FIELD (SUPPORT_Y, "support_y", CHANGE)                                                 \
  FIELD (SUPPORT_TURN, "support_turn", CHANGE)                                           \
  FIELD (JOIN, "join", NULL)
QN_FORM_FIELDS;

static gboolean
look (QnForm *form, const QnModel *model)
{
  return form->parts.blocks.count > 0;
}

/* Whether not all have what the first one has. */
static gboolean
is_mixed (const QnModel *model, QnBlockSet set, guint field)
{
  const QnBlock *first = &model->blocks[set.ids[0]];
  gboolean mixed = FALSE;
  for (guint i = 0; i < set.count; i++) {
    const QnBlock *block = &model->blocks[set.ids[i]];
    mixed |= field == THICKNESS ? block->thickness != first->thickness
             : field == WEIGHT  ? block->unit_weight != first->unit_weight
             : field == LAW
               ? block->law != first->law
               : block->support[field - SUPPORT] != first->support[field - SUPPORT];
  }
  return mixed;
}

/* What has no row among usual or common things has one behind them, which changes nothing. */
static void
show_stones (QnValue *value, int stone)
{
  for (int i = 0; i < QN_STONE_COUNT; i++) {
    g_autofree char *weight =
      qn_units_format_full (qn_settings_get_units (), QN_QUANTITY_UNIT_WEIGHT,
                            qn_typical_stones[i].unit_weight, 4);
    qn_value_take_row (value,
                       g_strdup_printf ("%s, %s", _ (qn_typical_stones[i].name), weight));
  }
  value->number = stone;
  if (stone < 0) {
    value->number = QN_STONE_COUNT;
    qn_value_add_row (value, _ ("Other"));
  }
}

static gboolean
show (QnForm *form, const QnModel *model, guint field, QnValue *value)
{
  QnBlockSet set = form->parts.blocks;
  const QnBlock *block = &model->blocks[set.ids[0]];
  /* What masonry is made of is told by its own form. */
  gboolean masonry = TRUE;
  for (guint i = 0; i < set.count; i++)
    masonry = masonry && model->blocks[set.ids[i]].masonry != QN_NONE;
  gboolean free_block =
    set.count == 1 && block->wall == QN_NONE && block->masonry == QN_NONE;
  int stone =
    is_mixed (model, set, WEIGHT) ? -1 : qn_typical_stone_find (block->unit_weight);
  switch (field) {
  case TITLE:
    value->text =
      set.count == 1
        ? g_strdup_printf (_ ("Block %s"), block->name)
        : g_strdup_printf (ngettext ("%u Block", "%u Blocks", set.count), set.count);
    return TRUE;
  case NAME:
    value->text = g_strdup (block->name);
    return free_block;
  case THICKNESS:
    value->number = block->thickness;
    value->mixed = is_mixed (model, set, field);
    return !masonry;
  case WEIGHT:
    value->number = block->unit_weight;
    value->mixed = is_mixed (model, set, field);
    return !masonry;
  case STONE:
    show_stones (value, stone);
    return !masonry;
  case STONE_SOURCE:
    value->text = stone < 0 ? NULL : g_strdup (_ (qn_typical_stones[stone].source));
    return !masonry && stone >= 0;
  case LAW:
    qn_value_set_laws (value, model, _ ("As all contacts"), block->law);
    if (is_mixed (model, set, field)) {
      value->number = value->row_count;
      qn_value_add_row (value, _ ("various"));
    }
    return !masonry;
  case SUPPORTS:
    return TRUE;
  case JOIN:
    return set.count > 1;
  default:
    value->number = block->support[field - SUPPORT];
    value->mixed = is_mixed (model, set, field);
    return TRUE;
  }
}

static gboolean
take (QnForm *data, QnModel *model, guint field, const QnValue *value, GError **error)
{
  QnBlockSet set = data->parts.blocks;
  switch (field) {
  case NAME:
    return qn_edit_rename_block (model, set.ids[0], value->text, error);
  case THICKNESS:
    return qn_edit_set_blocks (model, set, QN_BLOCK_THICKNESS, value->number, error);
  case WEIGHT:
    return qn_edit_set_blocks (model, set, QN_BLOCK_UNIT_WEIGHT, value->number, error);
  case STONE:
    return value->number < QN_STONE_COUNT
           && qn_edit_set_blocks (model, set, QN_BLOCK_UNIT_WEIGHT,
                                  qn_typical_stones[qn_value_int (value)].unit_weight,
                                  error);
  case LAW:
    if (value->number > (double) model->law_count)
      return FALSE;
    return qn_edit_set_blocks (model, set, QN_BLOCK_LAW, qn_value_get_law (value), error);
  default:
    return qn_edit_set_support (model, set, (int) (field - SUPPORT), 1,
                                &(bool){ value->number != 0.0 }, error);
  }
}

const QnFormKind qn_block_form =
  QN_FORM_KIND ("block-form", QnForm, .look = look, .follows = QN_FOLLOW_SELECTION);
