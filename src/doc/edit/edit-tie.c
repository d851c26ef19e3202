#include "doc/edit/edit-tie.h"

#include "core/base/numbers.h"
#include "core/model/bar.h"
#include "doc/edit/edit-frame.h"
#include "doc/text/law-text.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

/* E: EN 1993-1-1:2005, 3.2.6; fy: its table 3.1, up to 40 mm thick. */
const QnTieSteel qn_tie_steels[QN_TIE_STEELS] = {
  { "S235", 210e9, 235e6 },
  { "S275", 210e9, 275e6 },
  { "S355", 210e9, 355e6 },
  { "S450", 210e9, 440e6 },
};

const double qn_tie_diameters[QN_TIE_DIAMETERS] = { 0.010, 0.012, 0.016, 0.020, 0.024,
                                                    0.027, 0.030, 0.036, 0.042 };

#define TIE_DIAMETER 0.020

/* Where a copy of a bar or tie goes: four diameters to its left. */
static QnVec2
way_aside (QnVec2 start, QnVec2 end, double area)
{
  QnVec2 along = qn_vec2_sub (end, start);
  return qn_vec2_scale (4.0 * qn_bar_get_diameter (area) / qn_vec2_length (along),
                        qn_vec2_perp (along));
}

static QnTieEnd
end_at (const QnModel *model, QnVec2 at)
{
  return (QnTieEnd){ qn_model_block_under (model, at), at };
}

/* FALSE where both ends are fixed to the same: nothing would be tied. */
static gboolean
ties_something (const QnTie *tie, GError **error)
{
  QnId block = tie->ends[0].block;
  return block != tie->ends[1].block
         || qn_edit_refuse (error, block == QN_NONE
                                     ? _ ("Both ends of the tie would be on the ground")
                                     : _ ("Both ends of the tie would be on the same "
                                          "block"));
}

/* A new tie under the first name that is free. */
static QnTie *
add_tie (QnModel *model)
{
  g_autofree char *name =
    qn_edit_dup_new_name (model, offsetof (QnModel, ties), "t", "", model->tie_count + 1);
  return qn_model_add_tie (model, name);
}

gboolean
qn_edit_draw_tie (QnModel *model, QnVec2 from, QnVec2 to, GError **error)
{
  QnTie *tie = add_tie (model);
  if (tie == NULL)
    return qn_edit_no_memory (error);
  tie->ends[0] = end_at (model, from);
  tie->ends[1] = end_at (model, to);
  tie->area = qn_bar_get_area (TIE_DIAMETER);
  tie->elasticity = qn_tie_steels[0].elasticity;
  tie->yield = qn_tie_steels[0].yield;
  return ties_something (tie, error);
}

static gboolean
copy_tie (QnModel *model, QnId tie, GError **error)
{
  QnTie *added = add_tie (model);
  if (added == NULL)
    return qn_edit_no_memory (error);
  char *name = added->name;
  *added = model->ties[tie];
  added->name = name;
  QnVec2 aside = way_aside (added->ends[0].at, added->ends[1].at, added->area);
  for (int end = 0; end < 2; end++)
    added->ends[end].at = qn_vec2_add (added->ends[end].at, aside);
  return TRUE;
}

/* Where a line meets the sides of blocks, as parts of it, in order; 0 and 1 too. */
static GArray *
find_sides (const QnModel *model, QnVec2 from, QnVec2 along)
{
  const double ends[] = { 0.0, 1.0 }, length = qn_vec2_length (along);
  GArray *places = g_array_new (FALSE, FALSE, sizeof (double));
  g_array_append_vals (places, ends, 2);
  for (gsize b = 0; b < model->block_count; b++) {
    const QnVec2 *v = qn_model_block_vertices (model, (QnId) b);
    const gsize count = (gsize) model->blocks[b].vertex_count;
    for (gsize i = 0; i < count; i++) {
      const QnVec2 side = qn_vec2_sub (v[(i + 1) % count], v[i]);
      const QnVec2 to = qn_vec2_sub (v[i], from);
      const double turn = qn_vec2_cross (along, side);
      /* Of a side on the line its ends, where others begin. */
      const gboolean parallel = fabs (turn) < 1e-9 * length * qn_vec2_length (side);
      const double place = parallel ? qn_vec2_dot (to, along) / (length * length)
                                    : qn_vec2_cross (to, side) / turn;
      if (place > 0.0 && place < 1.0)
        g_array_append_val (places, place);
    }
  }
  g_array_sort (places, qn_compare_doubles);
  return places;
}

/* The blocks below a line, each with the middle of what it covers; an array of QnTieEnd. */
static GArray *
find_blocks_along (const QnModel *model, QnVec2 from, QnVec2 to)
{
  const QnVec2 along = qn_vec2_sub (to, from);
  const double little = 1e-6 / qn_vec2_length (along);
  g_autoptr (GArray) places = find_sides (model, from, along);
  GArray *found = g_array_new (FALSE, FALSE, sizeof (QnTieEnd));
  double begin = 0.0;
  for (guint i = 0; i + 1 < places->len; i++) {
    const double *place = &g_array_index (places, double, i);
    QnTieEnd *last =
      found->len > 0 ? &g_array_index (found, QnTieEnd, found->len - 1) : NULL;
    if (place[1] - place[0] < little)
      continue;
    QnTieEnd end =
      end_at (model, qn_vec2_add_scaled (from, 0.5 * (place[0] + place[1]), along));
    const gboolean same = last != NULL && last->block == end.block;
    if (end.block == QN_NONE)
      continue;
    begin = same ? begin : place[0];
    end.at = qn_vec2_add_scaled (from, 0.5 * (begin + place[1]), along);
    if (same)
      *last = end;
    else
      g_array_append_val (found, end);
  }
  return found;
}

