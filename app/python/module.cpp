// SPDX-License-Identifier: MIT
// pabd._pabd: what the package `pabd` is made of. Public names and their words for people are there
// (pabd/__init__.py); what is checked and computed is here and in the libraries.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/cli/exit_code.h"
#include "app/cli/scene_lookup.h"
#include "app/python/arrays.h"
#include "app/python/figures.h"
#include "app/python/simulation.h"
#include "app/python/values.h"
#include "app/session/step_at_time.h"
#include "render/output/png.h"
#include "sim/base/error.h"
#include "sim/base/output_path.h"
#include "sim/import/import.h"
#include "sim/scene/thickness.h"
#include "sim/trace/trace.h"

namespace pabd::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

// pabd.Error of the package, which has the same text.
void translate(std::exception_ptr thrown) {  // NOLINT(performance-unnecessary-value-param): pybind11's type
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const Error& error) {
    const py::object type = py::module_::import("pabd._pabd").attr("Error");
    const py::object raised = type(py::str(error.what()));
    raised.attr("code") = cli::exit_code(error.kind());
    raised.attr("kind") = cli::word_of(error.kind()).word;
    PyErr_SetObject(type.ptr(), raised.ptr());
  }
}

void bind_errors(py::module_& module) {
  const py::dict members("code"_a = 1, "kind"_a = "defect");
  PyObject* type = PyErr_NewExceptionWithDoc(
      "pabd.Error",
      R"(What pabd refuses, cannot do, or what went wrong; its text is the line that the program prints.

code: the exit code of the program: 1 defect, 2 bad input, 3 file, 4 no OpenGL, 5 diverged, 6 encoder, 7 images differ.
kind: the same as a word: "bad_input", "exists", "file", "no_context", "diverged", ….)",
      nullptr, members.ptr());
  if (type == nullptr) throw py::error_already_set();
  module.attr("Error") = py::reinterpret_steal<py::object>(type);
  py::register_exception_translator(&translate);
}

// A member of the scene.
template <class Get>
auto of_scene(Get get) {
  return [get](const NamedScene& named) { return get(*named.scene); };
}

void bind_scene(py::module_& module) {
  py::class_<NamedScene>(module, "Scene",
                         "A scene, validated and expanded: what a Simulation begins with. "
                         "It never changes.")
      .def_property_readonly("name", of_scene([](const Scene& s) { return s.name; }),
                             "Of the scene; the file's stem where it gives none.")
      .def_property_readonly("description", of_scene([](const Scene& s) { return s.description; }),
                             "One line; may be empty.")
      .def_property_readonly("duration", of_scene([](const Scene& s) { return s.duration; }),
                             "That its author means to be shown; s. None: not said.")
      .def_property_readonly("notes", of_scene([](const Scene& s) {
                               std::vector<std::string> notes;
                               if (const auto note = thickness_note(s)) notes.push_back(note->text);
                               return notes;
                             }),
                             "What the program says of it when it is read, a line each.")
      .def_property_readonly("hash", of_scene([](const Scene& s) { return s.hash; }),
                             "16 hex digits over the scene with all that was set when it was read.")
      .def_property_readonly("bodies", of_scene([](const Scene& s) { return s.model.name; }),
                             "Names of the bodies, by number.")
      .def_property_readonly("joints", of_scene([](const Scene& s) {
                               std::vector<std::string> names;
                               for (const Joint& joint : s.model.joints) names.push_back(joint.name);
                               return names;
                             }),
                             "Names of the joints, by number.")
      .def("__repr__", of_scene([](const Scene& s) {
             return "<pabd.Scene " + s.name + ": " + std::to_string(s.model.size()) + " bodies, " +
                    std::to_string(s.model.joints.size()) + " joints>";
           }));
  module.def(
      "load_scene",
      [](const std::string& name, const std::vector<std::string>& overrides) {
        return NamedScene{std::make_shared<const Scene>(load_any_scene(cli::find_scene(name), overrides)),
                          name};
      },
      "name"_a, "overrides"_a, py::call_guard<py::gil_scoped_release>());
  module.def(
      "parse_scene",
      [](const std::string& text, const std::string& source, const std::filesystem::path& folder,
         const std::vector<std::string>& overrides) {
        return NamedScene{std::make_shared<const Scene>(parse_scene(text, source, folder, overrides)),
                          source};
      },
      "text"_a, "source"_a, "folder"_a, "overrides"_a, py::call_guard<py::gil_scoped_release>());
  module.def("scenes", [] {
    std::vector<std::string> names;
    for (const auto& file : cli::shipped_scenes()) names.push_back(file.stem().string());
    return names;
  });
}

