/* Earthquakes in the window: the history while it is computed, energies, initial motion by fields,
 * capacity against a spectrum. */
#include "driver.h"

#include "app/widgets/quantity-entry.h"
#include "app/widgets/settings.h"
#include "doc/edit/edit-dynamic.h"
#include "doc/view/capacity-settings.h"
#include "io/project/project.h"
#include "support/edit-model.h"
#include "support/room.h"

#include <math.h>
#include <string.h>

/* ---- while it runs ---- */

static gboolean
take_long (QnModel *model, gpointer data, GError **error)
{
  (void) data;
  (void) error;
  model->analysis.dynamic.duration = 5000;
  model->ground[0].rests = true; /* the record is of 10 s */
  return TRUE;
}

static gboolean
has_live_history (gpointer window)
{
  gsize count = 0;
  QnJob *job = qn_window_get_document (window)->job;
  const QnVec2 *curve = job != NULL ? qn_job_get_curve (job, &count) : NULL;
  return count >= 3 && curve[0].x >= 0.0
         && driver_find_widget (window, driver_says, " of 5000 s") != NULL
         && driver_find_widget (window, driver_says, " left") != NULL;
}

/* The history grows over the whole time of the analysis; what has come so far is told with the time
 * that is left. */
static void
test_live_history (void)
{
  QnWindow *window = driver_open_example ("43-shaken-wall.quoin");
  QnDocument *document = qn_window_get_document (window);
  g_assert_true (edit_model (document, "Longer", NULL, take_long, NULL, NULL));
  driver_activate (window, "win.show-panel::result");
  driver_activate (window, "win.run");
  driver_wait (has_live_history, window);
  QnBox range = driver_plot_range (
    driver_find_widget (GTK_WIDGET (window), driver_has_name, "curve"));
  g_assert_cmpfloat_with_epsilon (range.min.x, 0.0, 1e-6);
  g_assert_cmpfloat_with_epsilon (range.max.x, 5000.0, 1e-6);
  driver_screenshot (GTK_WIDGET (window), "live-history");
  driver_activate (window, "win.cancel");
  driver_wait_for_job (window);
  const QnRun *run = document->run;
  g_assert_cmpint (run->result.outcome, ==, QN_OUTCOME_CANCELLED);
  driver_discard (window);
}

/* A history that was followed to its end has reached no target, and no other method has a multiplier
 * to add. */
static void
test_end_of_history (void)
{
  QnWindow *window = driver_open_example ("41-column-impulse.quoin");
  driver_activate (window, "win.show-panel::result");
  driver_activate (window, "win.run");
  driver_wait_for_job (window);
  /* It says so, and how far it moved; the picture is of that time, at true scale at least. */
  const QnRun *run = qn_window_get_document (window)->run;
  QnViewState *state = state_of (window);
  g_assert_nonnull (driver_find_widget (GTK_WIDGET (window), driver_says, "Stands"));
  g_assert_nonnull (
    driver_find_widget (GTK_WIDGET (window), driver_says, "Largest displacement: "));
  g_assert_cmpint (qn_view_state_get_step (state), ==,
                   qn_result_step_at (&run->result, run->result.history.peak_time));
  g_assert_cmpfloat (qn_view_state_get_shown_scale (state), >=, 1.0);
  driver_screenshot (GTK_WIDGET (window), "history-stands");
  g_assert_null (driver_find_widget (GTK_WIDGET (window), driver_says, "Target reached"));
  GtkWidget *others =
    driver_find_widget (GTK_WIDGET (window), driver_is_button, "Solve by _All Methods");
  g_assert_nonnull (others);
  g_assert_false (gtk_widget_get_mapped (others));
  driver_discard (window);
}

/* ---- energies ---- */

static int
step_of (QnWindow *window)
{
  return qn_view_state_get_step (state_of (window));
}

static double
time_of (QnWindow *window)
{
  const QnRun *run = qn_window_get_document (window)->run;
  return run->result.steps[step_of (window)].time;
}

