// SPDX-License-Identifier: MIT
// pabd serve: the window in a browser. What it does is in serve_run.cpp.
#include <memory>

#include "app/cli/backend_option.h"
#include "app/cli/help_text.h"
#include "app/cli/serve_setup.h"
#include "app/serve/gate.h"
#include "sim/base/error.h"
#include "sim/base/utf8.h"

namespace pabd::cli {
namespace {

int checked(const ServeSetup& setup) {
  check_range("--port", setup.port, 0, 65535);
  check_range("--sessions", setup.sessions, 1, 64);
  check_range("--past", setup.past, 1, 1e6, "MB");
  check_range("--idle-limit", setup.idle_limit, 0.1, 1e5, "minutes");
  if (setup.certificate.empty() != setup.key.empty())
    throw Error(ErrorKind::bad_input, "--tls-cert and --tls-key go together: give both, or none");
  for (const std::string& host : setup.hosts)
    if (!is_host(host))
      throw Error(
          ErrorKind::bad_input,
          fmt::format("--host {}: expected a name such as example.org or example.org:8472", one_line(host)));
  if (!setup.embed.empty() && !setup.embed.starts_with("http://") && !setup.embed.starts_with("https://"))
    throw Error(ErrorKind::bad_input, "--embed: expected an origin such as http://localhost:8888");
  if (setup.embed.find_first_of(" ;,'\"*\r\n") != std::string::npos)
    throw Error(ErrorKind::bad_input, "--embed: expected one origin such as http://localhost:8888");
  return serve(setup);
}

}  // namespace

void add_serve_command(CLI::App& app, Action& action) {
  auto setup = std::make_shared<ServeSetup>();
  CLI::App* command =
      add_command(app, "serve", "the interactive window in a browser, drawn on this machine",
                  {"pabd serve pyramid", "pabd serve pyramid --play --port 9000",
                   "pabd serve pile --root files --pause-when-alone",
                   "pabd serve pyramid --listen 0.0.0.0 --tls-cert cert.pem --tls-key key.pem"},
                  setup->common);
  command->add_option("SCENE", setup->scene,
                      "scene file, or the name of a shipped scene (default two_boxes)");
  constexpr const char *kNetwork = "Network", *kVisitors = "Visitors";
  auto* port = command
                   ->add_option("--port", setup->port,
                                "to listen on; 0: any that is free (default 8472, or one of the next 19)")
                   ->type_name("N")
                   ->group(kNetwork);
  command
      ->add_option("--listen", setup->addresses,
                   "address of this machine (repeatable; default 127.0.0.1 and ::1: only from here)")
      ->type_name("ADDRESS")
      ->allow_extra_args(false)
      ->group(kNetwork);
  command
      ->add_option("--host", setup->hosts,
                   "another name under which browsers call it (repeatable), for forwarded ports and proxies")
      ->type_name("NAME[:PORT]")
      ->allow_extra_args(false)
      ->group(kNetwork);
  command->add_option("--tls-cert", setup->certificate, "certificate chain, for https")
      ->type_name("PEM")
      ->group(kNetwork);
  command->add_option("--tls-key", setup->key, "its key")->type_name("PEM")->group(kNetwork);
  command
      ->add_flag("--i-know", setup->trusted,
                 "listen beyond this machine without TLS: everybody on the way can read the token")
      ->group(kNetwork);
  command->add_option("--embed", setup->embed, "a page from there may show this one in a frame (notebooks)")
      ->type_name("ORIGIN")
      ->group(kNetwork);
  command->add_flag("--no-watchers", setup->no_watchers, "no second link for people who only watch")
      ->group(kVisitors);
  command
      ->add_option("--sessions", setup->sessions,
                   "so many simulations, one a visitor (default 1: all see the same one)")
      ->type_name("K")
      ->group(kVisitors);
  command
      ->add_option("--idle-limit", setup->idle_limit,
                   "with --sessions: a simulation without its visitor is ended after so long (default 10)")
      ->type_name("MINUTES")
      ->group(kVisitors);
  command->add_flag("--pause-when-alone", setup->pause_when_alone, "the simulation waits while nobody looks")
      ->group(kVisitors);
  command
      ->add_option(
          "--root", setup->root,
          "folder of all files that are saved and uploaded (default: a new one that goes at the end)")
      ->type_name("FOLDER")
      ->group(kVisitors);
  command->add_flag("--play", setup->play, "start at once")->group(kVisitors);
  command
      ->add_option("--size", setup->size,
                   "pixels of the window before a page asks for its own (default 1280x720)")
      ->type_name("WxH")
      ->group(group::kPicture);
  command->add_option("--past", setup->past, "for states of the past of each simulation (default 256)")
      ->type_name("MB")
      ->group(group::kSimulation);
  add_backend_option(*command, setup->backend);
  add_scene_options(*command, setup->common);
  command->callback([setup, port, &action] {
    setup->port_given = port->count() > 0;
    action = [setup] { return checked(*setup); };
  });
}

}  // namespace pabd::cli
