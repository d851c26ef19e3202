#include "io/drawing-import.h"
#include "core/box-tree.h"
#include "core/polygon.h"
#include "io/io-error.h"
#include "stereotomy/linework.h"
#include "stereotomy/polygon-ops.h"

#include <glib/gi18n-lib.h>
#include <string.h>

/* Tolerance where the user gives none, as part of a block's size. */
#define DEFAULT_TOLERANCE 0.002

/* Sizes of blocks, m, that a drawing may have in the unit it declares. */
#define SMALLEST_BLOCK 0.03
#define LARGEST_BLOCK  4.0

/* Faces of line work so many times larger than the median are perhaps openings. */
#define SUSPICIOUS_SIZE 4.0

/* One outline on its way to a block. */
typedef struct Outline {
  QnRing ring; /* m */
  QnRole role;
  const char *name;
  guint line;
} Outline;

typedef struct Import {
  const QnDrawing *drawing;
  const QnImportSettings *settings;
  const char *name;
  QnImportReport *report;
  double unit, tolerance;
  GArray *outlines; /* Outline */
  QnSegments soups[QN_ROLE_COUNT];
  gboolean
    no_memory; /* some of what was drawn is lost: refused at the next opportunity */
} Import;

static const struct {
  const char *word;
  QnRole role;
} role_words[] = {
  { "SUPPORT", QN_ROLE_SUPPORT }, { "BASE", QN_ROLE_SUPPORT },
  { "GROUND", QN_ROLE_SUPPORT },  { "FOUND", QN_ROLE_SUPPORT },
  { "FIXED", QN_ROLE_SUPPORT },   { "OPENING", QN_ROLE_OPENING },
  { "VOID", QN_ROLE_OPENING },    { "HOLE", QN_ROLE_OPENING },
  { "WINDOW", QN_ROLE_OPENING },  { "DOOR", QN_ROLE_OPENING },
  { "DIM", QN_ROLE_IGNORED },     { "TEXT", QN_ROLE_IGNORED },
  { "AXIS", QN_ROLE_IGNORED },    { "AXES", QN_ROLE_IGNORED },
  { "HATCH", QN_ROLE_IGNORED },   { "DEFPOINT", QN_ROLE_IGNORED },
  { "CONTACT", QN_ROLE_IGNORED }, { "DEFORMED", QN_ROLE_IGNORED },
  { "GRID", QN_ROLE_IGNORED },
};

double
qn_import_unit (const char *name)
{
  static const struct {
    const char *name;
    double metres;
  } units[] = { { "mm", 0.001 }, { "cm", 0.01 },   { "dm", 0.1 },
                { "m", 1 },      { "in", 0.0254 }, { "ft", 0.3048 } };
  for (gsize i = 0; i < G_N_ELEMENTS (units); i++)
    if (strcmp (units[i].name, name) == 0)
      return units[i].metres;
  return 0;
}

static void tell (Import *import, gboolean warn, const char *format, ...)
  G_GNUC_PRINTF (3, 4);

static void
tell (Import *import, gboolean warn, const char *format, ...)
{
  va_list arguments;
  va_start (arguments, format);
  char *line = g_strdup_vprintf (format, arguments);
  va_end (arguments);
  g_ptr_array_add (import->report->lines, line);
  if (warn)
    g_ptr_array_add (import->report->warnings, g_strdup (line));
}

static void
tell_healing (Import *import, const char *what, const QnHealing *healing)
{
  if (healing->count > 0)
    tell (import, FALSE, _ ("%s: %zu, by up to %.3g m, first near (%.6g, %.6g)"), what,
          healing->count, healing->farthest, healing->at.x, healing->at.y);
}

/* What the reader of the file had to tell. */
static void
tell_notes (Import *import)
{
  for (guint i = 0; i < import->drawing->notes->len; i++) {
    const QnDrawingNote *note = import->drawing->notes->pdata[i];
    if (note->line > 0)
      tell (import, FALSE, _ ("%s: %u, first at line %u"), note->text, note->count,
            note->line);
    else
      tell (import, FALSE, "%s: %u", note->text, note->count);
  }
}

