/* The figure of the study: which one, how it is drawn, and the case under the pointer. */
#include "app/pages/study-private.h"

#include "app/widgets/context-menu.h"
#include "app/widgets/plot-view.h"
#include "study/report/column.h"
#include <glib/gi18n.h>
#include <math.h>

/* px: a click this near to a point means it. */
#define NEAR 12.0

static int
column_of (QnStudyPage *self, GtkDropDown *choice)
{
  GtkStringObject *item = gtk_drop_down_get_selected_item (choice);
  for (gsize i = 0; item != NULL && i < self->table.width; i++)
    if (strcmp (qn_table_column_text (&self->table, i),
                gtk_string_object_get_string (item))
        == 0)
      return (int) i;
  return -1;
}

gboolean
qn_study_page_chosen_figure (QnStudyPage *self, QnStudyFigure *figure)
{
  guint row = gtk_drop_down_get_selected (self->figure);
  if (self->folder == NULL || row >= QN_STUDY_FIGURE_MECHANISMS)
    return FALSE;
  *figure = (QnStudyFigure){ .kind = (QnStudyFigureKind) row,
                             .column = column_of (self, self->of),
                             .parameters = { column_of (self, self->by),
                                             column_of (self, self->by_second) } };
  return figure->column >= 0 && figure->parameters[0] >= 0 && figure->parameters[1] >= 0;
}

static QnPlot *
make_plot (gpointer data, gboolean zoomed, char **message)
{
  QnStudyPage *self = data;
  QnStudyFigure figure;
  self->points = FALSE;
  if (!qn_study_page_chosen_figure (self, &figure)) {
    *message =
      g_strdup (_ ("Choose what varies, then run the study: its cases appear here."));
    return NULL;
  }
  QnPlot *plot = qn_study_figure_plot (&figure, &self->table, NULL);
  if (plot == NULL) {
    *message = g_strdup (_ ("No case has this output yet."));
    return NULL;
  }
  self->points =
    figure.kind == QN_STUDY_FIGURE_SCATTER || figure.kind == QN_STUDY_FIGURE_ENVELOPE;
  if (!self->points || self->chosen < 0
      || (guint64) self->chosen >= self->table.rows->len)
    return plot;
  double *place = qn_plot_keep (plot, g_new (double, 2));
  place[0] =
    qn_table_number (&self->table, (gsize) self->chosen, (gsize) figure.parameters[0]);
  place[1] = qn_table_number (&self->table, (gsize) self->chosen, (gsize) figure.column);
  qn_plot_points (plot, NULL, 1, place, place + 1, 1, QN_MARKER_RING, 10.0);
  return plot;
}

static void
choose (QnStudyPage *self, gint64 row)
{
  QnStudyFigure figure;
  if (!qn_study_page_chosen_figure (self, &figure) || row < 0
      || row >= (gint64) self->table.rows->len)
    return;
  const QnRow *found = &g_array_index (self->table.rows, QnRow, (guint) row);
  self->chosen = row;
  g_autoptr (GString) text = g_string_new (NULL);
  g_string_append_printf (text, _ ("Case %zu"), found->index + 1);
  for (gsize k = 0; k < self->table.parameters; k++)
    g_string_append_printf (text, " · %s %.4g", qn_table_column_name (&self->table, k),
                            qn_table_number (&self->table, (gsize) row, k));
  if (found->failed)
    g_string_append_printf (text, " · %s", found->reason);
  else
    g_string_append_printf (
      text, " · %s %.4g%s%s", qn_table_column_text (&self->table, (gsize) figure.column),
      qn_table_number (&self->table, (gsize) row, (gsize) figure.column),
      found->mechanism != NULL ? " · " : "",
      found->mechanism != NULL ? qn_study_word (found->mechanism) : "");
  qn_study_page_tell (self, text->str);
  gtk_widget_queue_draw (self->plot);
}

