#include "doc/masonry/masonry-shape.h"
#include "core/base/integer.h"
#include "doc/edit/edit.h"
#include "doc/masonry/masonry-field.h"

#include <math.h>
#include <string.h>

/* Least size that dragging leaves, m. */
#define LEAST_SIZE 1e-3

/* First guesses for what spans an opening, in parts of its width. */
#define ARCH_RISE    0.2
#define RING_COURSES 1.5
#define FLAT_SKEW    0.3 /* rad */

/* ---- frame ---- */

QnVec2
qn_masonry_to_model (const QnMasonry *masonry, QnVec2 local)
{
  return qn_vec2_add (masonry->origin, qn_vec2_rotate (local, cos (masonry->rotation),
                                                       sin (masonry->rotation)));
}

QnVec2
qn_masonry_to_local (const QnMasonry *masonry, QnVec2 point)
{
  return qn_vec2_rotate (qn_vec2_sub (point, masonry->origin), cos (masonry->rotation),
                         -sin (masonry->rotation));
}

double
qn_wall_listed_length (const QnWall *listed)
{
  double longest = 0.0;
  for (int32_t course = 0, entry = 0; course < listed->course_count; course++) {
    double length = 0.0;
    for (; entry < listed->course_ends[course]; entry++)
      length += fabs (listed->lengths[entry]);
    longest = MAX (longest, length);
  }
  return longest;
}

QnVec2
qn_masonry_wall_size (const QnMasonry *masonry)
{
  const QnMasonryWall *wall = &masonry->wall;
  if (masonry->kind != QN_MASONRY_WALL || wall->leaf_count == 0)
    return qn_vec2 (0.0, 0.0);
  const QnLeaf *leaf = &wall->leaves[0];
  if (leaf->bond == QN_BOND_CUSTOM)
    return qn_vec2 (leaf->unit.x * qn_wall_listed_length (&wall->courses),
                    leaf->unit.y * wall->courses.course_count);
  double length = 0.0;
  for (gsize i = 0; i < wall->leaf_count; i++)
    length += wall->leaves[i].length;
  return qn_vec2 (length, wall->height);
}

gboolean
qn_masonry_wall_contains (const QnMasonry *masonry, QnVec2 point)
{
  QnVec2 p = qn_masonry_to_local (masonry, point);
  QnVec2 size = qn_masonry_wall_size (masonry);
  return p.x >= 0.0 && p.x <= size.x && p.y >= 0.0 && p.y <= size.y && size.x > 0.0;
}

int
qn_masonry_opening_at (const QnMasonry *masonry, QnVec2 point)
{
  QnVec2 p = qn_masonry_to_local (masonry, point);
  for (gsize i = 0; masonry->kind == QN_MASONRY_WALL && i < masonry->wall.opening_count;
       i++) {
    const QnOpening *o = &masonry->wall.openings[i];
    if (p.x >= o->at.x && p.x <= o->at.x + o->width && p.y >= o->at.y
        && p.y <= o->at.y + o->height)
      return (int) i;
  }
  return QN_NO_OPENING;
}

void
qn_masonry_opening_corners (const QnMasonry *masonry, int opening, QnVec2 corners[4])
{
  const QnOpening *o = &masonry->wall.openings[opening];
  double x1 = o->at.x + o->width, y1 = o->at.y + o->height;
  corners[0] = qn_masonry_to_model (masonry, o->at);
  corners[1] = qn_masonry_to_model (masonry, qn_vec2 (x1, o->at.y));
  corners[2] = qn_masonry_to_model (masonry, qn_vec2 (x1, y1));
  corners[3] = qn_masonry_to_model (masonry, qn_vec2 (o->at.x, y1));
}

/* ---- snapping to the bond ---- */

/* Height of the course joint nearest to y. */
static double
snap_height (const QnMasonryWall *wall, double y)
{
  if (wall->course_height_count == 0)
    return round (y / wall->leaves[0].unit.y) * wall->leaves[0].unit.y;
  double best = 0.0, joint = 0.0;
  for (gsize i = 0; joint < wall->height + LEAST_SIZE; i++) {
    joint += wall->course_heights[i % wall->course_height_count];
    if (fabs (joint - y) < fabs (best - y))
      best = joint;
  }
  return best;
}

