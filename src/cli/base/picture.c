#include "cli/base/picture.h"

#include "cli/base/message.h"
#include "doc/document/underlay.h"
#include "doc/view/sheet.h"

#include <glib/gi18n.h>
#include <math.h>
#include <string.h>

QnPictureOptions qn_picture;

void
qn_picture_page (void)
{
  const QnPictureOptions *options = &qn_picture;
  QnOutput *output = &qn_picture.output;
  QnPage page;
  char *end = options->dpi;

  if (options->path == NULL)
    qn_cli_usage_error (_ ("-o is missing"));
  qn_output_init (output);
  output->transparent = options->transparent;
  if (options->dpi != NULL) {
    output->dpi = g_ascii_strtod (options->dpi, &end);
    if (end == options->dpi || *end != '\0' || !(output->dpi > 0)
        || !isfinite (output->dpi))
      qn_cli_usage_error (_ ("--dpi must be positive"));
  }
  if (g_strcmp0 (options->backend, "gl") == 0)
    output->backend = QN_BACKEND_GL;
  else if (options->backend != NULL && strcmp (options->backend, "cairo") != 0)
    qn_cli_usage_error (_ ("--backend is cairo or gl"));
  qn_cli_must (options->size == NULL
               || qn_output_parse_size (output, options->size, QN_TROUBLE));
  qn_cli_must (qn_output_page (output, &page, QN_TROUBLE));
}

void
qn_picture_output (void)
{
  QnFormat format;
  qn_picture_page ();
  qn_cli_must (qn_format_of_path (qn_picture.path, &format, QN_TROUBLE));
}

void
qn_picture_if_any (void)
{
  if (qn_picture.path != NULL)
    qn_picture_output ();
}

void
qn_picture_or_table (void)
{
  QnFormat format;
  qn_picture_page ();
  if (!qn_is_table (qn_picture.path)
      && !qn_format_of_path (qn_picture.path, &format, NULL))
    qn_cli_usage_error ("%s: %s", qn_picture.path,
                        _ ("the name ends in .png, .svg, .pdf or .csv"));
}

void
qn_picture_plot (QnPlot *plot, const char *title, const QnProject *project)
{
  QnMetadata metadata;
  qn_project_get_metadata (project, &metadata);
  plot->title = title;
  plot->monochrome = qn_picture.monochrome;
  qn_cli_must (
    qn_plot_export (plot, qn_picture.path, &qn_picture.output, &metadata, QN_TROUBLE));
}

gboolean
qn_picture_figure (QnFigure *figure, const QnInput *input, const char *path,
                   const QnOutput *output)
{
  QnMetadata metadata;
  QnUnderlay *underlay = &figure->options.underlay;
  qn_project_get_metadata (&input->project, &metadata);
  gboolean done =
    qn_underlay_read (&input->project, qn_allow_outside, underlay, QN_TROUBLE)
    && qn_figure_export (figure, path, output, &metadata, QN_TROUBLE);
  g_clear_pointer (&underlay->image, cairo_surface_destroy);
  return done;
}