static gboolean
find_role (const char *word, QnRole *role)
{
  static const char *const names[] = { "block", "support", "opening", "ignored" };
  for (int i = 0; i < QN_ROLE_COUNT; i++)
    if (strcmp (names[i], word) == 0) {
      *role = (QnRole) i;
      return TRUE;
    }
  return FALSE;
}

static gboolean
check_layers (const QnImportSettings *settings, GError **error)
{
  for (char **layer = settings->layers; layer != NULL && *layer != NULL; layer++) {
    const char *equals = strrchr (*layer, '=');
    QnRole role;
    if (equals == NULL || !find_role (equals + 1, &role)) {
      g_set_error (error, QN_IO_ERROR, QN_IO_ERROR_OVERRIDE,
                   _ ("%s: expected NAME=block, support, opening or ignored"), *layer);
      return FALSE;
    }
  }
  return TRUE;
}

static QnRole
role_of_layer (const QnImportSettings *settings, const char *layer)
{
  QnRole role = QN_ROLE_BLOCK;
  for (char **given = settings->layers; given != NULL && *given != NULL; given++) {
    const char *equals = strrchr (*given, '=');
    gsize length = (gsize) (equals - *given);
    if (strlen (layer) == length && g_ascii_strncasecmp (*given, layer, length) == 0
        && find_role (equals + 1, &role))
      return role;
  }
  g_autofree char *upper = g_ascii_strup (layer, -1);
  for (gsize i = 0; i < G_N_ELEMENTS (role_words); i++)
    if (strstr (upper, role_words[i].word) != NULL)
      return role_words[i].role;
  return QN_ROLE_BLOCK;
}

static int
compare_doubles (gconstpointer left, gconstpointer right)
{
  double a = *(const double *) left, b = *(const double *) right;
  return (a > b) - (a < b);
}

/* Median size of the drawing's closed outlines, or of its open paths' lengths where there are
 * none, in the drawing's unit; 0 for an empty drawing. */
static double
median_size (const QnDrawing *drawing)
{
  g_autoptr (GArray) sizes = g_array_new (FALSE, FALSE, sizeof (double));
  for (int pass = 0; pass < 2 && sizes->len == 0; pass++)
    for (guint i = 0; i < drawing->paths->len; i++) {
      const QnDrawingPath *path = &g_array_index (drawing->paths, QnDrawingPath, i);
      QnRing ring = { path->points, path->count };
      double size = pass == 1 ? qn_bounds_size (qn_ring_bounds (&ring))
                    : path->count >= 4 || path->closed
                      ? sqrt (fabs (qn_ring_area (&ring)))
                      : 0;
      if (size > 0)
        g_array_append_val (sizes, size);
    }
  g_array_sort (sizes, compare_doubles);
  return sizes->len > 0 ? g_array_index (sizes, double, sizes->len / 2) : 0;
}

static QnBounds
drawing_bounds (const QnDrawing *drawing)
{
  QnBounds bounds = { { INFINITY, INFINITY }, { -INFINITY, -INFINITY } };
  for (guint i = 0; i < drawing->paths->len; i++) {
    const QnDrawingPath *path = &g_array_index (drawing->paths, QnDrawingPath, i);
    QnRing ring = { path->points, path->count };
    QnBounds own = qn_ring_bounds (&ring);
    bounds.min = qn_vec2 (fmin (bounds.min.x, own.min.x), fmin (bounds.min.y, own.min.y));
    bounds.max = qn_vec2 (fmax (bounds.max.x, own.max.x), fmax (bounds.max.y, own.max.y));
  }
  return bounds;
}

static gboolean
is_plausible (double size)
{
  return size >= SMALLEST_BLOCK && size <= LARGEST_BLOCK;
}