static QnVec2
snap_local (const QnMasonry *masonry, QnVec2 p)
{
  const QnMasonryWall *wall = &masonry->wall;
  if (masonry->kind != QN_MASONRY_WALL || wall->leaf_count == 0)
    return p;
  double half = 0.5 * wall->leaves[0].unit.x;
  QnVec2 size = qn_masonry_wall_size (masonry);
  /* The end of the wall need not be at a half block. */
  double x = round (p.x / half) * half;
  if (fabs (p.x - size.x) < fabs (p.x - x))
    x = size.x;
  return qn_vec2 (x, snap_height (wall, p.y));
}

/* ---- openings ---- */

/* Keeps an arched head possible for the opening's size. */
static void
fit_head (QnOpening *opening)
{
  if (opening->head == QN_HEAD_SEMICIRCULAR)
    opening->height = MAX (opening->height, 0.5 * opening->width);
  if (opening->head == QN_HEAD_SEGMENTAL) {
    double most = MIN (0.5 * opening->width, opening->height);
    opening->rise = CLAMP (opening->rise, 1e-3 * opening->width, most);
  }
}

gboolean
qn_masonry_set_opening_box (const QnMasonry *masonry, QnOpening *opening, QnVec2 a,
                            QnVec2 b, gboolean snap)
{
  QnVec2 p = qn_masonry_to_local (masonry, a), q = qn_masonry_to_local (masonry, b);
  if (snap) {
    p = snap_local (masonry, p);
    q = snap_local (masonry, q);
  }
  QnVec2 size = qn_masonry_wall_size (masonry);
  QnVec2 low = { CLAMP (MIN (p.x, q.x), 0.0, size.x),
                 CLAMP (MIN (p.y, q.y), 0.0, size.y) };
  QnVec2 high = { CLAMP (MAX (p.x, q.x), 0.0, size.x),
                  CLAMP (MAX (p.y, q.y), 0.0, size.y) };
  if (high.x - low.x < LEAST_SIZE || high.y - low.y < LEAST_SIZE)
    return FALSE;
  opening->at = low;
  opening->width = high.x - low.x;
  opening->height = high.y - low.y;
  fit_head (opening);
  return TRUE;
}

void
qn_opening_set_head (QnOpening *opening, QnHead head, QnSpan span, double course_height)
{
  opening->head = head;
  if (head == QN_HEAD_FLAT)
    opening->span = span == QN_SPAN_VOUSSOIRS ? QN_SPAN_FLAT_ARCH : span;
  else
    opening->span = span == QN_SPAN_NONE ? QN_SPAN_NONE : QN_SPAN_VOUSSOIRS;
  if (head == QN_HEAD_SEGMENTAL && opening->rise <= 0.0)
    opening->rise = ARCH_RISE * opening->width;
  if (opening->span != QN_SPAN_NONE && opening->depth <= 0.0)
    opening->depth = opening->span == QN_SPAN_LINTEL || opening->span == QN_SPAN_FLAT_ARCH
                       ? course_height
                       : RING_COURSES * course_height;
  if (opening->span == QN_SPAN_LINTEL && opening->bearing <= 0.0)
    opening->bearing = course_height;
  if (opening->span == QN_SPAN_FLAT_ARCH && opening->skew <= 0.0)
    opening->skew = FLAT_SKEW;
  if ((opening->span == QN_SPAN_FLAT_ARCH || opening->span == QN_SPAN_VOUSSOIRS)
      && opening->voussoirs < 2) {
    /* An odd number has a keystone. */
    int pairs = (int) qn_to_integer (ceil (0.25 * opening->width / course_height), 0,
                                     QN_MAX_BLOCKS);
    opening->voussoirs = 2 * CLAMP (pairs, 2, 15) + 1;
  }
  fit_head (opening);
}

