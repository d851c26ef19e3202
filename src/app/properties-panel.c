#include "app/form.h"
#include "app/panel.h"
#include "app/settings.h"
#include "doc/explain.h"
#include <glib/gi18n.h>
#include <math.h>

#define LARGEST 1e6 /* m, N/m3: limits of fields */

/* A panel's widgets; freed with the panel. */
typedef struct Panel {
  QnCanvas *canvas; /* not owned: lives as long as the panel's window */
  GtkWidget *tool_form, *block_form, *wall_form, *face_form, *empty_label;

  QnQuantityEntry *unit_x, *unit_y, *tool_thickness, *tool_weight, *force;
  GtkDropDown *bond, *force_kind;
  GtkWidget *base, *lintel;

  GtkLabel *block_title;
  GtkWidget *name;
  QnQuantityEntry *thickness, *weight;
  GtkDropDown *law;
  GtkWidget *support[QN_DOF_COUNT];
  GtkLabel *block_facts;
  QnQuantityEntry *copies, *step_x, *step_y;

  GtkLabel *wall_title;
  QnQuantityEntry *wall_x, *wall_y, *block_x, *block_y;

  GtkLabel *face_title, *face_facts;
  GtkDropDown *face_law, *placement;
  QnQuantityEntry *offset, *count;
} Panel;

static QnDocument *
document_of (const Panel *panel)
{
  return qn_canvas_get_document (panel->canvas);
}

static const QnModel *
model_of (const Panel *panel)
{
  return qn_document_get_model (document_of (panel));
}

/* The selected blocks, copied, because the selection may change under an edit. */
static QnBlockSet
dup_selected (const Panel *panel)
{
  guint count = 0;
  const QnId *ids =
    qn_selection_get_blocks (qn_canvas_get_selection (panel->canvas), &count);
  return (QnBlockSet){ g_memdup2 (ids, count * sizeof *ids), count };
}

/* ---- settings of the tools ---- */

static void
on_tool_setting (gpointer widget, Panel *panel)
{
  (void) widget;
  QnToolSettings *settings = qn_canvas_get_tool_settings (panel->canvas);
  settings->wall.unit = qn_vec2 (qn_quantity_entry_get_value (panel->unit_x),
                                 qn_quantity_entry_get_value (panel->unit_y));
  settings->wall.style.thickness = qn_quantity_entry_get_value (panel->tool_thickness);
  settings->wall.style.unit_weight = qn_quantity_entry_get_value (panel->tool_weight);
  settings->wall.bond = (QnWallBond) gtk_drop_down_get_selected (panel->bond);
  settings->wall.base = gtk_check_button_get_active (GTK_CHECK_BUTTON (panel->base));
  settings->lintel = gtk_check_button_get_active (GTK_CHECK_BUTTON (panel->lintel));
  settings->force = qn_quantity_entry_get_value (panel->force);
  settings->live = gtk_drop_down_get_selected (panel->force_kind) == 0;
}

static void
on_tool_choice (GtkDropDown *choice, GParamSpec *pspec, Panel *panel)
{
  (void) pspec;
  on_tool_setting (choice, panel);
}

static GtkWidget *
add_check (GtkWidget *form, const char *label, gboolean active, GCallback toggled,
           Panel *panel)
{
  GtkWidget *check = gtk_check_button_new_with_mnemonic (label);
  gtk_check_button_set_active (GTK_CHECK_BUTTON (check), active);
  g_signal_connect (check, "toggled", toggled, panel);
  qn_form_add_wide (form, check);
  return check;
}

