// SPDX-License-Identifier: MIT
// The rows. See parameter_table.h; their order is that of scene files and of what enters a scene's hash.
#include "sim/solver/parameter_table.h"

namespace pabd {
namespace {

const char* unit_of_kappa(const Params& params) { return kappa_unit(params.contact.barrier); }

constexpr auto kLog = ParameterScale::log;

constexpr ParameterRow kRows[] = {
    {.key = "gravity",
     .label = "gravity",
     .symbol = "g",
     .unit = "m/s²",
     .help = "Acceleration along x, y and z",
     .member = &Params::gravity,
     .range = {-1e6, 1e6}},
    {.key = "time_step",
     .label = "time step h",
     .symbol = "h",
     .unit = "s",
     .noun = "step",
     .help = "Simulated seconds a step",
     .member = &Params::h,
     .range = {1e-6, 1},
     .slider_lo = 1e-4,
     .slider_hi = 0.1,
     .scale = kLog},

    {.key = "solver.method",
     .label = "solver",
     .help =
         "sissm is the paper's; descent is for large piles; newton solves all bodies that hang together by "
         "joints or contacts at once; auto picks newton or descent for each such group in each step",
     .member = &SolverParams::method},
    {.key = "solver.iterations",
     .label = "iterations",
     .help =
         "At most so many in a step; up to four times as many where they end within 0.03 d̂ of a solution, "
         "unless solver.halvings is 0",
     .member = &SolverParams::iterations,
     .range = {1, 100000},
     .slider_lo = 1,
     .slider_hi = 1000,
     .scale = kLog},
    {.key = "solver.tolerance",
     .label = "tolerance",
     .help = "A step ends when no body moves by more than this part of d̂ in an iteration. 0: never",
     .member = &SolverParams::tolerance,
     .range = {0, 1},
     .slider_lo = 1e-12,
     .slider_hi = 1,
     .scale = kLog},
    {.key = "solver.halvings",
     .label = "halvings",
     .help = "A step that ends unsolved, or would make energy, is made again as two halves, so many times at "
             "most; only the bodies that hang together with what is unsolved, on a GPU all. Not where "
             "there is one iteration, and not for sissm. 0: never",
     .member = &SolverParams::halvings,
     .range = {0, 8},
     .slider_hi = 8,
     .hashed_default = false},
    {.key = "solver.integrator",
     .label = "integrator",
     .help =
         "bdf2: of second order where motion is smooth, for what flies and for joints, so that what swings "
         "is hardly damped; where a contact pushes, a joint is past a limit or has friction, and for halves: "
         "implicit Euler. euler: implicit Euler throughout, the paper's, which damps what swings. For sissm "
         "always euler",
     .member = &SolverParams::integrator,
     .hashed_default = false},
    {.key = "solver.relaxation",
     .label = "relaxation",
     .help = "Part of the Jacobi step that sissm takes; 1 is undamped",
     .member = &SolverParams::relaxation,
     .range = {0, 1, true},
     .slider_lo = 0.05,
     .slider_hi = 1},
    {.key = "solver.projection",
     .label = "projection",
     .help = "How the affine matrix becomes a rotation. polar is the paper's as printed and runs away where "
             "bonds are stiff; weighted is the exact minimiser of the body's isotropic model; tangent is a "
             "Newton step with its own normal and tangential weights, for descent only. auto: weighted for "
             "sissm, tangent for descent",
     .member = &SolverParams::projection},
    {.key = "solver.device",
     .label = "device",
     .help = "Who makes the steps. gpu: compute shaders of OpenGL 4.3, in float, by descent, for contacts, "
             "what hangs on "
             "joints stays with the processor; auto: a GPU that is no software where it takes the scene and "
             "10000 bodies "
             "or more move, else the processor. --device of a command goes before it",
     .member = &SolverParams::device,
     .hashed = false},

    {.key = "contact.barrier",
     .label = "barrier",
     .help = "Which potential Ψ keeps bodies apart: the polynomial sum S(5), its even part, the log barrier "
             "S(4), or a quadratic penalty",
     .member = &ContactParams::barrier},
    {.key = "contact.N",
     .label = "order N",
     .symbol = "N",
     .help =
         "Highest order of the polynomial barrier, at least 2 for its even part: a higher one is as stiff "
         "near d̂, and much steeper where bodies overlap",
     .member = &ContactParams::N,
     .range = {1, kMaxOrder},
     .slider_lo = 1,
     .slider_hi = kMaxOrder},
    {.key = "contact.d_hat",
     .label = "thickness d̂",
     .symbol = "d̂",
     .unit = "m",
     .noun = "thickness",
     .help = "Distance at which contacts begin to push. Where a scene states none, at most a tenth of the "
             "thickness of "
             "its thinnest movable body",
     .member = &ContactParams::d_hat,
     .range = {1e-9, 1e3},
     .slider_lo = 1e-5,
     .slider_hi = 1,
     .scale = kLog},
    {.key = "contact.kappa",
     .label = "stiffness κ",
     .symbol = "κ",
     .unit = "J",
     .unit_with = unit_of_kappa,
     .noun = "stiffness",
     .help = "Height of the barrier; J/m² for the log barrier. auto: all movable bodies, at least ten and at "
             "most a hundred of the heaviest, rest on four contacts at d = 0.9 d̂",
     .member = &ContactParams::kappa,
     .range = {1e-12, 1e18},
     .slider_lo = 1e-3,
     .slider_hi = 1e9,
     .scale = kLog},
    {.key = "contact.onset",
     .label = "onset ε",
     .symbol = "ε",
     .noun = "width",
     .help = "Part of d̂ over which the force rises from zero. 0 is the printed formula, whose force jumps",
     .member = &ContactParams::onset,
     .range = {0, 1, false, true},
     .slider_hi = 0.9},
    {.key = "contact.recovery_speed",
     .label = "recovery",
     .unit = "m/s",
     .noun = "speed",
     .help = "Largest speed at which bodies that overlap by more than 2 d̂ come apart. 0: no limit",
     .member = &ContactParams::recovery_speed,
     .range = {0, 1e6},
     .slider_hi = 20},
    {.key = "contact.friction.static",
     .label = "friction μ",
     .symbol = "μ_static",
     .noun = "coefficient",
     .help = "Largest friction force over normal force while bodies stick",
     .member = &ContactParams::mu_static,
     .range = {0, 100},
     .slider_hi = 1.5},
    {.key = "contact.friction.dynamic",
     .label = "sliding",
     .symbol = "μ_dynamic",
     .noun = "coefficient",
     .help = "Friction force over normal force while bodies slide; not above the static one",
     .member = &ContactParams::mu_dynamic,
     .range = {0, 100},
     .slider_hi = 1.5,
     .follows = "contact.friction.static"},
    {.key = "contact.friction.torsional",
     .label = "torsional",
     .symbol = "μ_torsional",
     .unit = "m",
     .noun = "length",
     .help = "Largest torque of friction about the normal of a contact, over its normal force: what spins on "
             "a point comes to rest. Not on a GPU",
     .member = &ContactParams::torsional,
     .range = {0, 1e3},
     .slider_hi = 0.1,
     .hashed_default = false},
    {.key = "contact.friction.rolling",
     .label = "rolling",
     .symbol = "μ_rolling",
     .unit = "m",
     .noun = "length",
     .help = "Largest torque of friction about what lies in the plane of a contact, over its normal force: "
             "what rolls comes to rest. Not on a GPU",
     .member = &ContactParams::rolling,
     .range = {0, 1e3},
     .slider_hi = 0.1,
     .hashed_default = false},
    {.key = "contact.friction_rule",
     .label = "combined",
     .help = "How the friction and the restitution of two bodies become those of their contact, where one of "
             "them at "
             "least has its own; who has none counts with that of contact. Where neither has, that is the "
             "contact's",
     .member = &ContactParams::friction_rule,
     .hashed_default = false,
     .applies = [](const Model& model) { return !model.friction.empty() || !model.restitution.empty(); }},
    {.key = "contact.restitution",
     .label = "restitution e",
     .symbol = "e",
     .help =
         "Speed with which bodies part after a hit over that with which they came; of bodies that have none "
         "of their own. What comes with less than 2 g h does not bounce. Not on a GPU",
     .member = &ContactParams::restitution,
     .range = {0, 1},
     .slider_lo = 0,
     .slider_hi = 1,
     .hashed_default = false},
    {.key = "contact.damping",
     .label = "damping τ",
     .symbol = "τ",
     .unit = "s",
     .noun = "time",
     .help = "Contacts push as if they were at d + τ times the speed at which d changes, and never pull: "
             "what sways on them comes to rest. Not for the log barrier, not on a GPU",
     .member = &ContactParams::damping,
     .range = {0, 10},
     .slider_hi = 0.1,
     .hashed_default = false},
};

constexpr ParameterSection kSections[] = {
    {"solver", "How a time step is solved"},
    {"contact", "What happens where bodies meet"},
    {"contact.friction", "Coulomb friction",
     "Coulomb friction; one number is that of slip, static and dynamic"},
};

}  // namespace

ParameterTable parameter_table() { return kRows; }
std::span<const ParameterSection> parameter_sections() { return kSections; }

}  // namespace pabd
