#include "io/exchange/vtu.h"

#include "core/base/box.h"
#include "disk/file-group.h"
#include "io/text/file-writer.h"
#include "io/text/io-error.h"
#include "io/text/text-format.h"

#include <glib/gi18n-lib.h>
#include <string.h>

/* VTK's numbers of the kinds of cells that lines and blocks are. */
#define VTK_LINE    3
#define VTK_POLYGON 7

/* Longest force arrow, as part of the model's extent. */
#define FORCE_LENGTH 0.1

/* --- XML ---------------------------------------------------------------------------------- */

/* An array of `count` rows; type as VTK calls it: "Float64", "Int64", "UInt8". */
static void
put_array (QnFileWriter *writer, const char *type, const char *name, size_t components,
           size_t count, const double *values)
{
  qn_file_writer_printf (writer,
                         "<DataArray type=\"%s\" Name=\"%s\" NumberOfComponents=\"%zu\" "
                         "format=\"ascii\">\n",
                         type, name, components);
  for (size_t i = 0; i < count * components; i++) {
    qn_file_writer_number (writer, values[i]);
    qn_file_writer_puts (writer, (i + 1) % components == 0 ? "\n" : " ");
  }
  qn_file_writer_puts (writer, "</DataArray>\n");
}

/* first, first + step, first + 2 step, … */
static void
put_series (QnFileWriter *writer, const char *type, const char *name, size_t count,
            double first, double step)
{
  g_autofree double *values = g_new (double, count);
  for (size_t i = 0; i < count; i++)
    values[i] = first + step * (double) i;
  put_array (writer, type, name, 1, count, values);
}

/* Rows of x, y, 0. */
static void
put_vectors (QnFileWriter *writer, const char *name, size_t count, const QnVec2 *vectors)
{
  g_autofree double *rows = g_new0 (double, 3 * count);
  for (size_t i = 0; i < count; i++) {
    rows[3 * i] = vectors[i].x;
    rows[3 * i + 1] = vectors[i].y;
  }
  put_array (writer, "Float64", name, 3, count, rows);
}

/* The head of a file, and Points and Cells: polygons whose points go up to their `ends`, or without
 * these lines. */
static void
begin (QnFileWriter *writer, size_t points, const QnVec2 *at, size_t cells,
       const double *ends)
{
  qn_file_writer_printf (
    writer,
    "<?xml version=\"1.0\"?>\n"
    "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
    "<UnstructuredGrid>\n<Piece NumberOfPoints=\"%zu\" "
    "NumberOfCells=\"%zu\">\n<Points>\n",
    points, cells);
  put_vectors (writer, "Points", points, at);
  qn_file_writer_puts (writer, "</Points>\n<Cells>\n");
  put_series (writer, "Int64", "connectivity", points, 0, 1);
  if (ends != NULL)
    put_array (writer, "Int64", "offsets", 1, cells, ends);
  else
    put_series (writer, "Int64", "offsets", cells, 2, 2);
  put_series (writer, "UInt8", "types", cells, ends != NULL ? VTK_POLYGON : VTK_LINE, 0);
  qn_file_writer_puts (writer, "</Cells>\n");
}

