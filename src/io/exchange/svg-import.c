#include "io/exchange/drawing.h"
#include "io/exchange/svg-path.h"
#include "io/exchange/svg-style.h"
#include "io/text/io-error.h"

#include <gio/gio.h>
#include <glib/gi18n-lib.h>
#include <libxml/parser.h>
#include <string.h>

/* Depth of elements that are used within each other, and all that are drawn so. */
#define MAX_USES 24
#define MAX_USED 100000

/* A compressed file may become so large; bytes. */
#define MAX_INFLATED ((gsize) 256 << 20)

/* A unit outside of these is taken for undeclared; m. */
#define LEAST_UNIT   1e-9
#define LARGEST_UNIT 1e9

/* The user unit where no view box says otherwise. */
#define METRES_PER_PIXEL (0.0254 / 96)

/* x' = a x + c y + e, y' = b x + d y + f, as SVG writes matrix(a b c d e f). */
typedef struct Matrix {
  double a, b, c, d, e, f;
} Matrix;

/* Properties inherited by the children of an element. */
typedef struct State {
  Matrix matrix;
  const char *layer;    /* kept by the drawing */
  gboolean even_odd;    /* fill-rule */
  gboolean gone;        /* display: none */
  gboolean invisible;   /* visibility: hidden */
  gboolean empty, bare; /* fill: none; stroke: none, as it is to begin with */
  double width, height; /* of the view port, for percentages */
  guint uses;
} State;

typedef struct Importer {
  QnDrawing *drawing;
  const char *name;
  QnSvgStyle style;
  GHashTable *elements; /* id -> xmlNode */
  gboolean physical;    /* a length has a unit of its own */
  guint budget;         /* of used elements */
  GError **error;
} Importer;

static QnVec2
apply (const Matrix *m, QnVec2 p)
{
  return qn_vec2 (m->a * p.x + m->c * p.y + m->e, m->b * p.x + m->d * p.y + m->f);
}

static Matrix
multiply (const Matrix *m, const Matrix *n)
{
  return (Matrix){ m->a * n->a + m->c * n->b,        m->b * n->a + m->d * n->b,
                   m->a * n->c + m->c * n->d,        m->b * n->c + m->d * n->d,
                   m->a * n->e + m->c * n->f + m->e, m->b * n->e + m->d * n->f + m->f };
}

/* Pixels per unit of a length, degrees per unit of an angle; 0 where it is none. */
static double
unit_factor (const char *unit)
{
  static const struct {
    const char *name;
    double factor;
  } known[] = { { "px", 1 },         { "mm", 96 / 25.4 },   { "cm", 96 / 2.54 },
                { "in", 96 },        { "pt", 96.0 / 72 },   { "pc", 16 },
                { "m", 96 / .0254 }, { "em", 16 },          { "ex", 8 },
                { "deg", 1 },        { "rad", 180 / G_PI }, { "grad", 0.9 },
                { "turn", 360 },     { "Q", 96 / 101.6 } };
  gsize length = 0;
  while (g_ascii_isalpha (unit[length]))
    length++;
  for (gsize i = 0; i < G_N_ELEMENTS (known); i++)
    if (strlen (known[i].name) == length && strncmp (unit, known[i].name, length) == 0)
      return known[i].factor;
  return 0;
}

static void
move (Matrix *m, double x, double y)
{
  QnVec2 origin = apply (m, qn_vec2 (x, y));
  m->e = origin.x;
  m->f = origin.y;
}

/* By its name, with angles in degrees and lengths in pixels; FALSE for one that is not known. */
static gboolean
transform_of (const char *kind, const double *n, guint count, Matrix *m)
{
  gboolean along_x = g_str_has_suffix (kind, "X"), along_y = g_str_has_suffix (kind, "Y");
  g_autofree char *base = g_strndup (kind, strlen (kind) - (along_x || along_y));
  double angle = count > 0 ? n[0] * G_PI / 180 : 0, c = cos (angle), s = sin (angle);
  *m = (Matrix){ 1, 0, 0, 1, 0, 0 };
  if (count < 1 || (count > 1 && (along_x || along_y)))
    return FALSE;
  if (strcmp (base, "translate") == 0) {
    m->e = along_y ? 0 : n[0];
    m->f = along_y ? n[0] : count > 1 ? n[1] : 0;
  } else if (strcmp (base, "scale") == 0) {
    m->a = along_y ? 1 : n[0];
    m->d = along_x ? 1 : count > 1 ? n[1] : n[0];
  } else if (strcmp (kind, "matrix") == 0 && count == 6) {
    *m = (Matrix){ n[0], n[1], n[2], n[3], n[4], n[5] };
  } else if (strcmp (kind, "rotate") == 0) {
    *m = (Matrix){ c, s, -s, c, count == 3 ? n[1] : 0, count == 3 ? n[2] : 0 };
    move (m, -m->e, -m->f);
  } else if (strcmp (kind, "skewX") == 0) {
    m->c = tan (angle);
  } else if (strcmp (kind, "skewY") == 0) {
    m->b = tan (angle);
  } else {
    return FALSE;
  }
  return TRUE;
}

