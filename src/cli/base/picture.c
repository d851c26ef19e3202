#include "cli/base/picture.h"

#include "cli/base/message.h"
#include "doc/view/sheet.h"

#include <glib/gi18n.h>
#include <math.h>
#include <string.h>

QnExit
qn_picture_page (const QnSubcommand *self, const QnPictureOptions *options,
                 QnOutput *output)
{
  GError *error = NULL;
  QnPage page;

  if (options->path == NULL)
    return qn_cli_usage_error (self->name, _ ("-o is missing"));
  output->transparent = options->transparent;
  char *end = options->dpi;
  if (options->dpi != NULL) {
    output->dpi = g_ascii_strtod (options->dpi, &end);
    if (end == options->dpi || *end != '\0' || !(output->dpi > 0)
        || !isfinite (output->dpi))
      return qn_cli_usage_error (self->name, _ ("--dpi must be positive"));
  }
  if (g_strcmp0 (options->backend, "gl") == 0)
    output->backend = QN_BACKEND_GL;
  else if (options->backend != NULL && strcmp (options->backend, "cairo") != 0)
    return qn_cli_usage_error (self->name, _ ("--backend is cairo or gl"));

  if ((options->size != NULL && !qn_output_parse_size (output, options->size, &error))
      || !qn_output_page (output, &page, &error))
    return qn_cli_fail (error);
  return QN_EXIT_DONE;
}

QnExit
qn_picture_output (const QnSubcommand *self, const QnPictureOptions *options,
                   QnOutput *output)
{
  GError *error = NULL;
  QnFormat format;
  QnExit code = qn_picture_page (self, options, output);
  if (code == QN_EXIT_DONE && !qn_format_of_path (options->path, &format, &error))
    code = qn_cli_fail (error);
  return code;
}

QnExit
qn_picture_or_table (const QnSubcommand *self, const QnPictureOptions *options,
                     QnOutput *output)
{
  QnFormat format;
  QnExit code = qn_picture_page (self, options, output);
  if (code == QN_EXIT_DONE && !qn_is_table (options->path)
      && !qn_format_of_path (options->path, &format, NULL))
    return qn_cli_usage_error (self->name, "%s: %s", options->path,
                               _ ("the name ends in .png, .svg, .pdf or .csv"));
  return code;
}
