/* Driving one spring by hand: steps that are committed, and tangents held against finite
 * differences. */
#pragma once

#include "core/law/spring.h"

/* A spring that remembers what it was taken through. */
typedef struct Probe {
  QnSpring spring;
  QnSpringMemory memory;
} Probe;

/* A spring of unit area and unit length made of the law; fails where the law is refused. */
Probe probe_of_law (const QnLaw *law);

/* The response at the elongation (normal, tangential), without and with committing it. */
QnSpringResponse probe_look (const Probe *probe, double normal, double tangential);
QnSpringResponse probe_go (Probe *probe, double normal, double tangential);

/* Fails unless the force is this one, to 1e-12 of its larger component or of `1`. */
void probe_assert_force (const QnSpringResponse *response, double normal,
                         double tangential);

/* Fails unless the tangent at this elongation is that of central differences, to 1e-6 of the
 * spring's stiffness, and symmetric where the law is associated. The elongation must not be at a
 * corner of the law. */
void probe_assert_tangent (const Probe *probe, double normal, double tangential);

/* Commits the normal elongations one after the other, without shear, and compares the normal
 * forces; `count` rows of { elongation, force }. Every tangent is checked on the way to the
 * next row. */
void probe_assert_history (Probe *probe, const double (*rows)[2], size_t count);
