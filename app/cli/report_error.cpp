// SPDX-License-Identifier: MIT
// See report_error.h.
#include "app/cli/report_error.h"

#include <new>
#include <system_error>

#include "app/cli/exit_code.h"
#include "app/cli/streams.h"

namespace pabd::cli {

int report_error(ErrorKind kind, const std::string& message) {
  write_note("pabd: error: " + message);
  return exit_code(kind);
}

int report_error(const std::exception_ptr& thrown) {
  try {
    std::rethrow_exception(thrown);
  } catch (const Error& error) {
    return report_error(error.kind(), error.what());
  } catch (const std::bad_alloc&) {
    return report_error(ErrorKind::file,
                        "out of memory; free some, or try a smaller scene, frame, file or --memory");
  } catch (const std::system_error& error) {  // a file, a folder, a thread
    if (error.code() == std::errc::resource_unavailable_try_again)
      return report_error(
          ErrorKind::file,
          "no thread could be started: allow more processes (ulimit -u) or memory, or try --threads 1");
    return report_error(ErrorKind::file, std::string("the system refused: ") + error.what());
  } catch (const std::exception& error) {
    return report_error(ErrorKind::defect,
                        std::string("a defect in the program: ") + error.what() +
                            "; please report this line, the command line, the scene file and 'pabd doctor'");
  }
}

}  // namespace pabd::cli