/* Attribute or property, "translate(1, 2) rotate(90deg)", on top of `all`. */
static Matrix
parse_transform (Importer *importer, const char *text, Matrix all, guint line)
{
  while (text != NULL && strcmp (text, "none") != 0) {
    const char *open = strchr (text, '('), *close = strchr (text, ')');
    if (open == NULL || close == NULL || close < open)
      break;
    double numbers[6];
    guint count = 0;
    const char *at = open + 1;
    while (count < 6 && qn_svg_next_number (&at, &numbers[count])) {
      double factor = unit_factor (at);
      numbers[count++] *= factor > 0 ? factor : 1;
      while (g_ascii_isalpha (*at))
        at++;
    }
    if (*at == '%')
      count = 0;
    g_autofree char *kind = g_strndup (text, (gsize) (open - text));
    Matrix own;
    if (!transform_of (g_strstrip (g_strdelimit (kind, ",", ' ')), numbers, count, &own))
      qn_drawing_note (importer->drawing, _ ("transformations that cannot be read"),
                       line);
    all = multiply (&all, &own);
    text = close + 1;
  }
  return all;
}

/* ---- elements ---- */

static void
note (Importer *importer, const xmlNode *node, const char *text)
{
  qn_drawing_note (importer->drawing, text, (guint) xmlGetLineNo (node));
}

static gboolean
is (const xmlNode *node, const char *element)
{
  return strcmp (qn_svg_name (node), element) == 0;
}

/* Where a percentage of a length counts from. */
typedef enum { ALONG_X, ALONG_Y, ALONG_BOTH } Along;

/* A length in user units; `otherwise` where it is not given or, which is told, no number. */
static double
length_of (Importer *importer, const xmlNode *node, const State *state, const char *key,
           Along along, double otherwise)
{
  g_autofree char *text = qn_svg_dup_property (&importer->style, node, key);
  const char *at = text;
  double number;
  if (text == NULL || !qn_svg_next_number (&at, &number)) {
    if (text != NULL && strcmp (text, "auto") != 0)
      note (importer, node, _ ("lengths that are no numbers, taken as not given"));
    return otherwise;
  }
  double across = hypot (state->width, state->height) / sqrt (2);
  if (*at == '%')
    return 0.01 * number
           * (along == ALONG_X   ? state->width
              : along == ALONG_Y ? state->height
                                 : across);
  double factor = unit_factor (at);
  importer->physical = importer->physical || (factor > 0 && factor != 1);
  return factor > 0 ? factor * number : number;
}