/* The unit given, else the declared one if blocks have a plausible size in it, else a guess. */
static void
choose_unit (Import *import)
{
  static const double guesses[] = { 1, 0.001, 0.01 };
  static const char *const names[] = { "m", "mm", "cm" };
  const QnDrawing *drawing = import->drawing;
  double size = median_size (drawing), declared = drawing->unit;
  QnBounds bounds = drawing_bounds (drawing);
  double width = bounds.max.x - bounds.min.x, height = bounds.max.y - bounds.min.y;
  import->unit = import->settings->unit;
  if (import->unit > 0) {
    tell (import, FALSE, _ ("unit: %g m as given; extents %.6g x %.6g m"), import->unit,
          width * import->unit, height * import->unit);
    return;
  }
  if (declared > 0 && is_plausible (size * declared)) {
    import->unit = declared;
    tell (import, FALSE, _ ("unit: %g m as the file declares; extents %.6g x %.6g m"),
          declared, width * declared, height * declared);
    return;
  }
  gsize guess = 0;
  while (guess < G_N_ELEMENTS (guesses) && !is_plausible (size * guesses[guess]))
    guess++;
  if (guess == G_N_ELEMENTS (guesses))
    import->unit = declared > 0 ? declared : 1;
  else
    import->unit = guesses[guess];
  if (declared > 0 && guess < G_N_ELEMENTS (guesses))
    tell (import, TRUE,
          _ ("unit: the file declares %g m, which would make blocks of about %.3g m; "
             "read as %s "
             "instead, extents %.6g x %.6g m (--unit decides)"),
          declared, size * declared, names[guess], width * import->unit,
          height * import->unit);
  else if (guess < G_N_ELEMENTS (guesses))
    tell (import, TRUE,
          _ ("unit: not declared; read as %s from its extents, %.6g x %.6g m (--unit "
             "decides)"),
          names[guess], width * import->unit, height * import->unit);
  else
    tell (import, TRUE,
          _ ("unit: blocks of about %.3g m are not plausible in any unit; read as %g m "
             "(--unit decides)"),
          size * import->unit, import->unit);
}

/* Decimal fractions keep their digits when divided by a power of ten. */
static QnVec2
to_metres (const Import *import, QnVec2 p)
{
  double per_metre = round (1 / import->unit);
  if (per_metre > 1 && fabs (per_metre * import->unit - 1) < 1e-12)
    return qn_vec2 (p.x / per_metre, p.y / per_metre);
  return qn_vec2_scale (import->unit, p);
}

/* Whether the points behind `first` run along the beginning of the ring again. */
static gboolean
retraces (const QnRing *ring, gsize first, double tolerance)
{
  for (gsize i = first; i < ring->count; i++) {
    double nearest = INFINITY;
    for (gsize k = 0; k + 1 < first; k++)
      nearest = fmin (nearest, qn_segment_distance (ring->points[k], ring->points[k + 1],
                                                    ring->points[i]));
    if (nearest > tolerance)
      return FALSE;
  }
  return TRUE;
}

/* Cuts the ring where it comes back to its beginning. FALSE for an open path. */
static gboolean
close_ring (Import *import, QnRing *ring, gboolean closed, gsize *ends, gsize *overruns)
{
  for (gsize i = 3; i < ring->count; i++) {
    QnVec2 way = qn_vec2_sub (ring->points[i], ring->points[0]);
    if (qn_vec2_length (way) > import->tolerance
        || !retraces (ring, i + 1, import->tolerance))
      continue;
    if (i + 1 < ring->count)
      (*overruns)++;
    else if (!closed)
      (*ends)++;
    ring->count = i;
    return TRUE;
  }
  return closed && ring->count >= 3;
}

static void
add_outline (Import *import, const QnRing *ring, QnRole role, const char *name,
             guint line)
{
  Outline outline = { .role = role, .name = name, .line = line };
  if (!qn_ring_init (&outline.ring, ring->points, ring->count)) {
    import->no_memory = TRUE;
    return;
  }
  qn_ring_orient (&outline.ring);
  g_array_append_val (import->outlines, outline);
}

