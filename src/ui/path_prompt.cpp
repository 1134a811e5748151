// A small file dialog: the folder as a field one can type into, what is in it, and a name. The
// program reads folders; here they are only shown. A click on a file takes its name, a double click
// answers with it; a double click on a folder asks for its contents.

#include <algorithm>
#include <cmath>
#include <string>

#include <imgui.h>
#include <imgui_stdlib.h>

#include "limn/mesh/mesh_format.h"
#include "ui/format.h"
#include "ui/panels.h"
#include "ui/widgets.h"

namespace limn::ui {
namespace {

struct PurposeLook {
  const char* title;
  const char* verb;
  ActionId answer;
  std::string_view ending;  ///< Added to a name that has none that fits; empty for none.
};

PurposeLook look_of(PathPrompt::Purpose purpose) {
  switch (purpose) {
    case PathPrompt::Purpose::kOpen:
      return {"Open a mesh or project", "Open", ActionId::kOpen, {}};
    case PathPrompt::Purpose::kReplaceMesh:
      return {"Replace the mesh under the painting", "Replace", ActionId::kReplaceMesh, {}};
    case PathPrompt::Purpose::kSaveProject:
      return {"Save project", "Save", ActionId::kSaveProjectAs, ".limn"};
    case PathPrompt::Purpose::kExportRefined:
      return {"Export mesh", "Export", ActionId::kExportRefined, ".obj"};
  }
  return {};
}

std::string joined(const std::string& folder, const std::string& name) {
  if (name.starts_with('/')) {
    return name;
  }
  return folder.ends_with('/') ? folder + name : folder + '/' + name;
}

/// Meshes are exported in the format that the name asks for.
std::string with_ending(PathPrompt::Purpose purpose, std::string name) {
  const std::string_view ending = look_of(purpose).ending;
  const bool fits = purpose == PathPrompt::Purpose::kExportRefined
                        ? format_by_ending(name).has_value()
                        : name.ends_with(ending);
  if (!name.empty() && !fits) {
    name += ending;
  }
  return name;
}

const FolderEntry* find_entry(const PathPrompt& prompt, const std::string& name) {
  const auto found = std::find_if(prompt.entries.begin(), prompt.entries.end(),
                                  [&name](const FolderEntry& entry) { return entry.name == name; });
  return found == prompt.entries.end() ? nullptr : &*found;
}

void follow_model(UiState::PathPromptState& state, const PathPrompt& prompt) {
  if (state.serial != prompt.serial) {
    state = {prompt.serial, prompt.folder, prompt.suggested_name, prompt.folder, true};
  } else if (state.listed_folder != prompt.folder) {
    state.folder = prompt.folder;
    state.listed_folder = prompt.folder;
  }
}

/// Takes the name as typed: into a folder, or as the answer.
void answer(PanelContext& context, const PathPrompt& prompt) {
  const PurposeLook look = look_of(prompt.purpose);
  const std::string& typed = context.state.path_prompt.name;
  const FolderEntry* entry = find_entry(prompt, typed);
  if (entry != nullptr && entry->is_folder) {
    context.emit(Action(ActionId::kBrowse, joined(prompt.folder, typed)));
    context.state.path_prompt.name = prompt.suggested_name;
  } else if (!typed.empty()) {
    context.emit(Action(look.answer, joined(prompt.folder, with_ending(prompt.purpose, typed))));
  }
}

void folder_row(PanelContext& context, const PathPrompt& prompt) {
  const float side = ImGui::GetFrameHeight();
  icon_button(context, Action(ActionId::kBrowse, prompt.parent), Icon::kFolderUp, side);
  ImGui::SameLine(0.0F, context.px(4));
  ImGui::SetNextItemWidth(room());
  std::string& folder = context.state.path_prompt.folder;
  if (ImGui::InputText("##folder", &folder, ImGuiInputTextFlags_EnterReturnsTrue) &&
      !folder.empty()) {
    context.emit(Action(ActionId::kBrowse, folder));
  }
  remember(context, "folder field");
}

void entry_row(PanelContext& context, const PathPrompt& prompt, const FolderEntry& entry) {
  UiState::PathPromptState& state = context.state.path_prompt;
  const float height = context.px(24);
  const ImVec2 start = ImGui::GetCursorScreenPos();
  const float width = room();
  const bool is_pressed = ImGui::Selectable(("##" + entry.name).c_str(), state.name == entry.name,
                                            ImGuiSelectableFlags_AllowDoubleClick, {width, height});
  remember(context, "entry: " + entry.name);
  const float y = std::floor(start.y + (height - ImGui::GetFontSize()) / 2.0F);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ThemeColours& c = context.colours;
  draw_icon(list, entry.is_folder ? Icon::kFolder : Icon::kFile,
            {start.x + context.px(12), start.y + height / 2.0F}, context.px(15), c.dim_text);
  const std::string size = entry.is_folder ? std::string() : bytes_text(entry.bytes);
  const float size_width = ImGui::CalcTextSize(size.c_str()).x;
  const std::string name = fit_text(entry.name, width - size_width - context.px(48));
  list.AddText({start.x + context.px(28), y}, c.text, name.c_str());
  list.AddText({start.x + width - size_width - context.px(8), y}, c.dim_text, size.c_str());
  if (!is_pressed) {
    return;
  }
  const bool is_double = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
  if (entry.is_folder) {
    if (is_double) {
      context.emit(Action(ActionId::kBrowse, joined(prompt.folder, entry.name)));
    }
    return;
  }
  state.name = entry.name;
  if (is_double) {
    answer(context, prompt);
  }
}

void entry_list(PanelContext& context, const PathPrompt& prompt, float height) {
  ImGui::PushStyleColor(ImGuiCol_ChildBg, context.colours.field);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {context.px(4), context.px(4)});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0F, 0.0F});
  ImGui::BeginChild("##entries", {0.0F, height}, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
  if (!prompt.problem.empty() || prompt.entries.empty()) {
    const std::string& text = prompt.problem;
    ImGui::PushStyleColor(ImGuiCol_Text, context.colours.dim_text);
    ImGui::PushTextWrapPos(0.0F);
    ImGui::TextUnformatted(text.empty() ? "Nothing here that Limn can use." : text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
  }
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(prompt.entries.size()), context.px(24));
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      entry_row(context, prompt, prompt.entries[static_cast<std::size_t>(i)]);
    }
  }
  ImGui::EndChild();
  ImGui::PopStyleVar(2);
  ImGui::PopStyleColor();
  // The child ended under its own spacing of 0.
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() + ImGui::GetStyle().ItemSpacing.y);
}

