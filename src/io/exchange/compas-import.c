#include "core/base/polygon.h"
#include "core/base/union-find.h"
#include "io/exchange/drawing.h"
#include "io/exchange/svg-path.h"
#include "io/json/json-value.h"
#include "io/text/file-read.h"
#include "io/text/io-error.h"
#include "stereotomy/ring.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

/* What coincides in projection does so within this part of the block's extent: files of single precision
 * are off by 2e-6. */
#define PLANAR_TOLERANCE 1e-5

/* More blocks are not compared with each other; a block with more vertices is no prism. */
#define MOST_COMPARED 20000
#define MOST_VERTICES 2000

/* Directions along which the prisms may run, tried in this order, and the two axes that are seen. */
static const struct {
  int depth, right, up;
  const char *text;
} views[] = { { 1, 0, 2, N_ ("seen from the front, along y; blocks") },
              { 2, 0, 1, N_ ("seen from above, along z; blocks") },
              { 0, 1, 2, N_ ("seen from the side, along x; blocks") } };

typedef struct MeshPoint {
  double at[3];
} MeshPoint;

/* A block as a mesh; a face is its number of corners and their indices. */
typedef struct Mesh {
  char *name;
  GArray *points, *faces; /* MeshPoint; guint */
  gboolean support;
  double density;  /* kg/m3, or 0 */
  guint last_face; /* where it begins */
} Mesh;

static void
free_mesh (gpointer data)
{
  Mesh *mesh = data;
  g_free (mesh->name);
  g_array_unref (mesh->points);
  g_array_unref (mesh->faces);
  g_free (mesh);
}

static Mesh *
add_mesh (GPtrArray *meshes, const char *name, gboolean support, double density)
{
  Mesh *mesh = g_new (Mesh, 1);
  *mesh = (Mesh){ g_strdup (name),
                  g_array_new (FALSE, FALSE, sizeof (MeshPoint)),
                  g_array_new (FALSE, FALSE, sizeof (guint)),
                  support,
                  density,
                  0 };
  g_ptr_array_add (meshes, mesh);
  return mesh;
}

/* Begins a face with the first corner at this index of the points, or adds the next one to the last face. */
static void
add_corner (Mesh *mesh, gboolean first, guint index)
{
  if (first) {
    mesh->last_face = mesh->faces->len;
    g_array_append_val (mesh->faces, (guint){ 0 });
  }
  g_array_append_val (mesh->faces, index);
  g_array_index (mesh->faces, guint, mesh->last_face)++;
}

/* The same with a point of a larger list, which the mesh gets a copy of; `indices`: where it has it, from 1. */
static void
copy_corner (Mesh *mesh, gboolean first, const GArray *points, guint index,
             GHashTable *indices)
{
  gpointer key = GUINT_TO_POINTER (index);
  guint own = GPOINTER_TO_UINT (g_hash_table_lookup (indices, key));
  if (own == 0) {
    g_array_append_val (mesh->points, g_array_index (points, MeshPoint, index));
    own = mesh->points->len;
    g_hash_table_insert (indices, key, GUINT_TO_POINTER (own));
  }
  add_corner (mesh, first, own - 1);
}

/* ---- prisms ---- */

static QnVec2
seen (const Mesh *mesh, guint index, int view)
{
  const double *p = g_array_index (mesh->points, MeshPoint, index).at;
  return qn_vec2 (p[views[view].right], p[views[view].up]);
}

/* Extent of the block along its largest axis; its least and greatest depth in a view. */
static double
extent_of (const Mesh *mesh, int view, double ends[2])
{
  double extent = 0;
  for (int axis = 0; axis < 3; axis++) {
    double low = INFINITY, high = -INFINITY;
    for (guint i = 0; i < mesh->points->len; i++) {
      low = fmin (low, g_array_index (mesh->points, MeshPoint, i).at[axis]);
      high = fmax (high, g_array_index (mesh->points, MeshPoint, i).at[axis]);
    }
    extent = fmax (extent, high - low);
    if (axis == views[view].depth) {
      ends[0] = low;
      ends[1] = high;
    }
  }
  return extent;
}

/* The first point at the place of this one, whatever its depth. */
static guint
place_of (const Mesh *mesh, guint index, int view, double tolerance)
{
  QnVec2 p = seen (mesh, index, view);
  guint i = 0;
  while (i < index
         && !(qn_vec2_length (qn_vec2_sub (seen (mesh, i, view), p)) <= tolerance))
    i++;
  return i;
}

