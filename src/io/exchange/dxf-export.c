#include "io/exchange/dxf-export.h"
#include "core/model/support.h"
#include "io/exchange/dxf-scan.h"
#include "io/text/file-writer.h"

/* Handles of the fixed objects; entities count on from FIRST_ENTITY. */
enum {
  HANDLE_LAYERS = 0x10,
  HANDLE_LTYPES,
  HANDLE_RECORDS,
  HANDLE_APPIDS,
  HANDLE_VPORTS,
  HANDLE_STYLES,
  HANDLE_VIEWS,
  HANDLE_UCSS,
  HANDLE_DIMSTYLES,
  HANDLE_MODEL,
  HANDLE_PAPER,
  HANDLE_ROOT,
  HANDLE_GROUPS,
  HANDLE_FREE,
  FIRST_ENTITY = 0x100
};

typedef struct Export {
  QnFileWriter *writer;
  double unit;
  guint handle;         /* the next free one */
  gboolean beams, ties; /* whether there are any */
} Export;

/* Group codes and values as they stand in the file. */
static void
put_text (Export *export, const char *lines)
{
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

static void
put_handle (Export *export, int code, guint handle)
{
  qn_file_writer_printf (export->writer, "%3d\n%X\n", code, handle);
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

static void
begin_table (Export *export, const char *name, guint handle, int entries)
{
  put (export, 0, "TABLE");
  put (export, 2, name);
  put_handle (export, 5, handle);
  put_int (export, 330, 0);
  put (export, 100, "AcDbSymbolTable");
  put_int (export, 70, entries);
}

static void
begin_record (Export *export, const char *type, guint handle, guint table,
              const char *subclass, const char *name)
{
  put (export, 0, type);
  put_handle (export, 5, handle);
  put_handle (export, 330, table);
  put (export, 100, "AcDbSymbolTableRecord");
  put (export, 100, subclass);
  put (export, 2, name);
}

static void
put_layers (Export *export)
{
  const struct {
    const char *name;
    int color;
    gboolean used;
  } layers[] = { { "0", 7, TRUE },           { "BLOCKS", 7, TRUE },
                 { "SUPPORTS", 5, TRUE },    { "CONTACTS", 1, TRUE },
                 { "DEFORMED", 3, TRUE },    { "BEAM_AXES", 6, export->beams },
                 { "TIES", 2, export->ties } };
  begin_table (export, "LAYER", HANDLE_LAYERS, 5 + export->beams + export->ties);
  for (gsize i = 0; i < G_N_ELEMENTS (layers); i++) {
    if (!layers[i].used)
      continue;
    begin_record (export, "LAYER", export->handle++, HANDLE_LAYERS,
                  "AcDbLayerTableRecord", layers[i].name);
    put_int (export, 70, 0);
    put_int (export, 62, layers[i].color);
    put (export, 6, "CONTINUOUS");
  }
  put_text (export, "  0\nENDTAB\n");
}

static void
put_line_types (Export *export)
{
  static const char *const names[] = { "ByBlock", "ByLayer", "CONTINUOUS" };
  begin_table (export, "LTYPE", HANDLE_LTYPES, G_N_ELEMENTS (names));
  for (gsize i = 0; i < G_N_ELEMENTS (names); i++) {
    begin_record (export, "LTYPE", export->handle++, HANDLE_LTYPES,
                  "AcDbLinetypeTableRecord", names[i]);
    put_text (export, " 70\n0\n  3\n\n 72\n65\n 73\n0\n 40\n0.0\n");
  }
  put_text (export, "  0\nENDTAB\n");
}

static void
put_empty_table (Export *export, const char *name, guint handle)
{
  begin_table (export, name, handle, 0);
  put_text (export, "  0\nENDTAB\n");
}

static void
put_tables (Export *export)
{
  put_text (export, "  0\nSECTION\n  2\nTABLES\n");
  put_empty_table (export, "VPORT", HANDLE_VPORTS);
  put_line_types (export);
  put_layers (export);
  begin_table (export, "STYLE", HANDLE_STYLES, 1);
  begin_record (export, "STYLE", export->handle++, HANDLE_STYLES,
                "AcDbTextStyleTableRecord", "Standard");
  put_text (export, " 70\n0\n  3\ntxt\n  0\nENDTAB\n");
  put_empty_table (export, "VIEW", HANDLE_VIEWS);
  put_empty_table (export, "UCS", HANDLE_UCSS);
  begin_table (export, "APPID", HANDLE_APPIDS, 1);
  begin_record (export, "APPID", export->handle++, HANDLE_APPIDS, "AcDbRegAppTableRecord",
                "ACAD");
  put_text (export, " 70\n0\n  0\nENDTAB\n");
  begin_table (export, "DIMSTYLE", HANDLE_DIMSTYLES, 0);
  put_text (export, "100\nAcDbDimStyleTable\n  0\nENDTAB\n");
  begin_table (export, "BLOCK_RECORD", HANDLE_RECORDS, 2);
  begin_record (export, "BLOCK_RECORD", HANDLE_MODEL, HANDLE_RECORDS,
                "AcDbBlockTableRecord", "*Model_Space");
  begin_record (export, "BLOCK_RECORD", HANDLE_PAPER, HANDLE_RECORDS,
                "AcDbBlockTableRecord", "*Paper_Space");
  put_text (export, "  0\nENDTAB\n  0\nENDSEC\n");
}

static void
put_space (Export *export, const char *name, guint record)
{
  put (export, 0, "BLOCK");
  put_handle (export, 5, export->handle++);
  put_handle (export, 330, record);
  put_text (export, "100\nAcDbEntity\n  8\n0\n100\nAcDbBlockBegin\n");
  put (export, 2, name);
  put_text (export, " 70\n0\n 10\n0.0\n 20\n0.0\n 30\n0.0\n");
  put (export, 3, name);
  put_text (export, "  1\n\n  0\nENDBLK\n");
  put_handle (export, 5, export->handle++);
  put_handle (export, 330, record);
  put_text (export, "100\nAcDbEntity\n  8\n0\n100\nAcDbBlockEnd\n");
}

static void
put_objects (Export *export)
{
  put_text (export, "  0\nSECTION\n  2\nOBJECTS\n  0\nDICTIONARY\n");
  put_handle (export, 5, HANDLE_ROOT);
  put_text (export, "330\n0\n100\nAcDbDictionary\n  3\nACAD_GROUP\n");
  put_handle (export, 350, HANDLE_GROUPS);
  put_text (export, "  0\nDICTIONARY\n");
  put_handle (export, 5, HANDLE_GROUPS);
  put_handle (export, 330, HANDLE_ROOT);
  put_text (export, "100\nAcDbDictionary\n  0\nENDSEC\n");
}

static void
write_entity (Export *export, const char *type, const char *layer, const char *subclass)
{
  put (export, 0, type);
  put_handle (export, 5, export->handle++);
  put_handle (export, 330, HANDLE_MODEL);
  put (export, 100, "AcDbEntity");
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

static void
put_entities (Export *export, const QnModel *model, const QnContacts *contacts,
              const QnResult *result, double scale)
{
  put_text (export, "  0\nSECTION\n  2\nENTITIES\n");
  for (size_t i = 0; i < model->block_count; i++)
    put_block (export, model, (QnId) i,
               qn_support_is_full (model->blocks[i].support) ? "SUPPORTS" : "BLOCKS",
               NULL, 0);
  for (size_t i = 0; contacts != NULL && i < contacts->face_count; i++)
    put_segment (export, "CONTACTS", contacts->faces[i].start, contacts->faces[i].end);
  if (result != NULL && result->step_count > 0) {
    const double *u = qn_result_step_displacements (result, result->step_count - 1);
    for (size_t i = 0; i < model->block_count; i++)
      put_block (export, model, (QnId) i, "DEFORMED", u + i * QN_DOF_COUNT, scale);
  }
  put_beams (export, model, result, scale);
  for (size_t i = 0; i < model->tie_count; i++)
    put_segment (export, "TIES", model->ties[i].ends[0].at, model->ties[i].ends[1].at);
  put_text (export, "  0\nENDSEC\n");
}

gboolean
qn_dxf_export (const QnModel *model, const QnContacts *contacts, const QnResult *result,
               double scale, double unit, const char *path, GError **error)
{
  Export export = { qn_file_writer_open (path, error), unit, FIRST_ENTITY,
                    model->beam_count > 0, model->tie_count > 0 };
  if (export.writer == NULL)
    return FALSE;
  put_text (&export, "  0\nSECTION\n  2\nHEADER\n"
                     "  9\n$ACADVER\n  1\nAC1015\n"
                     "  9\n$HANDSEED\n  5\nFFFFFF\n"
                     "  9\n$INSUNITS\n");
  put_int (&export, 70, qn_dxf_unit_code (export.unit));
  put_text (&export, "  9\n$MEASUREMENT\n 70\n1\n"
                     "  0\nENDSEC\n");
  put_tables (&export);
  put_text (&export, "  0\nSECTION\n  2\nBLOCKS\n");
  put_space (&export, "*Model_Space", HANDLE_MODEL);
  put_space (&export, "*Paper_Space", HANDLE_PAPER);
  put_text (&export, "  0\nENDSEC\n");
  put_entities (&export, model, contacts, result, scale);
  put_objects (&export);
  put_text (&export, "  0\nEOF\n");
  return qn_file_writer_commit (export.writer, error);
}
