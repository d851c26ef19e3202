/* Private to the export for ParaView: the frame of a VTU file and its arrays. */
#ifndef QN_IO_VTU_XML_H
#define QN_IO_VTU_XML_H

#include "core/result/result.h"
#include "io/text/file-writer.h"

/* A component of entry `index` of an array. */
typedef double (*QnVtuValueFunc) (const void *data, size_t index, int component);

/* The entry's own index: of points that are used in their order, of cells that are numbered. */
double qn_vtu_index_value (const void *data, size_t index, int component);

/* What stands before and behind the one piece of a file. */
void qn_vtu_begin (QnFileWriter *writer, size_t points, size_t cells);
void qn_vtu_end (QnFileWriter *writer);

/* An array of `count` rows; type as VTK calls it: "Float64", "Int64", "UInt8". */
void qn_vtu_put_array (QnFileWriter *writer, const char *type, const char *name,
                       int components, size_t count, QnVtuValueFunc value,
                       const void *data);

/* The whole of the elements Points and Cells for lines, each on two points of its own; `point`
 * gives coordinates, m. */
void qn_vtu_put_lines (QnFileWriter *writer, size_t lines, QnVtuValueFunc point,
                       const void *data);

/* In vtu-beams.c: a line for every element, on two points of its own, with displacements and
 * section forces where the result (nullable) has them at this step. Closes the writer (nullable:
 * it could not be opened). */
gboolean qn_vtu_write_beams (QnFileWriter *writer, const QnModel *model,
                             const QnResult *result, size_t step, GError **error);

#endif