/* The plot leads to the time that is clicked, the arrow keys go on; values are told. */
static void
test_energies (void)
{
  QnWindow *window = driver_open_example ("41-column-impulse.quoin");
  driver_activate (window, "win.show-panel::result");
  driver_activate (window, "win.run");
  driver_wait_for_job (window);
  GtkWidget *plot =
    driver_find_widget (GTK_WIDGET (window), driver_has_name, "energy-plot");
  g_assert_true (gtk_widget_get_mapped (plot));
  double width = gtk_widget_get_width (plot);
  driver_point_at (plot, 0.6 * width, 40);
  driver_press_button ("1");
  double clicked = time_of (window);
  g_assert_cmpfloat (clicked, >, 2.0);
  g_assert_cmpfloat (clicked, <, 6.0);
  int step = step_of (window);
  driver_key ("Right");
  g_assert_cmpint (step_of (window), ==, step + 1);
  const char *const kinds[] = { "input",   "kinetic",   "elastic", "friction",
                                "damping", "numerical", "error" };
  for (gsize i = 0; i < G_N_ELEMENTS (kinds); i++) {
    g_autofree char *text = g_strdup_printf ("%s: ", kinds[i]);
    g_assert_nonnull (driver_find_widget (GTK_WIDGET (window), driver_says, text));
  }
  driver_screenshot (GTK_WIDGET (window), "energies");

  /* Values under the pointer, elsewhere than at the step. */
  g_autofree char *before = g_strdup (gtk_label_get_text (
    GTK_LABEL (driver_find_widget (GTK_WIDGET (window), driver_says, "kinetic: "))));
  driver_point_at (plot, 0.3 * width, 60);
  g_assert_null (driver_find_widget (GTK_WIDGET (window), driver_says, before));
  driver_discard (window);
}

/* ---- playback ---- */

static gboolean
is_toggle (GtkWidget *widget, gconstpointer tip)
{
  return GTK_IS_TOGGLE_BUTTON (widget)
         && g_strcmp0 (gtk_widget_get_tooltip_text (widget), tip) == 0;
}

static gboolean
has_come_far (gpointer window)
{
  return time_of (window) >= 0.4;
}

static gboolean
is_choice (GtkWidget *widget, gconstpointer tip)
{
  return GTK_IS_DROP_DOWN (widget)
         && g_strcmp0 (gtk_widget_get_tooltip_text (widget), tip) == 0;
}

static gboolean
is_gone (gpointer weak)
{
  return *(gpointer *) weak == NULL;
}

static gboolean
has_stopped (gpointer window)
{
  const QnRun *run = qn_window_get_document (window)->run;
  return step_of (window) == (int) run->result.step_count - 1;
}

/* An analysis in time is played second for second or slowed, from the step that is shown; who goes to
 * another time meanwhile goes on from there; without a loop it stops at the end. */
static void
test_playback (void)
{
  QnWindow *window = driver_open_example ("41-column-impulse.quoin");
  QnViewState *state = state_of (window);
  driver_activate (window, "win.run");
  driver_wait_for_job (window);
  GtkWidget *speed = driver_find_widget (GTK_WIDGET (window), is_choice,
                                         "Speed; 1× is real time of an analysis in time");
  g_assert_nonnull (speed);
  driver_set_animated (TRUE);
  const guint speeds[] = { 3, 0 }; /* 1 and a tenth */
  const double slowed[] = { 1, 10 };
  for (gsize i = 0; i < G_N_ELEMENTS (speeds); i++) {
    qn_view_state_set_step (state, 0);
    gtk_drop_down_set_selected (GTK_DROP_DOWN (speed), speeds[i]);
    gint64 start = g_get_monotonic_time ();
    driver_activate (window, "win.play");
    driver_wait (has_come_far, window);
    double seconds = 1e-6 * (double) (g_get_monotonic_time () - start);
    /* kept steps are apart */
    g_assert_cmpfloat (time_of (window), <=, seconds / slowed[i] + 0.05);
    g_assert_cmpint (state->options.view, ==, QN_VIEW_DEFORMED);
    driver_activate (window, "win.play");
  }
  int held = step_of (window);
  driver_settle ();
  g_assert_cmpint (step_of (window), ==, held);

  GtkWidget *loop = driver_find_widget (GTK_WIDGET (window), is_toggle, "Loop");
  gtk_toggle_button_set_active (GTK_TOGGLE_BUTTON (loop), FALSE);
  driver_activate (window, "win.play");
  const QnRun *run = qn_window_get_document (window)->run;
  int late = (int) run->result.step_count - 4;
  qn_view_state_set_step (state, late);
  driver_settle ();
  g_assert_cmpint (step_of (window), >=, late);
  gtk_drop_down_set_selected (GTK_DROP_DOWN (speed), 3);
  driver_wait (has_stopped, window);
  driver_set_animated (FALSE);
  driver_settle (); /* plays no longer */
  g_assert_true (has_stopped (window));
  driver_discard (window);
}

