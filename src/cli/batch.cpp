#include "cli/batch.h"

#include <new>
#include <utility>

#include <fmt/format.h>

#include "cli/console.h"

namespace limn::cli {
namespace {

using Json = nlohmann::ordered_json;

Json error_json(const Error& error) {
  Json result = {{"message", error.message}, {"exit_code", exit_code(error.kind)}};
  if (error.line > 0) {
    result["line"] = error.line;
  }
  if (error.byte) {
    result["byte"] = *error.byte;
  }
  return result;
}

}  // namespace

void Batch::run(const std::string& input, const std::function<Result<Json>()>& work) {
  if (first_ && first_->kind == ErrorKind::kCancelled) {
    return;
  }
  ++count_;
  Result<Json> done;
  try {
    done = work();
  } catch (const std::bad_alloc&) {
    done = fail(ErrorKind::kFailed, "not enough memory; lower --levels or --budget", input);
  }
  Json report = {{"input", input}, {"ok", done.has_value()}};
  if (done) {
    if (is_single_) {
      reports_.push_back(*std::move(done));
      return;
    }
    report.update(done->is_null() ? Json::object() : *done);
  } else {
    ++failed_;
    report["error"] = error_json(done.error());
    if (!is_single_) {
      print_error(done.error());
    }
    first_ = first_ ? first_ : std::optional(done.error());
  }
  reports_.push_back(std::move(report));
}

Json Batch::report() const {
  return is_single_ && !reports_.empty() ? reports_.front() : Json(reports_);
}

Result<void> Batch::result() const {
  if (!first_) {
    return {};
  }
  if (is_single_) {
    return tl::unexpected<Error>(*first_);
  }
  return fail(first_->kind, fmt::format("{} of {} files failed", failed_, count_));
}

}  // namespace limn::cli
