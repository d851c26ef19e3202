#include "io/exchange/dxf-scan.h"
#include "core/base/integer.h"
#include "io/text/io-error.h"

#include <glib/gi18n-lib.h>
#include <string.h>

typedef struct Pair {
  int code;
  const char *value; /* borrowed */
} Pair;

typedef struct Scanner {
  char *cursor; /* behind the last line that was read; NULL at the end */
  const char *name;
  guint line;
  QnDrawing *drawing;
  QnDxfScan *scan;
  GArray *pairs; /* of the entity at hand */
  guint entity_line;
  char type[32]; /* of the entity at hand, "" between them */
  enum { OUTSIDE, HEADER, TABLES, BLOCKS, ENTITIES, OTHER } section;
  gboolean in_polyline;
  QnDxfBlock *block; /* that is open, or NULL */
  gboolean insunits; /* the next value is that of $INSUNITS */
  GError **error;
} Scanner;

/* Where the encoding must stand; bytes. */
#define HEADER_SIZE 65536

/* Numbers of $INSUNITS. */
static const struct {
  double metres;
  int code;
} units[] = {
  { 1, 6 },      { 0.001, 4 }, { 0.01, 5 },     { 0.1, 14 },          { 0.0254, 1 },
  { 0.3048, 2 }, { 1000, 7 },  { 0.9144, 10 },  { 1200. / 3937, 21 }, { 100. / 3937, 22 },
  { 10, 15 },    { 100, 16 },  { 1609.344, 3 }, { 2.54e-8, 8 },       { 2.54e-5, 9 },
  { 1e-6, 13 }
};

int
qn_dxf_unit_code (double metres)
{
  for (gsize i = 0; i < G_N_ELEMENTS (units); i++)
    if (units[i].metres == metres)
      return units[i].code;
  return 0;
}

/* Metres per unit; 0: unknown or none. */
static double
declared_unit (int code)
{
  for (gsize i = 0; i < G_N_ELEMENTS (units); i++)
    if (units[i].code == code)
      return units[i].metres;
  return 0;
}

static gboolean
fail (Scanner *scanner, guint line, const char *message)
{
  return qn_io_fail (scanner->error, QN_IO_ERROR_INVALID, "%s:%u: %s", scanner->name,
                     line, message);
}

/* The next line without its end and surrounding blanks; NULL at the end of the file. */
static char *
next_line (Scanner *scanner)
{
  char *line = scanner->cursor;
  if (line == NULL || *line == '\0')
    return NULL;
  scanner->cursor = strchr (line, '\n');
  if (scanner->cursor != NULL)
    *scanner->cursor++ = '\0';
  scanner->line++;
  return g_strstrip (line);
}

static gboolean
parse_number (const char *text, double *number)
{
  char *end;
  *number = g_ascii_strtod (text, &end);
  return *text != '\0' && *end == '\0' && fabs (*number) <= QN_DRAWING_LARGEST;
}

static gboolean
parse_integer (const char *text, int *number)
{
  char *end;
  gint64 value = g_ascii_strtoll (text, &end, 10);
  *number = (int) CLAMP (value, G_MININT, G_MAXINT);
  return *text != '\0' && *end == '\0' && *number == value;
}

static gboolean
is (const Pair *pair, const char *text)
{
  return strcmp (pair->value, text) == 0;
}

static const Pair *
find (const Scanner *scanner, int code)
{
  for (guint i = 0; i < scanner->pairs->len; i++) {
    const Pair *pair = &g_array_index (scanner->pairs, Pair, i);
    if (pair->code == code)
      return pair;
  }
  return NULL;
}

static int
find_integer (const Scanner *scanner, int code)
{
  const Pair *pair = find (scanner, code);
  int number = 0;
  return pair != NULL && parse_integer (pair->value, &number) ? number : 0;
}

static double
number_at (const Scanner *scanner, int code, double otherwise)
{
  const Pair *pair = find (scanner, code);
  double number;
  return pair != NULL && parse_number (pair->value, &number) ? number : otherwise;
}