static void
add_segments (Import *import, const QnRing *path, gboolean closed, QnRole role)
{
  for (gsize i = 0; i + 1 < path->count + (closed ? 1 : 0); i++)
    if (!qn_segments_add (&import->soups[role], path->points[i],
                          path->points[(i + 1) % path->count]))
      import->no_memory = TRUE;
}

/* Sorts every path into outlines and line work. */
static void
sort_paths (Import *import)
{
  gsize ends = 0, overruns = 0, collinear = 0, open = 0, ignored = 0;
  for (guint i = 0; i < import->drawing->paths->len; i++) {
    const QnDrawingPath *path = &g_array_index (import->drawing->paths, QnDrawingPath, i);
    QnRole role =
      path->support ? QN_ROLE_SUPPORT : role_of_layer (import->settings, path->layer);
    if (role == QN_ROLE_IGNORED) {
      ignored++;
      continue;
    }
    QnRing ring;
    if (!qn_ring_init (&ring, path->points, path->count)) {
      import->no_memory = TRUE;
      return;
    }
    for (gsize k = 0; k < ring.count; k++)
      ring.points[k] = to_metres (import, ring.points[k]);
    if (close_ring (import, &ring, path->closed, &ends, &overruns)) {
      collinear += qn_ring_simplify (&ring, 1e-6 * import->tolerance);
      if (ring.count >= 3)
        add_outline (import, &ring, role, path->name, path->line);
    } else if (ring.count >= 2) {
      open++;
      add_segments (import, &ring, FALSE, role);
    }
    qn_ring_clear (&ring);
  }
  if (ignored > 0)
    tell (import, FALSE, _ ("on ignored layers: %zu"), ignored);
  if (ends > 0)
    tell (import, FALSE, _ ("outlines closed that end where they began: %zu"), ends);
  if (overruns > 0)
    tell (import, FALSE, _ ("outlines closed that overran their beginning: %zu"),
          overruns);
  if (collinear > 0)
    tell (import, FALSE, _ ("repeated and collinear vertices removed: %zu"), collinear);
  if (open > 0)
    tell (import, FALSE, _ ("open lines made into faces: %zu"), open);
}

/* Leaves out what cannot be a block. */
static void
drop_flawed (Import *import)
{
  gsize kept = 0, crossing = 0, flat = 0;
  guint first_crossing = 0;
  for (guint i = 0; i < import->outlines->len; i++) {
    Outline outline = g_array_index (import->outlines, Outline, i);
    QnPolygonFlaw flaw = qn_polygon_check (outline.ring.points, outline.ring.count);
    if (flaw.problem == QN_PROBLEM_NO_MEMORY)
      import->no_memory = TRUE;
    if (flaw.problem == QN_PROBLEM_NONE || flaw.problem == QN_PROBLEM_NO_MEMORY) {
      g_array_index (import->outlines, Outline, kept++) = outline;
      continue;
    }
    if (flaw.problem == QN_PROBLEM_SELF_CROSSING) {
      if (crossing++ == 0)
        first_crossing = outline.line;
    } else {
      flat++;
    }
    qn_ring_clear (&outline.ring);
  }
  g_array_set_size (import->outlines, (guint) kept);
  if (crossing > 0)
    tell (import, TRUE,
          _ ("outlines left out that cross themselves: %zu, first at line %u"), crossing,
          first_crossing);
  if (flat > 0)
    tell (import, FALSE, _ ("outlines without area left out: %zu"), flat);
}

/* Key of an outline to the tolerance: centroid and area. */
static char *
outline_key (const Import *import, const QnRing *ring)
{
  QnVec2 c = qn_ring_centroid (ring);
  double t = 2 * import->tolerance;
  return g_strdup_printf ("%.0f %.0f %.0f", c.x / t, c.y / t,
                          sqrt (fabs (qn_ring_area (ring))) / t);
}