static void
drag_opening (const QnMasonry *masonry, QnOpening *opening, QnHandleKind handle,
              QnVec2 from, QnVec2 to, gboolean snap)
{
  QnVec2 p = qn_masonry_to_local (masonry, to);
  QnVec2 start = qn_masonry_to_local (masonry, from);
  QnVec2 size = qn_masonry_wall_size (masonry);
  double x0 = opening->at.x, y0 = opening->at.y;
  double x1 = x0 + opening->width, y1 = y0 + opening->height;
  if (handle == QN_HANDLE_MIDDLE) {
    QnVec2 at = qn_vec2_add (opening->at, qn_vec2_sub (p, start));
    at = snap ? snap_local (masonry, at) : at;
    opening->at.x = CLAMP (at.x, 0.0, MAX (0.0, size.x - opening->width));
    opening->at.y = CLAMP (at.y, 0.0, MAX (0.0, size.y - opening->height));
    return;
  }
  if (handle == QN_HANDLE_RISE) {
    opening->rise = y1 - p.y;
    fit_head (opening);
    return;
  }
  p = snap ? snap_local (masonry, p) : p;
  if (handle == QN_HANDLE_LEFT || handle == QN_HANDLE_BOTTOM_LEFT
      || handle == QN_HANDLE_TOP_LEFT)
    x0 = CLAMP (p.x, 0.0, x1 - LEAST_SIZE);
  if (handle == QN_HANDLE_RIGHT || handle == QN_HANDLE_BOTTOM_RIGHT
      || handle == QN_HANDLE_TOP_RIGHT)
    x1 = CLAMP (p.x, x0 + LEAST_SIZE, size.x);
  if (handle == QN_HANDLE_BOTTOM || handle == QN_HANDLE_BOTTOM_LEFT
      || handle == QN_HANDLE_BOTTOM_RIGHT)
    y0 = CLAMP (p.y, 0.0, y1 - LEAST_SIZE);
  if (handle == QN_HANDLE_TOP || handle == QN_HANDLE_TOP_LEFT
      || handle == QN_HANDLE_TOP_RIGHT)
    y1 = CLAMP (p.y, y0 + LEAST_SIZE, size.y);
  opening->at = qn_vec2 (x0, y0);
  opening->width = x1 - x0;
  opening->height = y1 - y0;
  fit_head (opening);
}

/* ---- cells ---- */

QnMasonryCells
qn_masonry_get_cells (const QnMasonry *masonry)
{
  QnMasonryCells cells = { .rubble = masonry->rubble };
  if (masonry->kind == QN_MASONRY_WALL && masonry->wall.grid) {
    const QnVec2 size = qn_masonry_wall_size (masonry);
    const QnVec2 unit = masonry->wall.leaves[0].unit;
    cells.grid =
      qn_vec2 (fmax (round (size.x / unit.x), 1), fmax (round (size.y / unit.y), 1));
  }
  return cells;
}

void
qn_masonry_keep_cells (QnMasonry *masonry, const QnMasonryCells *cells)
{
  QnArch *arch = qn_masonry_get_arch (masonry);
  QnRubble *rubble = &masonry->rubble;
  if (arch != NULL)
    qn_arch_fit_shape (arch);
  if (masonry->kind == QN_MASONRY_WALL && masonry->wall.grid)
    qn_masonry_set_grid (&masonry->wall, qn_masonry_wall_size (masonry), cells->grid);
  if (rubble->relaxed) {
    rubble->stone *= sqrt (rubble->width * rubble->height
                           / (cells->rubble.width * cells->rubble.height));
    rubble->top = rubble->width;
  }
}

/* ---- walls, arches, columns ---- */