/* A string in UTF-8, kept by the drawing: \U+00D6 is a character by its number. */
static const char *
keep_text (const Scanner *scanner, const Pair *pair, gboolean lower)
{
  g_autoptr (GString) text = g_string_new (NULL);
  for (const char *c = pair->value; *c != '\0'; c++) {
    gunichar number = 0;
    int digits = 0;
    for (; g_str_has_prefix (c, "\\U+") && digits < 4 && g_ascii_isxdigit (c[3 + digits]);
         digits++)
      number = 16 * number + (gunichar) g_ascii_xdigit_value (c[3 + digits]);
    if (digits == 4 && number > 0 && g_unichar_validate (number)) {
      g_string_append_unichar (text, number);
      c += 6;
    } else {
      g_string_append_c (text, *c);
    }
  }
  g_autofree char *valid = g_utf8_make_valid (text->str, (gssize) text->len);
  g_autofree char *folded = lower ? g_utf8_strdown (valid, -1) : NULL;
  return qn_drawing_keep_string (scanner->drawing, lower ? folded : valid);
}

static void
note (const Scanner *scanner, const char *text)
{
  qn_drawing_note (scanner->drawing, text, scanner->entity_line);
}

static gboolean
is_real_code (int code)
{
  return (code >= 10 && code <= 59) || (code >= 210 && code <= 239);
}

static void
add_point (Scanner *scanner, QnDxfEntity *entity, double x, double y, double z,
           double extra)
{
  QnDxfPoint point = { x, y, z, extra };
  g_array_append_val (scanner->scan->points, point);
  entity->point_count++;
}

/* The point of the group codes 10, 11, 12 … with 20, 30 and so on. */
static void
take_point (Scanner *scanner, QnDxfEntity *entity, int code)
{
  add_point (scanner, entity, number_at (scanner, code, 0),
             number_at (scanner, code + 10, 0), number_at (scanner, code + 20, 0), 0);
}

/* A coordinate of a list of points, one after the other, or the bulge of the last one. */
static void
take_coordinate (Scanner *scanner, QnDxfEntity *entity, int code, double number, double z)
{
  GArray *points = scanner->scan->points;
  QnDxfPoint *last =
    entity->point_count > 0 ? &g_array_index (points, QnDxfPoint, points->len - 1) : NULL;
  if (code == 10)
    add_point (scanner, entity, number, 0, z, entity->kind == QN_DXF_SPLINE);
  else if (code == 20 && last != NULL)
    last->y = number;
  else if (code == 30 && last != NULL)
    last->z = number;
  else if (code == 42 && last != NULL && entity->kind != QN_DXF_SPLINE)
    last->extra = number;
}

/* Points with what belongs to each: bulges (42) or, in their order, weights. */
static void
take_points (Scanner *scanner, QnDxfEntity *entity, double z)
{
  gboolean spline = entity->kind == QN_DXF_SPLINE;
  for (guint i = 0; i < scanner->pairs->len; i++) {
    const Pair *pair = &g_array_index (scanner->pairs, Pair, i);
    double number;
    if (!is_real_code (pair->code) || !parse_number (pair->value, &number))
      continue;
    take_coordinate (scanner, entity, pair->code, number, z);
    if (pair->code == 40 && spline)
      g_array_append_val (scanner->scan->knots, number);
  }
  entity->knot_count = scanner->scan->knots->len - entity->first_knot;
  /* Weights may stand before the points. */
  for (guint i = 0, k = 0; spline && i < scanner->pairs->len; i++) {
    const Pair *pair = &g_array_index (scanner->pairs, Pair, i);
    double number;
    if (pair->code == 41 && k < entity->point_count
        && parse_number (pair->value, &number))
      g_array_index (scanner->scan->points, QnDxfPoint, entity->first_point + k++).extra =
        number != 0 ? number : 1;
  }
}

/* An entity that begins with the points and knots that follow. */
static QnDxfEntity
begin_entity (Scanner *scanner, QnDxfKind kind)
{
  const Pair *layer = find (scanner, 8);
  return (
    QnDxfEntity){ .kind = kind,
                  .layer = layer != NULL ? keep_text (scanner, layer, FALSE)
                                         : qn_drawing_keep_string (scanner->drawing, "0"),
                  .line = scanner->entity_line,
                  .in_plane = TRUE,
                  .invisible = find_integer (scanner, 60) == 1,
                  .normal = { number_at (scanner, 210, 0), number_at (scanner, 220, 0),
                              number_at (scanner, 230, 1) },
                  .first_point = scanner->scan->points->len,
                  .first_knot = scanner->scan->knots->len };
}

