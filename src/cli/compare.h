#pragma once

#include "cli/commands.h"

namespace limn::cli {

/// There is a bundled mesh with the name of a comparison.
inline constexpr const char* kSphereIsNoMesh =
    "sphere is a comparison of its own; for the bundled mesh of that name write "
    "limn compare --to limit -- sphere";

/// Adds `compare sphere`.
void add_sphere_command(CLI::App& compare, Work& work);

/// Adds `compare IN --to WHAT`: the distance of a mesh, refined as painted, to the limit surface or
/// to another mesh.
void add_distance_options(CLI::App& compare, Work& work);

}  // namespace limn::cli
