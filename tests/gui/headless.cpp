#include "tests/gui/headless.hpp"

#include "app/gui/style.hpp"

#include <fmt/format.h>
#include <imgui/imgui.h>
#include <imgui/imgui_internal.h>

#include <algorithm>

namespace atrium::test {

HeadlessGui::HeadlessGui(float width, float height, float scale)
{
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {width, height};
    io.DeltaTime = 1.0f / 60.0f;
    io.MousePos = {-1, -1};
    gui::apply_style(scale);
    gui::load_font(scale);
    unsigned char* pixels = nullptr;
    int w = 0, h = 0;
    io.Fonts->GetTexDataAsRGBA32(&pixels, &w, &h);
}

HeadlessGui::~HeadlessGui()
{
    ImGui::DestroyContext();
}

void HeadlessGui::frame(const std::function<void()>& draw, bool in_window) const
{
    ImGui::NewFrame();
    if (in_window) {
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
        ImGui::Begin("test", nullptr,
                     ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove);
    }
    draw();
    if (in_window) ImGui::End();
    ImGui::Render();
}

void HeadlessGui::mouse(float x, float y, bool held) const
{
    ImGui::GetIO().MousePos = {x, y};
    ImGui::GetIO().MouseDown[0] = held;
}

void HeadlessGui::click(float x, float y, const std::function<void()>& draw, bool in_window) const
{
    for (const bool held : {false, true, false}) {
        mouse(x, y, held);
        frame(draw, in_window);
    }
}

void HeadlessGui::type(const char* text) const
{
    ImGui::GetIO().AddInputCharactersUTF8(text);
}

std::vector<std::string> HeadlessGui::cut_off() const
{
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    std::vector<std::string> out;
    for (const ImGuiWindow* w : ImGui::GetCurrentContext()->Windows) {
        if (!w->WasActive || w->Hidden || (w->Flags & ImGuiWindowFlags_Tooltip) != 0) continue;
        if (std::string(w->Name) == "Debug##Default") continue; // ImGui's own, never shown
        const ImVec2 end{w->Pos.x + w->Size.x, w->Pos.y + w->Size.y};
        const bool child = (w->Flags & ImGuiWindowFlags_ChildWindow) != 0; // its parent scrolls it
        if (!child && (w->Pos.x < 0 || w->Pos.y < 0 || end.x > display.x || end.y > display.y)) {
            out.push_back(fmt::format("{} lies at {},{} to {},{}", w->Name, w->Pos.x, w->Pos.y, end.x, end.y));
        }
        if (w->ScrollMax.x > 0.0f) out.push_back(fmt::format("{} lacks {} px of width", w->Name, w->ScrollMax.x));
        if (w->ScrollMax.y > 0.0f && w->ScrollbarY == false) {
            out.push_back(fmt::format("{} lacks {} px of height", w->Name, w->ScrollMax.y));
        }
        // Scrolled, but in no height worth the name.
        if (w->InnerRect.GetHeight() < ImGui::GetFontSize()) out.push_back(fmt::format("{} has no height", w->Name));
    }
    return out;
}

float HeadlessGui::lacking_tab_width() const
{
    const ImGuiTabBar& bar = *ImGui::GetCurrentContext()->TabBars.GetByIndex(0);
    return std::max(bar.WidthAllTabsIdeal - bar.BarRect.GetWidth(), 0.0f);
}

int HeadlessGui::vertices() const
{
    return ImGui::GetDrawData()->TotalVtxCount;
}

} // namespace atrium::test