/* ---- where blocks start ---- */

static gboolean
start_is (QnWindow *window, double x, double y, double angle)
{
  const QnModel *model = model_of (window);
  if (model->initial_count != 1)
    return FALSE;
  const double *u = model->initial[0].displacement;
  return fabs (u[0] - x) < 1e-9 && fabs (u[1] - y) < 1e-9 && fabs (u[2] - angle) < 1e-9;
}

static gboolean
choose_dynamic (QnModel *model, gpointer data, GError **error)
{
  (void) data;
  return qn_edit_choose_dynamic (model, error);
}

/* Types a displacement into the first field of where the selected blocks start, which is horizontal. */
static void
type_start (QnWindow *window, const char *text)
{
  GtkWidget *field = driver_find_id (GTK_WIDGET (window), "initial_ux");
  g_assert_nonnull (field);
  gtk_widget_grab_focus (field);
  driver_key ("ctrl+a");
  driver_type (text);
  driver_key ("Return");
}

/* A selected block starts where its fields say; one step, and what becomes of it. */
static void
test_initial (void)
{
  QnWindow *window = driver_open_example ("02-overturning-block.quoin");
  QnDocument *document = qn_window_get_document (window);
  const QnModel *model = model_of (window);
  QnId top = 0;
  for (gsize i = 0; i < model->block_count; i++)
    if (!model->blocks[i].support[0])
      top = (QnId) i;
  g_assert_true (edit_model (document, "In Time", NULL, choose_dynamic, NULL, NULL));
  qn_selection_set (document->selection, QN_PICK_BLOCK, &top, 1);
  driver_open_analysis (window);
  driver_settle ();
  g_assert_nonnull (
    driver_find_widget (GTK_WIDGET (window), driver_says, "Start of Block"));
  type_start (window, "20 mm");
  g_assert_true (start_is (window, 0.02, 0.0, 0.0));
  driver_screenshot (GTK_WIDGET (window), "initial-fields");
  driver_activate (window, "win.undo");
  g_assert_cmpuint (model_of (window)->initial_count, ==, 0);
  driver_activate (window, "win.redo");
  driver_activate (window, "win.run");
  driver_wait_for_job (window);
  const QnRun *run = document->run;
  g_assert_cmpuint (run->result.history.row_count, >, 10);
  g_assert_cmpfloat (run->result.history.peaks[top], >, 0.0);
  driver_discard (window);
}

/* What is fixed cannot start elsewhere: refused, and nothing has changed. */
static void
test_initial_fixed (void)
{
  QnWindow *window = driver_open_example ("02-overturning-block.quoin");
  QnDocument *document = qn_window_get_document (window);
  const QnModel *model = model_of (window);
  QnId base = 0;
  for (gsize i = 0; i < model->block_count; i++)
    if (model->blocks[i].support[0])
      base = (QnId) i;
  g_assert_true (edit_model (document, "In Time", NULL, choose_dynamic, NULL, NULL));
  qn_selection_set (document->selection, QN_PICK_BLOCK, &base, 1);
  driver_open_analysis (window);
  type_start (window, "0.1 m");
  g_assert_cmpuint (model_of (window)->initial_count, ==, 0);
  g_assert_nonnull (driver_find_widget (GTK_WIDGET (window), driver_says, "is fixed"));
  driver_discard (window);
}

