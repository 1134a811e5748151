#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <variant>
#include <vector>

#include "app/mailbox.h"
#include "limn/document/refinement.h"
#include "limn/document/scheme_refinement.h"
#include "limn/error.h"
#include "limn/mesh/control_mesh.h"
#include "limn/painting/face_depths.h"
#include "limn/subdivision/fine_demands.h"

namespace limn::render {
struct Surface;
}

namespace limn::app {

/// Everything a refinement follows from. A copy, so that the document may change meanwhile.
struct JobRequest {
  std::uint64_t serial = 0;  ///< The caller's number for this state of the document.
  std::shared_ptr<const ControlMesh> control;
  FaceDepths depths;
  FineDemands demands;
  SubdivisionSettings settings;
  std::optional<SchemeSettings> scheme;  ///< Takes the mesh. Nothing: what is painted.
  int levels = 0;                        ///< 0: labels and their prediction only.
  std::uint64_t face_budget = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t memory_budget = std::numeric_limits<std::uint64_t>::max();
};

/// What came of a request. Handed out twice where there is something to refine: first without a
/// refinement, as soon as the labels are known, then whole.
struct JobResult {
  std::uint64_t serial = 0;
  std::shared_ptr<const ControlMesh> control;
  std::shared_ptr<const DerivedLabels> labels;
  std::optional<SchemeSettings> scheme;            ///< That was asked for.
  std::shared_ptr<const RefinedMesh> mesh;         ///< Null where none was made, or not yet.
  std::shared_ptr<const Refinement> refinement;    ///< Of what is painted; null for a scheme.
  std::vector<SchemeStep> steps;                   ///< Of a scheme, levels 0..n.
  std::shared_ptr<const render::Surface> surface;  ///< Of the refined mesh, ready for drawing.
  RefinementPrediction prediction;                 ///< For the levels asked for.
  std::size_t illegal_left = 0;     ///< Illegal faces under the legal labels: 0, or it is a bug.
  bool is_over_budget = false;      ///< `prediction` was above the budget, so nothing was refined.
  std::uint64_t memory_budget = 0;  ///< Where that was too small, what it was.
  bool is_final = false;            ///< Nothing more will come of this request.
};

/// What the worker is at.
struct JobStatus {
  bool is_busy = false;
  std::uint64_t serial = 0;  ///< Of the request being worked on.
  double fraction = 0.0;
  std::string stage;
  std::chrono::steady_clock::duration running_for{};
};

/// Derives labels, legalisation, prediction, the refined mesh and the crack check from a painting,
/// one request at a time, on a thread of its own.
///
/// All members may be called from one owner's thread without waiting for the worker. `wake` is
/// called from the worker whenever there is something new to look at.
class RefinementJob {
 public:
  /// `name` and `arrivals` are those of its Mailbox.
  explicit RefinementJob(std::function<void()> wake, std::string name = "refinement",
                         Arrivals* arrivals = nullptr);
  /// Cancels what runs and waits for the worker to notice.
  ~RefinementJob();
  RefinementJob(const RefinementJob&) = delete;
  RefinementJob& operator=(const RefinementJob&) = delete;

  /// Works on this next; what runs or waits for an older request is given up, and what came of it
  /// and was not taken yet is thrown away.
  void submit(JobRequest request);
  /// Gives up what runs and what waits, in the same way.
  void cancel();

  [[nodiscard]] JobStatus status() const;
  /// Blocks until nothing runs and nothing waits.
  void wait_until_idle() const;

  /// The newest result, handed out once.
  [[nodiscard]] std::shared_ptr<const JobResult> take_result();
  /// Why the last request came to nothing, other than by cancelling; known after `take_result`.
  [[nodiscard]] std::optional<Error> take_error();

 private:
  class JobProgress;
  using News = std::variant<std::shared_ptr<const JobResult>, Error>;

  void work(const std::stop_token& stop);
  void carry_out(const JobRequest& request, const std::stop_token& stop, std::uint64_t ticket);
  /// Fills in what was asked for after the labels. Errors: those of what makes the mesh.
  [[nodiscard]] Result<void> refine(const JobRequest& request, JobResult& result,
                                    Progress& progress);
  /// Hands something to the owner unless a newer request has come in.
  void publish(std::uint64_t ticket, News news);

  std::function<void()> wake_;
  Mailbox<News> news_;
  RefinementSource source_;  ///< The worker's.

  mutable std::mutex mutex_;
  mutable std::condition_variable_any changed_;
  std::optional<JobRequest> waiting_;
  std::uint64_t ticket_ = 0;  ///< Counts submits and cancels: work for an older one is stale.
  JobStatus status_;
  std::chrono::steady_clock::time_point started_;
  std::optional<Error> error_;  ///< The owner's.

  std::jthread worker_;  ///< Last, so that it stops before anything it uses is gone.
};

}  // namespace limn::app
