// One pass of the JSON parser's events with a stack of the containers that are open. Inside one of
// the long lists numbers go straight into flat arrays; everything else becomes a field with its
// path. Nothing is kept of what no version of the format has.
#include "json_lists.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <utility>
#include <variant>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limn/mesh/flat_topology.h"
#include "limn/subdivision/settings.h"

namespace limn {
namespace {

using nlohmann::json;

constexpr std::size_t kDeepestNesting = 32;
constexpr std::size_t kMostFields = 256;
constexpr std::size_t kLongestQuote = 120;

constexpr std::array<std::string_view, 19> kRootKeys{
    "format",      "version",      "name",        "mesh_path", "settings", "stage", "view",
    "depths",      "mesh",         "opened_mesh", "target",    "distance", "yaw",   "pitch",
    "fov_degrees", "orthographic", "scheme",      "checksum",  "demands"};

std::string shortened(std::string text) {
  if (text.size() > kLongestQuote) {
    std::size_t length = kLongestQuote;
    while (length > 0 && (static_cast<unsigned char>(text[length]) & 0xC0U) == 0x80U) {
      --length;  // Never cut a UTF-8 character in two.
    }
    text.resize(length);
    text += "...";
  }
  return text;
}

/// Leaves out the library's prefix, "[json.exception.parse_error.101] parse error at line 1, ...:
/// ".
std::string reason_of(const nlohmann::detail::exception& exception) {
  const std::string_view what = exception.what();
  const std::size_t bracket = what.find("] ");
  std::string_view reason = bracket == std::string_view::npos ? what : what.substr(bracket + 2);
  if (reason.substr(0, 14) == "parse error at") {
    const std::size_t colon = reason.find(": ");
    reason = colon == std::string_view::npos ? reason : reason.substr(colon + 2);
  }
  return shortened(std::string(reason));
}

/// One of a mesh's long lists: where it stands, where it goes, and what to say of misfits.
struct ListKind {
  std::string_view key;
  std::variant<NumberRows MeshLists::*, IndexRows MeshLists::*, TextList MeshLists::*,
               ChoiceList MeshLists::*>
      list;
  std::string_view element;    ///< What every element must be, of a row where there are rows.
  std::string_view row{};      ///< What every row must be,
  std::string_view entries{};  ///< what the elements of one are called, and what is wrong with
  std::string_view length{};   ///< another number of them.
  std::size_t row_length = 0;  ///< Of numbers; indices are three or more.

  [[nodiscard]] bool has_rows() const noexcept { return !row.empty(); }
};

constexpr std::string_view kName = "must be a name.";
constexpr std::string_view kNumber = "must be a number.";
constexpr std::string_view kChoice = "must be the number of a name, or -1 for none.";

constexpr std::array<ListKind, 14> kListKinds{{
    {"positions", &MeshLists::positions, kNumber, "must be a list of three numbers.", "coordinates",
     "a position has three.", 3},
    {"faces", &MeshLists::faces, "must be the number of a vertex: a whole number from 0 on.",
     "must be a list of vertex numbers.", "vertices", "a face has three or more."},
    {"uvs", &MeshLists::uvs, kNumber, "must be a list of two numbers.", "coordinates",
     "a texture point has two.", 2},
    {"face_uvs", &MeshLists::face_uvs,
     "must be the number of a texture point: a whole number from 0 on.",
     "must be a list of texture point numbers.", "texture points", "a face has three or more."},
    {"creases", &MeshLists::creases, kNumber,
     "must be a list of two vertex numbers and a sharpness.", "entries", "a crease has three.", 3},
    {"corners", &MeshLists::corners, kNumber, "must be a list of a vertex number and a sharpness.",
     "entries", "a corner has two.", 2},
    {"loose_vertices", &MeshLists::loose_vertices, kNumber, "must be a list of three numbers.",
     "coordinates", "a position has three.", 3},
    {"object_names", &MeshLists::object_names, kName},
    {"face_objects", &MeshLists::face_objects, kChoice},
    {"group_names", &MeshLists::group_names, kName},
    {"face_groups", &MeshLists::face_groups, kChoice},
    {"material_names", &MeshLists::material_names, kName},
    {"face_materials", &MeshLists::face_materials, kChoice},
    {"material_libraries", &MeshLists::material_libraries, kName},
}};

class Reader final : public nlohmann::json_sax<json> {
 public:
  Reader(std::string_view text, const std::string& source) : text_(text), source_(source) {}

  [[nodiscard]] Result<ProjectText> finish(bool is_parsed) && {
    if (!is_parsed) {
      return tl::unexpected(std::move(error_));
    }
    return std::move(out_);
  }