typedef struct Edge {
  guint from, to;
} Edge;

/* Adds an edge, or takes out the one that runs the other way: that is inside of the front. */
static void
add_edge (GArray *edges, guint from, guint to)
{
  if (from == to)
    return;
  for (guint i = 0; i < edges->len; i++) {
    const Edge *edge = &g_array_index (edges, Edge, i);
    if ((edge->from == to && edge->to == from)
        || (edge->from == from && edge->to == to)) {
      g_array_remove_index_fast (edges, i);
      return;
    }
  }
  g_array_append_val (edges, ((Edge){ from, to }));
}

/* Takes the edges apart into rings: the largest, and how many; 0 where they are none. */
static guint
chain (const Mesh *mesh, int view, GArray *edges, GArray *outline)
{
  guint count = 0;
  double largest = 0;
  g_array_set_size (outline, 0);
  for (; edges->len > 0; count++) {
    g_autoptr (GArray) ring = g_array_new (FALSE, FALSE, sizeof (QnVec2));
    guint start = g_array_index (edges, Edge, 0).from, at = start;
    do {
      guint i = 0;
      while (i < edges->len && g_array_index (edges, Edge, i).from != at
             && g_array_index (edges, Edge, i).to != at)
        i++;
      if (i == edges->len)
        return 0;
      Edge edge = g_array_index (edges, Edge, i);
      QnVec2 p = seen (mesh, at, view);
      g_array_append_val (ring, p);
      at = edge.from == at ? edge.to : edge.from;
      g_array_remove_index_fast (edges, i);
    } while (at != start);
    double area =
      fabs (qn_ring_area (&(QnRing){ (QnVec2 *) (void *) ring->data, ring->len }));
    if (area > largest) {
      largest = area;
      g_array_set_size (outline, 0);
      g_array_append_vals (outline, ring->data, ring->len);
    }
  }
  return outline->len >= 3 ? count : 0;
}

/* The outline of all faces at one depth together, and how many rings they have. */
static guint
outline_at (const Mesh *mesh, int view, double at, double tolerance, GArray *outline)
{
  g_autoptr (GArray) edges = g_array_new (FALSE, FALSE, sizeof (Edge));
  const guint *faces = (const guint *) (const void *) mesh->faces->data;
  for (guint f = 0; f < mesh->faces->len; f += faces[f] + 1) {
    gboolean across = TRUE;
    for (guint i = 1; i <= faces[f]; i++) {
      double depth =
        g_array_index (mesh->points, MeshPoint, faces[f + i]).at[views[view].depth];
      across = across && fabs (depth - at) <= tolerance;
    }
    for (guint i = 1; across && i <= faces[f]; i++)
      add_edge (edges, place_of (mesh, faces[f + i], view, tolerance),
                place_of (mesh, faces[f + (i < faces[f] ? i + 1 : 1)], view, tolerance));
  }
  return chain (mesh, view, edges, outline);
}

static gboolean
is_on (const GArray *outline, QnVec2 p, double tolerance)
{
  const QnVec2 *ring = (const QnVec2 *) (const void *) outline->data;
  double nearest = INFINITY;
  for (guint i = 0; i < outline->len; i++)
    nearest =
      fmin (nearest, qn_segment_distance (ring[i], ring[(i + 1) % outline->len], p));
  return nearest <= tolerance;
}

/* The outline of a prism in a view, how many holes it has, and its least and greatest depth. FALSE where the
 * block is none: its front and its back have not one outline, or some vertex between them is not seen on
 * it. */
static gboolean
outline_of (const Mesh *mesh, int view, GArray *outline, guint *holes, double ends[2])
{
  double tolerance = PLANAR_TOLERANCE * extent_of (mesh, view, ends);
  g_autoptr (GArray) back = g_array_new (FALSE, FALSE, sizeof (QnVec2));
  if (mesh->points->len > MOST_VERTICES)
    return FALSE;
  guint rings = outline_at (mesh, view, ends[0], tolerance, outline);
  if (rings == 0 || outline_at (mesh, view, ends[1], tolerance, back) != rings)
    return FALSE;
  for (guint i = 0; i < outline->len; i++)
    if (!is_on (back, g_array_index (outline, QnVec2, i), tolerance))
      return FALSE;
  for (guint i = 0; i < back->len; i++)
    if (!is_on (outline, g_array_index (back, QnVec2, i), tolerance))
      return FALSE;
  *holes = rings - 1;
  for (guint v = 0; v < mesh->points->len; v++) {
    double depth = g_array_index (mesh->points, MeshPoint, v).at[views[view].depth];
    gboolean between = depth - ends[0] > tolerance && ends[1] - depth > tolerance;
    if (between && *holes == 0 && !is_on (outline, seen (mesh, v, view), tolerance))
      return FALSE;
  }
  return TRUE;
}

