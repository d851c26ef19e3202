#include "io/exchange/svg-import.h"
#include "io/text/io-error.h"

#include <glib/gi18n-lib.h>
#include <string.h>

#define MAX_GROUPS   64
#define CURVE_CHORDS 12

/* A unit outside of these is taken for undeclared; m. */
#define LEAST_UNIT   1e-9
#define LARGEST_UNIT 1e9

/* x' = a x + c y + e, y' = b x + d y + f, as SVG writes matrix(a b c d e f). */
typedef struct Matrix {
  double a, b, c, d, e, f;
} Matrix;

typedef struct Group {
  Matrix matrix;
  const char *layer; /* kept by the drawing */
  gboolean hidden;   /* definitions, clip paths … */
} Group;

typedef struct Importer {
  QnDrawing *drawing;
  const char *name;
  Group groups[MAX_GROUPS];
  guint depth;
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

static void
skip_blanks (const char **text)
{
  while (**text != '\0' && (g_ascii_isspace (**text) || **text == ','))
    (*text)++;
}

/* The next number of a list; FALSE where there is none. */
static gboolean
next_number (const char **text, double *number)
{
  skip_blanks (text);
  if (**text == '\0' || strchr ("+-.0123456789", **text) == NULL)
    return FALSE;
  char *end;
  *number = g_ascii_strtod (*text, &end);
  if (end == *text || !isfinite (*number))
    return FALSE;
  *text = end;
  return TRUE;
}

static guint
read_numbers (const char *text, double *numbers, guint most)
{
  guint count = 0;
  while (count < most && next_number (&text, &numbers[count]))
    count++;
  return count;
}

static Matrix
transform_of (const char *kind, gsize length, const double *n, guint count)
{
  Matrix m = { 1, 0, 0, 1, 0, 0 };
  if (length == 6 && strncmp (kind, "matrix", 6) == 0 && count == 6)
    return (Matrix){ n[0], n[1], n[2], n[3], n[4], n[5] };
  if (length == 9 && strncmp (kind, "translate", 9) == 0 && count >= 1) {
    m.e = n[0];
    m.f = count > 1 ? n[1] : 0;
  } else if (length == 5 && strncmp (kind, "scale", 5) == 0 && count >= 1) {
    m.a = n[0];
    m.d = count > 1 ? n[1] : n[0];
  } else if (length == 6 && strncmp (kind, "rotate", 6) == 0 && count >= 1) {
    double angle = n[0] * G_PI / 180;
    Matrix turn = { cos (angle), sin (angle), -sin (angle), cos (angle), 0, 0 };
    m = turn;
    if (count == 3) {
      QnVec2 moved = apply (&turn, qn_vec2 (n[1], n[2]));
      m.e = n[1] - moved.x;
      m.f = n[2] - moved.y;
    }
  } else if (length == 5 && strncmp (kind, "skewX", 5) == 0 && count == 1) {
    m.c = tan (n[0] * G_PI / 180);
  } else if (length == 5 && strncmp (kind, "skewY", 5) == 0 && count == 1) {
    m.b = tan (n[0] * G_PI / 180);
  }
  return m;
}

static Matrix
parse_transform (const char *text, Matrix all)
{
  while (text != NULL && *text != '\0') {
    skip_blanks (&text);
    const char *open = strchr (text, '('), *close = strchr (text, ')');
    if (open == NULL || close == NULL || close < open)
      break;
    double numbers[6];
    g_autofree char *list = g_strndup (open + 1, (gsize) (close - open - 1));
    guint count = read_numbers (list, numbers, G_N_ELEMENTS (numbers));
    gsize length = (gsize) (open - text);
    while (length > 0 && g_ascii_isspace (text[length - 1]))
      length--;
    Matrix own = transform_of (text, length, numbers, count);
    all = multiply (&all, &own);
    text = close + 1;
  }
  return all;
}

/* An elliptic arc from the last point, in the notation of SVG (implementation notes of the SVG
 * specification, "Conversion from endpoint to center parameterization"). */
static void
add_arc (QnDrawingPath *path, const double *n, QnVec2 end)
{
  QnVec2 start = path->points[path->count - 1];
  double rx = fabs (n[0]), ry = fabs (n[1]), phi = n[2] * G_PI / 180;
  if (rx == 0 || ry == 0 || (start.x == end.x && start.y == end.y)) {
    qn_drawing_path_add (path, end);
    return;
  }
  double c = cos (phi), s = sin (phi);
  QnVec2 half = qn_vec2_scale (0.5, qn_vec2_sub (start, end));
  QnVec2 p = { c * half.x + s * half.y, -s * half.x + c * half.y };
  double lambda = p.x * p.x / (rx * rx) + p.y * p.y / (ry * ry);
  if (lambda > 1) {
    rx *= sqrt (lambda);
    ry *= sqrt (lambda);
  }
  double down = rx * rx * p.y * p.y + ry * ry * p.x * p.x;
  double root = sqrt (fmax (0, (rx * rx * ry * ry - down) / down));
  if ((n[3] != 0) == (n[4] != 0))
    root = -root;
  QnVec2 centre = { root * rx * p.y / ry, -root * ry * p.x / rx };
  double from = atan2 ((p.y - centre.y) / ry, (p.x - centre.x) / rx);
  double to = atan2 ((-p.y - centre.y) / ry, (-p.x - centre.x) / rx);
  if (n[4] != 0 && to < from)
    to += 2 * G_PI;
  if (n[4] == 0 && to > from)
    to -= 2 * G_PI;
  QnVec2 middle = qn_vec2_lerp (start, end, 0.5);
  QnVec2 at = { c * centre.x - s * centre.y + middle.x,
                s * centre.x + c * centre.y + middle.y };
  path->count--;
  qn_drawing_path_add_ellipse (path, at, qn_vec2 (c * rx, s * rx),
                               qn_vec2 (-s * ry, c * ry), from, to);
  path->points[path->count - 1] = end;
}

/* A Bézier curve of degree 2 or 3 from the last point. */
static void
add_curve (QnDrawingPath *path, const QnVec2 *control, int degree)
{
  QnVec2 p[4] = { path->points[path->count - 1] };
  for (int i = 0; i < degree; i++)
    p[i + 1] = control[i];
  for (int k = 1; k <= CURVE_CHORDS; k++) {
    double t = (double) k / CURVE_CHORDS;
    QnVec2 q[4] = { p[0], p[1], p[2], p[3] };
    for (int round = degree; round > 0; round--)
      for (int i = 0; i < round; i++)
        q[i] = qn_vec2_lerp (q[i], q[i + 1], t);
    qn_drawing_path_add (path, k == CURVE_CHORDS ? p[degree] : q[0]);
  }
}

/* Where the pen is while a path's data are read. */
typedef struct Pen {
  Importer *importer;
  const char *layer;
  guint line;
  QnDrawingPath *path; /* open, or NULL */
  QnVec2 at, start, handle;
  char last;
} Pen;

static void
pen_move (Pen *pen, QnVec2 to)
{
  pen->path = qn_drawing_add_path (pen->importer->drawing, pen->layer, pen->line);
  qn_drawing_path_add (pen->path, to);
  pen->at = pen->start = to;
}

static QnVec2
pen_point (const Pen *pen, gboolean relative, double x, double y)
{
  return relative ? qn_vec2 (pen->at.x + x, pen->at.y + y) : qn_vec2 (x, y);
}

static guint
number_count (char command)
{
  switch (command) {
  case 'M':
  case 'L':
  case 'T':
    return 2;
  case 'H':
  case 'V':
    return 1;
  case 'S':
  case 'Q':
    return 4;
  case 'C':
    return 6;
  case 'A':
    return 7;
  default:
    return 0;
  }
}

/* One command with its numbers. */
static void
pen_draw (Pen *pen, char command, gboolean relative, const double *n)
{
  QnVec2 mirrored = qn_vec2_sub (qn_vec2_scale (2, pen->at), pen->handle);
  QnVec2 control[3], end = pen->at;
  if (pen->path == NULL)
    pen_move (pen, pen->at);
  switch (command) {
  case 'L':
    end = pen_point (pen, relative, n[0], n[1]);
    qn_drawing_path_add (pen->path, end);
    break;
  case 'H':
    end.x = relative ? end.x + n[0] : n[0];
    qn_drawing_path_add (pen->path, end);
    break;
  case 'V':
    end.y = relative ? end.y + n[0] : n[0];
    qn_drawing_path_add (pen->path, end);
    break;
  case 'C':
  case 'S': {
    guint k = command == 'C' ? 2 : 0;
    control[0] = command == 'C' ? pen_point (pen, relative, n[0], n[1])
                 : strchr ("CS", pen->last) != NULL ? mirrored
                                                    : pen->at;
    control[1] = pen_point (pen, relative, n[k], n[k + 1]);
    control[2] = end = pen_point (pen, relative, n[k + 2], n[k + 3]);
    add_curve (pen->path, control, 3);
    pen->handle = control[1];
    break;
  }
  case 'Q':
  case 'T':
    control[0] = command == 'Q' ? pen_point (pen, relative, n[0], n[1])
                 : strchr ("QT", pen->last) != NULL ? mirrored
                                                    : pen->at;
    control[1] = end = command == 'Q' ? pen_point (pen, relative, n[2], n[3])
                                      : pen_point (pen, relative, n[0], n[1]);
    add_curve (pen->path, control, 2);
    pen->handle = control[0];
    break;
  case 'A':
    end = pen_point (pen, relative, n[5], n[6]);
    add_arc (pen->path, n, end);
    break;
  default:
    break;
  }
  pen->at = end;
  pen->last = command;
}

/* The data of a path element; FALSE where they are not well-formed. */
static gboolean
read_path (Pen *pen, const char *data)
{
  char command = '\0';
  for (;;) {
    skip_blanks (&data);
    if (*data == '\0')
      return TRUE;
    gboolean given = g_ascii_isalpha (*data) != 0;
    if (given)
      command = *data++;
    char upper = g_ascii_toupper (command);
    gboolean relative = upper != command;
    if (upper == 'Z') {
      if (!given)
        return FALSE;
      if (pen->path != NULL)
        pen->path->closed = TRUE;
      pen->path = NULL;
      pen->at = pen->start;
      pen->last = upper;
      continue;
    }
    double numbers[7];
    guint need = number_count (upper);
    if (need == 0)
      return FALSE;
    for (guint i = 0; i < need; i++) {
      /* The flags of an arc may stand without blanks. */
      skip_blanks (&data);
      if (upper == 'A' && (i == 3 || i == 4) && (*data == '0' || *data == '1'))
        numbers[i] = *data++ - '0';
      else if (!next_number (&data, &numbers[i]))
        return FALSE;
    }
    if (upper == 'M') {
      pen_move (pen, pen_point (pen, relative, numbers[0], numbers[1]));
      pen->last = 'M';
      command = relative ? 'l' : 'L';
    } else {
      pen_draw (pen, upper, relative, numbers);
    }
  }
}

static const char *
attribute (const char **keys, const char **values, const char *key)
{
  for (guint i = 0; keys[i] != NULL; i++)
    if (strcmp (keys[i], key) == 0)
      return values[i];
  return NULL;
}

static double
number_of (const char **keys, const char **values, const char *key)
{
  const char *text = attribute (keys, values, key);
  double number = 0;
  return text != NULL && next_number (&text, &number) ? number : 0;
}

static gboolean
read_points (Pen *pen, const char *text, gboolean closed)
{
  double x, y;
  gboolean first = TRUE;
  while (text != NULL && next_number (&text, &x)) {
    if (!next_number (&text, &y))
      return FALSE;
    if (first)
      pen_move (pen, qn_vec2 (x, y));
    else
      qn_drawing_path_add (pen->path, qn_vec2 (x, y));
    first = FALSE;
  }
  if (pen->path != NULL)
    pen->path->closed = closed;
  return TRUE;
}

static gboolean
read_shape (Pen *pen, const char *element, const char **keys, const char **values)
{
  if (strcmp (element, "path") == 0) {
    const char *data = attribute (keys, values, "d");
    return data == NULL || read_path (pen, data);
  }
  if (strcmp (element, "polygon") == 0 || strcmp (element, "polyline") == 0)
    return read_points (pen, attribute (keys, values, "points"), element[4] == 'g');
  if (strcmp (element, "rect") == 0) {
    double x = number_of (keys, values, "x"), y = number_of (keys, values, "y");
    double w = number_of (keys, values, "width"), h = number_of (keys, values, "height");
    pen_move (pen, qn_vec2 (x, y));
    qn_drawing_path_add (pen->path, qn_vec2 (x + w, y));
    qn_drawing_path_add (pen->path, qn_vec2 (x + w, y + h));
    qn_drawing_path_add (pen->path, qn_vec2 (x, y + h));
    pen->path->closed = TRUE;
  } else if (strcmp (element, "circle") == 0 || strcmp (element, "ellipse") == 0) {
    QnVec2 centre = { number_of (keys, values, "cx"), number_of (keys, values, "cy") };
    double r = number_of (keys, values, "r");
    double rx = r > 0 ? r : number_of (keys, values, "rx");
    double ry = r > 0 ? r : number_of (keys, values, "ry");
    pen->path = qn_drawing_add_path (pen->importer->drawing, pen->layer, pen->line);
    qn_drawing_path_add_ellipse (pen->path, centre, qn_vec2 (rx, 0), qn_vec2 (0, ry), 0,
                                 2 * G_PI);
    pen->path->count--;
    pen->path->closed = TRUE;
  } else if (strcmp (element, "line") == 0) {
    pen_move (pen,
              qn_vec2 (number_of (keys, values, "x1"), number_of (keys, values, "y1")));
    qn_drawing_path_add (pen->path, qn_vec2 (number_of (keys, values, "x2"),
                                             number_of (keys, values, "y2")));
  } else if (strcmp (element, "text") == 0 || strcmp (element, "image") == 0
             || strcmp (element, "use") == 0) {
    g_autofree char *text = g_strdup_printf (_ ("%s elements left out"), element);
    qn_drawing_note (pen->importer->drawing, text, pen->line, qn_vec2 (NAN, NAN));
  }
  return TRUE;
}

/* Metres per user unit, from width="210mm" and viewBox="0 0 210 297". */
static void
read_unit (Importer *importer, const char **keys, const char **values)
{
  static const struct {
    const char *name;
    double metres;
  } units[] = { { "mm", 0.001 }, { "cm", 0.01 }, { "in", 0.0254 }, { "m", 1 } };
  const char *width = attribute (keys, values, "width");
  const char *box = attribute (keys, values, "viewBox");
  double size, numbers[4], unit = 0;
  if (width == NULL || box == NULL || !next_number (&width, &size)
      || read_numbers (box, numbers, 4) != 4 || !(numbers[2] > 0))
    return;
  for (gsize i = 0; i < G_N_ELEMENTS (units); i++)
    if (strcmp (width, units[i].name) == 0)
      unit = units[i].metres * size / numbers[2];
  if (unit >= LEAST_UNIT && unit <= LARGEST_UNIT)
    importer->drawing->unit = unit;
}

static void
start_element (GMarkupParseContext *context, const char *element, const char **keys,
               const char **values, gpointer data, GError **error)
{
  Importer *importer = data;
  const char *colon = strchr (element, ':');
  if (colon != NULL)
    element = colon + 1;
  int line;
  g_markup_parse_context_get_position (context, &line, NULL);
  if (importer->depth + 1 >= MAX_GROUPS) {
    g_set_error (error, QN_IO_ERROR, QN_IO_ERROR_INVALID, _ ("%s:%d: nested too deeply"),
                 importer->name, line);
    return;
  }
  const Group *outer = &importer->groups[importer->depth];
  Group *own = &importer->groups[++importer->depth];
  *own = *outer;
  own->matrix = parse_transform (attribute (keys, values, "transform"), outer->matrix);
  if (strcmp (element, "svg") == 0 && importer->depth == 1)
    read_unit (importer, keys, values);
  if (strcmp (element, "g") == 0) {
    const char *label = attribute (keys, values, "inkscape:label");
    if (label == NULL)
      label = attribute (keys, values, "id");
    if (label != NULL)
      own->layer = qn_drawing_keep_string (importer->drawing, label);
  }
  static const char *const unseen[] = { "defs",   "clipPath", "mask", "pattern",
                                        "marker", "symbol",   NULL };
  own->hidden = outer->hidden || g_strv_contains (unseen, element);
  if (own->hidden)
    return;

  GArray *paths = importer->drawing->paths;
  guint first = paths->len;
  Pen pen = { .importer = importer, .layer = own->layer, .line = (guint) line };
  if (!read_shape (&pen, element, keys, values)) {
    g_set_error (error, QN_IO_ERROR, QN_IO_ERROR_INVALID,
                 _ ("%s:%d: %s: its coordinates cannot be read"), importer->name, line,
                 element);
    return;
  }
  for (guint i = first; i < paths->len; i++) {
    QnDrawingPath *path = &g_array_index (paths, QnDrawingPath, i);
    for (gsize k = 0; k < path->count; k++) {
      QnVec2 p = apply (&own->matrix, path->points[k]);
      path->points[k] = qn_vec2 (p.x, -p.y);
    }
  }
}

static void
end_element (GMarkupParseContext *context, const char *element, gpointer data,
             GError **error)
{
  (void) context;
  (void) element;
  (void) error;
  ((Importer *) data)->depth--;
}

gboolean
qn_svg_import (const char *text, gsize length, const char *name, QnDrawing *drawing,
               GError **error)
{
  const GMarkupParser parser = { .start_element = start_element,
                                 .end_element = end_element };
  Importer importer = { .drawing = drawing, .name = name };
  importer.groups[0] = (Group){ { 1, 0, 0, 1, 0, 0 }, "0", FALSE };
  qn_drawing_init (drawing);
  GMarkupParseContext *context = g_markup_parse_context_new (&parser, 0, &importer, NULL);
  GError *problem = NULL;
  gboolean done = g_markup_parse_context_parse (context, text, (gssize) length, &problem)
                  && g_markup_parse_context_end_parse (context, &problem);
  if (!done && problem->domain != QN_IO_ERROR) {
    int line;
    g_markup_parse_context_get_position (context, &line, NULL);
    g_autofree char *reason = g_strdelimit (g_strdup (problem->message), "\r\n", ' ');
    g_set_error (error, QN_IO_ERROR, QN_IO_ERROR_INVALID, "%s:%d: %s", name, line,
                 reason);
    g_error_free (problem);
  } else if (!done) {
    g_propagate_error (error, problem);
  }
  g_markup_parse_context_free (context);
  if (!done)
    qn_drawing_clear (drawing);
  return done;
}
