#pragma once

#include "limn/document/document.h"
#include "limn/mesh/export.h"

namespace limn {

/// What goes out with the meshes of a document: its painting in the colours of the depth palette,
/// names of faces and loose vertices. The document must outlive it.
[[nodiscard]] ExportSettings export_settings(const Document& document);

}  // namespace limn
