#include "io/exchange/table-csv.h"

#include "core/contact/contact-bars.h"
#include "core/model/bar.h"
#include "core/result/curve-motion.h"
#include "core/result/result-contact.h"
#include "io/text/file-writer.h"
#include "io/text/outcome-text.h"

#include <errno.h>
#include <stdlib.h>

/* Heads of columns, behind the name of a body. */
static const char *const motions[] = { " ux [m]", " uy [m]", " rz [rad]" };

const char *
qn_result_body_name (const QnModel *model, QnId body)
{
  return (size_t) body < model->block_count
           ? model->blocks[body].name
           : model->nodes[(size_t) body - model->block_count].name;
}

/* A heading of a name and what it is of it. */
static void
write_heading (QnFileWriter *writer, const char *name, const char *of)
{
  g_autofree char *heading = g_strconcat (name, of, NULL);
  qn_file_writer_csv (writer, ",%s", heading);
}

static void
write_numbers (QnFileWriter *writer, const double *numbers, size_t count)
{
  for (size_t i = 0; i < count; i++)
    qn_file_writer_puts_number (writer, ",", numbers[i]);
}

/* Whether a support settles in any of the loads. */
static gboolean
settles (const QnModel *model, QnId block, QnDof dof)
{
  for (size_t i = 0; i < qn_model_load_count (model); i++) {
    const QnLoad *load = qn_model_load (model, i);
    if (load->kind == QN_LOAD_SETTLEMENT && load->block == block && load->dof == dof)
      return TRUE;
  }
  return FALSE;
}

/* How far supports that settle have gone, and what that takes: a row, or with result NULL the
 * heads of its columns. */
static void
write_settlements (QnFileWriter *writer, const QnModel *model, const QnResult *result,
                   const QnResult *values, size_t step)
{
  static const char *const actions[] = { " Rx [N]", " Ry [N]", " M [N m]" };
  for (size_t s = 0; s < result->support_count; s++)
    for (int dof = 0; dof < QN_DOF_COUNT; dof++) {
      QnId block = result->supports[s];
      if (!settles (model, block, (QnDof) dof))
        continue;
      if (values == NULL) {
        write_heading (writer, model->blocks[block].name, motions[dof]);
        write_heading (writer, model->blocks[block].name, actions[dof]);
        continue;
      }
      const double numbers[] = {
        qn_result_step_displacements (values, step)[block * QN_DOF_COUNT + dof],
        qn_result_step_reactions (values, step)[s * QN_DOF_COUNT + (size_t) dof]
      };
      write_numbers (writer, numbers, 2);
    }
}

static void
write_curve (QnFileWriter *writer, const QnModel *model, const QnContacts *contacts,
             const QnResult *result)
{
  (void) contacts;
  static const char *const events[QN_EVENT_COUNT] = { "", "snap", "collapse" };
  if (result->history.width > 0) {
    qn_file_writer_puts (writer, "time [s],ground x [m/s2],ground y [m/s2]");
    for (int kind = 0; kind < QN_ENERGY_KIND_COUNT; kind++)
      qn_file_writer_printf (writer, ",%s [J]", qn_energy_names[kind]);
    for (size_t i = 0; i < model->track_count; i++)
      write_heading (writer, model->blocks[model->tracks[i].block].name,
                     motions[model->tracks[i].dof]);
    for (size_t i = 0; i < result->history.row_count; i++) {
      const double *row = result->history.rows + i * result->history.width;
      qn_file_writer_puts_number (writer, "\n", row[0]);
      write_numbers (writer, row + 1, result->history.width - 1);
    }
    qn_file_writer_puts (writer, "\n");
    return;
  }
  gboolean staged = model->stage_count > 0;
  g_autofree double *works = staged ? g_new0 (double, result->step_count) : NULL;
  if (staged && !qn_result_sum_work (model, result, works))
    qn_file_writer_fail (writer, ENOMEM);
  QnId block = qn_result_curve_motion (model, result).body;
  const QnPathEvent *buckling = qn_result_find_buckling (result);
  ptrdiff_t buckles = buckling != NULL ? qn_result_buckling_step (result, buckling) : -1;

  qn_file_writer_puts (writer, "step,multiplier [-]");
  for (size_t dof = 0; block != QN_NONE && dof < QN_DOF_COUNT; dof++)
    write_heading (writer, qn_result_body_name (model, block), motions[dof]);
  qn_file_writer_puts (writer, ",iterations,residual [-],event");
  if (staged)
    qn_file_writer_puts (writer, ",stage,cycle,work [J]");
  if (result->reactions != NULL)
    write_settlements (writer, model, result, NULL, 0);
  qn_file_writer_puts (writer, "\n");
  for (size_t i = 0; i < result->step_count; i++) {
    const QnStep *step = &result->steps[i];
    qn_file_writer_csv (writer, "%zu,%g", i, step->multiplier);
    if (block != QN_NONE)
      write_numbers (
        writer, qn_result_step_displacements (result, i) + (size_t) block * QN_DOF_COUNT,
        QN_DOF_COUNT);
    qn_file_writer_csv (writer, ",%d,%g,%s", step->iterations, step->residual,
                        (ptrdiff_t) i == buckles ? "buckling" : events[step->event]);
    if (staged) {
      /* The stage of a step and the number of the cycle that it belongs to, empty where
       * there is none, and the work up to the step. */
      const gboolean known =
        step->stage > 0 && (size_t) step->stage <= model->stage_count;
      g_autofree char *name =
        known ? qn_stage_dup_name (model, step->stage) : g_strdup ("");
      int32_t cycle = known ? qn_stage_cycle (&model->stages[step->stage - 1]) : 0;
      qn_file_writer_csv (writer, ",%s,", name);
      if (cycle > 0)
        qn_file_writer_printf (writer, "%d", cycle);
      write_numbers (writer, &works[i], 1);
    }
    if (result->reactions != NULL)
      write_settlements (writer, model, result, result, i);
    qn_file_writer_puts (writer, "\n");
  }
}

