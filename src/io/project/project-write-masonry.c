#include "io/project/project-masonry.h"
#include "io/project/project-write-parts.h"
#include "io/text/json-text.h"

static void
put_leaf (GString *json, const QnLeaf *leaf)
{
  if (leaf->bond != QN_BOND_CUSTOM)
    qn_json_put_number (json, "length", leaf->length);
  qn_json_put_vec2 (json, "unit", leaf->unit);
  qn_json_put_string (json, "bond", qn_bond_names[leaf->bond]);
  if (leaf->closer != QN_CLOSER_NONE)
    qn_json_put_string (json, "closers", qn_closer_names[leaf->closer]);
  qn_json_put_unusual (json, "header", leaf->header, 0);
  qn_json_put_unusual (json, "lap", leaf->lap, 0.5);
}

static void
append_opening (GString *json, const QnOpening *opening)
{
  g_string_append_c (json, '{');
  if (opening->name != NULL)
    qn_json_put_string (json, "name", opening->name);
  qn_json_put_vec2 (json, "at", opening->at);
  qn_json_put_number (json, "width", opening->width);
  qn_json_put_number (json, "height", opening->height);
  qn_json_put_string (json, "head", qn_head_names[opening->head]);
  if (opening->head == QN_HEAD_SEGMENTAL)
    qn_json_put_number (json, "rise", opening->rise);
  qn_json_put_string (json, "span", qn_span_names[opening->span]);
  if (opening->span != QN_SPAN_NONE)
    qn_json_put_number (json, "depth", opening->depth);
  if (opening->span == QN_SPAN_LINTEL)
    qn_json_put_unusual (json, "bearing", opening->bearing, 0);
  if (opening->span == QN_SPAN_FLAT_ARCH || opening->span == QN_SPAN_VOUSSOIRS)
    qn_json_put_number (json, "voussoirs", opening->voussoirs);
  if (opening->span == QN_SPAN_FLAT_ARCH)
    qn_json_put_unusual (json, "skew", opening->skew, 0);
  if (opening->span == QN_SPAN_VOUSSOIRS)
    qn_json_put_string (json, "sides", qn_sides_names[opening->sides]);
  if (opening->sill_height > 0)
    qn_json_put_vec2 (json, "sill",
                      qn_vec2 (opening->sill_height, opening->sill_bearing));
  g_string_append (json, " }");
}

static void
put_wall (GString *json, const QnMasonryWall *wall)
{
  gboolean listed = wall->leaves[0].bond == QN_BOND_CUSTOM;
  if (!listed)
    qn_json_put_number (json, "height", wall->height);
  if (wall->leaf_count == 1) {
    put_leaf (json, &wall->leaves[0]);
  } else {
    qn_json_begin_member (json, "leaves");
    for (gsize i = 0; i < wall->leaf_count; i++) {
      g_string_append (json, i > 0 ? ", {" : "[{");
      put_leaf (json, &wall->leaves[i]);
      g_string_append (json, " }");
    }
    g_string_append_c (json, ']');
  }
  if (wall->course_height_count > 0)
    qn_json_put_numbers (json, "course_heights", wall->course_heights,
                         wall->course_height_count);
  if (listed) {
    qn_json_begin_member (json, "courses");
    g_string_append_c (json, '[');
    int32_t entry = 0;
    for (int32_t course = 0; course < wall->courses.course_count; course++) {
      g_string_append (json, course > 0 ? ", " : "");
      qn_json_append_numbers (json, wall->courses.lengths + entry,
                              (gsize) (wall->courses.course_ends[course] - entry));
      entry = wall->courses.course_ends[course];
    }
    g_string_append_c (json, ']');
  }
  if (wall->left != QN_EDGE_STRAIGHT || wall->right != QN_EDGE_STRAIGHT) {
    qn_json_begin_member (json, "edges");
    g_string_append_printf (json, "[\"%s\", \"%s\"]", qn_edge_names[wall->left],
                            qn_edge_names[wall->right]);
  }
  qn_json_put_number (json, "minimum_piece", wall->minimum_piece);
  if (wall->opening_count == 0)
    return;
  qn_json_begin_member (json, "openings");
  for (gsize i = 0; i < wall->opening_count; i++) {
    g_string_append (json, i > 0 ? ", " : "[");
    append_opening (json, &wall->openings[i]);
  }
  g_string_append_c (json, ']');
}