static gboolean
read_shape (Importer *importer, QnSvgPen *pen, const xmlNode *node, const State *state)
{
#define LENGTH(key, along, otherwise)                                                    \
  length_of (importer, node, state, key, along, otherwise)
  if (is (node, "path")) {
    g_autofree char *data = qn_svg_dup_attribute (node, "d");
    return data == NULL || qn_svg_read_path (pen, data);
  }
  if (is (node, "polygon") || is (node, "polyline")) {
    g_autofree char *points = qn_svg_dup_attribute (node, "points");
    return qn_svg_read_points (pen, points, is (node, "polygon"));
  }
  if (is (node, "rect")) {
    double x = LENGTH ("x", ALONG_X, 0), y = LENGTH ("y", ALONG_Y, 0);
    double w = LENGTH ("width", ALONG_X, 0), h = LENGTH ("height", ALONG_Y, 0);
    if (w < 0 || h < 0) {
      note (importer, node, _ ("shapes of negative size left out"));
      return TRUE;
    }
    if (LENGTH ("rx", ALONG_X, 0) > 0 || LENGTH ("ry", ALONG_Y, 0) > 0)
      note (importer, node, _ ("rounded corners drawn sharp"));
    qn_svg_pen_move (pen, qn_vec2 (x, y));
    qn_drawing_path_add (pen->path, qn_vec2 (x + w, y));
    qn_drawing_path_add (pen->path, qn_vec2 (x + w, y + h));
    qn_drawing_path_add (pen->path, qn_vec2 (x, y + h));
    pen->path->closed = TRUE;
  } else if (is (node, "circle") || is (node, "ellipse")) {
    QnVec2 centre = { LENGTH ("cx", ALONG_X, 0), LENGTH ("cy", ALONG_Y, 0) };
    double r = LENGTH ("r", ALONG_BOTH, 0);
    double rx = r > 0 ? r : LENGTH ("rx", ALONG_X, 0);
    double ry = r > 0 ? r : LENGTH ("ry", ALONG_Y, 0);
    if (r < 0 || rx < 0 || ry < 0) {
      note (importer, node, _ ("shapes of negative size left out"));
      return TRUE;
    }
    pen->path = qn_drawing_add_path (importer->drawing, pen->layer, pen->line);
    qn_drawing_path_add_ellipse (pen->path, centre, qn_vec2 (rx, 0), qn_vec2 (0, ry), 0,
                                 2 * G_PI);
    pen->path->count--;
    pen->path->closed = TRUE;
  } else { /* a line */
    qn_svg_pen_move (pen, qn_vec2 (LENGTH ("x1", ALONG_X, 0), LENGTH ("y1", ALONG_Y, 0)));
    qn_drawing_path_add (pen->path,
                         qn_vec2 (LENGTH ("x2", ALONG_X, 0), LENGTH ("y2", ALONG_Y, 0)));
  }
#undef LENGTH
  return TRUE;
}

static gboolean
add_shape (Importer *importer, const xmlNode *node, const State *state)
{
  GArray *paths = importer->drawing->paths;
  guint first = paths->len, line = (guint) xmlGetLineNo (node);
  QnSvgPen pen = { .drawing = importer->drawing, .layer = state->layer, .line = line };
  if (!read_shape (importer, &pen, node, state))
    return qn_io_fail (importer->error, QN_IO_ERROR_INVALID,
                       _ ("%s:%u: %s: its coordinates cannot be read"), importer->name,
                       line, qn_svg_name (node));
  gboolean painted = !state->empty || !state->bare || is (node, "line");
  for (guint i = first; i < paths->len; i++) {
    QnDrawingPath *path = &g_array_index (paths, QnDrawingPath, i);
    path->hidden = state->gone || state->invisible || !painted;
    path->closed = path->closed || (!state->empty && path->count >= 3);
    for (gsize k = 0; k < path->count; k++) {
      QnVec2 p = apply (&state->matrix, path->points[k]);
      path->points[k] = qn_vec2 (p.x, -p.y);
    }
  }
  qn_drawing_join_parts (importer->drawing, first, paths->len, state->even_odd);
  return TRUE;
}

/* The four numbers of a view box; FALSE where there is none. */
static gboolean
read_view_box (const xmlNode *node, double *box)
{
  g_autofree char *text = qn_svg_dup_attribute (node, "viewBox");
  const char *at = text;
  guint count = 0;
  while (text != NULL && count < 4 && qn_svg_next_number (&at, &box[count]))
    count++;
  return count == 4 && box[2] > 0 && box[3] > 0;
}

/* How many units of the view port a unit of the view box is, in both directions, and where the box begins
 * there (SVG 2, 8.2). */
static Matrix
fit_view_box (const xmlNode *node, const double *box, double width, double height)
{
  g_autofree char *given = qn_svg_dup_attribute (node, "preserveAspectRatio");
  const char *how = given != NULL ? given : "xMidYMid meet";
  double sx = width / box[2], sy = height / box[3];
  if (!g_str_has_prefix (how, "none"))
    sx = sy = strstr (how, "slice") != NULL ? fmax (sx, sy) : fmin (sx, sy);
  double right = strstr (how, "xMin") != NULL   ? 0
                 : strstr (how, "xMax") != NULL ? 1
                                                : 0.5;
  double down = strstr (how, "YMin") != NULL ? 0 : strstr (how, "YMax") != NULL ? 1 : 0.5;
  double dx = right * (width - sx * box[2]), dy = down * (height - sy * box[3]);
  return (Matrix){ sx, 0, 0, sy, dx - sx * box[0], dy - sy * box[1] };
}

