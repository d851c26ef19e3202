#include "render/backend/output.h"

#include "core/base/integer.h"
#include "disk/whole-file.h"
#include "render/backend/offscreen.h"
#include "render/drawing/text.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>
#include <zlib.h>

#define MAX_SIDE    32000.0
#define MAX_AREA    268435456.0 /* px; four bytes each */
#define MM_PER_INCH 25.4

/* Pixel pictures without dpi are drawn as if they were to be printed this wide in points: the
 * text of a picture keeps its share of the picture whatever its number of pixels. */
#define NOMINAL_WIDTH_PT 520.0

void
qn_output_init (QnOutput *output)
{
  *output = (QnOutput){ .width = 1600, .height = 1200 };
}

void
qn_metadata_init (QnMetadata *metadata)
{
  *metadata = (QnMetadata){ .multiplier = (double) NAN };
}

/* A positive number with its unit; returns the text after it or NULL. */
static const char *
parse_length (const char *text, double *value, bool *millimetres)
{
  /* Cut out first: "0x600" is no hexadecimal number here. */
  size_t length = strspn (text, "0123456789.+-eE");
  g_autofree char *number = g_strndup (text, length);
  const char *end = text + length;
  char *rest;
  *value = g_ascii_strtod (number, &rest);
  if (length == 0 || *rest != '\0' || !isfinite (*value))
    return NULL;
  *millimetres = g_str_has_prefix (end, "mm");
  return *millimetres ? end + 2 : g_str_has_prefix (end, "px") ? end + 2 : end;
}

bool
qn_output_parse_size (QnOutput *output, const char *text, GError **error)
{
  double width, height;
  bool width_mm, height_mm;
  const char *rest = parse_length (text, &width, &width_mm);
  if (rest != NULL)
    rest = *rest == 'x' ? parse_length (rest + 1, &height, &height_mm) : NULL;
  if (rest == NULL || *rest != '\0' || width_mm != height_mm)
    return qn_render_refuse (
      error, _ ("size \"%s\" is neither like 1600x1200 nor like 160mmx120mm"), text);
  output->width = width;
  output->height = height;
  output->millimetres = width_mm;
  return true;
}

bool
qn_format_of_path (const char *path, QnFormat *format, GError **error)
{
  static const char *const endings[] = { ".png", ".svg", ".pdf" };
  /* What cannot keep a name by its ending, such as a device, takes the first format. */
  if (strcmp (path, "-") == 0 || g_str_has_prefix (path, "/dev/")) {
    *format = QN_FORMAT_PNG;
    return true;
  }
  g_autofree char *lower = g_ascii_strdown (path, -1);
  for (size_t i = 0; i < G_N_ELEMENTS (endings); i++) {
    if (g_str_has_suffix (lower, endings[i])) {
      *format = (QnFormat) i;
      return true;
    }
  }
  return qn_render_refuse (error, _ ("%s: a picture's name ends in .png, .svg or .pdf"),
                           path);
}

bool
qn_output_page (const QnOutput *output, QnPage *page, GError **error)
{
  double dpi = output->dpi;
  if (dpi < 0 || !isfinite (dpi) || dpi > 1e5)
    return qn_render_refuse (
      error, _ ("the resolution must be a positive number of dpi, at most 100,000"));
  if (output->millimetres && !(dpi > 0))
    dpi = 300;
  double factor = output->millimetres ? dpi / MM_PER_INCH : 1;
  double width = round (output->width * factor), height = round (output->height * factor);
  if (!(width >= 1) || !(height >= 1))
    return qn_render_refuse (error, _ ("the size of the picture must be positive"));
  if (width > MAX_SIDE || height > MAX_SIDE || width * height > MAX_AREA)
    return qn_render_refuse (
      error, _ ("a picture of %.0f x %.0f px is larger than the program draws"), width,
      height);
  *page = (QnPage){
    .width = width,
    .height = height,
    .unit = dpi > 0 ? dpi / 72 : fmin (width, height * 1.4) / NOMINAL_WIDTH_PT,
    .transparent = output->transparent,
  };
  return true;
}

