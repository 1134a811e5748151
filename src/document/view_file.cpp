#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "files/regular_file.h"
#include "limn/document/project_file.h"
#include "limn/files/atomic_file.h"
#include "view_json.h"

namespace limn {
namespace {

constexpr std::size_t kMostViewBytes = std::size_t{1} << 20U;
constexpr NumberRange kDistance{1e-300, 1e300};
constexpr NumberRange kPitch{-90.0, 90.0};
constexpr NumberRange kFieldOfView{0.01, 179.0};

bool is_within(double value, NumberRange range) {
  return value >= range.low && value <= range.high;
}

}  // namespace

std::string fault_of(const ViewState& view) {
  const bool is_finite = std::isfinite(view.target.x) && std::isfinite(view.target.y) &&
                         std::isfinite(view.target.z) && std::isfinite(view.yaw);
  if (!is_finite || !is_within(view.distance, kDistance) || !is_within(view.pitch, kPitch) ||
      !is_within(view.fov_degrees, kFieldOfView)) {
    return fmt::format(
        "The view cannot be saved: target {} {} {}, distance {}, yaw {}, pitch {}, field of view "
        "{}.",
        view.target.x, view.target.y, view.target.z, view.distance, view.yaw, view.pitch,
        view.fov_degrees);
  }
  return {};
}

std::string json_number(double value) {
  // As an integer, "-0" would lose its sign.
  return value == 0.0 && std::signbit(value) ? "-0.0" : fmt::format("{}", value);
}

std::string view_json(const ViewState& view, std::string_view indent) {
  return fmt::format(
      "{{\n"
      "{0}  \"target\": [{1}, {2}, {3}],\n"
      "{0}  \"distance\": {4},\n"
      "{0}  \"yaw\": {5},\n"
      "{0}  \"pitch\": {6},\n"
      "{0}  \"fov_degrees\": {7},\n"
      "{0}  \"orthographic\": {8}\n"
      "{0}}}",
      indent, json_number(view.target.x), json_number(view.target.y), json_number(view.target.z),
      json_number(view.distance), json_number(view.yaw), json_number(view.pitch),
      json_number(view.fov_degrees), view.orthographic);
}

ViewState read_view(FieldReader& fields, const std::string& prefix) {
  fields.expect_object(prefix);
  fields.expect_list(prefix + "/target", 3);
  ViewState view;
  view.target.x = fields.number(prefix + "/target/0");
  view.target.y = fields.number(prefix + "/target/1");
  view.target.z = fields.number(prefix + "/target/2");
  view.distance = fields.number(prefix + "/distance", kDistance);
  view.yaw = fields.number(prefix + "/yaw");
  view.pitch = fields.number(prefix + "/pitch", kPitch);
  view.fov_degrees = fields.number(prefix + "/fov_degrees", kFieldOfView);
  view.orthographic = fields.flag(prefix + "/orthographic");
  return view;
}

Result<ViewState> load_view(const std::filesystem::path& path) {
  const Result<std::string> text = read_regular_file(path, kMostViewBytes);
  if (!text) {
    return tl::unexpected(text.error());
  }
  const Result<ProjectText> parsed = parse_project_text(*text, path.string());
  if (!parsed) {
    return tl::unexpected(parsed.error());
  }
  FieldReader fields(parsed->fields, path.string());
  const ViewState view = read_view(fields, "");
  if (parsed->misfit || fields.error()) {
    return tl::unexpected(parsed->misfit ? *parsed->misfit : *fields.error());
  }
  return view;
}

Result<void> save_view(const std::filesystem::path& path, const ViewState& view) {
  if (std::string fault = fault_of(view); !fault.empty()) {
    return fail(ErrorKind::kFailed, std::move(fault), path.string());
  }
  return write_file_atomically(path,
                               [&](std::ostream& out) { out << view_json(view, "") << '\n'; });
}

}  // namespace limn
