// SPDX-License-Identifier: MIT
// Requests of programs: scripts, state, pictures. See desk_work.h.
#include "app/gui/pictures.h"
#include "app/gui/script.h"
#include "app/serve/clock.h"
#include "app/serve/desk_work.h"
#include "render/output/png.h"
#include "sim/base/error.h"
#include "sim/scene/document.h"

namespace pabd {
namespace {

constexpr const char *kJson = "application/json", *kPng = "image/png";

desk::Answer answer_of(int status, const OrderedJson& json) {
  return {status, kJson, json_line(json) + "\n"};
}
desk::Answer refusal(int status, const std::string& why) { return answer_of(status, {{"error", why}}); }

// The desk was stopped during the script.
struct LeftScript {};

// Index of the first action that cannot be read; null: all can.
OrderedJson place_of_fault(const std::string& text) {
  OrderedJson document = OrderedJson::parse(text, nullptr, false);
  if (document.is_object() && document.contains("actions")) document = OrderedJson(document["actions"]);
  if (!document.is_array()) return nullptr;
  for (std::size_t i = 0; i < document.size(); ++i) {
    try {
      static_cast<void>(read_script(OrderedJson::array({document[i]}).dump(), "action"));
    } catch (const Error&) {
      return i;
    }
  }
  return nullptr;
}

}  // namespace

void DeskWork::run(const desk::Run& run) {
  const auto reply = [&](const desk::Answer& answer) {
    if (run.reply) return run.reply(answer);
    if (answer.status == 200) return;
    send_text({{"t", "error"}, {"text", OrderedJson::parse(answer.body)["error"]}}, true);
  };
  OrderedJson action, printed = OrderedJson::array();
  double began = 0;
  std::unique_lock turn(*options_.turn, std::defer_lock);
  try {
    static_cast<void>(parse_document(run.json, "actions"));  // checks the depth
    action = place_of_fault(run.json);
    const Script script(run.json, "actions");
    ScriptOptions options;
    options.force = true;  // the folder belongs to the visitors
    options.width = width_;
    options.height = height_;
    options.print = [&](const std::string& line) {
      printed.push_back(line.substr(0, line.find_last_not_of('\n') + 1));
    };
    options.before_action = [&](std::size_t number) { action = number; };
    options.refusal_of_window = refusal_of_window;
    options.before_frame = [&] {
      if (turn.owns_lock()) turn.unlock();  // an exception skipped after_frame
      if (queue_.stopped()) throw LeftScript();
      for (DeskInput& input : queue_.take_acknowledgements()) take(input);
      turn.lock();
      began = seconds_now();
    };
    options.after_frame = [&] {
      take_frame(began);
      turn.unlock();
      stream_.deliver(seconds_now());
    };
    script.run(viewer_, runner_, options);
    OrderedJson done = {{"done", script.size()}};
    if (!printed.empty()) done["printed"] = printed;
    reply(answer_of(200, done));
  } catch (const Error& error) {
    OrderedJson json = {{"error", error.what()}};
    if (!action.is_null()) json["action"] = action;
    reply(answer_of(422, json));
  } catch (const LeftScript&) {
    reply(refusal(503, "the server is going down"));
  } catch (const std::exception& error) {
    reply(refusal(500, error.what()));
  }
}

void DeskWork::answer(const desk::AskState& ask) {
  {
    const std::scoped_lock turn(*options_.turn);
    draw();
  }
  ask.reply(answer_of(200, state_document(viewer_.snapshot(), viewer_.ui(), viewer_.layout())));
}

// Any visitor may ask, so the window and its input stay as they are.
void DeskWork::answer(const desk::AskPicture& ask) {
  const std::scoped_lock turn(*options_.turn);
  const int width = ask.width > 0 ? ask.width : width_, height = ask.height > 0 ? ask.height : height_;
  const bool own_size = width == width_ && height == height_;
  try {
    draw();  // processes waiting events at the present size
    if (ask.panels && !own_size && viewer_.button_held())
      return ask.reply(
          refusal(503, "somebody drags in the window: try again, ask for its own size, or with panels=0"));
    std::vector<std::uint8_t> png;
    if (ask.panels) {
      for (int i = 0; i < 2; ++i) {  // the first one may resize panels
        if (own_size)
          draw();
        else
          viewer_.draw_aside(width, height);
      }
      Image image;
      viewer_.renderer().queue_read();
      viewer_.renderer().fetch(image);
      png = encode_png(image, {{"Software", "pabd"}});
    } else {
      png = scene_picture(viewer_.snapshot(), viewer_.ui(), width, height, context_);
    }
    ask.reply({200, kPng, std::string(png.begin(), png.end())});
  } catch (const Error& error) {
    ask.reply(refusal(422, error.what()));
  }
}

}  // namespace pabd
