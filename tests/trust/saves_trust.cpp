// Measures what is promised of saving, of work that is not saved, and of limits. Children that are
// to be killed are this program again, with --save or --work.
#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numeric>
#include <random>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>

#include "app/recovery_store.h"
#include "app/session.h"
#include "files/failing_calls.h"
#include "limn/document/memory_budget.h"
#include "limn/document/project_file.h"
#include "limn/document/refinement.h"
#include "limn/files/atomic_file.h"
#include "limn/mesh/bundled.h"
#include "limn/mesh/export.h"
#include "limn/mesh/import.h"
#include "promise.h"
#include "support/scratch_folder.h"
#include "support/shapes.h"

namespace limn::trust {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// --- processes that are killed

pid_t start(const std::vector<std::string>& arguments) {
  const pid_t child = ::fork();
  if (child == 0) {
    std::vector<char*> words;
    std::string name = "/proc/self/exe";
    words.push_back(name.data());
    std::vector<std::string> copies = arguments;
    for (std::string& word : copies) {
      words.push_back(word.data());
    }
    words.push_back(nullptr);
    ::execv(name.c_str(), words.data());
    ::_exit(127);
  }
  return child;
}

/// False where it had ended by itself.
bool kill_and_wait(pid_t child) {
  ::kill(child, SIGKILL);
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL;
}

Document document_to_save() {
  Document document = make_document(load_bundled_mesh("creature").value(), "creature");
  document.depths.set(7, 3);
  return document;
}

Result<void> save(const fs::path& path, const Document& document) {
  return path.extension() == ".limn"
             ? save_project(path, document, std::nullopt)
             : export_mesh(path, *document.control, {.depths = document.depths.values()});
}

/// Saves over and over until it is killed.
int save_for_ever(const fs::path& path) {
  const Document document = document_to_save();
  while (save(path, document)) {
  }
  return 1;
}

std::size_t faces_in(const fs::path& path) {
  if (path.extension() == ".limn") {
    const Result<Project> project = load_project(path);
    return project ? project->document.control->face_count() : 0;
  }
  const Result<ImportedMesh> mesh = import_mesh(path);
  return mesh ? mesh->mesh->face_count() : 0;
}

void measure_kills(Promises& promises) {
  constexpr int kills = 500;
  std::mt19937 random(500);
  for (const char* ending : {"obj", "ply", "off", "stl", "limn"}) {
    const test::ScratchFolder scratch;
    const fs::path path = scratch.path() / (std::string("mesh.") + ending);
    if (!save(path, document_to_save())) {
      promises.tell(fmt::format("Kills while a {} is saved", ending), "cannot save", "0 bad",
                    false);
      continue;
    }
    const std::size_t faces = faces_in(path);
    int bad = 0;
    for (int i = 0; i < kills; ++i) {
      const pid_t child = start({"--save", path.string()});
      std::this_thread::sleep_for(std::chrono::microseconds(15000 + random() % 40000));
      bad += kill_and_wait(child) && faces > 0 && faces_in(path) == faces ? 0 : 1;
    }
    const bool is_swept = save(path, document_to_save()).has_value() &&
                          std::distance(fs::directory_iterator(scratch.path()), {}) == 1;
    promises.tell(fmt::format("Kills while a .{} is saved", ending),
                  fmt::format("{} of {} left a bad file; leftovers {}", bad, kills,
                              is_swept ? "swept" : "stay"),
                  "0 of 500", bad == 0 && is_swept);
  }
}

// --- failures

void measure_failing_calls(Promises& promises) {
  const test::ScratchFolder scratch;
  const fs::path path = scratch.path() / "mesh.limn";
  const Document document = document_to_save();
  test::write_file(path, "old");
  test::forget_calls();
  bool holds = save(path, document).has_value();
  const auto calls = test::counted_calls();
  int failures = 0;
  for (std::size_t kind = 0; kind < calls.size(); ++kind) {
    const auto call = static_cast<test::Call>(kind);
    const int most = call == test::Call::kClose ? 1 : calls.at(kind);
    for (int nth = 1; nth <= most; ++nth, ++failures) {
      test::write_file(path, "old");
      const test::FailingCall fails(call, nth, EIO);
      const Result<void> saved = save(path, document);
      holds = holds && !saved &&
              saved.error().message.find("Input/output error") != std::string::npos &&
              test::read_file(path) == "old";
    }
  }
  promises.tell("Every failing write, fsync, close, rename is told and leaves the old file",
                fmt::format("{} failures, {}", failures, holds ? "all so" : "not all so"), "all",
                holds && failures > 0);
}

/// In a process of its own, which returns 77 where it may not do so.
std::string in_child(const std::function<int()>& work, bool& holds) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::_exit(work());
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  holds = code == 0;
  return code == 0    ? "an error with the reason, the old file intact"
         : code == 77 ? "not allowed here"
                      : "broken";
}

