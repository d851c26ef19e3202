/* Contacts that follow the blocks, in large displacements.
 *
 * A joint of the drawing is valid while its blocks stay in place. Once it has slid by
 * QN_FOLLOW_SLIP of the smaller block, or its blocks have turned against each other by
 * QN_FOLLOW_TURN, it is released: its pairs carry nothing from then on. All other contacts are
 * corners on sides. A corner of one block and a side of another make a pair. Its normal is that of
 * the side, its force acts at the corner, and it carries nothing where the corner is beyond an end
 * of the side. Two sides that lie on each other carry at two corners, one at each end of their
 * overlap.
 *
 * A search through the box tree of the displaced blocks lists corners near sides. It must be
 * repeated once something has moved by a quarter of its margin. A listed pair is inactive or
 * active:
 *
 *   it becomes active    where its corner comes from outside, between the ends of the side; or lies
 *                        within, less deep than behind any other side of the block, as where a joint
 *                        was left or another corner has slid off
 *   it becomes inactive  again where its corner is beyond an end of the side by
 *                        qn_contact_follow_band()
 *
 * Where two corners meet, the second pair is inactive until the first corner has slid off.
 *
 * A corner may become active within a block although no other contact there was released. It then
 * carries nothing at that depth, its inset: its elongation is measured from the inset until the
 * corner has left the block. So no contact has energy without work.
 */
#pragma once

#include "core/base/memory.h"
#include "core/contact/contact-pair.h"
#include "core/contact/contact-side.h"
#include "core/contact/contacts.h"

/* Slip that releases a joint, and distance beyond the end of a side at which a corner becomes
 * inactive: part of the square root of the area of the smaller block, and at least so many times
 * the deepest overlap of joints under the dead load. So a corner that is pressed in differs from
 * one that comes from the side. */
#define QN_FOLLOW_SLIP    0.005
#define QN_FOLLOW_OVERLAP 4.0

/* Rotation of one block against the other that releases a joint, rad. */
#define QN_FOLLOW_TURN 0.35

/* Least margin of a search, part of the square root of the area of the smallest block. */
#define QN_FOLLOW_MARGIN 0.05

/* Where the corner of a contact lies. */
typedef struct QnCornerPlace {
  double along;  /* m from the first vertex of the side */
  double length; /* of the side, m */
  double apart;  /* m off the side; negative within the block */
} QnCornerPlace;

typedef struct QnContactFollow {
  QnPool pool; /* of numbers of blocks and faces */
  const QnModel *model;
  const QnContacts *drawn;
  QnSides sides;
  double *sizes, *reach; /* by block, m: root of the area; farthest corner's distance */
  double smallest;       /* of the sizes */
  bool *left;            /* faces as drawn */
  double overlap;        /* of joints under the dead load, m */
  QnFoundContact *found; /* last search; both directions of two blocks adjacent */
  bool *active;
  QnId *origins; /* by listed contact: its place in the list before, or QN_NONE */
  size_t count, capacity;
  double margin;     /* of the last search, m; 0: none yet */
  double *at_search; /* block_count x 3: displacements then */
} QnContactFollow;

/* `follow` is overwritten without being cleared. Model and contacts must outlive it. */
QnStatus qn_contact_follow_init (QnContactFollow *follow, const QnModel *model,
                                 const QnContacts *drawn, QnDiag *diag);

void qn_contact_follow_clear (QnContactFollow *follow);

/* Sets the overlap of joints from the elongations of the pairs as drawn under the dead load, m
 * (pair_count x 2). */
void qn_contact_follow_set_overlap (QnContactFollow *follow, const double *elongations);

/* The slip and overhang that count between two blocks, m. */
double qn_contact_follow_band (const QnContactFollow *follow, QnId a, QnId b);

/* Releases the joints that have slid (responses of the pairs as drawn) or turned; true if any was released.
 * displacements: block_count x 3. Joints crossed by bars are never released. */
bool qn_contact_follow_leave (QnContactFollow *follow, const double *displacements,
                              const QnPairResponse *responses);

/* Whether a block has moved by so much since the last search that another one is due. */
bool qn_contact_follow_is_due (const QnContactFollow *follow, const double *displacements,
                               double margin);

/* Lists the contacts within the margin anew. Contacts that remain keep foot and activity. *changed: the list
 * differs. */
QnStatus qn_contact_follow_search (QnContactFollow *follow, const double *displacements,
                                   double margin, bool *changed, QnDiag *diag);

/* Makes pairs inactive, or active with inset 0; sets the inset of corners outside the block to 0. True if
 * any pair changed. */
bool qn_contact_follow_activate (QnContactFollow *follow, const double *displacements);

/* Index of this contact in the list, regardless of foot and inset; `count`: not listed. */
size_t qn_contact_follow_find (const QnContactFollow *follow,
                               const QnFoundContact *contact);

/* One past the last listed contact between the two blocks of contact `first` (they are adjacent). */
size_t qn_contact_follow_end (const QnContactFollow *follow, size_t first);

QnCornerPlace qn_contact_follow_place (const QnContactFollow *follow,
                                       const QnFoundContact *contact,
                                       const double *displacements);

/* The contacts as drawn, followed by one face with one pair for each found contact. The pair's tributary
 * length is half of the shorter of two sides: the contact's side and the longer side at the corner.
 * `contacts` is overwritten without being cleared. */
QnStatus qn_contacts_with_found (const QnModel *model, const QnContacts *drawn,
                                 const QnSides *sides, const QnFoundContact *found,
                                 size_t count, QnContacts *contacts, QnDiag *diag);

/* Sets the inset of a found pair, m; true if it changed. */
bool qn_contacts_set_inset (QnContacts *contacts, size_t pair, double inset);

/* The faces as drawn between two blocks, in either order: [first, end). */
void qn_contacts_between (const QnContacts *drawn, QnId a, QnId b, size_t *first,
                          size_t *end);
