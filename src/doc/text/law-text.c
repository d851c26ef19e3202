#include "doc/text/law-text.h"

#include "core/law/spring.h"
#include "io/project/typical-joint.h"

#include <glib/gi18n-lib.h>
#include <math.h>
#include <stdlib.h>

const char *const qn_law_kind_words[QN_LAW_KIND_COUNT] = {
  [QN_LAW_ELASTIC] = N_ ("Elastic"),
  [QN_LAW_NO_TENSION] = N_ ("No tension"),
  [QN_LAW_COULOMB] = N_ ("Coulomb"),
  [QN_LAW_MOHR_COULOMB] = N_ ("Coulomb, crushing"),
  [QN_LAW_BILINEAR] = N_ ("Bilinear, hardening"),
  [QN_LAW_ELASTIC_PLASTIC] = N_ ("Elastic and plastic"),
  [QN_LAW_CONCRETE] = N_ ("Concrete"),
  [QN_LAW_STEEL] = N_ ("Steel"),
  [QN_LAW_CURVE] = N_ ("By points"),
};

const char *const qn_basis_words[QN_BASIS_COUNT] = {
  [QN_BASIS_CONTACT] = N_ ("Contact pair"),
  [QN_BASIS_SURFACE] = N_ ("Surface"),
  [QN_BASIS_MATERIAL] = N_ ("Material"),
};

typedef enum { PLAIN, STRENGTH, STIFFNESS, ENERGY, STRAIN, SLIP } Measure;

static const QnQuantity quantities[][QN_BASIS_COUNT] = {
  [PLAIN] = { QN_QUANTITY_NUMBER, QN_QUANTITY_NUMBER, QN_QUANTITY_NUMBER },
  [STRENGTH] = { QN_QUANTITY_FORCE, QN_QUANTITY_STRESS, QN_QUANTITY_STRESS },
  [STIFFNESS] = { QN_QUANTITY_STIFFNESS, QN_QUANTITY_SURFACE_STIFFNESS,
                  QN_QUANTITY_STRESS },
  [ENERGY] = { QN_QUANTITY_ENERGY, QN_QUANTITY_SURFACE_ENERGY,
               QN_QUANTITY_SURFACE_ENERGY },
  [STRAIN] = { QN_QUANTITY_LENGTH, QN_QUANTITY_LENGTH, QN_QUANTITY_NUMBER },
  [SLIP] = { QN_QUANTITY_LENGTH, QN_QUANTITY_LENGTH, QN_QUANTITY_LENGTH },
};

/* With the letters of docs/method/laws.md, those that a list has room for. */
static const struct {
  const char *key, *word, *symbol;
  Measure measure;
} numbers[] = {
  { "elasticity", N_ ("Elasticity"), NULL, STRENGTH },
  { "poisson", N_ ("Poisson's ratio"), NULL, PLAIN },
  { "kn", N_ ("Normal stiffness"), NULL, STIFFNESS },
  { "ks", N_ ("Shear stiffness"), NULL, STIFFNESS },
  { "shear_factor", N_ ("Shear factor (0: 1)"), NULL, PLAIN },
  { "friction", N_ ("Friction, tangent"), "tan φ", PLAIN },
  { "cohesion", N_ ("Cohesion"), "c", STRENGTH },
  { "tension", N_ ("Tensile strength"), "ft", STRENGTH },
  { "compression", N_ ("Compressive strength"), "fc", STRENGTH },
  { "residual_friction", N_ ("Residual friction, tangent"), NULL, PLAIN },
  { "fracture_energy_tension", N_ ("Fracture energy, tension"), NULL, ENERGY },
  { "fracture_energy_shear", N_ ("Fracture energy, shear"), NULL, ENERGY },
  { "dilatancy", N_ ("Dilatancy, tangent"), NULL, PLAIN },
  { "dilation_end", N_ ("End of dilation, slip"), NULL, SLIP },
  { "yield", N_ ("Yield"), "fy", STRENGTH },
  { "hardening", N_ ("Hardening, part of stiffness"), NULL, PLAIN },
  { "strength", N_ ("Strength"), "f", STRENGTH },
  { "ultimate_strain", N_ ("Ultimate strain"), NULL, STRAIN },
  { "fracture_energy", N_ ("Fracture energy"), NULL, ENERGY },
  { "crushing_energy", N_ ("Crushing energy"), NULL, ENERGY },
};

/* Behind the last of a key that is none of them. */
static gsize
find_number (const char *key)
{
  gsize i = 0;
  while (i < G_N_ELEMENTS (numbers) && !g_str_equal (numbers[i].key, key))
    i++;
  return i;
}

