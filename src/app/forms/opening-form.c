/* The selected opening of a wall: place, size, and what spans it. */
#include "app/forms/form.h"
#include "app/forms/panel.h"
#include "doc/edit/edit-masonry.h"
#include "doc/masonry/masonry-field.h"
#include <glib/gi18n.h>

typedef struct Form {
  QnCanvas *canvas;
  GtkWidget *box;
  GtkLabel *title;
  GtkDropDown *head, *span, *sides;
  QnQuantityEntry *fields[QN_OPENING_FIELD_COUNT];
} Form;

/* What spans flat heads, in the order of the list. */
static const QnSpan spans[] = { QN_SPAN_NONE, QN_SPAN_LINTEL, QN_SPAN_FLAT_ARCH,
                                QN_SPAN_VOUSSOIRS };

static const QnOpening *
selected_opening (Form *form, QnId *object, int *number)
{
  const QnMasonries *list = qn_canvas_get_masonry (form->canvas);
  if (!qn_selection_get_opening (qn_canvas_get_selection (form->canvas), object, number)
      || (gsize) *object >= list->count
      || (gsize) *number >= list->items[*object].wall.opening_count)
    return NULL;
  return &list->items[*object].wall.openings[*number];
}

typedef enum { CHANGE_FIELD, CHANGE_HEAD, CHANGE_SIDES } Kind;

typedef struct Change {
  Kind kind;
  QnId object;
  int number;
  QnOpeningField field;
  double value;
  QnHead head;
  QnSpan span;
  QnSides sides;
} Change;

static gboolean
change_opening (QnMasonry *masonry, gpointer data, GError **error)
{
  (void) error;
  const Change *change = data;
  QnOpening *opening = &masonry->wall.openings[change->number];
  switch (change->kind) {
  case CHANGE_FIELD:
    qn_opening_set_field (opening, change->field, change->value);
    break;
  case CHANGE_HEAD:
    qn_opening_set_head (opening, change->head, change->span,
                         masonry->wall.leaves[0].unit.y);
    break;
  case CHANGE_SIDES:
    opening->sides = change->sides;
    break;
  }
  return TRUE;
}

static gboolean
edit_change (QnProject *draft, gpointer data, GError **error)
{
  const Change *change = data;
  return qn_edit_change_masonry (draft, change->object, change_opening, data, error);
}

static void update (Form *form);

static void
apply (Form *form, const char *name, Change change)
{
  if (selected_opening (form, &change.object, &change.number) != NULL
      && qn_canvas_edit_project (form->canvas, name, NULL, edit_change, &change))
    return;
  update (form);
}

static void
on_field (QnQuantityEntry *entry, Form *form)
{
  for (int field = 0; field < QN_OPENING_FIELD_COUNT; field++) {
    if (form->fields[field] == entry)
      apply (form, field <= QN_OPENING_BOTTOM ? _ ("Move Opening") : _ ("Change Opening"),
             (Change){ .kind = CHANGE_FIELD,
                       .field = (QnOpeningField) field,
                       .value = qn_quantity_entry_get_value (entry) });
  }
}

static void
on_head (GtkDropDown *choice, GParamSpec *pspec, Form *form)
{
  (void) choice;
  (void) pspec;
  guint span = gtk_drop_down_get_selected (form->span);
  apply (form, _ ("Change Opening"),
         (Change){ .kind = CHANGE_HEAD,
                   .head = (QnHead) gtk_drop_down_get_selected (form->head),
                   .span = spans[MIN (span, G_N_ELEMENTS (spans) - 1)] });
}

static void
on_sides (GtkDropDown *choice, GParamSpec *pspec, Form *form)
{
  (void) pspec;
  apply (form, _ ("Change Opening"),
         (Change){ .kind = CHANGE_SIDES,
                   .sides = (QnSides) gtk_drop_down_get_selected (choice) });
}

static void
update (Form *form)
{
  QnId object;
  int number;
  const QnOpening *opening = selected_opening (form, &object, &number);
  gtk_widget_set_visible (form->box, opening != NULL);
  if (opening == NULL)
    return;
  g_autofree char *title = opening->name != NULL
                             ? g_strdup_printf (_ ("Opening %s"), opening->name)
                             : g_strdup_printf (_ ("Opening %d"), number + 1);
  gtk_label_set_text (form->title, title);
  qn_form_set_choice (form->head, opening->head, form);
  for (guint i = 0; i < G_N_ELEMENTS (spans); i++) {
    if (spans[i] == opening->span)
      qn_form_set_choice (form->span, i, form);
  }
  qn_form_set_choice (form->sides, opening->sides, form);
  qn_form_set_row_visible (GTK_WIDGET (form->sides), opening->span == QN_SPAN_VOUSSOIRS);
  for (int field = 0; field < QN_OPENING_FIELD_COUNT; field++) {
    gboolean has = qn_opening_has_field (opening, (QnOpeningField) field);
    qn_form_set_row_visible (GTK_WIDGET (form->fields[field]), has);
    if (has)
      qn_quantity_entry_set_value (
        form->fields[field], qn_opening_get_field (opening, (QnOpeningField) field));
  }
}

GtkWidget *
qn_opening_form_new (QnCanvas *canvas)
{
  const char *const heads[] = { _ ("Flat"), _ ("Segmental"), _ ("Round"), NULL };
  const char *const span_names[] = { _ ("Nothing"), _ ("Lintel"), _ ("Flat arch"),
                                     _ ("Voussoirs"), NULL };
  const char *const sides[] = { _ ("Curved"), _ ("Straight"), NULL };
  Form *form = g_new0 (Form, 1);
  form->canvas = canvas;
  GtkWidget *grid = form->box = qn_form_new ();
  form->title = GTK_LABEL (qn_form_add_heading (grid, ""));
  form->head = qn_form_add_choice (grid, _ ("_Head"), heads, G_CALLBACK (on_head), form);
  form->span =
    qn_form_add_choice (grid, _ ("_Spanned by"), span_names, G_CALLBACK (on_head), form);
  form->sides = qn_form_add_choice (grid, _ ("Sides of voussoirs"), sides,
                                    G_CALLBACK (on_sides), form);
  for (int field = 0; field < QN_OPENING_FIELD_COUNT; field++) {
    const QnFieldInfo *info = qn_opening_field_info ((QnOpeningField) field);
    form->fields[field] =
      qn_form_add_quantity (grid, _ (info->label), info->quantity, info->least,
                            info->most, G_CALLBACK (on_field), form);
  }
  GtkWidget *fill = gtk_button_new_with_mnemonic (_ ("_Fill Opening"));
  gtk_actionable_set_action_name (GTK_ACTIONABLE (fill), "win.delete");
  qn_form_add_wide (grid, fill);
  qn_form_follow_canvas (grid, canvas, G_CALLBACK (update), form);
  update (form);
  return grid;
}
