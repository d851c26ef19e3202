#include "doc/view/cracks-csv.h"

#include "io/text/file-writer.h"
#include "render/scene/reading.h"

gboolean
qn_cracks_csv_write (const char *path, const QnProject *project,
                     const QnContacts *contacts, const QnResult *result, GError **error)
{
  const QnModel *model = &project->model;
  QnFileWriter *writer = qn_file_writer_open (path, error);
  if (writer == NULL)
    return FALSE;
  qn_file_writer_puts (writer,
                       "face,block a,block b,width [m],mean [m],x [m],y [m],line\n");
  g_autoptr (GArray) cracks =
    result->step_count > 0
      ? qn_result_cracks (model, contacts, result, result->step_count - 1)
      : g_array_new (FALSE, FALSE, sizeof (QnCrack));
  g_autofree guint *lines = g_new (guint, cracks->len);
  g_array_unref (qn_cracks_by_line (contacts, cracks, lines));
  for (guint i = 0; i < cracks->len; i++) {
    const QnCrack *crack = &g_array_index (cracks, QnCrack, i);
    const double numbers[] = { crack->width, crack->mean, crack->at.x, crack->at.y };
    qn_file_writer_printf (writer, "%td,", crack->face - contacts->faces);
    qn_file_writer_quoted (writer, model->blocks[crack->face->a].name);
    qn_file_writer_puts (writer, ",");
    qn_file_writer_quoted (writer, model->blocks[crack->face->b].name);
    qn_file_writer_puts (writer, ",");
    qn_file_writer_numbers (writer, numbers, G_N_ELEMENTS (numbers), ",");
    qn_file_writer_printf (writer, ",%u\n", lines[i] + 1);
  }
  return qn_file_writer_commit (writer, error);
}