bool keeps_old(const fs::path& path, const std::string& reason) {
  const Result<void> saved = save(path, document_to_save());
  return !saved && saved.error().message.find(reason) != std::string::npos &&
         test::read_file(path) == "old";
}

void measure_trouble(Promises& promises) {
  const test::ScratchFolder scratch;
  bool holds = false;
  std::string told = in_child(
      [&] {
        const fs::path disk = scratch.path() / "disk";
        fs::create_directory(disk);
        if (::unshare(CLONE_NEWNS) != 0 ||
            ::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0 ||
            ::mount("none", disk.c_str(), "tmpfs", 0, "size=40k") != 0) {
          return 77;
        }
        test::write_file(disk / "mesh.limn", "old");
        return keeps_old(disk / "mesh.limn", "No space left") ? 0 : 1;
      },
      holds);
  promises.tell("A full disk (tmpfs of 40 kB)", told, "told, old file intact", holds);
  test::write_file(scratch.path() / "mesh.limn", "old");
  told = in_child(
      [&] {
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit small{20000, 20000};
        ::setrlimit(RLIMIT_FSIZE, &small);
        return keeps_old(scratch.path() / "mesh.limn", "File too large") ? 0 : 1;
      },
      holds);
  promises.tell("A limit on the size of files", told, "told, old file intact", holds);
  fs::permissions(scratch.path(), fs::perms(0555));
  told = in_child(
      [&] {
        constexpr uid_t nobody = 65534;
        if (::geteuid() == 0 && (::setgid(nobody) != 0 || ::setuid(nobody) != 0)) {
          return 77;
        }
        return keeps_old(scratch.path() / "mesh.limn", "Permission denied") ? 0 : 1;
      },
      holds);
  fs::permissions(scratch.path(), fs::perms(0755));
  promises.tell("A read-only folder", told, "told, old file intact", holds);
}

// --- damage

std::string text_of(const Project& project) {
  std::ostringstream out;
  write_project(out, project.document, project.view);
  return out.str();
}

void measure_damage(Promises& promises) {
  Document document = make_document(load_bundled_mesh("cube").value(), "cube");
  document.depths.set(2, 3);
  const std::string text = text_of({document, ViewState{}});
  std::size_t tried = 0;
  std::size_t wrong = 0;
  const auto look = [&](const std::string& damaged) {
    const Result<Project> project = parse_project(damaged, "damaged");
    ++tried;
    wrong += project && text_of(*project) != text ? 1 : 0;
  };
  for (std::size_t length = 0; length < text.size(); ++length) {
    look(text.substr(0, length));
  }
  for (std::size_t bit = 0; bit < 8 * text.size(); ++bit) {
    std::string damaged = text;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << bit % 8));
    look(damaged);
  }
  promises.tell("Every truncation and every flipped bit of a project is refused or right",
                fmt::format("{} of {} wrong", wrong, tried), "0", wrong == 0);
}

// --- work that was not saved

int painted(const Document& document) {
  const auto depths = document.depths.values();
  return std::accumulate(depths.begin(), depths.end(), 0);
}

/// Paints until it is killed, with a clock of its own. Before each operation its time is written
/// down, so that the n-th line belongs to the operation after which n faces are painted.
int work_for_ever(const fs::path& common, const fs::path& log, unsigned seed) {
  std::mt19937 random(seed);
  app::Session session({[] {}, {}, common});
  session.perform({ui::ActionId::kOpenBundled, std::string("creature")});
  session.perform(ui::ActionId::kSubdivide);
  const auto faces = static_cast<unsigned>(session.document().control->face_count());
  const int file = ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND, 0600);
  double now = 0.0;
  for (unsigned i = 0;; ++i) {
    const std::string line = fmt::format("{}\n", now);
    if (::write(file, line.data(), line.size()) < 0) {
      return 1;
    }
    session.begin_stroke(DepthChange::add(1));
    const std::uint32_t face = i % faces;
    session.touch(std::span(&face, 1));
    session.end_stroke();
    session.update(now);
    // The main loop wakes when the session wants it to, not only at the next operation.
    const double next = now + static_cast<double>(random() % 20);
    for (int wakes = 0; wakes < 100 && session.next_update() < next; ++wakes) {
      now = std::max(now, session.next_update());
      session.update(now);
      session.finish_autosave();
    }
    now = next;
    session.update(now);
    if (random() % 3 == 0) {
      session.finish_refinement();
    }
    session.finish_autosave();
    session.update(now);
  }
}

