/* Crack widths of a result as a table. */
#pragma once

#include "core/contact/contacts.h"
#include "core/result/result.h"
#include "io/project/project.h"

/* Every joint that has opened at the last equilibrium, the widest first: its blocks, its largest width and
 * where that is, the mean over its length, and the number of its line of joints. Only the header where there is no equilibrium. */
gboolean qn_cracks_csv_write (const char *path, const QnProject *project,
                              const QnContacts *contacts, const QnResult *result,
                              GError **error);