void bind_state(py::module_& module) {
  py::class_<SavedState>(module, "State", "A moment of a simulation, to come back to. It never changes.")
      .def_property_readonly(
          "time", [](const SavedState& s) { return s.state.time; }, "Of the simulation; s.")
      .def_property_readonly(
          "step", [](const SavedState& s) { return s.state.step; }, "Steps since the start.")
      .def_property_readonly(
          "hash", [](const SavedState& s) { return state_hash(s.state); },
          "16 hex digits over all that the next step depends on: equal states, equal hash.")
      .def(
          "json", [](const SavedState& s) { return state_to_json(*s.model, s.state); },
          "The text of a state file, as 'pabd run --state' writes it; numbers read back exactly.");
}

// Arrays of the state and the model: views.
void bind_views(py::class_<Simulation>& simulation) {
  const auto view = [&](const char* name, auto array, const char* doc) {
    simulation.def_property_readonly(
        name, [array](const py::object& self) { return array(self.cast<const Simulation&>(), self); }, doc);
  };
  view(
      "positions", [](const Simulation& s, py::handle self) { return view_of(s.state().c, self); },
      "Centres of mass: (n, 3) float64, m, world. A read-only view without a copy; every step refreshes it.");
  view(
      "rotations", [](const Simulation& s, py::handle self) { return view_of(s.state().R, self); },
      R"(Affine matrices at the end of the step, which are rotations, body to world: (n, 3, 3) float64.
A read-only view without a copy; every step refreshes it.)");
  view(
      "velocities", [](const Simulation& s, py::handle self) { return view_of(s.state().v, self); },
      "Of the centres of mass: (n, 3) float64, m/s, world. A read-only view without a copy; every step "
      "refreshes it.");
  view(
      "angular_velocities",
      [](const Simulation& s, py::handle self) { return view_of(s.state().omega, self); },
      "(n, 3) float64, rad/s, world. A read-only view without a copy; every step refreshes it.");
  view(
      "masses", [](const Simulation& s, py::handle self) { return view_of(s.model().mass, self); },
      "(n,) float64, kg; 0 for a fixed body. A read-only view without a copy; it never changes.");
  view(
      "fixed", [](const Simulation& s, py::handle self) { return flags_of(s.model().fixed, self); },
      "(n,) bool: never moves. A read-only view without a copy; it never changes.");
}

