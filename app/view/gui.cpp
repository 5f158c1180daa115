#include "app/view/gui.hpp"

#include "app/gui/style.hpp"
#include "app/gui/ui_image.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui/backends/imgui_impl_glfw.h>
#include <imgui/imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace atrium::app {
namespace {

using Triangle = std::array<shared::UiVertex, 3>;

/// What ImGui draws without a texture reads the font's one white texel.
bool is_plain(const Triangle& triangle)
{
    const ImVec2 white = ImGui::GetIO().Fonts->TexUvWhitePixel;
    return std::all_of(triangle.begin(), triangle.end(),
                       [&](const shared::UiVertex& v) { return v.uv.x == white.x && v.uv.y == white.y; });
}

/// In pixels.
float area(const Triangle& triangle)
{
    const vec2 a = triangle[1].position - triangle[0].position, b = triangle[2].position - triangle[0].position;
    return 0.5f * std::abs(a.x * b.y - a.y * b.x);
}

/// Adds a command. Reading the font is most of what a pixel costs lavapipe, so large plain triangles and the plain ones
/// that follow become commands of their own; small ones are not worth it.
void append_command(UiDraws& out, const UiCommand& whole)
{
    constexpr float worth_it = 2000; // pixels
    UiCommand run = whole;
    run.index_count = 0;
    const auto end_run = [&](std::uint32_t image) {
        if (run.index_count > 0) out.commands.push_back(run);
        run.first_index += run.index_count;
        run.index_count = 0;
        run.image = image;
    };
    for (std::uint32_t i = 0; i < whole.index_count; i += 3) {
        Triangle triangle;
        for (std::uint32_t k = 0; k < 3; ++k) triangle[k] = out.vertices[out.indices[whole.first_index + i + k]];
        const bool plain = is_plain(triangle);
        if (run.image == shared::ui_font && plain && area(triangle) >= worth_it) end_run(shared::ui_plain);
        if (run.image == shared::ui_plain && !plain) end_run(shared::ui_font);
        run.index_count += 3;
    }
    end_run(whole.image);
}

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
        append_command(out, command);
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
#if IMGUI_VERSION_NUM >= 18700
    io.AddMousePosEvent(mouse_.x, mouse_.y);
#else
    io.MousePos = {mouse_.x, mouse_.y};
#endif
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
