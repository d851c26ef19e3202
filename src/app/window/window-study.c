/* The study of the project: numbers that vary, loads that move. */
#include "app/window/window-private.h"

#include "app/dialogs/study-window.h"
#include "doc/edit/edit-stage.h"
#include "study/plan/study.h"
#include <glib/gi18n.h>

/* The list of growing loads (edit-stage.h). */
#define LIVE_LOADS 0

/* The study window, or NULL where the window says why not. */
static GtkWindow *
show_study (QnWindow *self, const char *path)
{
  const QnStudyParent parent = { GTK_WINDOW (self), self->document, self->state };
  g_autoptr (GError) error = NULL;
  GtkWindow *study = qn_study_window_show (&parent, path, &error);
  if (study == NULL)
    qn_window_show_error (self, error->message);
  return study;
}

static void
study (QnWindow *self, GVariant *parameter)
{
  show_study (self, NULL);
}

/* (path in the project, its number) */
static void
vary (QnWindow *self, GVariant *parameter)
{
  const char *path;
  double number;
  g_variant_get (parameter, "(&sd)", &path, &number);
  GtkWindow *window = show_study (self, NULL);
  if (window != NULL)
    qn_study_window_vary (window, path, number);
}

/* The place of the first growing force on a block; -1 where there is none. */
static int
find_force (const QnModel *model)
{
  for (gsize i = 0; i < qn_model_count_loads (model, LIVE_LOADS); i++)
    if (qn_model_get_load (model, LIVE_LOADS, i)->kind == QN_LOAD_FORCE)
      return (int) i;
  return -1;
}

/* The corners of the line: x, y after each other. */
static void
move_load (QnWindow *self, GVariant *parameter)
{
  gsize count;
  const double *numbers = g_variant_get_fixed_array (parameter, &count, sizeof *numbers);
  int force = find_force (qn_document_get_model (self->document));
  if (force < 0) {
    qn_window_show_error (self,
                          _ ("No force grows with the multiplier: draw one with the "
                             "force tool first."));
    return;
  }
  g_autofree char *path = g_strdup_printf ("loads.live[%d]", force);
  g_autoptr (GArray) line = g_array_new (FALSE, FALSE, sizeof (QnVec2));
  g_array_append_vals (line, numbers, (guint) count / 2);
  GtkWindow *window = show_study (self, NULL);
  if (window != NULL)
    qn_study_window_move_load (window, path, line);
}

gboolean
qn_window_open_study (QnWindow *self, const char *path)
{
  QnStudy opened;
  g_autoptr (GError) error = NULL;
  if (!qn_study_read (path, NULL, &opened, &error)) {
    qn_window_show_error (self, error->message);
    return FALSE;
  }
  g_autofree char *project = g_strdup (opened.project.path);
  qn_study_clear (&opened);
  if (project == NULL || !qn_window_open_path (self, project))
    return FALSE;
  qn_window_remember_recent (path);
  return show_study (self, path) != NULL;
}

void
qn_window_add_study_actions (QnWindow *self)
{
  static const QnWindowAction actions[] = {
    { "study", NULL, study },
    { "vary", "(sd)", vary },
    { "move-load", "ad", move_load },
  };
  qn_window_add_action_table (self, actions, G_N_ELEMENTS (actions));
}