/* ---- capacity ---- */

static gboolean
has_ratio (gpointer dialog)
{
  return driver_find_widget (dialog, driver_says, "EN 1998-3") != NULL;
}

static gboolean
has_alpha0 (gpointer dialog)
{
  return driver_find_widget (dialog, driver_says, "alpha0") != NULL;
}

static gboolean
has_note (gpointer dialog)
{
  return driver_find_widget (dialog, driver_says, "The model has changed since.") != NULL;
}

/* The curve is found in the background and held against the spectrum entered; another spectrum is held
 * against it at once. */
static void
test_capacity (void)
{
  QnWindow *window = driver_open_example ("02-overturning-block.quoin");
  driver_activate (window, "win.capacity");
  GtkWidget *dialog = driver_find_page ("Capacity Curve");
  g_assert_nonnull (dialog);
  driver_press (dialog, "Compute Curve");
  driver_wait (has_ratio, dialog);
  driver_screenshot (dialog, "capacity");
  g_assert_nonnull (driver_find_widget (dialog, driver_says, "Block block"));
  const char *const states[] = { "SLV", "SLC", "SD", "NC" };
  for (gsize i = 0; i < G_N_ELEMENTS (states); i++)
    g_assert_nonnull (driver_find_widget (dialog, driver_says, states[i]));

  /* By the mechanism there are no checks of EN 1998-3. */
  GtkWidget *mechanism = driver_find_widget (dialog, driver_has_id, "mechanism");
  gtk_check_button_set_active (GTK_CHECK_BUTTON (mechanism), TRUE);
  driver_settle ();
  g_assert_false (has_ratio (dialog));
  driver_press (dialog, "Compute Curve");
  driver_wait (has_alpha0, dialog);
  g_assert_false (has_ratio (dialog));
  g_assert_nonnull (driver_find_widget (dialog, driver_says, "SLC"));
  driver_screenshot (dialog, "capacity-mechanism");
  gtk_check_button_set_active (GTK_CHECK_BUTTON (mechanism), FALSE);
  driver_settle ();
  driver_press (dialog, "Compute Curve");
  driver_wait (has_ratio, dialog);

  /* A spectrum from a file has no soil; none has no table. */
  GtkWidget *kind = driver_find_widget (dialog, driver_has_name, "GtkDropDown");
  gtk_drop_down_set_selected (GTK_DROP_DOWN (kind), 3);
  driver_settle ();
  g_assert_false (has_ratio (dialog));
  driver_screenshot (dialog, "capacity-alone");
  gtk_drop_down_set_selected (GTK_DROP_DOWN (kind), 1);
  driver_settle ();
  g_assert_true (has_ratio (dialog));

  /* What is edited meanwhile is told; what is no part of the model is not. */
  g_assert_true (qn_document_edit_extra (qn_window_get_document (window), "Report", NULL,
                                         "report", "{ \"paper\": \"letter\" }", NULL));
  driver_settle ();
  g_assert_false (has_note (dialog));
  QnId top = 0;
  for (gsize i = 0; i < model_of (window)->block_count; i++)
    if (!model_of (window)->blocks[i].support[0])
      top = (QnId) i;
  qn_selection_set (qn_window_get_document (window)->selection, QN_PICK_BLOCK, &top, 1);
  driver_activate (window, "win.nudge((0.01,0.0))");
  driver_wait (has_note, dialog);

  /* The selected block is controlled; one that is not there is refused. */
  driver_press (dialog, "Use Selected Block");
  driver_settle ();
  driver_press (dialog, "Compute Curve");
  driver_wait (has_ratio, dialog);
  g_assert_false (has_note (dialog));
  driver_discard (window);
}