static gboolean
finish (QnFileWriter *writer, GError **error)
{
  qn_file_writer_puts (writer,
                       "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
  return qn_file_writer_commit (writer, error);
}

/* --- The files: each closes its writer ---------------------------------------------------- */

/* The blocks, moved by u (nullable: block_count x 3). */
static gboolean
write_blocks (QnFileWriter *writer, const QnModel *model, const double *u, GError **error)
{
  const size_t cells = model->block_count;
  size_t points = 0, n = 0;
  for (size_t i = 0; i < cells; i++)
    points += (size_t) model->blocks[i].vertex_count;
  g_autofree QnVec2 *at = g_new (QnVec2, points), *moved = g_new0 (QnVec2, points);
  g_autofree double *ends = g_new (double, cells), *weights = g_new (double, cells);
  g_autofree double *supported = g_new (double, cells);
  g_autofree double *still = g_new0 (double, QN_DOF_COUNT *cells);
  for (size_t i = 0; i < cells; i++) {
    const QnBlock *block = &model->blocks[i];
    const QnVec2 *vertices = qn_model_block_vertices (model, (QnId) i);
    for (QnId k = 0; k < block->vertex_count; k++, n++) {
      at[n] = vertices[k];
      if (u == NULL)
        continue;
      const double *motion = u + i * QN_DOF_COUNT;
      QnVec2 arm = qn_vec2_sub (vertices[k], block->centroid);
      QnVec2 turned =
        qn_vec2_rotate (arm, cos (motion[QN_DOF_RZ]), sin (motion[QN_DOF_RZ]));
      moved[n] = qn_vec2_add (qn_vec2 (motion[QN_DOF_UX], motion[QN_DOF_UY]),
                              qn_vec2_sub (turned, arm));
    }
    ends[i] = (double) n;
    supported[i] = qn_support_is_any (block->support);
    weights[i] = block->weight;
  }

  begin (writer, points, at, cells, ends);
  qn_file_writer_puts (writer, "<PointData Vectors=\"displacement\">\n");
  put_vectors (writer, "displacement", points, moved);
  qn_file_writer_puts (writer, "</PointData>\n<CellData Scalars=\"block\">\n");
  put_series (writer, "Int64", "block", cells, 0, 1);
  put_array (writer, "UInt8", "supported", 1, cells, supported);
  put_array (writer, "Float64", "motion", QN_DOF_COUNT, cells, u != NULL ? u : still);
  put_array (writer, "Float64", "weight", 1, cells, weights);
  return finish (writer, error);
}

/* A line for every element, with what the result, unless it is NULL, has of it at this step. */
static gboolean
write_beam_lines (QnFileWriter *writer, const QnModel *model, const QnResult *result,
                  size_t step, GError **error)
{
  /* Rows of the nodes. */
  const double *u = result != NULL ? qn_result_step_displacements (result, step)
                                       + result->block_count * QN_DOF_COUNT
                                   : NULL;
  const QnBeamForces *forces =
    result != NULL ? qn_result_step_beam_forces (result, step) : NULL;

  const size_t cells = model->element_count, points = 2 * cells;
  g_autofree QnVec2 *at = g_new (QnVec2, points), *moved = g_new0 (QnVec2, points);
  g_autofree double *nvm = g_new0 (double, 3 * points), *beams = g_new (double, cells);
  for (size_t i = 0; i < points; i++) {
    const QnBeamElement *element = &model->elements[i / 2];
    const size_t end = i % 2;
    const QnId node = element->nodes[end];
    at[i] = model->nodes[node].at;
    if (u != NULL) {
      const double *motion = u + (size_t) node * QN_DOF_COUNT;
      moved[i] = qn_vec2 (motion[QN_DOF_UX], motion[QN_DOF_UY]);
    }
    if (forces != NULL) {
      nvm[3 * i] = forces[i / 2].normal[end];
      nvm[3 * i + 1] = forces[i / 2].shear[end];
      nvm[3 * i + 2] = forces[i / 2].moment[end];
    }
    beams[i / 2] = element->beam;
  }

  begin (writer, points, at, cells, NULL);
  qn_file_writer_puts (writer, "<PointData Vectors=\"displacement\">\n");
  put_vectors (writer, "displacement", points, moved);
  if (forces != NULL)
    put_array (writer, "Float64", "normal_shear_moment", 3, points, nvm);
  qn_file_writer_puts (writer, "</PointData>\n<CellData Scalars=\"beam\">\n");
  put_array (writer, "Int64", "beam", 1, cells, beams);
  return finish (writer, error);
}

static QnVec2
force_on_b (const QnContacts *contacts, const QnResult *result, size_t pair)
{
  const QnContactFace *face = &contacts->faces[contacts->pairs[pair].face];
  const QnPairResult *state = &result->pairs[pair];
  QnVec2 f = qn_vec2_add_scaled (qn_vec2_scale (state->normal_force, face->normal),
                                 state->shear_force, face->tangent);
  return qn_vec2_scale (-1, f);
}

/* The contact forces at the last equilibrium; the largest becomes a tenth of the model's extent. */
static gboolean
write_forces (QnFileWriter *writer, const QnModel *model, const QnContacts *contacts,
              const QnResult *result, GError **error)
{
  const size_t cells = contacts->pair_count;
  QnBox bounds = QN_BOX_EMPTY;
  double largest = 0;
  for (size_t i = 0; i < model->block_count; i++)
    qn_box_add_box (&bounds, qn_model_block_box (model, (QnId) i));
  for (size_t i = 0; i < cells; i++)
    largest = fmax (largest, qn_vec2_length (force_on_b (contacts, result, i)));
  const double metres_per_newton =
    largest > 0 ? FORCE_LENGTH * qn_box_size (bounds) / largest : 0;

  g_autofree QnVec2 *points = g_new (QnVec2, 2 * cells);
  g_autofree double *states = g_new (double, cells), *faces = g_new (double, cells);
  g_autofree double *forces = g_new (double, 2 * cells);
  for (size_t i = 0; i < cells; i++) {
    const QnContactPair *pair = &contacts->pairs[i];
    points[2 * i] = pair->point;
    points[2 * i + 1] = qn_vec2_add_scaled (pair->point, metres_per_newton,
                                            force_on_b (contacts, result, i));
    states[i] = result->pairs[i].state;
    faces[i] = pair->face;
    forces[2 * i] = result->pairs[i].normal_force;
    forces[2 * i + 1] = result->pairs[i].shear_force;
  }

  begin (writer, 2 * cells, points, cells, NULL);
  qn_file_writer_puts (writer, "<CellData Scalars=\"state\">\n");
  put_array (writer, "Int64", "state", 1, cells, states);
  put_array (writer, "Int64", "face", 1, cells, faces);
  put_array (writer, "Float64", "normal_shear_force", 2, cells, forces);
  return finish (writer, error);
}

/* --- The group ---------------------------------------------------------------------------- */

/* The files of one export: the list and what it names. */
typedef struct Export {
  QnFileGroup group;
  char *folder, *stem; /* "walls", "wall3" of walls/wall3.pvd */
  GString *entries;    /* of the list */
} Export;

/* Opens a file of the group; messages call it by the place it is meant for. */
static QnFileWriter *
open_member (Export *export, const char *name)
{
  g_autofree char *place = g_build_filename (export->folder, name, NULL);
  g_autofree char *path = NULL;
  int trouble = qn_file_group_add (&export->group, name, &path);
  return qn_file_writer_open_as (path, place, trouble);
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
write_steps (Export *export, const QnModel *model, const QnContacts *contacts,
             const QnResult *result, GError **error)
{
  size_t steps = result != NULL && result->step_count > 0 ? result->step_count : 1;
  for (size_t i = 0; i < steps; i++) {
    gboolean has = result != NULL && i < result->step_count;
    g_autofree char *name = g_strdup_printf ("%s_%04zu.vtu", export->stem, i);
    if (!write_blocks (open_member (export, name), model,
                       has ? qn_result_step_displacements (result, i) : NULL, error))
      return FALSE;
    double time = has ? result->steps[i].multiplier : 0;
    put_entry (export, time, 0, name);
    if (model->element_count == 0)
      continue;
    g_autofree char *beams = g_strdup_printf ("%s_beams_%04zu.vtu", export->stem, i);
    if (!write_beam_lines (open_member (export, beams), model, has ? result : NULL, i,
                           error))
      return FALSE;
    put_entry (export, time, 2, beams);
  }
  if (result == NULL || result->step_count == 0
      || result->pair_count != contacts->pair_count)
    return TRUE;
  g_autofree char *name = g_strdup_printf ("%s_forces.vtu", export->stem);
  if (!write_forces (open_member (export, name), model, contacts, result, error))
    return FALSE;
  put_entry (export, result->steps[result->step_count - 1].multiplier, 1, name);
  return TRUE;
}

static gboolean
write_list (Export *export, const char *name, GError **error)
{
  QnFileWriter *writer = open_member (export, name);
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
  gboolean done = trouble == 0 && write_steps (&export, model, contacts, result, error)
                  && write_list (&export, name, error);
  if (done)
    trouble = qn_file_group_commit (&export.group);
  else if (trouble == 0)
    qn_file_group_discard (&export.group);
  if (trouble != 0)
    qn_io_error_set_errno (error, path, _ ("cannot be written"), trouble);
  g_string_free (export.entries, TRUE);
  g_free (export.folder);
  g_free (export.stem);
  return done && trouble == 0;
}
