#include "app/forms/form.h"

#include "app/widgets/builder.h"
#include "app/widgets/choice-list.h"
#include "app/widgets/context-menu.h"
#include "app/widgets/quantity-entry.h"
#include "app/widgets/row.h"
#include <glib/gi18n.h>
#include <math.h>

/* What an entry tells by itself, while it shows a refusal; what it has shown or was last taken of it. */
#define TOOLTIP "qn-tooltip"
#define KNOWN   "qn-known"

static GMenuModel *make_menu (GtkWidget *widget, QnMenuPlace *place, gpointer data);

/* ---- members ---- */

/* What is selected is looked at; returns the document's model, which only steps change; NULL in dialogs. */
static QnModel *
look_at_document (QnForm *form)
{
  if (form->canvas == NULL)
    return NULL;
  form->parts = qn_selection_get_parts (form->canvas->selection);
  return (QnModel *) qn_canvas_get_model (form->canvas);
}

gpointer
qn_form_item (gconstpointer data, const QnModel *model)
{
  const QnForm *form = data;
  const QnFormList *list = form->kind->list;
  return form->selected < 0 ? NULL
                            : G_STRUCT_MEMBER (char *, model, list->items)
                                + (gsize) form->selected * list->size;
}

/* Takes a value into the member of a field, or shows it; nothing where it has none, or there is no subject. */
static void
exchange_member (QnForm *form, QnModel *model, guint field, QnValue *value,
                 gboolean takes)
{
  const QnFormKind *kind = form->kind;
  if (field >= kind->field_count || kind->fields[field].size == 0)
    return;
  char *subject = kind->subject != NULL ? kind->subject (form, model, field)
                  : kind->list != NULL  ? qn_form_item (form, model)
                                        : (gpointer) form;
  if (subject == NULL)
    return;
  const gpointer at = subject + kind->fields[field].offset;
  const gsize size = kind->fields[field].size;
  if (kind->fields[field].is_text) {
    if (!takes)
      value->text = g_strdup (*(char **) at);
  } else if (!takes)
    value->number = size == sizeof (double) ? *(double *) at
                    : size == sizeof (bool) ? *(bool *) at
                                            : *(int *) at;
  else if (size == sizeof (double))
    *(double *) at = value->number;
  else if (size == sizeof (bool))
    *(bool *) at = value->number != 0.0;
  else
    *(int *) at = qn_value_int (value);
}

/* ---- widgets ---- */

static void on_entered (GtkWidget *widget);

/* How kinds of widgets tell that something was entered, and the property that is its number. What derives
 * from another kind is before it. */
typedef struct Way {
  GType (*type) (void);
  const char *signal, *property;
} Way;

static const Way *
way_of (GtkWidget *widget)
{
  static const Way ways[] = {
    { qn_quantity_entry_get_type, "committed", NULL },
    { gtk_drop_down_get_type, "notify::selected", "selected" },
    { gtk_list_box_get_type, "row-selected", NULL },
    { gtk_check_button_get_type, "toggled", "active" },
    { gtk_switch_get_type, "notify::active", "active" },
    { gtk_spin_button_get_type, "value-changed", "value" },
    { gtk_range_get_type, "value-changed", "value" },
    { gtk_entry_get_type, "activate", NULL },
    { gtk_toggle_button_get_type, "toggled", "active" },
    { gtk_button_get_type, "clicked", NULL },
  };
  for (gsize i = 0; i < G_N_ELEMENTS (ways); i++)
    if (g_type_is_a (G_OBJECT_TYPE (widget), ways[i].type ()))
      return &ways[i];
  return NULL;
}

/* The number of a property: a "value" is a real one, rows (none is -1, as GTK_INVALID_LIST_POSITION) and
 * flags are whole ones. */
static void
exchange_number (GtkWidget *widget, const char *property, double *number, gboolean shows)
{
  gpointer object = GTK_IS_RANGE (widget)
                      ? (gpointer) gtk_range_get_adjustment (GTK_RANGE (widget))
                      : widget;
  int whole = (int) *number;
  if (shows && *property == 'v')
    g_object_set (object, property, *number, NULL);
  else if (shows)
    g_object_set (object, property, whole, NULL);
  else if (*property == 'v')
    g_object_get (object, property, number, NULL);
  else {
    g_object_get (object, property, &whole, NULL);
    *number = whole;
  }
}

