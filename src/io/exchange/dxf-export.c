#include "io/exchange/dxf-export.h"
#include "io/exchange/dxf-scan.h"
#include "io/text/file-writer.h"

#include <string.h>

/* Handles of fixed objects are 10 to 1D, as the texts below have them; all others count on from here. */
#define FIRST_HANDLE 0x100

typedef struct Export {
  QnFileWriter *writer;
  double unit;
  guint handle;         /* the next free one */
  gboolean beams, ties; /* whether there are any */
} Export;

/* Group codes and values as they stand in the file; @ is the next free handle. */
static void
put_text (Export *export, const char *lines)
{
  for (const char *at; (at = strchr (lines, '@')) != NULL; lines = at + 1) {
    qn_file_writer_write (export->writer, lines, (gsize) (at - lines));
    qn_file_writer_printf (export->writer, "%X", export->handle++);
  }
  qn_file_writer_puts (export->writer, lines);
}

static void
put (Export *export, int code, const char *text)
{
  qn_file_writer_printf (export->writer, "%3d\n%s\n", code, text);
}

static void
put_int (Export *export, int code, int number)
{
  qn_file_writer_printf (export->writer, "%3d\n%d\n", code, number);
}

/* Fifteen digits where they say the same as seventeen: scaling leaves the file's own digits. */
static void
put_length (Export *export, int code, double metres)
{
  double number = metres / export->unit;
  double per_metre = 1 / export->unit;
  if (export->unit < 1 && fabs (per_metre - round (per_metre)) < 1e-9)
    number = metres * round (per_metre);
  char text[G_ASCII_DTOSTR_BUF_SIZE];
  g_ascii_formatd (text, sizeof text, "%.15g", number);
  if (export->unit == 1 && g_ascii_strtod (text, NULL) != number)
    g_ascii_formatd (text, sizeof text, "%.17g", number);
  put (export, code, text);
}

