#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "limn/mesh/control_mesh.h"
#include "meshes.h"

namespace limn::bench {

/// A program that refines uniformly: Limn or a peer, all with results in single precision.
///
/// A run is `prepare`, `refine`, questions, `release`. Only `refine` is on the clock: topology and
/// positions of every level, from a control mesh in the program's own form to the finest mesh.
class Subdivider {
 public:
  virtual ~Subdivider() = default;

  /// What is done once a control mesh, or lost by refining it in place: brings the control mesh
  /// into the form that `refine` starts from.
  virtual void prepare() = 0;
  virtual void refine(int levels) = 0;
  /// Frees all that `prepare` and `refine` took.
  virtual void release() = 0;
  /// Gets ready to refine again. Keeps the memory where the program has a way to.
  virtual void recycle() {
    release();
    prepare();
  }

  [[nodiscard]] virtual Counts counts() const = 0;
  /// The finest vertices, in the program's order.
  [[nodiscard]] virtual std::vector<glm::vec3> positions() const = 0;
  /// Bytes of the finished mesh; 0 where it is not told apart from what made it.
  [[nodiscard]] virtual std::size_t result_bytes() const { return 0; }
};

[[nodiscard]] std::unique_ptr<Subdivider> make_limn(const ControlMesh& mesh, Rules rules);
[[nodiscard]] std::unique_ptr<Subdivider> make_opensubdiv(const ControlMesh& mesh, Rules rules);
[[nodiscard]] std::unique_ptr<Subdivider> make_openmesh(const ControlMesh& mesh, Rules rules);
[[nodiscard]] std::unique_ptr<Subdivider> make_cgal(const ControlMesh& mesh, Rules rules);

/// One of the above, by the name that follows `make_`. Broken contract for any other.
[[nodiscard]] std::unique_ptr<Subdivider> make_subdivider(std::string_view program,
                                                          const ControlMesh& mesh, Rules rules);

/// The same, made when first asked for and kept until the program ends.
[[nodiscard]] Subdivider& cached_subdivider(const std::string& program, const Work& work);

}  // namespace limn::bench
