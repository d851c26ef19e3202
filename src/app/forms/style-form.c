/* What the current tool draws with; only what concerns it is shown. */
#include "app/forms/form.h"
#include "app/forms/panel.h"
#include "app/tools/tools.h"
#include "core/base/integer.h"
#include <glib/gi18n.h>

#define LARGEST 1e6 /* m, N/m3: limits of fields */

/* Which rows concern which tool. */
enum {
  SHOW_MASONRY = 1 << 0, /* block and course, bond, base */
  SHOW_BLOCK = 1 << 1,   /* thickness and weight */
  SHOW_OPENING = 1 << 2,
  SHOW_ARCH = 1 << 3,
  SHOW_COLUMN = 1 << 4,
  SHOW_FORCE = 1 << 5,
  SHOW_JOINT = 1 << 6,
  SHOW_MIRROR = 1 << 7,
  SHOW_BEAM = 1 << 8
};

static const struct {
  const QnTool *tool;
  guint rows;
} concerns[] = {
  { &qn_tool_wall, SHOW_MASONRY | SHOW_BLOCK },
  { &qn_tool_opening, SHOW_OPENING },
  { &qn_tool_arch, SHOW_ARCH | SHOW_BLOCK },
  { &qn_tool_column, SHOW_COLUMN | SHOW_BLOCK },
  { &qn_tool_rectangle, SHOW_BLOCK },
  { &qn_tool_polygon, SHOW_BLOCK },
  { &qn_tool_beam, SHOW_BEAM },
  { &qn_tool_force, SHOW_FORCE },
  { &qn_tool_joint, SHOW_JOINT },
  { &qn_tool_mirror, SHOW_MIRROR },
};

/* Bonds in the list: kind and lap. */
static const struct {
  QnBond bond;
  double lap;
} bonds[] = { { QN_BOND_RUNNING, 0.5 }, { QN_BOND_RUNNING, 1.0 / 3.0 },
              { QN_BOND_STACK, 0.0 },   { QN_BOND_HEADER, 0.5 },
              { QN_BOND_ENGLISH, 0.5 }, { QN_BOND_FLEMISH, 0.5 } };

/* Openings in the list: head and span. */
static const struct {
  QnHead head;
  QnSpan span;
} heads[] = { { QN_HEAD_FLAT, QN_SPAN_LINTEL },
              { QN_HEAD_FLAT, QN_SPAN_FLAT_ARCH },
              { QN_HEAD_SEGMENTAL, QN_SPAN_VOUSSOIRS },
              { QN_HEAD_SEMICIRCULAR, QN_SPAN_VOUSSOIRS },
              { QN_HEAD_FLAT, QN_SPAN_NONE } };

typedef struct Form {
  QnCanvas *canvas;
  const QnTool *shown;
  GtkWidget *box;
  GtkLabel *title;
  QnQuantityEntry *unit_x, *unit_y, *thickness, *weight, *ring, *voussoirs, *taper,
    *force;
  QnQuantityEntry *elements;
  GtkDropDown *bond, *head, *shape, *force_kind, *joint_law, *section;
  GtkWidget *base, *mirror_copy, *hinges[2];
} Form;

static void
on_setting (gpointer widget, Form *form)
{
  (void) widget;
  QnToolSettings *settings = qn_canvas_get_tool_settings (form->canvas);
  QnMasonryStyle *style = &settings->masonry;
  guint bond = gtk_drop_down_get_selected (form->bond);
  guint head = gtk_drop_down_get_selected (form->head);
  style->unit = qn_vec2 (qn_quantity_entry_get_value (form->unit_x),
                         qn_quantity_entry_get_value (form->unit_y));
  style->thickness = qn_quantity_entry_get_value (form->thickness);
  style->unit_weight = qn_quantity_entry_get_value (form->weight);
  style->bond = bonds[MIN (bond, G_N_ELEMENTS (bonds) - 1)].bond;
  style->lap = bonds[MIN (bond, G_N_ELEMENTS (bonds) - 1)].lap;
  style->base = gtk_check_button_get_active (GTK_CHECK_BUTTON (form->base));
  style->head = heads[MIN (head, G_N_ELEMENTS (heads) - 1)].head;
  style->span = heads[MIN (head, G_N_ELEMENTS (heads) - 1)].span;
  style->shape = (QnArchShape) gtk_drop_down_get_selected (form->shape);
  style->ring = qn_quantity_entry_get_value (form->ring);
  style->voussoirs = (int32_t) qn_to_integer (
    qn_quantity_entry_get_value (form->voussoirs), 0, G_MAXINT32);
  style->top_to_foot = qn_quantity_entry_get_value (form->taper);
  settings->force = qn_quantity_entry_get_value (form->force);
  settings->live = gtk_drop_down_get_selected (form->force_kind) == 0;
  settings->elements =
    (int) qn_to_integer (qn_quantity_entry_get_value (form->elements), 0, G_MAXINT32);
  for (int end = 0; end < 2; end++)
    settings->hinges[end] =
      gtk_check_button_get_active (GTK_CHECK_BUTTON (form->hinges[end]));
  settings->mirror_copy =
    gtk_check_button_get_active (GTK_CHECK_BUTTON (form->mirror_copy));
}

