#include "io/exchange/vtu.h"

#include "core/model/support.h"
#include "disk/file-group.h"
#include "io/exchange/vtu-xml.h"
#include "io/text/file-writer.h"
#include "io/text/io-error.h"
#include "io/text/number-text.h"

#include <glib/gi18n-lib.h>
#include <stdlib.h>
#include <string.h>

/* VTK's number of the kind of cell that a block is. */
#define VTK_POLYGON 7

/* Longest force arrow, as part of the model's extent. */
#define FORCE_LENGTH 0.1

/* The blocks at one step. */
typedef struct Blocks {
  const QnModel *model;
  const double *u; /* block_count x 3, nullable */
  QnId *owner;     /* block of each vertex, block by block */
  QnVec2 *points;
  size_t *ends;
  size_t point_count;
} Blocks;

static void
blocks_init (Blocks *blocks, const QnModel *model)
{
  *blocks = (Blocks){ .model = model };
  for (size_t i = 0; i < model->block_count; i++)
    blocks->point_count += (size_t) model->blocks[i].vertex_count;
  blocks->owner = g_new (QnId, blocks->point_count);
  blocks->points = g_new (QnVec2, blocks->point_count);
  blocks->ends = g_new (size_t, model->block_count);
  size_t n = 0;
  for (size_t i = 0; i < model->block_count; i++) {
    const QnVec2 *vertices = qn_model_block_vertices (model, (QnId) i);
    for (QnId k = 0; k < model->blocks[i].vertex_count; k++, n++) {
      blocks->owner[n] = (QnId) i;
      blocks->points[n] = vertices[k];
    }
    blocks->ends[i] = n;
  }
}

static void
blocks_clear (Blocks *blocks)
{
  g_free (blocks->owner);
  g_free (blocks->points);
  g_free (blocks->ends);
}

static double
point_value (const void *data, size_t index, int component)
{
  const Blocks *blocks = data;
  QnVec2 p = blocks->points[index];
  return component == 0 ? p.x : component == 1 ? p.y : 0;
}

static double
displacement_value (const void *data, size_t index, int component)
{
  const Blocks *blocks = data;
  if (blocks->u == NULL || component == 2)
    return 0;
  const double *u = blocks->u + (size_t) blocks->owner[index] * QN_DOF_COUNT;
  QnVec2 arm = qn_vec2_sub (blocks->points[index],
                            blocks->model->blocks[blocks->owner[index]].centroid);
  QnVec2 turned = qn_vec2_rotate (arm, cos (u[QN_DOF_RZ]), sin (u[QN_DOF_RZ]));
  QnVec2 moved = qn_vec2_sub (turned, arm);
  return component == 0 ? u[QN_DOF_UX] + moved.x : u[QN_DOF_UY] + moved.y;
}

static double
end_value (const void *data, size_t index, int component)
{
  (void) component;
  return (double) ((const Blocks *) data)->ends[index];
}

static double
polygon_value (const void *data, size_t index, int component)
{
  (void) data;
  (void) index;
  (void) component;
  return VTK_POLYGON;
}

static double
motion_value (const void *data, size_t index, int component)
{
  const Blocks *blocks = data;
  return blocks->u != NULL ? blocks->u[index * QN_DOF_COUNT + (size_t) component] : 0;
}

static double
supported_value (const void *data, size_t index, int component)
{
  const bool *support = ((const Blocks *) data)->model->blocks[index].support;
  (void) component;
  return qn_support_is_any (support);
}

static double
weight_value (const void *data, size_t index, int component)
{
  (void) component;
  return ((const Blocks *) data)->model->blocks[index].weight;
}

