#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn_program.h"

namespace limn::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(CommandLine, HelpListsTheSubcommandsAndSucceeds) {
  const ProgramRun run = limn({"--help"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.out, AllOf(HasSubstr("refine"), HasSubstr("render"), HasSubstr("info")));
}

TEST(CommandLine, EverySubcommandHasHelp) {
  for (const char* command : {"refine", "render", "info"}) {
    const ProgramRun run = limn({command, "--help"});
    EXPECT_EQ(run.exit_code, 0) << command;
    EXPECT_THAT(run.out, HasSubstr("IN")) << command;
  }
}

TEST(CommandLine, MistakesAreUsageErrorsOnStandardError) {
  const std::vector<std::vector<std::string>> mistakes = {
      {"refine"},
      {"refine", "cube", "--no-such-option"},
      {"refine", "cube", "--paint", "everything:+1"},
      {"refine", "cube", "--paint", "all"},
      {"refine", "cube", "--paint", "@no-such-file"},
      {"refine", "cube", "--legalize", "lavish"},
      {"refine", "cube", "--levels", "-1"},
      {"refine", "cube", "--json", "-o", "-"},
      {"refine", "cube", "--size", "640"},
      {"refine", "cube", "--view", "sideways"},
      {"refine", "cube", "-o", "out.fbx"},
      {"info"},
  };
  for (const auto& arguments : mistakes) {
    const ProgramRun run = limn(arguments);
    EXPECT_EQ(run.exit_code, 2) << testing::PrintToString(arguments);
    EXPECT_THAT(run.out, IsEmpty()) << testing::PrintToString(arguments);
    EXPECT_THAT(run.err, testing::Not(IsEmpty())) << testing::PrintToString(arguments);
  }
}

TEST(CommandLine, AFaceOutOfRangeIsAUsageErrorThatNamesIt) {
  const ProgramRun run = limn({"refine", "cube", "--paint", "faces=6:+1"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, HasSubstr("6"));
}

TEST(CommandLine, BadInputNamesFileAndLine) {
  const ScratchFolder scratch;
  const std::string path = scratch.file("bad.obj");
  write_file(path, "v 0 0 0\nv 1 0 0\nv 0 1 0\n\nf 1 2 9\n");
  for (const char* command : {"refine", "info", "render"}) {
    std::vector<std::string> arguments = {command, path};
    if (command == std::string("render")) {
      arguments.insert(arguments.end(), {"-o", scratch.file("out.png")});
    }
    const ProgramRun run = limn(arguments);
    EXPECT_EQ(run.exit_code, 3) << command;
    EXPECT_THAT(run.err, HasSubstr(path + ":5: ")) << command;
    EXPECT_THAT(run.out, IsEmpty()) << command;
  }
}

TEST(CommandLine, AMissingFileListsTheBundledMeshes) {
  const ProgramRun run = limn({"info", "no-such-mesh.obj"});
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_THAT(run.err, AllOf(HasSubstr("no-such-mesh.obj"), HasSubstr("creature")));
}

}  // namespace
}  // namespace limn::test