static double
entered (GtkWidget *dialog, const char *id)
{
  return qn_quantity_entry_get_value (
    QN_QUANTITY_ENTRY (driver_find_widget (dialog, driver_has_id, id)));
}

static guint
chosen (GtkWidget *dialog, const char *id)
{
  return gtk_drop_down_get_selected (
    GTK_DROP_DOWN (driver_find_widget (dialog, driver_has_id, id)));
}

static char *
kept (QnWindow *window)
{
  return qn_project_dup_extra (qn_document_get_project (qn_window_get_document (window)),
                               QN_CAPACITY_MEMBER);
}

/* What is entered for the spectrum is kept in the project, undone and done again; the page follows. */
static void
test_capacity_undo (void)
{
  QnWindow *window = driver_open_example ("02-overturning-block.quoin");
  driver_activate (window, "win.capacity");
  GtkWidget *dialog = driver_find_page ("Capacity Curve");
  g_assert_null (kept (window));
  double first = entered (dialog, "ag");
  GtkWidget *ag = driver_find_widget (dialog, driver_has_id, "ag");
  gtk_widget_grab_focus (ag);
  gtk_editable_set_text (GTK_EDITABLE (ag), "0.4");
  driver_key ("Return");
  g_assert_cmpfloat (entered (dialog, "ag"), ==, 0.4);
  g_autofree char *after_ag = kept (window);
  g_assert_nonnull (after_ag);
  guint soil = chosen (dialog, "soil");
  gtk_drop_down_set_selected (
    GTK_DROP_DOWN (driver_find_widget (dialog, driver_has_id, "soil")), soil + 2);
  driver_settle ();
  g_autofree char *after_soil = kept (window);
  g_assert_cmpstr (after_soil, !=, after_ag);

  driver_activate (window, "win.undo");
  g_autofree char *undone = kept (window);
  if (undone != NULL) { /* each a step of its own */
    g_assert_cmpstr (undone, ==, after_ag);
    g_assert_cmpuint (chosen (dialog, "soil"), ==, soil);
    driver_activate (window, "win.undo");
  }
  g_assert_null (kept (window));
  g_assert_cmpfloat (entered (dialog, "ag"), ==, first);
  g_assert_cmpuint (chosen (dialog, "soil"), ==, soil);
  driver_activate (window, "win.redo");
  driver_activate (window, "win.redo");
  g_autofree char *redone = kept (window);
  g_assert_cmpstr (redone, ==, after_soil);
  g_assert_cmpfloat (entered (dialog, "ag"), ==, 0.4);
  g_assert_cmpuint (chosen (dialog, "soil"), ==, soil + 2);
  driver_discard (window);
}

/* The page of the curve, or the project's, is closed while the curve is searched: the search ends and
 * nothing outlives it. */
static void
close_while_searching (gboolean project)
{
  QnWindow *window = driver_open_example ("12-facade.quoin");
  driver_activate (window, "win.capacity");
  GtkWidget *dialog = driver_find_page ("Capacity Curve");
  g_assert_nonnull (dialog);
  driver_press (dialog, "Compute Curve");
  GtkWidget *cancel = driver_find_widget (dialog, driver_has_id, "cancel");
  g_assert_true (gtk_widget_get_mapped (cancel));
  gpointer gone = dialog;
  g_object_add_weak_pointer (G_OBJECT (dialog), &gone);
  if (!project) {
    driver_activate (window, "win.close-page");
    driver_wait (is_gone, &gone);
  }
  driver_discard (window);
  g_assert_null (gone);
}

static void
test_capacity_closed (void)
{
  close_while_searching (FALSE);
  close_while_searching (TRUE);
}

