#include "cli/base/input.h"
#include "cli/base/message.h"
#include "cli/base/picture.h"
#include "cli/base/progress.h"
#include "cli/base/shown-text.h"
#include "cli/base/subcommand.h"
#include "core/base/integer.h"
#include "core/path/analysis.h"
#include "doc/view/sheet.h"
#include "io/project/project-vehicle.h"
#include "io/text/file-writer.h"
#include "render/figure/plot.h"

#include <glib/gi18n.h>

#define MOST_POSITIONS 10000

/* Least share of the picture's height that the curve takes; the structure is drawn below. The curve is shown
 * up to so many times its least value. */
#define CURVE_SHARE 0.45
#define CURVE_TOP   5.0
#define MARGIN      10.0 /* pt */

/* Of the frame's width, what the axis of positions takes about. */
#define AXIS_SHARE 0.87

typedef struct EnvelopeOptions {
  QnPictureOptions picture;
  QnInputOptions input;
  char *table, *vehicle, *vehicles;
  double from, to, step;
  gboolean one_way, path, quiet;
} EnvelopeOptions;

/* Multipliers over the position of the front, going to the right and to the left; not-a-number where the
 * vehicle loads nothing. */
typedef struct Envelope {
  const QnModel *model;
  gsize load, count;
  double *x, *multiplier[2];
  gsize worst;
  int worst_way;
} Envelope;

/* The vehicle among the growing loads; G_MAXSIZE where there is none. */
static gsize
find_vehicle_load (const QnModel *model)
{
  for (gsize i = 0; i < model->live_load_count; i++)
    if (model->live_loads[i].kind == QN_LOAD_VEHICLE && model->live_loads[i].set == 0)
      return i;
  return G_MAXSIZE;
}

static QnExit
choose_vehicle (const EnvelopeOptions *options, QnModel *model, QnLoad *load)
{
  GError *error = NULL;
  if (options->vehicles != NULL
      && !qn_read_vehicle_file (options->vehicles, model, &error))
    return qn_cli_fail (error);
  if (options->vehicle == NULL)
    return QN_EXIT_DONE;
  QnId vehicle = qn_model_take_vehicle (model, options->vehicle);
  if (vehicle == QN_NONE) {
    g_auto (GStrv) names = qn_dup_vehicle_names ();
    g_autofree char *list = g_strjoinv (", ", names);
    return qn_cli_usage_error ("envelope", _ ("%s: no such vehicle; built in are %s"),
                               options->vehicle, list);
  }
  load->vehicle = vehicle;
  return QN_EXIT_DONE;
}

/* The multiplier at one position. */
static QnExit
solve_at (const QnInput *input, const Envelope *e, gsize position, int way,
          const EnvelopeOptions *options, QnTerminalProgress *progress)
{
  const QnModel *model = &input->project.model;
  QnModel moved;
  QnDiag diag = { 0 };
  QnResult result = { 0 };
  QnExit code = QN_EXIT_DONE;
  double *multiplier = &e->multiplier[way][position];
  *multiplier = (double) NAN;
  QnStatus status = qn_model_copy (model, &moved, &diag);
  if (status != QN_OK)
    return qn_input_fail (input, QN_INPUT_PATH, &diag);
  QnLoad *load = &moved.live_loads[e->load];
  load->position = e->x[position];
  load->reversed = way == 1;
  if (!options->path)
    moved.analysis.procedure = QN_PROCEDURE_LIMIT;
  status = qn_model_prepare (&moved, &diag);
  double down = status == QN_OK
                  ? -qn_model_load_resultant (&moved, moved.dead_load_count + e->load).y
                  : 0;
  if (status == QN_OK && down > 0)
    status = qn_analysis_run (&moved, &input->contacts, qn_terminal_progress_update,
                              progress, &result, &diag);
  if (status != QN_OK) {
    code = qn_input_fail (input, QN_INPUT_PATH, &diag);
  } else if (down > 0 && result.outcome == QN_OUTCOME_DEAD_LOAD_UNSTABLE) {
    qn_cli_error (_ ("%s: no stable equilibrium under the dead load"),
                  input->project.name);
    code = QN_EXIT_NO_ANSWER;
  } else if (down > 0 && result.outcome == QN_OUTCOME_COLLAPSE) {
    *multiplier = result.collapse_multiplier;
  }
  qn_result_clear (&result);
  qn_model_clear (&moved);
  return code;
}

