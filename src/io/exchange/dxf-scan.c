#include "io/exchange/dxf-scan.h"
#include "io/text/io-error.h"

#include <glib/gi18n-lib.h>
#include <string.h>

typedef struct Pair {
  int code;
  const char *value; /* borrowed, not NUL-terminated */
  gsize length;
} Pair;

typedef struct Scanner {
  const char *cursor, *end, *name;
  guint line;
  QnDrawing *drawing;
  QnDxfScan *scan;
  GArray *pairs; /* of the entity at hand */
  guint entity_line;
  char type[32]; /* of the entity at hand, "" between them */
  enum { OUTSIDE, HEADER, BLOCKS, ENTITIES, OTHER } section;
  gboolean in_polyline;
  gboolean insunits; /* the next value is that of $INSUNITS */
  GError **error;
} Scanner;

/* Numbers of $INSUNITS. */
static const struct {
  double metres;
  int code;
} units[] = { { 1, 6 },      { 0.001, 4 },  { 0.01, 5 }, { 0.1, 14 },
              { 0.0254, 1 }, { 0.3048, 2 }, { 1000, 7 }, { 0.9144, 10 } };

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

static const char *const kept_types[] = { "LINE",   "LWPOLYLINE", "POLYLINE", "VERTEX",
                                          "SEQEND", "ARC",        "CIRCLE",   "ELLIPSE",
                                          "SPLINE", "INSERT",     "SOLID",    "TRACE",
                                          "BLOCK",  "ENDBLK" };

static gboolean
fail (Scanner *scanner, guint line, const char *message)
{
  g_set_error (scanner->error, QN_IO_ERROR, QN_IO_ERROR_INVALID, "%s:%u: %s",
               scanner->name, line, message);
  return FALSE;
}

/* The next line without its end and surrounding blanks; FALSE at the end of the file. */
static gboolean
next_line (Scanner *scanner, const char **start, gsize *length)
{
  if (scanner->cursor >= scanner->end)
    return FALSE;
  const char *begin = scanner->cursor;
  const char *stop = memchr (begin, '\n', (gsize) (scanner->end - begin));
  scanner->cursor = stop != NULL ? stop + 1 : scanner->end;
  if (stop == NULL)
    stop = scanner->end;
  while (begin < stop && g_ascii_isspace (*begin))
    begin++;
  while (stop > begin && g_ascii_isspace (stop[-1]))
    stop--;
  *start = begin;
  *length = (gsize) (stop - begin);
  scanner->line++;
  return TRUE;
}

static gboolean
parse_integer (const char *text, gsize length, int *number)
{
  char buffer[16], *end;
  if (length == 0 || length >= sizeof buffer)
    return FALSE;
  memcpy (buffer, text, length);
  buffer[length] = '\0';
  gint64 value = g_ascii_strtoll (buffer, &end, 10);
  if (*end != '\0' || value < G_MININT || value > G_MAXINT)
    return FALSE;
  *number = (int) value;
  return TRUE;
}

static gboolean
parse_number (const Pair *pair, double *number)
{
  char buffer[64], *end;
  if (pair->length == 0 || pair->length >= sizeof buffer)
    return FALSE;
  memcpy (buffer, pair->value, pair->length);
  buffer[pair->length] = '\0';
  *number = g_ascii_strtod (buffer, &end);
  return *end == '\0' && fabs (*number) <= QN_DRAWING_LARGEST;
}

static gboolean
is (const Pair *pair, const char *text)
{
  return pair->length == strlen (text) && memcmp (pair->value, text, pair->length) == 0;
}

static void
emit (Scanner *scanner, int code, const char *value, gsize length)
{
  g_string_append_printf (scanner->scan->text, "%d\n", code);
  g_string_append_len (scanner->scan->text, value, (gssize) length);
  g_string_append_c (scanner->scan->text, '\n');
}

static void
emit_count (Scanner *scanner, int code, guint count)
{
  g_string_append_printf (scanner->scan->text, "%d\n%u\n", code, count);
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
  if (pair != NULL)
    parse_integer (pair->value, pair->length, &number);
  return number;
}

static QnVec2
place_of (const Scanner *scanner)
{
  QnVec2 at = { NAN, NAN };
  const Pair *x = find (scanner, 10), *y = find (scanner, 20);
  if (x != NULL && y != NULL && !(parse_number (x, &at.x) && parse_number (y, &at.y)))
    at = qn_vec2 (NAN, NAN);
  return at;
}