/* The first block, or NULL, whose middle is seen within another one: they lie behind each other. */
static const QnDrawingPath *
find_covered (const QnDrawing *drawing)
{
  guint count = drawing->paths->len;
  const QnDrawingPath *paths = &g_array_index (drawing->paths, QnDrawingPath, 0);
  g_autofree QnBox *boxes = g_new (QnBox, count);
  for (guint i = 0; i < count; i++)
    boxes[i] = qn_ring_bounds (&(QnRing){ paths[i].points, paths[i].count });
  for (guint i = 0; i < count && count <= MOST_COMPARED; i++) {
    QnVec2 p = qn_polygon_inner_point (paths[i].points, paths[i].count);
    for (guint k = 0; k < count; k++)
      if (k != i && p.x > boxes[k].min.x && p.x < boxes[k].max.x && p.y > boxes[k].min.y
          && p.y < boxes[k].max.y
          && qn_polygon_depth (paths[k].points, paths[k].count, p) > 0)
        return &paths[i];
  }
  return NULL;
}

/* Notes so many things, if any. */
static void
tell (QnDrawing *drawing, const char *text, guint count, gboolean minor)
{
  if (count == 0)
    return;
  QnDrawingNote *note = qn_drawing_note (drawing, text, 0);
  note->count += count - 1;
  note->minor = minor;
}

/* Adds all blocks as seen in a view. Returns why that cannot be: the name of a block, and whether it is
 * no prism or lies behind others. */
static char *
add_view (const GPtrArray *meshes, int view, QnDrawing *drawing)
{
  g_autoptr (GArray) outline = g_array_new (FALSE, FALSE, sizeof (QnVec2));
  guint dense = 0, hollow = 0;
  for (guint i = 0; i < meshes->len; i++) {
    const Mesh *mesh = meshes->pdata[i];
    guint holes = 0;
    double ends[2] = { 0 };
    if (!outline_of (mesh, view, outline, &holes, ends))
      return g_strdup_printf (_ ("block %s is not a prism along %c"), mesh->name,
                              'x' + views[view].depth);
    QnRing ring = { (QnVec2 *) (void *) outline->data, outline->len };
    qn_ring_orient (&ring);
    QnDrawingPath *path = qn_drawing_add_path (drawing, "BLOCKS", 0);
    path->closed = TRUE;
    path->support = mesh->support;
    path->density = mesh->density;
    path->thickness = ends[1] - ends[0];
    dense += mesh->density > 0;
    hollow += holes > 0;
    for (guint k = 0; k < outline->len; k++)
      qn_drawing_path_add (path, g_array_index (outline, QnVec2, k));
  }
  const QnDrawingPath *covered = find_covered (drawing);
  if (covered == NULL) {
    tell (drawing, _ ("blocks with holes, which are taken as solid"), hollow, FALSE);
    tell (drawing, _ ("blocks as thick as in the file"), meshes->len, TRUE);
    tell (drawing, _ ("blocks with a density of the file"), dense, TRUE);
    return NULL;
  }
  const Mesh *mesh =
    meshes->pdata[covered - (QnDrawingPath *) (void *) drawing->paths->data];
  return g_strdup_printf (
    hollow > 0 ? _ ("block %s lies behind another one along %c, or in its hole: "
                    "blocks cannot be hollow")
               : _ ("block %s lies behind another one along %c"),
    mesh->name, 'x' + views[view].depth);
}

static gboolean
is_plate (const Mesh *mesh)
{
  const guint *faces = (const guint *) (const void *) mesh->faces->data;
  gboolean plate = mesh->faces->len == 0 || mesh->faces->len == faces[0] + 1;
  for (int view = 0; view < (int) G_N_ELEMENTS (views); view++) {
    double ends[2] = { 0 }, extent = extent_of (mesh, view, ends);
    plate = plate || ends[1] - ends[0] <= PLANAR_TOLERANCE * extent;
  }
  return plate;
}

/* Replaces an object by its bodies, which share no vertex: each is a block. Where one of them is flat the
 * object stays whole: its faces do not share their vertices, or it has no sides. */
