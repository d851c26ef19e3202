#include "doc/view/view-state.h"

#include "doc/document/underlay.h"
#include "render/scene/motion.h"

#include <string.h>

G_DEFINE_FINAL_TYPE (QnViewState, qn_view_state, G_TYPE_OBJECT)

static void
qn_view_state_finalize (GObject *object)
{
  QnViewState *self = QN_VIEW_STATE (object);
  g_clear_object (&self->document);
  g_clear_pointer (&self->options.underlay.image, cairo_surface_destroy);
  g_clear_pointer (&self->onion, qn_run_unref);
  g_clear_error (&self->image_error);
  g_free (self->image_path);
  G_OBJECT_CLASS (qn_view_state_parent_class)->finalize (object);
}

static void
qn_view_state_class_init (QnViewStateClass *klass)
{
  G_OBJECT_CLASS (klass)->finalize = qn_view_state_finalize;
  g_signal_new ("changed", QN_TYPE_VIEW_STATE, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL,
                G_TYPE_NONE, 0);
}

static void
qn_view_state_init (QnViewState *self)
{
  qn_view_options_init (&self->options, QN_VIEW_MODEL);
  /* The window has a title and a scale of its own. */
  self->options.titles = false;
}

void
qn_view_state_changed (QnViewState *self)
{
  g_signal_emit_by_name (self, "changed");
}

/* The image is read again only where its file is another, or it is rectified in another way. */
static void
update_underlay (QnViewState *self)
{
  const char *folder = self->document->folder;
  g_autofree char *path = NULL;
  QnUnderlay underlay;
  g_clear_error (&self->image_error);
  qn_underlay_locate (qn_document_get_project (self->document), folder, &path, &underlay,
                      &self->image_error);
  const QnUnderlay *shown = &self->options.underlay;
  cairo_surface_t *image = shown->image;
  gboolean same =
    underlay.rectified == shown->rectified && underlay.cropped == shown->cropped
    && (!underlay.rectified
        || memcmp (underlay.points, shown->points, sizeof shown->points) == 0);
  underlay.seen = shown->seen;
  if (g_strcmp0 (path, self->image_path) != 0 || image == NULL || !same) {
    g_clear_pointer (&image, cairo_surface_destroy);
    self->options.underlay.image = NULL;
    g_free (self->image_path);
    self->image_path = g_steal_pointer (&path);
    if (self->image_path != NULL)
      qn_document_read_picture (self->document, &underlay, &self->image_error);
  } else
    underlay.image = image;
  self->options.underlay = underlay;
}

/* An outline of other blocks would be nonsense. */
static gboolean
same_structure (const QnRun *a, const QnRun *b)
{
  if (a->model.block_count != b->model.block_count)
    return FALSE;
  for (gsize i = 0; i < a->model.block_count; i++) {
    if (a->model.blocks[i].vertex_count != b->model.blocks[i].vertex_count)
      return FALSE;
  }
  return TRUE;
}

void
qn_view_state_refresh_underlay (QnViewState *self)
{
  update_underlay (self);
  qn_view_state_changed (self);
}

/* Another run has other steps; without one only the model can be shown. */
static void
on_runs_changed (QnDocument *document, QnViewState *self)
{
  self->options.step = QN_STEP_LAST;
  self->options.phase = 1.0;
  self->fitting_scale = 0.0;
  const QnRun *run = document->run;
  if (self->onion != NULL && (run == NULL || !same_structure (self->onion, run)))
    g_clear_pointer (&self->onion, qn_run_unref);
  if (run == NULL && qn_view_needs_result (self->options.view))
    self->options.view = QN_VIEW_MODEL;
  qn_view_state_changed (self);
}

QnViewState *
qn_view_state_new (QnDocument *document)
{
  QnViewState *self = g_object_new (QN_TYPE_VIEW_STATE, NULL);
  self->document = g_object_ref (document);
  g_signal_connect_object (document, "runs-changed", G_CALLBACK (on_runs_changed), self,
                           0);
  g_signal_connect_object (document, "changed",
                           G_CALLBACK (qn_view_state_refresh_underlay), self,
                           G_CONNECT_SWAPPED);
  g_signal_connect_object (document, "file-changed",
                           G_CALLBACK (qn_view_state_refresh_underlay), self,
                           G_CONNECT_SWAPPED);
  update_underlay (self);
  return self;
}

/* Colours of what the result does not know are none. */
static QnField
shown_field (QnViewState *self, const QnRun *run)
{
  QnField field = self->options.field;
  QnView view = self->options.view;
  if (run == NULL || !qn_view_needs_result (view) || view == QN_VIEW_DIAGRAMS)
    return QN_FIELD_NONE;
  gboolean moves = view == QN_VIEW_MECHANISM
                     ? run->result.mechanism != NULL
                     : run->result.step_count > 0 && !run->result.limit.given;
  gboolean known =
    qn_field_needs_forces (field)
      ? qn_result_has_forces (&run->result, qn_view_state_get_shown_step (self))
      : moves;
  known &= field != QN_FIELD_BODIES || run->result.mechanism != NULL;
  return known ? field : QN_FIELD_NONE;
}

