#include "io/exchange/vtu-xml.h"

typedef struct Beams {
  const QnModel *model;
  const double *u;            /* rows of the nodes, nullable */
  const QnBeamForces *forces; /* nullable */
} Beams;

static QnId
node_of (const Beams *beams, size_t point)
{
  return beams->model->elements[point / 2].nodes[point % 2];
}

static double
point_value (const void *data, size_t index, int component)
{
  const Beams *beams = data;
  QnVec2 at = beams->model->nodes[node_of (beams, index)].at;
  return component == 0 ? at.x : component == 1 ? at.y : 0;
}

static double
displacement_value (const void *data, size_t index, int component)
{
  const Beams *beams = data;
  if (beams->u == NULL || component == 2)
    return 0;
  return beams->u[(size_t) node_of (beams, index) * QN_DOF_COUNT + (size_t) component];
}

/* N, V, M at the end that a point is. */
static double
force_value (const void *data, size_t index, int component)
{
  const Beams *beams = data;
  if (beams->forces == NULL)
    return 0;
  const QnBeamForces *f = &beams->forces[index / 2];
  size_t end = index % 2;
  return component == 0   ? f->normal[end]
         : component == 1 ? f->shear[end]
                          : f->moment[end];
}

static double
beam_value (const void *data, size_t index, int component)
{
  (void) component;
  return ((const Beams *) data)->model->elements[index].beam;
}

gboolean
qn_vtu_write_beams (QnFileWriter *writer, const QnModel *model, const QnResult *result,
                    size_t step, GError **error)
{
  if (writer == NULL)
    return FALSE;
  Beams beams = { .model = model };
  if (result != NULL && step < result->step_count
      && result->node_count == model->node_count)
    beams.u =
      qn_result_step_displacements (result, step) + result->block_count * QN_DOF_COUNT;
  if (beams.u != NULL && result->element_count == model->element_count)
    beams.forces = qn_result_step_beam_forces (result, step);

  size_t cells = model->element_count, points = 2 * cells;
  qn_vtu_begin (writer, points, cells);
  qn_vtu_put_lines (writer, cells, point_value, &beams);
  qn_file_writer_puts (writer, "<PointData Vectors=\"displacement\">\n");
  qn_vtu_put_array (writer, "Float64", "displacement", 3, points, displacement_value,
                    &beams);
  if (beams.forces != NULL)
    qn_vtu_put_array (writer, "Float64", "normal_shear_moment", 3, points, force_value,
                      &beams);
  qn_file_writer_puts (writer, "</PointData>\n<CellData Scalars=\"beam\">\n");
  qn_vtu_put_array (writer, "Int64", "beam", 1, cells, beam_value, &beams);
  qn_file_writer_puts (writer, "</CellData>\n");
  qn_vtu_end (writer);
  return qn_file_writer_commit (writer, error);
}
