#include "bench/limit-program.h"

#include <interfaces/highs_c_api.h>
#include <math.h>

double
highs_solve (const LimitProgram *program, int method, double seconds)
{
  void *highs = Highs_create ();
  double found = NAN;
  Highs_setBoolOptionValue (highs, "output_flag", 0);
  Highs_setStringOptionValue (highs, "solver", method == 0 ? "ipm" : "simplex");
  Highs_setStringOptionValue (highs, "run_crossover", "off");
  Highs_setStringOptionValue (highs, "parallel", "off");
  Highs_setIntOptionValue (highs, "threads", 1);
  Highs_setDoubleOptionValue (highs, "primal_feasibility_tolerance", 1e-9);
  Highs_setDoubleOptionValue (highs, "dual_feasibility_tolerance", 1e-9);
  Highs_setDoubleOptionValue (highs, "time_limit", seconds);
  Highs_passLp (highs, program->column_count, program->row_count,
                program->starts[program->column_count], kHighsMatrixFormatColwise,
                kHighsObjSenseMaximize, 0, program->cost, program->lower, program->upper,
                program->right, program->right, program->starts, program->rows,
                program->values);
  if (Highs_run (highs) == kHighsStatusOk
      && Highs_getModelStatus (highs) == kHighsModelStatusOptimal)
    found = Highs_getObjectiveValue (highs);
  Highs_destroy (highs);
  return found;
}
