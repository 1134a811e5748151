#pragma once

#include <span>
#include <vector>

#include "limn/mesh/control_mesh.h"
#include "limn/painting/mirror.h"
#include "limn/subdivision/fine_demands.h"

namespace limn {

/// Faces of finer levels and their mirror images: within the partner of a control face the face at
/// the same place, as the corners that lie nearest to where the mirror puts their own say. Each
/// once, by ascending control face. Where a control face has no partner, nor have its faces.
[[nodiscard]] std::vector<FineFace> with_images(const ControlMesh& mesh, const FaceMirror& mirror,
                                                std::span<const FineFace> faces);

}  // namespace limn