static void
keep_entity (Scanner *scanner, QnDxfEntity *entity)
{
  entity->outside = scanner->block == NULL && scanner->section == ENTITIES;
  g_array_append_val (scanner->scan->entities, *entity);
  if (scanner->block != NULL)
    scanner->block->end = scanner->scan->entities->len;
}

/* The boundaries of a hatch (92 begins one, 97 or 75 ends it), polylines or edges (72 begins one);
 * those with edges that are neither lines nor arcs are left out. */
static void
take_hatch (Scanner *scanner)
{
  QnDxfEntity loop = begin_entity (scanner, QN_DXF_HATCH);
  double z = number_at (scanner, 30, 0), n[8] = { 0 };
  int edge = 0; /* kind of the one at hand; -1 in a polyline */
  guint before = scanner->scan->entities->len;
  gboolean open = FALSE; /* in a boundary */
  gboolean odd = FALSE;  /* it has an edge that cannot be read */
  for (guint i = 0; i <= scanner->pairs->len; i++) {
    const Pair *pair =
      i < scanner->pairs->len ? &g_array_index (scanner->pairs, Pair, i) : NULL;
    int code = pair != NULL ? pair->code : 75;
    double number = 0;
    if (pair != NULL && !parse_number (pair->value, &number))
      continue;
    if (open && edge > 0 && (code == 72 || code == 92 || code == 97 || code == 75)) {
      if (edge == 1) {
        add_point (scanner, &loop, n[0], n[1], z, 0);
      } else if (edge == 2) {
        double turn = n[6] != 0 ? 1 : -1, from = turn * n[4] * G_PI / 180,
               to = turn * n[5] * G_PI / 180;
        double middle = 0.5 * (from + to), bulge = tan ((to - from) / 8);
        add_point (scanner, &loop, n[0] + n[3] * cos (from), n[1] + n[3] * sin (from), z,
                   bulge);
        add_point (scanner, &loop, n[0] + n[3] * cos (middle), n[1] + n[3] * sin (middle),
                   z, bulge);
      } else {
        odd = TRUE;
      }
      edge = 0;
    }
    if (code == 92 || code == 97 || code == 75) {
      loop.numbers[0] = scanner->scan->entities->len == before;
      if (open && !odd && loop.point_count >= 2)
        keep_entity (scanner, &loop);
      else if (open && odd)
        note (scanner, _ ("boundaries of hatches with ellipses or splines left out"));
      open = code == 92;
      odd = FALSE;
      loop = begin_entity (scanner, QN_DXF_HATCH);
      loop.closed = TRUE;
      if (code == 75) {
        if (scanner->scan->entities->len == before)
          note (scanner, _ ("hatches without a boundary that can be read left out"));
        return;
      }
      edge = (qn_to_integer (number, 0, G_MAXINT) & 2) != 0 ? -1 : 0;
    } else if (open && edge < 0) { /* a polyline */
      take_coordinate (scanner, &loop, code, number, z);
    } else if (open && code == 72) {
      edge = (int) qn_to_integer (number, 1, 5);
      memset (n, 0, sizeof n);
    } else if (open && edge > 0) {
      static const int codes[] = { 10, 20, 11, 40, 50, 51, 73 };
      for (gsize k = 0; k < G_N_ELEMENTS (codes); k++)
        if (codes[k] == code)
          n[k] = number;
    }
  }
}

static void
take_block (Scanner *scanner)
{
  const Pair *name = find (scanner, 2);
  guint next = scanner->scan->entities->len;
  scanner->block = NULL;
  if (name == NULL)
    return;
  scanner->block = g_new (QnDxfBlock, 1);
  *scanner->block =
    (QnDxfBlock){ { number_at (scanner, 10, 0), number_at (scanner, 20, 0),
                    number_at (scanner, 30, 0) },
                  next,
                  next };
  g_hash_table_replace (scanner->scan->blocks, (char *) keep_text (scanner, name, TRUE),
                        scanner->block);
}