gboolean
qn_edit_glue_tie (QnModel *model, QnId tie, GError **error)
{
  if (!qn_edit_has_item (model, QN_PICK_TIE, tie, error))
    return FALSE;
  const QnTie strip = model->ties[tie];
  g_autoptr (GArray) blocks =
    find_blocks_along (model, strip.ends[0].at, strip.ends[1].at);
  if (blocks->len < 2)
    return qn_edit_refuse (error, _ ("The tie crosses no joint"));
  for (guint i = 0; i + 1 < blocks->len; i++) {
    QnTie *part = i == 0 ? &model->ties[tie] : add_tie (model);
    if (part == NULL)
      return qn_edit_no_memory (error);
    char *name = part->name;
    *part = strip;
    part->name = name;
    memcpy (part->ends, &g_array_index (blocks, QnTieEnd, i), sizeof part->ends);
  }
  return TRUE;
}

gboolean
qn_edit_place_tie_end (QnModel *model, QnId tie, int end, QnVec2 at, GError **error)
{
  if (!qn_edit_has_item (model, QN_PICK_TIE, tie, error))
    return FALSE;
  model->ties[tie].ends[end] = end_at (model, at);
  return ties_something (&model->ties[tie], error);
}

static const char *
name_of_end (const QnModel *model, const QnTieEnd *end)
{
  return end->block != QN_NONE ? model->blocks[end->block].name : _ ("ground");
}

char *
qn_tie_dup_text (const QnModel *model, const QnTie *tie, QnUnits units)
{
  g_autofree char *diameter = qn_units_format_full (units, QN_QUANTITY_DIAMETER,
                                                    qn_bar_get_diameter (tie->area), 3);
  return g_strdup_printf ("%s, Ø %s: %s – %s", tie->name, diameter,
                          name_of_end (model, &tie->ends[0]),
                          name_of_end (model, &tie->ends[1]));
}

char *
qn_tie_dup_facts (const QnTie *tie, QnUnits units)
{
  double strength = qn_tie_strength (tie);
  g_autofree char *length =
    qn_units_format_full (units, QN_QUANTITY_LENGTH, qn_tie_length (tie), 4);
  g_autofree char *stiffness =
    qn_units_format_full (units, QN_QUANTITY_STIFFNESS, qn_tie_stiffness (tie), 4);
  if (!isfinite (strength))
    return g_strdup_printf (_ ("Length %s, stiffness %s, no limit of its force"), length,
                            stiffness);
  g_autofree char *most = qn_units_format_full (units, QN_QUANTITY_FORCE, strength, 4);
  return g_strdup_printf (qn_tie_weakest (tie) == QN_TIE_ANCHOR
                            ? _ ("Length %s, stiffness %s, strength %s (anchor)")
                            : _ ("Length %s, stiffness %s, strength %s (steel)"),
                          length, stiffness, most);
}

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
    qn_edit_dup_free_name (model, offsetof (QnModel, laws), _ ("steel"));
  QnLaw *added = qn_model_add_law (model, name);
  if (added == NULL)
    return qn_edit_no_memory (error);
  char *kept = added->name;
  *added = qn_law_preset (QN_LAW_STEEL)->law;
  added->name = kept;
  *law = (QnId) model->law_count - 1;
  return TRUE;
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
  QnBox box = qn_edit_box_of (model, set);
  if (set.count == 0)
    return qn_edit_refuse (error, _ ("Select the blocks that the bar goes through"));
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
copy_bar (QnModel *model, QnId bar, GError **error)
{
  QnBar *added = qn_model_add_bar (model);
  if (added == NULL)
    return qn_edit_no_memory (error);
  *added = model->bars[bar];
  QnVec2 aside = way_aside (added->start, added->end, added->area);
  for (int32_t i = 0; i < added->via_count; i++)
    added->via[i] = qn_vec2_add (added->via[i], aside);
  added->start = qn_vec2_add (added->start, aside);
  added->end = qn_vec2_add (added->end, aside);
  return TRUE;
}

QnId
qn_edit_duplicate_item (QnModel *model, QnPickKind kind, QnId item, GError **error)
{
  const gboolean live = kind == QN_PICK_LIVE_LOAD;
  if (!qn_edit_has_item (model, kind, item, error))
    return QN_NONE;
  if (kind == QN_PICK_BAR || kind == QN_PICK_TIE)
    return (kind == QN_PICK_BAR ? copy_bar : copy_tie) (model, item, error)
             ? (QnId) qn_model_count_items (model, kind) - 1
             : QN_NONE;
  if (qn_edit_new_load (model, live, error) == NULL)
    return QN_NONE;
  QnLoad *original = qn_model_loads (model, live, NULL) + item;
  memmove (original + 1, original,
           (qn_model_count_items (model, kind) - 1 - (gsize) item) * sizeof *original);
  return item + 1;
}

char *
qn_bar_dup_text (const QnModel *model, const QnBar *bar, QnUnits units)
{
  g_autofree char *diameter = qn_units_format_full (units, QN_QUANTITY_DIAMETER,
                                                    qn_bar_get_diameter (bar->area), 3);
  g_autofree char *start =
    qn_units_format_pair (units, QN_QUANTITY_LENGTH, bar->start, 4);
  g_autofree char *end = qn_units_format_pair (units, QN_QUANTITY_LENGTH, bar->end, 4);
  return g_strdup_printf ("%s, Ø %s: %s – %s", model->laws[bar->law].name, diameter,
                          start, end);
}