static void
show_list (QnForm *form, GtkListBox *list, const QnValue *value)
{
  GtkWidget *child = gtk_widget_get_first_child (GTK_WIDGET (list));
  for (char **row = value->rows; row != NULL && *row != NULL; row++) {
    if (child == NULL) {
      g_autoptr (GtkBuilder) builder = qn_builder_new ("list-row");
      qn_context_menu_attach (qn_builder_get_widget (builder, "text"), make_menu, form);
      gtk_list_box_append (list, qn_builder_take_widget (builder, "row"));
      child = gtk_widget_get_last_child (GTK_WIDGET (list));
    }
    GtkWidget *icon =
      gtk_widget_get_first_child (gtk_list_box_row_get_child (GTK_LIST_BOX_ROW (child)));
    GtkWidget *label = gtk_widget_get_next_sibling (icon);
    gtk_widget_set_visible (icon, value->icons != NULL);
    if (value->icons != NULL)
      gtk_image_set_from_icon_name (GTK_IMAGE (icon), value->icons[row - value->rows]);
    gtk_label_set_text (GTK_LABEL (label), *row);
    gtk_widget_set_tooltip_text (label, *row);
    gtk_widget_set_visible (child, **row != '\0');
    child = gtk_widget_get_next_sibling (child);
  }
  while (child != NULL) {
    GtkWidget *next = gtk_widget_get_next_sibling (child);
    gtk_list_box_remove (list, child);
    child = next;
  }
  gtk_list_box_select_row (list, value->number < 0.0 ? NULL
                                                     : gtk_list_box_get_row_at_index (
                                                       list, (int) value->number));
  GtkWidget *scroller =
    gtk_widget_get_ancestor (GTK_WIDGET (list), GTK_TYPE_SCROLLED_WINDOW);
  if (scroller != NULL && gtk_widget_has_css_class (scroller, "frame"))
    gtk_widget_set_visible (scroller, value->rows != NULL && value->rows[0] != NULL);
}

/* Checks that are there stay: one of them may be telling of its change. */
static void
show_checks (GtkBox *box, const QnValue *value)
{
  GtkWidget *check = gtk_widget_get_first_child (GTK_WIDGET (box));
  for (guint i = 0; value->rows[i] != NULL; i++) {
    if (check == NULL) {
      check = gtk_check_button_new ();
      g_signal_connect_swapped (check, "toggled", G_CALLBACK (on_entered), box);
      gtk_box_append (box, check);
    }
    gtk_check_button_set_label (GTK_CHECK_BUTTON (check), value->rows[i]);
    gtk_check_button_set_active (GTK_CHECK_BUTTON (check),
                                 (guint32) value->number >> i & 1);
    check = gtk_widget_get_next_sibling (check);
  }
  while (check != NULL) {
    GtkWidget *next = gtk_widget_get_next_sibling (check);
    gtk_box_remove (box, check);
    check = next;
  }
}

static void
know_text (GtkWidget *entry, const char *text)
{
  g_object_set_data_full (G_OBJECT (entry), KNOWN, g_strdup (text), g_free);
}

