// The barrier that contacts see, to read and to tune on.
#include "app/plots/figures/barrier_panel.h"
#include "app/gui/panels.h"
#include "app/gui/widgets.h"
#include "app/overlay/panels.h"

namespace pabd {
namespace {

class BarrierPanelView final : public GuiPanel {
 public:
  const char* name() const override { return "barrier"; }
  const char* title() const override { return "Barrier"; }
  const char* help() const override {
    return "Ψ, Ψ′ and Ψ″ against the distance d, with a marker for every contact";
  }
  Slot slot() const override { return Slot::right_top; }

  void draw(GuiFrame& f) override {
    BarrierPanelOptions options;
    const BarrierPanel data = barrier_panel(f.sim.a.params.contact, f.sim.a.kappa,
                                            f.sim.a.report.contact_reports, contact_ink, options);
    plot_widget(f, "barrier", data.plot, ImGui::GetContentRegionAvail());
  }
};

}  // namespace

std::unique_ptr<GuiPanel> make_barrier_panel() { return std::make_unique<BarrierPanelView>(); }

}  // namespace pabd
