// Quantities over time; a click goes to that step.
#include "app/gui/panels.h"
#include "app/gui/widgets.h"
#include "app/plots/figures/time_series.h"

namespace pabd {
namespace {

class SeriesPanel final : public GuiPanel {
 public:
  const char* name() const override { return "series"; }
  const char* title() const override { return "Over time"; }
  const char* help() const override {
    return "Penetration, energies and errors over time; a click goes to that step";
  }
  Slot slot() const override { return Slot::right_bottom; }

  void draw(GuiFrame& f) override {
    std::vector<HistoryPoint> points;
    for (const StepReport& r : *f.sim.a.history) points.push_back(history_point(r));
    const PlotTouch touch = plot_widget(
        f, "series", time_series_plot(points, f.sim.a.params.contact.d_hat, !f.sim.a.model->joints.empty()),
        ImGui::GetContentRegionAvail());
    if (touch.clicked) f.out.send(Command(command::Seek{touch.layout.unmap(touch.mouse).x}));
  }
};

}  // namespace

std::unique_ptr<GuiPanel> make_series_panel() { return std::make_unique<SeriesPanel>(); }

}  // namespace pabd
