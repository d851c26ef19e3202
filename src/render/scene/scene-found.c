/* Contacts that blocks found on their way (core/contact/contact-follow.h): a dot where the corner lies on
 * the side of another block, and in the view of forces an arrow as of joints. Those that carry nothing
 * at the step are not drawn. */
#include "render/scene/scene-builder.h"

#include <glib/gi18n-lib.h>

#define SIZE 4.6F

/* Forces below this share of the largest are not drawn. */
#define LEAST_FORCE_SHARE 1e-3

static const QnFoundForce *
forces_of (const QnSceneBuilder *b, size_t *count)
{
  *count = 0;
  return b->result != NULL ? qn_step_found (b->result, b->step, count) : NULL;
}

static const QnFoundContact *
contact_of (const QnSceneBuilder *b, const QnFoundForce *force)
{
  return &b->result->found[force->found].contact;
}

static QnVec2
place_of (const QnSceneBuilder *b, const QnFoundForce *force)
{
  const QnFoundContact *contact = contact_of (b, force);
  return qn_builder_place (b, contact->other, qn_found_corner (b->model, contact));
}

void
qn_build_found (QnSceneBuilder *b)
{
  size_t count;
  const QnFoundForce *forces = forces_of (b, &count);
  QnColor color = qn_builder_ink (b, QN_INK_FACE);
  for (size_t i = 0; i < count; i++) {
    QnCommand *command = qn_scene_marker (b->scene, QN_LAYER_SYMBOLS, QN_MARKER_DOT,
                                          place_of (b, &forces[i]), SIZE, 0, color);
    qn_command_set_pick (command, QN_PICK_FOUND, forces[i].found);
  }
  if (count == 0)
    return;
  qn_scene_legend_marker (b->scene, QN_MARKER_DOT, SIZE, color, "%s",
                          _ ("contact found during the motion"));
}

double
qn_largest_found_force (const QnSceneBuilder *b)
{
  size_t count;
  const QnFoundForce *forces = forces_of (b, &count);
  double largest = 0;
  for (size_t i = 0; i < count; i++)
    largest = fmax (largest, hypot (forces[i].normal, forces[i].shear));
  return largest;
}

void
qn_build_found_forces (QnSceneBuilder *b, double per_newton, double largest)
{
  size_t count;
  const QnFoundForce *forces = forces_of (b, &count);
  for (size_t i = 0; i < count; i++)
    if (hypot (forces[i].normal, forces[i].shear) >= LEAST_FORCE_SHARE * largest)
      qn_build_resultant (b,
                          qn_found_force (b->model, contact_of (b, &forces[i]),
                                          &forces[i], b->motion.displacements),
                          place_of (b, &forces[i]), per_newton, largest, QN_PICK_FOUND,
                          forces[i].found);
}