static void
note (const Scanner *scanner, const char *text)
{
  qn_drawing_note (scanner->drawing, text, scanner->entity_line, place_of (scanner));
}

static gboolean
is_real_code (int code)
{
  return (code >= 10 && code <= 59) || (code >= 210 && code <= 239);
}

/* Whether a pair says something about the shape of the entity at hand. */
static gboolean
is_shape_code (const Scanner *scanner, int code)
{
  if (code == 2)
    return TRUE;
  if (strcmp (scanner->type, "LWPOLYLINE") == 0)
    return code == 10 || code == 20 || code == 42 || code == 70 || code / 10 == 21
           || code == 220 || code == 230;
  if (strcmp (scanner->type, "SPLINE") == 0)
    return code == 10 || code == 20 || code == 30 || code == 40 || code == 41
           || code == 70 || code == 71;
  return (code >= 10 && code <= 14) || (code >= 20 && code <= 24)
         || (code >= 30 && code <= 34) || (code >= 40 && code <= 45) || code == 50
         || code == 51 || (code >= 70 && code <= 72) || code == 210 || code == 220
         || code == 230;
}

static guint
count_code (const Scanner *scanner, int code)
{
  guint count = 0;
  for (guint i = 0; i < scanner->pairs->len; i++)
    count += g_array_index (scanner->pairs, Pair, i).code == code;
  return count;
}

/* Whether the entity at hand is an outline that we can use; what is not is counted. */
static gboolean
is_wanted (Scanner *scanner)
{
  const char *type = scanner->type;
  gboolean kept = FALSE;
  for (gsize i = 0; i < G_N_ELEMENTS (kept_types); i++)
    kept = kept || strcmp (kept_types[i], type) == 0;
  if (strcmp (type, "VERTEX") == 0)
    return scanner->in_polyline && !(find_integer (scanner, 70) & 16);
  if (strcmp (type, "SEQEND") == 0)
    return scanner->in_polyline;
  if (!kept) {
    /* Attributes of inserts are text like any other. */
    g_autofree char *text = g_strdup_printf (_ ("%s entities left out"), type);
    note (scanner, text);
    return FALSE;
  }
  if (find_integer (scanner, 67) == 1) {
    note (scanner, _ ("entities in paper space left out"));
    return FALSE;
  }
  if (strcmp (type, "POLYLINE") == 0 && (find_integer (scanner, 70) & (16 | 64))) {
    note (scanner, _ ("three-dimensional meshes left out"));
    return FALSE;
  }
  if (strcmp (type, "SPLINE") == 0 && count_code (scanner, 10) == 0) {
    note (scanner, _ ("splines without control points left out"));
    return FALSE;
  }
  return TRUE;
}

/* Passes the entity at hand on, or not, and forgets it. */
static void
finish_entity (Scanner *scanner)
{
  const char *type = scanner->type;
  if (type[0] == '\0')
    return;
  gboolean wanted = is_wanted (scanner);
  if (strcmp (type, "POLYLINE") == 0)
    scanner->in_polyline = wanted;
  else if (strcmp (type, "VERTEX") != 0)
    scanner->in_polyline = FALSE;
  if (wanted) {
    const Pair *layer = find (scanner, 8);
    g_autofree char *layer_name =
      layer != NULL ? g_utf8_make_valid (layer->value, (gssize) layer->length) : NULL;
    QnDxfSource source = { qn_drawing_keep_string (scanner->drawing,
                                                   layer_name != NULL ? layer_name : "0"),
                           scanner->entity_line };
    emit (scanner, 0, type, strlen (type));
    emit_count (scanner, 8, scanner->scan->sources->len);
    g_array_append_val (scanner->scan->sources, source);
    /* Counts as they are, not as the file claims. */
    if (strcmp (scanner->type, "LWPOLYLINE") == 0) {
      emit_count (scanner, 90, count_code (scanner, 10));
    } else if (strcmp (scanner->type, "SPLINE") == 0) {
      emit_count (scanner, 72, count_code (scanner, 40));
      emit_count (scanner, 73, count_code (scanner, 10));
      emit_count (scanner, 74, 0);
    }
    for (guint i = 0; i < scanner->pairs->len; i++) {
      const Pair *pair = &g_array_index (scanner->pairs, Pair, i);
      if (is_shape_code (scanner, pair->code))
        emit (scanner, pair->code, pair->value, pair->length);
    }
  }
  scanner->type[0] = '\0';
  g_array_set_size (scanner->pairs, 0);
}

