/* What the current tool draws with; only what concerns it is shown. */
#include "app/forms/form.h"
#include "app/forms/panel.h"
#include "app/tools/tools.h"
#include <glib/gi18n.h>

#define FIELDS(FIELD, MEMBER)                                                            \
  FIELD (TITLE, "title", NULL)                                                           \
  FIELD (KIND, "kind", NULL)                                                             \
  MEMBER (UNIT_X, "unit_x", NULL, QnToolSettings, masonry.unit.x)                        \
  MEMBER (UNIT_Y, "unit_y", NULL, QnToolSettings, masonry.unit.y)                        \
  FIELD (BOND, "bond", NULL)                                                             \
  FIELD (HEAD, "head", NULL)                                                             \
  MEMBER (SHAPE, "shape", NULL, QnToolSettings, masonry.shape)                           \
  MEMBER (RING, "ring", NULL, QnToolSettings, masonry.ring)                              \
  MEMBER (VOUSSOIRS, "voussoirs", NULL, QnToolSettings, masonry.voussoirs)               \
  MEMBER (TAPER, "taper", NULL, QnToolSettings, masonry.top_to_foot)                     \
  MEMBER (THICKNESS, "thickness", NULL, QnToolSettings, masonry.thickness)               \
  MEMBER (WEIGHT, "weight", NULL, QnToolSettings, masonry.unit_weight)                   \
  MEMBER (FORCE, "force", NULL, QnToolSettings, force)                                   \
  MEMBER (INTENSITY, "intensity", NULL, QnToolSettings, intensity)                       \
  FIELD (FORCE_KIND, "force_kind", NULL)                                                 \
  FIELD (JOINT_LAW, "joint_law", NULL)                                                   \
  FIELD (SECTION, "section", NULL)                                                       \
  MEMBER (ELEMENTS, "elements", NULL, QnToolSettings, elements)                          \
  MEMBER (FIRST_HINGE, "first_hinge", NULL, QnToolSettings, hinges[0])                   \
  MEMBER (SECOND_HINGE, "second_hinge", NULL, QnToolSettings, hinges[1])                 \
  MEMBER (BASE, "base", NULL, QnToolSettings, masonry.base)                              \
  MEMBER (MIRROR_COPY, "mirror_copy", NULL, QnToolSettings, mirror_copy)
QN_FORM_FIELDS;

/* Which fields concern which tool, a bit for each. */
#define BIT(field) (1u << (field))
#define OF_BLOCK   (BIT (THICKNESS) | BIT (WEIGHT))