/* What AutoCAD asks of a file of release 2000 beside its entities. */
static void
put_tables (Export *export)
{
  const struct {
    const char *name;
    int color;
    gboolean used;
  } layers[] = { { "0", 7, TRUE },           { "BLOCKS", 7, TRUE },
                 { "SUPPORTS", 5, TRUE },    { "CONTACTS", 1, TRUE },
                 { "DEFORMED", 3, TRUE },    { "BEAM_AXES", 6, export->beams },
                 { "TIES", 2, export->ties } };
  put_text (export,
            "  0\nSECTION\n  2\nTABLES\n  0\nTABLE\n  2\nVPORT\n  5\n14\n330\n0\n"
            "100\nAcDbSymbolTable\n 70\n0\n  0\nENDTAB\n"
            "  0\nTABLE\n  2\nLTYPE\n  5\n11\n330\n0\n100\nAcDbSymbolTable\n 70\n3\n"
            "  0\nLTYPE\n  5\n@\n330\n11\n100\nAcDbSymbolTableRecord\n"
            "100\nAcDbLinetypeTableRecord\n  2\nByBlock\n 70\n0\n  3\n\n 72\n65\n"
            " 73\n0\n 40\n0.0\n"
            "  0\nLTYPE\n  5\n@\n330\n11\n100\nAcDbSymbolTableRecord\n"
            "100\nAcDbLinetypeTableRecord\n  2\nByLayer\n 70\n0\n  3\n\n 72\n65\n"
            " 73\n0\n 40\n0.0\n"
            "  0\nLTYPE\n  5\n@\n330\n11\n100\nAcDbSymbolTableRecord\n"
            "100\nAcDbLinetypeTableRecord\n  2\nCONTINUOUS\n 70\n0\n  3\n\n 72\n65\n"
            " 73\n0\n 40\n0.0\n"
            "  0\nENDTAB\n  0\nTABLE\n  2\nLAYER\n  5\n10\n330\n0\n"
            "100\nAcDbSymbolTable\n");
  put_int (export, 70, 5 + export->beams + export->ties);
  for (gsize i = 0; i < G_N_ELEMENTS (layers); i++) {
    if (!layers[i].used)
      continue;
    put_text (export, "  0\nLAYER\n  5\n@\n330\n10\n100\nAcDbSymbolTableRecord\n"
                      "100\nAcDbLayerTableRecord\n");
    put (export, 2, layers[i].name);
    put_int (export, 70, 0);
    put_int (export, 62, layers[i].color);
    put (export, 6, "CONTINUOUS");
  }
  put_text (export,
            "  0\nENDTAB\n  0\nTABLE\n  2\nSTYLE\n  5\n15\n330\n0\n"
            "100\nAcDbSymbolTable\n 70\n1\n"
            "  0\nSTYLE\n  5\n@\n330\n15\n100\nAcDbSymbolTableRecord\n"
            "100\nAcDbTextStyleTableRecord\n  2\nStandard\n 70\n0\n  3\ntxt\n"
            "  0\nENDTAB\n"
            "  0\nTABLE\n  2\nVIEW\n  5\n16\n330\n0\n100\nAcDbSymbolTable\n 70\n0\n"
            "  0\nENDTAB\n"
            "  0\nTABLE\n  2\nUCS\n  5\n17\n330\n0\n100\nAcDbSymbolTable\n 70\n0\n"
            "  0\nENDTAB\n"
            "  0\nTABLE\n  2\nAPPID\n  5\n13\n330\n0\n100\nAcDbSymbolTable\n 70\n1\n"
            "  0\nAPPID\n  5\n@\n330\n13\n100\nAcDbSymbolTableRecord\n"
            "100\nAcDbRegAppTableRecord\n  2\nACAD\n 70\n0\n  0\nENDTAB\n"
            "  0\nTABLE\n  2\nDIMSTYLE\n  5\n18\n330\n0\n100\nAcDbSymbolTable\n"
            " 70\n0\n100\nAcDbDimStyleTable\n  0\nENDTAB\n"
            "  0\nTABLE\n  2\nBLOCK_RECORD\n  5\n12\n330\n0\n100\nAcDbSymbolTable\n"
            " 70\n2\n"
            "  0\nBLOCK_RECORD\n  5\n19\n330\n12\n100\nAcDbSymbolTableRecord\n"
            "100\nAcDbBlockTableRecord\n  2\n*Model_Space\n"
            "  0\nBLOCK_RECORD\n  5\n1A\n330\n12\n100\nAcDbSymbolTableRecord\n"
            "100\nAcDbBlockTableRecord\n  2\n*Paper_Space\n  0\nENDTAB\n  0\nENDSEC\n"
            "  0\nSECTION\n  2\nBLOCKS\n  0\nBLOCK\n  5\n@\n330\n19\n"
            "100\nAcDbEntity\n  8\n0\n100\nAcDbBlockBegin\n  2\n*Model_Space\n"
            " 70\n0\n 10\n0.0\n 20\n0.0\n 30\n0.0\n  3\n*Model_Space\n  1\n\n"
            "  0\nENDBLK\n  5\n@\n330\n19\n100\nAcDbEntity\n  8\n0\n"
            "100\nAcDbBlockEnd\n"
            "  0\nBLOCK\n  5\n@\n330\n1A\n100\nAcDbEntity\n  8\n0\n"
            "100\nAcDbBlockBegin\n  2\n*Paper_Space\n 70\n0\n 10\n0.0\n 20\n0.0\n"
            " 30\n0.0\n  3\n*Paper_Space\n  1\n\n  0\nENDBLK\n  5\n@\n330\n1A\n"
            "100\nAcDbEntity\n  8\n0\n100\nAcDbBlockEnd\n  0\nENDSEC\n");
}

static void
write_entity (Export *export, const char *type, const char *layer, const char *subclass)
{
  put (export, 0, type);
  put_text (export, "  5\n@\n330\n19\n100\nAcDbEntity\n");
  put (export, 8, layer);
  put (export, 100, subclass);
}

/* The outline of a block, moved by `u` (nullable: ux, uy, rz, the rotation as a finite one). */
static void
put_block (Export *export, const QnModel *model, QnId id, const char *layer,
           const double *u, double scale)
{
  const QnBlock *block = &model->blocks[id];
  const QnVec2 *vertices = qn_model_block_vertices (model, id);
  write_entity (export, "LWPOLYLINE", layer, "AcDbPolyline");
  put_int (export, 90, block->vertex_count);
  put_int (export, 70, 1);
  for (QnId i = 0; i < block->vertex_count; i++) {
    QnVec2 p = vertices[i];
    if (u != NULL) {
      double angle = scale * u[QN_DOF_RZ];
      QnVec2 arm =
        qn_vec2_rotate (qn_vec2_sub (p, block->centroid), cos (angle), sin (angle));
      p = qn_vec2_add (qn_vec2_add (block->centroid, arm),
                       qn_vec2 (scale * u[QN_DOF_UX], scale * u[QN_DOF_UY]));
    }
    put_length (export, 10, p.x);
    put_length (export, 20, p.y);
  }
}

