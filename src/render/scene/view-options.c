#include "render/scene/view-options.h"
#include "core/base/word.h"

#include <glib.h>
#include <math.h>
#include <string.h>

const char *const qn_view_names[QN_VIEW_COUNT] = {
  [QN_VIEW_MODEL] = "model",       [QN_VIEW_CONTACTS] = "contacts",
  [QN_VIEW_DEFORMED] = "deformed", [QN_VIEW_MECHANISM] = "mechanism",
  [QN_VIEW_FORCES] = "forces",     [QN_VIEW_DIAGRAMS] = "diagrams",
};

const char *const qn_diagram_names[QN_DIAGRAM_COUNT] = {
  [QN_DIAGRAM_MOMENT] = "M",
  [QN_DIAGRAM_SHEAR] = "V",
  [QN_DIAGRAM_NORMAL] = "N",
};

const char *const qn_field_names[QN_FIELD_COUNT] = {
  [QN_FIELD_NONE] = "none",
  [QN_FIELD_DISPLACEMENT] = "displacement",
  [QN_FIELD_DISPLACEMENT_X] = "displacement-x",
  [QN_FIELD_DISPLACEMENT_Y] = "displacement-y",
  [QN_FIELD_ROTATION] = "rotation",
  [QN_FIELD_STRESS] = "stress",
  [QN_FIELD_STRESS_X] = "stress-x",
  [QN_FIELD_STRESS_Y] = "stress-y",
  [QN_FIELD_STRESS_XY] = "stress-xy",
  [QN_FIELD_PRINCIPAL] = "principal",
  [QN_FIELD_OPENING] = "opening",
  [QN_FIELD_SLIDING] = "sliding",
  [QN_FIELD_CRACK] = "crack",
  [QN_FIELD_BODIES] = "bodies",
};

void
qn_view_options_init (QnViewOptions *options, QnView view)
{
  *options = (QnViewOptions){
    .view = view,
    .step = QN_STEP_LAST,
    .scale = QN_SCALE_AUTO,
    .phase = 1,
    .ghost = true,
    .symbols = true,
    .counts = true,
    .loads = view == QN_VIEW_MODEL,
    .dimensions = view == QN_VIEW_MODEL,
    .legend = true,
    .titles = true,
    .underlay = { .width = 1, .opacity = 1 },
  };
}

const char *const qn_view_switches[] = {
  "ghost",  "symbols", "loads",  "dimensions", "names",
  "values", "legend",  "titles", "monochrome", NULL,
};

bool *
qn_view_switch (QnViewOptions *options, const char *name)
{
  bool *const flags[] = { &options->ghost,      &options->symbols, &options->loads,
                          &options->dimensions, &options->names,   &options->values,
                          &options->legend,     &options->titles,  &options->monochrome };
  int i;
  return qn_find_word (name, qn_view_switches, QN_N_ELEMENTS (flags), &i) ? flags[i]
                                                                          : NULL;
}

static bool
parse_step (const char *text, int32_t *step)
{
  guint64 number;
  *step = QN_STEP_LAST;
  if (strcmp (text, "last") == 0)
    return true;
  if (!g_ascii_string_to_unsigned (text, 10, 0, G_MAXINT32, &number, NULL))
    return false;
  *step = (int32_t) number;
  return true;
}

static bool
parse_scale (const char *text, double *scale)
{
  char *end;
  *scale = strcmp (text, "true") == 0 ? 1 : QN_SCALE_AUTO;
  if (*scale == 1 || strcmp (text, "auto") == 0)
    return true;
  *scale = g_ascii_strtod (text, &end);
  return end != text && *end == '\0' && isfinite (*scale) && *scale > 0;
}

bool
qn_view_options_set (QnViewOptions *options, const char *name, const char *value)
{
  bool on = strcmp (value, "on") == 0, *flag = qn_view_switch (options, name);
  if (flag != NULL) {
    *flag = on;
    return on || strcmp (value, "off") == 0;
  }
  if (strcmp (name, "field") == 0)
    return qn_find_word (value, qn_field_names, QN_FIELD_COUNT, &options->field);
  if (strcmp (name, "diagram") == 0)
    return qn_find_word (value, qn_diagram_names, QN_DIAGRAM_COUNT, &options->diagram);
  if (strcmp (name, "step") == 0)
    return parse_step (value, &options->step);
  return strcmp (name, "scale") == 0 && parse_scale (value, &options->scale);
}

bool
qn_underlay_corners (const QnUnderlay *u, QnVec2 corners[4])
{
  QnBox seen = { { 0, 0 }, { 1, 1 } };
  if (u->image == NULL)
    return false;
  double columns = cairo_image_surface_get_width (u->image);
  double rows = cairo_image_surface_get_height (u->image), height = u->height;
  if (columns < 1 || rows < 1)
    return false;
  if (u->rectified)
    seen = u->seen;
  else
    height = u->width * rows / columns;
  for (int i = 0; i < 4; i++) {
    QnVec2 part = { i == 1 || i == 2 ? seen.max.x : seen.min.x,
                    i >= 2 ? seen.max.y : seen.min.y };
    QnVec2 arm = { part.x * u->width, part.y * height };
    corners[i] =
      qn_vec2_add (u->origin, qn_vec2_rotate (arm, cos (u->angle), sin (u->angle)));
  }
  return true;
}