const char *
qn_law_number_word (const char *key)
{
  const gsize i = find_number (key);
  return i < G_N_ELEMENTS (numbers) ? numbers[i].word : key;
}

QnQuantity
qn_law_quantity (const char *key, QnBasis basis)
{
  const gsize i = find_number (key);
  return i < G_N_ELEMENTS (numbers) ? quantities[numbers[i].measure][basis]
                                    : QN_QUANTITY_NUMBER;
}

/* What has a law. A joint counts where one of its two sides has it. */
typedef struct Uses {
  gsize joints, blocks, bars;
} Uses;

static void
append_number (GString *text, const char *key, const char *symbol, double value,
               QnBasis basis, QnUnits units)
{
  g_autofree char *number =
    qn_units_format_full (units, qn_law_quantity (key, basis), value, 6);
  const char *gap = g_str_has_suffix (text->str, "\n") ? "" : " · ";
  g_string_append_printf (text, "%s%s %s", gap, symbol, number);
}

char *
qn_law_dup_text (const QnModel *model, const QnContacts *contacts, QnId id, QnUnits units)
{
  const QnLaw *law = &model->laws[id];
  gboolean holds;
  const char *source = qn_law_get_source (law, &holds);
  GString *text = g_string_new (law->name);
  g_string_append_printf (text, "\n%s, %s · ", _ (qn_law_kind_words[law->kind]),
                          _ (qn_basis_words[law->basis]));
  Uses uses = { 0 };
  for (gsize i = 0; i < contacts->face_count; i++)
    uses.joints += contacts->faces[i].law_a == id || contacts->faces[i].law_b == id;
  for (gsize i = 0; i < model->block_count; i++) {
    QnId own = model->blocks[i].law;
    uses.blocks += (own != QN_NONE ? own : model->contact.law) == id;
  }
  for (gsize i = 0; i < model->bar_count; i++)
    uses.bars += model->bars[i].law == id;
  g_string_append_printf (text, ngettext ("%u joint", "%u joints", (gulong) uses.joints),
                          (guint) uses.joints);
  g_string_append (text, " · ");
  g_string_append_printf (text, ngettext ("%u block", "%u blocks", (gulong) uses.blocks),
                          (guint) uses.blocks);
  if (uses.bars > 0) {
    g_string_append (text, " · ");
    g_string_append_printf (text, ngettext ("%u bar", "%u bars", (gulong) uses.bars),
                            (guint) uses.bars);
  }
  if (model->contact.law == id)
    g_string_append_printf (text, " · %s", _ ("the law of all others"));
  g_string_append_c (text, '\n');
  gsize count;
  const QnLawParameter *parameters = qn_law_parameters (law->kind, &count);
  for (gsize i = 0; i < G_N_ELEMENTS (numbers); i++)
    for (gsize k = 0; k < count; k++) {
      double value = qn_law_get (law, &parameters[k]);
      if (numbers[i].symbol != NULL && value > 0.0
          && g_str_equal (parameters[k].key, numbers[i].key))
        append_number (text, numbers[i].key, numbers[i].symbol, value, law->basis, units);
    }
  if (law->elasticity > 0.0)
    append_number (text, "elasticity",
                   law->arrangement == QN_ARRANGEMENT_GRID ? _ ("E (grid)")
                                                           : _ ("E (chain)"),
                   law->elasticity, law->basis, units);
  if (law->elasticity > 0.0)
    append_number (text, "poisson", "ν", law->poisson, law->basis, units);
  append_number (text, "kn", "kn", law->kn, law->basis, units);
  append_number (text, "ks", "ks", law->ks, law->basis, units);
  if (source != NULL)
    g_string_append_printf (text, "\n%s%s", source,
                            holds ? "" : _ (" (numbers changed since)"));
  return g_string_free (text, FALSE);
}

/* Points between two turning points of the history. */
#define POINTS_PER_BRANCH 400

/* Compression of a joint during shear, N or Pa. */
#define PRESSING_FORCE  1e4
#define PRESSING_STRESS 1e6

