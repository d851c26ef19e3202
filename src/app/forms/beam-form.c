/* The selected beams: what they are, what they carry, and their section forces after a run. */
#include "app/forms/form.h"
#include "app/forms/panel.h"
#include "app/widgets/settings.h"
#include "doc/text/beam-summary.h"
#include <glib/gi18n.h>

#define CHANGE N_ ("Set Load along Beam")

#define FIELDS(FIELD, MEMBER)                                                            \
  FIELD (TITLE, "title", NULL)                                                           \
  FIELD (NAME, "name", N_ ("Rename Beam"))                                               \
  FIELD (SECTION, "section", N_ ("Set Section")) /* and what follows as QnBeamField */   \
  FIELD (KIND, "kind", N_ ("Change Kind of Beam"))                                       \
  FIELD (ELEMENTS, "elements", N_ ("Cut Beam into Elements"))                            \
  FIELD (HINGE, "first_hinge", N_ ("Set Hinge"))                                         \
  FIELD (SECOND_HINGE, "second_hinge", N_ ("Set Hinge"))                                 \
  FIELD (FACTS, "facts", NULL)                                                           \
  FIELD (FORCES, "forces", NULL)                                                         \
  FIELD (LOAD, "constant_x", CHANGE) /* constant and growing, horizontal and vertical */ \
  FIELD (CONSTANT_Y, "constant_y", CHANGE)                                               \
  FIELD (GROWING_X, "growing_x", CHANGE)                                                 \
  FIELD (GROWING_Y, "growing_y", CHANGE)
QN_FORM_FIELDS;

static gboolean
look (QnForm *form, const QnModel *model)
{
  return form->parts.beams.count > 0;
}

static char *
dup_facts (const QnModel *model, QnBeamSet set)
{
  QnUnits units = qn_settings_get_units ();
  double length = 0.0, weight = 0.0;
  for (guint i = 0; i < set.count; i++) {
    double own = qn_model_beam_length (model, set.ids[i]);
    length += own;
    weight +=
      own * qn_section_weight (&model->sections[model->beams[set.ids[i]].section]);
  }
  g_autofree char *l = qn_units_format_full (units, QN_QUANTITY_LENGTH, length, 5);
  g_autofree char *w = qn_units_format_full (units, QN_QUANTITY_FORCE, weight, 4);
  return g_strdup_printf (_ ("Length %s, weight %s"), l, w);
}

/* Of a single beam at the step that is shown; NULL without a run of this model. */
static char *
dup_forces (const QnForm *form, QnBeamSet set)
{
  const QnRun *run = form->canvas->document->run;
  if (set.count != 1 || run == NULL || run->result.step_count == 0
      || qn_document_get_run_age (form->canvas->document, run) == QN_RUN_OTHER_MODEL
      || (gsize) set.ids[0] >= run->model.beam_count)
    return NULL;
  return qn_beam_dup_summary (&run->model, &run->result,
                              qn_view_state_get_shown_step (form->canvas->state),
                              set.ids[0], qn_settings_get_units ());
}

static gboolean
show (QnForm *form, const QnModel *model, guint field, QnValue *value)
{
  QnBeamSet set = form->parts.beams;
  const QnBeam *beam = &model->beams[set.ids[0]];
  QnVec2 load;
  switch (field) {
  case TITLE:
    value->text =
      set.count == 1
        ? g_strdup_printf (_ ("Beam %s"), beam->name)
        : g_strdup_printf (ngettext ("%u Beam", "%u Beams", set.count), set.count);
    return TRUE;
  case NAME:
    value->text = g_strdup (beam->name);
    return set.count == 1;
  case SECTION:
    qn_value_set_sections (value, model, beam->section);
    return TRUE;
  case KIND:
    value->number = beam->kind;
    return TRUE;
  case ELEMENTS:
    value->number = beam->element_count;
    return TRUE;
  case HINGE:
  case HINGE + 1:
    value->number = beam->hinge[field - HINGE];
    for (guint i = 0; i < set.count; i++)
      value->mixed |=
        model->beams[set.ids[i]].hinge[field - HINGE] != (value->number != 0.0);
    return TRUE;
  case FACTS:
    value->text = dup_facts (model, set);
    return TRUE;
  case FORCES:
    value->text = dup_forces (form, set);
    return value->text != NULL;
  default:
    load = qn_model_line_load (model, set.ids[0], (field - LOAD) / 2);
    value->number = (field - LOAD) % 2 == 0 ? load.x : load.y;
    return TRUE;
  }
}

static gboolean
take (QnForm *data, QnModel *model, guint field, const QnValue *value, GError **error)
{
  QnBeamSet set = data->parts.beams;
  gboolean live = field >= LOAD + 2;
  guint x = live ? LOAD + 2 : LOAD;
  switch (field) {
  case NAME:
    return qn_edit_take_name (&model->beams[set.ids[0]].name, value->text, error);
  case SECTION:
  case KIND:
  case ELEMENTS:
  case HINGE:
  case HINGE + 1:
    return qn_edit_set_beams (model, set, (QnBeamField) (field - SECTION), value->number,
                              error);
  default:
    return qn_edit_set_line_load (
      model, set, live,
      qn_vec2 (qn_form_get_number (data, x), qn_form_get_number (data, x + 1)), error);
  }
}

const QnFormKind qn_beam_form =
  QN_FORM_KIND ("beam-form", QnForm, .look = look,
                .follows = QN_FOLLOW_SELECTION | QN_FOLLOW_RUNS | QN_FOLLOW_VIEW);