static QnExit
find_envelope (const QnInput *input, const EnvelopeOptions *options, Envelope *e)
{
  const int ways = options->one_way ? 1 : 2;
  QnExit code = QN_EXIT_DONE;
  QnTerminalProgress progress;
  e->worst = G_MAXSIZE;
  qn_interrupt_install ();
  qn_terminal_progress_init (&progress, options->quiet);
  for (gsize i = 0; i < e->count && code == QN_EXIT_DONE; i++)
    for (int way = 0; way < ways && code == QN_EXIT_DONE; way++) {
      code = solve_at (input, e, i, way, options, &progress);
      if (code == QN_EXIT_DONE && qn_interrupt_seen ())
        code = qn_cli_cancelled (input->project.name);
      double here = e->multiplier[way][i];
      if (!isnan (here)
          && (e->worst == G_MAXSIZE || here < e->multiplier[e->worst_way][e->worst])) {
        e->worst = i;
        e->worst_way = way;
      }
    }
  qn_terminal_progress_done (&progress);
  return code;
}

static void
print_worst (const QnInput *input, const Envelope *e)
{
  const QnModel *model = &input->project.model;
  const QnLoad *load = &model->live_loads[e->load];
  const QnVehicle *vehicle = &model->vehicles[load->vehicle];
  const double factor = e->multiplier[e->worst_way][e->worst];
  const double share = qn_model_load_factor (model, load);
  double sum = 0, largest = 0;
  for (int32_t i = 0; i < vehicle->axle_count; i++) {
    sum += share * vehicle->axles[i].load;
    largest = fmax (largest, share * vehicle->axles[i].load);
  }
  qn_print (e->worst_way == 0
              ? _ ("%s: adequacy factor %.5g, its front at x = %.6g m, to the right\n")
              : _ ("%s: adequacy factor %.5g, its front at x = %.6g m, to the left\n"),
            vehicle->name, factor, e->x[e->worst]);
  if (sum > 0)
    qn_print (_ ("axles of %.5g kN in all carry %.5g kN, the heaviest %.5g kN\n"),
              sum / 1000, factor * sum / 1000, factor * largest / 1000);
  qn_print (_ ("that position: --set loads.live[%d].position=%.15g --set "
               "loads.live[%d].reversed=%s\n"),
            (int) e->load, e->x[e->worst], (int) e->load,
            e->worst_way == 1 ? "true" : "false");
}

static QnExit
write_table (const Envelope *e, const char *path)
{
  GError *error = NULL;
  QnFileWriter *writer = qn_file_writer_open (path, &error);
  if (writer == NULL)
    return qn_cli_fail (error);
  qn_file_writer_puts (writer, "position [m],to the right,to the left\n");
  for (gsize i = 0; i < e->count; i++) {
    qn_file_writer_rounded (writer, e->x[i], "%.10g");
    for (int way = 0; way < 2; way++) {
      qn_file_writer_puts (writer, ",");
      if (!isnan (e->multiplier[way][i]))
        qn_file_writer_rounded (writer, e->multiplier[way][i], "%.10g");
    }
    qn_file_writer_puts (writer, "\n");
  }
  qn_file_writer_commit (writer, &error);
  return qn_cli_end (error);
}

/* The structure with the surface of its fill, m. */
static QnBox
find_box (const QnModel *model)
{
  QnBox box = qn_box_of_points (model->vertices, model->vertex_count);
  for (size_t i = 0; i < model->dead_load_count; i++)
    for (int32_t k = 0; k < model->dead_loads[i].surface_count; k++)
      qn_box_add_point (&box, model->dead_loads[i].surface[k]);
  return box;
}

/* A line of points of the structure, at the scale of the axis of positions below `top`. */
static void
draw_line (cairo_t *cr, const QnVec2 *points, int32_t count, gboolean closed,
           const QnPlotPlace *place, double top, double y0)
{
  cairo_new_sub_path (cr);
  for (int32_t k = 0; k < count; k++)
    cairo_line_to (cr, place->x_zero + place->x_scale * points[k].x,
                   y0 + place->x_scale * (top - points[k].y));
  if (closed)
    cairo_close_path (cr);
}

