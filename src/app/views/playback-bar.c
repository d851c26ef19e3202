#include "app/forms/panel.h"
#include "app/widgets/builder.h"
#include "app/widgets/layouts.h"
#include "app/widgets/quantity-entry.h"
#include "app/widgets/settings.h"
#include "core/base/integer.h"
#include "doc/view/load-text.h"
#include "io/text/outcome-text.h"
#include <glib/gi18n.h>
#include <math.h>

typedef struct Bar {
  QnViewState *state;
  GtkWidget *box, *play, *slider, *truly;
  QnQuantityEntry *scale;
  guint tick;
  gint64 last_time;
  double position; /* seconds into the motion */
  int played;      /* the step of an analysis in time that was played last */
} Bar;

/* Rows of the choice of speed. */
static const double speeds[] = { 0.1, 0.25, 0.5, 1.0, 2.0, 4.0 };

static const QnRun *
run_of (const Bar *bar)
{
  return bar->state->document->run;
}

static int
last_step (const Bar *bar)
{
  const QnRun *run = run_of (bar);
  return run != NULL && run->result.step_count > 0 ? (int) run->result.step_count - 1 : 0;
}

static gboolean
moves_by_phase (const Bar *bar)
{
  return bar->state->options.view == QN_VIEW_MECHANISM;
}

/* Shows the state `share` of the way from rest to the end. */
static void
show_share (Bar *bar, double share)
{
  if (moves_by_phase (bar)) {
    bar->state->options.phase = share;
    qn_view_state_changed (bar->state);
  } else
    qn_view_state_set_step (
      bar->state, (int) qn_to_integer (round (share * last_step (bar)), 0, G_MAXINT));
}

static void
stop (Bar *bar)
{
  if (bar->tick != 0)
    gtk_widget_remove_tick_callback (bar->box, bar->tick);
  bar->tick = 0;
  gtk_button_set_icon_name (GTK_BUTTON (bar->play), "media-playback-start-symbolic");
  gtk_widget_set_tooltip_text (bar->play, _ ("Play (Space)"));
}

/* The run, where it is played second for second. */
static const QnRun *
run_in_time (const Bar *bar)
{
  const QnRun *run = run_of (bar);
  return run != NULL && qn_run_is_in_time (run) && !moves_by_phase (bar) ? run : NULL;
}

static int
shown_step (const Bar *bar)
{
  return (int) qn_view_state_get_shown_step (bar->state);
}

static gboolean
on_tick (GtkWidget *widget, GdkFrameClock *clock, gpointer data)
{
  Bar *bar = data;
  const QnRun *run = run_in_time (bar);
  gint64 now = gdk_frame_clock_get_frame_time (clock);
  double speed = speeds[gtk_drop_down_get_selected (qn_part (bar->box, "speed"))];
  if (bar->last_time != 0)
    bar->position += 1e-6 * (double) (now - bar->last_time) * speed;
  bar->last_time = now;
  double period = g_settings_get_double (qn_settings_get (), "animation-period");
  gboolean loop = gtk_toggle_button_get_active (qn_part (bar->box, "loop"));
  const double turns = bar->position / period;
  gboolean goes_on = loop || turns < 1.0;
  if (run != NULL) {
    /* The time of the position; from the start again behind the end. Who goes to another step meanwhile
     * goes on from it. */
    double end = run->result.steps[last_step (bar)].time;
    if (shown_step (bar) != bar->played)
      bar->position = run->result.steps[shown_step (bar)].time;
    else if (bar->position > end && loop)
      bar->position = 0.0;
    goes_on = bar->position <= end;
    bar->played = qn_result_step_at (&run->result, bar->position);
    qn_view_state_set_step (bar->state, bar->played);
  } else /* to and fro, slowly at both ends */
    show_share (bar, goes_on ? 0.5 - 0.5 * cos (G_PI * turns) : 1.0);
  if (!goes_on)
    stop (bar);
  return goes_on ? G_SOURCE_CONTINUE : G_SOURCE_REMOVE;
}

static void
play (Bar *bar)
{
  QnView view = bar->state->options.view;
  const QnRun *run = run_of (bar);
  if (run == NULL)
    return;
  if (!qn_view_needs_result (view)
      || (view == QN_VIEW_FORCES && !qn_run_is_in_time (run)))
    qn_view_state_set_view (bar->state, qn_view_of_result (&run->result));
  bar->position = 0.0;
  bar->last_time = 0;
  if (run_in_time (bar) != NULL) {
    bar->played = shown_step (bar) < last_step (bar) ? shown_step (bar) : 0;
    bar->position = run->result.steps[bar->played].time;
    qn_view_state_set_step (bar->state, bar->played);
  }
  if (qn_settings_reduced_motion ()) {
    show_share (bar, 1.0);
    return;
  }
  bar->tick = gtk_widget_add_tick_callback (bar->box, on_tick, bar, NULL);
  gtk_button_set_icon_name (GTK_BUTTON (bar->play), "media-playback-pause-symbolic");
  gtk_widget_set_tooltip_text (bar->play, _ ("Pause (Space)"));
}

static void
toggle (Bar *bar)
{
  if (bar->tick != 0)
    stop (bar);
  else
    play (bar);
}

static void
on_slider (GtkRange *range, Bar *bar)
{
  show_share (bar, gtk_range_get_value (range) / MAX (1, last_step (bar)));
}

