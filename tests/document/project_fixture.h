#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "limn/document/project_file.h"
#include "support/scratch_folder.h"

namespace limn::test {

/// A bundled mesh, unpainted.
[[nodiscard]] Document opened(std::string_view name);

/// Fails the test where anything that a project holds differs, to the last bit.
void expect_same_document(const Document& a, const Document& b);

/// A project's text as older programs wrote it.
[[nodiscard]] std::string without_checksum(std::string text);

/// A project file in a folder of its own.
class ProjectFixture : public ::testing::Test {
 protected:
  /// What loading this text complains about, as a person would read it.
  std::string complaint(std::string_view text);

  /// A painted cube as text, without a checksum: any change of it is judged for itself.
  std::string cube_text();

  /// The cube's text with one piece of it replaced, and what loading it complains about.
  std::string complaint_with(std::string_view piece, std::string_view other);

  ScratchFolder folder_;
  std::filesystem::path path_ = folder_ / "test.limn";
  std::size_t line_ = 0;
};

}  // namespace limn::test
