#include "doc/view-state.h"

#include <string.h>

struct _QnViewState {
  GObject parent_instance;
  QnDocument *document;
  QnViewOptions options;
};

G_DEFINE_FINAL_TYPE (QnViewState, qn_view_state, G_TYPE_OBJECT)

enum { SIGNAL_CHANGED, SIGNAL_COUNT };
static guint signals[SIGNAL_COUNT];

static void
qn_view_state_finalize (GObject *object)
{
  g_clear_object (&QN_VIEW_STATE (object)->document);
  G_OBJECT_CLASS (qn_view_state_parent_class)->finalize (object);
}

static void
qn_view_state_class_init (QnViewStateClass *klass)
{
  G_OBJECT_CLASS (klass)->finalize = qn_view_state_finalize;
  signals[SIGNAL_CHANGED] =
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

static void
emit_changed (QnViewState *self)
{
  g_signal_emit (self, signals[SIGNAL_CHANGED], 0);
}

/* Another run has other steps; without one only the model can be shown. */
static void
on_runs_changed (QnDocument *document, QnViewState *self)
{
  self->options.step = QN_STEP_LAST;
  self->options.phase = 1.0;
  if (qn_document_get_run (document) == NULL && qn_view_needs_result (self->options.view))
    self->options.view = QN_VIEW_MODEL;
  emit_changed (self);
}

QnViewState *
qn_view_state_new (QnDocument *document)
{
  QnViewState *self = g_object_new (QN_TYPE_VIEW_STATE, NULL);
  self->document = g_object_ref (document);
  g_signal_connect_object (document, "runs-changed", G_CALLBACK (on_runs_changed), self,
                           0);
  g_signal_connect_object (document, "changed", G_CALLBACK (emit_changed), self,
                           G_CONNECT_SWAPPED);
  return self;
}

QnDocument *
qn_view_state_get_document (QnViewState *self)
{
  return self->document;
}

QnViewOptions
qn_view_state_get_options (QnViewState *self)
{
  QnViewOptions options = self->options;
  options.step = qn_view_state_get_step (self);
  return options;
}

QnView
qn_view_state_get_view (QnViewState *self)
{
  return self->options.view;
}

void
qn_view_state_set_view (QnViewState *self, QnView view)
{
  if (self->options.view == view)
    return;
  self->options.view = view;
  self->options.phase = 1.0;
  emit_changed (self);
}

int
qn_view_state_get_step (QnViewState *self)
{
  const QnRun *run = qn_document_get_run (self->document);
  if (run == NULL || self->options.step == QN_STEP_LAST || run->result.step_count == 0)
    return QN_STEP_LAST;
  return MIN (self->options.step, (int) run->result.step_count - 1);
}

void
qn_view_state_set_step (QnViewState *self, int step)
{
  const QnRun *run = qn_document_get_run (self->document);
  int count = run != NULL ? (int) run->result.step_count : 0;
  int clamped = step < 0 || step >= count ? QN_STEP_LAST : step;
  if (self->options.step == clamped)
    return;
  self->options.step = clamped;
  emit_changed (self);
}

void
qn_view_state_set_scale (QnViewState *self, double scale)
{
  if (self->options.scale == scale)
    return;
  self->options.scale = scale;
  emit_changed (self);
}

double
qn_view_state_get_scale (QnViewState *self)
{
  return self->options.scale;
}

void
qn_view_state_set_phase (QnViewState *self, double phase)
{
  if (self->options.phase == phase)
    return;
  self->options.phase = phase;
  emit_changed (self);
}

double
qn_view_state_get_phase (QnViewState *self)
{
  return self->options.phase;
}

static bool *
find_switch (QnViewState *self, const char *name)
{
  QnViewOptions *o = &self->options;
  const struct {
    const char *name;
    bool *value;
  } switches[] = { { "ghost", &o->ghost }, { "symbols", &o->symbols },
                   { "loads", &o->loads }, { "dimensions", &o->dimensions },
                   { "names", &o->names }, { "monochrome", &o->monochrome } };
  for (gsize i = 0; i < G_N_ELEMENTS (switches); i++) {
    if (strcmp (switches[i].name, name) == 0)
      return switches[i].value;
  }
  return NULL;
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
  emit_changed (self);
}

void
qn_view_state_set_field (QnViewState *self, QnField field)
{
  if (self->options.field == field)
    return;
  self->options.field = field;
  emit_changed (self);
}

gboolean
qn_view_needs_result (QnView view)
{
  return view == QN_VIEW_DEFORMED || view == QN_VIEW_MECHANISM || view == QN_VIEW_FORCES;
}

gboolean
qn_view_state_get_content (QnViewState *self, const QnModel **model,
                           const QnContacts **contacts, const QnResult **result)
{
  const QnRun *run = qn_document_get_run (self->document);
  if (!qn_view_needs_result (self->options.view)) {
    *model = qn_document_get_model (self->document);
    *contacts = qn_document_get_contacts (self->document);
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