/* In a small window the checks and the curve come before what was entered. */
static void
test_capacity_in_sight (void)
{
  QnWindow *window = driver_open_window (1024, 700);
  g_autofree char *path = driver_example_path ("02-overturning-block.quoin");
  g_assert_true (qn_window_open_path (window, path));
  driver_activate (window, "win.capacity");
  GtkWidget *page = driver_find_page ("Capacity Curve");
  driver_press (page, "Compute Curve");
  driver_wait (has_ratio, page);
  static const char *const parts[] = { "table", "plot" };
  for (gsize i = 0; i < G_N_ELEMENTS (parts); i++) {
    graphene_rect_t at;
    g_assert_true (
      gtk_widget_compute_bounds (driver_find_id (page, parts[i]), page, &at));
    g_assert_cmpfloat (at.origin.y, >=, 0);
    g_assert_cmpfloat (at.origin.y + at.size.height, <=, gtk_widget_get_height (page));
  }
  driver_screenshot (page, "capacity-small");
  driver_discard (window);
}

static gboolean
is_preview (GtkWidget *widget, gconstpointer data)
{
  (void) data;
  return driver_has_id (widget, "preview") && gtk_widget_get_mapped (widget);
}

static gboolean
lose_record (QnModel *model, gpointer data, GError **error)
{
  (void) data;
  (void) error;
  g_free (model->ground[0].record);
  model->ground[0].record = g_strdup ("nowhere.csv");
  return TRUE;
}

/* A record is plotted from its file, before any analysis and however long that is; one that cannot be
 * read is named with what is wrong. */
static void
test_record (void)
{
  QnWindow *window = driver_open_example ("43-shaken-wall.quoin");
  QnDocument *document = qn_window_get_document (window);
  driver_open_analysis (window);
  GtkWidget *root = GTK_WIDGET (window);
  GtkWidget *plot = driver_find_widget (root, driver_has_id, "plot");
  GtkWidget *fault = driver_find_widget (root, driver_has_id, "fault");
  GtkWidget *preview = driver_find_widget (root, is_preview, NULL);
  g_assert_true (gtk_widget_get_mapped (plot));
  g_assert_false (gtk_widget_get_mapped (fault));
  gtk_widget_grab_focus (
    driver_find_widget (root, driver_has_id, "remove")); /* in sight */
  for (guint i = 0; i < 4; i++) {
    g_autofree char *name = g_strdup_printf ("record-%u", i);
    gtk_drop_down_set_selected (GTK_DROP_DOWN (preview), i);
    driver_settle ();
    g_assert_true (gtk_widget_get_mapped (plot));
    driver_screenshot (root, name);
  }
  g_assert_true (edit_model (document, "Longer", NULL, take_long, NULL, NULL));
  driver_settle ();
  g_assert_true (gtk_widget_get_mapped (plot));
  g_assert_true (edit_model (document, "Lose", NULL, lose_record, NULL, NULL));
  driver_settle ();
  g_assert_false (gtk_widget_get_mapped (plot));
  g_assert_true (gtk_widget_get_mapped (fault));
  driver_screenshot (root, "record-lost");
  const char *told = gtk_label_get_text (GTK_LABEL (fault));
  g_test_message ("%s", told);
  g_assert_nonnull (strstr (told, "ground[0].record"));
  g_assert_nonnull (strstr (told, "nowhere.csv"));
  driver_activate (window, "win.undo");
  g_assert_true (gtk_widget_get_mapped (plot));
  driver_discard (window);
}

/* Damping as a part of the critical one needs the modes: of the first and the last it is what was
 * entered, one step of the history; their periods stand in the spectrum of the ground. */
