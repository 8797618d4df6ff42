// SPDX-License-Identifier: MIT
// Convex hull by the qhull library, which nothing outside this file knows.
#include <csetjmp>
#include <cstdio>
#include <memory>

#include "sim/body/hull_parts.h"

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

namespace pabd::hull_parts {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

// The library's state, given back in every case.
class Qhull {
 public:
  explicit Qhull(std::FILE* messages) : qh_(std::make_unique<qhT>()), messages_(messages) {
    qh_zero(qh_.get(), messages);
  }
  ~Qhull() {
    int open_blocks = 0, open_bytes = 0;
    qh_freeqhull(qh_.get(), !qh_ALL);
    qh_memfreeshort(qh_.get(), &open_blocks, &open_bytes);
  }
  Qhull(const Qhull&) = delete;
  Qhull& operator=(const Qhull&) = delete;

  bool build(std::vector<double>& coordinates) {
    char command[] = "qhull Qt";  // Qt: every facet a triangle
    if (qh_new_qhull(qh_.get(), 3, static_cast<int>(coordinates.size() / 3), coordinates.data(), False,
                     command, nullptr, messages_) != 0) {
      return false;
    }
    return triangulate(qh_.get());
  }
  const qhT& state() const { return *qh_; }

 private:
  // The library leaves by longjmp when it fails; nothing in this frame needs a destructor.
  static bool triangulate(qhT* qh) {
    qh->NOerrexit = False;
    const int failure = setjmp(qh->errexit);
    if (failure == 0) qh_prepare_output(qh);
    qh->NOerrexit = True;
    return failure == 0;
  }

  std::unique_ptr<qhT> qh_;
  std::FILE* messages_;
};

}  // namespace

std::vector<Triangle> hull_triangles(const std::vector<Vec3>& points) {
  // The library reports to a file and never to us: the result is checked instead.
  const std::unique_ptr<std::FILE, CloseFile> nowhere(std::fopen("/dev/null", "w"));
  if (!nowhere) return {};
  std::vector<double> coordinates;
  coordinates.reserve(3 * points.size());
  for (const Vec3& p : points) coordinates.insert(coordinates.end(), p.data(), p.data() + 3);

  Qhull library(nowhere.get());
  if (!library.build(coordinates)) return {};
  const double* first = coordinates.data();
  std::vector<Triangle> triangles;
  for (const facetT* facet = library.state().facet_list; facet != nullptr && facet->next != nullptr;
       facet = facet->next) {
    const setT* corners = facet->vertices;
    Triangle t;
    int n = 0;
    for (void* const* place = &corners->e[0].p; *place != nullptr; ++place) {
      if (n == 3) return {};
      const auto offset = static_cast<const vertexT*>(*place)->point - first;
      if (offset < 0 || offset >= static_cast<std::ptrdiff_t>(coordinates.size())) return {};
      t[n++] = static_cast<int>(offset / 3);
    }
    if (n != 3) return {};
    if (facet->toporient != qh_ORIENTclock) std::swap(t[1], t[2]);
    triangles.push_back(t);
  }
  return triangles;
}

}  // namespace pabd::hull_parts
