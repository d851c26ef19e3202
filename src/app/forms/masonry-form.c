/* The parameters of the masonry that the selected blocks belong to. */
#include "app/forms/form.h"
#include "app/forms/panel.h"
#include "doc/edit/edit-masonry.h"
#include "doc/masonry/masonry-field.h"
#include <glib/gi18n.h>

typedef struct Form {
  QnCanvas *canvas;
  GtkWidget *box;
  GtkLabel *title;
  QnQuantityEntry *fields[QN_MASONRY_FIELD_COUNT];
  GtkDropDown *bond, *closer, *shape, *sides, *law;
  GtkLabel *openings;
  QnId object; /* that the form is about, or QN_NONE */
} Form;

/* Bonds in the list. */
static const QnBond bonds[] = { QN_BOND_RUNNING, QN_BOND_STACK,   QN_BOND_HEADER,
                                QN_BOND_ENGLISH, QN_BOND_FLEMISH, QN_BOND_CUSTOM };

/* The object of the selected blocks, or of the selected opening. */
static QnId
selected_object (Form *form)
{
  QnSelection *selection = qn_canvas_get_selection (form->canvas);
  const QnModel *model = qn_canvas_get_model (form->canvas);
  QnId object;
  int opening;
  guint count = 0;
  const QnId *ids = qn_selection_get_blocks (selection, &count);
  if (count > 0)
    object = model->blocks[ids[0]].masonry;
  else if (!qn_selection_get_opening (selection, &object, &opening))
    object = QN_NONE;
  return object >= 0 && (gsize) object < qn_canvas_get_masonry (form->canvas)->count
           ? object
           : QN_NONE;
}

/* ---- changes ---- */

typedef enum { CHANGE_FIELD, CHANGE_BOND, CHANGE_CLOSER, CHANGE_ARCH, CHANGE_LAW } Kind;

typedef struct Change {
  Kind kind;
  QnId object;
  QnMasonryField field;
  double value;
  guint choice, other;
  QnId law;
} Change;

static gboolean
change_masonry (QnMasonry *masonry, gpointer data, GError **error)
{
  (void) error;
  const Change *change = data;
  QnLeaf *leaf = &masonry->wall.leaves[0];
  switch (change->kind) {
  case CHANGE_FIELD:
    qn_masonry_set_field (masonry, change->field, change->value);
    break;
  case CHANGE_BOND:
    qn_masonry_set_bond (masonry, bonds[change->choice], leaf->lap);
    break;
  case CHANGE_CLOSER:
    leaf->closer = (QnCloser) change->choice;
    break;
  case CHANGE_ARCH:
    masonry->arch.shape = (QnArchShape) change->choice;
    masonry->arch.sides = (QnSides) change->other;
    break;
  case CHANGE_LAW:
    masonry->law = change->law;
    break;
  }
  return TRUE;
}

static gboolean
edit_change (QnProject *draft, gpointer data, GError **error)
{
  const Change *change = data;
  return qn_edit_change_masonry (draft, change->object, change_masonry, data, error);
}

static void update (Form *form);

static void
apply (Form *form, const char *name, Change change)
{
  change.object = form->object;
  if (form->object == QN_NONE
      || !qn_canvas_edit_project (form->canvas, name, NULL, edit_change, &change))
    update (form);
}

static void
on_field (QnQuantityEntry *entry, Form *form)
{
  for (int field = 0; field < QN_MASONRY_FIELD_COUNT; field++) {
    if (form->fields[field] != entry)
      continue;
    const char *label = _ (qn_masonry_field_info ((QnMasonryField) field)->label);
    g_autofree char *name = g_strdup_printf (_ ("Change %s"), label);
    apply (form, name,
           (Change){ .kind = CHANGE_FIELD,
                     .field = (QnMasonryField) field,
                     .value = qn_quantity_entry_get_value (entry) });
    return;
  }
}

static void
on_bond (GtkDropDown *choice, GParamSpec *pspec, Form *form)
{
  (void) pspec;
  guint bond = gtk_drop_down_get_selected (choice);
  if (bond < G_N_ELEMENTS (bonds) && bonds[bond] != QN_BOND_CUSTOM)
    apply (form, _ ("Change Bond"), (Change){ .kind = CHANGE_BOND, .choice = bond });
  else
    update (form);
}

static void
on_closer (GtkDropDown *choice, GParamSpec *pspec, Form *form)
{
  (void) pspec;
  apply (
    form, _ ("Change Closers"),
    (Change){ .kind = CHANGE_CLOSER, .choice = gtk_drop_down_get_selected (choice) });
}

static void
on_arch (GtkDropDown *choice, GParamSpec *pspec, Form *form)
{
  (void) choice;
  (void) pspec;
  apply (form, _ ("Change Arch"),
         (Change){ .kind = CHANGE_ARCH,
                   .choice = gtk_drop_down_get_selected (form->shape),
                   .other = gtk_drop_down_get_selected (form->sides) });
}

static void
on_law (GtkDropDown *choice, GParamSpec *pspec, Form *form)
{
  (void) pspec;
  apply (form, _ ("Set Law"),
         (Change){ .kind = CHANGE_LAW, .law = qn_form_get_law (choice) });
}

/* ---- what is shown ---- */

static char *
dup_title (const QnMasonry *masonry)
{
  switch (masonry->kind) {
  case QN_MASONRY_WALL:
    return g_strdup_printf (_ ("Wall %s"), masonry->name);
  case QN_MASONRY_ARCH:
    return g_strdup_printf (_ ("Arch %s"), masonry->name);
  case QN_MASONRY_COLUMN:
    return g_strdup_printf (_ ("Column %s"), masonry->name);
  case QN_MASONRY_BUTTRESS:
    return g_strdup_printf (_ ("Buttress %s"), masonry->name);
  case QN_MASONRY_PORTAL:
    return g_strdup_printf (_ ("Portal %s"), masonry->name);
  case QN_MASONRY_RUBBLE:
    return g_strdup_printf (_ ("Rubble %s"), masonry->name);
  case QN_MASONRY_KIND_COUNT:
    break;
  }
  return g_strdup (masonry->name);
}

