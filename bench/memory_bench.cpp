#include <string>
#include <vector>

#include "cases.h"
#include "memory.h"
#include "meshes.h"

namespace limn::bench {

void register_memory(Extent extent) {
  std::vector<std::string> programs = {"limn", "opensubdiv"};
  if (extent == Extent::kAll) {
    programs.insert(programs.end(), {"openmesh", "cgal"});
  }
  for (const Work& work : large_works()) {
    for (const std::string& program : programs) {
      add_case("memory/" + path_of(work) + "/" + program, 1, [=](benchmark::State& state) {
        std::size_t peak = 0;
        time_run(state, [&] { peak = measure_peak(program, work); });
        if (peak == 0) {
          fail_run(state, "peak memory could not be measured");
        }
        state.counters["peak_bytes"] = static_cast<double>(peak);
        state.counters["faces"] =
            static_cast<double>(uniform_counts(control_mesh(work.mesh), work.levels).faces);
      });
    }
  }
}

}  // namespace limn::bench