/* The entities whose points have a group code each. */
static void
take_simple (Scanner *scanner)
{
  static const struct {
    const char *type;
    QnDxfKind kind;
    gboolean in_plane;
    int points[4], numbers[3]; /* group codes */
  } simple[] = {
    { "LINE", QN_DXF_LINE, FALSE, { 10, 11 }, { 0 } },
    { "ARC", QN_DXF_ARC, TRUE, { 10 }, { 40, 50, 51 } },
    { "CIRCLE", QN_DXF_ARC, TRUE, { 10 }, { 40 } },
    { "ELLIPSE", QN_DXF_ELLIPSE, FALSE, { 10, 11 }, { 40, 41, 42 } },
    /* Corners of these two cross over. */
    { "SOLID", QN_DXF_FACE, TRUE, { 10, 11, 13, 12 }, { 0 } },
    { "TRACE", QN_DXF_FACE, TRUE, { 10, 11, 13, 12 }, { 0 } },
    { "3DFACE", QN_DXF_FACE, FALSE, { 10, 11, 12, 13 }, { 0 } },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (simple); i++) {
    if (strcmp (scanner->type, simple[i].type) != 0)
      continue;
    QnDxfEntity entity = begin_entity (scanner, simple[i].kind);
    entity.in_plane = simple[i].in_plane;
    entity.closed = simple[i].kind == QN_DXF_FACE;
    for (int k = 0; k < 4 && simple[i].points[k] != 0; k++)
      if (k == 0 || find (scanner, simple[i].points[k]) != NULL)
        take_point (scanner, &entity, simple[i].points[k]);
    for (int k = 0; k < 3 && simple[i].numbers[k] != 0; k++)
      entity.numbers[k] = number_at (scanner, simple[i].numbers[k], 0);
    if (scanner->type[0] == 'C')
      entity.numbers[2] = 360;
    if (entity.point_count >= (entity.kind == QN_DXF_ARC ? 1 : 2))
      keep_entity (scanner, &entity);
    return;
  }
  /* Entities that nobody takes for a part of the structure. */
  static const char *const annotations[] = {
    "TEXT",        "MTEXT",   "DIMENSION", "LEADER",     "ATTRIB", "ATTDEF",
    "MULTILEADER", "MLEADER", "TOLERANCE", "VIEWPORT",   "POINT",  "IMAGE",
    "WIPEOUT",     "RAY",     "XLINE",     "ACAD_TABLE", NULL
  };
  g_autofree char *text = g_strdup_printf (_ ("%s entities left out"), scanner->type);
  QnDrawingNote *left_out =
    qn_drawing_note (scanner->drawing, text, scanner->entity_line);
  left_out->minor = g_strv_contains (annotations, scanner->type);
}

/* Polylines of both kinds, and splines. */
static void
take_curve (Scanner *scanner)
{
  int flags = find_integer (scanner, 70);
  gboolean spline = strcmp (scanner->type, "SPLINE") == 0;
  gboolean old = strcmp (scanner->type, "POLYLINE") == 0;
  if (old && (flags & (16 | 64))) {
    note (scanner, _ ("three-dimensional meshes left out"));
    return;
  }
  QnDxfEntity entity = begin_entity (scanner, spline ? QN_DXF_SPLINE : QN_DXF_POLYLINE);
  entity.closed = (flags & 1) != 0;
  entity.in_plane = !spline && !(old && (flags & 8));
  entity.numbers[0] = find_integer (scanner, 71);
  if (!old)
    take_points (scanner, &entity, number_at (scanner, 38, 0));
  if (spline && entity.point_count == 0) {
    note (scanner, _ ("splines without control points left out"));
    return;
  }
  keep_entity (scanner, &entity);
  scanner->in_polyline = old;
}

static void
take_vertex (Scanner *scanner)
{
  GArray *entities = scanner->scan->entities;
  QnDxfEntity *polyline = &g_array_index (entities, QnDxfEntity, entities->len - 1);
  if (find_integer (scanner, 70) & 16) /* of the frame of a spline */
    return;
  take_point (scanner, polyline, 10);
  g_array_index (scanner->scan->points, QnDxfPoint, scanner->scan->points->len - 1)
    .extra = number_at (scanner, 42, 0);
}