static void
build_tool_form (Panel *panel)
{
  const char *const bonds[] = { _ ("Running bond"), _ ("Stack bond"), _ ("Third bond"),
                                NULL };
  const char *const kinds[] = { _ ("Live (grows)"), _ ("Dead (constant)"), NULL };
  GCallback changed = G_CALLBACK (on_tool_setting);
  GtkWidget *form = panel->tool_form = qn_form_new ();
  qn_form_add_heading (form, _ ("New Elements"));
  panel->unit_x = qn_form_add_quantity (form, _ ("Block _length"), QN_QUANTITY_LENGTH,
                                        1e-4, LARGEST, changed, panel);
  panel->unit_y = qn_form_add_quantity (form, _ ("Course _height"), QN_QUANTITY_LENGTH,
                                        1e-4, LARGEST, changed, panel);
  panel->tool_thickness = qn_form_add_quantity (
    form, _ ("_Thickness"), QN_QUANTITY_LENGTH, 1e-4, LARGEST, changed, panel);
  panel->tool_weight = qn_form_add_quantity (
    form, _ ("Unit _weight"), QN_QUANTITY_UNIT_WEIGHT, 0.0, LARGEST, changed, panel);
  panel->bond =
    qn_form_add_choice (form, _ ("B_ond"), bonds, G_CALLBACK (on_tool_choice), panel);
  panel->force = qn_form_add_quantity (form, _ ("For_ce"), QN_QUANTITY_FORCE, 1e-9, 1e12,
                                       changed, panel);
  panel->force_kind = qn_form_add_choice (form, _ ("_Kind of force"), kinds,
                                          G_CALLBACK (on_tool_choice), panel);
  const QnToolSettings settings = *qn_canvas_get_tool_settings (panel->canvas);
  panel->base = add_check (form, _ ("Lay walls on a _fixed base"), settings.wall.base,
                           changed, panel);
  panel->lintel =
    add_check (form, _ ("_Span openings with a lintel"), settings.lintel, changed, panel);

  qn_quantity_entry_set_value (panel->unit_x, settings.wall.unit.x);
  qn_quantity_entry_set_value (panel->unit_y, settings.wall.unit.y);
  qn_quantity_entry_set_value (panel->tool_thickness, settings.wall.style.thickness);
  qn_quantity_entry_set_value (panel->tool_weight, settings.wall.style.unit_weight);
  qn_quantity_entry_set_value (panel->force, settings.force);
  *qn_canvas_get_tool_settings (panel->canvas) = settings;
}

/* ---- selected blocks ---- */

typedef enum {
  CHANGE_THICKNESS,
  CHANGE_WEIGHT,
  CHANGE_LAW,
  CHANGE_SUPPORT,
  CHANGE_NAME,
  CHANGE_WALL
} ChangeKind;

typedef struct Change {
  ChangeKind kind;
  QnBlockSet set;
  double value;
  QnId law, wall;
  bool support[QN_DOF_COUNT];
  const char *name;
  QnVec2 origin, unit;
} Change;

static gboolean
edit_change (QnModel *model, gpointer data, GError **error)
{
  const Change *change = data;
  switch (change->kind) {
  case CHANGE_THICKNESS:
    return qn_edit_set_thickness (model, change->set, change->value, error);
  case CHANGE_WEIGHT:
    return qn_edit_set_unit_weight (model, change->set, change->value, error);
  case CHANGE_LAW:
    return qn_edit_set_law (model, change->set, change->law, error);
  case CHANGE_SUPPORT:
    return qn_edit_set_support (model, change->set, change->support, error);
  case CHANGE_NAME:
    return qn_edit_rename_block (model, change->set.ids[0], change->name, error);
  case CHANGE_WALL:
    model->walls[change->wall].origin = change->origin;
    model->walls[change->wall].unit = change->unit;
    return qn_edit_rebuild (model, NULL, error);
  }
  return FALSE;
}

static void update (Panel *panel);

static void
apply (Panel *panel, const char *name, Change change)
{
  change.set = dup_selected (panel);
  if (change.set.count > 0
      && !qn_canvas_edit (panel->canvas, name, NULL, edit_change, &change))
    update (panel);
  g_free ((gpointer) change.set.ids);
}

static void
on_thickness (QnQuantityEntry *entry, Panel *panel)
{
  apply (
    panel, _ ("Set Thickness"),
    (Change){ .kind = CHANGE_THICKNESS, .value = qn_quantity_entry_get_value (entry) });
}

