// A short list in the order of first appearance: files use a dozen kinds of statement at most, and
// unknown ones are capped.
#include "mesh/formats/unused_data.h"

#include <algorithm>

#include <fmt/format.h>

#include "mesh/counted.h"
#include "mesh/printable.h"

namespace limn::detail {
namespace {

struct Keyword {
  std::string_view keyword;
  std::string_view one;
  std::string_view many;
};

constexpr Keyword Keywords[] = {
    {"vn", "normal", "normals"},
    {"vp", "parameter-space point", "parameter-space points"},
    {"vw", "skin weight", "skin weights"},
    {"s", "smoothing group statement", "smoothing group statements"},
    {"l", "line element", "line elements"},
    {"p", "point element", "point elements"},
    {"curv", "free-form curve", "free-form curves"},
    {"curv2", "free-form curve", "free-form curves"},
    {"surf", "free-form surface", "free-form surfaces"},
    {"cstype", "free-form attribute", "free-form attributes"},
    {"deg", "free-form attribute", "free-form attributes"},
    {"bmat", "free-form attribute", "free-form attributes"},
    {"step", "free-form attribute", "free-form attributes"},
    {"parm", "free-form attribute", "free-form attributes"},
    {"trim", "free-form attribute", "free-form attributes"},
    {"hole", "free-form attribute", "free-form attributes"},
    {"scrv", "free-form attribute", "free-form attributes"},
    {"sp", "free-form attribute", "free-form attributes"},
    {"end", "free-form attribute", "free-form attributes"},
    {"con", "free-form attribute", "free-form attributes"},
    {"mg", "free-form attribute", "free-form attributes"},
    {"ctech", "free-form attribute", "free-form attributes"},
    {"stech", "free-form attribute", "free-form attributes"},
    {"bevel", "display attribute", "display attributes"},
    {"c_interp", "display attribute", "display attributes"},
    {"d_interp", "display attribute", "display attributes"},
    {"lod", "display attribute", "display attributes"},
    {"maplib", "display attribute", "display attributes"},
    {"usemap", "display attribute", "display attributes"},
    {"shadow_obj", "display attribute", "display attributes"},
    {"trace_obj", "display attribute", "display attributes"},
};

}  // namespace

void UnusedData::add(std::size_t count, std::string_view one, std::string_view many) {
  if (count == 0) {
    return;
  }
  const auto found = std::find_if(entries_.begin(), entries_.end(),
                                  [&](const Entry& entry) { return entry.one == one; });
  if (found != entries_.end()) {
    found->count += count;
  } else {
    entries_.push_back({std::string(one), std::string(many), count});
  }
}

void UnusedData::add_named(std::size_t count, std::string_view name, std::string_view what) {
  constexpr std::size_t most_kinds = 8;
  const std::string one = fmt::format("\"{}\" {}", printable(name), what);
  const bool is_known = std::any_of(entries_.begin(), entries_.end(),
                                    [&](const Entry& entry) { return entry.one == one; });
  if (!is_known && named_kinds_ == most_kinds) {
    add(count, fmt::format("other unknown {}", what));
    return;
  }
  named_kinds_ += is_known || count == 0 ? 0 : 1;
  add(count, one);
}

std::vector<std::string> UnusedData::phrases() const {
  std::vector<std::string> result;
  result.reserve(entries_.size());
  for (const Entry& entry : entries_) {
    result.push_back(counted(entry.count, entry.one, entry.many));
  }
  return result;
}

void count_obj_statement(UnusedData& unused, std::string_view keyword) {
  const auto known = std::find_if(std::begin(Keywords), std::end(Keywords),
                                  [&](const Keyword& k) { return k.keyword == keyword; });
  if (known != std::end(Keywords)) {
    unused.add(1, known->one, known->many);
  } else {
    unused.add_named(1, keyword, "statement");
  }
}

}  // namespace limn::detail
