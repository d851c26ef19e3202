#include "study/report/output-text.h"

#include "core/base/word.h"
#include "core/result/mechanism.h"
#include "io/text/outcome-text.h"
#include "render/scene/motion.h"

#include <glib/gi18n-lib.h>

const char *
qn_study_output_text (QnStudyOutput output)
{
  static const char *const texts[QN_STUDY_OUTPUT_COUNT] = {
    [QN_STUDY_COLLAPSE_MULTIPLIER] = N_ ("Collapse multiplier λ"),
    [QN_STUDY_ASSOCIATIVE_MULTIPLIER] = N_ ("Associative bound of λ"),
    [QN_STUDY_FIRST_LIMIT_MULTIPLIER] = N_ ("Multiplier λ at the first jump"),
    [QN_STUDY_LOWER_BOUND] = N_ ("Limit analysis of λ: static value"),
    [QN_STUDY_UPPER_BOUND] = N_ ("Limit analysis of λ: kinematic value"),
    [QN_STUDY_MECHANISM_KIND] = N_ ("Kind of mechanism"),
    [QN_STUDY_MECHANISM_SHAPE] = N_ ("Shape of mechanism"),
    [QN_STUDY_LAST_MULTIPLIER] = N_ ("Multiplier λ of the last step"),
    [QN_STUDY_LARGEST_DISPLACEMENT] = N_ ("Largest displacement (m)"),
    [QN_STUDY_STEPS] = N_ ("Number of steps"),
    [QN_STUDY_ITERATIONS] = N_ ("Number of iterations"),
    [QN_STUDY_WIDEST_CRACK] = N_ ("Widest crack (m)"),
    [QN_STUDY_CRACK_MISFIT] = N_ ("Misfit of measured cracks (m)"),
    [QN_STUDY_COLLAPSED] = N_ ("Collapsed (1: yes, 0: no)"),
    [QN_STUDY_TIME_OF_COLLAPSE] = N_ ("Time of collapse (s)"),
    [QN_STUDY_PEAK_DISPLACEMENT] = N_ ("Peak displacement (m)"),
    [QN_STUDY_FRICTION_ENERGY] = N_ ("Energy lost by friction (J)"),
    [QN_STUDY_LARGEST_SLIP] = N_ ("Largest slip, over the length of its joint"),
    [QN_STUDY_ENERGY_ERROR] = N_ ("Error of the energy balance, over the input"),
    [QN_STUDY_FREQUENCY_1] = N_ ("1st frequency (Hz)"),
    [QN_STUDY_FREQUENCY_2] = N_ ("2nd frequency (Hz)"),
    [QN_STUDY_FREQUENCY_3] = N_ ("3rd frequency (Hz)"),
    [QN_STUDY_FREQUENCY_4] = N_ ("4th frequency (Hz)"),
    [QN_STUDY_FREQUENCY_5] = N_ ("5th frequency (Hz)"),
    [QN_STUDY_FREQUENCY_6] = N_ ("6th frequency (Hz)"),
  };
  return _ (texts[output]);
}

const char *
qn_study_word (const char *name)
{
  QnOutcome outcome;
  QnMechanismKind kind;
  if (qn_find_word (name, qn_outcome_names, QN_OUTCOME_COUNT, &outcome))
    return qn_outcome_text (outcome, FALSE);
  if (qn_find_word (name, qn_mechanism_kind_names, QN_MECHANISM_KIND_COUNT, &kind))
    return qn_mechanism_kind_text (kind);
  return name;
}