static void
show_value (QnForm *form, GtkWidget *widget, const QnValue *value)
{
  const Way *way = way_of (widget);
  double number = value->mixed ? 0.0 : value->number;
  if (GTK_IS_DROP_DOWN (widget) && value->rows != NULL)
    qn_choice_list_fill (GTK_DROP_DOWN (widget), (const char *const *) value->rows);
  if (way != NULL && way->property != NULL)
    exchange_number (widget, way->property, &number, TRUE);
  else if (QN_IS_QUANTITY_ENTRY (widget) && value->mixed)
    qn_quantity_entry_set_mixed (QN_QUANTITY_ENTRY (widget));
  else if (QN_IS_QUANTITY_ENTRY (widget))
    qn_quantity_entry_set_value (QN_QUANTITY_ENTRY (widget), value->number);
  else if (GTK_IS_LIST_BOX (widget))
    show_list (form, GTK_LIST_BOX (widget), value);
  else if (GTK_IS_BOX (widget) && value->rows != NULL)
    show_checks (GTK_BOX (widget), value);
  else if (GTK_IS_LABEL (widget) && value->text != NULL)
    gtk_label_set_text (GTK_LABEL (widget), value->text);
  else if (GTK_IS_EDITABLE (widget)) {
    const char *text = value->text != NULL ? value->text : "";
    know_text (widget, text);
    if (!g_str_equal (gtk_editable_get_text (GTK_EDITABLE (widget)), text))
      gtk_editable_set_text (GTK_EDITABLE (widget), text);
    if (gtk_widget_has_css_class (widget, "error"))
      gtk_widget_set_tooltip_text (widget,
                                   g_object_get_data (G_OBJECT (widget), TOOLTIP));
    gtk_widget_remove_css_class (widget, "error");
  }
  if (GTK_IS_CHECK_BUTTON (widget))
    gtk_check_button_set_inconsistent (GTK_CHECK_BUTTON (widget), value->mixed);
  if (GTK_IS_CHECK_BUTTON (widget) && value->text != NULL)
    gtk_check_button_set_label (GTK_CHECK_BUTTON (widget), value->text);
  /* A button of an action can be pressed while the action can be done. */
  if (!GTK_IS_ACTIONABLE (widget)
      || gtk_actionable_get_action_name (GTK_ACTIONABLE (widget)) == NULL)
    gtk_widget_set_sensitive (widget, !value->disabled);
}

static QnValue
take_value (GtkWidget *widget)
{
  const Way *way = way_of (widget);
  QnValue value = { 0 };
  if (way != NULL && way->property != NULL)
    exchange_number (widget, way->property, &value.number, FALSE);
  else if (QN_IS_QUANTITY_ENTRY (widget))
    value.number = qn_quantity_entry_get_value (QN_QUANTITY_ENTRY (widget));
  else if (GTK_IS_LIST_BOX (widget)) {
    GtkListBoxRow *row = gtk_list_box_get_selected_row (GTK_LIST_BOX (widget));
    value.number = row != NULL ? gtk_list_box_row_get_index (row) : -1;
  } else if (GTK_IS_BOX (widget)) {
    guint32 bits = 0, bit = 1;
    for (GtkWidget *check = gtk_widget_get_first_child (widget); check != NULL;
         check = gtk_widget_get_next_sibling (check), bit <<= 1)
      if (gtk_check_button_get_active (GTK_CHECK_BUTTON (check)))
        bits |= bit;
    value.number = bits;
  } else if (GTK_IS_EDITABLE (widget))
    value.text = g_strdup (gtk_editable_get_text (GTK_EDITABLE (widget)));
  return value;
}

/* ---- the list ---- */

static gsize
count_items (const QnForm *form, const QnModel *model)
{
  return G_STRUCT_MEMBER (size_t, model, form->kind->list->count);
}

/* What an edit has added is selected; what was selected in the drawing is shown. */
static void
follow_list (QnForm *form, const QnModel *model)
{
  const QnFormList *list = form->kind->list;
  const int count = (int) count_items (form, model), before = form->selected;
  if (list->kind == QN_PICK_NOTHING) {
    form->selected = MIN (form->wanted >= 0 ? form->wanted : before, count - 1);
    form->wanted = -1;
    return;
  }
  QnSelection *selection = form->canvas->selection;
  if (form->wanted >= 0 && form->wanted < count)
    qn_selection_set_one (selection, list->kind, form->wanted);
  form->wanted = -1;
  form->selected = qn_selection_get_one (selection, list->kind);
  if (form->selected >= count)
    form->selected = -1;
  if (form->selected >= 0 && form->selected != before)
    qn_form_reveal (form);
}

static gboolean
is_list (const QnForm *form, guint field)
{
  return form->kind->list != NULL && field == form->kind->list->list;
}