static void
on_weight (QnQuantityEntry *entry, Panel *panel)
{
  apply (panel, _ ("Set Unit Weight"),
         (Change){ .kind = CHANGE_WEIGHT, .value = qn_quantity_entry_get_value (entry) });
}

static void
on_law (GtkDropDown *choice, GParamSpec *pspec, Panel *panel)
{
  (void) pspec;
  guint selected = gtk_drop_down_get_selected (choice);
  QnId law = selected == 0 ? QN_NONE : (QnId) selected - 1;
  apply (panel, _ ("Set Law"), (Change){ .kind = CHANGE_LAW, .law = law });
}

static void
on_support (GtkCheckButton *button, Panel *panel)
{
  (void) button;
  Change change = { .kind = CHANGE_SUPPORT };
  for (int dof = 0; dof < QN_DOF_COUNT; dof++)
    change.support[dof] =
      gtk_check_button_get_active (GTK_CHECK_BUTTON (panel->support[dof]));
  apply (panel, _ ("Set Support"), change);
}

static void
on_name (GtkEntry *entry, Panel *panel)
{
  g_autofree char *name = g_strdup (gtk_editable_get_text (GTK_EDITABLE (entry)));
  apply (panel, _ ("Rename Block"), (Change){ .kind = CHANGE_NAME, .name = name });
}

static void
on_array (Panel *panel)
{
  g_autoptr (GVariant) value = g_variant_ref_sink (
    g_variant_new ("(idd)", (int) qn_quantity_entry_get_value (panel->copies),
                   qn_quantity_entry_get_value (panel->step_x),
                   qn_quantity_entry_get_value (panel->step_y)));
  gtk_widget_activate_action_variant (GTK_WIDGET (panel->canvas), "win.array", value);
}

/* Numbers that are only read when the button is pressed. */
static void
on_array_number (QnQuantityEntry *entry, Panel *panel)
{
  (void) entry;
  (void) panel;
}

static void
build_array (Panel *panel, GtkWidget *form)
{
  GCallback nothing = G_CALLBACK (on_array_number);
  panel->copies = qn_form_add_quantity (form, _ ("_Copies"), QN_QUANTITY_NUMBER, 1.0,
                                        1000.0, nothing, panel);
  panel->step_x =
    qn_form_add_quantity (form, _ ("Each to the _right by"), QN_QUANTITY_LENGTH, -LARGEST,
                          LARGEST, nothing, panel);
  panel->step_y = qn_form_add_quantity (form, _ ("Each _up by"), QN_QUANTITY_LENGTH,
                                        -LARGEST, LARGEST, nothing, panel);
  qn_quantity_entry_set_value (panel->copies, 3.0);
  qn_quantity_entry_set_value (panel->step_x, 1.0);
  GtkWidget *button = gtk_button_new_with_mnemonic (_ ("Make C_opies"));
  g_signal_connect_swapped (button, "clicked", G_CALLBACK (on_array), panel);
  qn_form_add_wide (form, button);
}

