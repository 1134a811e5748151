// Standard streams go through files of a scratch folder, so that no pipe can fill up and block.
#include "support/run_program.h"

#include <system_error>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "support/scratch_folder.h"

extern char** environ;

namespace limn::test {

ProgramRun run_program(const std::filesystem::path& program,
                       const std::vector<std::string>& arguments, const std::string& input) {
  const ScratchFolder scratch;
  write_file(scratch.file("in"), input);

  posix_spawn_file_actions_t streams;
  posix_spawn_file_actions_init(&streams);
  posix_spawn_file_actions_addopen(&streams, STDIN_FILENO, scratch.file("in").c_str(), O_RDONLY, 0);
  constexpr int kNew = O_WRONLY | O_CREAT | O_TRUNC;
  posix_spawn_file_actions_addopen(&streams, STDOUT_FILENO, scratch.file("out").c_str(), kNew,
                                   0600);
  posix_spawn_file_actions_addopen(&streams, STDERR_FILENO, scratch.file("err").c_str(), kNew,
                                   0600);

  std::string name = program.string();
  std::vector<std::string> copies = arguments;
  std::vector<char*> argv{name.data()};
  for (std::string& copy : copies) {
    argv.push_back(copy.data());
  }
  argv.push_back(nullptr);

  pid_t child = 0;
  const int error = posix_spawn(&child, name.c_str(), &streams, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&streams);
  if (error != 0) {
    throw std::system_error(error, std::generic_category(), name);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
          read_file(scratch.file("out")), read_file(scratch.file("err"))};
}

}  // namespace limn::test
