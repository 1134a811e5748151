// Measures what is promised of reading and writing mesh files. Every file is read in a process of
// its own, so that a crash is counted and memory is what that file took.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include "child.h"
#include "limn/mesh/export.h"
#include "limn/mesh/import.h"
#include "promise.h"
#include "support/corpus.h"
#include "support/hostile_files.h"
#include "support/mesh_difference.h"
#include "support/scratch_folder.h"

namespace limn::trust {
namespace {

namespace fs = std::filesystem;

constexpr double Mebi = 1024.0 * 1024.0;

/// How much of 64 MiB and so many times the file's size a reading took.
double memory_share(const ChildRun& run, std::uintmax_t file_bytes, double times) {
  return static_cast<double>(run.peak_bytes) /
         (64.0 * Mebi + times * static_cast<double>(file_bytes));
}

constexpr double RefusedTimes = 20.0;
constexpr double ReadTimes = 40.0;  ///< Binary data of a mesh is a tenth of what it is connected.

ChildRun read_in_child(const fs::path& path) {
  return run_in_child([&] { return import_mesh(path).has_value(); });
}

struct Worst {
  std::size_t files = 0;
  std::size_t crashed = 0;
  std::size_t refused = 0;
  double seconds = 0.0;
  double memory = 0.0;
  std::string slowest;

