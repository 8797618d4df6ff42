// What the parameters panel shows of each tunable key.
#pragma once

#include <array>
#include <cstdint>

namespace pabd {

enum class ParameterKind : std::uint8_t { real, log, integer, log_integer, choice, text };

struct ParameterRow {
  const char* key;
  const char* name;
  const char* help;
  ParameterKind kind = ParameterKind::real;
  double lo = 0, hi = 1;  // of the slider; the field takes everything that is allowed
  const char* unit = "";
  std::array<const char*, 4> choices{};
};

inline constexpr std::array kContactRows{
    ParameterRow{"contact.barrier",
                 "barrier",
                 "Which potential Ψ keeps bodies apart: the polynomial sum S(5), its even part, or the log "
                 "barrier S(4)",
                 ParameterKind::choice,
                 0,
                 0,
                 "",
                 {"polynomial", "even", "log"}},
    ParameterRow{"contact.N", "order N",
                 "Highest order of the polynomial barrier: a higher one is as stiff near d̂, and much steeper "
                 "where bodies overlap",
                 ParameterKind::integer, 1, 32},
    ParameterRow{"contact.d_hat", "thickness d̂", "Distance at which contacts begin to push",
                 ParameterKind::log, 1e-5, 1, "m"},
    ParameterRow{"contact.kappa", "stiffness κ",
                 "Height of the barrier. \"auto\": all movable bodies, at least ten and at most a hundred of "
                 "the heaviest, rest on four contacts at d = 0.9 d̂",
                 ParameterKind::log, 1e-3, 1e9, "J"},
    ParameterRow{
        "contact.onset", "onset ε",
        "Part of d̂ over which the force rises from zero. 0 is the printed formula, whose force jumps",
        ParameterKind::real, 0, 0.9},
    ParameterRow{"contact.recovery_speed", "recovery",
                 "Largest speed at which bodies that overlap by more than 2 d̂ come apart. 0: no limit",
                 ParameterKind::real, 0, 20, "m/s"},
    ParameterRow{"contact.friction.static", "friction μ",
                 "Largest friction force over normal force while bodies stick", ParameterKind::real, 0, 1.5},
    ParameterRow{"contact.friction.dynamic", "  sliding",
                 "The same while they slide; not above the static one", ParameterKind::real, 0, 1.5},
};
inline constexpr std::array kSolverRows{
    ParameterRow{"solver.method",
                 "solver",
                 "sissm is the paper's; descent is for large piles; newton solves what hangs together at "
                 "once; auto chooses for each island of bodies",
                 ParameterKind::choice,
                 0,
                 0,
                 "",
                 {"auto", "sissm", "descent", "newton"}},
    ParameterRow{"solver.projection",
                 "projection",
                 "How the affine matrix becomes a rotation. auto: weighted for sissm, tangent for descent",
                 ParameterKind::choice,
                 0,
                 0,
                 "",
                 {"auto", "polar", "weighted", "tangent"}},
    ParameterRow{"solver.iterations", "iterations", "At most so many in a step", ParameterKind::log_integer,
                 1, 1000},
    ParameterRow{"solver.tolerance", "tolerance",
                 "A step ends when no body moves by more than this part of d̂ in an iteration",
                 ParameterKind::log, 1e-12, 1},
    ParameterRow{"solver.relaxation", "relaxation", "Part of the Jacobi step that sissm takes",
                 ParameterKind::real, 0.05, 1},
};
inline constexpr std::array kWorldRows{
    ParameterRow{"time_step", "time step h", "Simulated seconds a step", ParameterKind::log, 1e-4, 0.1, "s"},
    ParameterRow{"gravity", "gravity", "Acceleration along x, y and z, m/s²", ParameterKind::text},
};

}  // namespace pabd
