#include "io/vtu-xml.h"

void
qn_vtu_begin (QnFileWriter *writer, size_t points, size_t cells)
{
  qn_file_writer_printf (
    writer,
    "<?xml version=\"1.0\"?>\n"
    "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
    "<UnstructuredGrid>\n<Piece NumberOfPoints=\"%zu\" NumberOfCells=\"%zu\">\n",
    points, cells);
}

void
qn_vtu_end (QnFileWriter *writer)
{
  qn_file_writer_puts (writer, "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
}

void
qn_vtu_put_array (QnFileWriter *writer, const char *type, const char *name,
                  int components, size_t count, QnVtuValueFunc value, const void *data)
{
  qn_file_writer_printf (writer,
                         "<DataArray type=\"%s\" Name=\"%s\" NumberOfComponents=\"%d\" "
                         "format=\"ascii\">\n",
                         type, name, components);
  for (size_t i = 0; i < count; i++) {
    for (int c = 0; c < components; c++) {
      if (c > 0)
        qn_file_writer_puts (writer, " ");
      qn_file_writer_number (writer, value (data, i, c));
    }
    qn_file_writer_puts (writer, "\n");
  }
  qn_file_writer_puts (writer, "</DataArray>\n");
}