static void
drop_repeated (Import *import)
{
  g_autoptr (GHashTable) seen =
    g_hash_table_new_full (g_str_hash, g_str_equal, g_free, NULL);
  gsize kept = 0, repeated = 0;
  for (guint i = 0; i < import->outlines->len; i++) {
    Outline outline = g_array_index (import->outlines, Outline, i);
    char *key = outline_key (import, &outline.ring);
    if (outline.role != QN_ROLE_OPENING && !g_hash_table_add (seen, key)) {
      repeated++;
      qn_ring_clear (&outline.ring);
    } else {
      if (outline.role == QN_ROLE_OPENING)
        g_free (key);
      g_array_index (import->outlines, Outline, kept++) = outline;
    }
  }
  g_array_set_size (import->outlines, (guint) kept);
  if (repeated > 0)
    tell (import, FALSE, _ ("outlines drawn twice: %zu"), repeated);
}

static gboolean
lies_in_outline (const Import *import, QnVec2 point, guint count)
{
  for (guint i = 0; i < count; i++) {
    const QnRing *ring = &g_array_index (import->outlines, Outline, i).ring;
    QnBounds b = qn_ring_bounds (ring);
    if (point.x >= b.min.x && point.x <= b.max.x && point.y >= b.min.y
        && point.y <= b.max.y && qn_polygon_depth (ring->points, ring->count, point) > 0)
      return TRUE;
  }
  return FALSE;
}

/* Warns of faces that are much larger than the others. */
static void
look_for_openings (Import *import, const QnRings *faces)
{
  g_autoptr (GArray) areas = g_array_new (FALSE, FALSE, sizeof (double));
  for (gsize i = 0; i < faces->count; i++) {
    double area = qn_ring_area (&faces->items[i]);
    g_array_append_val (areas, area);
  }
  g_array_sort (areas, compare_doubles);
  double median = areas->len > 0 ? g_array_index (areas, double, areas->len / 2) : 0;
  gsize count = 0;
  QnVec2 at = { 0, 0 };
  for (gsize i = 0; i < faces->count; i++)
    if (qn_ring_area (&faces->items[i]) > SUSPICIOUS_SIZE * median) {
      if (count++ == 0)
        at = qn_ring_centroid (&faces->items[i]);
    }
  if (count > 0)
    tell (import, TRUE,
          _ ("faces much larger than the others, perhaps openings or the ground: %zu, "
             "first at "
             "(%.6g, %.6g); outlines on a layer OPENINGS cut them out"),
          count, at.x, at.y);
}

/* Whether a face is bounded by open lines at all, and not only by outlines around it. */
static gboolean
touches_lines (const Import *import, const QnBoxTree *tree, const QnSegments *lines,
               const QnRing *face)
{
  for (gsize i = 0; i < face->count; i++) {
    QnVec2 a = face->points[i], b = face->points[(i + 1) % face->count];
    QnVec2 middle = qn_vec2_lerp (a, b, 0.5);
    QnBoxQuery query = qn_box_tree_query (
      tree, qn_box_grow ((QnBox){ middle, middle }, import->tolerance));
    for (QnId k; (k = qn_box_query_next (&query)) != QN_NONE;)
      if (qn_segment_distance (lines->items[k].a, lines->items[k].b, middle)
          <= import->tolerance)
        return TRUE;
  }
  return FALSE;
}

/* Turns the faces that lie in no outline and are bounded by open lines, of which there are
 * `lines`, into outlines. */
static void
take_faces (Import *import, QnRole role, const QnRings *faces, const QnSegments *lines,
            guint outlines)
{
  g_autofree QnBox *boxes = g_new (QnBox, lines->count);
  QnBoxTree tree;
  for (gsize i = 0; i < lines->count; i++)
    boxes[i] = qn_box_of_segment (lines->items[i].a, lines->items[i].b);
  if (!qn_box_tree_init (&tree, boxes, lines->count)) {
    import->no_memory = TRUE;
    return;
  }
  for (gsize i = 0; i < faces->count; i++) {
    const QnRing *face = &faces->items[i];
    QnVec2 inner = qn_polygon_inner_point (face->points, face->count);
    if (!lies_in_outline (import, inner, outlines)
        && touches_lines (import, &tree, lines, face))
      add_outline (import, face, role, NULL, 0);
  }
  qn_box_tree_clear (&tree);
}

