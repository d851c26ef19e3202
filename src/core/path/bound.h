/* The largest multiplier that limit analysis leaves to a path. */
#pragma once

#include "core/base/progress.h"
#include "core/contact/contacts.h"
#include "core/result/result.h"

/* Adds the associative bound to the result of a path: the largest multiplier at which forces within the
 * strength of every joint are in balance, with whatever geometry, is that of rigid blocks that do not
 * move; so it bounds linear geometry alone. Nothing is added where analysis.bound asks for none, where
 * there is one already, or where limit analysis does not know the joints or does not get to its end.
 * *cancelled (nullable) says whether `report` refused to go on. NO_MEMORY is the only error. */
QnStatus qn_path_add_bound (const QnModel *model, const QnContacts *contacts,
                            QnProgressFunc report, void *report_data, QnResult *result,
                            bool *cancelled, QnDiag *diag);

/* Where the associative bound is known and joints have a bond, which it takes as ductile: adds the same of
 * joints whose bonds are broken, unless analysis.bound asks for none. */
QnStatus qn_path_add_broken_bound (const QnModel *model, const QnContacts *contacts,
                                   QnProgressFunc report, void *report_data,
                                   QnResult *result, QnDiag *diag);
