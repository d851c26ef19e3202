/* Copies of what is selected: in a row, a column, or around a point. */
#include "app/forms/form.h"
#include "app/forms/panel.h"

typedef struct Form {
  QnForm base;
  double numbers[4]; /* copies, each to the right, up, turned by */
} Form;

#define FIELDS(FIELD, MEMBER)                                                            \
  MEMBER (COPIES, "copies", NULL, Form, numbers[0])                                      \
  MEMBER (RIGHT, "right", NULL, Form, numbers[1])                                        \
  MEMBER (UP, "up", NULL, Form, numbers[2])                                              \
  MEMBER (TURN, "turn", NULL, Form, numbers[3])                                          \
  FIELD (MAKE, "make", NULL)
QN_FORM_FIELDS;

static gboolean
look (QnForm *data, const QnModel *model)
{
  return data->parts.blocks.count + data->parts.beams.count > 0;
}

static gboolean
show (QnForm *form, const QnModel *model, guint field, QnValue *value)
{
  return TRUE;
}

static gboolean
take (QnForm *data, QnModel *model, guint field, const QnValue *value, GError **error)
{
  const Form *form = (const Form *) data;
  if (field == MAKE)
    gtk_widget_activate_action (GTK_WIDGET (form->base.canvas), "win.array", "(iddd)",
                                (int) form->numbers[COPIES], form->numbers[RIGHT],
                                form->numbers[UP], form->numbers[TURN]);
  return TRUE;
}

/* As it is before anything is shown. */
static void
init (QnForm *data)
{
  Form *form = (Form *) data;
  form->numbers[COPIES] = 3.0;
  form->numbers[RIGHT] = 1.0;
}

const QnFormKind qn_array_form = QN_FORM_KIND (
  "array-form", Form, .look = look, .follows = QN_FOLLOW_SELECTION, .init = init);