GtkWidget *
qn_form_show (gpointer data)
{
  QnForm *form = data;
  if (form->showing)
    return form->root;
  form->showing = TRUE;
  const QnFormList *list = form->kind->list;
  if (list != NULL)
    follow_list (form, qn_canvas_get_model (form->canvas));
  QnModel *model = look_at_document (form);
  gboolean there = form->kind->look == NULL || form->kind->look (form, model);
  if (!GTK_IS_WINDOW (form->root))
    gtk_widget_set_visible (form->root, there);
  for (guint field = 0; there && form->widgets[field] != NULL; field++) {
    if (list != NULL && field == list->empty) {
      gtk_widget_set_visible (form->widgets[field], count_items (form, model) == 0);
      continue;
    }
    QnValue value = { 0 };
    gboolean shown;
    if (is_list (form, field)) {
      value.number = form->selected;
      for (gsize i = 0; i < count_items (form, model); i++)
        qn_value_take_row (&value, list->dup_row (model, i));
      shown = value.row_count > 0;
    } else {
      exchange_member (form, model, field, &value, FALSE);
      shown = form->kind->show (form, model, field, &value);
    }
    gtk_widget_set_visible (form->widgets[field], shown);
    if (shown)
      show_value (form, form->widgets[field], &value);
    qn_value_clear (&value);
  }
  form->showing = FALSE;
  return form->root;
}

/* A part of what scrolls, as much of it as there is room for. */
static void
scroll_to_part (GtkWidget *part)
{
  GtkWidget *scroller = gtk_widget_get_ancestor (part, GTK_TYPE_SCROLLED_WINDOW);
  graphene_point_t at;
  if (scroller == NULL
      || !gtk_widget_compute_point (part, scroller, graphene_point_zero (), &at))
    return;
  GtkAdjustment *place =
    gtk_scrolled_window_get_vadjustment (GTK_SCROLLED_WINDOW (scroller));
  const double top = gtk_adjustment_get_value (place) + at.y;
  gtk_adjustment_clamp_page (
    place, top,
    top + MIN (gtk_widget_get_height (part), gtk_adjustment_get_page_size (place)));
}

/* In the second frame: in the first one the form gets its place. */
static gboolean
scroll_to (GtkWidget *root, GdkFrameClock *clock, gpointer data)
{
  QnForm *form = data;
  if (form->frames++ < 2)
    return G_SOURCE_CONTINUE;
  for (guint i = 0; form->widgets[i] != NULL; i++) {
    GtkListBox *list =
      GTK_IS_LIST_BOX (form->widgets[i]) ? (gpointer) form->widgets[i] : NULL;
    if (list != NULL && gtk_list_box_get_selected_row (list) != NULL)
      scroll_to_part (GTK_WIDGET (gtk_list_box_get_selected_row (list)));
  }
  scroll_to_part (root);
  form->frames = 0;
  return G_SOURCE_REMOVE;
}

void
qn_form_reveal (gpointer data)
{
  QnForm *form = data;
  if (form->card != NULL)
    gtk_expander_set_expanded (form->card, TRUE);
  GtkRoot *window = gtk_widget_get_root (form->root);
  GtkWidget *focus = window != NULL ? gtk_root_get_focus (window) : NULL;
  if (GTK_IS_EXPANDER (form->root))
    gtk_expander_set_expanded (GTK_EXPANDER (form->root), TRUE);
  if (form->frames == 0
      && (focus == NULL || !gtk_widget_is_ancestor (focus, form->root))) {
    form->frames = 1;
    gtk_widget_add_tick_callback (form->root, scroll_to, form, NULL);
  }
}

/* ---- taking ---- */

double
qn_form_get_number (gpointer data, guint field)
{
  const QnForm *form = data;
  return form->taken != NULL && form->taken_field == field
           ? form->taken->number
           : take_value (form->widgets[field]).number;
}

char *
qn_form_dup_text (gpointer data, guint field)
{
  const QnForm *form = data;
  return take_value (form->widgets[field]).text;
}

typedef struct Entered {
  QnForm *form;
  guint field;
  QnValue value;
} Entered;