/* Keeps what the entity at hand says, or counts it, and forgets it. */
static void
finish_entity (Scanner *scanner)
{
  const char *type = scanner->type;
  if (type[0] == '\0')
    return;
  gboolean vertex = strcmp (type, "VERTEX") == 0;
  gboolean in_polyline = scanner->in_polyline;
  scanner->in_polyline = in_polyline && vertex;
  if (scanner->section == TABLES) {
    if (strcmp (type, "LAYER") == 0) {
      const Pair *name = find (scanner, 2);
      int state = (find_integer (scanner, 70) & 1) ? QN_DXF_FROZEN
                  : find_integer (scanner, 62) < 0 ? QN_DXF_OFF
                                                   : 0;
      if (name != NULL && state != 0)
        g_hash_table_insert (scanner->scan->hidden,
                             (char *) keep_text (scanner, name, TRUE),
                             GINT_TO_POINTER (state));
    }
  } else if (strcmp (type, "BLOCK") == 0) {
    take_block (scanner);
  } else if (strcmp (type, "ENDBLK") == 0) {
    scanner->block = NULL;
  } else if (vertex) {
    if (in_polyline)
      take_vertex (scanner);
  } else if (strcmp (type, "SEQEND") == 0) {
    scanner->in_polyline = FALSE;
  } else if (find_integer (scanner, 67) == 1) {
    note (scanner, _ ("entities in paper space left out"));
  } else if (strcmp (type, "INSERT") == 0) {
    static const int codes[] = { 41, 42, 43, 50, 70, 71, 44, 45 };
    QnDxfEntity insert = begin_entity (scanner, QN_DXF_INSERT);
    const Pair *name = find (scanner, 2);
    for (gsize k = 0; k < G_N_ELEMENTS (codes); k++)
      insert.numbers[k] = number_at (scanner, codes[k], k < 3);
    insert.name = name != NULL ? keep_text (scanner, name, TRUE) : NULL;
    take_point (scanner, &insert, 10);
    keep_entity (scanner, &insert);
  } else if (strcmp (type, "HATCH") == 0) {
    take_hatch (scanner);
  } else if (strcmp (type, "LWPOLYLINE") == 0 || strcmp (type, "POLYLINE") == 0
             || strcmp (type, "SPLINE") == 0) {
    take_curve (scanner);
  } else {
    take_simple (scanner);
  }
  scanner->type[0] = '\0';
  g_array_set_size (scanner->pairs, 0);
}

/* What is quoted of a line. */
static char *
dup_beginning (const char *line)
{
  return g_utf8_make_valid (line, (gssize) MIN (strlen (line), 40));
}

static gboolean
take_pair (Scanner *scanner, const Pair *pair)
{
  double number;
  if (pair->code == 0) {
    /* A pair with code 0 ends what was before it. */
    finish_entity (scanner);
    gboolean drawn = scanner->section >= TABLES && scanner->section <= ENTITIES;
    if (is (pair, "SECTION")) {
      scanner->section = OUTSIDE;
    } else if (is (pair, "ENDSEC")) {
      scanner->section = OTHER;
      scanner->block = NULL;
    } else if (drawn) {
      g_strlcpy (scanner->type, pair->value, sizeof scanner->type);
      for (char *c = scanner->type; *c != '\0'; c++)
        *c = g_ascii_isgraph (*c) ? *c : '?';
      scanner->entity_line = scanner->line - 1;
    }
  } else if (scanner->section == OUTSIDE && pair->code == 2) {
    scanner->section = is (pair, "HEADER")     ? HEADER
                       : is (pair, "TABLES")   ? TABLES
                       : is (pair, "BLOCKS")   ? BLOCKS
                       : is (pair, "ENTITIES") ? ENTITIES
                                               : OTHER;
  } else if (scanner->section == HEADER) {
    int code;
    if (pair->code == 9)
      scanner->insunits = is (pair, "$INSUNITS");
    else if (scanner->insunits && pair->code == 70 && parse_integer (pair->value, &code))
      scanner->drawing->unit = declared_unit (code);
  } else if (scanner->type[0] != '\0') {
    if (scanner->section != TABLES && is_real_code (pair->code)
        && !parse_number (pair->value, &number)) {
      g_autofree char *value = dup_beginning (pair->value);
      g_autofree char *message =
        g_strdup_printf (_ ("expected a coordinate or length, found \"%s\""), value);
      return fail (scanner, scanner->line, message);
    }
    g_array_append_val (scanner->pairs, *pair);
  }
  return TRUE;
}