static void
put_arch (GString *json, const QnArch *arch, gboolean with_span)
{
  qn_json_put_string (json, "shape", qn_arch_shape_names[arch->shape]);
  if (with_span)
    qn_json_put_number (json, "span", arch->span);
  qn_json_put_number (json, "rise", arch->rise);
  qn_json_put_number (json, "ring", arch->ring);
  qn_json_put_number (json, "voussoirs", arch->voussoirs);
  qn_json_put_string (json, "sides", qn_sides_names[arch->sides]);
  if (with_span)
    qn_json_put_unusual (json, "springer", arch->springer, 0);
}

static void
put_column (GString *json, const QnColumn *column)
{
  qn_json_put_number (json, "height", column->height);
  qn_json_put_vec2 (json, "width", qn_vec2 (column->bottom, column->top));
  qn_json_put_number (json, "drums", column->drums);
  if (column->plinth_height > 0)
    qn_json_put_vec2 (json, "plinth",
                      qn_vec2 (column->plinth_width, column->plinth_height));
  if (column->capital_height > 0)
    qn_json_put_vec2 (json, "capital",
                      qn_vec2 (column->capital_width, column->capital_height));
}

static void
put_portal (GString *json, const QnPortal *portal)
{
  qn_json_put_number (json, "bays", portal->bays);
  qn_json_put_number (json, "span", portal->span);
  qn_json_put_vec2 (json, "pier", qn_vec2 (portal->pier_width, portal->pier_height));
  qn_json_put_number (json, "courses", portal->courses);
  if (portal->lintel_height > 0) {
    qn_json_put_number (json, "lintel", portal->lintel_height);
    return;
  }
  qn_json_begin_member (json, "arch");
  g_string_append_c (json, '{');
  put_arch (json, &portal->arch, FALSE);
  g_string_append (json, " }");
}

static void
put_kind (GString *json, const QnMasonry *masonry)
{
  switch (masonry->kind) {
  case QN_MASONRY_WALL:
    put_wall (json, &masonry->wall);
    break;
  case QN_MASONRY_ARCH:
    put_arch (json, &masonry->arch, TRUE);
    break;
  case QN_MASONRY_COLUMN:
    put_column (json, &masonry->column);
    break;
  case QN_MASONRY_BUTTRESS:
    qn_json_put_number (json, "height", masonry->buttress.height);
    qn_json_put_vec2 (json, "width",
                      qn_vec2 (masonry->buttress.bottom, masonry->buttress.top));
    qn_json_put_number (json, "courses", masonry->buttress.courses);
    qn_json_put_string (json, "side", masonry->buttress.leans_right ? "right" : "left");
    break;
  case QN_MASONRY_PORTAL:
    put_portal (json, &masonry->portal);
    break;
  case QN_MASONRY_RUBBLE:
    qn_json_put_vec2 (json, "width",
                      qn_vec2 (masonry->rubble.width, masonry->rubble.top));
    qn_json_put_number (json, "height", masonry->rubble.height);
    qn_json_put_number (json, "stone", masonry->rubble.stone);
    qn_json_put_number (json, "irregularity", masonry->rubble.irregularity);
    qn_json_put_number (json, "seed", masonry->rubble.seed);
    break;
  case QN_MASONRY_KIND_COUNT:
    break;
  }
}

void
qn_masonry_append_json (GString *json, const QnMasonry *masonry, const QnModel *model)
{
  g_string_append_c (json, '{');
  qn_json_put_string (json, "kind", qn_masonry_kind_names[masonry->kind]);
  qn_json_put_string (json, "name", masonry->name);
  qn_json_put_vec2 (json, "origin", masonry->origin);
  qn_json_put_unusual (json, "rotation", masonry->rotation, 0);
  qn_json_put_number (json, "thickness", masonry->thickness);
  qn_json_put_weight (json, masonry->unit_weight, masonry->density);
  qn_json_put_law (json, model, masonry->law);
  qn_json_put_unusual (json, "foundation", masonry->foundation, 0);
  if (masonry->perturbation > 0) {
    qn_json_put_number (json, "perturbation", masonry->perturbation);
    qn_json_put_number (json, "perturbation_seed", masonry->perturbation_seed);
  }
  put_kind (json, masonry);
  g_string_append (json, " }");
}
