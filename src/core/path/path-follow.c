/* Contacts that follow the blocks along a path of equilibria, in large displacements.
 *
 * Once an equilibrium is accepted, joints that have slid or turned too far are left and corners near sides
 * are listed anew (core/dynamics/moving-contacts.h); the next step starts from there. Going over changes
 * forces by what the pairs that cease to carry held and those that begin to carry do not: the next
 * equilibrium takes that up, and counts as one that relaxation found. Without time a step is known by its
 * number, which stands for the time in the result's lists of contacts.
 */
#include "core/path/path.h"

QnStatus
qn_path_follow_contacts (QnPath *path, bool *changed, QnDiag *diag)
{
  QnEquilibrium *eq = &path->equilibrium;

  qn_equilibrium_restore (eq);
  QnStatus status = qn_moving_contacts_update (
    &path->moving, eq, QN_PATH_LIST_CONTACTS * eq->assembly.length,
    (double) path->result->step_count, path->result, changed, diag);
  if (status != QN_OK || !*changed)
    return status;
  qn_inertia_free (path->inertia);
  path->inertia = NULL;
  qn_equilibrium_renew (eq);
  return QN_OK;
}

QnStatus
qn_path_begin_to_follow (QnPath *path, bool asked, QnDiag *diag)
{
  const QnAssembly *as = &path->equilibrium.assembly;

  if (!asked || !as->nonlinear)
    return QN_OK;
  path->follows = true;
  return qn_moving_contacts_init (&path->moving, as, diag);
}