/* ---- encoders -------------------------------------------------------------------------- */

static double
recorded_dpi (const QnOutput *output)
{
  return output->dpi > 0 ? output->dpi : output->millimetres ? 300 : 96;
}

cairo_surface_t *
qn_page_create_image (const QnPage *page)
{
  return cairo_image_surface_create (CAIRO_FORMAT_ARGB32,
                                     (int) qn_to_integer (page->width, 1, G_MAXINT16),
                                     (int) qn_to_integer (page->height, 1, G_MAXINT16));
}

bool
qn_output_succeeded (cairo_status_t status, GError **error)
{
  if (status != CAIRO_STATUS_SUCCESS)
    g_set_error_literal (error, QN_RENDER_ERROR, QN_RENDER_ERROR_FAILED,
                         cairo_status_to_string (status));
  return status == CAIRO_STATUS_SUCCESS;
}

static bool
draw_page (cairo_t *cr, const QnPage *page, QnPageFunc draw, void *data, GError **error)
{
  if (!page->transparent) {
    cairo_set_source_rgb (cr, 1, 1, 1);
    cairo_paint (cr);
  }
  return draw (cr, page, data, error) && qn_output_succeeded (cairo_status (cr), error);
}

/* Bytes of the signature and of the chunk with the picture's size: what is told of it comes behind. */
#define HEAD 33

static void
append_number (GByteArray *out, guint32 number)
{
  const guint32 big_endian = GUINT32_TO_BE (number);
  g_byte_array_append (out, (const guint8 *) &big_endian, sizeof big_endian);
}

static void
append_chunk (GByteArray *out, const char *type, const GByteArray *content)
{
  append_number (out, content->len);
  const guint start = out->len;
  g_byte_array_append (out, (const guint8 *) type, 4);
  g_byte_array_append (out, content->data, content->len);
  append_number (out, (guint32) crc32 (0, out->data + start, out->len - start));
}

GBytes *
qn_png_encode (cairo_surface_t *surface, double dpi, const QnPngText *texts,
               size_t text_count, GError **error)
{
  g_autoptr (GByteArray) image = g_byte_array_new ();
  if (!qn_output_succeeded (
        cairo_surface_write_to_png_stream (surface, qn_output_append, image), error))
    return NULL;
  GByteArray *out = g_byte_array_sized_new (image->len);
  g_byte_array_append (out, image->data, HEAD);
  if (dpi > 0) {
    static const guint8 in_metres = 1;
    g_autoptr (GByteArray) content = g_byte_array_new ();
    const gint64 per_metre = qn_to_integer (round (dpi / 0.0254), 1, G_MAXINT32);
    append_number (content, (guint32) per_metre);
    append_number (content, (guint32) per_metre);
    g_byte_array_append (content, &in_metres, 1);
    append_chunk (out, "pHYs", content);
  }
  for (size_t i = 0; i < text_count; i++) {
    /* More programs read the older kind of chunk, which holds no UTF-8; the other says,
     * between key and text, that it is not compressed and of no language that is named. */
    static const guint8 nothing[5];
    const bool plain = g_str_is_ascii (texts[i].text);
    g_autoptr (GByteArray) content = g_byte_array_new ();
    g_byte_array_append (content, (const guint8 *) texts[i].key,
                         (guint) strlen (texts[i].key));
    g_byte_array_append (content, nothing, plain ? 1 : sizeof nothing);
    g_byte_array_append (content, (const guint8 *) texts[i].text,
                         (guint) strlen (texts[i].text));
    append_chunk (out, plain ? "tEXt" : "iTXt", content);
  }
  g_byte_array_append (out, image->data + HEAD, image->len - HEAD);
  return g_byte_array_free_to_bytes (out);
}

