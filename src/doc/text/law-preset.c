#include "doc/text/law-preset.h"

#include <stdlib.h>

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