static gboolean
write_blocks (const Blocks *blocks, QnFileWriter *writer, GError **error)
{
  if (writer == NULL)
    return FALSE;
  size_t points = blocks->point_count, cells = blocks->model->block_count;
  qn_vtu_begin (writer, points, cells);
  qn_file_writer_puts (writer, "<Points>\n");
  qn_vtu_put_array (writer, "Float64", "Points", 3, points, point_value, blocks);
  qn_file_writer_puts (writer, "</Points>\n<Cells>\n");
  qn_vtu_put_array (writer, "Int64", "connectivity", 1, points, qn_vtu_index_value,
                    blocks);
  qn_vtu_put_array (writer, "Int64", "offsets", 1, cells, end_value, blocks);
  qn_vtu_put_array (writer, "UInt8", "types", 1, cells, polygon_value, blocks);
  qn_file_writer_puts (writer, "</Cells>\n<PointData Vectors=\"displacement\">\n");
  qn_vtu_put_array (writer, "Float64", "displacement", 3, points, displacement_value,
                    blocks);
  qn_file_writer_puts (writer, "</PointData>\n<CellData Scalars=\"block\">\n");
  qn_vtu_put_array (writer, "Int64", "block", 1, cells, qn_vtu_index_value, blocks);
  qn_vtu_put_array (writer, "UInt8", "supported", 1, cells, supported_value, blocks);
  qn_vtu_put_array (writer, "Float64", "motion", 3, cells, motion_value, blocks);
  qn_vtu_put_array (writer, "Float64", "weight", 1, cells, weight_value, blocks);
  qn_file_writer_puts (writer, "</CellData>\n");
  qn_vtu_end (writer);
  return qn_file_writer_commit (writer, error);
}

/* The contact forces at the last equilibrium. */
typedef struct Forces {
  const QnContacts *contacts;
  const QnResult *result;
  double metres_per_newton;
} Forces;

static QnVec2
force_on_b (const Forces *forces, size_t pair)
{
  const QnContactFace *face =
    &forces->contacts->faces[forces->contacts->pairs[pair].face];
  const QnPairResult *state = &forces->result->pairs[pair];
  QnVec2 f = qn_vec2_add_scaled (qn_vec2_scale (state->normal_force, face->normal),
                                 state->shear_force, face->tangent);
  return qn_vec2_scale (-1, f);
}

static double
force_point (const void *data, size_t index, int component)
{
  const Forces *forces = data;
  QnVec2 p = forces->contacts->pairs[index / 2].point;
  if (index % 2 == 1)
    p = qn_vec2_add_scaled (p, forces->metres_per_newton, force_on_b (forces, index / 2));
  return component == 0 ? p.x : component == 1 ? p.y : 0;
}

static double
state_value (const void *data, size_t index, int component)
{
  (void) component;
  return ((const Forces *) data)->result->pairs[index].state;
}

static double
face_value (const void *data, size_t index, int component)
{
  (void) component;
  return ((const Forces *) data)->contacts->pairs[index].face;
}

static double
force_value (const void *data, size_t index, int component)
{
  const QnPairResult *state = &((const Forces *) data)->result->pairs[index];
  return component == 0 ? state->normal_force : state->shear_force;
}

static gboolean
write_forces (const Forces *forces, QnFileWriter *writer, GError **error)
{
  if (writer == NULL)
    return FALSE;
  size_t cells = forces->contacts->pair_count;
  qn_vtu_begin (writer, 2 * cells, cells);
  qn_vtu_put_lines (writer, cells, force_point, forces);
  qn_file_writer_puts (writer, "<CellData Scalars=\"state\">\n");
  qn_vtu_put_array (writer, "Int64", "state", 1, cells, state_value, forces);
  qn_vtu_put_array (writer, "Int64", "face", 1, cells, face_value, forces);
  qn_vtu_put_array (writer, "Float64", "normal_shear_force", 2, cells, force_value,
                    forces);
  qn_file_writer_puts (writer, "</CellData>\n");
  qn_vtu_end (writer);
  return qn_file_writer_commit (writer, error);
}

/* The largest force becomes a tenth of the model's extent. */
static double
force_scale (const Forces *forces, const Blocks *blocks)
{
  QnVec2 low = { INFINITY, INFINITY }, high = { -INFINITY, -INFINITY };
  for (size_t i = 0; i < blocks->point_count; i++) {
    low = qn_vec2 (fmin (low.x, blocks->points[i].x), fmin (low.y, blocks->points[i].y));
    high =
      qn_vec2 (fmax (high.x, blocks->points[i].x), fmax (high.y, blocks->points[i].y));
  }
  double largest = 0;
  for (size_t i = 0; i < forces->contacts->pair_count; i++)
    largest = fmax (largest, qn_vec2_length (force_on_b (forces, i)));
  double extent = fmax (high.x - low.x, high.y - low.y);
  return largest > 0 ? FORCE_LENGTH * extent / largest : 0;
}