static void
test_damping (void)
{
  QnWindow *window = driver_open_example ("43-shaken-wall.quoin");
  QnDocument *document = qn_window_get_document (window);
  const QnDynamicSettings before = document->project.model.analysis.dynamic;
  driver_open_analysis (window);
  GtkWidget *ratio = driver_find_widget (GTK_WIDGET (window), driver_has_id, "ratio");
  g_assert_false (gtk_widget_is_sensitive (ratio));
  driver_activate (window, "win.run-modes::dead");
  driver_wait_for_job (window);
  driver_open_analysis (window);
  g_assert_true (gtk_widget_is_sensitive (ratio));
  gtk_widget_grab_focus (ratio);
  driver_key ("ctrl+a");
  driver_type ("0.05");
  driver_key ("Return");
  const GPtrArray *runs = document->runs;
  const QnRun *ends[] = { runs->pdata[0], runs->pdata[runs->len - 1] };
  const QnDynamicSettings *after = &document->project.model.analysis.dynamic;
  for (guint i = 0; i < G_N_ELEMENTS (ends); i++) {
    const double omega = ends[i]->result.vibration.omega;
    g_assert_cmpfloat_with_epsilon (
      0.5 * (after->mass_damping / omega + after->joint_damping * omega), 0.05, 1e-9);
  }
  g_assert_cmpfloat_with_epsilon (qn_quantity_entry_get_value (QN_QUANTITY_ENTRY (ratio)),
                                  0.05, 1e-9);
  GtkWidget *preview = driver_find_widget (GTK_WIDGET (window), is_preview, NULL);
  gtk_drop_down_set_selected (GTK_DROP_DOWN (preview), 3);
  driver_settle ();
  driver_screenshot (GTK_WIDGET (window), "damping");
  driver_activate (window, "win.undo");
  after = &document->project.model.analysis.dynamic;
  g_assert_cmpfloat (after->mass_damping, ==, before.mass_damping);
  g_assert_cmpfloat (after->joint_damping, ==, before.joint_damping);
  driver_discard (window);
}

static gboolean
rests (const QnModel *model)
{
  return model->ground[0].rests;
}

static gboolean
follows (const QnModel *model)
{
  return model->analysis.dynamic.follow;
}

static gboolean
falls (const QnModel *model)
{
  return model->analysis.dynamic.fall;
}

/* A record that ends too soon is given rest, contacts follow the blocks, the motion goes on after an
 * overturning: each with a button, and undo takes it back. */
static void
test_buttons (void)
{
  static const struct {
    const char *name;
    gboolean (*holds) (const QnModel *model);
  } buttons[] = { { "rests", rests }, { "follow", follows }, { "fall", falls } };
  QnWindow *window = driver_open_example ("43-shaken-wall.quoin");
  driver_open_analysis (window);
  /* Paths of equilibria have a button "follow" as well. */
  GtkWidget *last = driver_find_widget (GTK_WIDGET (window), driver_has_id, "fall");
  GtkWidget *form = gtk_widget_get_parent (last);
  for (gsize i = 0; i < G_N_ELEMENTS (buttons); i++) {
    GtkWidget *check = driver_find_widget (form, driver_has_id, buttons[i].name);
    g_assert_true (gtk_widget_get_visible (check));
    g_assert_false (gtk_check_button_get_active (GTK_CHECK_BUTTON (check)));
    gtk_check_button_set_active (GTK_CHECK_BUTTON (check), TRUE);
    driver_settle ();
    g_assert_true (buttons[i].holds (model_of (window)));
    driver_activate (window, "win.undo");
    g_assert_false (buttons[i].holds (model_of (window)));
    g_assert_false (gtk_check_button_get_active (GTK_CHECK_BUTTON (check)));
  }
  driver_discard (window);
}

QN_TESTS
{
  gtk_init ();
  g_test_add_func ("/app/earthquakes/live-history", test_live_history);
  g_test_add_func ("/app/earthquakes/end", test_end_of_history);
  g_test_add_func ("/app/earthquakes/record", test_record);
  g_test_add_func ("/app/earthquakes/damping", test_damping);
  g_test_add_func ("/app/earthquakes/buttons", test_buttons);
  g_test_add_func ("/app/earthquakes/energies", test_energies);
  g_test_add_func ("/app/earthquakes/playback", test_playback);
  g_test_add_func ("/app/earthquakes/initial", test_initial);
  g_test_add_func ("/app/earthquakes/initial-fixed", test_initial_fixed);
  g_test_add_func ("/app/earthquakes/capacity", test_capacity);
  g_test_add_func ("/app/earthquakes/capacity-undo", test_capacity_undo);
  g_test_add_func ("/app/earthquakes/capacity-closed", test_capacity_closed);
  g_test_add_func ("/app/earthquakes/capacity-in-sight", test_capacity_in_sight);
}
