/* Vehicles: axles and stretches of uniform load that stand on a structure or on the fill above it, and how
 * fill spreads them. */
#pragma once

#include "core/base/base.h"
#include "core/base/vec2.h"

#define QN_MAX_AXLES 40
#define QN_MAX_LINES 4

typedef struct QnAxle {
  double at;   /* m behind the front of the vehicle */
  double load; /* N, >= 0 */
} QnAxle;

typedef struct QnLineLoad {
  double from, to;  /* m behind the front, negative ones before it; from < to */
  double intensity; /* N/m, >= 0 */
} QnLineLoad;

typedef struct QnVehicle {
  char *name;   /* owned, unique among vehicles */
  char *source; /* owned, may be NULL */
  QnAxle axles[QN_MAX_AXLES];
  QnLineLoad lines[QN_MAX_LINES];
  int32_t axle_count, line_count;
  double patch[2]; /* m: of a wheel along and across, > 0 */
  double track; /* m: from middle to middle of the wheels, or length of a sleeper; >= 0 */
  bool built_in; /* of the program's list, not of the project */
  int32_t note;
} QnVehicle;

/* How wide a load is at a depth z below the surface: `along` and `across` the structure, m. Widths across
 * may be replaced by an effective width, and none exceeds that of the structure. */
typedef enum {
  QN_DISPERSAL_HALF,   /* 1 : 2 to all sides: patch + z; track + patch + z */
  QN_DISPERSAL_CS_454, /* 0.3 m + z; track + 1.5 m + z */
  QN_DISPERSAL_NR_025, /* 0.25 m + z; track + 2 z */
  QN_DISPERSAL_EN_1991, /* 30 degrees to all sides: patch + 2 z tan 30; track + patch + 2 z tan 30 */
  QN_DISPERSAL_BOUSSINESQ, /* along: of the half-space under a line load (Flamant); across as 1 : 2 */
  QN_DISPERSAL_COUNT
} QnDispersal;

/* Lengths along and across at the surface, m, and their growth per metre of depth. */
typedef struct QnSpread {
  double along, along_slope, across, across_slope;
} QnSpread;

QnSpread qn_dispersal_spread (QnDispersal dispersal, const QnVehicle *vehicle);

/* From the front to the rear axle or end of a stretch of load, m; stretches longer than
 * QN_ENDLESS do not count. */
double qn_vehicle_length (const QnVehicle *vehicle);
#define QN_ENDLESS 500.0