static gboolean
take (const Entered *entered, GError **error)
{
  QnForm *form = entered->form;
  QnValue value = entered->value;
  QnModel *shown = look_at_document (form),
          *model = form->draft != NULL ? &form->draft->model : shown;
  exchange_member (form, model, entered->field, &value, TRUE);
  return form->kind->take (form, model, entered->field, &entered->value, error);
}

static gboolean
edit (QnProject *draft, gpointer data, GError **error)
{
  const Entered *entered = data;
  QnForm *form = entered->form;
  form->draft = draft;
  form->taken = &entered->value;
  form->taken_field = entered->field;
  gboolean done = take (entered, error);
  form->draft = NULL;
  form->taken = NULL;
  return done;
}

/* What was typed stays, with the reason beside it; what was chosen is as before. */
static void
refuse (QnForm *form, GtkWidget *widget, const GError *error)
{
  if (QN_IS_QUANTITY_ENTRY (widget) && error != NULL)
    qn_quantity_entry_refuse (QN_QUANTITY_ENTRY (widget), error->message);
  else if (GTK_IS_ENTRY (widget) && error != NULL) {
    if (!gtk_widget_has_css_class (widget, "error"))
      g_object_set_data_full (G_OBJECT (widget), TOOLTIP,
                              g_strdup (gtk_widget_get_tooltip_text (widget)), g_free);
    gtk_widget_add_css_class (widget, "error");
    gtk_widget_set_tooltip_text (widget, error->message);
  } else
    qn_form_show (form);
  if (error != NULL && form->canvas != NULL)
    qn_canvas_tell (form->canvas, error->message);
}

/* "Change %s" of the row "_Width". */
static char *
dup_step (const char *step, GtkWidget *widget)
{
  GtkWidget *row = gtk_widget_get_ancestor (widget, QN_TYPE_ROW);
  GString *name = g_string_new (step);
  if (row != NULL)
    g_string_replace (
      name, "%s", gtk_label_get_text (GTK_LABEL (qn_row_get_label (QN_ROW (row)))), 1);
  return g_string_free (name, FALSE);
}

/* The name of the step that a new value of this field is; NULL where it changes no document. */
static const char *
step_of (const QnForm *form, guint field)
{
  const QnFormKind *kind = form->kind;
  if (field < kind->field_count)
    return kind->fields[field].step;
  const char *step = kind->row_info (field - kind->field_count).step;
  return step != NULL ? step : N_ ("Change %s");
}

static guint
field_of (const QnForm *form, const GtkWidget *widget)
{
  guint field = 0;
  while (form->widgets[field] != widget)
    field++;
  return field;
}

/* The context menu offers to vary the number of the file that another value of the field would change. */
static void
on_menu (QnQuantityEntry *entry, QnForm *form)
{
  Entered same = { .form = form,
                   .field = field_of (form, GTK_WIDGET (entry)),
                   .value.number = qn_quantity_entry_get_value (entry) };
  Entered other = same;
  double number = NAN;
  g_autofree char *path = NULL;
  g_autoptr (GMenu) menu = g_menu_new ();
  if (form->canvas == NULL || step_of (form, same.field) == NULL)
    return;
  for (guint attempt = 0;
       path == NULL && qn_quantity_entry_get_other (entry, attempt, &other.value.number);
       attempt++)
    path = qn_document_dup_number_path (form->canvas->document, edit, &same, &other,
                                        other.value.number, &number);
  if (path != NULL)
    qn_menu_add_target (
      menu, _ ("_Vary This…"), "win.vary",
      g_variant_new ("(sd)", path, isnan (number) ? same.value.number : number));
  gtk_entry_set_extra_menu (GTK_ENTRY (entry), path != NULL ? G_MENU_MODEL (menu) : NULL);
}

