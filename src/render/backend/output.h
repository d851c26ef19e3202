/* Output of a picture: size, resolution, ground, format and metadata.
 *
 * Every export of this layer goes through qn_page_export(): the page is drawn into memory,
 * encoded into memory and only then written, to a temporary file that takes the final name at
 * the end. A failed export leaves the old file, if any, as it was. Equal input gives equal
 * bytes: no dates, no counters.
 */
#pragma once

#include "render/drawing/render-error.h"

#include <cairo.h>
#include <glib.h>
#include <stdbool.h>

typedef enum { QN_BACKEND_CAIRO, QN_BACKEND_GL } QnBackend;

typedef enum { QN_FORMAT_PNG, QN_FORMAT_SVG, QN_FORMAT_PDF } QnFormat;

typedef struct QnOutput {
  double width, height; /* px, or mm where `millimetres` */
  bool millimetres;
  double dpi; /* 0: not given; 300 is used for mm, 96 recorded for px */
  bool transparent;
  QnBackend backend; /* GL applies to PNG figures; vector formats are always Cairo */
} QnOutput;

/* Contents of PNG text chunks, SVG metadata and PDF information dictionaries. All strings are borrowed
 * and may be NULL. */
typedef struct QnMetadata {
  const char *title;
  const char *model;        /* file name of the model */
  const char *model_sha256; /* hexadecimal */
  const char *generator;    /* "quoin 0.1.0" */
  double multiplier;        /* of what is shown; not-a-number: none */
} QnMetadata;

/* The page as drawing functions see it: px, y down. */
typedef struct QnPage {
  double width, height; /* px */
  double unit;          /* px per typographic point, as styles use it */
  bool transparent;
  struct QnOffscreen *offscreen; /* borrowed; NULL: Cairo draws */
} QnPage;

/* 1600 x 1200 px on white, Cairo. */
void qn_output_init (QnOutput *output);

/* No metadata. */
void qn_metadata_init (QnMetadata *metadata);

/* "1600x1200" (px) or "160mmx120mm"; sets the error (USAGE) otherwise. */
bool qn_output_parse_size (QnOutput *output, const char *text, GError **error);

/* The format by the ending of the path; "-" (standard output) is PNG. */
bool qn_format_of_path (const char *path, QnFormat *format, GError **error);

/* Checks the size and converts it into px. Refuses sizes that are not positive, and more than 32,000 px
 * on a side or 2^28 px in all. */
bool qn_output_page (const QnOutput *output, QnPage *page, GError **error);

/* An image of the page's size. */
cairo_surface_t *qn_page_create_image (const QnPage *page);

/* Whether Cairo has done what it should; else an error (FAILED). */
bool qn_output_succeeded (cairo_status_t status, GError **error);

/* Draws one page; false with an error to give up. */
typedef bool (*QnPageFunc) (cairo_t *cr, const QnPage *page, void *data, GError **error);

/* Draws, encodes and writes, whole or not at all; "-" writes to standard output. False with an
 * error of QN_RENDER_ERROR, or the one that `draw` has set. */
bool qn_page_export (const char *path, const QnOutput *output, const QnMetadata *metadata,
                     QnPageFunc draw, void *data, GError **error);

/* The same, into memory. Returns NULL with an error. */
GBytes *qn_page_encode (QnFormat format, const QnOutput *output,
                        const QnMetadata *metadata, QnPageFunc draw, void *data,
                        GError **error);

/* Collects what Cairo writes in a GByteArray. */
cairo_status_t qn_output_append (void *bytes, const unsigned char *data,
                                 unsigned int length);

/* PNG files with text chunks and resolution, which Cairo's own writer cannot carry. */
typedef struct QnPngText {
  const char *key;  /* "Title", "Software", … or a private one, Latin-1 */
  const char *text; /* UTF-8 */
} QnPngText;

/* Encodes an ARGB32 image surface. `dpi` <= 0: no resolution chunk. An image without any
 * transparent pixel is written without alpha. NULL with an error (FAILED). */
GBytes *qn_png_encode (cairo_surface_t *surface, double dpi, const QnPngText *texts,
                       size_t text_count, GError **error);

/* Puts the metadata into a PDF, which bears no date: equal input gives equal bytes. */
void qn_output_describe_pdf (cairo_surface_t *surface, const QnMetadata *metadata);

/* Replaces the file by these bytes as a whole. Devices and pipes are written to directly. */
bool qn_file_replace (const char *path, const void *data, size_t length, GError **error);
