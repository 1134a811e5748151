#pragma once

#include <cstddef>
#include <string>

#include "limn/document/document.h"

namespace limn {

/// One undoable change of a document. `apply` after `revert` is redo and gives the same state.
/// `apply` and `revert` take turns; both count up the revisions of what they change, and no other.
class Command {
 public:
  virtual ~Command() = default;

  virtual void apply(Document& document) = 0;
  virtual void revert(Document& document) = 0;
  /// Memory this command keeps alive, for the history's bound. A mesh that is also the document's
  /// (or its opened one) costs the command nothing, so the figure may change on apply and revert.
  [[nodiscard]] virtual std::size_t bytes() const noexcept = 0;
  /// For "Undo …": "paint 12 faces", "subdivide".
  [[nodiscard]] virtual std::string name() const = 0;
};

}  // namespace limn