/* Whatever else its signal tells. */
static void
on_entered (GtkWidget *widget)
{
  QnForm *form = g_object_get_data (G_OBJECT (widget), QN_FORM);
  /* Lists that are being taken apart say that nothing is selected any more; the form is gone by then. */
  if (gtk_widget_get_root (widget) == NULL || form->showing)
    return;
  g_autoptr (GError) error = NULL;
  Entered entered = { .form = form,
                      .field = field_of (form, widget),
                      .value = take_value (widget) };
  if (entered.value.text != NULL)
    know_text (widget, entered.value.text);
  GtkWidget *popover = gtk_widget_get_ancestor (widget, GTK_TYPE_POPOVER);
  if (popover != NULL && GTK_IS_BUTTON (widget))
    gtk_popover_popdown (GTK_POPOVER (popover));
  const char *name = step_of (form, entered.field);
  gboolean done;
  g_rc_box_acquire (form); /* a button may close its dialog */
  if (is_list (form, entered.field)) {
    const QnPickKind kind = form->kind->list->kind;
    const int item = (int) entered.value.number;
    if (kind != QN_PICK_NOTHING)
      qn_selection_set_one (form->canvas->selection, kind, item);
    else
      form->selected = item;
    done = TRUE;
  } else if (name != NULL) {
    g_autofree char *step = dup_step (_ (name), widget);
    done = qn_document_edit (form->canvas->document, step, NULL, edit, &entered, &error);
  } else {
    done = take (&entered, &error);
  }
  if (!form->closed && done) {
    qn_form_show (form);
    if (form->told != NULL)
      qn_canvas_tell (form->canvas, form->told);
  } else if (!form->closed) {
    form->wanted = -1;
    refuse (form, widget, error);
  }
  form->told = NULL;
  qn_form_unref (form);
  qn_value_clear (&entered.value);
}

/* The widget of that id, where the form has one that can be used now. */
static GtkWidget *
find_usable (const QnForm *form, const char *id)
{
  for (guint field = 0; field < form->kind->field_count; field++)
    if (g_str_equal (form->kind->fields[field].id, id)
        && gtk_widget_get_visible (form->widgets[field])
        && gtk_widget_get_sensitive (form->widgets[field]))
      return form->widgets[field];
  return NULL;
}

/* A double click or Enter goes to the name of what is selected in a list. */
static void
on_row_activated (GtkListBox *list, GtkListBoxRow *row, QnForm *form)
{
  GtkWidget *name = find_usable (form, "name");
  if (name != NULL)
    gtk_widget_grab_focus (name);
}

/* F2 does so, too; Delete removes it, as the button that is called "remove" does. */
static gboolean
on_list_key (GtkEventControllerKey *keys, guint key, guint code, GdkModifierType state,
             QnForm *form)
{
  gboolean removes = key == GDK_KEY_Delete || key == GDK_KEY_KP_Delete;
  GtkWidget *wanted = removes             ? find_usable (form, "remove")
                      : key == GDK_KEY_F2 ? find_usable (form, "name")
                                          : NULL;
  if (wanted != NULL && removes)
    g_signal_emit_by_name (wanted, "clicked");
  return wanted != NULL && (removes || gtk_widget_grab_focus (wanted));
}

/* Not while the window goes, nor what was taken, or refused, already. */
static void
on_left (GtkEventController *focus, QnForm *form)
{
  GtkWidget *entry = gtk_event_controller_get_widget (focus);
  if (gtk_widget_get_mapped (entry)
      && g_strcmp0 (gtk_editable_get_text (GTK_EDITABLE (entry)),
                    g_object_get_data (G_OBJECT (entry), KNOWN))
           != 0)
    on_entered (entry);
}

static void
on_refused (QnQuantityEntry *entry, const char *reason, QnForm *form)
{
  if (form->canvas != NULL)
    qn_canvas_tell (form->canvas, reason);
}

