// How the solver converged within the step that led to the present state.
#include "app/gui/panels.h"
#include "app/gui/widgets.h"
#include "app/plots/figures/convergence.h"

namespace pabd {
namespace {

class ConvergencePanel final : public GuiPanel {
 public:
  const char* name() const override { return "convergence"; }
  const char* title() const override { return "Convergence"; }
  const char* help() const override {
    return "Energy, residual, penetration and joint error of every iteration of the step";
  }
  Slot slot() const override { return Slot::right_bottom; }

  void draw(GuiFrame& f) override {
    plot_widget(f, "convergence", convergence_plot(f.sim.a.report.records, !f.sim.a.model->joints.empty()),
                ImGui::GetContentRegionAvail());
  }
};

}  // namespace

std::unique_ptr<GuiPanel> make_convergence_panel() { return std::make_unique<ConvergencePanel>(); }

}  // namespace pabd
