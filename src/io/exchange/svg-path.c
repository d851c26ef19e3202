#include "io/exchange/svg-path.h"

#include <string.h>

static void
skip_blanks (const char **text)
{
  while (**text != '\0' && (g_ascii_isspace (**text) || **text == ','))
    (*text)++;
}

gboolean
qn_svg_next_number (const char **text, double *number)
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

/* A Bézier curve of degree 2 or 3 from the last point: a spline of one span. */
static void
add_curve (QnDrawingPath *path, const QnVec2 *control, guint degree)
{
  static const double knots[] = { 0, 0, 0, 0, 1, 1, 1, 1 };
  QnVec2 p[4] = { path->points[path->count - 1] };
  for (guint i = 0; i < degree; i++)
    p[i + 1] = control[i];
  qn_drawing_path_add_spline (path, degree, knots + 3 - degree, 2 * degree + 2, p, NULL,
                              degree + 1);
}

void
qn_svg_pen_move (QnSvgPen *pen, QnVec2 to)
{
  pen->path = qn_drawing_add_path (pen->drawing, pen->layer, pen->line);
  qn_drawing_path_add (pen->path, to);
  pen->at = pen->start = to;
}

static QnVec2
pen_point (const QnSvgPen *pen, gboolean relative, double x, double y)
{
  return relative ? qn_vec2 (pen->at.x + x, pen->at.y + y) : qn_vec2 (x, y);
}

/* How many numbers a command has; 0 for what is none. */
static guint
number_count (char command)
{
  static const char commands[] = "MLTHVSQCA";
  static const guint counts[] = { 2, 2, 2, 1, 1, 4, 4, 6, 7 };
  const char *at = strchr (commands, command);
  return command != '\0' && at != NULL ? counts[at - commands] : 0;
}

/* One command with its numbers. */
static void
pen_draw (QnSvgPen *pen, char command, gboolean relative, const double *n)
{
  QnVec2 mirrored = qn_vec2_sub (qn_vec2_scale (2, pen->at), pen->handle);
  QnVec2 control[3], end = pen->at;
  if (pen->path == NULL)
    qn_svg_pen_move (pen, pen->at);
  switch (command) {
  case 'L':
  case 'H':
  case 'V':
    if (command != 'V')
      end.x = relative ? end.x + n[0] : n[0];
    if (command != 'H')
      end.y = relative ? end.y + n[command == 'L'] : n[command == 'L'];
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

gboolean
qn_svg_read_path (QnSvgPen *pen, const char *data)
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
      else if (!qn_svg_next_number (&data, &numbers[i]))
        return FALSE;
    }
    if (upper == 'M') {
      qn_svg_pen_move (pen, pen_point (pen, relative, numbers[0], numbers[1]));
      pen->last = 'M';
      command = relative ? 'l' : 'L';
    } else {
      pen_draw (pen, upper, relative, numbers);
    }
  }
}

gboolean
qn_svg_read_points (QnSvgPen *pen, const char *text, gboolean closed)
{
  double x, y;
  gboolean first = TRUE;
  while (text != NULL && qn_svg_next_number (&text, &x)) {
    if (!qn_svg_next_number (&text, &y))
      return FALSE;
    if (first)
      qn_svg_pen_move (pen, qn_vec2 (x, y));
    else
      qn_drawing_path_add (pen->path, qn_vec2 (x, y));
    first = FALSE;
  }
  if (pen->path != NULL)
    pen->path->closed = closed;
  return text == NULL || *text == '\0';
}
