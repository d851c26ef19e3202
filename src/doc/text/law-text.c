#include "doc/text/law-text.h"

#include "io/project/typical-joint.h"

#include <glib/gi18n-lib.h>
#include <string.h>

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

/* The numbers that a list has room for, with the letters of docs/method/laws.md. */
static const struct {
  const char *key, *symbol;
} main_numbers[] = {
  { "friction", "tan φ" }, { "cohesion", "c" }, { "tension", "ft" },
  { "compression", "fc" }, { "yield", "fy" },   { "strength", "f" },
};

static const struct {
  const char *key, *word;
} number_words[] = {
  { "elasticity", N_ ("Elasticity") },
  { "poisson", N_ ("Poisson's ratio") },
  { "kn", N_ ("Normal stiffness") },
  { "ks", N_ ("Shear stiffness") },
  { "shear_factor", N_ ("Shear factor (0: 1)") },
  { "friction", N_ ("Friction, tangent") },
  { "cohesion", N_ ("Cohesion") },
  { "tension", N_ ("Tensile strength") },
  { "compression", N_ ("Compressive strength") },
  { "residual_friction", N_ ("Residual friction, tangent") },
  { "fracture_energy_tension", N_ ("Fracture energy, tension") },
  { "fracture_energy_shear", N_ ("Fracture energy, shear") },
  { "dilatancy", N_ ("Dilatancy, tangent") },
  { "dilation_end", N_ ("End of dilation, slip") },
  { "yield", N_ ("Yield") },
  { "hardening", N_ ("Hardening, part of stiffness") },
  { "strength", N_ ("Strength") },
  { "ultimate_strain", N_ ("Ultimate strain") },
  { "fracture_energy", N_ ("Fracture energy") },
  { "crushing_energy", N_ ("Crushing energy") },
};

const char *
qn_law_number_word (const char *key)
{
  for (gsize i = 0; i < G_N_ELEMENTS (number_words); i++)
    if (g_str_equal (number_words[i].key, key))
      return number_words[i].word;
  return key;
}

QnQuantity
qn_law_quantity (const char *key, QnBasis basis)
{
  static const char *const stiffnesses[] = { "kn", "ks", NULL };
  static const char *const strengths[] = { "elasticity",  "cohesion", "tension",
                                           "compression", "yield",    "strength",
                                           NULL };
  static const QnQuantity stiffness[QN_BASIS_COUNT] = { QN_QUANTITY_STIFFNESS,
                                                        QN_QUANTITY_SURFACE_STIFFNESS,
                                                        QN_QUANTITY_STRESS };
  if (g_strv_contains (stiffnesses, key))
    return stiffness[basis];
  if (g_strv_contains (strengths, key))
    return basis == QN_BASIS_CONTACT ? QN_QUANTITY_FORCE : QN_QUANTITY_STRESS;
  if (strstr (key, "_energy") != NULL)
    return basis == QN_BASIS_CONTACT ? QN_QUANTITY_ENERGY : QN_QUANTITY_SURFACE_ENERGY;
  if (g_str_equal (key, "ultimate_strain"))
    return basis == QN_BASIS_MATERIAL ? QN_QUANTITY_NUMBER : QN_QUANTITY_LENGTH;
  return g_str_equal (key, "dilation_end") ? QN_QUANTITY_LENGTH : QN_QUANTITY_NUMBER;
}

/* What has a law. A joint counts where one of its two sides has it. */
typedef struct Uses {
  gsize joints, blocks, bars;
} Uses;

static Uses
count_uses (const QnModel *model, const QnContacts *contacts, QnId law)
{
  Uses uses = { 0 };
  for (gsize i = 0; i < contacts->face_count; i++)
    uses.joints += contacts->faces[i].law_a == law || contacts->faces[i].law_b == law;
  for (gsize i = 0; i < model->block_count; i++) {
    QnId own = model->blocks[i].law;
    uses.blocks += (own != QN_NONE ? own : model->contact.law) == law;
  }
  for (gsize i = 0; i < model->bar_count; i++)
    uses.bars += model->bars[i].law == law;
  return uses;
}

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
  Uses uses = count_uses (model, contacts, id);
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
  for (gsize i = 0; i < G_N_ELEMENTS (main_numbers); i++)
    for (gsize k = 0; k < count; k++) {
      double value = qn_law_get (law, &parameters[k]);
      if (value > 0.0 && g_str_equal (parameters[k].key, main_numbers[i].key))
        append_number (text, parameters[k].key, main_numbers[i].symbol, value, law->basis,
                       units);
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