  bool null() override { return value(JsonNull{}); }
  bool boolean(bool v) override { return value(v); }
  bool number_integer(std::int64_t v) override { return value(v); }
  bool number_unsigned(std::uint64_t v) override { return value(v); }
  bool number_float(double v, const std::string&) override { return value(v); }
  bool string(std::string& v) override { return value(std::move(v)); }
  bool binary(json::binary_t&) override { return false; }  // No such thing in text.

  bool start_object(std::size_t) override { return open(false); }
  bool start_array(std::size_t) override { return open(true); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(std::string& name) override {
    levels_.back().key = std::move(name);
    return true;
  }

  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::detail::exception& exception) override {
    return stop_at(position, reason_of(exception));
  }

 private:
  struct Level {
    bool is_list = false;
    std::size_t begun = 0;  ///< Elements of a list so far, the current one included.
    std::string key;        ///< Of the current member of an object.
  };

  /// The path to the value that is being read.
  [[nodiscard]] std::string path() const {
    std::string path;
    for (const Level& level : levels_) {
      path += '/';
      if (level.is_list) {
        path += std::to_string(level.begun == 0 ? 0 : level.begun - 1);
        continue;
      }
      for (const char c : level.key) {
        path += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
      }
    }
    return path;
  }

  bool stop_at(std::size_t position, std::string reason) {
    const std::string_view before = text_.substr(0, std::min(position, text_.size()));
    const auto line = static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')) + 1;
    const std::string where = shortened(path());
    error_ = Error{
        ErrorKind::kBadInput,
        fmt::format("The JSON cannot be read{}{}: {}.", where.empty() ? "" : " at ", where, reason),
        source_, line};
    return false;
  }

  void misfit(std::string_view what) { misfit(path(), what); }
  void misfit(std::string_view where, std::string_view what) {
    is_misfit_ = true;
    if (!out_.misfit) {
      out_.misfit = Error{ErrorKind::kBadInput, fmt::format("{}: {}", where, what), source_, 0};
    }
  }

  void begin_value() {
    if (!levels_.empty() && levels_.back().is_list) {
      ++levels_.back().begun;
    }
  }

  void keep_field(JsonValue value) {
    if (levels_.empty()) {
      out_.fields.push_back({"", std::move(value)});
      return;
    }
    const Level& root = levels_.front();
    if (root.is_list ||
        std::find(kRootKeys.begin(), kRootKeys.end(), root.key) == kRootKeys.end()) {
      return;
    }
    std::string where = path();
    const auto is_there = [&](const JsonField& field) { return field.path == where; };
    if (std::any_of(out_.fields.begin(), out_.fields.end(), is_there)) {
      misfit("stands there twice.");
    } else if (out_.fields.size() == kMostFields) {
      misfit("is one entry too many.");
    } else {
      out_.fields.push_back({std::move(where), std::move(value)});
    }
  }

  template <class T>
  bool value(T v) {
    begin_value();
    if (!is_in_list_) {
      keep_field(JsonValue(std::move(v)));
    } else if (!is_misfit_) {
      keep_element(v);
    }
    return true;
  }

  template <class T>
  void keep_element(const T& v) {
    if (kind_ == nullptr && is_demands_) {
      if (!keep_index(out_.demands, v)) {
        misfit("must be a whole number from 0 on.");
      }
    } else if (kind_ == nullptr) {
      keep_depth(v);
    } else if (levels_.size() != list_level_ + (kind_->has_rows() ? 1 : 0)) {
      misfit(kind_->has_rows() ? kind_->row : kind_->element);
    } else if (!std::visit([&](auto list) { return keep_in(lists_->*list, v); }, kind_->list)) {
      misfit(kind_->element);
    }
  }

  // Each is false where the value is none for the list.
  template <class T>
  static bool keep_in(NumberRows& rows, const T& v) {
    if constexpr (std::is_arithmetic_v<T> && !std::is_same_v<T, bool>) {
      rows.numbers.push_back(static_cast<double>(v));
      return true;
    }
    return false;
  }
  template <class T>
  static bool keep_in(IndexRows& rows, const T& v) {
    return keep_index(rows.indices, v);
  }
  template <class T>
  static bool keep_in(ChoiceList& list, const T& v) {
    if constexpr (std::is_same_v<T, std::int64_t>) {
      if (v == -1) {
        list.choices.push_back(kNone);
        return true;
      }
    }
    return keep_index(list.choices, v);
  }
  template <class T>
  static bool keep_in(TextList& list, const T& v) {
    if constexpr (std::is_same_v<T, std::string>) {
      list.texts.push_back(bytes_of_json(v));
      return true;
    }
    return false;
  }
  template <class T>
  static bool keep_index(std::vector<std::uint32_t>& indices, const T& v) {
    if constexpr (std::is_same_v<T, std::uint64_t>) {
      if (v < kNone) {
        indices.push_back(static_cast<std::uint32_t>(v));
        return true;
      }
    }
    return false;
  }