static void
build_block_form (Panel *panel)
{
  const char *const none[] = { NULL };
  GtkWidget *form = panel->block_form = qn_form_new ();
  panel->block_title = GTK_LABEL (qn_form_add_heading (form, ""));
  panel->name = gtk_entry_new ();
  gtk_editable_set_width_chars (GTK_EDITABLE (panel->name), 10);
  g_signal_connect (panel->name, "activate", G_CALLBACK (on_name), panel);
  qn_form_add_row (form, _ ("_Name"), panel->name);
  panel->thickness =
    qn_form_add_quantity (form, _ ("_Thickness"), QN_QUANTITY_LENGTH, 1e-6, LARGEST,
                          G_CALLBACK (on_thickness), panel);
  panel->weight = qn_form_add_quantity (form, _ ("Unit _weight"), QN_QUANTITY_UNIT_WEIGHT,
                                        0.0, 1e9, G_CALLBACK (on_weight), panel);
  panel->law = qn_form_add_choice (form, _ ("_Law"), none, G_CALLBACK (on_law), panel);

  static const char *const labels[QN_DOF_COUNT] = { N_ ("x"), N_ ("y"), N_ ("turn") };
  GtkWidget *box = gtk_box_new (GTK_ORIENTATION_HORIZONTAL, 6);
  for (int dof = 0; dof < QN_DOF_COUNT; dof++) {
    panel->support[dof] = gtk_check_button_new_with_label (_ (labels[dof]));
    g_signal_connect (panel->support[dof], "toggled", G_CALLBACK (on_support), panel);
    gtk_box_append (GTK_BOX (box), panel->support[dof]);
  }
  qn_form_add_row (form, _ ("Fixed"), box);
  panel->block_facts = qn_form_add_text (form);
  build_array (panel, form);
}

/* The dropdown of laws, with the general one first. */
static void
fill_laws (GtkDropDown *choice, const QnModel *model, QnId law, Panel *panel)
{
  g_autoptr (GStrvBuilder) names = g_strv_builder_new ();
  g_strv_builder_add (names, _ ("As all contacts"));
  for (gsize i = 0; i < model->law_count; i++)
    g_strv_builder_add (names, model->laws[i].name);
  g_auto (GStrv) strings = g_strv_builder_end (names);
  g_autoptr (GtkStringList) list = gtk_string_list_new ((const char *const *) strings);
  g_signal_handlers_block_matched (choice, G_SIGNAL_MATCH_DATA, 0, 0, NULL, NULL, panel);
  gtk_drop_down_set_model (choice, G_LIST_MODEL (list));
  gtk_drop_down_set_selected (choice, law == QN_NONE ? 0 : (guint) law + 1);
  g_signal_handlers_unblock_matched (choice, G_SIGNAL_MATCH_DATA, 0, 0, NULL, NULL,
                                     panel);
}

static void
set_check (GtkWidget *check, gboolean active, Panel *panel)
{
  g_signal_handlers_block_matched (check, G_SIGNAL_MATCH_DATA, 0, 0, NULL, NULL, panel);
  gtk_check_button_set_active (GTK_CHECK_BUTTON (check), active);
  g_signal_handlers_unblock_matched (check, G_SIGNAL_MATCH_DATA, 0, 0, NULL, NULL, panel);
}

static void
update_block_form (Panel *panel, QnBlockSet set)
{
  const QnModel *model = model_of (panel);
  const QnBlock *block = &model->blocks[set.ids[0]];
  QnUnits units = qn_settings_get_units ();
  g_autofree char *title =
    set.count == 1
      ? g_strdup_printf (_ ("Block %s"), block->name)
      : g_strdup_printf (ngettext ("%u Block", "%u Blocks", set.count), set.count);
  gtk_label_set_text (panel->block_title, title);
  gtk_editable_set_text (GTK_EDITABLE (panel->name), block->name);
  qn_form_set_row_visible (panel->name, set.count == 1 && block->wall == QN_NONE);
  qn_quantity_entry_set_value (panel->thickness, block->thickness);
  qn_quantity_entry_set_value (panel->weight, block->unit_weight);
  fill_laws (panel->law, model, block->law, panel);
  for (int dof = 0; dof < QN_DOF_COUNT; dof++)
    set_check (panel->support[dof], block->support[dof], panel);

  double weight = 0.0;
  for (guint i = 0; i < set.count; i++)
    weight += model->blocks[set.ids[i]].weight;
  g_autofree char *force = qn_units_format_full (units, QN_QUANTITY_FORCE, weight, 4);
  g_autofree char *x = qn_units_format (units, QN_QUANTITY_LENGTH, block->centroid.x, 5);
  g_autofree char *y =
    qn_units_format_full (units, QN_QUANTITY_LENGTH, block->centroid.y, 5);
  g_autofree char *facts =
    set.count == 1 ? g_strdup_printf (_ ("Weight %s, centroid at %s; %s"), force, x, y)
                   : g_strdup_printf (_ ("Weight %s in all"), force);
  gtk_label_set_text (panel->block_facts, facts);
}