/// Room for two lines, so that nothing jumps.
float loss_height() {
  return 2.0F * ImGui::GetTextLineHeightWithSpacing();
}

void name_row(PanelContext& context, const PathPrompt& prompt) {
  UiState::PathPromptState& state = context.state.path_prompt;
  ImGui::AlignTextToFramePadding();
  ImGui::PushStyleColor(ImGuiCol_Text, context.colours.dim_text);
  ImGui::TextUnformatted("Name");
  ImGui::PopStyleColor();
  ImGui::SameLine(0.0F, context.px(12));
  ImGui::SetNextItemWidth(room());
  if (state.wants_focus) {
    ImGui::SetKeyboardFocusHere();
    state.wants_focus = false;
  }
  if (ImGui::InputText("##name", &state.name, ImGuiInputTextFlags_EnterReturnsTrue)) {
    answer(context, prompt);
  }
  remember(context, "name field");
}

/// The formats to export in, and what the one that the name asks for does not hold.
void format_rows(PanelContext& context, const PathPrompt& prompt) {
  std::string& name = context.state.path_prompt.name;
  const MeshFormat chosen = format_by_ending(name).value_or(MeshFormat::kObj);
  ImGui::AlignTextToFramePadding();
  ImGui::PushStyleColor(ImGuiCol_Text, context.colours.dim_text);
  ImGui::TextUnformatted("Format");
  ImGui::PopStyleColor();
  for (const MeshFormat format : MeshFormats) {
    ImGui::SameLine(0.0F, context.px(12));
    const std::string label(name_of(format));
    if (ImGui::RadioButton(label.c_str(), format == chosen)) {
      if (format_by_ending(name)) {
        name.resize(name.size() - ending_of(chosen).size());
      }
      name += ending_of(format);
    }
    remember(context, "format: " + label);
  }
  const std::string& loss = prompt.losses[static_cast<std::size_t>(chosen)];
  ImGui::PushStyleColor(ImGuiCol_Text, context.colours.dim_text);
  ImGui::BeginChild("##loss", {0.0F, loss_height()});
  ImGui::PushTextWrapPos(0.0F);
  ImGui::TextUnformatted(loss.empty() ? "Everything the mesh has goes with it." : loss.c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndChild();
  ImGui::PopStyleColor();
}

/// Cancel and the answer. The answer says where it would replace a file.
void buttons(PanelContext& context, const PathPrompt& prompt) {
  const PurposeLook look = look_of(prompt.purpose);
  const std::string name = with_ending(prompt.purpose, context.state.path_prompt.name);
  const FolderEntry* entry = find_entry(prompt, name);
  const bool replaces = prompt.purpose != PathPrompt::Purpose::kOpen && entry != nullptr;
  const float width = context.px(110);
  const float gap = context.px(8);
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + room() - 2.0F * width - gap);
  action_button(context, ActionId::kCancel, {.width = width});
  ImGui::SameLine(0.0F, gap);
  ImGui::BeginDisabled(name.empty());
  if (plain_button(context, replaces ? "Replace" : look.verb, width, !name.empty())) {
    answer(context, prompt);
  }
  ImGui::EndDisabled();
}

}  // namespace

void draw_path_prompt(PanelContext& context, const PathPrompt& prompt) {
  follow_model(context.state.path_prompt, prompt);
  ImGui::PushFont(context.fonts.body_strong);
  ImGui::TextUnformatted(look_of(prompt.purpose).title);
  ImGui::PopFont();
  folder_row(context, prompt);
  const float spacing = ImGui::GetStyle().ItemSpacing.y;
  float foot = ImGui::GetFrameHeight() + context.px(28) + 2.0F * spacing;
  const bool has_formats = prompt.purpose == PathPrompt::Purpose::kExportRefined;
  foot += has_formats ? ImGui::GetFrameHeight() + loss_height() + 2.0F * spacing : 0.0F;
  entry_list(context, prompt, ImGui::GetContentRegionAvail().y - foot);
  name_row(context, prompt);
  if (has_formats) {
    format_rows(context, prompt);
  }
  buttons(context, prompt);
}

}  // namespace limn::ui