/* The files of one export: the list and what it names. */
typedef struct Export {
  QnFileGroup group;
  char *folder, *stem; /* "walls", "wall3" of walls/wall3.pvd */
  GString *entries;    /* of the list */
} Export;

/* Opens a file of the group; messages call it by the place it is meant for. */
static QnFileWriter *
open_member (Export *export, const char *name, GError **error)
{
  g_autofree char *place = g_build_filename (export->folder, name, NULL);
  char *path;
  int trouble = qn_file_group_add (&export->group, name, &path);
  if (trouble != 0) {
    qn_io_error_set_errno (error, place, _ ("cannot be written"), trouble);
    return NULL;
  }
  QnFileWriter *writer = qn_file_writer_open_as (path, place, error);
  free (path);
  return writer;
}

static void
put_entry (Export *export, double time, int part, const char *name)
{
  char number[QN_NUMBER_TEXT_SIZE];
  g_autofree char *escaped = g_markup_escape_text (name, -1);
  g_string_append_printf (
    export->entries, "<DataSet timestep=\"%s\" group=\"\" part=\"%d\" file=\"%s\"/>\n",
    qn_number_text (time, number), part, escaped);
}

static gboolean
write_steps (Export *export, Blocks *blocks, const QnContacts *contacts,
             const QnResult *result, GError **error)
{
  size_t steps = result != NULL && result->step_count > 0 ? result->step_count : 1;
  for (size_t i = 0; i < steps; i++) {
    gboolean has = result != NULL && i < result->step_count;
    g_autofree char *name = g_strdup_printf ("%s_%04zu.vtu", export->stem, i);
    blocks->u = has ? qn_result_step_displacements (result, i) : NULL;
    if (!write_blocks (blocks, open_member (export, name, error), error))
      return FALSE;
    double time = has ? result->steps[i].multiplier : 0;
    put_entry (export, time, 0, name);
    if (blocks->model->element_count == 0)
      continue;
    g_autofree char *beams = g_strdup_printf ("%s_beams_%04zu.vtu", export->stem, i);
    if (!qn_vtu_write_beams (open_member (export, beams, error), blocks->model, result, i,
                             error))
      return FALSE;
    put_entry (export, time, 2, beams);
  }
  if (result == NULL || result->step_count == 0
      || result->pair_count != contacts->pair_count)
    return TRUE;
  g_autofree char *name = g_strdup_printf ("%s_forces.vtu", export->stem);
  Forces forces = { contacts, result, 0 };
  forces.metres_per_newton = force_scale (&forces, blocks);
  if (!write_forces (&forces, open_member (export, name, error), error))
    return FALSE;
  put_entry (export, result->steps[result->step_count - 1].multiplier, 1, name);
  return TRUE;
}

static gboolean
write_list (Export *export, const char *name, GError **error)
{
  QnFileWriter *writer = open_member (export, name, error);
  if (writer == NULL)
    return FALSE;
  qn_file_writer_printf (
    writer,
    "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" "
    "byte_order=\"LittleEndian\">\n<Collection>\n%s</Collection>\n</VTKFile>\n",
    export->entries->str);
  return qn_file_writer_commit (writer, error);
}

gboolean
qn_vtu_export (const QnModel *model, const QnContacts *contacts, const QnResult *result,
               const char *path, GError **error)
{
  Export export = { 0 };
  g_autofree char *name = g_path_get_basename (path);
  gsize length = strlen (name);
  export.folder = g_path_get_dirname (path);
  export.stem = g_strndup (name, g_str_has_suffix (name, ".pvd") ? length - 4 : length);
  export.entries = g_string_new (NULL);

  int trouble = qn_file_group_open (&export.group, export.folder);
  gboolean done = trouble == 0;
  if (done) {
    Blocks blocks;
    blocks_init (&blocks, model);
    done = write_steps (&export, &blocks, contacts, result, error)
           && write_list (&export, name, error);
    blocks_clear (&blocks);
    if (done)
      trouble = qn_file_group_commit (&export.group);
    else
      qn_file_group_discard (&export.group);
  }
  if (trouble != 0)
    qn_io_error_set_errno (error, path, _ ("cannot be written"), trouble);
  g_string_free (export.entries, TRUE);
  g_free (export.folder);
  g_free (export.stem);
  return done && trouble == 0;
}