gboolean
qn_law_trace (const QnLawPreset *what, double length, GArray *samples)
{
  QnSpring spring = qn_spring_from_law (&what->law, 1, length);
  QnSpringMemory memory = { 0 };
  double from = 0, step = length / POINTS_PER_BRANCH;
  if (isinf (qn_spring_softening (&spring)))
    return FALSE;
  for (gsize turn = 0; turn < what->turn_count; turn++) {
    for (int i = turn == 0 ? 0 : 1; i <= POINTS_PER_BRANCH; i++) {
      double at = from * length + i * step * (what->turns[turn] - from);
      double pressed = what->pressed * length;
      double q[2] = { what->shear ? pressed : at, what->shear ? at : 0 };
      QnSpringResponse r;
      qn_spring_evaluate (&spring, &memory, q, &r);
      memory = r.memory;
      QnLawSample sample = { { q[0] / length, q[1] / length },
                             { r.force[0], r.force[1] },
                             { r.tangent[0][0] * length, r.tangent[1][1] * length } };
      g_array_append_val (samples, sample);
    }
    from = what->turns[turn];
  }
  return TRUE;
}

QnPlot *
qn_law_plot (const QnLawPreset *what, const GArray *samples)
{
  const gboolean strain = what->law.basis == QN_BASIS_MATERIAL;
  const gboolean stress = what->law.basis != QN_BASIS_CONTACT;
  const int axis = what->shear ? 1 : 0;
  const char *name = what->shear ? _ ("Slip") : strain ? _ ("Strain") : _ ("Elongation");
  QnPlot *plot = qn_plot_new (NULL, what->shear ? stress ? _ ("Shear stress (MPa)")
                                                         : _ ("Shear force (kN)")
                                    : stress ? _ ("Stress (MPa)")
                                                : _ ("Force (kN)"));
  double *x = qn_plot_keep (plot, g_new (double, samples->len));
  double *y = qn_plot_keep (plot, g_new (double, samples->len));
  for (guint i = 0; i < samples->len; i++) {
    const QnLawSample *s = &g_array_index (samples, QnLawSample, i);
    x[i] = s->elongation[axis] * 1e3;
    y[i] = s->force[axis] * (stress ? 1e-6 : 1e-3);
  }
  plot->x.label =
    qn_plot_keep (plot, g_strdup_printf ("%s (%s)", name, strain ? "‰" : "mm"));
  plot->y.room = QN_CURVE_ROOM;
  qn_plot_mark (plot, QN_MARKS_LINE, NULL, 0, x, y, samples->len);
  return plot;
}

/* The elongation at which what is particular about a law happens. */
static double
characteristic (const QnLaw *law, double pressed)
{
  switch (law->kind) {
  case QN_LAW_COULOMB:
    return (law->cohesion - law->friction * law->kn * pressed) / law->ks;
  case QN_LAW_MOHR_COULOMB:
    return law->compression / law->kn;
  case QN_LAW_BILINEAR:
  case QN_LAW_ELASTIC_PLASTIC:
    return law->yield / law->kn;
  case QN_LAW_CONCRETE:
    return law->ultimate_strain > 0.0 ? law->ultimate_strain
                                      : 3.5 * law->strength / law->kn;
  case QN_LAW_STEEL:
    return law->ultimate_strain;
  case QN_LAW_CURVE: {
    double most = 0.0;
    for (int32_t i = 0; i < law->point_count; i++)
      most = fmax (most, fabs (law->points[i].x));
    return most;
  }
  case QN_LAW_ELASTIC:
  case QN_LAW_NO_TENSION:
  case QN_LAW_KIND_COUNT:
    break;
  }
  return 1.0;
}

QnLawPreset
qn_law_preset_for (const QnLaw *law)
{
  QnLawPreset what = *qn_law_preset (law->kind);
  double typical = characteristic (&what.law, what.pressed);
  if (what.shear)
    what.pressed =
      -(law->basis == QN_BASIS_CONTACT ? PRESSING_FORCE : PRESSING_STRESS) / law->kn;
  double scale = characteristic (law, what.pressed) / typical;
  /* A joint without friction slips at once: any slip shows that. */
  if (!(scale > 0.0) || !isfinite (scale))
    scale = 1.0;
  for (gsize i = 0; i < what.turn_count; i++)
    what.turns[i] *= scale;
  what.law = *law;
  return what;
}

#define TURNS(...)                                                                       \
  .turns = { __VA_ARGS__ },                                                              \
  .turn_count = sizeof ((const double[]){ __VA_ARGS__ }) / sizeof (double)

/* A masonry joint in N/m per pair, as the six walls have it; concrete of 30 N/mm2 with the peak
 * at 2 per mille; steel B500 of class B; a joint of mortar that tears, by points. */
