// See report_error.h.
#include "app/cli/report_error.h"

#include <new>
#include <system_error>

#include "app/cli/streams.h"

namespace pabd::cli {

int report_error(ExitCode code, const std::string& message) {
  write_note("pabd: error: " + message);
  return static_cast<int>(code);
}

int report_error(const std::exception_ptr& thrown) {
  try {
    std::rethrow_exception(thrown);
  } catch (const Error& error) {
    return report_error(error.code(), error.what());
  } catch (const std::bad_alloc&) {
    return report_error(ExitCode::file,
                        "out of memory; free some, or try a smaller scene, frame, file or --memory");
  } catch (const std::system_error& error) {  // a file, a folder, a thread
    return report_error(ExitCode::file, std::string("the system refused: ") + error.what());
  } catch (const std::exception& error) {
    return report_error(ExitCode::defect,
                        std::string("a defect in the program: ") + error.what() +
                            "; please report this line, the command line, the scene file and 'pabd doctor'");
  }
}

}  // namespace pabd::cli