static gboolean
has_openings (const Import *import)
{
  for (guint i = 0; i < import->outlines->len; i++)
    if (g_array_index (import->outlines, Outline, i).role == QN_ROLE_OPENING)
      return TRUE;
  return FALSE;
}

/* Line work of one role into outlines. Outlines that are there already bound faces too. */
static QnStatus
take_soup (Import *import, QnRole role, QnDiag *diag)
{
  QnSegments *soup = &import->soups[role];
  if (soup->count == 0)
    return QN_OK;
  guint outlines = import->outlines->len;
  QnSegments lines = { 0 };
  for (gsize i = 0; i < soup->count; i++)
    if (!qn_segments_add (&lines, soup->items[i].a, soup->items[i].b))
      import->no_memory = TRUE;
  for (guint i = 0; i < outlines; i++) {
    const Outline *outline = &g_array_index (import->outlines, Outline, i);
    if (outline->role == role)
      add_segments (import, &outline->ring, TRUE, role);
  }
  QnRings faces = { 0 };
  QnHealing healing = { 0 };
  gsize holes = 0;
  QnStatus status =
    import->no_memory
      ? qn_diag_no_memory (diag)
      : qn_linework_polygonize (soup, import->tolerance, &faces, &holes, &healing, diag);
  tell_healing (import, _ ("ends of lines joined"), &healing);
  if (holes > 0)
    tell (import, TRUE, _ ("faces around other faces left out: %zu"), holes);
  if (status == QN_OK)
    take_faces (import, role, &faces, &lines, outlines);
  if (role == QN_ROLE_BLOCK && outlines == 0 && !has_openings (import))
    look_for_openings (import, &faces);
  qn_rings_clear (&faces);
  qn_segments_clear (&lines);
  return status;
}

/* Moves the rings of blocks and supports out of the outlines, or those that were moved back. */
static void
exchange_rings (Import *import, QnRings *rings, gboolean out)
{
  gsize next = 0;
  for (guint i = 0; i < import->outlines->len; i++) {
    Outline *outline = &g_array_index (import->outlines, Outline, i);
    if (outline->role == QN_ROLE_OPENING)
      continue;
    if (out) {
      if (!qn_rings_take (rings, &outline->ring)) {
        import->no_memory = TRUE;
        return;
      }
    } else if (next < rings->count) {
      outline->ring = rings->items[next];
      rings->items[next++] = (QnRing){ 0 };
    }
  }
}

static void
drop_collapsed (Import *import)
{
  gsize kept = 0;
  for (guint i = 0; i < import->outlines->len; i++) {
    Outline outline = g_array_index (import->outlines, Outline, i);
    if (outline.ring.count >= 3)
      g_array_index (import->outlines, Outline, kept++) = outline;
    else
      qn_ring_clear (&outline.ring);
  }
  if (kept < import->outlines->len)
    tell (import, FALSE, _ ("slivers left out: %zu"), import->outlines->len - kept);
  g_array_set_size (import->outlines, (guint) kept);
}

static QnStatus
heal (Import *import, QnDiag *diag)
{
  QnRings rings = { 0 };
  QnHealing welded = { 0 }, snapped = { 0 };
  exchange_rings (import, &rings, TRUE);
  QnStatus status = import->no_memory
                      ? qn_diag_no_memory (diag)
                      : qn_weld_vertices (&rings, 1e-6 * import->tolerance,
                                          import->tolerance, NULL, &welded, diag);
  if (status == QN_OK)
    status = qn_snap_neighbours (&rings, import->tolerance, &snapped, diag);
  exchange_rings (import, &rings, FALSE);
  qn_rings_clear (&rings);
  tell_healing (import, _ ("vertices welded"), &welded);
  tell_healing (import, _ ("gaps and overlaps between neighbours closed"), &snapped);
  drop_collapsed (import);
  return status;
}

