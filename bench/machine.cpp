#include "machine.h"

#include <sys/utsname.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <string>
#include <thread>

#include <CGAL/version.h>
#include <OpenMesh/Core/System/config.h>
#include <benchmark/benchmark.h>
#include <opensubdiv/version.h>

namespace limn::bench {
namespace {

/// What follows `key` and a colon in /proc/cpuinfo; the first such line.
std::string processor_field(const std::string& key) {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with(key)) {
      const std::size_t colon = line.find(": ");
      return colon == std::string::npos ? "" : line.substr(colon + 2);
    }
  }
  return "unknown";
}

std::string first_line(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  return std::getline(file, line) ? line : "unknown";
}

std::string memory() {
  const double bytes =
      static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  return std::to_string(std::lround(bytes / (1 << 30))) + " GiB";
}

std::string system_name() {
  utsname name{};
  uname(&name);
  return std::string(name.sysname) + " " + name.release + " " + name.machine;
}

}  // namespace

void describe_machine() {
  using benchmark::AddCustomContext;
  AddCustomContext("processor", processor_field("model name"));
  AddCustomContext("processor_family", processor_field("cpu family"));
  AddCustomContext("cores", std::to_string(std::thread::hardware_concurrency()));
  AddCustomContext("memory", memory());
  AddCustomContext("system", system_name());
  AddCustomContext("huge_pages", first_line("/sys/kernel/mm/transparent_hugepage/enabled"));
  AddCustomContext("compiler", "g++ " __VERSION__);
  AddCustomContext("opensubdiv", std::to_string(OPENSUBDIV_VERSION_MAJOR) + "." +
                                     std::to_string(OPENSUBDIV_VERSION_MINOR));
  AddCustomContext("openmesh", std::to_string(OM_GET_VER) + "." + std::to_string(OM_GET_MAJ >> 8));
  AddCustomContext("cgal", CGAL_STR(CGAL_VERSION));
}

}  // namespace limn::bench
