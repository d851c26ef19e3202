#include "bench/limit-program.h"

#include <coin/Clp_C_Interface.h>
#include <math.h>

double
clp_solve (const LimitProgram *program, int method, double seconds)
{
  Clp_Simplex *model = Clp_newModel ();
  Clp_setLogLevel (model, 0);
  Clp_loadProblem (model, program->column_count, program->row_count, program->starts,
                   program->rows, program->values, program->lower, program->upper,
                   program->cost, program->right, program->right);
  Clp_setObjSense (model, -1);
  /* The default 1e-7 stops short of the optimum where forces are large. */
  Clp_setDualTolerance (model, 1e-9);
  Clp_setPrimalTolerance (model, 1e-9);
  Clp_setMaximumSeconds (model, seconds);
  if (method == 0)
    Clp_initialBarrierNoCrossSolve (model);
  else if (method == 1)
    Clp_initialDualSolve (model);
  else
    Clp_initialPrimalSolve (model);
  double found = Clp_status (model) == 0 ? Clp_objectiveValue (model) : NAN;
  Clp_deleteModel (model);
  return found;
}