/* What a file says of itself; texts are borrowed. */
typedef struct Words {
  QnPngText texts[5];
  size_t count;
  char number[G_ASCII_DTOSTR_BUF_SIZE];
} Words;

static void
describe (const QnMetadata *m, Words *words)
{
  const char *number = NULL;
  if (!isnan (m->multiplier))
    number = g_ascii_formatd (words->number, sizeof words->number, "%.6g", m->multiplier);
  const QnPngText all[] = { { "Title", m->title },
                            { "Software", m->generator },
                            { "Source", m->model },
                            { "Model-SHA256", m->model_sha256 },
                            { "Multiplier", number } };
  words->count = 0;
  for (size_t i = 0; i < G_N_ELEMENTS (all); i++)
    if (all[i].text != NULL)
      words->texts[words->count++] = all[i];
}

cairo_status_t
qn_output_append (void *bytes, const unsigned char *data, unsigned int length)
{
  g_byte_array_append (bytes, data, length);
  return CAIRO_STATUS_SUCCESS;
}

void
qn_output_describe_pdf (cairo_surface_t *surface, const QnMetadata *metadata)
{
  Words words;
  g_autoptr (GString) keywords = g_string_new (NULL);
  describe (metadata, &words);
  for (const QnPngText *text = words.texts; text < words.texts + words.count; text++) {
    if (strcmp (text->key, "Title") == 0)
      cairo_pdf_surface_set_metadata (surface, CAIRO_PDF_METADATA_TITLE, text->text);
    else if (strcmp (text->key, "Software") == 0)
      cairo_pdf_surface_set_metadata (surface, CAIRO_PDF_METADATA_CREATOR, text->text);
    else
      g_string_append_printf (keywords, "%s%s: %s", keywords->len > 0 ? ", " : "",
                              text->key, text->text);
  }
  if (keywords->len > 0)
    cairo_pdf_surface_set_metadata (surface, CAIRO_PDF_METADATA_KEYWORDS, keywords->str);
  /* No date: equal input shall give equal bytes. */
  cairo_pdf_surface_set_metadata (surface, CAIRO_PDF_METADATA_CREATE_DATE, "");
}

/* Cairo names the groups of an SVG after a counter of the process; numbers them anew in the
 * order of their appearance. */
static void
renumber_surfaces (GString *svg)
{
  g_autoptr (GHashTable) seen = g_hash_table_new (NULL, NULL);
  g_autoptr (GString) out = g_string_sized_new (svg->len);
  const char *at = svg->str, *hit;
  while ((hit = strstr (at, "surface")) != NULL) {
    const char *digits = hit + strlen ("surface");
    char *end = (char *) digits;
    guint64 name = g_ascii_isdigit (*digits) ? g_ascii_strtoull (digits, &end, 10) : 0;
    g_string_append_len (out, at, digits - at);
    if (end > digits && (hit[-1] == '"' || hit[-1] == '#')) {
      gpointer key = GSIZE_TO_POINTER (name), number = g_hash_table_lookup (seen, key);
      if (number == NULL)
        number = GUINT_TO_POINTER (g_hash_table_size (seen) + 1);
      g_hash_table_insert (seen, key, number);
      g_string_append_printf (out, "%u", GPOINTER_TO_UINT (number));
      digits = end;
    }
    at = digits;
  }
  g_string_append (out, at);
  g_string_assign (svg, out->str);
}