static void
drag_wall (QnMasonry *masonry, QnHandleKind handle, QnVec2 p, gboolean snap)
{
  QnMasonryWall *wall = &masonry->wall;
  QnLeaf *last = &wall->leaves[wall->leaf_count - 1];
  double half = 0.5 * last->unit.x;
  QnVec2 size = qn_masonry_wall_size (masonry);
  if (handle == QN_HANDLE_RIGHT) {
    double longer = p.x - size.x;
    longer = snap ? round (longer / half) * half : longer;
    last->length = MAX (last->length + longer, half);
  } else if (handle == QN_HANDLE_LEFT) {
    double by = snap ? round (p.x / half) * half : p.x;
    by = MIN (by, wall->leaves[0].length - half);
    wall->leaves[0].length -= by;
    masonry->origin = qn_masonry_to_model (masonry, qn_vec2 (by, 0.0));
    for (gsize i = 0; i < wall->opening_count; i++)
      wall->openings[i].at.x -= by;
  } else if (handle == QN_HANDLE_TOP) {
    double height = snap ? snap_height (wall, p.y) : p.y;
    wall->height = MAX (height, wall->leaves[0].unit.y);
  }
}

static void
drag_arch (QnMasonry *masonry, QnHandleKind handle, QnVec2 to, QnVec2 p)
{
  QnArch *arch = &masonry->arch;
  if (handle == QN_HANDLE_RISE)
    arch->rise = MAX (p.y, LEAST_SIZE);
  else if (handle == QN_HANDLE_RING)
    arch->ring = MAX (p.y - arch->rise, LEAST_SIZE);
  else {
    QnVec2 left = masonry->origin;
    QnVec2 right = qn_masonry_to_model (masonry, qn_vec2 (arch->span, 0.0));
    if (handle == QN_HANDLE_LEFT)
      left = to;
    else
      right = to;
    QnVec2 chord = qn_vec2_sub (right, left);
    double span = qn_vec2_length (chord);
    if (span < LEAST_SIZE)
      return;
    arch->rise *= span / arch->span;
    arch->span = span;
    masonry->origin = left;
    masonry->rotation = atan2 (chord.y, chord.x);
  }
}

void
qn_masonry_drag (QnMasonry *masonry, int opening, QnHandleKind handle, QnVec2 from,
                 QnVec2 to, gboolean snap)
{
  const QnMasonryCells cells = qn_masonry_get_cells (masonry);
  QnVec2 p = qn_masonry_to_local (masonry, to);
  if (opening != QN_NO_OPENING) {
    drag_opening (masonry, &masonry->wall.openings[opening], handle, from, to, snap);
    return;
  }
  if (masonry->kind == QN_MASONRY_WALL)
    drag_wall (masonry, handle, p, snap && !masonry->wall.grid);
  else if (masonry->kind == QN_MASONRY_RUBBLE && handle == QN_HANDLE_RIGHT)
    masonry->rubble.width = MAX (p.x, LEAST_SIZE);
  else if (masonry->kind == QN_MASONRY_RUBBLE && handle == QN_HANDLE_TOP)
    masonry->rubble.height = MAX (p.y, LEAST_SIZE);
  else if (masonry->kind == QN_MASONRY_ARCH)
    drag_arch (masonry, handle, to, p);
  else if (masonry->kind == QN_MASONRY_COLUMN) {
    double plinth = masonry->column.plinth_height;
    if (handle == QN_HANDLE_TOP)
      masonry->column.height = MAX (p.y - plinth, LEAST_SIZE);
    else if (handle == QN_HANDLE_TOP_RIGHT)
      masonry->column.top = MAX (2.0 * p.x, LEAST_SIZE);
    else if (handle == QN_HANDLE_BOTTOM_RIGHT)
      masonry->column.bottom = MAX (2.0 * p.x, LEAST_SIZE);
  }
  qn_masonry_keep_cells (masonry, &cells);
}

/* ---- handles ---- */

