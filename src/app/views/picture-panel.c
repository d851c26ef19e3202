/* The picture behind the drawing: opacity, size, place and angle; only there when it is. */
#include "app/forms/bound-form.h"
#include "app/forms/panel.h"
#include "doc/document/picture.h"
#include "io/text/io-error.h"
#include <glib/gi18n.h>

enum { TROUBLE, ALLOW, OPACITY, WIDTH, X, Y, ANGLE };

/* The picture is no part of the model: its steps are made here. */
static const QnFormField fields[] = {
  [TROUBLE] = { .id = "trouble" },
  [ALLOW] = { .id = "allow" },
  [OPACITY] = { .id = "opacity" },
  [WIDTH] = { .id = "width" },
  [X] = { .id = "x" },
  [Y] = { .id = "y" },
  [ANGLE] = { .id = "angle" },
};

static double *
number_of (QnUnderlay *underlay, guint field)
{
  double *const all[] = { [OPACITY] = &underlay->opacity,
                          [WIDTH] = &underlay->width,
                          [X] = &underlay->origin.x,
                          [Y] = &underlay->origin.y,
                          [ANGLE] = &underlay->angle };
  return all[field];
}

static gboolean
look (gpointer data)
{
  QnViewState *state = qn_canvas_get_state (((QnBoundForm *) data)->canvas);
  return qn_view_state_get_underlay (state)->image != NULL
         || qn_view_state_get_underlay_error (state) != NULL;
}

static gboolean
show (gpointer data, guint field, QnValue *value)
{
  QnViewState *state = qn_canvas_get_state (((QnBoundForm *) data)->canvas);
  const GError *error = qn_view_state_get_underlay_error (state);
  QnUnderlay underlay = *qn_view_state_get_underlay (state);
  if (field == ALLOW)
    return g_error_matches (error, QN_IO_ERROR, QN_IO_ERROR_OUTSIDE);
  if (field == TROUBLE) {
    value->text = g_strdup (error != NULL ? error->message : "");
    return error != NULL;
  }
  value->number = *number_of (&underlay, field);
  return TRUE;
}

static gboolean
take (gpointer data, QnProject *draft, guint field, const QnValue *value, GError **error)
{
  QnCanvas *canvas = ((QnBoundForm *) data)->canvas;
  QnDocument *document = qn_canvas_get_document (canvas);
  QnUnderlay underlay = *qn_view_state_get_underlay (qn_canvas_get_state (canvas));
  gboolean fade = field == OPACITY;
  (void) draft;
  if (field == ALLOW) {
    qn_document_allow_picture (document);
    qn_view_state_refresh_underlay (qn_canvas_get_state (canvas));
    return TRUE;
  }
  *number_of (&underlay, field) = value->number;
  return qn_document_place_picture (document,
                                    fade ? _ ("Fade Picture") : _ ("Place Picture"),
                                    fade ? "picture-opacity" : NULL, &underlay, error);
}

GtkWidget *
qn_picture_panel_new (QnCanvas *canvas)
{
  static const QnFormKind kind =
    QN_FORM_KIND ("picture-panel", QnBoundForm, QN_FOLLOW_VIEW);
  return qn_bound_form_show (qn_bound_form_new (&kind, canvas));
}