static void
on_choice (GtkDropDown *choice, GParamSpec *pspec, Form *form)
{
  (void) pspec;
  on_setting (choice, form);
}

static void
on_joint_law (GtkDropDown *choice, GParamSpec *pspec, Form *form)
{
  (void) pspec;
  QnToolSettings *settings = qn_canvas_get_tool_settings (form->canvas);
  QnId law = qn_form_get_law (choice);
  g_free (settings->joint_law);
  settings->joint_law =
    law != QN_NONE ? g_strdup (qn_canvas_get_model (form->canvas)->laws[law].name) : NULL;
}

static void
on_section (GtkDropDown *choice, GParamSpec *pspec, Form *form)
{
  (void) pspec;
  QnToolSettings *settings = qn_canvas_get_tool_settings (form->canvas);
  guint row = gtk_drop_down_get_selected (choice);
  g_free (settings->section);
  settings->section =
    row < qn_canvas_get_model (form->canvas)->section_count
      ? g_strdup (qn_canvas_get_model (form->canvas)->sections[row].name)
      : NULL;
}

/* Without a section there is one to come with the first beam. */
static void
update_sections (Form *form)
{
  const QnModel *model = qn_canvas_get_model (form->canvas);
  const char *name = qn_canvas_get_tool_settings (form->canvas)->section;
  QnId section = name != NULL ? qn_model_find_section (model, name) : QN_NONE;
  g_autoptr (GStrvBuilder) names = g_strv_builder_new ();
  for (gsize i = 0; i < model->section_count; i++)
    g_strv_builder_add (names, model->sections[i].name);
  if (model->section_count == 0)
    g_strv_builder_add (names, _ ("New section"));
  g_auto (GStrv) strings = g_strv_builder_end (names);
  qn_form_fill_choice (form->section, (const char *const *) strings,
                       section != QN_NONE ? (guint) section : 0, form);
}

static void
update_laws (Form *form)
{
  update_sections (form);
  const char *name = qn_canvas_get_tool_settings (form->canvas)->joint_law;
  QnId law =
    name != NULL ? qn_model_find_law (qn_canvas_get_model (form->canvas), name) : QN_NONE;
  qn_form_fill_laws (form->joint_law, qn_canvas_get_model (form->canvas),
                     _ ("None of their own"), law, form);
}

static void
show (gpointer field, guint rows, guint which)
{
  qn_form_set_row_visible (GTK_WIDGET (field), (rows & which) != 0);
}

static void
update_tool (Form *form)
{
  const QnTool *tool = qn_canvas_get_tool (form->canvas);
  if (tool == form->shown)
    return;
  form->shown = tool;
  guint rows = 0;
  for (gsize i = 0; i < G_N_ELEMENTS (concerns); i++) {
    if (concerns[i].tool == tool)
      rows = concerns[i].rows;
  }
  gtk_widget_set_visible (form->box, rows != 0);
  gtk_label_set_text (form->title, _ (tool->label));
  show (form->unit_x, rows, SHOW_MASONRY);
  show (form->unit_y, rows, SHOW_MASONRY | SHOW_COLUMN);
  show (form->bond, rows, SHOW_MASONRY);
  show (form->thickness, rows, SHOW_BLOCK);
  show (form->weight, rows, SHOW_BLOCK);
  show (form->base, rows, SHOW_MASONRY | SHOW_ARCH | SHOW_COLUMN);
  show (form->head, rows, SHOW_OPENING);
  show (form->shape, rows, SHOW_ARCH);
  show (form->ring, rows, SHOW_ARCH);
  show (form->voussoirs, rows, SHOW_ARCH);
  show (form->taper, rows, SHOW_COLUMN);
  show (form->force, rows, SHOW_FORCE);
  show (form->force_kind, rows, SHOW_FORCE);
  show (form->joint_law, rows, SHOW_JOINT);
  show (form->section, rows, SHOW_BEAM);
  show (form->elements, rows, SHOW_BEAM);
  show (form->hinges[0], rows, SHOW_BEAM);
  show (form->hinges[1], rows, SHOW_BEAM);
  show (form->mirror_copy, rows, SHOW_MIRROR);
}

