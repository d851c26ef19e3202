/* Options that all subcommands which make a picture share. */
#pragma once

#include "cli/base/input.h"
#include "render/figure/plot.h"

/* The options as they stand on the command line; all NULL or zero before parsing. */
typedef struct QnPictureOptions {
  char *path, *size, *dpi, *backend;
  gboolean transparent, monochrome;
  QnOutput output; /* what they say */
} QnPictureOptions;

extern QnPictureOptions qn_picture;

/* Entries for a GOptionEntry array. */
/* clang-format off */
#define QN_PICTURE_ENTRIES(path_name)                                                    \
  { "output", 'o', 0, G_OPTION_ARG_FILENAME, &qn_picture.path,                           \
    N_ ("Write the picture here; - is standard output"), path_name },                    \
  { "size", 0, 0, G_OPTION_ARG_STRING, &qn_picture.size,                                 \
    N_ ("Size in pixels or millimetres"), N_ ("1600x1200|160mmx120mm") },                \
  { "dpi", 0, 0, G_OPTION_ARG_STRING, &qn_picture.dpi,                                   \
    N_ ("Pixels per inch for sizes in millimetres"), N_ ("DPI") },                       \
  { "backend", 0, 0, G_OPTION_ARG_STRING, &qn_picture.backend,                           \
    N_ ("Drawing library: cairo (default) or gl"), N_ ("cairo|gl") },                    \
  { "transparent", 0, 0, G_OPTION_ARG_NONE, &qn_picture.transparent,                     \
    N_ ("No white background"), NULL },                                                  \
  { "monochrome", 0, 0, G_OPTION_ARG_NONE, &qn_picture.monochrome, N_ ("Greys only"), NULL }
/* clang-format on */

/* Fills `output`; wrong options, or none for the path, end the program. */
void qn_picture_output (void);

/* The same where a picture is asked for; else nothing. */
void qn_picture_if_any (void);

/* The same without a look at the ending of the path: for files that are no single picture. */
void qn_picture_page (void);

/* The same for a picture or a table. */
void qn_picture_or_table (void);

/* Writes the picture of a plot about a project, which may be NULL. */
void qn_picture_plot (QnPlot *plot, const char *title, const QnProject *project);

/* Writes a figure of a project, with the picture that lies beneath it; FALSE with QN_TROUBLE. */
gboolean qn_picture_figure (QnFigure *figure, const QnInput *input, const char *path,
                            const QnOutput *output);