/* The blocks, the fill and the axles at the worst position below the curve. */
static void
draw_structure (cairo_t *cr, const Envelope *e, const QnPage *page,
                const QnPlotPlace *place, double y0)
{
  const QnModel *model = e->model;
  QnLoad load = model->live_loads[e->load];
  const QnVehicle *vehicle = &model->vehicles[load.vehicle];
  const QnColor soil = qn_ink (QN_INK_DEAD_LOAD, 0), live = qn_ink (QN_INK_LIVE_LOAD, 0);
  const double top = find_box (model).max.y;
  load.position = e->x[e->worst];
  load.reversed = e->worst_way == 1;
  cairo_save (cr);
  cairo_rectangle (cr, place->frame.min.x, y0 - MARGIN * page->unit,
                   place->frame.max.x - place->frame.min.x, page->height - y0);
  cairo_clip (cr);
  cairo_set_line_width (cr, 0.6 * page->unit);
  cairo_set_source_rgb (cr, 0, 0, 0);
  for (size_t b = 0; b < model->block_count; b++)
    draw_line (cr, qn_model_block_vertices (model, (QnId) b),
               model->blocks[b].vertex_count, TRUE, place, top, y0);
  cairo_stroke (cr);
  cairo_set_source_rgb (cr, soil.r / 255.0, soil.g / 255.0, soil.b / 255.0);
  for (size_t i = 0; i < model->dead_load_count; i++)
    draw_line (cr, model->dead_loads[i].surface, model->dead_loads[i].surface_count,
               FALSE, place, top, y0);
  cairo_stroke (cr);
  cairo_set_source_rgb (cr, live.r / 255.0, live.g / 255.0, live.b / 255.0);
  for (int32_t n = 0; n < load.convoy; n++)
    for (int32_t i = 0; i < vehicle->axle_count; i++) {
      double x = qn_load_behind_front (model, &load, n, vehicle->axles[i].at);
      cairo_new_sub_path (cr);
      cairo_arc (cr, place->x_zero + place->x_scale * x, y0 - 3 * page->unit,
                 3 * page->unit, 0, 2 * G_PI);
    }
  cairo_stroke (cr);
  cairo_restore (cr);
}

static bool
draw_page (cairo_t *cr, const QnPage *page, void *data, GError **error)
{
  const Envelope *e = data;
  QnFrame frame = qn_page_frame (page, MARGIN);
  const QnBox blocks = qn_box_of_points (e->model->vertices, e->model->vertex_count);
  const QnBox box = find_box (e->model);
  const double least = e->multiplier[e->worst_way][e->worst];
  QnPlotPlace place;
  (void) error;
  g_autoptr (QnPlot) plot =
    qn_plot_new (_ ("position of the front (m)"), _ ("load multiplier"));
  plot->title = e->model->title;
  plot->x.from_zero = false;
  plot->x.low = fmin (e->x[0], blocks.min.x); /* all that is drawn below */
  plot->x.high = fmax (e->x[e->count - 1], blocks.max.x);
  plot->y.high = CURVE_TOP * least;
  qn_plot_mark (plot, QN_MARKS_LINE, _ ("to the right"), 0, e->x, e->multiplier[0],
                e->count);
  qn_plot_mark (plot, QN_MARKS_LINE, _ ("to the left"), 1, e->x, e->multiplier[1],
                e->count)
    ->dash = QN_USUAL_DASH;
  qn_plot_points (plot, _ ("least"), QN_SERIES_REFERENCE, &e->x[e->worst],
                  &e->multiplier[e->worst_way][e->worst], 1, QN_MARKER_DOT, 5);
  double scale = AXIS_SHARE * frame.width / (plot->x.high - plot->x.low);
  double below = scale * (box.max.y - box.min.y) + 3 * MARGIN * page->unit;
  frame.height = fmax (frame.height - below, CURVE_SHARE * frame.height);
  qn_plot_draw (plot, cr, page->unit, &frame, &place);
  draw_structure (cr, e, page, &place, frame.y + frame.height + 2 * MARGIN * page->unit);
  return true;
}

static QnExit
write_picture (const EnvelopeOptions *options, const QnOutput *output,
               const QnInput *input, const Envelope *e)
{
  QnMetadata metadata;
  GError *error = NULL;
  qn_project_get_metadata (&input->project, &metadata);
  metadata.title = e->model->title;
  qn_page_export (options->picture.path, output, &metadata, draw_page, (void *) e,
                  &error);
  return qn_cli_end (error);
}

/* Positions from where the vehicle comes to the structure to where it has left it. */
static QnExit
place_positions (const EnvelopeOptions *options, const QnModel *model, Envelope *e)
{
  const QnBox box = qn_box_of_points (model->vertices, model->vertex_count);
  double from = options->from, to = options->to;
  const QnLoad *load = &model->live_loads[e->load];
  const QnVehicle *vehicle = &model->vehicles[load->vehicle];
  const double length = load->convoy * (qn_vehicle_length (vehicle) + load->headway);
  if (from == G_MAXDOUBLE)
    from = options->one_way ? box.min.x : box.min.x - length;
  if (to == G_MAXDOUBLE)
    to = box.max.x + length;
  double count = floor ((to - from) / options->step + 1e-9) + 1;
  if (!(options->step > 0) || !(count >= 1) || count > MOST_POSITIONS)
    return qn_cli_usage_error ("envelope",
                               _ ("from, to and step give no positions, or more than %d"),
                               MOST_POSITIONS);
  e->count = (gsize) qn_to_integer (count, 1, MOST_POSITIONS);
  e->x = g_new (double, e->count);
  for (int way = 0; way < 2; way++)
    e->multiplier[way] = g_new (double, e->count);
  for (gsize i = 0; i < e->count; i++) {
    e->x[i] = from + (double) i * options->step;
    e->multiplier[0][i] = e->multiplier[1][i] = (double) NAN;
  }
  return QN_EXIT_DONE;
}