static void
build_masonry_rows (Form *form, GtkWidget *grid)
{
  const char *const bond_names[] = { _ ("Running bond"),
                                     _ ("Third bond"),
                                     _ ("Stack bond"),
                                     _ ("Header bond"),
                                     _ ("English bond"),
                                     _ ("Flemish bond"),
                                     NULL };
  const char *const head_names[] = { _ ("Lintel"),         _ ("Flat arch"),
                                     _ ("Segmental arch"), _ ("Round arch"),
                                     _ ("Nothing"),        NULL };
  const char *const shapes[] = { _ ("Circular"), _ ("Pointed"), _ ("Elliptic"), NULL };
  GCallback changed = G_CALLBACK (on_setting), chosen = G_CALLBACK (on_choice);
  form->unit_x = qn_form_add_quantity (grid, _ ("Block _length"), QN_QUANTITY_LENGTH,
                                       1e-4, LARGEST, changed, form);
  form->unit_y = qn_form_add_quantity (grid, _ ("Course _height"), QN_QUANTITY_LENGTH,
                                       1e-4, LARGEST, changed, form);
  form->bond = qn_form_add_choice (grid, _ ("B_ond"), bond_names, chosen, form);
  form->head = qn_form_add_choice (grid, _ ("_Spanned by"), head_names, chosen, form);
  form->shape = qn_form_add_choice (grid, _ ("S_hape"), shapes, chosen, form);
  form->ring = qn_form_add_quantity (grid, _ ("_Ring thickness"), QN_QUANTITY_LENGTH,
                                     1e-4, LARGEST, changed, form);
  form->voussoirs = qn_form_add_quantity (grid, _ ("_Voussoirs"), QN_QUANTITY_NUMBER, 2.0,
                                          1000.0, changed, form);
  form->taper = qn_form_add_quantity (grid, _ ("Top to foo_t"), QN_QUANTITY_NUMBER, 0.01,
                                      100.0, changed, form);
  form->thickness = qn_form_add_quantity (grid, _ ("_Thickness"), QN_QUANTITY_LENGTH,
                                          1e-4, LARGEST, changed, form);
  form->weight = qn_form_add_quantity (grid, _ ("Unit _weight"), QN_QUANTITY_UNIT_WEIGHT,
                                       0.0, LARGEST, changed, form);
}

static void
build_other_rows (Form *form, GtkWidget *grid, const QnToolSettings *settings)
{
  const char *const kinds[] = { _ ("Live (grows)"), _ ("Dead (constant)"), NULL };
  const char *const none[] = { NULL };
  GCallback changed = G_CALLBACK (on_setting), chosen = G_CALLBACK (on_choice);
  form->force = qn_form_add_quantity (grid, _ ("For_ce"), QN_QUANTITY_FORCE, 1e-9, 1e12,
                                      changed, form);
  form->force_kind = qn_form_add_choice (grid, _ ("_Kind of force"), kinds, chosen, form);
  form->joint_law =
    qn_form_add_choice (grid, _ ("_Law"), none, G_CALLBACK (on_joint_law), form);
  form->section =
    qn_form_add_choice (grid, _ ("_Section"), none, G_CALLBACK (on_section), form);
  form->elements = qn_form_add_quantity (grid, _ ("_Elements"), QN_QUANTITY_NUMBER, 1.0,
                                         QN_MAX_BEAM_ELEMENTS, changed, form);
  form->hinges[0] =
    qn_form_add_check (grid, _ ("Hinge at the _first end"), FALSE, changed, form);
  form->hinges[1] =
    qn_form_add_check (grid, _ ("Hinge at the se_cond end"), FALSE, changed, form);
  form->base = qn_form_add_check (grid, _ ("Lay on a _fixed base"),
                                  settings->masonry.base, changed, form);
  form->mirror_copy = qn_form_add_check (grid, _ ("_Keep the original"),
                                         settings->mirror_copy, changed, form);
}

static guint
row_of_bond (const QnMasonryStyle *style)
{
  for (guint i = 0; i < G_N_ELEMENTS (bonds); i++) {
    if (bonds[i].bond == style->bond
        && (style->bond != QN_BOND_RUNNING || bonds[i].lap == style->lap))
      return i;
  }
  return 0;
}

GtkWidget *
qn_style_form_new (QnCanvas *canvas)
{
  Form *form = g_new0 (Form, 1);
  const QnToolSettings settings = *qn_canvas_get_tool_settings (canvas);
  form->canvas = canvas;
  GtkWidget *grid = form->box = qn_form_new ();
  form->title = GTK_LABEL (qn_form_add_heading (grid, ""));
  build_masonry_rows (form, grid);
  build_other_rows (form, grid, &settings);
  const QnMasonryStyle *style = &settings.masonry;
  qn_quantity_entry_set_value (form->unit_x, style->unit.x);
  qn_quantity_entry_set_value (form->unit_y, style->unit.y);
  qn_quantity_entry_set_value (form->thickness, style->thickness);
  qn_quantity_entry_set_value (form->weight, style->unit_weight);
  qn_quantity_entry_set_value (form->ring, style->ring);
  qn_quantity_entry_set_value (form->voussoirs, style->voussoirs);
  qn_quantity_entry_set_value (form->taper, style->top_to_foot);
  qn_quantity_entry_set_value (form->elements, settings.elements);
  qn_quantity_entry_set_value (form->force, settings.force);
  qn_form_set_choice (form->bond, row_of_bond (style), form);
  qn_own (grid, form);
  qn_watch (grid, qn_canvas_get_document (canvas), "changed", G_CALLBACK (update_laws),
            form);
  qn_watch (grid, canvas, "status", G_CALLBACK (update_tool), form);
  update_laws (form);
  update_tool (form);
  return grid;
}