/* A view port within the drawing, of an svg element or a symbol that is used. */
static void
enter_view_port (Importer *importer, const xmlNode *node, const xmlNode *use,
                 State *state)
{
  double box[4];
  double x = length_of (importer, node, state, "x", ALONG_X, 0);
  double y = length_of (importer, node, state, "y", ALONG_Y, 0);
  double w = length_of (importer, node, state, "width", ALONG_X, state->width);
  double h = length_of (importer, node, state, "height", ALONG_Y, state->height);
  if (use != NULL) {
    w = length_of (importer, use, state, "width", ALONG_X, w);
    h = length_of (importer, use, state, "height", ALONG_Y, h);
  }
  move (&state->matrix, x, y);
  state->width = w;
  state->height = h;
  if (!read_view_box (node, box))
    return;
  if (w > 0 && h > 0) {
    Matrix own = fit_view_box (node, box, w, h);
    state->matrix = multiply (&state->matrix, &own);
  }
  state->width = box[2];
  state->height = box[3];
}

/* Metres of a length with a unit of its own; 0 where it has none. */
static double
metres_of (const xmlNode *node, const char *key)
{
  g_autofree char *text = qn_svg_dup_attribute (node, key);
  const char *at = text;
  double number;
  if (text == NULL || !qn_svg_next_number (&at, &number) || *at == 'e'
      || strncmp (at, "px", 2) == 0)
    return 0;
  return unit_factor (at) * number * METRES_PER_PIXEL;
}

/* The view port of the whole drawing: its user unit is that of the drawing, and larger in one direction
 * where the view box is stretched. */
static void
enter_drawing (Importer *importer, const xmlNode *root, State *state)
{
  double box[4], width = metres_of (root, "width"), height = metres_of (root, "height");
  double unit = width > 0 || height > 0 ? METRES_PER_PIXEL : 0;
  state->width = length_of (importer, root, state, "width", ALONG_X, 0);
  state->height = length_of (importer, root, state, "height", ALONG_Y, 0);
  if (read_view_box (root, box)) {
    double w = width > 0 ? width : height * box[2] / box[3];
    double h = height > 0 ? height : width * box[3] / box[2];
    Matrix fit = fit_view_box (root, box, w, h);
    unit = width > 0 || height > 0 ? fit.a : 0;
    if (unit > 0 && fabs (fit.d / fit.a - 1) > 1e-12)
      state->matrix.d = fit.d / fit.a;
    state->width = box[2];
    state->height = box[3];
    importer->physical = FALSE;
  } else if (unit == 0 && importer->physical) {
    unit = METRES_PER_PIXEL;
  }
  if (unit >= LEAST_UNIT && unit <= LARGEST_UNIT)
    importer->drawing->unit = unit;
}

static gboolean
says (const char *value, const char *word)
{
  return value != NULL && g_ascii_strcasecmp (value, word) == 0;
}

/* A paint that is not seen; as before where the element itself says nothing. */
static gboolean
is_unpainted (const char *paint, const char *opacity, gboolean before)
{
  if (opacity != NULL && g_ascii_strtod (opacity, NULL) == 0)
    return TRUE;
  return paint == NULL || says (paint, "inherit")
           ? before
           : says (paint, "none") || says (paint, "transparent");
}

/* Where transformations turn about: "400px 300px", "50% bottom" of the view port. */
static QnVec2
origin_of (const char *text, const State *state)
{
  double number[2] = { 0 }, part[2] = { 0.5, 0.5 };
  g_auto (GStrv) given = g_strsplit_set (text, " \t\r\n", -1);
  guint count = 0;
  for (char **one = given; *one != NULL && count < 2; one++) {
    guint axis = says (*one, "top") || says (*one, "bottom")   ? 1
                 : says (*one, "left") || says (*one, "right") ? 0
                                                               : count;
    const char *at = *one;
    part[axis] = says (*one, "right") || says (*one, "bottom") ? 1
                 : says (*one, "center")                       ? 0.5
                                                               : 0;
    if (qn_svg_next_number (&at, &number[axis])) {
      double factor = *at == '%' ? 0 : unit_factor (at);
      part[axis] = *at == '%' ? 0.01 * number[axis] : 0;
      number[axis] *= *at == '%' ? 0 : factor > 0 ? factor : 1;
    }
    count += **one != '\0';
  }
  return qn_vec2 (number[0] + part[0] * state->width,
                  number[1] + part[1] * state->height);
}