guint
qn_masonry_get_handles (const QnMasonry *masonry, int opening, QnHandle *handles)
{
  guint count = 0;
  if (opening != QN_NO_OPENING) {
    const QnOpening *o = &masonry->wall.openings[opening];
    double x0 = o->at.x, x1 = x0 + o->width, xm = 0.5 * (x0 + x1);
    double y0 = o->at.y, y1 = y0 + o->height, ym = 0.5 * (y0 + y1);
    const QnHandle local[] = {
      { QN_HANDLE_BOTTOM_LEFT, { x0, y0 } },  { QN_HANDLE_BOTTOM, { xm, y0 } },
      { QN_HANDLE_BOTTOM_RIGHT, { x1, y0 } }, { QN_HANDLE_RIGHT, { x1, ym } },
      { QN_HANDLE_TOP_RIGHT, { x1, y1 } },    { QN_HANDLE_TOP, { xm, y1 } },
      { QN_HANDLE_TOP_LEFT, { x0, y1 } },     { QN_HANDLE_LEFT, { x0, ym } },
      { QN_HANDLE_MIDDLE, { xm, ym } },       { QN_HANDLE_RISE, { x1, y1 - o->rise } },
    };
    memcpy (handles, local, sizeof local);
    count = G_N_ELEMENTS (local) - (o->head != QN_HEAD_SEGMENTAL);
  } else if (masonry->kind == QN_MASONRY_WALL) {
    /* The lengths of a listed wall are in its courses. */
    if (masonry->wall.leaves[0].bond == QN_BOND_CUSTOM)
      return 0;
    QnVec2 size = qn_masonry_wall_size (masonry);
    handles[count++] = (QnHandle){ QN_HANDLE_LEFT, { 0.0, 0.5 * size.y } };
    handles[count++] = (QnHandle){ QN_HANDLE_RIGHT, { size.x, 0.5 * size.y } };
    handles[count++] = (QnHandle){ QN_HANDLE_TOP, { 0.5 * size.x, size.y } };
  } else if (masonry->kind == QN_MASONRY_ARCH) {
    const QnArch *arch = &masonry->arch;
    handles[count++] = (QnHandle){ QN_HANDLE_LEFT, { 0.0, 0.0 } };
    handles[count++] = (QnHandle){ QN_HANDLE_RIGHT, { arch->span, 0.0 } };
    handles[count++] = (QnHandle){ QN_HANDLE_RISE, { 0.5 * arch->span, arch->rise } };
    handles[count++] =
      (QnHandle){ QN_HANDLE_RING, { 0.5 * arch->span, arch->rise + arch->ring } };
  } else if (masonry->kind == QN_MASONRY_COLUMN) {
    const QnColumn *c = &masonry->column;
    double y0 = c->plinth_height, y1 = y0 + c->height;
    handles[count++] = (QnHandle){ QN_HANDLE_TOP, { 0.0, y1 } };
    handles[count++] = (QnHandle){ QN_HANDLE_TOP_RIGHT, { 0.5 * c->top, y1 } };
    handles[count++] = (QnHandle){ QN_HANDLE_BOTTOM_RIGHT, { 0.5 * c->bottom, y0 } };
  } else if (masonry->kind == QN_MASONRY_RUBBLE && masonry->rubble.relaxed) {
    const double w = masonry->rubble.width, h = masonry->rubble.height;
    handles[count++] = (QnHandle){ QN_HANDLE_RIGHT, { w, 0.5 * h } };
    handles[count++] = (QnHandle){ QN_HANDLE_TOP, { 0.5 * w, h } };
  }
  for (guint i = 0; i < count; i++)
    handles[i].at = qn_masonry_to_model (masonry, handles[i].at);
  return count;
}

/* ---- bond ---- */

void
qn_masonry_set_bond (QnMasonry *masonry, QnBond bond, double lap)
{
  QnMasonryWall *wall = &masonry->wall;
  QnVec2 size = qn_masonry_wall_size (masonry);
  QnLeaf *leaf = &wall->leaves[0];
  if (leaf->bond == QN_BOND_CUSTOM && bond != QN_BOND_CUSTOM) {
    leaf->length = size.x;
    wall->height = size.y;
    qn_wall_remove_courses (&wall->courses);
  }
  for (gsize i = 0; i < wall->leaf_count; i++) {
    wall->leaves[i].bond = bond;
    wall->leaves[i].lap = lap;
    if (bond == QN_BOND_FLEMISH && wall->leaves[i].header >= wall->leaves[i].unit.x)
      wall->leaves[i].header = 0.0;
  }
}