static QnExit
make_envelope (const EnvelopeOptions *options, const QnOutput *output, QnInput *input)
{
  QnModel *model = &input->project.model;
  Envelope e = { .model = model, .load = find_vehicle_load (model) };
  if (e.load == G_MAXSIZE)
    return qn_cli_usage_error ("envelope",
                               _ ("there is no vehicle among the live loads"));
  QnExit code = choose_vehicle (options, model, &model->live_loads[e.load]);
  if (code == QN_EXIT_DONE)
    code = place_positions (options, model, &e);
  if (code == QN_EXIT_DONE)
    code = find_envelope (input, options, &e);
  if (code == QN_EXIT_DONE && e.worst == G_MAXSIZE) {
    qn_cli_error (_ ("%s: no position gives a collapse"), input->project.name);
    code = QN_EXIT_NO_ANSWER;
  }
  if (code == QN_EXIT_DONE && !options->quiet && g_strcmp0 (options->table, "-") != 0
      && g_strcmp0 (options->picture.path, "-") != 0)
    print_worst (input, &e);
  if (code == QN_EXIT_DONE && options->table != NULL)
    code = write_table (&e, options->table);
  if (code == QN_EXIT_DONE && options->picture.path != NULL)
    code = write_picture (options, output, input, &e);
  g_free (e.x);
  for (int way = 0; way < 2; way++)
    g_free (e.multiplier[way]);
  return code;
}

static QnExit
run_envelope (const QnSubcommand *self, int argc, char **argv)
{
  EnvelopeOptions options = { .from = G_MAXDOUBLE, .to = G_MAXDOUBLE, .step = 0.25 };
  const GOptionEntry entries[] = {
    { "vehicle", 0, 0, G_OPTION_ARG_STRING, &options.vehicle,
      N_ ("Instead of the project's vehicle, one of its list or built in"), N_ ("NAME") },
    { "vehicles", 0, 0, G_OPTION_ARG_FILENAME, &options.vehicles,
      N_ ("Read more vehicles from this file"), N_ ("FILE.json") },
    { "from", 0, 0, G_OPTION_ARG_DOUBLE, &options.from,
      N_ ("First position of the front, m"), N_ ("X") },
    { "to", 0, 0, G_OPTION_ARG_DOUBLE, &options.to, N_ ("Last position, m"), N_ ("X") },
    { "step", 0, 0, G_OPTION_ARG_DOUBLE, &options.step,
      N_ ("Distance of positions, m (0.25)"), N_ ("LENGTH") },
    { "one-way", 0, 0, G_OPTION_ARG_NONE, &options.one_way,
      N_ ("Only to the right; without it to the left too"), NULL },
    { "path", 0, 0, G_OPTION_ARG_NONE, &options.path,
      N_ ("Follow the path by the project's procedure instead of limit analysis"), NULL },
    { "csv", 0, 0, G_OPTION_ARG_FILENAME, &options.table,
      N_ ("Write the multipliers as a table"), N_ ("TABLE.csv") },
    QN_PICTURE_ENTRIES (options.picture, N_ ("OUT.png|svg|pdf")),
    QN_INPUT_ENTRIES (options.input),
    QN_INPUT_QUIET_ENTRY (&options.quiet),
    G_OPTION_ENTRY_NULL,
  };
  QnInput input = { 0 };
  QnOutput output;
  QnExit code = QN_EXIT_USAGE;

  qn_output_init (&output);
  if (qn_subcommand_parse (self, entries, 1, 1, &argc, &argv))
    code = options.picture.path != NULL
             ? qn_picture_output (self, &options.picture, &output)
             : QN_EXIT_DONE;
  if (code == QN_EXIT_DONE)
    code = qn_input_load (&input, argv[1], &options.input);
  if (code == QN_EXIT_DONE)
    code = qn_input_require_sound (&input);
  if (code == QN_EXIT_DONE)
    code = make_envelope (&options, &output, &input);
  qn_input_clear (&input);
  qn_subcommand_free_values (entries);
  return code;
}

const QnSubcommand qn_cmd_envelope = {
  .name = "envelope",
  .arguments = "MODEL",
  .summary = N_ ("Move a vehicle over a bridge and find where it carries least"),
  .help =
    N_ ("The first vehicle among the live loads is moved from place to place, to the "
        "right and to the left. The least multiplier is the adequacy factor. Picture: "
        "the multiplier over the position, with the bridge below."),
  .run = run_envelope,
};
