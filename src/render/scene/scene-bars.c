/* Reinforcing bars: lines from end to end that follow the blocks they lie in. Under a field of
 * stresses each piece has the colour of the stress where it crosses the nearest joint. A dot is where one
 * has yielded. */
#include "core/contact/contact-bars.h"
#include "core/model/bar.h"
#include "render/drawing/text.h"
#include "render/scene/scene-builder.h"

#include <glib/gi18n-lib.h>
#include <stdlib.h>

#define WIDTH_BAR 1.9
#define WIDTH_RIM 3.4

/* Where a bar goes over from one block to the next; along a joint between two columns from two to two. */
typedef struct Crossing {
  QnBarCrossing at;
  QnId from[2], to[2]; /* blocks */
  QnVec2 point;        /* undeformed, m */
  double force, area;  /* N, tension positive, 0 where forces are not known; m2 */
  bool yields;
} Crossing;

static Crossing
read_crossing (const QnSceneBuilder *b, const QnBarCrossing *at)
{
  const QnContactPair *pair = &b->contacts->pairs[at->pair];
  const QnContactFace *face = &b->contacts->faces[pair->face];
  QnVec2 ends[2];
  qn_bar_line (&b->model->bars[at->bar], (size_t) at->line, ends);
  bool forth = qn_vec2_dot (qn_vec2_sub (ends[1], ends[0]), face->normal) > 0;
  QnId from = forth ? face->a : face->b, to = forth ? face->b : face->a;
  Crossing crossing = { .at = *at,
                        .from = { from, from },
                        .to = { to, to },
                        .point = pair->point,
                        .area = pair->tributary * face->thickness };
  if (b->pairs != NULL) {
    const QnPairResult *result = &b->pairs[at->pair];
    crossing.force = qn_bar_axial (pair, result->normal_force, result->shear_force);
    crossing.yields = result->state == QN_PAIR_YIELD;
  }
  return crossing;
}

/* All of them, bar by bar, from start to end; two at one place are one. */
static GArray *
find_crossings (const QnSceneBuilder *b)
{
  GArray *crossings = g_array_new (FALSE, FALSE, sizeof (Crossing));
  size_t count = 0;
  QnBarCrossing *all =
    b->contacts != NULL ? qn_bar_crossings (b->model, b->contacts, &count) : NULL;
  for (size_t i = 0; i < count; i++) {
    const Crossing crossing = read_crossing (b, &all[i]);
    Crossing *last =
      i > 0 ? &g_array_index (crossings, Crossing, crossings->len - 1) : NULL;
    if (last == NULL || !qn_bar_crossings_meet (&last->at, &all[i])) {
      g_array_append_val (crossings, crossing);
      continue;
    }
    last->from[1] = crossing.from[0];
    last->to[1] = crossing.to[0];
    last->force += crossing.force;
    last->area += crossing.area;
    last->yields |= crossing.yields;
  }
  free (all);
  return crossings;
}

static double
stress_at (const GArray *crossings, guint i)
{
  const Crossing *c = &g_array_index (crossings, Crossing, i);
  return c->force / c->area;
}

/* A point of the blocks on one side of a crossing. */
static QnVec2
place (const QnSceneBuilder *b, const QnId blocks[2], QnVec2 point)
{
  return qn_vec2_lerp (qn_builder_place (b, blocks[0], point),
                       qn_builder_place (b, blocks[1], point), 0.5);
}

static bool
same_line (const Crossing *a, const Crossing *b)
{
  return a->at.bar == b->at.bar && a->at.line == b->at.line;
}

/* The part of a bar about `count` crossings: to the middle of the way to the next crossing on either
 * side, or to the bar's end. */
static void
add_part (QnSceneBuilder *b, const GArray *crossings, guint first, guint count,
          double width, QnColor color)
{
  const Crossing *all = (const Crossing *) (const void *) crossings->data;
  const Crossing *head = &all[first], *tail = &all[first + count - 1];
  QnVec2 line_ends[2];
  qn_bar_line (&b->model->bars[head->at.bar], (size_t) head->at.line, line_ends);
  bool begins = first == 0 || !same_line (&head[-1], head);
  bool ends = first + count == crossings->len || !same_line (&tail[1], tail);
  QnVec2 start = begins ? line_ends[0] : qn_vec2_lerp (head[-1].point, head->point, 0.5);
  QnVec2 end = ends ? line_ends[1] : qn_vec2_lerp (tail->point, tail[1].point, 0.5);
  g_autofree QnVec2 *line = g_new (QnVec2, 2 * count + 2);
  guint n = 0;
  line[n++] = place (b, head->from, start);
  for (const Crossing *c = head; c <= tail; c++) {
    line[n++] = place (b, c->from, c->point);
    line[n++] = place (b, c->to, c->point);
  }
  line[n++] = place (b, tail->to, end);
  qn_command_set_pick (
    qn_scene_stroke (b->scene, QN_LAYER_JOINTS, line, n, false, width, color),
    QN_PICK_BAR, head->at.bar);
}

