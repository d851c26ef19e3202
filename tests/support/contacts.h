/* Preparing a test model and detecting its contacts in one go; any error aborts. */
#pragma once

#include "support/auto-clear.h"

/* Prepares the model, detects, and checks what holds for every result: order, unit vectors, ends
 * along the tangent, pairs on their faces with tributary lengths that add up. */
void test_detect (QnModel *model, QnContacts *contacts);

/* The same, and there must be nothing wrong with the model nor worth a finding. */
void test_detect_sound (QnModel *model, QnContacts *contacts);

/* Number of findings of one kind. */
size_t test_count_findings (const QnContacts *contacts, QnProblem problem);

/* The only finding of one kind; aborts if there is none or more than one. */
const QnFinding *test_the_finding (const QnContacts *contacts, QnProblem problem);

/* Fails unless all faces and pairs are the same to the last bit. */
void test_assert_same_faces (const QnContacts *found, const QnContacts *expected);