static void
put_segment (Export *export, const char *layer, QnVec2 start, QnVec2 end)
{
  write_entity (export, "LINE", layer, "AcDbLine");
  put_length (export, 10, start.x);
  put_length (export, 20, start.y);
  put (export, 30, "0.0");
  put_length (export, 11, end.x);
  put_length (export, 21, end.y);
  put (export, 31, "0.0");
}

/* Where a node has gone; u: rows of the nodes, or NULL. */
static QnVec2
place_node (const QnModel *model, QnId node, const double *u, double scale)
{
  QnVec2 at = model->nodes[node].at;
  if (u == NULL)
    return at;
  const double *row = u + (size_t) node * QN_DOF_COUNT;
  return qn_vec2_add_scaled (at, scale, qn_vec2 (row[QN_DOF_UX], row[QN_DOF_UY]));
}

/* Beams as they lie, whole; displaced ones element by element. */
static void
put_beams (Export *export, const QnModel *model, const QnResult *result, double scale)
{
  for (size_t i = 0; i < model->beam_count; i++)
    put_segment (export, "BEAM_AXES", model->nodes[model->beams[i].nodes[0]].at,
                 model->nodes[model->beams[i].nodes[1]].at);
  if (result == NULL || result->step_count == 0
      || result->node_count != model->node_count)
    return;
  const double *u = qn_result_step_displacements (result, result->step_count - 1)
                    + result->block_count * QN_DOF_COUNT;
  for (size_t i = 0; i < model->element_count; i++)
    put_segment (export, "DEFORMED",
                 place_node (model, model->elements[i].nodes[0], u, scale),
                 place_node (model, model->elements[i].nodes[1], u, scale));
}

gboolean
qn_dxf_export (const QnModel *model, const QnContacts *contacts, const QnResult *result,
               double scale, double unit, const char *path, GError **error)
{
  Export export = { qn_file_writer_open (path), unit, FIRST_HANDLE, model->beam_count > 0,
                    model->tie_count > 0 };
  put_text (&export, "  0\nSECTION\n  2\nHEADER\n"
                     "  9\n$ACADVER\n  1\nAC1015\n"
                     "  9\n$HANDSEED\n  5\nFFFFFF\n"
                     "  9\n$INSUNITS\n");
  put_int (&export, 70, qn_dxf_unit_code (export.unit));
  put_text (&export, "  9\n$MEASUREMENT\n 70\n1\n"
                     "  0\nENDSEC\n");
  put_tables (&export);
  put_text (&export, "  0\nSECTION\n  2\nENTITIES\n");
  for (size_t i = 0; i < model->block_count; i++)
    put_block (&export, model, (QnId) i,
               qn_support_is_full (model->blocks[i].support) ? "SUPPORTS" : "BLOCKS",
               NULL, 0);
  for (size_t i = 0; contacts != NULL && i < contacts->face_count; i++)
    put_segment (&export, "CONTACTS", contacts->faces[i].start, contacts->faces[i].end);
  if (result != NULL && result->step_count > 0) {
    const double *u = qn_result_step_displacements (result, result->step_count - 1);
    for (size_t i = 0; i < model->block_count; i++)
      put_block (&export, model, (QnId) i, "DEFORMED", u + i * QN_DOF_COUNT, scale);
  }
  put_beams (&export, model, result, scale);
  for (size_t i = 0; i < model->tie_count; i++)
    put_segment (&export, "TIES", model->ties[i].ends[0].at, model->ties[i].ends[1].at);
  put_text (&export, "  0\nENDSEC\n");
  put_text (&export,
            "  0\nSECTION\n  2\nOBJECTS\n  0\nDICTIONARY\n  5\n1B\n330\n0\n"
            "100\nAcDbDictionary\n  3\nACAD_GROUP\n350\n1C\n"
            "  0\nDICTIONARY\n  5\n1C\n330\n1B\n100\nAcDbDictionary\n  0\nENDSEC\n"
            "  0\nEOF\n");
  return qn_file_writer_commit (export.writer, error);
}