static void
split_bodies (GPtrArray *meshes, guint number)
{
  Mesh *mesh = meshes->pdata[number];
  const guint *faces = (const guint *) (const void *) mesh->faces->data;
  guint length = mesh->faces->len, count = mesh->points->len;
  g_autofree QnId *sets = g_new (QnId, count + 1);
  g_autofree Mesh **own = g_new0 (Mesh *, count + 1);
  g_autoptr (GPtrArray) bodies = g_ptr_array_new_with_free_func (free_mesh);
  g_autoptr (GHashTable) indices = g_hash_table_new (NULL, NULL);
  qn_sets_init (sets, count);
  for (guint f = 0; f < length; f += faces[f] + 1)
    for (guint i = 2; i <= faces[f]; i++)
      qn_sets_join (sets, (QnId) faces[f + 1], (QnId) faces[f + i]);
  for (guint f = 0; f < length; f += faces[f] + 1) {
    Mesh **body = &own[qn_sets_root (sets, (QnId) faces[f + 1])];
    g_autofree char *name = g_strdup_printf ("%s.%u", mesh->name, bodies->len + 1);
    if (*body == NULL)
      *body = add_mesh (bodies, name, mesh->support, mesh->density);
    for (guint k = 1; k <= faces[f]; k++)
      copy_corner (*body, k == 1, mesh->points, faces[f + k], indices);
  }
  for (guint i = 0; i < bodies->len; i++)
    if (bodies->len < 2 || is_plate (bodies->pdata[i]))
      return;
  g_ptr_array_extend_and_steal (meshes, g_steal_pointer (&bodies));
  g_array_set_size (mesh->points, 0);
}

/* Tries the views; what spoils the first one is told where another one is taken. */
static gboolean
view_meshes (const GPtrArray *meshes, const char *name, QnDrawing *drawing,
             GError **error)
{
  g_autofree char *first = NULL;
  for (int view = 0; view < (int) G_N_ELEMENTS (views); view++) {
    g_autofree char *problem = add_view (meshes, view, drawing);
    if (problem == NULL) {
      tell (drawing, _ (views[view].text), meshes->len, view == 0);
      tell (drawing, first, first != NULL, FALSE);
      return TRUE;
    }
    if (first == NULL)
      first = g_steal_pointer (&problem);
    for (guint i = 0; i < drawing->paths->len; i++)
      g_free (g_array_index (drawing->paths, QnDrawingPath, i).points);
    g_array_set_size (drawing->paths, 0);
  }
  return qn_io_fail (error, QN_IO_ERROR_INVALID,
                     _ ("%s:1: the blocks are not prisms of one direction: %s"), name,
                     first);
}

/* ---- files ---- */

typedef struct Reading {
  GPtrArray *meshes;
  QnDrawing *drawing;
  const char *name; /* of the file */
  GError **error;
} Reading;

/* Of a vertex, or of a corner of a face. */
static gboolean
fail_mesh (const Reading *reading, guint line, const char *block, gboolean vertex)
{
  return qn_io_fail (
    reading->error, QN_IO_ERROR_INVALID, "%s:%u: %s: %s", reading->name, line, block,
    vertex ? _ ("expected three coordinates of a vertex")
           : _ ("expected a face of three or more corners, each one of the "
                "vertices"));
}

static const cJSON *
member (const cJSON *object, const char *key)
{
  return cJSON_IsObject (object) ? cJSON_GetObjectItemCaseSensitive (object, key) : NULL;
}

/* Moves a point by the rows of a matrix of 4 x 4; NULL, or what is none, leaves it. */
static void
transform (MeshPoint *p, const cJSON *matrix)
{
  MeshPoint moved = *p;
  for (int i = 0; i < 3; i++) {
    const cJSON *row = cJSON_GetArrayItem (matrix, i);
    if (cJSON_GetArraySize (row) != 4)
      return;
    moved.at[i] = cJSON_GetArrayItem (row, 3)->valuedouble;
    for (int k = 0; k < 3; k++)
      moved.at[i] += cJSON_GetArrayItem (row, k)->valuedouble * p->at[k];
  }
  *p = moved;
}

