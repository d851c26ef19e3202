/* Every reason for which the core refuses an input or warns about it, with its English sentence.
 *
 * One list makes both the enumeration and the texts, so the two cannot fall out of step. The
 * texts are message identifiers: layers above the core translate them. They start in lower
 * case and name no entity, because the layer that prints them puts "file:line:column: path: "
 * in front.
 */
#pragma once

/* clang-format off */
#define QN_PROBLEMS(X) \
  X (NONE, "no problem") \
  X (NO_MEMORY, "not enough memory") \
  X (NOT_FINITE, "number is not finite") \
  X (NOT_POSITIVE, "number must be positive") \
  X (NEGATIVE, "number must not be negative") \
  X (TOO_LARGE, "number is too large") \
  X (TOO_SMALL, "number is too small") \
  X (TOLERANCE_FINE, "tolerance is below what double precision resolves") \
  X (TOLERANCE_COARSE, "tolerance is too coarse to distinguish equilibrium from collapse") \
  X (TOO_FEW_VERTICES, "polygon has fewer than three vertices") \
  X (DUPLICATE_VERTEX, "polygon repeats a vertex") \
  X (ZERO_AREA, "polygon has no area") \
  X (SELF_CROSSING, "polygon crosses itself") \
  X (BLOCKS_OVERLAP, "blocks overlap") \
  X (TOO_MANY_OVERLAPS, "more pairs of blocks overlap than the program lists") \
  X (TOO_MANY_CROSSINGS, "lines cross each other more often than the program divides them") \
  X (TOO_MANY_NEIGHBOURS, "more pairs of blocks lie near each other than the program searches") \
  X (NAME_MISSING, "name is empty") \
  X (NAME_TAKEN, "name is used twice") \
  X (LAW_UNKNOWN, "no law has this name") \
  X (LAW_MISSING, "contact law is missing") \
  X (DILATANCY_ABOVE_FRICTION, "dilatancy exceeds friction") \
  X (HARDENING_TOO_LARGE, "hardening must be less than 1") \
  X (STRENGTH_BELOW_YIELD, "strength is below yield") \
  X (CRUSHING_DILATES, "a law with an ultimate strain must have no dilatancy") \
  X (ULTIMATE_STRAIN_TOO_SMALL, "ultimate strain is not beyond the strain at the strength") \
  X (FRACTURE_ENERGY_MISSING, "a law that softens needs an energy here") \
  X (FRACTURE_ENERGY_TOO_SMALL, "fracture energy is too small for blocks of this size") \
  X (CURVE_COUNT, "curve needs 1 to 32 points besides the origin") \
  X (CURVE_ORDER, "points of the curve must have growing elongations") \
  X (CURVE_SIGN, "force of the point acts against its elongation") \
  X (CURVE_TOO_STEEP, "curve rises more steeply than kn") \
  X (PAIR_POSITION, "positions must increase from 0 to 1") \
  X (PAIR_WEIGHTS, "weights must be positive and add up to 1") \
  X (RIGID_JOINT, "both sides of a joint by material are rigid: nothing can deform") \
  X (LAW_CHAIN, "law of a chain joins blocks that have neighbours in two directions: its shear stiffness is half the right one") \
  X (LAW_GRID, "law of a grid joins blocks in one direction only: its shear stiffness is twice the right one") \
  X (LAW_SHEAR, "shear of this law stays elastic: between blocks that have neighbours in two directions neither diagonal cracks nor sliding are represented") \
  X (BAR_BASIS, "a bar needs a law by area: basis surface or material") \
  X (BAR_SHORT, "bar has no length") \
  X (BAR_END, "bar ends in no block") \
  X (BAR_TOO_MANY, "a mesh has at most 10,000 bars") \
  X (BAR_MESH, "a mesh has a rectangle between its corners, and no corners on the way") \
  X (BAR_UNUSED, "bar crosses no contact face") \
  X (TIE_SHORT, "tie has no length") \
  X (TIE_ON_GROUND, "both ends of the tie are on the ground") \
  X (TIE_ON_ONE_BLOCK, "both ends of the tie are on the same block") \
  X (TIE_PRESTRESS, "prestress is more than the tie or its anchor holds") \
  X (TIE_SLACK, "a tie with prestress has no slack") \
  X (TIE_OFF_BLOCK, "end of the tie lies outside its block") \
  X (LAW_WITHOUT_LIMIT, "limit analysis covers the strengths of joints only, not of this kind of law") \
  X (BLOCK_WITHOUT_MASS, "block has no mass to vibrate with") \
  X (STATE_SLIPS, "pairs slip without dilatancy in this state: no symmetric stiffness") \
  X (LIMIT_WITHOUT_STATE, "limit analysis ends without displacements: vibrations need another procedure") \
  X (TIME_WITHOUT_STATE, "an analysis in time leaves no equilibrium to start from") \
  X (STABILITY_STAGES, "stability is computed along the live loads, not along stages") \
  X (STATE_SINGULAR, "stiffness of this state is singular") \
  X (STATE_UNSTABLE, "this state is unstable: there are no vibrations about it") \
  X (CAPACITY_LOADS, "a capacity curve needs horizontal weights as live loads") \
  X (CAPACITY_BEAMS, "capacity curves are for blocks only: remove the beams") \
  X (CAPACITY_MOTION, "block does not move with the live load: control another one") \
  X (CAPACITY_STAGES, "a capacity curve has one live load: no stages") \
  X (MECHANISM_MISSING, "a kinematic check needs a mechanism of collapse: there is none") \
  X (MECHANISM_SLIDES, "mechanism is no chain of parts that turn about hinges: joints slide, part or are crushed") \
  X (MECHANISM_WEIGHT, "no weight resists the mechanism") \
  X (MECHANISM_TIE, "mechanism stretches a tie that has no strength: give yield or anchor") \
  X (TOO_FEW_UNKNOWNS, "structure has no degree of freedom") \
  X (MODES_NOT_FOUND, "modes were not found") \
  X (BLOCK_UNKNOWN, "no block has this name") \
  X (SAME_BLOCK, "a block has no contact with itself") \
  X (NODE_UNKNOWN, "no node has this name") \
  X (SECTION_UNKNOWN, "no section has this name") \
  X (BEAM_UNKNOWN, "no beam has this name") \
  X (NODE_UNUSED, "free node without a beam") \
  X (NODE_SUPPORTED_BY_BLOCK, "a node on a block has no support of its own") \
  X (NODE_MOMENT, "moment acts on a node where every beam is hinged") \
  X (POISSON_RATIO, "Poisson's ratio must be above -1 and at most 0.5") \
  X (LAW_POISSON, "Poisson's ratio of a law must be at least 0 and below 0.5") \
  X (YIELD_SHAPELESS, "only a rectangle yields by a stress: give the plastic moment") \
  X (BEAM_SHORT, "beam has no length") \
  X (BEAM_ON_ONE_BLOCK, "both ends of the beam are on the same block") \
  X (TOO_MANY_NODES, "more nodes than the program handles") \
  X (BEAM_FLOATING, "beam is not connected to any support") \
  X (BEAM_END_FREE, "end of the beam touches nothing") \
  X (BEAM_WITHOUT_MASS, "beam has no mass to vibrate with") \
  X (BEAMS_WITHOUT_LIMIT, "limit analysis covers rigid blocks only, not beams: use another procedure") \
  X (CONTROL_NODE_RIDES, "controlled node is on a block: control the block") \
  X (NO_BLOCKS, "no blocks: draw or generate some first") \
  X (NO_SUPPORT, "no block is supported: fix the ground, or the lowest blocks") \
  X (BLOCK_FLOATING, "block is not connected to any support") \
  X (COURSE_EMPTY, "course is empty") \
  X (COURSE_LENGTH_ZERO, "length in a course is zero") \
  X (TOO_MANY_BLOCKS, "more blocks than the program handles") \
  X (PAIR_OFFSET_TOO_LARGE, "offset leaves no room between the two contact pairs of a face") \
  X (PAIR_COUNT, "number of contact pairs must be at least one") \
  X (LOBATTO_COUNT, "gauss-lobatto has 3 to 9 contact pairs on a face") \
  X (PAIRS_BENDING, "contact pairs misstate the bending stiffness of joints") \
  X (PAIRS_CRUSHING, "crushed joints carry too much moment with these contact pairs") \
  X (NO_LIVE_LOAD, "no live load acts on any free block") \
  X (CONTROL_DOF_FIXED, "controlled degree of freedom is fixed") \
  X (CONTROL_TARGET_ZERO, "control target is zero") \
  X (CONTROL_MISSING, "procedure needs a control block and target") \
  X (DAMPING_UNUSED, "joints are damped by impact; damping by stiffness is of beams, and there are none") \
  X (CONTROL_WRONG_SIGN, "target is opposite to the motion under the live load") \
  X (SETTLEMENT_FREE, "only a supported degree of freedom can settle") \
  X (SETTLEMENT_WORK, "work control needs loads: settlements do no work") \
  X (SETTLEMENT_LIMIT, "limit analysis covers loads, not settlements") \
  X (LOAD_SET_UNKNOWN, "no load set has this name") \
  X (LOAD_CASE_UNKNOWN, "no load case has this name") \
  X (EDGE_UNKNOWN, "block has no such edge") \
  X (LOADED_PART, "loaded part must begin before it ends") \
  X (EARTH_ANGLE, "friction angle of a soil must be at least 0 and below pi/2 (rad)") \
  X (EARTH_SIDE, "soil must lie to the left or to the right") \
  X (TOO_MANY_EDGE_FORCES, "loads act on more edges than the program handles") \
  X (LOAD_MEETS_NOTHING, "load meets no edge of a block") \
  X (LOAD_OFF_BLOCK, "force acts outside its block") \
  X (LOAD_BESIDE, "axles stand beside structure and fill: they do not act") \
  X (LOAD_SET_UNUSED, "no stage applies this load set") \
  X (STAGE_IDLE, "stage applies no load set") \
  X (STAGE_SETS_APART, "load sets of the stage have different multipliers") \
  X (STAGE_ENDLESS, "target is missing: only the last stage may end by collapse") \
  X (STAGE_NO_CHANGE, "stage ends where it begins") \
  X (STAGE_TWO_ENDS, "stage ends at a multiplier or at a displacement, not at both") \
  X (STAGE_LIMIT, "limit analysis has no stages") \
  X (STAGE_MULTIPLIER, "stages have targets of their own") \
  X (SIGNAL_EMPTY, "signal needs at least two points") \
  X (SIGNAL_ORDER, "times of the signal must increase") \
  X (SIGNAL_TOO_LONG, "signal has more points than the program handles") \
  X (SIGNAL_WITHOUT_DIRECTION, "ground motion has no direction") \
  X (RADIUS_RANGE, "spectral radius must lie between 0 and 1") \
  X (TOO_MANY_TIME_STEPS, "duration has more time steps than the program handles") \
  X (STAGES_DYNAMIC, "an analysis in time has no stages") \
  X (INITIAL_FIXED, "a supported degree of freedom cannot start from elsewhere") \
  X (NEAR_MISS_GAP, "gap just wider than the contact tolerance") \
  X (NEAR_MISS_OVERLAP, "overlap within a few contact tolerances") \
  X (POINT_CONTACT, "blocks touch at a point only") \
  X (BLOCK_WITHOUT_CONTACT, "block touches no other block") \
  X (BLOCK_SLIVER, "block is a sliver beside the others: merge it with its neighbour, or remove it") \
  X (GEOMETRY_FAILED, "geometry could not be computed") \
  X (GEOMETRY_EMPTY, "nothing is left of the geometry") \
  X (GEOMETRY_HOLE, "polygon would surround a hole") \
  X (GEOMETRY_SEVERAL, "polygons do not form one piece") \
  X (FRACTION, "number must lie between 0 and 1") \
  X (PERTURBATION, "perturbation must lie between 0 and 0.4") \
  X (HEADER_TOO_LONG, "header must be shorter than the unit") \
  X (LEAVES_LISTED, "listed courses make a wall of a single leaf") \
  X (OPENING_SPAN, "this kind of span does not fit the head of the opening") \
  X (OPENING_MISSES, "opening lies outside the wall") \
  X (OPENING_OUTSIDE, "lintel, arch or sill of the opening reaches beyond the wall") \
  X (OPENINGS_OVERLAP, "openings overlap") \
  X (FLAT_ARCH_SKEW, "skew must be an acute angle") \
  X (ARCH_SHAPE, "rise does not fit the span and the shape of the arch") \
  X (SURFACE, "the surface of a fill has two or more points, from left to right") \
  X (FILL_LIVE, "fill is a dead load") \
  X (VEHICLE_UNKNOWN, "no vehicle has this name") \
  X (VEHICLE_EMPTY, "a vehicle needs axles or lines") \
  X (POINTED_RINGS, "a pointed arch has one ring") \
  X (BACKING_TOO_HIGH, "backing must end above the skewbacks and below the crown of the arches") \
  X (PIER_TOO_NARROW, "pier is too narrow for the arches on it") \
  X (OVERRIDE_UNUSED, "exception names two blocks without a common face") \
  X (DOUBT_TANGENT, "friction is a tangent: is this an angle in degrees?") \
  X (DOUBT_ANGLE, "angles are in rad: is this in degrees?") \
  X (DOUBT_APEX, "joints part at cohesion over friction: more tension is never reached") \
  X (DOUBT_STRESS, "strengths and pressures are in Pa: is this in MPa, kPa or another unit?") \
  X (DOUBT_RATIO, "this is a ratio: is it in percent?") \
  X (DOUBT_ENERGY, "energies are in J/m2: is this in N/mm?") \
  X (DOUBT_WEIGHT, "the weight is a force already: is gravity counted twice?") \
  X (DOUBT_STIFFNESS, "stiffness is in N/m, Pa/m or Pa by its basis: is this in another unit, kN, MPa or GPa?") \
  X (DOUBT_UNIT_WEIGHT, "unit weights are in N/m3: is this in kN/m3, or a density?") \
  X (DOUBT_DENSITY, "densities are in kg/m3: is this in t/m3, or a unit weight?") \
  X (DOUBT_LENGTH, "lengths are in m: is this in mm or cm?") \
  X (DOUBT_AREA, "areas are in m2: is this in mm2 or cm2?") \
  X (DOUBT_GRAVITY, "gravity is in m/s2: is this in another unit?") \
  X (DOUBT_FORCE, "forces are in N: is this in kN or another unit?") \
  X (DOUBT_ACCELERATION, "accelerations are in m/s2: is this in cm/s2?") \
  X (DOUBT_DAMPING, "damping is in 1/s by mass and in s by stiffness: is this a ratio, or in percent?") \
  X (DOUBT_NO_DEAD_LOAD, "no dead load: joints without tension and cohesion carry nothing, and the multiplier is 0") \
  X (DOUBT_SOFT, "joints are soft for their blocks, which sink far under the dead load: is the stiffness in another unit?")
/* clang-format on */

typedef enum {
#define QN_PROBLEM_ENUM(name, text) QN_PROBLEM_##name,
  QN_PROBLEMS (QN_PROBLEM_ENUM)
#undef QN_PROBLEM_ENUM
    QN_PROBLEM_COUNT
} QnProblem;

/* The English sentence of a problem; a static string. */
const char *qn_problem_text (QnProblem problem);