QnViewOptions
qn_view_state_get_options (QnViewState *self)
{
  QnViewOptions options = self->options;
  const QnRun *run = self->document->run;
  options.step = qn_view_state_get_step (self);
  if (options.view == QN_VIEW_MECHANISM)
    options.scale = self->mechanism_scale;
  if (qn_view_needs_result (options.view))
    options.loads = self->result_loads;
  options.field = shown_field (self, run);
  /* Joints of a mode bend; they neither slide nor open. */
  if (run != NULL && run->kind != QN_RUN_ANALYSIS && options.view == QN_VIEW_MECHANISM)
    options.symbols = false;
  options.onion = self->onion != NULL && self->onion != run ? &self->onion->result : NULL;
  return options;
}

void
qn_view_state_set_view (QnViewState *self, QnView view)
{
  if (self->options.view == view)
    return;
  self->options.view = view;
  self->options.phase = 1.0;
  qn_view_state_changed (self);
}

int
qn_view_state_get_step (QnViewState *self)
{
  const QnRun *run = self->document->run;
  if (run == NULL || self->options.step == QN_STEP_LAST || run->result.step_count == 0)
    return QN_STEP_LAST;
  return MIN (self->options.step, (int) run->result.step_count - 1);
}

gsize
qn_view_state_get_shown_step (QnViewState *self)
{
  const QnRun *run = self->document->run;
  const int step = qn_view_state_get_step (self);
  return step != QN_STEP_LAST                        ? (gsize) step
         : run != NULL && run->result.step_count > 0 ? run->result.step_count - 1
                                                     : 0;
}

void
qn_view_state_set_step (QnViewState *self, int step)
{
  const QnRun *run = self->document->run;
  int count = run != NULL ? (int) run->result.step_count : 0;
  int clamped = step < 0 || step >= count ? QN_STEP_LAST : step;
  if (self->options.step == clamped)
    return;
  self->options.step = clamped;
  qn_view_state_changed (self);
}

void
qn_view_state_show_step (QnViewState *self, int step)
{
  if (!qn_view_needs_result (self->options.view)
      || self->options.view == QN_VIEW_MECHANISM)
    qn_view_state_set_view (self, QN_VIEW_DEFORMED);
  qn_view_state_set_step (self, step);
}

void
qn_view_state_set_scale (QnViewState *self, double scale)
{
  double *own = self->options.view == QN_VIEW_MECHANISM ? &self->mechanism_scale
                                                        : &self->options.scale;
  if (*own == scale)
    return;
  *own = scale;
  qn_view_state_changed (self);
}

double
qn_view_state_get_shown_scale (QnViewState *self)
{
  const QnRun *run = self->document->run;
  if (self->options.scale > 0.0)
    return self->options.scale;
  if (self->fitting_scale == 0.0)
    self->fitting_scale =
      run != NULL ? qn_motion_result_scale (&run->model, &run->result) : 1.0;
  return self->fitting_scale;
}

static bool *
find_switch (QnViewState *self, const char *name)
{
  return strcmp (name, "loads") == 0 && qn_view_needs_result (self->options.view)
           ? &self->result_loads
           : qn_view_switch (&self->options, name);
}

gboolean
qn_view_state_get_switch (QnViewState *self, const char *name)
{
  const bool *value = find_switch (self, name);
  g_return_val_if_fail (value != NULL, FALSE);
  return *value;
}

void
qn_view_state_set_switch (QnViewState *self, const char *name, gboolean on)
{
  bool *value = find_switch (self, name);
  g_return_if_fail (value != NULL);
  if (*value == (on != FALSE))
    return;
  *value = on != FALSE;
  qn_view_state_changed (self);
}

void
qn_view_state_set_onion (QnViewState *self, QnRun *run)
{
  const QnRun *current = self->document->run;
  if (run == self->onion
      || (run != NULL && (current == NULL || !same_structure (run, current))))
    return;
  g_clear_pointer (&self->onion, qn_run_unref);
  self->onion = run != NULL ? qn_run_ref (run) : NULL;
  qn_view_state_changed (self);
}

gboolean
qn_view_state_get_content (QnViewState *self, QnView view, const QnModel **model,
                           const QnContacts **contacts, const QnResult **result)
{
  const QnRun *run = self->document->run;
  if (!qn_view_needs_result (view)) {
    *model = &self->document->project.model;
    *contacts = &self->document->contacts;
    *result = NULL;
    return TRUE;
  }
  if (run == NULL)
    return FALSE;
  *model = &run->model;
  *contacts = &run->contacts;
  *result = &run->result;
  return TRUE;
}