static guint
row_of_bond (QnBond bond)
{
  for (guint i = 0; i < G_N_ELEMENTS (bonds); i++) {
    if (bonds[i] == bond)
      return i;
  }
  return 0;
}

static void
update_choices (Form *form, const QnMasonry *masonry)
{
  gboolean wall = masonry->kind == QN_MASONRY_WALL;
  gboolean arch = masonry->kind == QN_MASONRY_ARCH;
  const QnLeaf *leaf = &masonry->wall.leaves[0];
  qn_form_set_row_visible (GTK_WIDGET (form->bond), wall);
  qn_form_set_row_visible (
    GTK_WIDGET (form->closer),
    wall && (leaf->bond == QN_BOND_ENGLISH || leaf->bond == QN_BOND_FLEMISH));
  qn_form_set_row_visible (GTK_WIDGET (form->shape), arch);
  qn_form_set_row_visible (GTK_WIDGET (form->sides), arch);
  gtk_widget_set_visible (GTK_WIDGET (form->openings), wall);
  qn_form_set_choice (form->bond, row_of_bond (leaf->bond), form);
  qn_form_set_choice (form->closer, leaf->closer, form);
  qn_form_set_choice (form->shape, masonry->arch.shape, form);
  qn_form_set_choice (form->sides, masonry->arch.sides, form);
  guint count = (guint) masonry->wall.opening_count;
  g_autofree char *openings =
    count == 0
      ? g_strdup (_ ("No openings: cut some with the opening tool."))
      : g_strdup_printf (ngettext ("%u opening: click it in the drawing to change "
                                   "it.",
                                   "%u openings: click one in the drawing to "
                                   "change it.",
                                   count),
                         count);
  gtk_label_set_text (form->openings, openings);
}

static void
update (Form *form)
{
  form->object = selected_object (form);
  gtk_widget_set_visible (form->box, form->object != QN_NONE);
  if (form->object == QN_NONE)
    return;
  const QnMasonry *masonry = &qn_canvas_get_masonry (form->canvas)->items[form->object];
  g_autofree char *title = dup_title (masonry);
  gtk_label_set_text (form->title, title);
  for (int field = 0; field < QN_MASONRY_FIELD_COUNT; field++) {
    gboolean has = qn_masonry_has_field (masonry, (QnMasonryField) field);
    qn_form_set_row_visible (GTK_WIDGET (form->fields[field]), has);
    if (has)
      qn_quantity_entry_set_value (
        form->fields[field], qn_masonry_get_field (masonry, (QnMasonryField) field));
  }
  update_choices (form, masonry);
  qn_form_fill_laws (form->law, qn_canvas_get_model (form->canvas), _ ("As all contacts"),
                     masonry->law, form);
}

static void
build_choices (Form *form, GtkWidget *grid)
{
  const char *const bond_names[] = { _ ("Running bond"),
                                     _ ("Stack bond"),
                                     _ ("Header bond"),
                                     _ ("English bond"),
                                     _ ("Flemish bond"),
                                     _ ("As listed"),
                                     NULL };
  const char *const closers[] = { _ ("None"), _ ("Queen closers"),
                                  _ ("Three-quarter bats"), NULL };
  const char *const shapes[] = { _ ("Circular"), _ ("Pointed"), _ ("Elliptic"), NULL };
  const char *const sides[] = { _ ("Curved"), _ ("Straight"), NULL };
  const char *const none[] = { NULL };
  form->bond =
    qn_form_add_choice (grid, _ ("B_ond"), bond_names, G_CALLBACK (on_bond), form);
  form->closer =
    qn_form_add_choice (grid, _ ("Closers"), closers, G_CALLBACK (on_closer), form);
  form->shape =
    qn_form_add_choice (grid, _ ("Shape"), shapes, G_CALLBACK (on_arch), form);
  form->sides = qn_form_add_choice (grid, _ ("Sides of voussoirs"), sides,
                                    G_CALLBACK (on_arch), form);
  form->law = qn_form_add_choice (grid, _ ("_Law"), none, G_CALLBACK (on_law), form);
}

GtkWidget *
qn_detach_button_new (void)
{
  GtkWidget *button = gtk_button_new_with_mnemonic (_ ("_Detach into Free Blocks"));
  gtk_actionable_set_action_name (GTK_ACTIONABLE (button), "win.detach");
  gtk_widget_set_tooltip_text (
    button, _ ("Free blocks can be moved, turned, fixed and renamed one by one"));
  return button;
}

GtkWidget *
qn_masonry_form_new (QnCanvas *canvas)
{
  Form *form = g_new0 (Form, 1);
  form->canvas = canvas;
  GtkWidget *grid = form->box = qn_form_new ();
  form->title = GTK_LABEL (qn_form_add_heading (grid, ""));
  build_choices (form, grid);
  for (int field = 0; field < QN_MASONRY_FIELD_COUNT; field++) {
    const QnFieldInfo *info = qn_masonry_field_info ((QnMasonryField) field);
    form->fields[field] =
      qn_form_add_quantity (grid, _ (info->label), info->quantity, info->least,
                            info->most, G_CALLBACK (on_field), form);
  }
  form->openings = qn_form_add_text (grid);
  qn_form_add_wide (grid, qn_detach_button_new ());
  qn_form_follow_canvas (grid, canvas, G_CALLBACK (update), form);
  update (form);
  return grid;
}
