#include "io/exchange/compas-import.h"
#include "io/json/json-parse.h"
#include "io/text/io-error.h"

#include <glib/gi18n-lib.h>
#include <math.h>

/* Vertices of a prism coincide in projection within this part of the block's extent. */
#define PLANAR_TOLERANCE 1e-6

static const char *const axes[] = { "x", "y", "z" };

/* Axis along which the prisms run, tried in this order, and the two that are seen. */
static const struct {
  int depth, right, up;
} views[] = { { 1, 0, 2 }, { 2, 0, 1 }, { 0, 1, 2 } };

static const cJSON *
member (const cJSON *object, const char *key)
{
  return cJSON_IsObject (object) ? cJSON_GetObjectItemCaseSensitive (object, key) : NULL;
}

/* "data" wrappers of newer versions are looked through. */
static const cJSON *
inside (const cJSON *value)
{
  const cJSON *data = member (value, "data");
  return data != NULL ? data : value;
}

static double
coordinate (const cJSON *vertex, int axis)
{
  const cJSON *value = cJSON_IsArray (vertex) ? cJSON_GetArrayItem (vertex, axis)
                                              : member (vertex, axes[axis]);
  return cJSON_IsNumber (value) ? value->valuedouble : NAN;
}

/* A vertex of the block by the entry of a face, a number or a string. */
static const cJSON *
vertex_of (const cJSON *vertices, const cJSON *entry)
{
  char key[32];
  if (cJSON_IsNumber (entry))
    g_snprintf (key, sizeof key, "%.0f", entry->valuedouble);
  const char *text = cJSON_IsString (entry) ? entry->valuestring : key;
  if (cJSON_IsArray (vertices))
    return cJSON_GetArrayItem (vertices, (int) g_ascii_strtoll (text, NULL, 10));
  return member (vertices, text);
}

/* Extent of the block along its largest axis. */
static double
extent_of (const cJSON *vertices)
{
  double extent = 0;
  for (int axis = 0; axis < 3; axis++) {
    double low = INFINITY, high = -INFINITY;
    for (const cJSON *v = vertices->child; v != NULL; v = v->next) {
      low = fmin (low, coordinate (v, axis));
      high = fmax (high, coordinate (v, axis));
    }
    extent = fmax (extent, high - low);
  }
  return extent;
}

/* Fills `outline` with the projection of a face that lies across the view; FALSE if it does not. */
static gboolean
project_face (const cJSON *vertices, const cJSON *face, int view, double tolerance,
              GArray *outline)
{
  double depth = NAN;
  g_array_set_size (outline, 0);
  for (const cJSON *entry = face->child; entry != NULL; entry = entry->next) {
    const cJSON *vertex = vertex_of (vertices, entry);
    double d = vertex != NULL ? coordinate (vertex, views[view].depth) : NAN;
    QnVec2 p = { NAN, NAN };
    if (vertex != NULL)
      p = qn_vec2 (coordinate (vertex, views[view].right),
                   coordinate (vertex, views[view].up));
    if (isnan (depth))
      depth = d;
    if (!(fabs (d - depth) <= tolerance) || !isfinite (p.x) || !isfinite (p.y))
      return FALSE;
    g_array_append_val (outline, p);
  }
  return outline->len >= 3;
}

/* Whether every vertex of the block is seen as a vertex of the outline. */
static gboolean
covers (const cJSON *vertices, int view, double tolerance, const GArray *outline)
{
  for (const cJSON *v = vertices->child; v != NULL; v = v->next) {
    QnVec2 p = { coordinate (v, views[view].right), coordinate (v, views[view].up) };
    gboolean seen = FALSE;
    for (guint i = 0; i < outline->len && !seen; i++)
      seen =
        qn_vec2_length (qn_vec2_sub (p, g_array_index (outline, QnVec2, i))) <= tolerance;
    if (!seen)
      return FALSE;
  }
  return TRUE;
}

static gboolean
outline_of (const cJSON *block, int view, GArray *outline)
{
  const cJSON *vertices = member (inside (block), "vertex");
  const cJSON *faces = member (inside (block), "face");
  if (vertices == NULL || faces == NULL)
    return FALSE;
  double tolerance = PLANAR_TOLERANCE * extent_of (vertices);
  for (const cJSON *face = faces->child; face != NULL; face = face->next)
    if (project_face (vertices, face, view, tolerance, outline)
        && covers (vertices, view, tolerance, outline))
      return TRUE;
  return FALSE;
}

/* A node of the assembly with its block. */
typedef struct Node {
  const cJSON *block;
  gboolean support;
} Node;

/* Adds all blocks as seen from one side; FALSE, with nothing added, if one is no prism. */
static gboolean
add_view (const GArray *nodes, int view, QnDrawing *drawing)
{
  g_autoptr (GArray) outline = g_array_new (FALSE, FALSE, sizeof (QnVec2));
  for (guint i = 0; i < nodes->len; i++)
    if (!outline_of (g_array_index (nodes, Node, i).block, view, outline))
      return FALSE;
  for (guint i = 0; i < nodes->len; i++) {
    const Node *node = &g_array_index (nodes, Node, i);
    outline_of (node->block, view, outline);
    QnDrawingPath *path = qn_drawing_add_path (drawing, "BLOCKS", 0);
    path->closed = TRUE;
    path->support = node->support;
    for (guint k = 0; k < outline->len; k++)
      qn_drawing_path_add (path, g_array_index (outline, QnVec2, k));
  }
  return TRUE;
}

gboolean
qn_compas_import (const char *text, gsize length, const char *name, QnDrawing *drawing,
                  GError **error)
{
  QnJsonProblem problem;
  cJSON *document = qn_json_parse (text, length, &problem);
  qn_drawing_init (drawing);
  drawing->unit = 1;
  gboolean done = FALSE;
  if (document == NULL) {
    g_propagate_error (error, qn_json_problem_to_error (&problem, name, text));
  } else {
    g_autoptr (GArray) nodes = g_array_new (FALSE, FALSE, sizeof (Node));
    const cJSON *data = inside (document);
    const cJSON *graph = inside (member (data, "graph"));
    const cJSON *list = member (graph, "node");
    const cJSON *blocks = NULL;
    if (list == NULL) {
      list = member (member (data, "assembly"), "vertex");
      blocks = member (data, "blocks");
    }
    for (const cJSON *item = list != NULL ? list->child : NULL; item != NULL;
         item = item->next) {
      const cJSON *block =
        blocks != NULL ? member (blocks, item->string) : member (item, "block");
      Node node = { block, cJSON_IsTrue (member (item, "is_support")) };
      if (block != NULL)
        g_array_append_val (nodes, node);
    }
    for (guint view = 0; nodes->len > 0 && !done && view < G_N_ELEMENTS (views); view++)
      done = add_view (nodes, (int) view, drawing);
    if (!done)
      g_set_error (error, QN_IO_ERROR, QN_IO_ERROR_INVALID,
                   nodes->len == 0
                     ? _ ("%s:1: no assembly of blocks")
                     : _ ("%s:1: the blocks are no prisms of one direction"),
                   name);
  }
  g_free (problem.path);
  cJSON_Delete (document);
  if (!done)
    qn_drawing_clear (drawing);
  return done;
}