/* The mesh of a block: vertices and faces by keys. */
static gboolean
take_mesh (const Reading *reading, const cJSON *vertices, const cJSON *faces,
           const char *name, gboolean support, double density, const cJSON *matrix)
{
  Mesh *mesh = add_mesh (reading->meshes, name, support, density);
  g_autoptr (GHashTable) indices =
    g_hash_table_new_full (g_str_hash, g_str_equal, g_free, NULL);
  guint next = 0;
  for (const cJSON *v = vertices->child; v != NULL; v = v->next, next++) {
    /* A point by an object with x, y and z, or an array of three numbers. */
    static const char *const axes[] = { "x", "y", "z" };
    MeshPoint p;
    for (int axis = 0; axis < 3; axis++) {
      const cJSON *value =
        cJSON_IsArray (v) ? cJSON_GetArrayItem (v, axis) : member (v, axes[axis]);
      p.at[axis] = cJSON_IsNumber (value) ? value->valuedouble : NAN;
    }
    transform (&p, matrix);
    if (!isfinite (p.at[0]) || !isfinite (p.at[1]) || !isfinite (p.at[2]))
      return fail_mesh (reading, 1, name, TRUE);
    g_array_append_val (mesh->points, p);
    g_hash_table_insert (
      indices, v->string != NULL ? g_strdup (v->string) : g_strdup_printf ("%u", next),
      GUINT_TO_POINTER (next + 1));
  }
  for (const cJSON *face = faces->child; face != NULL; face = face->next)
    for (const cJSON *entry = face->child; entry != NULL; entry = entry->next) {
      char key[32];
      g_snprintf (key, sizeof key, "%.0f", entry->valuedouble);
      guint index = GPOINTER_TO_UINT (
        g_hash_table_lookup (indices, cJSON_IsString (entry) ? entry->valuestring : key));
      if (index == 0)
        return fail_mesh (reading, 1, name, FALSE);
      add_corner (mesh, entry == face->child, index - 1);
    }
  return TRUE;
}

/* Every mesh in the document that is no joint, whichever class has it: assemblies, networks, models with
 * elements. Support, density, name and place are those of what is nearest around it. In files of old
 * assemblies the blocks stand beside the nodes, which say what is a support. Nodes without a block are told
 * where others have one. */
static gboolean
collect (const Reading *reading, const cJSON *item, const cJSON *nodes, const char *name,
         gboolean support, double density, const cJSON *matrix)
{
  static const char *const joints[] = { "edge",       "edgedata", "adjacency",
                                        "interfaces", "contacts", NULL };
  const cJSON *vertices = member (item, "vertex"), *faces = member (item, "face");
  const cJSON *given = member (item, "is_support"), *blocks = member (item, "blocks");
  if (given != NULL)
    support = cJSON_IsTrue (given);
  const cJSON *own_density = member (item, "density");
  if (own_density == NULL)
    own_density = member (member (item, "attributes"), "density");
  if (cJSON_IsNumber (own_density) && own_density->valuedouble > 0)
    density = own_density->valuedouble;
  const cJSON *placed = member (item, "transformation");
  const cJSON *data = member (placed, "data");
  if (cJSON_IsObject (placed))
    matrix = member (data != NULL ? data : placed, "matrix");
  /* Networks have their blocks in nodes, whatever else stands beside them. */
  gboolean network = cJSON_GetArraySize (member (item, "node")) > 0;
  if (network) {
    item = member (item, "node");
    support = FALSE;
  } else if (vertices != NULL && faces != NULL && cJSON_GetArraySize (faces) > 0) {
    return take_mesh (reading, vertices, faces, name, support, density, matrix);
  }
  g_autoptr (GHashTable) idle = g_hash_table_new (g_str_hash, g_str_equal);
  for (const cJSON *node = nodes != NULL ? nodes->child : NULL; node != NULL;
       node = node->next)
    g_hash_table_insert (idle, node->string, (gpointer) node);
  const cJSON *own = member (member (item, "assembly"), "vertex");
  guint found = reading->meshes->len, without = 0;
  for (const cJSON *child = item->child; child != NULL; child = child->next) {
    if (child->string != NULL && g_strv_contains (joints, child->string))
      continue;
    const cJSON *node =
      child->string != NULL ? g_hash_table_lookup (idle, child->string) : NULL;
    gboolean numbered = child->string != NULL && g_ascii_isdigit (child->string[0]);
    const char *inner = numbered ? child->string : name;
    const cJSON *title = member (child, "name");
    guint before = reading->meshes->len;
    if (cJSON_IsString (title) && !numbered)
      inner = title->valuestring;
    if (!collect (reading, child, child == blocks && cJSON_IsObject (own) ? own : NULL,
                  inner,
                  node != NULL ? cJSON_IsTrue (member (node, "is_support")) : support,
                  density, matrix))
      return FALSE;
    if (node != NULL)
      g_hash_table_remove (idle, child->string);
    without += reading->meshes->len == before;
  }
  without += g_hash_table_size (idle);
  if ((network || nodes != NULL) && reading->meshes->len > found)
    tell (reading->drawing, _ ("nodes without a block left out"), without, FALSE);
  return TRUE;
}

