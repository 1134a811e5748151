// Includes are expanded depth first. `#line LINE FILE` keeps the driver's messages true: FILE
// counts the files in the order they are first included, the shader itself being 0.
#include "render/shader_library.h"

#include <algorithm>
#include <array>
#include <vector>

#include <fmt/format.h>

#include "embedded/shaders.h"
#include "limn/contract.h"

namespace limn::render {
namespace {

std::string_view embedded(std::string_view name) {
  const auto files = shaders::files();
  const auto found = std::find_if(files.begin(), files.end(),
                                  [name](const auto& file) { return file.name == name; });
  LIMN_EXPECTS(found != files.end());
  return found->text;
}

void expand(std::string_view name, std::vector<std::string_view>& seen, std::string& out) {
  constexpr std::string_view kInclude = "#include \"";
  const std::size_t number = seen.size();
  seen.push_back(name);
  std::string_view rest = embedded(name);
  for (int line = 1; !rest.empty(); ++line) {
    const std::size_t end = rest.find('\n');
    const std::string_view text = rest.substr(0, end);
    rest = end == std::string_view::npos ? "" : rest.substr(end + 1);
    if (!text.starts_with(kInclude)) {
      out += text;
      out += '\n';
      continue;
    }
    const std::size_t quote = text.find('"', kInclude.size());
    LIMN_EXPECTS(quote != std::string_view::npos);
    const std::string_view file = text.substr(kInclude.size(), quote - kInclude.size());
    if (std::find(seen.begin(), seen.end(), file) == seen.end()) {
      out += fmt::format("#line 1 {}\n", seen.size());
      expand(file, seen, out);
    }
    out += fmt::format("#line {} {}\n", line + 1, number);
  }
}

gl::ShaderStage stage(GLenum type, std::string_view name) {
  return {type, std::string(name), shader_source(name)};
}

}  // namespace

std::string shader_source(std::string_view name) {
  std::vector<std::string_view> seen;
  std::string text;
  expand(name, seen, text);
  return text;
}

gl::ShaderProgram load_program(std::string_view vertex, std::string_view fragment) {
  const std::array stages{stage(GL_VERTEX_SHADER, vertex), stage(GL_FRAGMENT_SHADER, fragment)};
  return gl::ShaderProgram::link(fragment, stages);
}

gl::ShaderProgram load_compute_program(std::string_view compute, std::string_view macro) {
  std::array stages{stage(GL_COMPUTE_SHADER, compute)};
  if (!macro.empty()) {
    // After the version, which must come first.
    std::string& source = stages.front().source;
    source.insert(source.find('\n') + 1, fmt::format("#define {}\n#line 2 0\n", macro));
  }
  return gl::ShaderProgram::link(compute, stages);
}

}  // namespace limn::render