static void
connect (QnForm *form, GtkWidget *widget)
{
  g_object_set_data (G_OBJECT (widget), QN_FORM, form);
  /* Where buttons have little room their words go below each other. */
  GtkWidget *words =
    GTK_IS_BUTTON (widget) ? gtk_button_get_child (GTK_BUTTON (widget)) : NULL;
  if (GTK_IS_LABEL (words)) {
    gtk_label_set_wrap (GTK_LABEL (words), TRUE);
    gtk_label_set_justify (GTK_LABEL (words), GTK_JUSTIFY_CENTER);
  }
  /* A button with an action is a field only to be shown or hidden. */
  if (GTK_IS_ACTIONABLE (widget)
      && gtk_actionable_get_action_name (GTK_ACTIONABLE (widget)) != NULL)
    return;
  const Way *way = way_of (widget);
  if (way != NULL)
    g_signal_connect (widget, way->signal, G_CALLBACK (on_entered), NULL);
  if (GTK_IS_ENTRY (widget) && !QN_IS_QUANTITY_ENTRY (widget)) { /* which do so */
    GtkEventController *focus = gtk_event_controller_focus_new ();
    g_signal_connect (focus, "leave", G_CALLBACK (on_left), form);
    gtk_widget_add_controller (widget, focus);
  }
  if (GTK_IS_LIST_BOX (widget)) {
    GtkEventController *keys = gtk_event_controller_key_new ();
    g_signal_connect (keys, "key-pressed", G_CALLBACK (on_list_key), form);
    gtk_widget_add_controller (widget, keys);
    gtk_list_box_set_activate_on_single_click (GTK_LIST_BOX (widget), FALSE);
    g_signal_connect (widget, "row-activated", G_CALLBACK (on_row_activated), form);
  }
  if (QN_IS_QUANTITY_ENTRY (widget)) {
    g_signal_connect (widget, "refused", G_CALLBACK (on_refused), form);
    g_signal_connect (widget, "menu", G_CALLBACK (on_menu), form);
  }
}

/* ---- context menus ---- */

/* A button that does something with what the form is about; and that can be pressed now. */
static gboolean
is_named (GtkWidget *button)
{
  return GTK_IS_BUTTON (button) && !GTK_IS_TOGGLE_BUTTON (button)
         && gtk_button_get_label (GTK_BUTTON (button)) != NULL
         && gtk_actionable_get_action_name (GTK_ACTIONABLE (button)) == NULL;
}

/* The buttons of the form, for the row of a list that was clicked or has the focus, or for what a
 * choice shows. */
static GMenuModel *
make_menu (GtkWidget *widget, QnMenuPlace *place, gpointer data)
{
  QnForm *form = data;
  GtkWidget *row = gtk_widget_get_ancestor (widget, GTK_TYPE_LIST_BOX_ROW);
  GMenu *menu = g_menu_new (), *commands = g_menu_new (), *text = g_menu_new ();
  if (row != NULL) {
    gtk_list_box_select_row (GTK_LIST_BOX (gtk_widget_get_parent (row)),
                             GTK_LIST_BOX_ROW (row));
    qn_menu_add_target (text, _ ("_Copy Text"), "win.copy-text",
                        g_variant_new_string (gtk_label_get_text (GTK_LABEL (widget))));
  }
  for (guint field = 0; form->widgets[field] != NULL; field++) {
    GtkWidget *button = form->widgets[field];
    if (is_named (button) && gtk_widget_get_visible (button)
        && gtk_widget_get_sensitive (button))
      qn_menu_add_target (commands, gtk_button_get_label (GTK_BUTTON (button)),
                          "form.press", g_variant_new_int32 ((int) field));
  }
  qn_menu_add_section (menu, commands);
  qn_menu_add_section (menu, text);
  return G_MENU_MODEL (menu);
}

static void
press (GSimpleAction *action, GVariant *field, gpointer data)
{
  QnForm *form = data;
  g_signal_emit_by_name (form->widgets[g_variant_get_int32 (field)], "clicked");
}

/* Choices of what the form is about have the menu, and the rows of lists. */
static void
add_menus (QnForm *form)
{
  static const GActionEntry entries[] = {
    { .name = "press", .activate = press, .parameter_type = "i" }
  };
  qn_actions_insert (form->root, "form", entries, G_N_ELEMENTS (entries), form);
  gboolean any = FALSE;
  for (guint i = 0; i < form->kind->field_count; i++)
    any = any || is_named (form->widgets[i]);
  for (guint i = 0; any && i < form->kind->field_count; i++)
    if (GTK_IS_DROP_DOWN (form->widgets[i]) && form->kind->fields[i].step == NULL)
      qn_context_menu_attach (form->widgets[i], make_menu, form);
}

/* ---- life ---- */