/* Adds the corners of "f 1 2/5 -1" behind its letter: a vertex by its number, or how far it is back. */
static gboolean
take_face (Mesh *mesh, const char *text, const GArray *points, GHashTable *indices)
{
  guint count = 0;
  while (*(text += strspn (text, " \t")) != '\0') {
    gint64 number = g_ascii_strtoll (text, NULL, 10);
    gint64 index = number < 0 ? number + points->len : number - 1;
    if (index < 0 || index >= points->len)
      return FALSE;
    copy_corner (mesh, count++ == 0, points, (guint) index, indices);
    text += strcspn (text, " \t");
  }
  return count >= 3;
}

/* Wavefront's OBJ: an object or group is a block. A backslash at the end of a line continues it. */
static gboolean
collect_objects (const Reading *reading, const char *bytes, gsize size)
{
  gsize length;
  g_autofree char *text = qn_text_decode (bytes, size, NULL, &length);
  g_auto (GStrv) lines = g_strsplit (text, "\n", -1);
  g_autoptr (GArray) points = g_array_new (FALSE, FALSE, sizeof (MeshPoint));
  g_autoptr (GHashTable) indices = g_hash_table_new (NULL, NULL);
  Mesh *mesh = NULL;
  g_autofree char *name = g_strdup ("1");
  for (guint i = 0; lines[i] != NULL; i++) {
    guint number = i + 1;
    g_autoptr (GString) line = g_string_new (lines[i]);
    while (line->len > 0 && line->str[line->len - 1] == '\\') {
      line->str[line->len - 1] = ' ';
      g_string_append (line, lines[i + 1] != NULL ? lines[++i] : "");
    }
    if (g_str_has_prefix (line->str, "v ")) {
      MeshPoint p;
      const char *at = line->str + 1;
      for (int axis = 0; axis < 3; axis++)
        if (!qn_svg_next_number (&at, &p.at[axis]))
          return fail_mesh (reading, number, name, TRUE);
      g_array_append_val (points, p);
    } else if (g_str_has_prefix (line->str, "o ") || g_str_has_prefix (line->str, "g ")) {
      mesh = NULL;
      g_free (name);
      name = g_strstrip (g_strdup (line->str + 2));
    } else if (g_str_has_prefix (line->str, "f ")) {
      if (mesh == NULL) {
        mesh = add_mesh (reading->meshes, name, FALSE, 0);
        g_hash_table_remove_all (indices);
      }
      if (!take_face (mesh, line->str + 2, points, indices))
        return fail_mesh (reading, number, name, FALSE);
    }
  }
  return TRUE;
}

gboolean
qn_compas_import (const char *text, gsize length, const char *name, QnDrawing *drawing,
                  GError **error)
{
  g_autoptr (GPtrArray) meshes = g_ptr_array_new_with_free_func (free_mesh);
  const Reading reading = { meshes, drawing, name, error };
  const char *first = text + strspn (text, " \t\r\n");
  gboolean json = length == 0 || *first == '{' || *first == '[';
  cJSON *document = json ? qn_json_parse (text, length, name, error) : NULL;
  drawing->unit = 1;
  gboolean done = !json ? collect_objects (&reading, text, length)
                  : document != NULL
                    ? collect (&reading, document, NULL, "1", FALSE, 0, NULL)
                    : FALSE;
  for (guint i = 0, count = meshes->len; i < count && done; i++)
    split_bodies (meshes, i);
  if (done) {
    /* Leaves out plates without thickness, such as a floor drawn as one face: they are no
     * blocks. Nor is what was taken apart. */
    for (guint i = meshes->len; i-- > 0;) {
      const Mesh *mesh = meshes->pdata[i];
      if (!is_plate (mesh))
        continue;
      tell (drawing, _ ("meshes without thickness left out"), mesh->points->len > 0,
            FALSE);
      g_ptr_array_remove_index (meshes, i);
    }
  }
  if (done && meshes->len == 0)
    done =
      qn_io_fail (error, QN_IO_ERROR_INVALID, _ ("%s:1: no assembly of blocks"), name);
  done = done && view_meshes (meshes, name, drawing, error);
  cJSON_Delete (document);
  return done;
}