static void
enter_transform (Importer *importer, const xmlNode *node, char *const *own, State *state)
{
  static const QnSvgProperty single[] = { QN_SVG_TRANSLATE, QN_SVG_ROTATE, QN_SVG_SCALE };
  static const char *const names[] = { "translate", "rotate", "scale" };
  guint line = (guint) xmlGetLineNo (node);
  gboolean any = own[QN_SVG_TRANSFORM] != NULL && !says (own[QN_SVG_TRANSFORM], "none");
  QnVec2 origin = { 0 };
  if (own[QN_SVG_TRANSFORM_ORIGIN] != NULL)
    origin = origin_of (own[QN_SVG_TRANSFORM_ORIGIN], state);
  move (&state->matrix, origin.x, origin.y);
  for (guint i = 0; i < G_N_ELEMENTS (single); i++)
    if (own[single[i]] != NULL && !says (own[single[i]], "none")) {
      g_autofree char *text = g_strdup_printf ("%s(%s)", names[i], own[single[i]]);
      state->matrix = parse_transform (importer, text, state->matrix, line);
      any = TRUE;
    }
  state->matrix = parse_transform (importer, own[QN_SVG_TRANSFORM], state->matrix, line);
  move (&state->matrix, -origin.x, -origin.y);
  if (any && own[QN_SVG_TRANSFORM_BOX] != NULL
      && !says (own[QN_SVG_TRANSFORM_BOX], "view-box")) {
    note (importer, node, _ ("shapes transformed about a box of their own left out"));
    state->gone = TRUE;
  }
}

/* What the element's attributes and style change for it and for what is in it. */
static void
enter (Importer *importer, const xmlNode *node, State *state)
{
  QnSvgProperties properties = qn_svg_properties_of (&importer->style, node);
  char *const *own = properties.of;
  enter_transform (importer, node, own, state);
  state->gone =
    state->gone || says (own[QN_SVG_DISPLAY], "none")
    || (own[QN_SVG_OPACITY] != NULL && g_ascii_strtod (own[QN_SVG_OPACITY], NULL) == 0);
  if (own[QN_SVG_VISIBILITY] != NULL && !says (own[QN_SVG_VISIBILITY], "inherit"))
    state->invisible = !says (own[QN_SVG_VISIBILITY], "visible");
  state->empty = is_unpainted (own[QN_SVG_FILL], own[QN_SVG_FILL_OPACITY], state->empty);
  state->bare =
    is_unpainted (own[QN_SVG_STROKE], own[QN_SVG_STROKE_OPACITY], state->bare);
  if (own[QN_SVG_FILL_RULE] != NULL && !says (own[QN_SVG_FILL_RULE], "inherit"))
    state->even_odd = says (own[QN_SVG_FILL_RULE], "evenodd");
  if (own[QN_SVG_CLIP_PATH] != NULL && !says (own[QN_SVG_CLIP_PATH], "none"))
    note (importer, node, _ ("shapes that are clipped taken whole"));
  qn_svg_properties_clear (&properties);
  if (!is (node, "g"))
    return;
  g_autofree char *label = qn_svg_dup_attribute (node, "inkscape:label");
  g_autofree char *id = qn_svg_dup_attribute (node, "id");
  if (label != NULL || id != NULL)
    state->layer = qn_drawing_keep_string (importer->drawing, label != NULL ? label : id);
}

static gboolean walk (Importer *importer, const xmlNode *node, State state);

static gboolean
walk_children (Importer *importer, const xmlNode *node, const State *state)
{
  for (const xmlNode *child = node->children; child != NULL; child = child->next)
    if (child->type == XML_ELEMENT_NODE && !walk (importer, child, *state))
      return FALSE;
  return TRUE;
}

/* Elements that are drawn: shapes, what holds others, and what is left out. */
static const char *const svg_shapes[] = { "path",   "polygon", "polyline", "rect",
                                          "circle", "ellipse", "line",     NULL };
static const char *const svg_groups[] = { "svg", "g", "a", "switch", "use", NULL };
static const char *const svg_others[] = { "text", "image", "foreignObject", NULL };