/* Adds <title> and <metadata> as first children of the root. */
static void
describe_svg (GString *svg, const QnMetadata *metadata)
{
  Words words;
  g_autoptr (GString) head = g_string_new (NULL);
  describe (metadata, &words);
  if (metadata->title != NULL) {
    g_autofree char *title = qn_xml_dup_text (metadata->title);
    g_string_append_printf (head, "<title>%s</title>\n", title);
  }
  g_string_append (head, "<metadata>\n");
  for (size_t i = 0; i < words.count; i++) {
    g_autofree char *text = qn_xml_dup_text (words.texts[i].text);
    g_string_append_printf (head, "%s: %s\n", words.texts[i].key, text);
  }
  g_string_append (head, "</metadata>\n");
  const char *root = strstr (svg->str, "<svg");
  const char *end = root != NULL ? strchr (root, '>') : NULL;
  if (end != NULL)
    g_string_insert (svg, end - svg->str + 2, head->str);
}

static GBytes *
encode_vector (QnFormat format, const QnOutput *output, const QnPage *page,
               const QnMetadata *metadata, QnPageFunc draw, void *data, GError **error)
{
  g_autoptr (GByteArray) bytes = g_byte_array_new ();
  double points = 72 / recorded_dpi (output);
  double width = page->width * points, height = page->height * points;
  bool pdf = format == QN_FORMAT_PDF;
  cairo_surface_t *surface =
    pdf ? cairo_pdf_surface_create_for_stream (qn_output_append, bytes, width, height)
        : cairo_svg_surface_create_for_stream (qn_output_append, bytes, width, height);
  g_autoptr (GPtrArray) texts = pdf ? NULL : qn_svg_text_collect (surface);
  if (pdf)
    qn_output_describe_pdf (surface, metadata);
  cairo_t *cr = cairo_create (surface);
  cairo_scale (cr, points, points);
  bool done = draw_page (cr, page, draw, data, error);
  cairo_destroy (cr);
  cairo_surface_finish (surface);
  cairo_surface_destroy (surface);
  if (!done)
    return NULL;
  if (pdf)
    return g_byte_array_free_to_bytes (g_steal_pointer (&bytes));

  g_autoptr (GString) svg = g_string_new_len ((const char *) bytes->data, bytes->len);
  renumber_surfaces (svg);
  qn_svg_text_insert (svg, texts);
  describe_svg (svg, metadata);
  return g_string_free_to_bytes (g_steal_pointer (&svg));
}

GBytes *
qn_page_encode (QnFormat format, const QnOutput *output, const QnMetadata *metadata,
                QnPageFunc draw, void *data, GError **error)
{
  QnPage page;
  if (!qn_output_page (output, &page, error))
    return NULL;
  if (format == QN_FORMAT_PNG) {
    g_autoptr (QnOffscreen) offscreen = NULL;
    if (output->backend == QN_BACKEND_GL
        && (offscreen = qn_offscreen_new (error)) == NULL)
      return NULL;
    page.offscreen = offscreen;
    cairo_surface_t *surface = qn_page_create_image (&page);
    cairo_t *cr = cairo_create (surface);
    GBytes *bytes = NULL;
    if (draw_page (cr, &page, draw, data, error)) {
      Words words;
      describe (metadata, &words);
      bytes =
        qn_png_encode (surface, recorded_dpi (output), words.texts, words.count, error);
    }
    cairo_destroy (cr);
    cairo_surface_destroy (surface);
    return bytes;
  }
  return encode_vector (format, output, &page, metadata, draw, data, error);
}

bool
qn_page_export (const char *path, const QnOutput *output, const QnMetadata *metadata,
                QnPageFunc draw, void *data, GError **error)
{
  QnFormat format;
  if (!qn_format_of_path (path, &format, error))
    return false;
  g_autoptr (GBytes) bytes = qn_page_encode (format, output, metadata, draw, data, error);
  if (bytes == NULL)
    return false;
  gsize length;
  const void *content = g_bytes_get_data (bytes, &length);
  return qn_file_replace (path, content, length, error);
}

bool
qn_file_replace (const char *path, const void *data, size_t length, GError **error)
{
  int trouble = qn_whole_file_replace (path, data, length);
  if (trouble != 0)
    qn_render_error_set_unwritten (error, path, trouble);
  return trouble == 0;
}
