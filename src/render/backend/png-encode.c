#include "render/backend/png-encode.h"

#include "core/base/integer.h"
#include "render/backend/output.h"

#include <math.h>
#include <string.h>
#include <zlib.h>

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

static void
append_resolution (GByteArray *out, double dpi)
{
  static const guint8 in_metres = 1;
  g_autoptr (GByteArray) content = g_byte_array_new ();
  const gint64 per_metre = qn_to_integer (round (dpi / 0.0254), 1, G_MAXINT32);
  append_number (content, (guint32) per_metre);
  append_number (content, (guint32) per_metre);
  g_byte_array_append (content, &in_metres, 1);
  append_chunk (out, "pHYs", content);
}

/* More programs read the older kind of chunk, which holds no UTF-8; the other says, between key and text,
 * that it is not compressed and of no language that is named. */
static void
append_text (GByteArray *out, const QnPngText *text)
{
  static const guint8 nothing[5];
  const bool plain = g_str_is_ascii (text->text);
  g_autoptr (GByteArray) content = g_byte_array_new ();
  g_byte_array_append (content, (const guint8 *) text->key, (guint) strlen (text->key));
  g_byte_array_append (content, nothing, plain ? 1 : sizeof nothing);
  g_byte_array_append (content, (const guint8 *) text->text, (guint) strlen (text->text));
  append_chunk (out, plain ? "tEXt" : "iTXt", content);
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
  if (dpi > 0)
    append_resolution (out, dpi);
  for (size_t i = 0; i < text_count; i++)
    append_text (out, &texts[i]);
  g_byte_array_append (out, image->data + HEAD, image->len - HEAD);
  return g_byte_array_free_to_bytes (out);
}