/* Cuts all openings out of the blocks. */
static QnStatus
cut_openings (Import *import, QnDiag *diag)
{
  QnRings cutters = { 0 };
  gsize changed = 0;
  for (guint i = 0; i < import->outlines->len; i++) {
    const Outline *outline = &g_array_index (import->outlines, Outline, i);
    if (outline->role == QN_ROLE_OPENING
        && !qn_rings_add (&cutters, outline->ring.points, outline->ring.count))
      import->no_memory = TRUE;
  }
  QnStatus status = import->no_memory ? qn_diag_no_memory (diag) : QN_OK;
  guint count = import->outlines->len;
  for (guint i = 0; cutters.count > 0 && i < count && status == QN_OK; i++) {
    Outline outline = g_array_index (import->outlines, Outline, i);
    if (outline.role == QN_ROLE_OPENING)
      continue;
    QnRings parts = { 0 };
    double area = qn_ring_area (&outline.ring), left = 0;
    status = qn_polygon_difference (&outline.ring, &cutters, &parts, diag);
    for (gsize k = 0; k < parts.count; k++)
      left += qn_ring_area (&parts.items[k]);
    /* What is left along the edge of an opening within the tolerance is no block. */
    if (status == QN_OK && left < area * (1 - 1e-9)) {
      changed++;
      for (gsize k = 0; k < parts.count; k++)
        if (2 * qn_ring_area (&parts.items[k])
            > import->tolerance * qn_ring_perimeter (&parts.items[k]))
          add_outline (import, &parts.items[k], outline.role, outline.name, outline.line);
      g_array_index (import->outlines, Outline, i).ring.count = 0;
    }
    qn_rings_clear (&parts);
  }
  if (cutters.count > 0)
    tell (import, FALSE, _ ("openings cut out: %zu, blocks cut or removed: %zu"),
          cutters.count, changed);
  qn_rings_clear (&cutters);
  gsize kept = 0;
  for (guint i = 0; i < import->outlines->len; i++) {
    Outline outline = g_array_index (import->outlines, Outline, i);
    if (outline.role != QN_ROLE_OPENING && outline.ring.count >= 3)
      g_array_index (import->outlines, Outline, kept++) = outline;
    else
      qn_ring_clear (&outline.ring);
  }
  g_array_set_size (import->outlines, (guint) kept);
  return status;
}

/* Fixes the lowest row where no layer says what is fixed. */
static void
infer_supports (Import *import)
{
  double lowest = INFINITY;
  gsize supports = 0;
  for (guint i = 0; i < import->outlines->len; i++) {
    const Outline *outline = &g_array_index (import->outlines, Outline, i);
    supports += outline->role == QN_ROLE_SUPPORT;
    lowest = fmin (lowest, qn_ring_bounds (&outline->ring).min.y);
  }
  import->report->supported = import->outlines->len > 0;
  if (supports > 0) {
    tell (import, FALSE, _ ("fixed by their layer: %zu"), supports);
    return;
  }
  double margin = fmax (import->tolerance, 1e-9 * fabs (lowest));
  for (guint i = 0; i < import->outlines->len; i++) {
    Outline *outline = &g_array_index (import->outlines, Outline, i);
    if (qn_ring_bounds (&outline->ring).min.y <= lowest + margin) {
      outline->role = QN_ROLE_SUPPORT;
      supports++;
    }
  }
  tell (import, TRUE, _ ("no layer of supports: the lowest row is fixed, %zu blocks"),
        supports);
}