  template <class T>
  void keep_depth(const T& v) {
    if constexpr (std::is_same_v<T, std::uint64_t>) {
      if (v <= std::uint64_t{kMaxDepth}) {
        out_.depths.push_back(static_cast<std::uint8_t>(v));
        return;
      }
    }
    misfit(fmt::format("must be a depth: a whole number from 0 to {}.", kMaxDepth));
  }

  /// Whether one of the long lists begins at the current path; sets which.
  bool is_list_here() {
    if (levels_.size() == 1 && (levels_[0].key == "depths" || levels_[0].key == "demands")) {
      kind_ = nullptr;
      is_demands_ = levels_[0].key == "demands";
      return true;
    }
    if (levels_.size() != 2 || levels_[0].is_list || levels_[1].is_list) {
      return false;
    }
    if (levels_[0].key == "mesh") {
      lists_ = &out_.mesh;
    } else if (levels_[0].key == "opened_mesh") {
      lists_ = &out_.opened_mesh;
    } else {
      return false;
    }
    const auto found = std::ranges::find(kListKinds, levels_[1].key, &ListKind::key);
    kind_ = found == kListKinds.end() ? nullptr : &*found;
    return kind_ != nullptr;
  }

  bool open(bool is_list) {
    begin_value();
    if (levels_.size() == kDeepestNesting) {
      error_ =
          Error{ErrorKind::kBadInput,
                fmt::format("{}: is nested more than {} deep.", shortened(path()), kDeepestNesting),
                source_, 0};
      return false;
    }
    if (is_in_list_) {
      const bool is_row =
          is_list && levels_.size() == list_level_ && kind_ != nullptr && kind_->has_rows();
      if (!is_row && !is_misfit_) {
        keep_element(JsonNull{});  // As wrong here as any other value, and for the same reason.
      }
      levels_.push_back({is_list, 0, {}});
      return true;
    }
    if (is_list && !levels_.empty() && !levels_[0].is_list && is_list_here()) {
      begin_list();
    } else {
      keep_field(is_list ? JsonValue(JsonList{}) : JsonValue(JsonObject{}));
    }
    levels_.push_back({is_list, 0, {}});
    return true;
  }

  void begin_list() {
    bool& is_there =
        kind_ == nullptr
            ? (is_demands_ ? out_.has_demands : out_.has_depths)
            : std::visit([&](auto list) -> bool& { return (lists_->*list).is_there; }, kind_->list);
    if (is_there) {
      misfit("stands there twice.");
    }
    is_there = true;
    is_in_list_ = true;
    list_level_ = levels_.size() + 1;
  }

  bool close() {
    if (is_in_list_ && levels_.size() == list_level_) {
      is_in_list_ = false;
    }
    if (is_in_list_ && levels_.size() == list_level_ + 1 && !is_misfit_ && kind_->has_rows()) {
      end_row(levels_.back().begun);
    }
    levels_.pop_back();
    return true;
  }

  void end_row(std::size_t length) {
    Level row = std::move(levels_.back());
    levels_.pop_back();
    auto* const faces = std::get_if<IndexRows MeshLists::*>(&kind_->list);
    if (faces != nullptr ? length < 3 : length != kind_->row_length) {
      misfit(fmt::format("has {} {}; {}", length, kind_->entries, kind_->length));
    }
    if (faces != nullptr) {
      IndexRows& rows = lists_->**faces;
      rows.offsets.push_back(static_cast<std::uint32_t>(rows.indices.size()));
    }
    levels_.push_back(std::move(row));
  }

  std::string_view text_;
  const std::string& source_;
  ProjectText out_;
  Error error_;
  bool is_misfit_ = false;  ///< The lists are not listened to any more.
  std::vector<Level> levels_;
  bool is_in_list_ = false;
  const ListKind* kind_ = nullptr;  ///< Of the list; nullptr for the depths and the demands.
  bool is_demands_ = false;
  std::size_t list_level_ = 0;  ///< Size of `levels_` directly inside the list.
  MeshLists* lists_ = nullptr;
};

}  // namespace

Result<ProjectText> parse_project_text(std::string_view text, const std::string& source) {
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    return fail(ErrorKind::kBadInput, "The file is empty.", source);
  }
  Reader reader(text, source);
  const bool is_parsed = json::sax_parse(text.begin(), text.end(), &reader);
  return std::move(reader).finish(is_parsed);
}

std::string json_quoted(std::string_view text) {
  return json(text).dump(-1, ' ', false, json::error_handler_t::replace);
}

bool is_utf8(std::string_view text) {
  return json(text).dump(-1, ' ', false, json::error_handler_t::ignore).size() ==
         json(text).dump(-1, ' ', false, json::error_handler_t::replace).size();
}

}  // namespace limn
