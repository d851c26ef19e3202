/* The picture behind the drawing: opacity, size, place and angle; only there when it is. */
#include "app/forms/form.h"
#include "app/forms/panel.h"
#include "doc/document/underlay.h"
#include "io/text/io-error.h"
#include <glib/gi18n.h>

/* The picture is no part of the model: its steps are made here. */
#define FIELDS(FIELD, MEMBER)                                                            \
  FIELD (TROUBLE, "trouble", NULL)                                                       \
  FIELD (ALLOW, "allow", NULL)                                                           \
  FIELD (OPACITY, "opacity", NULL)                                                       \
  FIELD (WIDTH, "width", NULL)                                                           \
  FIELD (HEIGHT, "height", NULL)                                                         \
  FIELD (X, "x", NULL)                                                                   \
  FIELD (Y, "y", NULL)                                                                   \
  FIELD (ANGLE, "angle", NULL)                                                           \
  FIELD (CORNER, "corner_0", NULL) /* four of the rectangle on the photo */              \
  FIELD (CORNER_1, "corner_1", NULL)                                                     \
  FIELD (CORNER_2, "corner_2", NULL)                                                     \
  FIELD (CORNER_3, "corner_3", NULL)                                                     \
  FIELD (CROPPED, "cropped", NULL)                                                       \
  FIELD (AS_TAKEN, "as_taken", NULL)
QN_FORM_FIELDS;

static double *
number_of (QnUnderlay *underlay, guint field)
{
  double *const all[] = { [OPACITY] = &underlay->opacity, [WIDTH] = &underlay->width,
                          [HEIGHT] = &underlay->height,   [X] = &underlay->origin.x,
                          [Y] = &underlay->origin.y,      [ANGLE] = &underlay->angle };
  return all[field];
}

static gboolean
look (QnForm *form, const QnModel *model)
{
  const QnViewState *state = form->canvas->state;
  return state->options.underlay.image != NULL || state->image_error != NULL;
}

static gboolean
show (QnForm *form, const QnModel *model, guint field, QnValue *value)
{
  const QnViewState *state = form->canvas->state;
  const GError *error = state->image_error;
  QnUnderlay underlay = state->options.underlay;
  if (field == ALLOW)
    return g_error_matches (error, QN_IO_ERROR, QN_IO_ERROR_OUTSIDE);
  if (field == TROUBLE) {
    value->text = g_strdup (error != NULL ? error->message : "");
    return error != NULL;
  }
  if (field >= CORNER) {
    QnVec2 corner = underlay.points[(field - CORNER) % 4];
    value->number = underlay.cropped;
    if (field < CROPPED)
      value->text = g_strdup_printf ("%.4g; %.4g", corner.x, corner.y);
    return underlay.rectified;
  }
  value->number = *number_of (&underlay, field);
  return field != HEIGHT || underlay.rectified;
}

static gboolean
take (QnForm *form, QnModel *model, guint field, const QnValue *value, GError **error)
{
  QnCanvas *canvas = form->canvas;
  QnUnderlay underlay = canvas->state->options.underlay;
  gboolean fade = field == OPACITY;
  if (field == ALLOW) {
    qn_document_allow_picture (canvas->document);
    qn_view_state_refresh_underlay (canvas->state);
    return TRUE;
  }
  if (field == AS_TAKEN) {
    qn_underlay_show_as_taken (&underlay);
    return qn_document_place_picture (canvas->document, _ ("Show Picture as Taken"), NULL,
                                      &underlay, error);
  }
  if (field == CROPPED)
    underlay.cropped = value->number != 0.0;
  else if (field >= CORNER) {
    /* "0.1; 0.25": parts of the photo's width and height. */
    double numbers[2];
    g_auto (GStrv) parts = g_strsplit (value->text, ";", -1);
    gboolean read = g_strv_length (parts) == 2;
    for (int i = 0; read && i < 2; i++)
      read =
        qn_units_parse (QN_UNITS_SI, QN_QUANTITY_NUMBER, parts[i], &numbers[i], NULL);
    if (!read)
      return qn_edit_refuse (error,
                             _ ("Expected two numbers with a semicolon between them"));
    underlay.points[field - CORNER] = qn_vec2 (numbers[0], numbers[1]);
  } else
    *number_of (&underlay, field) = value->number;
  return qn_document_place_picture (
    canvas->document, fade ? _ ("Change Opacity of Picture") : _ ("Place Picture"),
    fade ? "picture-opacity" : NULL, &underlay, error);
}

const QnFormKind qn_picture_form =
  QN_FORM_KIND ("picture-panel", QnForm, .look = look, .follows = QN_FOLLOW_VIEW);