  void add(const std::string& name, const ChildRun& run, std::uintmax_t bytes) {
    ++files;
    crashed += run.has_ended ? 0 : 1;
    if (run.seconds > seconds) {
      seconds = run.seconds;
      slowest = name;
    }
    if (!run.result) {
      ++refused;
      memory = std::max(memory, memory_share(run, bytes, RefusedTimes));
    }
  }
};

/// What is no file to read.
std::vector<fs::path> special_files(const fs::path& folder) {
  fs::create_directory(folder / "folder.obj");
  ::mkfifo((folder / "pipe.ply").c_str(), 0600);
  fs::create_symlink("/dev/zero", folder / "zero.stl");
  fs::create_symlink("loop.off", folder / "loop.off");
  std::ofstream(folder / "unreadable.obj") << "v 0 0 0\n";
  fs::permissions(folder / "unreadable.obj", fs::perms::none);
  return {
      folder / "folder.obj",     folder / "pipe.ply",    folder / "zero.stl", folder / "loop.off",
      folder / "unreadable.obj", folder / "missing.obj", "/dev/zero",         "/dev/null"};
}

bool has_lying_count(const std::string& name) {
  for (const char* beginning : {"vertices", "faces", "facets", "corners", "list", "elements"}) {
    if (name.starts_with(beginning)) {
      return true;
    }
  }
  return false;
}

void measure_hostile_files(Promises& promises) {
  const test::ScratchFolder scratch;
  Worst all;
  Worst counts;
  for (const test::HostileFile& file : test::hostile_files(20)) {
    const fs::path path = scratch.path() / file.name;
    std::ofstream(path, std::ios::binary) << file.bytes;
    const ChildRun run = read_in_child(path);
    all.add(file.name, run, file.bytes.size());
    if (has_lying_count(file.name)) {
      counts.add(file.name, run, file.bytes.size());
    }
    fs::remove(path);
  }
  for (const fs::path& path : special_files(scratch.path())) {
    all.add(path.string(), read_in_child(path), 0);
  }
  promises.tell("No hostile file crashes or hangs the readers",
                fmt::format("{} files, {} crashes, slowest {:.2f} s ({})", all.files, all.crashed,
                            all.seconds, all.slowest),
                "at least 150 files, 2 s each",
                all.files >= 150 && all.crashed == 0 && all.seconds < 2.0);
  promises.tell("Counts that lie are refused before anything is allocated",
                fmt::format("{} files, slowest {:.3f} s", counts.files, counts.seconds), "0.1 s",
                counts.seconds < 0.1);
  promises.tell(
      "Memory of what is refused",
      fmt::format("{} files, at most {:.0f} % of the bound", all.refused, 100 * all.memory),
      "64 MiB and 20 times the file", all.memory < 1.0);
}

/// A file of a size, and what makes it.
struct Shape {
  std::string name;
  std::string ending;
  std::size_t size;
  std::function<void(std::ostream&, std::size_t)> write;
};

void write_points(std::ostream& out, std::size_t n) {
  for (std::size_t i = 0; i < n; ++i) {
    out << fmt::format("v {} {} {}\n", i, i % 7, i % 5);
  }
}

void write_polygon(std::ostream& out, std::size_t n) {
  write_points(out, n);
  out << 'f';
  for (std::size_t i = 1; i <= n; ++i) {
    out << ' ' << i;
  }
  out << '\n';
}

void write_fan(std::ostream& out, std::size_t n) {
  write_points(out, n + 2);
  for (std::size_t i = 2; i < n + 2; ++i) {
    out << "f 1 " << i << ' ' << i + 1 << '\n';
  }
}

void write_comment(std::ostream& out, std::size_t n) {
  out << '#' << std::string(n, 'x') << "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
}

/// A square of about n quads.
void write_grid(std::ostream& out, std::size_t n, MeshFormat format) {
  RefinedMesh mesh;
  std::uint32_t side = 1;
  while (std::size_t{side} * side < n) {
    ++side;
  }
  for (std::uint32_t y = 0; y <= side; ++y) {
    for (std::uint32_t x = 0; x <= side; ++x) {
      mesh.positions.push_back(
          {0.1f * static_cast<float>(x), 0.1f * static_cast<float>(y), 0.01f * float(x * y % 97)});
    }
  }
  const std::uint32_t row = side + 1;
  for (std::uint32_t v = 0; v < row * side; ++v) {
    if (v % row != side) {
      mesh.quads.push_back({v, v + 1, v + row + 1, v + row});
    }
  }
  write_mesh(out, format, mesh);
}

std::vector<Shape> shapes() {
  std::vector<Shape> result{{"a polygon of 50,000 sides", ".obj", 50'000, write_polygon},
                            {"a vertex of valence 20,000", ".obj", 20'000, write_fan},
                            {"a comment of 20 MB", ".obj", 20'000'000, write_comment}};
  for (const MeshFormat format : MeshFormats) {
    result.push_back({fmt::format("a million faces as {}", name_of(format)),
                      std::string(ending_of(format)),
                      format == MeshFormat::kStl ? 500'000U : 1'000'000U,
                      [format](std::ostream& out, std::size_t n) { write_grid(out, n, format); }});
  }
  return result;
}

/// The best of three: what is measured is the work, not who else was there.
ChildRun best_of_three(const fs::path& path) {
  ChildRun best = read_in_child(path);
  for (int i = 0; i < 2; ++i) {
    const ChildRun again = read_in_child(path);
    best.seconds = std::min(best.seconds, again.seconds);
    best.has_ended = best.has_ended && again.has_ended;
  }
  return best;
}

void measure_shapes(Promises& promises) {
  const test::ScratchFolder scratch;
  for (const Shape& shape : shapes()) {
    ChildRun runs[2];
    double memory = 0.0;
    for (std::size_t i = 0; i < 2; ++i) {
      const fs::path path = scratch.path() / ("shape" + shape.ending);
      // Written by a child, so that this process stays small.
      static_cast<void>(run_in_child([&] {
        std::ofstream out(path, std::ios::binary);
        shape.write(out, (i + 1) * shape.size);
        return true;
      }));
      runs[i] = best_of_three(path);
      memory = std::max(memory, memory_share(runs[i], fs::file_size(path), ReadTimes));
      fs::remove(path);
    }
    // Below a hundredth of a second the start of a process is what is measured.
    const double ratio = runs[1].seconds / std::max(runs[0].seconds, 0.01);
    promises.tell(
        "Time and memory are linear: " + shape.name,
        fmt::format("{:.2f} s, at double size {:.2f} times that; memory {:.0f} % of the bound",
                    runs[0].seconds, ratio, 100 * memory),
        "2.5 times; 64 MiB and 40 times the file",
        ratio <= 2.5 && memory < 1.0 && runs[0].has_ended && runs[1].has_ended);
  }
}

void measure_writing(Promises& promises) {
  const test::ScratchFolder scratch;
  for (const MeshFormat format : MeshFormats) {
    const fs::path path = scratch.path() / "grid";
    const ChildRun run = run_in_child([&] {
      std::ofstream out(path, std::ios::binary);
      write_grid(out, 1'000'000, format);
      return true;
    });
    promises.tell(fmt::format("A million quads are written as {}", name_of(format)),
                  fmt::format("{:.2f} s", run.seconds), "5 s", run.has_ended && run.seconds < 5.0);
  }
}

std::string round_trip(const ControlMesh& mesh, MeshFormat format) {
  std::ostringstream out;
  write_mesh(out, format, mesh);
  const auto again = import_bytes(out.str(), format, "written");
  if (!again) {
    return to_string(again.error());
  }
  test::Compared compared{.names = format == MeshFormat::kObj};
  for (const std::string& lost : lost_in(format, mesh)) {
    compared.uvs = compared.uvs && lost.find("texture") == std::string::npos;
  }
  compared.sharpness = format != MeshFormat::kOff;
  return test::difference(mesh, *again->mesh, compared);
}

void measure_corpus(Promises& promises) {
  if (!test::corpus_folder()) {
    return;
  }
  std::size_t meshes = 0;
  std::size_t refused = 0;
  std::size_t mended = 0;
  std::size_t different = 0;
  for (const std::string ending : {".obj", ".ply", ".off", ".stl"}) {
    for (const fs::path& path : test::corpus_files(ending)) {
      const auto imported = import_mesh(path);
      if (!imported) {
        ++refused;
        continue;
      }
      ++meshes;
      mended += imported->report.is_mended() ? 1 : 0;
      for (const MeshFormat format : {MeshFormat::kObj, MeshFormat::kPly, MeshFormat::kOff}) {
        different += round_trip(*imported->mesh, format).empty() ? 0 : 1;
      }
    }
  }
  promises.tell(
      "Meshes from elsewhere come in, or are refused with the reason",
      fmt::format("{} read, {} of them mended with a report, {} refused", meshes, mended, refused),
      "every one", meshes > 0);
  promises.tell("What is written is read again to the last bit (OBJ, PLY, OFF)",
                fmt::format("{} meshes, {} differences", meshes, different), "none",
                different == 0);
}

int measure() {
  Promises promises;
  measure_hostile_files(promises);
  measure_shapes(promises);
  measure_writing(promises);
  measure_corpus(promises);
  return promises.exit_code();
}

}  // namespace
}  // namespace limn::trust

int main() {
  return limn::trust::measure();
}
