// SPDX-License-Identifier: MIT
// pabd serve: the window in a browser. What it does is in serve_run.cpp.
#include <fmt/format.h>

#include <memory>

#include "app/cli/serve_setup.h"
#include "app/serve/gate.h"
#include "sim/base/error.h"
#include "sim/base/utf8.h"

namespace pabd::cli {
namespace {

int checked(const ServeSetup& setup) {
  check_range("--port", setup.port.value_or(0), 0, 65535);
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
  const Command command(app, "serve", "the interactive window in a browser, drawn on this machine",
                        {"pabd serve pyramid", "pabd serve pyramid --play --port 9000",
                         "pabd serve pile --root files --pause-when-alone",
                         "pabd serve pyramid --listen 0.0.0.0 --tls-cert cert.pem --tls-key key.pem"},
                        setup->common);
  constexpr const char *kNetwork = "Network", *kVisitors = "Visitors";
  using namespace group;
  command.argument("SCENE", setup->scene, "scene file, or the name of a shipped scene (default two_boxes)");
  command.option(kNetwork, "--port", setup->port,
                 "to listen on; 0: any that is free (default 8472, or one of the next 19)", "N");
  command.repeated(kNetwork, "--listen", setup->addresses,
                   "address of this machine (repeatable; default 127.0.0.1 and ::1: only from here)",
                   "ADDRESS");
  command.repeated(kNetwork, "--host", setup->hosts,
                   "another name under which browsers call it (repeatable), for forwarded ports and proxies",
                   "NAME[:PORT]");
  command.option(kNetwork, "--tls-cert", setup->certificate, "certificate chain, for https", "PEM");
  command.option(kNetwork, "--tls-key", setup->key, "its key", "PEM");
  command.flag(kNetwork, "--i-know", setup->trusted,
               "listen beyond this machine without TLS: everybody on the way can read the token");
  command.option(kNetwork, "--embed", setup->embed,
                 "a page from there may show this one in a frame (notebooks)", "ORIGIN");
  command.flag(kVisitors, "--no-watchers", setup->no_watchers, "no second link for people who only watch");
  command.option(kVisitors, "--sessions", setup->sessions,
                 "so many simulations, one a visitor (default 1: all see the same one)", "K");
  command.option(kVisitors, "--idle-limit", setup->idle_limit,
                 "with --sessions: a simulation without its visitor is ended after so long (default 10)",
                 "MINUTES");
  command.flag(kVisitors, "--pause-when-alone", setup->pause_when_alone,
               "the simulation waits while nobody looks");
  command.option(kVisitors, "--root", setup->root,
                 "folder of all files that are saved and uploaded (default: a new one that goes at the end)",
                 "FOLDER");
  command.flag(kVisitors, "--play", setup->play, "start at once");
  command.option(kPicture, "--size", setup->size,
                 "pixels of the window before a page asks for its own (default 1280x720)", "WxH");
  command.option(kSimulation, "--past", setup->past,
                 "for states of the past of each simulation (default 256)", "MB");
  command.backend(setup->backend);
  command.simulation(setup->common);
  command.carry_out(action, setup, checked);
}

}  // namespace pabd::cli