static const QnLawPreset presets[QN_LAW_KIND_COUNT] = {
  [QN_LAW_ELASTIC] = { .law = { .kind = QN_LAW_ELASTIC,
                                .basis = QN_BASIS_MATERIAL,
                                .kn = 30e9,
                                .ks = 12.5e9 },
                       TURNS (5e-4, -5e-4, 0) },
  [QN_LAW_NO_TENSION] = { .law = { .kind = QN_LAW_NO_TENSION, .kn = 1e7, .ks = 1e7 },
                          TURNS (-1e-3, 1e-3, -1.5e-3, 5e-4) },
  [QN_LAW_COULOMB] = { .law = { .kind = QN_LAW_COULOMB,
                                .kn = 1e7,
                                .ks = 1e7,
                                .friction = 0.65 },
                       .shear = TRUE,
                       .pressed = -1e-3,
                       TURNS (2e-3, -2e-3, 3e-3, 1e-3) },
  [QN_LAW_MOHR_COULOMB] = { .law = { .kind = QN_LAW_MOHR_COULOMB,
                                     .basis = QN_BASIS_SURFACE,
                                     .kn = 1e10,
                                     .ks = 5e9,
                                     .friction = 0.65,
                                     .compression = 5e6 },
                            TURNS (-1e-3, 2e-4, -1.5e-3, -1e-3) },
  [QN_LAW_BILINEAR] = { .law = { .kind = QN_LAW_BILINEAR,
                                 .basis = QN_BASIS_MATERIAL,
                                 .kn = 30e9,
                                 .ks = 12.5e9,
                                 .yield = 20e6,
                                 .hardening = 0.1 },
                        TURNS (2e-3, -2e-3, 3e-3, -3e-3, 0) },
  [QN_LAW_ELASTIC_PLASTIC] = { .law = { .kind = QN_LAW_ELASTIC_PLASTIC,
                                        .basis = QN_BASIS_MATERIAL,
                                        .kn = 30e9,
                                        .ks = 12.5e9,
                                        .yield = 20e6 },
                               TURNS (2e-3, -2e-3, 3e-3, -3e-3, 0) },
  [QN_LAW_CONCRETE] = { .law = { .kind = QN_LAW_CONCRETE,
                                 .basis = QN_BASIS_MATERIAL,
                                 .kn = 30e9,
                                 .ks = 12.5e9,
                                 .strength = 30e6,
                                 .ultimate_strain = 3.5e-3,
                                 .crushing_energy = 15e3,
                                 .tension = 2.9e6,
                                 .fracture_energy = 100 },
                        TURNS (2e-4, -1e-3, 4e-4, -2.2e-3, -1e-3, -8e-3) },
  [QN_LAW_STEEL] = { .law = { .kind = QN_LAW_STEEL,
                              .basis = QN_BASIS_MATERIAL,
                              .kn = 200e9,
                              .ks = 77e9,
                              .yield = 500e6,
                              .strength = 540e6,
                              .ultimate_strain = 0.05,
                              .fracture_energy = 1e6 },
                     TURNS (0.01, -0.01, 0.03, 0.02, 0.1) },
  [QN_LAW_CURVE] = { .law = { .kind = QN_LAW_CURVE,
                              .basis = QN_BASIS_SURFACE,
                              .kn = 1e11,
                              .ks = 4e10,
                              .point_count = 5,
                              .points = { { -4e-4, -8e6 },
                                          { -1e-4, -6e6 },
                                          { -4e-5, -4e6 },
                                          { 2e-6, 2e5 },
                                          { 5e-5, 0 } } },
                     TURNS (2e-5, -8e-5, 1e-5, -3e-4, -2e-4) },
};

const QnLawPreset *
qn_law_preset (QnLawKind kind)
{
  return &presets[kind];
}

void
qn_law_change_kind (QnLaw *law, QnLawKind kind)
{
  gboolean rubs = kind == QN_LAW_COULOMB || kind == QN_LAW_MOHR_COULOMB;
  law->kind = kind;
  if (qn_law_check (law, 0, NULL) == QN_OK && !(rubs && law->friction == 0.0))
    return;
  const QnLaw *typical = &presets[kind].law;
  char *name = law->name;
  if (kind == QN_LAW_MOHR_COULOMB && law->compression <= 0.0)
    law->compression = typical->compression;
  if (rubs && qn_law_check (law, 0, NULL) == QN_OK && law->friction > 0.0)
    return;
  if (rubs) {
    law->friction = typical->friction;
    law->dilatancy = 0.0;
    if (qn_law_check (law, 0, NULL) == QN_OK)
      return;
  }
  int32_t note = law->note;
  free (law->source);
  *law = *typical;
  law->note = note;
  law->name = name;
}
