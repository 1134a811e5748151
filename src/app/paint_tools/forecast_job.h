#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "app/mailbox.h"
#include "limn/mesh/control_mesh.h"
#include "limn/painting/depth_change.h"
#include "limn/painting/face_depths.h"
#include "limn/subdivision/prediction.h"
#include "limn/subdivision/settings.h"

namespace limn::app {

/// Works out how many faces a change of the painting would add to the refined mesh, exactly and
/// before it is made, on a thread of its own. Only the last question counts: while a mouse moves
/// over the mesh it is asked many times, and what it was asked before is given up.
class ForecastJob {
 public:
  struct Question {
    std::shared_ptr<const ControlMesh> control;
    FaceDepths depths;             ///< As they are,
    std::vector<DepthEdit> edits;  ///< and what would change.
    SubdivisionSettings settings;
    int levels = kAllLevels;     ///< That the refined mesh is shown to.
    FineDemands demands{};       ///< As they are,
    DemandEdits demand_edits{};  ///< and what would change.

    [[nodiscard]] bool operator==(const Question&) const = default;
  };

  /// `wake` is called from the worker when `update` has something to take in. `arrivals` is that of
  /// its Mailbox, "forecast".
  explicit ForecastJob(std::function<void()> wake, Arrivals* arrivals = nullptr);
  /// Gives up what runs and waits for it to notice.
  ~ForecastJob();
  ForecastJob(const ForecastJob&) = delete;
  ForecastJob& operator=(const ForecastJob&) = delete;

  /// Nothing happens where it is the question asked last.
  void ask(Question question);
  /// There is nothing to know any more.
  void forget();
  /// Takes in what was found; true where there was anything.
  bool update();

  /// Faces that the refined mesh would get more (or, negative, fewer), of the last question;
  /// nothing while that is not known.
  [[nodiscard]] std::optional<std::int64_t> added_faces() const noexcept { return added_; }
  void wait_until_idle() const;

 private:
  class Watch;
  void work(const std::stop_token& stop);
  [[nodiscard]] std::optional<std::int64_t> answer(const Question& question, Watch& watch);

  std::function<void()> wake_;
  Mailbox<std::int64_t> answers_;
  Question asked_;  ///< Without a mesh: nothing.
  std::optional<std::int64_t> added_;

  /// The worker's: faces as things are, for as long as only the edits differ.
  Question known_;
  std::uint64_t known_faces_ = 0;

  mutable std::mutex mutex_;
  mutable std::condition_variable_any changed_;
  std::optional<Question> waiting_;
  std::uint64_t ticket_ = 0;  ///< Counts questions: work for an older one is stale.
  bool is_working_ = false;
  std::jthread worker_;  ///< Last, so that it stops before anything it uses is gone.
};

}  // namespace limn::app
