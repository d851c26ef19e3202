/* Private to the export for ParaView: the frame of a VTU file and its arrays. */
#ifndef QN_IO_VTU_XML_H
#define QN_IO_VTU_XML_H

#include "core/result.h"
#include "io/file-writer.h"

#define QN_VTK_LINE    3
#define QN_VTK_POLYGON 7

/* A component of entry `index` of an array. */
typedef double (*QnVtuValueFunc) (const void *data, size_t index, int component);

void qn_vtu_begin (QnFileWriter *writer, size_t points, size_t cells);
void qn_vtu_end (QnFileWriter *writer);
void qn_vtu_put_array (QnFileWriter *writer, const char *type, const char *name,
                       int components, size_t count, QnVtuValueFunc value,
                       const void *data);

/* In vtu-beams.c: a line for every element, on two points of its own, with displacements and
 * section forces where the result (nullable) has them at this step. Closes the writer (nullable:
 * it could not be opened). */
gboolean qn_vtu_write_beams (QnFileWriter *writer, const QnModel *model,
                             const QnResult *result, size_t step, GError **error);

#endif