static gboolean
scan_pairs (Scanner *scanner)
{
  gboolean ended = FALSE, any = FALSE;
  for (const char *text; !ended && (text = next_line (scanner)) != NULL;) {
    Pair pair;
    if (*text == '\0' && (scanner->cursor == NULL || *scanner->cursor == '\0'))
      break;
    if (!parse_integer (text, &pair.code)) {
      g_autofree char *found = dup_beginning (text);
      g_autofree char *message = g_strdup_printf (
        any ? _ ("expected a group code, found \"%s\"")
            : _ ("this is not a DXF file: expected a group code, found \"%s\""),
        g_strdelimit (found, "\r\n", ' '));
      return fail (scanner, scanner->line, message);
    }
    if ((pair.value = next_line (scanner)) == NULL)
      return fail (scanner, scanner->line, _ ("the file ends after a group code"));
    ended = pair.code == 0 && is (&pair, "EOF");
    any = TRUE;
    if (!take_pair (scanner, &pair))
      return FALSE;
  }
  finish_entity (scanner);
  if (!any)
    return fail (scanner, 1, _ ("the file is empty"));
  if (!ended)
    qn_drawing_note (scanner->drawing, _ ("file ends without its EOF mark"),
                     scanner->line);
  return TRUE;
}

gboolean
qn_dxf_scan (char *text, const char *name, QnDrawing *drawing, QnDxfScan *scan,
             GError **error)
{
  /* Points and knots are pointed to where there are none, too. */
  *scan =
    (QnDxfScan){ .entities = g_array_new (FALSE, FALSE, sizeof (QnDxfEntity)),
                 .points = g_array_sized_new (FALSE, FALSE, sizeof (QnDxfPoint), 1),
                 .knots = g_array_sized_new (FALSE, FALSE, sizeof (double), 1),
                 .blocks = g_hash_table_new_full (g_str_hash, g_str_equal, NULL, g_free),
                 .hidden = g_hash_table_new (g_str_hash, g_str_equal) };
  Scanner scanner = { .cursor = text,
                      .name = name,
                      .drawing = drawing,
                      .scan = scan,
                      .section = OTHER,
                      .pairs = g_array_new (FALSE, FALSE, sizeof (Pair)),
                      .error = error };
  gboolean done;
  if (g_str_has_prefix (text, "AutoCAD Binary DXF"))
    done = fail (&scanner, 1, _ ("binary DXF; save it as text (ASCII)"));
  else if (g_str_has_prefix (text, "AC10"))
    done = fail (&scanner, 1, _ ("a DWG file; save it as DXF"));
  else
    done = scan_pairs (&scanner);
  g_array_unref (scanner.pairs);
  if (!done)
    qn_dxf_scan_clear (scan);
  return done;
}

void
qn_dxf_scan_clear (QnDxfScan *scan)
{
  g_array_unref (scan->entities);
  g_array_unref (scan->points);
  g_array_unref (scan->knots);
  g_hash_table_unref (scan->blocks);
  g_hash_table_unref (scan->hidden);
}

char *
qn_dxf_dup_charset (const char *bytes, gsize size)
{
  const char *at = g_strstr_len (bytes, (gssize) MIN (size, HEADER_SIZE), "$DWGCODEPAGE");
  for (int line = 0; line < 2 && at != NULL; line++) {
    gsize left = (gsize) (bytes + size - at);
    gsize end = 0;
    while (end < left && at[end] != '\n' && at[end] != '\r')
      end++;
    while (end < left && g_ascii_isspace (at[end]))
      end++;
    at = end < left ? at + end : NULL;
  }
  if (at == NULL)
    return NULL;
  g_autofree char *stated = g_strndup (at, strcspn (at, " \t\r\n"));
  static const char *const names[][2] = { { "mac-roman", "MACINTOSH" },
                                          { "ascii", "CP437" }, /* of DOS */
                                          { "gb2312", "CP936" } };
  for (gsize i = 0; i < G_N_ELEMENTS (names); i++)
    if (g_ascii_strcasecmp (stated, names[i][0]) == 0)
      return g_strdup (names[i][1]);
  const char *number = strpbrk (stated, "0123456789");
  gboolean page = g_ascii_strncasecmp (stated, "ANSI_", 5) == 0
                  || g_ascii_strncasecmp (stated, "DOS", 3) == 0;
  return page && number != NULL ? g_strconcat ("CP", number, NULL)
                                : g_steal_pointer (&stated);
}