static void
on_destroy (QnForm *form)
{
  form->closed = TRUE;
}

static void
free_form (gpointer data)
{
  QnForm *form = data;
  if (form->kind->clear != NULL)
    form->kind->clear (form);
  g_free (form->widgets);
}

void
qn_form_unref (gpointer form)
{
  g_rc_box_release_full (form, free_form);
}

/* The labels of all rows below a widget are equally wide, and so are the fields, but for those that do
 * not fill theirs. */
static void
align_rows (GtkWidget *widget, GtkSizeGroup *labels, GtkSizeGroup *fields)
{
  if (QN_IS_ROW (widget)
      && gtk_widget_get_halign (qn_row_get_field (QN_ROW (widget))) == GTK_ALIGN_FILL) {
    gtk_size_group_add_widget (labels, qn_row_get_label (QN_ROW (widget)));
    gtk_size_group_add_widget (fields, qn_row_get_field (QN_ROW (widget)));
  }
  /* What is folded is no part of the tree. */
  if (GTK_IS_EXPANDER (widget))
    align_rows (gtk_expander_get_child (GTK_EXPANDER (widget)), labels, fields);
  for (GtkWidget *child = gtk_widget_get_first_child (widget); child != NULL;
       child = gtk_widget_get_next_sibling (child))
    align_rows (child, labels, fields);
}

gpointer
qn_form_new (const QnFormKind *kind, QnCanvas *canvas)
{
  g_autoptr (GtkBuilder) builder = qn_builder_new (kind->name);
  QnForm *form = g_rc_box_alloc0 (kind->size);
  form->kind = kind;
  form->canvas = canvas;
  form->selected = form->wanted = -1;
  form->root = qn_builder_take_widget (builder, "form");
  form->widgets = g_new0 (GtkWidget *, kind->field_count + kind->row_count + 1);
  for (guint i = 0; i < kind->field_count; i++) {
    GtkWidget *widget = GTK_WIDGET (gtk_builder_get_object (builder, kind->fields[i].id));
    form->widgets[i] = widget;
    if (GTK_IS_DROP_DOWN (widget))
      qn_choice_list_prepare (GTK_DROP_DOWN (widget));
    connect (form, widget);
  }
  for (guint i = 0; i < kind->row_count; i++) {
    const QnFieldInfo info = kind->row_info (i);
    GtkWidget *entry = qn_quantity_entry_new (info.quantity, info.least, info.most);
    gtk_box_append (GTK_BOX (gtk_builder_get_object (builder, "rows")),
                    qn_row_new (_ (info.label), entry));
    form->widgets[kind->field_count + i] = entry;
    connect (form, entry);
  }
  g_autoptr (GtkSizeGroup) labels = gtk_size_group_new (GTK_SIZE_GROUP_HORIZONTAL);
  g_autoptr (GtkSizeGroup) fields = gtk_size_group_new (GTK_SIZE_GROUP_HORIZONTAL);
  align_rows (form->root, labels, fields);
  g_object_set_data_full (G_OBJECT (form->root), QN_FORM, form, qn_form_unref);
  g_signal_connect_swapped (form->root, "destroy", G_CALLBACK (on_destroy), form);
  if (kind->init != NULL)
    kind->init (form);
  if (canvas == NULL)
    return form;
  add_menus (form);
  const struct {
    QnFollow what;
    gpointer object;
    const char *signal;
  } signals[] = { { QN_FOLLOW_SELECTION, canvas->selection, "changed" },
                  { QN_FOLLOW_RUNS, canvas->document, "runs-changed" },
                  { QN_FOLLOW_RUNS, canvas->document, "job-changed" },
                  { QN_FOLLOW_VIEW, canvas->state, "changed" },
                  { QN_FOLLOW_TOOL, canvas, "tool-changed" } };
  GCallback callback = G_CALLBACK (qn_form_show);
  qn_watch (form->root, canvas->document, "changed", callback, form);
  for (gsize i = 0; i < G_N_ELEMENTS (signals); i++)
    if ((kind->follows & signals[i].what) != 0)
      qn_watch (form->root, signals[i].object, signals[i].signal, callback, form);
  return form;
}