static gboolean
fill_project (Import *import, QnProject *project)
{
  QnModel *model = &project->model;
  const QnImportSettings *settings = import->settings;
  QnLaw *law = qn_model_add_law (model, "dry joint");
  QnLoad *dead = qn_model_add_dead_load (model), *live = qn_model_add_live_load (model);
  if (law == NULL || dead == NULL || live == NULL)
    return FALSE;
  law->kind = QN_LAW_COULOMB;
  law->kn = law->ks = 1e9;
  law->friction = settings->friction;
  model->contact.law = 0;
  dead->vector = qn_vec2 (0, -1);
  live->vector = qn_vec2 (1, 0);
  dead->block = live->block = QN_NONE;
  for (guint i = 0; i < import->outlines->len; i++) {
    const Outline *outline = &g_array_index (import->outlines, Outline, i);
    g_autofree char *name =
      outline->name != NULL && qn_model_find_block (model, outline->name) == QN_NONE
        ? g_strdup (outline->name)
        : g_strdup_printf ("b%u", i + 1);
    QnBlock *block =
      qn_model_add_block (model, name, outline->ring.points, outline->ring.count);
    if (block == NULL)
      return FALSE;
    block->thickness = settings->thickness;
    block->unit_weight = settings->unit_weight;
    for (int dof = 0; dof < QN_DOF_COUNT; dof++)
      block->support[dof] = outline->role == QN_ROLE_SUPPORT;
  }
  return TRUE;
}

static gboolean
run_import (Import *import, QnProject *project, GError **error)
{
  QnDiag diag = { 0 };
  tell_notes (import);
  choose_unit (import);
  import->tolerance =
    import->settings->tolerance > 0
      ? import->settings->tolerance
      : DEFAULT_TOLERANCE * median_size (import->drawing) * import->unit;
  sort_paths (import);
  drop_flawed (import);
  drop_repeated (import);
  QnStatus status = import->no_memory ? qn_diag_no_memory (&diag) : QN_OK;
  for (int role = 0; role < QN_ROLE_IGNORED && status == QN_OK; role++)
    status = take_soup (import, (QnRole) role, &diag);
  if (status == QN_OK)
    status = heal (import, &diag);
  drop_flawed (import);
  if (status == QN_OK)
    status = cut_openings (import, &diag);
  if (import->no_memory)
    status = qn_diag_no_memory (&diag);
  if (status == QN_OK && import->outlines->len == 0) {
    g_set_error (error, QN_IO_ERROR, QN_IO_ERROR_INVALID,
                 _ ("%s:1: no closed outline to make a block of"), import->name);
    return FALSE;
  }
  infer_supports (import);
  tell (import, FALSE, _ ("blocks: %u"), import->outlines->len);
  qn_project_init (project);
  project->name = g_strdup (import->name);
  if (status == QN_OK && !fill_project (import, project))
    status = qn_diag_no_memory (&diag);
  if (status == QN_OK)
    status = qn_model_prepare (&project->model, &diag);
  if (status == QN_OK)
    return TRUE;
  qn_project_set_error (project, &diag, error);
  qn_project_clear (project);
  return FALSE;
}

gboolean
qn_drawing_to_project (const QnDrawing *drawing, const char *name,
                       const QnImportSettings *settings, QnProject *project,
                       QnImportReport *report, GError **error)
{
  *project = (QnProject){ 0 };
  *report = (QnImportReport){ g_ptr_array_new_with_free_func (g_free),
                              g_ptr_array_new_with_free_func (g_free), FALSE };
  Import import = { .drawing = drawing,
                    .settings = settings,
                    .name = name,
                    .report = report,
                    .outlines = g_array_new (FALSE, FALSE, sizeof (Outline)) };
  gboolean done = check_layers (settings, error) && run_import (&import, project, error);
  for (guint i = 0; i < import.outlines->len; i++)
    qn_ring_clear (&g_array_index (import.outlines, Outline, i).ring);
  g_array_unref (import.outlines);
  for (int role = 0; role < QN_ROLE_COUNT; role++)
    qn_segments_clear (&import.soups[role]);
  if (!done)
    qn_import_report_clear (report);
  return done;
}

void
qn_import_report_clear (QnImportReport *report)
{
  g_clear_pointer (&report->lines, g_ptr_array_unref);
  g_clear_pointer (&report->warnings, g_ptr_array_unref);
}