/* ---- wall of the selected blocks ---- */

static QnId
selected_wall (const Panel *panel)
{
  guint count = 0;
  const QnId *ids =
    qn_selection_get_blocks (qn_canvas_get_selection (panel->canvas), &count);
  return count > 0 ? model_of (panel)->blocks[ids[0]].wall : QN_NONE;
}

static void
on_wall (QnQuantityEntry *entry, Panel *panel)
{
  (void) entry;
  Change change = { .kind = CHANGE_WALL, .wall = selected_wall (panel) };
  if (change.wall == QN_NONE)
    return;
  change.origin = qn_vec2 (qn_quantity_entry_get_value (panel->wall_x),
                           qn_quantity_entry_get_value (panel->wall_y));
  change.unit = qn_vec2 (qn_quantity_entry_get_value (panel->block_x),
                         qn_quantity_entry_get_value (panel->block_y));
  apply (panel, _ ("Change Wall"), change);
}

static void
build_wall_form (Panel *panel)
{
  GtkWidget *form = panel->wall_form = qn_form_new ();
  panel->wall_title = GTK_LABEL (qn_form_add_heading (form, ""));
  GCallback changed = G_CALLBACK (on_wall);
  panel->wall_x = qn_form_add_quantity (form, _ ("Left edge"), QN_QUANTITY_LENGTH,
                                        -LARGEST, LARGEST, changed, panel);
  panel->wall_y = qn_form_add_quantity (form, _ ("Lower edge"), QN_QUANTITY_LENGTH,
                                        -LARGEST, LARGEST, changed, panel);
  panel->block_x = qn_form_add_quantity (form, _ ("Block length"), QN_QUANTITY_LENGTH,
                                         1e-4, LARGEST, changed, panel);
  panel->block_y = qn_form_add_quantity (form, _ ("Course height"), QN_QUANTITY_LENGTH,
                                         1e-4, LARGEST, changed, panel);
  GtkWidget *detach = gtk_button_new_with_mnemonic (_ ("_Detach into Free Blocks"));
  gtk_actionable_set_action_name (GTK_ACTIONABLE (detach), "win.detach");
  gtk_widget_set_tooltip_text (
    detach, _ ("Free blocks can be moved, turned, fixed and renamed one by one"));
  qn_form_add_wide (form, detach);
}

static void
update_wall_form (Panel *panel, QnId id)
{
  const QnWall *wall = &model_of (panel)->walls[id];
  g_autofree char *title = g_strdup_printf (_ ("Wall %s"), wall->name);
  gtk_label_set_text (panel->wall_title, title);
  qn_quantity_entry_set_value (panel->wall_x, wall->origin.x);
  qn_quantity_entry_set_value (panel->wall_y, wall->origin.y);
  qn_quantity_entry_set_value (panel->block_x, wall->unit.x);
  qn_quantity_entry_set_value (panel->block_y, wall->unit.y);
}

/* ---- selected contact face ---- */

typedef struct FaceChange {
  QnId a, b;
  QnFaceOverride override;
} FaceChange;

static gboolean
edit_face (QnModel *model, gpointer data, GError **error)
{
  const FaceChange *change = data;
  return qn_edit_override_face (model, change->a, change->b, &change->override, error);
}

