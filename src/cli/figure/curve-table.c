#include "cli/figure/curve-table.h"

#include "cli/base/message.h"
#include "core/result/mechanism.h"
#include "io/text/file-writer.h"
#include "io/text/mechanism-text.h"

#include <glib/gi18n.h>

gboolean
qn_is_table (const char *path)
{
  g_autofree char *lower = path != NULL ? g_ascii_strdown (path, -1) : NULL;
  return lower != NULL && g_str_has_suffix (lower, ".csv");
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

/* A field in quotes, which are doubled within. */
static void
write_text (QnFileWriter *writer, const char *text)
{
  g_auto (GStrv) parts = g_strsplit (text, "\"", -1);
  g_autofree char *doubled = g_strjoinv ("\"\"", parts);
  qn_file_writer_printf (writer, "\"%s\"", doubled);
}

gboolean
qn_curve_table_write (const char *path, const QnCurve *curves, gsize count,
                      GError **error)
{
  QnFileWriter *writer = qn_file_writer_open (path, error);
  if (writer == NULL)
    return FALSE;
  qn_file_writer_puts (writer,
                       count > 0 && curves[0].in_time
                         ? "run,step,time [s],displacement [m or rad],mark\n"
                       : count > 0 && curves[0].settles
                         ? "run,step,settlement [m or rad],reaction [N or N m],mark\n"
                         : "run,step,displacement [m or rad],multiplier [-],mark\n");
  for (gsize c = 0; c < count; c++)
    for (gsize i = 0; i < curves[c].count; i++) {
      const QnCurve *curve = &curves[c];
      const char *mark = (ptrdiff_t) i == curve->collapse_point ? "collapse"
                         : (ptrdiff_t) i == curve->limit_point  ? "limit point"
                                                                : "";
      write_text (writer, curve->label != NULL ? curve->label : "");
      qn_file_writer_printf (writer, ",%" G_GSIZE_FORMAT ",", i);
      qn_file_writer_number (writer, curve->x[i]);
      qn_file_writer_puts_number (writer, ",", curve->y[i]);
      qn_file_writer_printf (writer, ",%s\n", mark);
    }
  return qn_file_writer_commit (writer, error);
}

/* Its name alone; empty where there is none. */
static char *
dup_mechanism (const QnSheetItem *item)
{
  QnMechanism mechanism;
  const QnResult *result = &item->file.result;
  if (result->mechanism == NULL
      || qn_mechanism_of_result (&mechanism, &item->input.project.model,
                                 &item->input.contacts, result, NULL)
           != QN_OK)
    return g_strdup ("");
  char *title = qn_mechanism_dup_title (&mechanism);
  qn_mechanism_clear (&mechanism);
  return title;
}

gboolean
qn_comparison_table_write (const char *path, const QnSheetItem *items, gsize count,
                           GError **error)
{
  QnFileWriter *writer = qn_file_writer_open (path, error);
  if (writer == NULL)
    return FALSE;
  qn_file_writer_puts (writer, "project,title,outcome,multiplier [-],mechanism,steps\n");
  for (gsize i = 0; i < count; i++) {
    const QnResult *result = &items[i].file.result;
    g_autofree char *mechanism = dup_mechanism (&items[i]);
    write_text (writer, items[i].input.project.name);
    qn_file_writer_puts (writer, ",");
    write_text (writer, qn_sheet_item_title (&items[i]));
    qn_file_writer_printf (writer, ",%s,", qn_outcome_names[result->outcome]);
    if (result->has_collapse_multiplier)
      qn_file_writer_number (writer, result->collapse_multiplier);
    qn_file_writer_puts (writer, ",");
    write_text (writer, mechanism);
    qn_file_writer_printf (writer, ",%" G_GSIZE_FORMAT "\n", result->step_count);
  }
  return qn_file_writer_commit (writer, error);
}