static void
write_displacements (QnFileWriter *writer, const QnModel *model,
                     const QnContacts *contacts, const QnResult *result)
{
  (void) contacts;
  const size_t steps = result->step_count, last = steps > 0 ? steps - 1 : 0;
  qn_file_writer_puts (writer, "block,x [m],y [m],ux [m],uy [m],rz [rad]\n");
  for (size_t i = 0; steps > 0 && i < qn_result_body_count (result); i++) {
    QnVec2 at = i < result->block_count ? model->blocks[i].centroid
                                        : model->nodes[i - result->block_count].at;
    qn_file_writer_csv (writer, "%s,%g,%g", qn_result_body_name (model, (QnId) i), at.x,
                        at.y);
    write_numbers (writer, qn_result_step_displacements (result, last) + i * QN_DOF_COUNT,
                   QN_DOF_COUNT);
    qn_file_writer_puts (writer, "\n");
  }
}

static void
write_contacts (QnFileWriter *writer, const QnModel *model, const QnContacts *contacts,
                const QnResult *result)
{
  const QnBlock *blocks = model->blocks;
  qn_file_writer_puts (writer,
                       "pair,face,block a,block b,x [m],y [m],normal x [-],normal y [-],"
                       "normal force [N],shear force [N],state,damage [-]\n");
  const double *deformation = qn_result_deformation (model, result);
  size_t count = result->step_count > 0 ? contacts->pair_count : 0;
  for (size_t i = 0; i < count; i++) {
    const QnContactPair *pair = &contacts->pairs[i];
    const QnContactFace *face = &contacts->faces[pair->face];
    const QnPairResult *forces = &result->pairs[i];
    QnVec2 point, normal;
    qn_result_contact_place (model, contacts, i, deformation, &point, &normal);
    qn_file_writer_csv (writer, "%zu,%d,%s,%s,%g,%g,%g,%g,%g,%g,%s,%g\n", i, pair->face,
                        blocks[face->a].name, blocks[face->b].name, point.x, point.y,
                        normal.x, normal.y, forces->normal_force, forces->shear_force,
                        qn_pair_state_names[forces->state], forces->damage);
  }
}