static void
add_bars (QnSceneBuilder *b, const GArray *crossings, double width, QnColor color)
{
  for (guint first = 0, next; first < crossings->len; first = next) {
    const Crossing *all = (const Crossing *) (const void *) crossings->data;
    for (next = first + 1; next < crossings->len; next++)
      if (!same_line (&all[next], &all[first]))
        break;
    add_part (b, crossings, first, next - first, width, color);
  }
}

/* From end to end, where contacts are not known. */
static void
add_straight (QnSceneBuilder *b)
{
  const QnColor ink = qn_builder_ink (b, QN_INK_BAR);
  QnVec2 line[2];
  for (size_t bar = 0; bar < b->model->bar_count; bar++)
    for (size_t i = 0; i < qn_bar_line_count (&b->model->bars[bar]); i++) {
      qn_bar_line (&b->model->bars[bar], i, line);
      qn_command_set_pick (
        qn_scene_stroke (b->scene, QN_LAYER_JOINTS, line, 2, false, WIDTH_BAR, ink),
        QN_PICK_BAR, (QnId) bar);
    }
}

/* A dot where a bar has yielded, at the end of the step; one line in the legend. */
static void
add_yield_marks (QnSceneBuilder *b, const GArray *crossings)
{
  QnColor ink = qn_builder_ink (b, QN_INK_HINGE);
  bool any = false;
  for (guint i = 0; i < crossings->len; i++) {
    const Crossing *c = &g_array_index (crossings, Crossing, i);
    if (!c->yields)
      continue;
    qn_scene_marker (b->scene, QN_LAYER_SYMBOLS, QN_MARKER_DOT,
                     place (b, c->from, c->point), 4, 0, ink);
    any = true;
  }
  if (any)
    qn_scene_legend (b->scene, QN_COMMAND_MARKER, 4, ink, "%s", _ ("bar yields"));
}

void
qn_build_bars (QnSceneBuilder *b)
{
  g_autoptr (GArray) crossings = find_crossings (b);
  QnColorBar range = { .shown =
                         qn_field_is_stress (b->options->field) && b->pairs != NULL,
                       .diverging = true,
                       .factor = 1e-6 };
  QnColor ink = qn_builder_ink (b, QN_INK_BAR);
  if (crossings->len == 0) {
    add_straight (b);
    return;
  }
  /* Pale colours need a dark rim, the dark ink a pale one. */
  add_bars (b, crossings, WIDTH_RIM,
            range.shown ? ink : qn_builder_ink (b, QN_INK_GROUND));
  if (!range.shown)
    add_bars (b, crossings, WIDTH_BAR, ink);
  if (b->options->symbols)
    add_yield_marks (b, crossings);
  for (guint i = 0; i < crossings->len; i++) {
    double stress = stress_at (crossings, i);
    range.min = fmin (range.min, stress);
    range.max = fmax (range.max, stress);
  }
  for (guint i = 0; range.shown && i < crossings->len; i++) {
    double stress = stress_at (crossings, i);
    add_part (b, crossings, i, 1, WIDTH_BAR,
              qn_color_bar_color (&range, stress, b->options->monochrome));
  }
  if (!range.shown) {
    /* One bar, or many from the thinnest to the thickest. */
    double finest = INFINITY, widest = 0.0;
    for (size_t i = 0; i < b->model->bar_count; i++) {
      const double diameter = 1e3 * qn_bar_get_diameter (b->model->bars[i].area);
      finest = fmin (finest, diameter);
      widest = fmax (widest, diameter);
    }
    g_autofree char *thin = qn_label_number ("%.3g", finest);
    g_autofree char *thick = qn_label_number ("%.3g", widest);
    g_autofree char *label =
      g_str_equal (thin, thick)
        ? g_strdup_printf (_ ("reinforcing bar, Ø %s mm"), thin)
        : g_strdup_printf (_ ("reinforcing bars, Ø %s–%s mm"), thin, thick);
    qn_scene_legend (b->scene, QN_COMMAND_STROKE, WIDTH_BAR,
                     qn_builder_ink (b, QN_INK_BAR), "%s", label);
    return;
  }
  QnColor pulled = qn_color_bar_color (&range, range.max, b->options->monochrome);
  QnColor pressed = qn_color_bar_color (&range, range.min, b->options->monochrome);
  g_autofree char *most = qn_label_number ("%.3g", range.max * range.factor);
  g_autofree char *least = qn_label_number ("%.3g", -range.min * range.factor);
  if (range.max > 0)
    qn_scene_legend (b->scene, QN_COMMAND_STROKE, WIDTH_BAR, pulled,
                     _ ("bars: tension up to %s MPa"), most);
  if (range.min < 0)
    qn_scene_legend (b->scene, QN_COMMAND_STROKE, WIDTH_BAR, pressed,
                     _ ("bars: compression up to %s MPa"), least);
}
