// SPDX-License-Identifier: MIT
// pabd serve at work: see serve_setup.h and app/serve.
#include <fcntl.h>
#include <fmt/format.h>
#include <stdlib.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "app/cli/device_option.h"
#include "app/cli/interrupt.h"
#include "app/cli/scene_lookup.h"
#include "app/cli/serve_setup.h"
#include "app/cli/streams.h"
#include "app/serve/http_server.h"
#include "sim/base/descriptor.h"
#include "sim/base/error.h"
#include "sim/base/utf8.h"

namespace pabd::cli {
namespace {

namespace fs = std::filesystem;

constexpr int kPort = 8472, kTries = 20;

// The folder of the visitors' files: one that stays, or a new one that goes with the object.
class Root {
 public:
  explicit Root(const std::string& named) : folder_(named), kept_(!named.empty()) {
    std::error_code failure;
    if (kept_) {
      fs::create_directories(folder_, failure);
      if (failure) throw Error(ErrorKind::file, named, "cannot be made: " + failure.message());
      return;
    }
    remove_left();
    // Another server that begins now may take it for one that was left: then there is another one.
    for (int attempt = 0; attempt < kTries && !lock_; ++attempt) {
      if (attempt > 0) fs::remove(folder_, failure);
      std::string name = (fs::temp_directory_path() / (std::string(kTemporary) + "XXXXXX")).string();
      if (!::mkdtemp(name.data()))
        throw Error(ErrorKind::file, name, "cannot be made; --root names a folder");
      folder_ = name;
      lock_ = lock_of(folder_);
    }
  }
  ~Root() {
    std::error_code ignored;
    if (!kept_) fs::remove_all(folder_, ignored);
  }
  Root(const Root&) = delete;
  Root& operator=(const Root&) = delete;
  const fs::path& folder() const { return folder_; }

 private:
  static constexpr std::string_view kTemporary = ".pabd-serve-";  // nobody calls his own so

  // Held as long as the server lives, however it ends. None: it is another's.
  static std::optional<Descriptor> lock_of(const fs::path& folder) {
    Descriptor out(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC | O_NOFOLLOW));
    struct stat info;
    const bool ours = out.get() >= 0 && ::fstat(out.get(), &info) == 0 && info.st_uid == ::geteuid();
    if (!ours || ::flock(out.get(), LOCK_EX | LOCK_NB) != 0) return std::nullopt;
    return out;
  }

  // Of servers that were killed.
  static void remove_left() {
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(fs::temp_directory_path(), ignored)) {
      if (!entry.path().filename().string().starts_with(kTemporary)) continue;
      if (lock_of(entry.path())) fs::remove_all(entry.path(), ignored);
    }
  }

  fs::path folder_;
  bool kept_;
  std::optional<Descriptor> lock_;
};

bool only_here(const std::string& address) { return address.starts_with("127.") || address == "::1"; }

std::string own_name() {
  char name[256] = {};
  return ::gethostname(name, sizeof name - 1) == 0 ? name : "localhost";
}

ServerOptions server_options(const ServeSetup& setup) {
  ServerOptions out;
  out.addresses = setup.addresses;
  out.hosts = setup.hosts;
  out.port = setup.port.value_or(kPort);
  out.tries = setup.port ? 1 : kTries;
  out.certificate = setup.certificate;
  out.key = setup.key;
  out.embed = setup.embed;
  out.tokens.watchers = !setup.no_watchers && setup.sessions == 1;
  for (const std::string& address : setup.addresses) {
    if (only_here(address)) continue;
    if (!setup.trusted && setup.certificate.empty())
      throw Error(
          ErrorKind::bad_input,
          fmt::format("--listen {}: everybody on that network could read the link's token and control the "
                      "window; give --tls-cert and --tls-key, or --i-know for a network that you trust",
                      one_line(address)));
    if (address == "0.0.0.0" || address == "::") out.hosts.push_back(own_name());
  }
  return out;
}

// A shipped scene by its name, or the file that the list of scenes shows. Nothing else is looked at.
std::string shipped_scene(const std::string& name) {
  for (const fs::path& scene : shipped_scenes()) {
    std::error_code none;
    const bool same = scene.stem() == name || scene.filename() == name ||
                      (name.starts_with('/') && fs::equivalent(scene, name, none));
    if (same) return scene.string();
  }
  throw Error(
      ErrorKind::file, name,
      "there is no such scene here; expected the name of a shipped scene, or of a file that was uploaded");
}

LobbyOptions lobby_options(const ServeSetup& setup, const Root& root, const AccessTokens& tokens) {
  LobbyOptions out;
  if (tokens.watchers) out.watch_token = tokens.watch.hex();
  out.sessions = setup.sessions;
  out.idle_limit = 60 * setup.idle_limit;
  out.keep_files = !setup.root.empty();
  out.version = PABD_VERSION;
  const FrameSize size = parse_size(setup.size);
  DeskOptions& desk = out.desk;
  desk.scene = fs::absolute(find_scene(setup.scene)).string();
  desk.sets = setup.common.sets;
  desk.threads = std::max(1, setup.common.thread_count() / setup.sessions);
  desk.memory = static_cast<std::size_t>(setup.past * kBytesPerMegabyte);
  desk.backend = parse_backend(setup.backend);
  desk.devices = [backend = desk.backend](std::shared_ptr<SharedContext> drawing) {
    return gpu_devices(backend, std::move(drawing));
  };
  desk.files = std::make_shared<FileRoot>(root.folder());
  desk.find_scene = shipped_scene;
  desk.shipped_scenes = [] { return shipped_scenes(); };
  for (const fs::path& folder : scene_folders()) desk.mesh_folders.push_back(folder.parent_path() / "meshes");
  desk.turn = std::make_shared<std::mutex>();
  desk.play = setup.play;
  desk.pause_when_alone = setup.pause_when_alone;
  desk.width = size.width;
  desk.height = size.height;
  return out;
}

}  // namespace

int serve(const ServeSetup& setup) {
  const ServerOptions options = server_options(setup);
  const InterruptGuard interrupt;
  const Root root(setup.root);
  HttpServer server(options, lobby_options(setup, root, options.tokens));
  write_stdout(server.url() + "#k=" + options.tokens.control.hex() + "\n");
  if (options.tokens.watchers)
    write_stdout("watch: " + server.url() + "#k=" + options.tokens.watch.hex() + "\n");
  if (!setup.common.quiet) write_note("open the link in a browser; Ctrl-C ends it");
  server.run([&] { return interrupt.requested(); });
  return 0;
}

}  // namespace pabd::cli