static void
change_face (Panel *panel)
{
  const QnContacts *contacts = qn_document_get_contacts (document_of (panel));
  QnId id = qn_selection_get_face (qn_canvas_get_selection (panel->canvas));
  if (id == QN_NONE || (gsize) id >= contacts->face_count)
    return;
  guint law = gtk_drop_down_get_selected (panel->face_law);
  guint placement = gtk_drop_down_get_selected (panel->placement);
  FaceChange change = { contacts->faces[id].a, contacts->faces[id].b, { 0 } };
  change.override.law = law == 0 ? QN_NONE : (QnId) law - 1;
  change.override.has_pairs = placement > 0;
  change.override.pairs.placement =
    placement == 2 ? QN_PLACEMENT_UNIFORM : QN_PLACEMENT_ENDS;
  change.override.pairs.offset = qn_quantity_entry_get_value (panel->offset);
  change.override.pairs.count = MAX (1, (int) qn_quantity_entry_get_value (panel->count));
  if (qn_canvas_edit (panel->canvas, _ ("Change Contact"), NULL, edit_face, &change))
    qn_selection_set_face (qn_canvas_get_selection (panel->canvas), id);
  else
    update (panel);
}

static void
on_face_choice (GtkDropDown *choice, GParamSpec *pspec, Panel *panel)
{
  (void) choice;
  (void) pspec;
  change_face (panel);
}

static void
on_face_quantity (QnQuantityEntry *entry, Panel *panel)
{
  (void) entry;
  change_face (panel);
}

static void
build_face_form (Panel *panel)
{
  const char *const none[] = { NULL };
  const char *const placements[] = { _ ("As all contacts"), _ ("At the ends"),
                                     _ ("Uniform"), NULL };
  GtkWidget *form = panel->face_form = qn_form_new ();
  panel->face_title = GTK_LABEL (qn_form_add_heading (form, ""));
  panel->face_facts = qn_form_add_text (form);
  panel->face_law =
    qn_form_add_choice (form, _ ("_Law"), none, G_CALLBACK (on_face_choice), panel);
  panel->placement = qn_form_add_choice (form, _ ("_Pairs"), placements,
                                         G_CALLBACK (on_face_choice), panel);
  panel->offset = qn_form_add_quantity (form, _ ("_Offset"), QN_QUANTITY_LENGTH, 0.0,
                                        LARGEST, G_CALLBACK (on_face_quantity), panel);
  panel->count = qn_form_add_quantity (form, _ ("_Number"), QN_QUANTITY_NUMBER, 1.0,
                                       1000.0, G_CALLBACK (on_face_quantity), panel);
}

static const QnFaceOverride *
find_override (const QnModel *model, const QnContactFace *face)
{
  for (gsize i = 0; i < model->override_count; i++) {
    const QnFaceOverride *o = &model->overrides[i];
    if ((o->block_a == face->a && o->block_b == face->b)
        || (o->block_a == face->b && o->block_b == face->a))
      return o;
  }
  return NULL;
}

static void
append_pair_states (GString *facts, const Panel *panel, const QnContactFace *face,
                    QnId id)
{
  const QnRun *run = qn_document_get_run (document_of (panel));
  if (run == NULL || run->result.pairs == NULL
      || qn_document_is_stale (document_of (panel), run)
      || (gsize) id >= run->contacts.face_count)
    return;
  QnUnits units = qn_settings_get_units ();
  for (int32_t i = 0; i < face->pair_count; i++) {
    const QnPairResult *pair = &run->result.pairs[face->first_pair + i];
    g_autofree char *n =
      qn_units_format_full (units, QN_QUANTITY_FORCE, pair->normal_force, 4);
    g_autofree char *t =
      qn_units_format_full (units, QN_QUANTITY_FORCE, pair->shear_force, 4);
    g_string_append_printf (facts, "\n%s %d: %s, N %s, T %s", _ ("Pair"), i + 1,
                            qn_explain_pair_state (pair->state), n, t);
  }
}