static void
on_scale (QnQuantityEntry *entry, Bar *bar)
{
  qn_view_state_set_scale (bar->state, qn_quantity_entry_get_value (entry));
}

static void
on_true_scale (GtkToggleButton *button, Bar *bar)
{
  qn_view_state_set_scale (bar->state,
                           gtk_toggle_button_get_active (button) ? 1.0 : QN_SCALE_AUTO);
}

static void
update_label (Bar *bar, const QnRun *run)
{
  g_autofree char *text = NULL;
  if (run == NULL || run->result.step_count == 0)
    text = g_strdup ("");
  else if (moves_by_phase (bar))
    text = g_strdup_printf (_ ("Motion %.0f %%"), 100.0 * bar->state->options.phase);
  else {
    int shown = shown_step (bar);
    const QnStep *at = &run->result.steps[shown];
    if (run->result.history.width > 0)
      text = g_strdup_printf (_ ("%.3f s of %.3f s"), at->time,
                              run->result.steps[last_step (bar)].time);
    else if (at->stage > 0 && (gsize) at->stage <= run->model.stage_count) {
      g_autofree char *stage = qn_stage_dup_name (&run->model, at->stage);
      text = g_strdup_printf (_ ("Step %d of %d, “%s” %.4f"), shown, last_step (bar),
                              stage, at->multiplier);
    } else
      text = g_strdup_printf (_ ("Step %d of %d, multiplier %.4f"), shown,
                              last_step (bar), at->multiplier);
  }
  gtk_label_set_text (qn_part (bar->box, "step"), text);
}

/* The end of each stage but the last. */
static void
mark_stages (Bar *bar)
{
  const QnRun *run = run_of (bar);
  gtk_scale_clear_marks (GTK_SCALE (bar->slider));
  size_t first = 0, last = 0;
  for (gsize i = 1; run != NULL && i < run->model.stage_count; i++)
    if (qn_result_stage_steps (&run->result, (int32_t) i, &first, &last))
      gtk_scale_add_mark (GTK_SCALE (bar->slider), (double) last, GTK_POS_TOP, NULL);
}

static void
update (Bar *bar)
{
  const QnRun *run = run_of (bar);
  gtk_widget_set_visible (bar->box, run != NULL);
  if (run == NULL) {
    stop (bar);
    return;
  }
  int last = last_step (bar);
  double value =
    moves_by_phase (bar) ? bar->state->options.phase * MAX (1, last) : shown_step (bar);
  g_signal_handlers_block_by_func (bar->slider, on_slider, bar);
  gtk_range_set_range (GTK_RANGE (bar->slider), 0.0, MAX (1, last));
  gtk_range_set_value (GTK_RANGE (bar->slider), value);
  g_signal_handlers_unblock_by_func (bar->slider, on_slider, bar);
  /* The factor drawn with, chosen or not. A mechanism has no size of its own. */
  double shown = qn_view_state_get_shown_scale (bar->state);
  gboolean deforms = bar->state->options.view == QN_VIEW_DEFORMED;
  qn_quantity_entry_set_value (bar->scale, shown);
  gtk_widget_set_visible (qn_part (bar->box, "factor"), deforms);
  g_signal_handlers_block_by_func (bar->truly, on_true_scale, bar);
  gtk_toggle_button_set_active (GTK_TOGGLE_BUTTON (bar->truly), shown == 1.0);
  g_signal_handlers_unblock_by_func (bar->truly, on_true_scale, bar);
  update_label (bar, run);
}

GtkWidget *
qn_playback_bar_new (QnViewState *state)
{
  g_autoptr (GtkBuilder) builder = qn_builder_new ("playback-bar");
  Bar *bar = g_new (Bar, 1);
  *bar = (Bar){
    .state = state,
    .box = qn_builder_take_widget (builder, "bar"),
    .play = qn_builder_get_widget (builder, "play"),
    .slider = qn_builder_get_widget (builder, "slider"),
    .truly = qn_builder_get_widget (builder, "truly"),
    .scale = QN_QUANTITY_ENTRY (qn_builder_get_widget (builder, "scale")),
  };
  g_signal_connect_swapped (bar->play, "clicked", G_CALLBACK (toggle), bar);
  g_signal_connect (bar->slider, "value-changed", G_CALLBACK (on_slider), bar);
  g_signal_connect (bar->scale, "committed", G_CALLBACK (on_scale), bar);
  g_signal_connect (bar->truly, "toggled", G_CALLBACK (on_true_scale), bar);
  qn_layout_wrap_pair (bar->box);
  /* Time runs to the right, as on every player. */
  static const char *const directed[] = { "motion", "measures", "slider" };
  for (gsize i = 0; i < G_N_ELEMENTS (directed); i++)
    gtk_widget_set_direction (qn_builder_get_widget (builder, directed[i]),
                              GTK_TEXT_DIR_LTR);
  g_object_set_data (G_OBJECT (bar->box), "qn-bar", bar);
  qn_own (bar->box, bar);
  qn_watch (bar->box, state, "changed", G_CALLBACK (update), bar);
  qn_watch (bar->box, state->document, "runs-changed", G_CALLBACK (mark_stages), bar);
  update (bar);
  return bar->box;
}

void
qn_playback_bar_toggle (GtkWidget *box)
{
  toggle (g_object_get_data (G_OBJECT (box), "qn-bar"));
}