/* Whether the user reads a language, "de-CH": by its beginning, too. Written as in locales then. */
static gboolean
user_reads (char *language)
{
  const char *const *all = g_get_language_names ();
  g_strdelimit (language, "-", '_');
  for (guint i = 0; all[i] != NULL; i++) {
    const char *own = i == 0 && !g_ascii_islower (all[i][0]) ? "en" : all[i];
    const gsize length = strlen (own);
    if (g_ascii_strncasecmp (language, own, length) == 0
        && strchr ("_", language[length]) != NULL)
      return TRUE;
  }
  return FALSE;
}

/* Whether an element in a switch may be the one that is drawn (SVG 1.1, 5.8). Extensions are not known, and
 * what is of another kind than SVG is not drawn: of features those that the W3C has named are known. */
static gboolean
is_applicable (const xmlNode *node)
{
  g_autofree char *extensions = qn_svg_dup_attribute (node, "requiredExtensions");
  g_autofree char *features = qn_svg_dup_attribute (node, "requiredFeatures");
  g_autofree char *languages = qn_svg_dup_attribute (node, "systemLanguage");
  if (extensions != NULL
      || (features != NULL
          && (strstr (features, "w3") == NULL || strstr (features, "#Extensibility"))))
    return FALSE;
  g_auto (GStrv) tags = g_strsplit_set (languages != NULL ? languages : "", ", ", -1);
  for (char **tag = tags; *tag != NULL; tag++)
    if (**tag != '\0' && user_reads (*tag))
      return TRUE;
  return languages == NULL;
}

/* The first of its children that applies. */
static gboolean
walk_switch (Importer *importer, const xmlNode *node, const State *state)
{
  for (const xmlNode *child = node->children; child != NULL; child = child->next) {
    const char *name = child->type == XML_ELEMENT_NODE ? qn_svg_name (child) : "";
    if ((g_strv_contains (svg_shapes, name) || g_strv_contains (svg_groups, name)
         || g_strv_contains (svg_others, name))
        && strcmp (name, "foreignObject") != 0 && is_applicable (child))
      return walk (importer, child, *state);
  }
  g_autofree char *text = g_strdup_printf (_ ("%s elements left out"), "switch");
  note (importer, node, text);
  return TRUE;
}

static gboolean
walk_use (Importer *importer, const xmlNode *use, State state)
{
  g_autofree char *href = qn_svg_dup_attribute (use, "xlink:href");
  const xmlNode *target = href != NULL && href[0] == '#'
                            ? g_hash_table_lookup (importer->elements, href + 1)
                            : NULL;
  if (target == NULL || ++state.uses > MAX_USES) {
    note (importer, use,
          target == NULL ? _ ("uses of unknown elements left out")
                         : _ ("uses nested too deeply left out"));
    return TRUE;
  }
  move (&state.matrix, length_of (importer, use, &state, "x", ALONG_X, 0),
        length_of (importer, use, &state, "y", ALONG_Y, 0));
  if (!is (target, "symbol") && !is (target, "svg"))
    return walk (importer, target, state);
  enter (importer, target, &state);
  enter_view_port (importer, target, use, &state);
  return walk_children (importer, target, &state);
}

static gboolean
walk (Importer *importer, const xmlNode *node, State state)
{
  const char *name = qn_svg_name (node);
  if (state.uses > 0 && importer->budget-- == 0)
    return qn_io_fail (importer->error, QN_IO_ERROR_INVALID,
                       _ ("%s:1: more than %d outlines"), importer->name, MAX_USED);
  if (g_strv_contains (svg_shapes, name)) {
    enter (importer, node, &state);
    return add_shape (importer, node, &state);
  }
  if (strcmp (name, "use") == 0) {
    enter (importer, node, &state);
    return walk_use (importer, node, state);
  }
  if (g_strv_contains (svg_groups, name)) {
    enter (importer, node, &state);
    if (node->parent != NULL && node->parent->type != XML_ELEMENT_NODE)
      enter_drawing (importer, node, &state);
    else if (is (node, "svg"))
      enter_view_port (importer, node, NULL, &state);
    return is (node, "switch") ? walk_switch (importer, node, &state)
                               : walk_children (importer, node, &state);
  }
  if (g_strv_contains (svg_others, name)) {
    g_autofree char *text = g_strdup_printf (_ ("%s elements left out"), name);
    qn_drawing_note (importer->drawing, text, (guint) xmlGetLineNo (node))->minor = TRUE;
  }
  return TRUE;
}

