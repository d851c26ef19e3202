/* The threads of this process that analyses of large structures may use. */
#pragma once

#include "core/base/workers.h"

/* As many threads as there are processors, the caller's among them: started when they are first needed,
 * shared by all callers and kept until the process ends. Where none can be started, the caller's thread
 * does everything. May be called from any thread. */
const QnWorkers *qn_threads_get (void);
