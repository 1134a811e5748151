#pragma once

#include <functional>

#include "limn/error.h"

namespace CLI {
class App;
}

namespace limn::cli {

/// Each function adds one subcommand to the program. Its work runs after parsing, when the command
/// line was understood; it is stored in `work`, which returns the failure, if there was one.
using Work = std::function<Result<void>()>;

void add_refine_command(CLI::App& program, Work& work);
void add_render_command(CLI::App& program, Work& work);
void add_info_command(CLI::App& program, Work& work);
void add_validate_command(CLI::App& program, Work& work);
void add_convert_command(CLI::App& program, Work& work);
void add_subdivide_command(CLI::App& program, Work& work);
void add_schemes_command(CLI::App& program, Work& work);
void add_compare_command(CLI::App& program, Work& work);
void add_symmetrise_command(CLI::App& program, Work& work);
void add_split_and_flip_command(CLI::App& program, Work& work);
void add_reattach_command(CLI::App& program, Work& work);
void add_recover_command(CLI::App& program, Work& work);
void add_replay_command(CLI::App& program, Work& work);
void add_classroom_command(CLI::App& program, Work& work);
void add_presets_command(CLI::App& program, Work& work);

}  // namespace limn::cli