/* A pair with code 0 ends what was before it. */
static void
begin_thing (Scanner *scanner, const Pair *pair)
{
  finish_entity (scanner);
  gboolean drawn = scanner->section == BLOCKS || scanner->section == ENTITIES;
  if (is (pair, "SECTION")) {
    scanner->section = OUTSIDE;
  } else if (is (pair, "ENDSEC")) {
    if (drawn)
      emit (scanner, 0, "ENDSEC", 6);
    scanner->section = OTHER;
  } else if (drawn && pair->length > 0) {
    g_strlcpy (scanner->type, "", sizeof scanner->type);
    gsize length = MIN (pair->length, sizeof scanner->type - 1);
    for (gsize i = 0; i < length; i++)
      scanner->type[i] = g_ascii_isgraph (pair->value[i]) ? pair->value[i] : '?';
    scanner->type[length] = '\0';
    scanner->entity_line = scanner->line - 1;
  }
}

static gboolean
take_pair (Scanner *scanner, const Pair *pair)
{
  double number;
  if (pair->code == 0) {
    begin_thing (scanner, pair);
  } else if (scanner->section == OUTSIDE && pair->code == 2) {
    scanner->section = is (pair, "HEADER")     ? HEADER
                       : is (pair, "BLOCKS")   ? BLOCKS
                       : is (pair, "ENTITIES") ? ENTITIES
                                               : OTHER;
    if (scanner->section == BLOCKS || scanner->section == ENTITIES) {
      emit (scanner, 0, "SECTION", 7);
      emit (scanner, 2, pair->value, pair->length);
    }
  } else if (scanner->section == HEADER) {
    int code;
    if (pair->code == 9)
      scanner->insunits = is (pair, "$INSUNITS");
    else if (scanner->insunits && pair->code == 70
             && parse_integer (pair->value, pair->length, &code))
      scanner->drawing->unit = declared_unit (code);
  } else if (scanner->type[0] != '\0') {
    if (is_real_code (pair->code) && !parse_number (pair, &number)) {
      g_autofree char *value =
        g_utf8_make_valid (pair->value, (gssize) MIN (pair->length, 40));
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
  const char *text;
  gsize length;
  gboolean ended = FALSE, any = FALSE;
  while (!ended && next_line (scanner, &text, &length)) {
    Pair pair;
    if (length == 0 && scanner->cursor >= scanner->end)
      break;
    if (!parse_integer (text, length, &pair.code)) {
      g_autofree char *found = g_utf8_make_valid (text, (gssize) MIN (length, 40));
      g_autofree char *message = g_strdup_printf (
        any ? _ ("expected a group code, found \"%s\"")
            : _ ("this is not a DXF file: expected a group code, found \"%s\""),
        g_strdelimit (found, "\r\n", ' '));
      return fail (scanner, scanner->line, message);
    }
    if (!next_line (scanner, &pair.value, &pair.length))
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
                     scanner->line, qn_vec2 (NAN, NAN));
  emit (scanner, 0, "EOF", 3);
  return TRUE;
}

gboolean
qn_dxf_scan (const char *text, gsize length, const char *name, QnDrawing *drawing,
             QnDxfScan *scan, GError **error)
{
  static const char binary[] = "AutoCAD Binary DXF";
  *scan = (QnDxfScan){ g_string_sized_new (length / 2 + 64),
                       g_array_new (FALSE, FALSE, sizeof (QnDxfSource)) };
  Scanner scanner = { .cursor = text,
                      .end = text + length,
                      .name = name,
                      .drawing = drawing,
                      .scan = scan,
                      .section = OTHER,
                      .pairs = g_array_new (FALSE, FALSE, sizeof (Pair)),
                      .error = error };
  gboolean done;
  if (length >= strlen (binary) && memcmp (text, binary, strlen (binary)) == 0)
    done = fail (&scanner, 1, _ ("binary DXF; save it as text (ASCII)"));
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
  if (scan->text != NULL)
    g_string_free (scan->text, TRUE);
  g_clear_pointer (&scan->sources, g_array_unref);
  scan->text = NULL;
}
