#include "app/view/gui.hpp"

#include "app/gui/style.hpp"
#include "app/gui/ui_image.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui/backends/imgui_impl_glfw.h>
#include <imgui/imgui.h>

#include <algorithm>

namespace atrium::app {
namespace {

void append(UiDraws& out, const ImDrawList& list, uvec2 pixels)
{
    const auto first_vertex = static_cast<std::uint32_t>(out.vertices.size());
    for (const ImDrawVert& v : list.VtxBuffer) out.vertices.push_back({{v.pos.x, v.pos.y}, {v.uv.x, v.uv.y}, v.col});
    for (const ImDrawCmd& c : list.CmdBuffer) {
        if (c.UserCallback) continue; // nobody here uses them
        const vec2 low = glm::max(vec2(c.ClipRect.x, c.ClipRect.y), vec2(0));
        const vec2 high = glm::min(vec2(c.ClipRect.z, c.ClipRect.w), vec2(pixels));
        if (high.x <= low.x || high.y <= low.y) continue;
        UiCommand command;
        command.clip_origin = uvec2(low);
        command.clip_size = uvec2(high) - command.clip_origin;
        command.first_index = static_cast<std::uint32_t>(out.indices.size());
        command.index_count = c.ElemCount;
        command.image = gui::image_of(c.TextureId);
        for (unsigned i = 0; i < c.ElemCount; ++i) {
            out.indices.push_back(first_vertex + c.VtxOffset + list.IdxBuffer[static_cast<int>(c.IdxOffset + i)]);
        }
        out.commands.push_back(command);
    }
}

} // namespace

Gui::Gui(Window& window, Engine& engine) : window_(window), engine_(engine)
{
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr; // the program keeps its own state
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    constexpr bool listens = false; // the window does
    ImGui_ImplGlfw_InitForVulkan(window.handle(), listens);
    set_scale(window.scale());
}

Gui::~Gui()
{
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void* Gui::insets()
{
    return gui::ui_image(shared::ui_insets);
}

void Gui::set_scale(float scale)
{
    scale_ = scale;
    gui::apply_style(scale);
    gui::load_font(scale);
    ImGuiIO& io = ImGui::GetIO();
    unsigned char* texels = nullptr;
    int width = 0, height = 0;
    io.Fonts->GetTexDataAsRGBA32(&texels, &width, &height);
    engine_.set_ui_font({static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)},
                        {reinterpret_cast<const std::byte*>(texels), static_cast<std::size_t>(width * height) * 4});
    io.Fonts->SetTexID(gui::ui_image(shared::ui_font));
}

std::vector<KeyPress> Gui::take_input()
{
    ImGuiIO& io = ImGui::GetIO();
    std::vector<KeyPress> presses;
    for (const InputEvent& event : window_.input().take_frame()) {
        if (const auto* move = std::get_if<MouseMove>(&event)) {
            mouse_ = move->at;
        } else if (const auto* button = std::get_if<MouseButton>(&event)) {
            buttons_.set(static_cast<std::size_t>(button->button), button->down);
        } else if (const auto* wheel = std::get_if<MouseWheel>(&event)) {
            io.MouseWheelH += wheel->by.x;
            io.MouseWheel += wheel->by.y;
        } else if (const auto* text = std::get_if<TextInput>(&event)) {
            io.AddInputCharacter(text->character);
        } else if (const auto* key = std::get_if<KeyChange>(&event)) {
            ImGui_ImplGlfw_KeyCallback(window_.handle(), key->key, key->scancode, key->action, key->mods);
            if (key->action == GLFW_PRESS) presses.push_back({key->key, key->mods});
        }
    }
    // In place of where and how the mouse is by now.
    io.MousePos = {mouse_.x, mouse_.y};
    for (std::size_t i = 0; i < std::size(io.MouseDown); ++i) io.MouseDown[i] = buttons_[i];
    return presses;
}

std::vector<KeyPress> Gui::begin(uvec2 pixels)
{
    if (window_.scale() != scale_) set_scale(window_.scale());
    ImGui_ImplGlfw_NewFrame();
    std::vector<KeyPress> presses = take_input();
    ImGui::GetIO().DisplaySize = {static_cast<float>(pixels.x), static_cast<float>(pixels.y)};
    ImGui::GetIO().DisplayFramebufferScale = {1, 1};
    ImGui::NewFrame();
    return presses;
}

UiDraws Gui::end()
{
    ImGui::Render();
    const ImDrawData& data = *ImGui::GetDrawData();
    UiDraws out;
    const uvec2 pixels(static_cast<std::uint32_t>(data.DisplaySize.x), static_cast<std::uint32_t>(data.DisplaySize.y));
    out.vertices.reserve(static_cast<std::size_t>(data.TotalVtxCount));
    out.indices.reserve(static_cast<std::size_t>(data.TotalIdxCount));
    for (int i = 0; i < data.CmdListsCount; ++i) append(out, *data.CmdLists[i], pixels);
    return out;
}

} // namespace atrium::app