static void
write_beams (QnFileWriter *writer, const QnModel *model, const QnContacts *contacts,
             const QnResult *result)
{
  (void) contacts;
  qn_file_writer_puts (writer, "beam,element,node,x [m],y [m],s [m],normal force N [N],"
                               "shear force V [N],moment M [N m]\n");
  gboolean known = result->step_count > 0 && result->beam_forces != NULL
                   && result->element_count == model->element_count;
  const QnBeamForces *forces =
    known ? qn_result_step_beam_forces (result, result->step_count - 1) : NULL;
  for (size_t i = 0; known && i < model->element_count; i++)
    for (int end = 0; end < 2; end++) {
      /* A row for one end of an element. */
      const QnBeamElement *e = &model->elements[i];
      const QnBeam *beam = &model->beams[e->beam];
      QnVec2 at = model->nodes[e->nodes[end]].at;
      QnVec2 from = model->nodes[beam->nodes[0]].at;
      qn_file_writer_csv (writer, "%s,%d,%s,%g,%g,%g,%g,%g,%g\n", beam->name,
                          (int) i - beam->first_element, model->nodes[e->nodes[end]].name,
                          at.x, at.y, qn_vec2_length (qn_vec2_sub (at, from)),
                          forces[i].normal[end], forces[i].shear[end],
                          forces[i].moment[end]);
    }
}

static void
write_ties (QnFileWriter *writer, const QnModel *model, const QnContacts *contacts,
            const QnResult *result)
{
  (void) contacts;
  qn_file_writer_puts (writer,
                       "step,multiplier,time [s],tie,force [N],elongation [m],state\n");
  for (size_t s = 0;
       s < result->step_count && result->tie_count == qn_model_tie_count (model); s++) {
    const QnTieResult *ties = qn_result_step_ties (result, s);
    for (size_t i = 0; ties != NULL && i < qn_model_tie_count (model); i++)
      qn_file_writer_csv (writer, "%zu,%g,%g,%s,%g,%g,%s\n", s,
                          result->steps[s].multiplier, result->steps[s].time,
                          qn_model_tie (model, i)->name, ties[i].force,
                          ties[i].elongation, qn_tie_state_names[ties[i].state]);
  }
}

/* How far the start of a line is from the start of its bar, m; lines of a mesh are bars of their own. */
static double
line_start (const QnBar *bar, int32_t line)
{
  double along = 0;
  for (int32_t i = 0; i < line && !qn_bar_is_mesh (bar); i++) {
    QnVec2 ends[2];
    qn_bar_line (bar, (size_t) i, ends);
    along += qn_vec2_length (qn_vec2_sub (ends[1], ends[0]));
  }
  return along;
}

static void
write_bars (QnFileWriter *writer, const QnModel *model, const QnContacts *contacts,
            const QnResult *result)
{
  size_t count = 0;
  QnBarCrossing *crossings = qn_bar_crossings (model, contacts, &count);
  if (crossings == NULL)
    qn_file_writer_fail (writer, ENOMEM);
  qn_file_writer_puts (
    writer, "bar,line,s [m],x [m],y [m],area [m2],force [N],stress [Pa],state\n");
  for (size_t i = 0; crossings != NULL && i < count && result->step_count > 0; i++) {
    const QnBarCrossing *c = &crossings[i];
    const QnContactPair *pair = &contacts->pairs[c->pair];
    const QnPairResult *forces = &result->pairs[c->pair];
    double area = pair->tributary * contacts->faces[pair->face].thickness;
    double force = qn_bar_axial (pair, forces->normal_force, forces->shear_force);
    qn_file_writer_csv (writer, "%d,%d,%g,%g,%g,%g,%g,%g,%s\n", pair->bar, pair->line,
                        line_start (&model->bars[c->bar], c->line) + c->along,
                        pair->point.x, pair->point.y, area, force, force / area,
                        qn_pair_state_names[forces->state]);
  }
  free (crossings);
}

gboolean
qn_result_table_write (const char *path, QnResultTable table, const QnProject *project,
                       const QnContacts *contacts, const QnResult *result, GError **error)
{
  static void (*const write[]) (QnFileWriter * writer, const QnModel *model,
                                const QnContacts *contacts, const QnResult *result) = {
    [QN_TABLE_CURVE] = write_curve,       [QN_TABLE_DISPLACEMENTS] = write_displacements,
    [QN_TABLE_CONTACTS] = write_contacts, [QN_TABLE_BEAMS] = write_beams,
    [QN_TABLE_BARS] = write_bars,         [QN_TABLE_TIES] = write_ties,
  };
  QnFileWriter *writer = qn_file_writer_open (path);
  write[table](writer, &project->model, contacts, result);
  return qn_file_writer_commit (writer, error);
}