/* The uncompressed text of a gzip file; NULL: unreadable or too large. */
static GByteArray *
inflate (const char *bytes, gsize size)
{
  g_autoptr (GZlibDecompressor) gzip =
    g_zlib_decompressor_new (G_ZLIB_COMPRESSOR_FORMAT_GZIP);
  g_autoptr (GInputStream) packed =
    g_memory_input_stream_new_from_data (bytes, (gssize) size, NULL);
  g_autoptr (GInputStream) stream =
    g_converter_input_stream_new (packed, G_CONVERTER (gzip));
  g_autoptr (GByteArray) all = g_byte_array_new ();
  guint8 piece[16384];
  gssize count;
  while ((count = g_input_stream_read (stream, piece, sizeof piece, NULL, NULL)) > 0
         && all->len < MAX_INFLATED)
    g_byte_array_append (all, piece, (guint) count);
  return count == 0 ? g_steal_pointer (&all) : NULL;
}

static gboolean
import_document (const xmlDoc *document, const char *name, QnDrawing *drawing,
                 GError **error)
{
  const xmlNode *root = xmlDocGetRootElement ((xmlDoc *) document);
  Importer importer = { .drawing = drawing,
                        .name = name,
                        .elements =
                          g_hash_table_new_full (g_str_hash, g_str_equal, g_free, NULL),
                        .budget = MAX_USED,
                        .error = error };
  State state = { .matrix = { 1, 0, 0, 1, 0, 0 }, .layer = "0", .bare = TRUE };
  qn_svg_style_init (&importer.style);
  /* Elements by their id, and the style sheets. Without recursion: a document may be deep. */
  for (const xmlNode *node = root; node != NULL;) {
    if (node->type == XML_ELEMENT_NODE) {
      char *id = qn_svg_dup_attribute (node, "id");
      if (id != NULL)
        g_hash_table_insert (importer.elements, id, (gpointer) node);
      if (is (node, "style"))
        qn_svg_style_add (&importer.style, node);
    }
    const xmlNode *next = node->type == XML_ELEMENT_NODE ? node->children : NULL;
    for (; next == NULL && node != root; node = node->parent)
      next = node->next;
    node = next;
  }
  if (importer.style.odd > 0)
    qn_drawing_note (drawing, _ ("rules of the style sheet that are not followed"), 0)
      ->count = importer.style.odd;
  gboolean done = is (root, "svg");
  if (done)
    done = walk (&importer, root, state);
  else
    g_set_error (error, QN_IO_ERROR, QN_IO_ERROR_INVALID,
                 _ ("%s:1: not an SVG drawing: its element is \"%s\""), name,
                 qn_svg_name (root));
  if (drawing->unit == 0 && importer.physical)
    drawing->unit = METRES_PER_PIXEL;
  qn_svg_style_clear (&importer.style);
  g_hash_table_unref (importer.elements);
  return done;
}

gboolean
qn_svg_import (const char *text, gsize length, const char *name, QnDrawing *drawing,
               GError **error)
{
  g_autoptr (GByteArray) inflated = NULL;
  if (length > 2 && memcmp (text, "\x1f\x8b", 2) == 0) {
    inflated = inflate (text, length);
    text = inflated != NULL ? (const char *) inflated->data : "";
    length = inflated != NULL ? inflated->len : 0;
  }
  /* Entities are replaced in attributes; those of other files are not read. */
  xmlParserCtxt *context = xmlNewParserCtxt ();
  xmlDoc *document =
    length <= G_MAXINT
      ? xmlCtxtReadMemory (context, text, (int) length, NULL, NULL,
                           XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_NOWARNING)
      : NULL;
  if (document == NULL) {
    /* One line of what libxml2 says. */
    const xmlError *problem = xmlCtxtGetLastError (context);
    g_autofree char *reason = g_utf8_make_valid (
      problem != NULL && problem->message != NULL ? problem->message
                                                  : _ ("not an XML file"),
      -1);
    g_set_error (error, QN_IO_ERROR, QN_IO_ERROR_INVALID, "%s:%d: %s", name,
                 problem != NULL ? MAX (problem->line, 1) : 1,
                 g_strstrip (g_strdelimit (reason, "\r\n", ' ')));
  }
  gboolean done = document != NULL && import_document (document, name, drawing, error);
  xmlFreeDoc (document);
  xmlFreeParserCtxt (context);
  return done;
}
