/* Models, contacts and results made by hand for the tests of pictures, independent of the
 * geometry and the solver. */
#pragma once

#include "core/contact/contacts.h"
#include "core/model/model.h"
#include "core/result/result.h"

typedef struct Fixture {
  QnModel model;
  QnContacts contacts;
  QnResult result;
} Fixture;

/* A running-bond wall of `courses` courses of `columns` blocks of 0.4 x 0.175 m on a fixed
 * base, with all its faces, two pairs a face. The result has four steps in which the wall
 * shears over like a rocking and sliding pier, and that motion as mechanism. */
void fixture_init_wall (Fixture *fixture, int columns, int courses);

/* One block of the given size on a fixed base that overturns about its lower right corner. */
void fixture_init_block (Fixture *fixture, double width, double height);

void fixture_clear (Fixture *fixture);