// What a step tells: copies.
void bind_reports(py::class_<Simulation>& simulation) {
  const auto property = [&](const char* name, auto get, const char* doc) {
    simulation.def_property_readonly(name, get, doc);
  };
  const auto observed = [](bool on, const char* what) {
    if (!on)
      throw Error(ErrorKind::bad_input,
                  std::string(what) + ": not observed; call observe(" + what + "=True) before the step");
  };
  property(
      "report", [](const Simulation& s) { return dict_of(s.session().report()); },
      R"(Of the last step, a dict of its own: status, iterations, contacts, energies (J), min_gap (m), times (ms), ….
Before the first step: the energies of the start.)");
  property(
      "energies", [](const Simulation& s) { return energies_of(s.session().report()); },
      "kinetic, potential (-sum of m g.c), elastic (in contacts and bonds) and total; J.");
  property(
      "contacts",
      [observed](const Simulation& s) {
        observed(s.observed().contacts, "contacts");
        return contacts_of(s.session().report());
      },
      R"(Contacts with d < d_hat at the end of the last step, a copy: structured array with the fields
a, b           numbers of the bodies; a owns the normal
y_a, y_b       (3,) the two points, world; m
n              (3,) unit normal from a to b
d              signed distance (y_b - y_a).n; m
normal_force   f_n = -Psi'(d) >= 0; N
friction       (3,) friction force on b; N
sticking       bool
mu             coefficient of friction in the step)");
  property(
      "iterations",
      [observed](const Simulation& s) {
        observed(s.observed().iterations, "iterations");
        return iterations_of(s.session().report());
      },
      R"(Iterations of the last step, the first iterate first, a copy: structured array with the fields
iteration                  0: before the first one
energy                     incremental potential E; J
residual                   largest displacement of a body in this iteration over d_hat
max_penetration_before     max(0, -d) before and after the projection; m
max_penetration_after
min_gap_before             smallest d before and after the projection; m
min_gap_after
max_joint_error            m
projection_change          largest |A - R| (Frobenius) over bodies)");
  property(
      "joint_forces",
      [observed](const Simulation& s) {
        observed(s.observed().joints, "joints");
        return joints_of(s.session().report());
      },
      R"(What each joint's first body does to the second one in the last step, a copy: structured array with the fields
force    (3,) N, world
moment   (3,) about the joint's anchor on the first body; N m
axis     (3,) unit, of the joint, with the first body
coupling what the joint that it follows drives its angle or offset with; N m or N)");
  property(
      "history", [](const Simulation& s) { return steps_of(s.history()); },
      R"(The last steps (20000 or more) since the start, reset() or restore(), a copy: structured array with the fields
converged, milliseconds, and the numbers of a step's report (assets/step_numbers.md).)");
}

py::dict stepped(Simulation& simulation, std::int64_t count) {
  simulation.step(count);
  return dict_of(simulation.session().report());
}

void bind_simulation(py::module_& module) {
  py::class_<Simulation> simulation(module, "Simulation");
  simulation.def(py::init<NamedScene, int>(), "scene"_a, "threads"_a = 0)
      .def_property_readonly("scene", &Simulation::scene, "The Scene that it began with.")
      .def_property_readonly(
          "time", [](const Simulation& s) { return s.session().state().time; }, "Of the simulation; s.")
      .def_property_readonly(
          "steps", [](const Simulation& s) { return s.session().state().step; }, "Steps since the start.")
      .def_property_readonly(
          "kappa", [](const Simulation& s) { return s.session().kappa(); },
          "Stiffness of the contacts that contact.kappa comes to where it is \"auto\"; J.")
      .def_property_readonly(
          "hash", [](const Simulation& s) { return state_hash(s.session().state()); },
          "Of the state: what 'pabd run' prints for the same scene, parameters and steps.")
      .def(
          "step", [](Simulation& s, std::int64_t n) { return stepped(s, n); }, "n"_a = 1,
          R"(Make n steps (0 to 10**9), and return the report of the last one as a dict.

The interpreter's lock is released meanwhile. Ctrl-C ends it between two steps with KeyboardInterrupt; the steps that
were made stay. Error with code 5 where the state leaves all bounds: it stays that of the step before.)")
      .def(
          "run",
          [](Simulation& s, double time) { return stepped(s, steps_until(time, s.session().params().h)); },
          "time"_a,
          "Make the steps that the program makes in `time` seconds, and return the report of the last one.")
      .def("_parameter", [](const Simulation& s,
                            const std::string& key) { return parameter_value(s.session().params(), key); })
      .def("_set", &Simulation::set)
      .def(
          "observe",
          [](Simulation& s, std::optional<bool> contacts, std::optional<bool> joints,
             std::optional<bool> iterations) {
            const Observed now = s.observed();
            s.observe({contacts.value_or(now.contacts), joints.value_or(now.joints),
                       iterations.value_or(now.iterations)});
          },
          py::kw_only(), "contacts"_a = py::none(), "joints"_a = py::none(), "iterations"_a = py::none(),
          R"(What later steps put into their reports; None: as it is. At first contacts and joints.

None of it changes a result; iterations cost a pass over the contacts each.)")
      .def("reset", &Simulation::reset, "Back to the start of the scene and to its parameters.")
      .def("save", &Simulation::save, "The present moment as a State, to come back to.")
      .def("restore", &Simulation::restore, "state"_a,
           "Go on from a State of this scene, with the present parameters. The history begins anew.")
      .def(
          "load_state", [](Simulation& s, const std::filesystem::path& path) { s.load_state(path.string()); },
          "path"_a,
          "Go on from a state file of this scene, as 'pabd run --from' does. The history begins anew.")
      .def(
          "render",
          [](Simulation& s, int width, int height, const std::string& camera, const std::string& overlay,
             const std::string& theme, const std::string& quality) {
            return rgba_of(s.render({width, height, camera, overlay, theme, quality}));
          },
          "width"_a = 1280, "height"_a = 720, py::kw_only(), "camera"_a = "", "overlay"_a = "none",
          "theme"_a = "studio", "quality"_a = "good",
          R"(A picture as 'pabd render' makes it, without a display: (height, width, 4) uint8, sRGB and opacity.

camera, overlay, theme, quality: words as that command takes them ("front,ortho", "contacts,series", "dark", "draft").
Drawing again with the same words is quick. Error with code 4 where there is no OpenGL.)");
  bind_views(simulation);
  bind_reports(simulation);
}

// From (h, w, 3) or (h, w, 4).
void write_array(const std::filesystem::path& path,
                 const py::array_t<std::uint8_t, py::array::c_style>& array, bool force) {
  if (array.ndim() != 3 || (array.shape(2) != 3 && array.shape(2) != 4) ||
      array.shape(0) > png_largest_side || array.shape(1) > png_largest_side)
    throw Error(ErrorKind::bad_input,
                "write_png: expected an array (h, w, 3) or (h, w, 4) of at most 16384 "
                "pixels a side");
  check_overwrite(path.string(), path, {force, nullptr, "force=True replaces it"});
  Image image;
  image.resize(static_cast<int>(array.shape(1)), static_cast<int>(array.shape(0)));
  const auto channels = static_cast<std::size_t>(array.shape(2));
  const std::uint8_t* from = array.data();
  for (std::size_t k = 0; k < image.rgb.size() / 3; ++k, from += channels) {
    std::copy_n(from, 3, image.rgb.data() + 3 * k);
    if (channels == 4) image.alpha.push_back(from[3]);
  }
  if (std::all_of(image.alpha.begin(), image.alpha.end(), [](std::uint8_t a) { return a == 255; }))
    image.alpha.clear();
  write_png(path, image, {{"Software", "pabd " PABD_VERSION}});
}

}  // namespace
}  // namespace pabd::python

PYBIND11_MODULE(_pabd, module) {
  using namespace pabd::python;
  namespace py = pybind11;
  using namespace py::literals;
  register_rows();
  module.attr("__version__") = PABD_VERSION;
  bind_errors(module);
  bind_scene(module);
  bind_state(module);
  bind_simulation(module);
  bind_figures(module);
  module.def("parameters", [] {
    py::list rows;
    for (const pabd::ParameterRow& row : pabd::parameter_table()) rows.append(description_of(row));
    return rows;
  });
  module.def("_set_context_trial", &pabd::set_context_trial, "command"_a);
  module.def("_try_contexts", &pabd::try_headless_contexts, "words"_a);
  module.def("write_png", &write_array, "path"_a, "image"_a, "force"_a);
  module.def(
      "read_png", [](const std::filesystem::path& path) { return rgba_of(pabd::read_png(path)); }, "path"_a);
}
