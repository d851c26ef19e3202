#include "io/exchange/vtu-xml.h"

/* VTK's number of the kind of cell that a line is. */
#define VTK_LINE 3

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
    for (int c = 0; c < components; c++)
      qn_file_writer_puts_number (writer, c > 0 ? " " : "", value (data, i, c));
    qn_file_writer_puts (writer, "\n");
  }
  qn_file_writer_puts (writer, "</DataArray>\n");
}

double
qn_vtu_index_value (const void *data, size_t index, int component)
{
  (void) data;
  (void) component;
  return (double) index;
}

static double
line_end (const void *data, size_t index, int component)
{
  (void) data;
  (void) component;
  return 2 * ((double) index + 1);
}

static double
line_value (const void *data, size_t index, int component)
{
  (void) data;
  (void) index;
  (void) component;
  return VTK_LINE;
}

void
qn_vtu_put_lines (QnFileWriter *writer, size_t lines, QnVtuValueFunc point,
                  const void *data)
{
  qn_file_writer_puts (writer, "<Points>\n");
  qn_vtu_put_array (writer, "Float64", "Points", 3, 2 * lines, point, data);
  qn_file_writer_puts (writer, "</Points>\n<Cells>\n");
  qn_vtu_put_array (writer, "Int64", "connectivity", 1, 2 * lines, qn_vtu_index_value,
                    data);
  qn_vtu_put_array (writer, "Int64", "offsets", 1, lines, line_end, data);
  qn_vtu_put_array (writer, "UInt8", "types", 1, lines, line_value, data);
  qn_file_writer_puts (writer, "</Cells>\n");
}
