/* Structures whose motion under pulses is published or follows from an equation: the rocking block, the
 * multi-drum column and the arch of Lemos. For test-earthquakes and bench-earthquakes. */
#pragma once

#include "core/result/result.h"

#include <glib.h>

#define TEST_G 9.81

/* Block of 0.2 x 1 m on a rigid plane under a half-sine pulse (m/s2, s). `model` is overwritten
 * without being cleared. */
void test_earthquake_init_block (QnModel *model, double amplitude, double pulse);

/* The same under a full sine, with damping by impact. */
void test_earthquake_init_block_sine (QnModel *model, double amplitude, double pulse);

/* Least amplitude that overturns the same block by the exact equation of a rigid one with Housner's
 * impact, m/s2, and after how many impacts. The pulse has so many halves of a sine. */
double test_earthquake_exact_boundary (int halves, double pulse, int *impacts);

/* p of that block, 1/s: sqrt (3 g / (4 R)). */
double test_earthquake_block_frequency (void);

/* The multi-drum column under a step impulse (g, s). */
void test_earthquake_init_column (QnModel *model, double amplitude, double duration);

/* Least amplitude of the step impulse that overturns it, g: the least and the greatest of UDEC,
 * LMGC90 (Dimitri, De Lorenzis & Zavarise 2011) and the authors of HybriDFEM. */
typedef struct TestColumn {
  double duration, least, greatest;
} TestColumn;

#define TEST_COLUMNS 13
extern const TestColumn test_columns[TEST_COLUMNS];

/* The arch of Lemos under a half-sine pulse. 3DEC with 5 % of stiffness-proportional damping: */
#define TEST_ARCH_FIRST       16.1e-3 /* m */
#define TEST_ARCH_FIRST_TIME  0.535   /* s */
#define TEST_ARCH_SECOND      -5.6e-3
#define TEST_ARCH_SECOND_TIME 1.218

void test_earthquake_init_arch (QnModel *model);

/* First and second peak of the middle of the extrados of its crown, m, positive where the body force of
 * the pulse drives it, and when, s. */
void test_earthquake_arch_peaks (const QnModel *model, const QnHistory *history,
                                 double peaks[2], double times[2]);

/* Solves a model in time, with contacts that follow the blocks or that do not. The result is cleared by
 * the caller. */
void test_earthquake_solve (QnModel *model, gboolean follow, QnResult *result);

/* Whether it overturns; the model is cleared. *energy_error, if larger, is that of the result. */
gboolean test_earthquake_overturns (QnModel *model, gboolean follow,
                                    double *energy_error);