void measure_recovery(Promises& promises) {
  constexpr int kills = 100;
  std::mt19937 random(100);
  int bad = 0;
  double most_seconds = 0.0;
  int most_operations = 0;
  for (int i = 0; i < kills; ++i) {
    const test::ScratchFolder scratch;
    const fs::path common = scratch.path() / "recovery";
    const fs::path log = scratch.path() / "log";
    const pid_t child = start({"--work", common.string(), log.string(), std::to_string(random())});
    std::this_thread::sleep_for(std::chrono::milliseconds(50 + random() % 600));
    if (!kill_and_wait(child)) {
      ++bad;
      continue;
    }
    std::vector<double> times;
    std::ifstream in(log);
    for (double time = 0.0; in >> time;) {
      times.push_back(time);
    }
    const std::vector<app::LostWork> lost = app::find_lost_work(common);
    std::size_t kept = 0;
    if (!lost.empty()) {
      const Result<Project> project = app::load_lost_work(lost.front());
      if (!project) {
        ++bad;
        continue;
      }
      kept = static_cast<std::size_t>(painted(project->document));
    }
    const std::size_t operations = times.size() - std::min(kept, times.size());
    const double seconds = operations == 0 ? 0.0 : times.back() - times[kept];
    if (operations > 1) {
      most_seconds = std::max(most_seconds, seconds);
      most_operations = std::max(most_operations, static_cast<int>(operations));
      bad += seconds > app::Autosave::kSeconds ? 1 : 0;
    }
  }
  promises.tell("A kill loses at most 60 s of work or one operation",
                fmt::format("{} of {} lost more; at most {:.0f} s ({} operations)", bad, kills,
                            most_seconds, most_operations),
                "0 of 100", bad == 0);
}

// --- limits

/// Stops after so many seconds and remembers when it was first asked to.
class StopAfter final : public Progress {
 public:
  explicit StopAfter(double seconds) : seconds_(seconds) {}
  [[nodiscard]] bool report(double, std::string_view) override {
    return seconds_since(start_) < seconds_;
  }
  /// How long it went on after the stop was wanted; below 0 where it was done before.
  [[nodiscard]] double late() const { return seconds_since(start_) - seconds_; }

 private:
  Clock::time_point start_ = Clock::now();
  double seconds_;
};

void measure_limits(Promises& promises) {
  const auto mesh = load_bundled_mesh("creature").value().mesh;
  std::mt19937 random(3);
  std::size_t wrong = 0;
  constexpr int paintings = 50;
  for (int i = 0; i < paintings; ++i) {
    const auto depths = test::random_depths(*mesh, (i % 10) / 9.0, 4, random);
    IgnoreProgress progress;
    const DerivedLabels labels = derive_labels(*mesh, depths, {}, progress).value();
    const Refinement refined = derive_refinement(*mesh, labels, {}, progress).value();
    wrong += refined.prediction.faces == refined.mesh->face_count() &&
                     refined.prediction.bytes == refined.mesh->bytes()
                 ? 0
                 : 1;
  }
  promises.tell("Faces and bytes are foretold exactly",
                fmt::format("{} of {} paintings wrong", wrong, paintings), "0", wrong == 0);

  const std::vector<std::uint8_t> deepest(mesh->face_count(), 10);
  IgnoreProgress progress;
  const auto begin = Clock::now();
  const DerivedLabels labels = derive_labels(*mesh, deepest, {}, progress).value();
  RefinementOptions options;
  options.memory_budget = memory_budget();
  const auto refused = derive_refinement(*mesh, labels, options, progress);
  const double refusal = seconds_since(begin);
  promises.tell("What memory does not hold is refused with the number",
                fmt::format("{} faces, {}, in {:.3f} s", labels.prediction.faces,
                            memory_text(labels.prediction.bytes), refusal),
                "0.1 s",
                !refused && refused.error().kind == ErrorKind::kOverBudget && refusal < 0.1);

  const std::vector<std::uint8_t> deep(mesh->face_count(), 6);
  const auto six = derive_labels(*mesh, deep, {}, progress).value();
  double latest = 0.0;
  int stopped = 0;
  for (int i = 0; i < 60; ++i) {
    StopAfter stop(0.001 * static_cast<double>(random() % 400));
    const auto result = derive_refinement(*mesh, six, {}, stop);
    stopped += result ? 0 : 1;
    latest = std::max(latest, stop.late());
  }
  promises.tell("A refinement to 4.6 million faces that is cancelled ends",
                fmt::format("{} of 60 cancelled, the latest after {:.3f} s", stopped, latest),
                "0.2 s", stopped > 0 && latest < 0.2);
}

}  // namespace
}  // namespace limn::trust

int main(int argc, char** argv) {
  using namespace limn::trust;
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.size() == 2 && words[0] == "--save") {
    return save_for_ever(words[1]);
  }
  if (words.size() == 4 && words[0] == "--work") {
    return work_for_ever(words[1], words[2], static_cast<unsigned>(std::stoul(words[3])));
  }
  Promises promises;
  measure_limits(promises);
  measure_recovery(promises);
  measure_damage(promises);
  measure_failing_calls(promises);
  measure_trouble(promises);
  measure_kills(promises);
  return promises.exit_code();
}