/* The case whose point is nearest to a place of the plot, or -1 where none is near. */
static gint64
find_point (QnStudyPage *self, double x, double y)
{
  QnStudyFigure figure;
  const QnPlotPlace *place = qn_plot_view_get_place (self->plot);
  double best = NEAR;
  gint64 nearest = -1;
  if (!self->points || !qn_study_page_chosen_figure (self, &figure))
    return -1;
  for (guint i = 0; i < self->table.rows->len; i++) {
    double px =
      place->x_zero
      + place->x_scale * qn_table_number (&self->table, i, (gsize) figure.parameters[0]);
    double py =
      place->y_zero
      + place->y_scale * qn_table_number (&self->table, i, (gsize) figure.column);
    double distance = hypot (px - x, py - y);
    if (distance < best) { /* false for NaN */
      best = distance;
      nearest = i;
    }
  }
  return nearest;
}

static void
on_click (GtkGestureClick *gesture, int count, double x, double y, QnStudyPage *self)
{
  gtk_widget_grab_focus (self->plot);
  gint64 nearest = find_point (self, x, y);
  if (nearest < 0)
    return;
  choose (self, nearest);
  qn_study_page_open_case (self);
}

/* The case under the pointer, or the one that the keys have chosen; and what can be written. */
static GMenuModel *
make_menu (GtkWidget *plot, QnMenuPlace *place, gpointer data)
{
  QnStudyPage *self = data;
  GMenu *menu = g_menu_new (), *one = g_menu_new (), *all = g_menu_new ();
  gtk_widget_grab_focus (plot);
  gint64 nearest = place->by_key ? self->chosen : find_point (self, place->x, place->y);
  if (!place->by_key && nearest >= 0)
    choose (self, nearest);
  if (nearest >= 0) {
    g_menu_append (one, _ ("_Open Case in the Drawing"), "study.open-case");
    g_menu_append (one, _ ("_Copy Text"), "study.copy-case");
  }
  g_menu_append (all, _ ("_Table…"), "study.export::table");
  g_menu_append (all, _ ("_Figure…"), "study.export::figure");
  g_menu_append (all, _ ("_Mechanisms…"), "study.export::mechanisms");
  qn_menu_add_section (menu, one);
  qn_menu_add_section (menu, all);
  return G_MENU_MODEL (menu);
}

static gboolean
on_key (GtkEventControllerKey *controller, guint keyval, guint keycode,
        GdkModifierType modifiers, QnStudyPage *self)
{
  switch (keyval) {
  case GDK_KEY_Right:
    choose (self, self->chosen + 1);
    return TRUE;
  case GDK_KEY_Left:
    choose (self, self->chosen - 1);
    return TRUE;
  case GDK_KEY_Return:
  case GDK_KEY_KP_Enter:
    gtk_widget_activate_action (self->page, "study.open-case", NULL);
    return TRUE;
  default:
    return FALSE;
  }
}

static void
on_figure (QnStudyPage *self)
{
  guint row = gtk_drop_down_get_selected (self->figure);
  gboolean surface = row == QN_STUDY_FIGURE_SURFACE;
  gboolean by =
    surface || row == QN_STUDY_FIGURE_SCATTER || row == QN_STUDY_FIGURE_ENVELOPE;
  gtk_widget_set_visible (GTK_WIDGET (self->by), by);
  gtk_widget_set_visible (self->over, by);
  gtk_widget_set_visible (GTK_WIDGET (self->by_second), surface);
  gtk_widget_set_visible (self->and, surface);
  qn_study_page_show_statistics (self);
  qn_plot_view_fit (self->plot);
}

void
qn_study_page_connect_plot (QnStudyPage *self)
{
  static const QnPlotHand hand = { .make = make_plot };
  GtkDropDown *const shown[] = { self->figure, self->of, self->by, self->by_second };
  for (gsize i = 0; i < G_N_ELEMENTS (shown); i++)
    g_signal_connect_swapped (shown[i], "notify::selected", G_CALLBACK (on_figure), self);
  qn_plot_view_init (self->plot, &hand, self);
  GtkGesture *click = gtk_gesture_click_new ();
  g_signal_connect (click, "released", G_CALLBACK (on_click), self);
  gtk_widget_add_controller (self->plot, GTK_EVENT_CONTROLLER (click));
  GtkEventController *key = gtk_event_controller_key_new ();
  g_signal_connect (key, "key-pressed", G_CALLBACK (on_key), self);
  gtk_widget_add_controller (self->plot, key);
  qn_context_menu_attach (self->plot, make_menu, self);
  on_figure (self);
}