static const struct {
  const QnTool *tool;
  guint fields;
} concerns[] = {
  { &qn_tool_wall, OF_BLOCK | BIT (UNIT_X) | BIT (UNIT_Y) | BIT (BOND) | BIT (BASE) },
  { &qn_tool_opening, BIT (HEAD) },
  { &qn_tool_arch, OF_BLOCK | BIT (SHAPE) | BIT (RING) | BIT (VOUSSOIRS) | BIT (BASE) },
  { &qn_tool_column,
    OF_BLOCK | BIT (KIND) | BIT (UNIT_X) | BIT (UNIT_Y) | BIT (TAPER) | BIT (BASE) },
  { &qn_tool_rectangle, OF_BLOCK },
  { &qn_tool_polygon, OF_BLOCK },
  { &qn_tool_beam,
    BIT (SECTION) | BIT (ELEMENTS) | BIT (FIRST_HINGE) | BIT (SECOND_HINGE) },
  { &qn_tool_force, BIT (FORCE) | BIT (FORCE_KIND) },
  { &qn_tool_edge_load, BIT (INTENSITY) | BIT (FORCE_KIND) },
  { &qn_tool_joint, BIT (JOINT_LAW) },
  { &qn_tool_mirror, BIT (MIRROR_COPY) },
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

/* Stones of rubble and cells of Voronoi have a length, drums and courses a height, cells of a grid
 * both; piers of a portal and cells are upright. */
static guint
not_of_kind (int kind)
{
  return kind == QN_MASONRY_RUBBLE    ? BIT (UNIT_Y)
         : kind == QN_MASONRY_PORTAL  ? BIT (UNIT_X) | BIT (TAPER)
         : kind == QN_MASONRY_GRID    ? BIT (TAPER)
         : kind == QN_MASONRY_VORONOI ? BIT (UNIT_Y) | BIT (TAPER)
                                      : BIT (UNIT_X);
}

static guint
fields_of (const QnTool *tool)
{
  for (gsize i = 0; i < G_N_ELEMENTS (concerns); i++)
    if (concerns[i].tool == tool)
      return concerns[i].fields;
  return 0;
}

static gboolean
look (QnForm *form, const QnModel *model)
{
  return fields_of (form->canvas->tool) != 0;
}

static gpointer
subject (QnForm *form, QnModel *model, guint field)
{
  return form->canvas->settings;
}

static gboolean
show (QnForm *form, const QnModel *model, guint field, QnValue *value)
{
  const QnTool *tool = form->canvas->tool;
  QnToolSettings *settings = form->canvas->settings;
  const QnMasonryStyle *style = &settings->masonry;
  switch (field) {
  case TITLE:
    value->text = g_strdup (_ (tool->label));
    return TRUE;
  case BOND:
    for (guint i = 0; i < G_N_ELEMENTS (bonds); i++)
      if (bonds[i].bond == style->bond
          && (style->bond != QN_BOND_RUNNING || bonds[i].lap == style->lap))
        value->number = i;
    break;
  case HEAD:
    for (guint i = G_N_ELEMENTS (heads); i-- > 0;)
      if (heads[i].head == style->head && heads[i].span == style->span)
        value->number = i;
    break;
  case KIND:
    value->number = style->kind - QN_MASONRY_COLUMN;
    break;
  case FORCE_KIND:
    value->number = settings->live ? 0 : 1;
    break;
  case JOINT_LAW:
    qn_value_set_laws (value, model, _ ("None of their own"),
                       settings->joint_law != NULL
                         ? qn_model_find_law (model, settings->joint_law)
                         : QN_NONE);
    break;
  case SECTION: /* without a section there is one to come with the first beam */
    qn_value_set_sections (value, model,
                           settings->section != NULL
                             ? qn_model_find_section (model, settings->section)
                             : QN_NONE);
    if (model->section_count == 0)
      qn_value_add_row (value, _ ("New section"));
    break;
  }
  return (fields_of (tool) & BIT (field)) != 0
         && (tool != &qn_tool_column || (not_of_kind (style->kind) & BIT (field)) == 0);
}

static void
take_name (char **kept, const char *name)
{
  g_free (*kept);
  *kept = g_strdup (name);
}

static gboolean
take (QnForm *form, QnModel *model, guint field, const QnValue *value, GError **error)
{
  QnToolSettings *settings = form->canvas->settings;
  QnMasonryStyle *style = &settings->masonry;
  guint row = (guint) MAX (value->number, 0.0);
  switch (field) {
  case BOND:
    style->bond = bonds[row].bond;
    style->lap = bonds[row].lap;
    break;
  case HEAD:
    style->head = heads[row].head;
    style->span = heads[row].span;
    break;
  case KIND:
    style->kind = QN_MASONRY_COLUMN + (int) row;
    break;
  case FORCE_KIND:
    settings->live = row == 0;
    break;
  case JOINT_LAW:
    take_name (&settings->joint_law, row > 0 ? model->laws[row - 1].name : NULL);
    break;
  case SECTION:
    take_name (&settings->section,
               row < model->section_count ? model->sections[row].name : NULL);
    break;
  }
  return TRUE;
}

const QnFormKind qn_style_form = QN_FORM_KIND (
  "style-form", QnForm, .look = look, .subject = subject, .follows = QN_FOLLOW_TOOL);
