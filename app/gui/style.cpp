#include "app/gui/style.hpp"

#include <cmath>
#include <filesystem>
#include <utility>

#include <imgui/imgui.h>

namespace atrium::gui {
namespace {

/// As displayed (sRGB), 0xRRGGBB.
struct Colour {
    int hex = 0;
    float alpha = 1;

    operator ImVec4() const
    {
        const auto channel = [this](int shift) { return static_cast<float>((hex >> shift) & 255) / 255.0f; };
        return {channel(16), channel(8), channel(0), alpha};
    }
};

constexpr Colour rgb(int hex, float alpha = 1.0f)
{
    return {hex, alpha};
}

// Stone from dark to light; the picture shines through the darkest.
constexpr Colour ground = rgb(0x1f1c1a, 0.94f), deep = rgb(0x181614), field = rgb(0x35302c), raised = rgb(0x443d38),
                 lifted = rgb(0x554c46), edge = rgb(0x4a433d), clear = rgb(0, 0.0f);
constexpr Colour ink = rgb(0xe9e2da), faint = rgb(0xa39a90);
constexpr Colour accent = rgb(0xc8694a), bright = rgb(0xe38763);

constexpr std::pair<ImGuiCol, Colour> colours[]{
    {ImGuiCol_Text, ink},
    {ImGuiCol_TextDisabled, faint},
    {ImGuiCol_WindowBg, ground},
    {ImGuiCol_ChildBg, clear},
    {ImGuiCol_PopupBg, rgb(0x24211e, 0.98f)},
    {ImGuiCol_Border, edge},
    {ImGuiCol_BorderShadow, clear},
    {ImGuiCol_FrameBg, field},
    {ImGuiCol_FrameBgHovered, raised},
    {ImGuiCol_FrameBgActive, lifted},
    {ImGuiCol_TitleBg, deep},
    {ImGuiCol_TitleBgActive, deep},
    {ImGuiCol_TitleBgCollapsed, rgb(0x181614, 0.8f)},
    {ImGuiCol_MenuBarBg, deep},
    {ImGuiCol_ScrollbarBg, clear},
    {ImGuiCol_ScrollbarGrab, raised},
    {ImGuiCol_ScrollbarGrabHovered, lifted},
    {ImGuiCol_ScrollbarGrabActive, accent},
    {ImGuiCol_CheckMark, bright},
    {ImGuiCol_SliderGrab, accent},
    {ImGuiCol_SliderGrabActive, bright},
    {ImGuiCol_Button, field},
    {ImGuiCol_ButtonHovered, lifted},
    {ImGuiCol_ButtonActive, accent},
    {ImGuiCol_Header, rgb(0x3c3631)},
    {ImGuiCol_HeaderHovered, lifted},
    {ImGuiCol_HeaderActive, rgb(0x6a4a3c)},
    {ImGuiCol_Separator, edge},
    {ImGuiCol_SeparatorHovered, accent},
    {ImGuiCol_SeparatorActive, bright},
    {ImGuiCol_ResizeGrip, raised},
    {ImGuiCol_ResizeGripHovered, accent},
    {ImGuiCol_ResizeGripActive, bright},
    {ImGuiCol_Tab, clear},
    {ImGuiCol_TabHovered, lifted},
    {ImGuiCol_TabActive, rgb(0x8a4b36)},
    {ImGuiCol_TabUnfocused, clear},
    {ImGuiCol_TabUnfocusedActive, rgb(0x8a4b36)},
    {ImGuiCol_PlotLines, bright},
    {ImGuiCol_PlotLinesHovered, ink},
    {ImGuiCol_PlotHistogram, rgb(0x9c543c)},
    {ImGuiCol_PlotHistogramHovered, bright},
    {ImGuiCol_TableHeaderBg, rgb(0x2c2825)},
    {ImGuiCol_TableBorderStrong, edge},
    {ImGuiCol_TableBorderLight, field},
    {ImGuiCol_TableRowBg, clear},
    {ImGuiCol_TableRowBgAlt, rgb(0xffffff, 0.03f)},
    {ImGuiCol_TextSelectedBg, rgb(0xc8694a, 0.45f)},
    {ImGuiCol_DragDropTarget, bright},
    {ImGuiCol_NavHighlight, bright},
    {ImGuiCol_NavWindowingHighlight, ink},
    {ImGuiCol_NavWindowingDimBg, rgb(0, 0.4f)},
    {ImGuiCol_ModalWindowDimBg, rgb(0, 0.5f)},
};
static_assert(std::size(colours) == ImGuiCol_COUNT, "none is left as ImGui has it");

} // namespace

void apply_style(float scale)
{
    ImGuiStyle style;
    style.WindowPadding = {10, 10};
    style.FramePadding = {7, 4};
    style.CellPadding = {5, 3};
    style.ItemSpacing = {7, 6};
    style.ItemInnerSpacing = {6, 4};
    style.IndentSpacing = 14;
    style.ScrollbarSize = 11;
    style.GrabMinSize = 10;
    style.WindowRounding = 6;
    style.ChildRounding = style.PopupRounding = 4;
    style.FrameRounding = style.TabRounding = style.GrabRounding = 3;
    style.ScrollbarRounding = 6;
    style.WindowTitleAlign = {0.5f, 0.5f};
    style.WindowMenuButtonPosition = ImGuiDir_Right;
    style.ScaleAllSizes(scale);
    // A hair at any scale: ScaleAllSizes leaves lines alone, and these are the ones that there are.
    style.WindowBorderSize = style.ChildBorderSize = style.PopupBorderSize = 1;
    style.FrameBorderSize = style.TabBorderSize = 0;
    for (const auto& [which, colour] : colours) style.Colors[which] = colour;
    ImGui::GetStyle() = style;
}

void load_font(float scale)
{
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    const char* file = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
    std::error_code unreadable;
    if (std::filesystem::is_regular_file(file, unreadable) &&
        atlas.AddFontFromFileTTF(file, std::round(14.0f * scale)) != nullptr) {
        return;
    }
    ImFontConfig config;
    config.SizePixels = std::round(13.0f * scale);
    atlas.AddFontDefault(&config);
}

} // namespace atrium::gui
