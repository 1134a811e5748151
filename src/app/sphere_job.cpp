#include "app/sphere_job.h"

#include "limn/part_of_progress.h"

namespace limn::app {

void SphereJob::start(Question question) {
  question_ = std::move(question);
  answer_ = {};
  job_.start([asked = question_](Progress& progress) { return compare(asked, progress); });
}

Result<SphereJob::Answer> SphereJob::compare(const Question& question, Progress& progress) {
  Answer answer;
  const auto count = static_cast<double>(question.schemes.size());
  for (std::size_t i = 0; i < question.schemes.size(); ++i) {
    PartOfProgress part(progress, static_cast<double>(i) / count,
                        static_cast<double>(i + 1) / count);
    auto rows = compare_with_sphere(*question.control, question.schemes[i], question.levels, part);
    if (rows) {
      answer.series.push_back({question.schemes[i], *std::move(rows)});
    } else if (rows.error().kind == ErrorKind::kCancelled) {
      return tl::unexpected(std::move(rows.error()));
    } else {
      answer.problem = std::move(rows.error().message);
    }
  }
  return answer;
}

bool SphereJob::update() {
  std::optional<Result<Answer>> answer = job_.take();
  if (!answer) {
    return false;
  }
  answer_ = *answer ? **std::move(answer) : Answer{{}, std::move(answer->error().message)};
  return true;
}

ui::SphereStatus SphereJob::status(const Question& current) const {
  ui::SphereStatus status;
  if (question_ != current) {
    return status;
  }
  status.running = job_.running();
  if (!status.running) {
    status.series = answer_.series;
    status.problem = answer_.problem;
  }
  return status;
}

}  // namespace limn::app
