#include "cli/figure/curve-table.h"

#include "io/text/file-writer.h"

/* A field in quotes, which are doubled within. */
static void
write_text (QnFileWriter *writer, const char *text)
{
  g_auto (GStrv) parts = g_strsplit (text, "\"", -1);
  g_autofree char *doubled = g_strjoinv ("\"\"", parts);
  qn_file_writer_printf (writer, "\"%s\"", doubled);
}

static void
write_point (QnFileWriter *writer, const QnCurve *curve, gsize i)
{
  const char *mark = (ptrdiff_t) i == curve->collapse_point ? "collapse"
                     : (ptrdiff_t) i == curve->limit_point  ? "limit point"
                                                            : "";
  write_text (writer, curve->label != NULL ? curve->label : "");
  qn_file_writer_printf (writer, ",%" G_GSIZE_FORMAT ",", i);
  qn_file_writer_number (writer, curve->x[i]);
  qn_file_writer_puts_number (writer, ",", curve->y[i]);
  qn_file_writer_printf (writer, ",%s\n", mark);
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
                         : "run,step,displacement [m or rad],multiplier [-],mark\n");
  for (gsize c = 0; c < count; c++)
    for (gsize i = 0; i < curves[c].count; i++)
      write_point (writer, &curves[c], i);
  return qn_file_writer_commit (writer, error);
}
