// Every peak is measured in a process of its own: this program once more, which does nothing but
// that refinement and prints its peak.
#include <unistd.h>

#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <tbb/global_control.h>

#include "cases.h"
#include "limn/contract.h"
#include "limn/subdivision/label_subdivision.h"
#include "memory.h"
#include "meshes.h"
#include "paintings.h"
#include "peers/subdivider.h"

namespace limn::bench {
namespace {

/// A refinement's peak in bytes, and the faces it made.
struct Peak {
  std::size_t bytes = 0;
  std::size_t faces = 0;
};

Peak uniform_peak(const std::string& program, const Work& work) {
  const ControlMesh& mesh = control_mesh(work.mesh);
  const std::unique_ptr<Subdivider> subdivider = make_subdivider(program, mesh, work.rules);
  subdivider->prepare();
  const std::size_t bytes = peak_of([&] { subdivider->refine(work.levels); });
  LIMN_EXPECTS(subdivider->counts() == uniform_counts(mesh, work));
  return {bytes, subdivider->counts().faces};
}

Peak painting_peak(const Painting& painting) {
  const ControlMesh& mesh = control_mesh(kLargestMesh);
  const VertexLabels labels = legal_labels_of(mesh, painting);
  IgnoreProgress progress;
  RefinedMesh result;
  const std::size_t bytes =
      peak_of([&] { result = refine(mesh, labels, {}, {}, progress).value(); });
  return {bytes, result.face_count()};
}

/// What a case is called, and how its peak is measured.
struct PeakCase {
  std::string name;
  std::function<Peak()> measure;
};

std::vector<PeakCase> peak_cases(Extent extent) {
  std::vector<PeakCase> cases;
  std::vector<Work> works = large_works();
  works.push_back(loop_works().front());
  for (const Work& work : works) {
    for (const std::string program : {"limn", "opensubdiv", "openmesh", "cgal"}) {
      if (extent == Extent::kAll || program == "limn" || program == "opensubdiv") {
        cases.push_back({"memory/" + path_of(work) + "/" + program,
                         [=] { return uniform_peak(program, work); }});
      }
    }
  }
  for (const Painting& painting : deepest_paintings()) {
    if (extent == Extent::kAll || painting.layout == Layout::kPatches) {
      cases.push_back(
          {"memory/" + path_of(painting) + "/limn", [=] { return painting_peak(painting); }});
    }
  }
  return cases;
}

Peak measure_in_own_process(const std::string& name) {
  const std::string command = "/proc/" + std::to_string(getpid()) + "/exe " + kPeakOption + name;
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), &pclose);
  Peak peak;
  if (pipe == nullptr || std::fscanf(pipe.get(), "%zu %zu", &peak.bytes, &peak.faces) != 2) {
    return {};
  }
  return peak;
}

}  // namespace

bool print_peak(std::string_view name) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  for (const PeakCase& peak_case : peak_cases(Extent::kAll)) {
    if (peak_case.name == name) {
      const Peak peak = peak_case.measure();
      std::printf("%zu %zu\n", peak.bytes, peak.faces);
      return true;
    }
  }
  return false;
}

void register_memory(Extent extent) {
  for (const PeakCase& peak_case : peak_cases(extent)) {
    add_case(peak_case.name, 1, [name = peak_case.name](benchmark::State& state) {
      Peak peak;
      time_run(state, [&] { peak = measure_in_own_process(name); });
      if (peak.bytes == 0) {
        fail_run(state, "peak memory could not be measured");
      }
      state.counters["peak_bytes"] = static_cast<double>(peak.bytes);
      state.counters["faces"] = static_cast<double>(peak.faces);
    });
  }
}

}  // namespace limn::bench