static void
update_face_form (Panel *panel, QnId id)
{
  const QnModel *model = model_of (panel);
  const QnContactFace *face = &qn_document_get_contacts (document_of (panel))->faces[id];
  QnUnits units = qn_settings_get_units ();
  g_autofree char *title = g_strdup_printf (_ ("Contact Face %d"), id);
  gtk_label_set_text (panel->face_title, title);
  g_autofree char *length =
    qn_units_format_full (units, QN_QUANTITY_LENGTH, face->length, 5);
  GString *facts = g_string_new (NULL);
  g_string_append_printf (facts, _ ("%s – %s, %s long, %d pairs"),
                          model->blocks[face->a].name, model->blocks[face->b].name,
                          length, face->pair_count);
  append_pair_states (facts, panel, face, id);
  gtk_label_set_text (panel->face_facts, facts->str);
  g_string_free (facts, TRUE);

  const QnFaceOverride *override = find_override (model, face);
  const QnPairRule rule =
    override != NULL && override->has_pairs ? override->pairs : model->contact.pairs;
  guint placement = override == NULL || !override->has_pairs ? 0
                    : rule.placement == QN_PLACEMENT_ENDS    ? 1
                                                             : 2;
  fill_laws (panel->face_law, model, override != NULL ? override->law : QN_NONE, panel);
  qn_form_set_choice (panel->placement, placement, panel);
  qn_quantity_entry_set_value (panel->offset, rule.offset);
  qn_quantity_entry_set_value (panel->count, rule.count);
  qn_form_set_row_visible (GTK_WIDGET (panel->offset), placement == 1);
  qn_form_set_row_visible (GTK_WIDGET (panel->count), placement == 2);
}

/* ---- panel ---- */

static void
update (Panel *panel)
{
  QnBlockSet set = dup_selected (panel);
  const QnContacts *contacts = qn_document_get_contacts (document_of (panel));
  QnId wall = selected_wall (panel);
  QnId face = qn_selection_get_face (qn_canvas_get_selection (panel->canvas));
  if ((gsize) face >= contacts->face_count)
    face = QN_NONE;
  gtk_widget_set_visible (panel->block_form, set.count > 0);
  gtk_widget_set_visible (panel->wall_form, wall != QN_NONE);
  gtk_widget_set_visible (panel->face_form, face != QN_NONE);
  gtk_widget_set_visible (panel->empty_label, set.count == 0 && face == QN_NONE);
  if (set.count > 0)
    update_block_form (panel, set);
  if (wall != QN_NONE)
    update_wall_form (panel, wall);
  if (face != QN_NONE)
    update_face_form (panel, face);
  g_free ((gpointer) set.ids);
}

GtkWidget *
qn_properties_panel_new (QnCanvas *canvas)
{
  Panel *panel = g_new0 (Panel, 1);
  panel->canvas = canvas;
  GtkWidget *box = gtk_box_new (GTK_ORIENTATION_VERTICAL, 0);
  build_tool_form (panel);
  build_block_form (panel);
  build_wall_form (panel);
  build_face_form (panel);
  panel->empty_label = gtk_label_new (
    _ ("Select blocks, or a contact face in the contacts view, to change them here."));
  gtk_label_set_wrap (GTK_LABEL (panel->empty_label), TRUE);
  gtk_label_set_xalign (GTK_LABEL (panel->empty_label), 0.0f);
  gtk_label_set_max_width_chars (GTK_LABEL (panel->empty_label), 36);
  gtk_widget_add_css_class (panel->empty_label, "dim-label");
  gtk_widget_set_margin_start (panel->empty_label, 12);
  gtk_widget_set_margin_end (panel->empty_label, 12);
  GtkWidget *parts[] = {
    panel->tool_form,   gtk_separator_new (GTK_ORIENTATION_HORIZONTAL),
    panel->empty_label, panel->block_form,
    panel->wall_form,   panel->face_form
  };
  for (gsize i = 0; i < G_N_ELEMENTS (parts); i++)
    gtk_box_append (GTK_BOX (box), parts[i]);

  qn_own (box, panel);
  QnDocument *document = qn_canvas_get_document (canvas);
  qn_watch (box, document, "changed", G_CALLBACK (update), panel);
  qn_watch (box, document, "runs-changed", G_CALLBACK (update), panel);
  qn_watch (box, qn_canvas_get_selection (canvas), "changed", G_CALLBACK (update), panel);
  update (panel);
  return box;
}
