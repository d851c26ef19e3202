/* Options that all subcommands which make a picture share. */
#pragma once

#include "cli/base/exit-code.h"
#include "cli/base/subcommand.h"
#include "render/backend/output.h"

/* The options as they stand on the command line; all NULL or zero before parsing. */
typedef struct QnPictureOptions {
  char *path, *size, *dpi, *backend;
  gboolean transparent, monochrome;
} QnPictureOptions;

/* Entries for a GOptionEntry array; `options` is a QnPictureOptions. */
/* clang-format off */
#define QN_PICTURE_ENTRIES(options, path_name)                                           \
  { "output", 'o', 0, G_OPTION_ARG_FILENAME, &(options).path,                            \
    N_ ("Write the picture here; - is standard output"), path_name },                    \
  { "size", 0, 0, G_OPTION_ARG_STRING, &(options).size,                                  \
    N_ ("Size in pixels or millimetres"), N_ ("1600x1200|160mmx120mm") },                \
  { "dpi", 0, 0, G_OPTION_ARG_STRING, &(options).dpi,                                    \
    N_ ("Pixels per inch for sizes in millimetres"), N_ ("DPI") },                       \
  { "backend", 0, 0, G_OPTION_ARG_STRING, &(options).backend,                            \
    N_ ("Drawing library: cairo (default) or gl"), N_ ("cairo|gl") },                    \
  { "transparent", 0, 0, G_OPTION_ARG_NONE, &(options).transparent,                      \
    N_ ("No white background"), NULL },                                                  \
  { "monochrome", 0, 0, G_OPTION_ARG_NONE, &(options).monochrome, N_ ("Greys only"), NULL }
/* clang-format on */

/* Fills `output`; the defaults of an unset --size are in it already. Tells the user what is
 * wrong and returns QN_EXIT_USAGE otherwise. */
QnExit qn_picture_output (const QnSubcommand *self, const QnPictureOptions *options,
                          QnOutput *output);

/* The same without a look at the ending of the path: for files that are no single picture. */
QnExit qn_picture_page (const QnSubcommand *self, const QnPictureOptions *options,
                        QnOutput *output);

/* The same for a picture or a table. */
QnExit qn_picture_or_table (const QnSubcommand *self, const QnPictureOptions *options,
                            QnOutput *output);
