#pragma once
// The frame as passes that declare what they read and write. A Graph is built anew each frame (microseconds); the
// Runner plans it, keeps the memory of its images from frame to frame, and records it.

#include "renderer/core/math.hpp"
#include "renderer/gpu/pipelines.hpp"
#include "renderer/gpu/resources.hpp"
#include "renderer/graph/plan.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace atrium::graph {

inline constexpr ResourceIndex no_resource = ~0u;

/// An image of the graph.
struct Tex {
    ResourceIndex index = no_resource;
    explicit operator bool() const { return index != no_resource; }
};
/// A buffer of the graph.
struct Buf {
    ResourceIndex index = no_resource;
    explicit operator bool() const { return index != no_resource; }
};

/// What the size of a texture is relative to.
enum class SizeOf : std::uint8_t { absolute, render, output };

inline constexpr std::uint32_t all_mips = 0; ///< all mips down to one texel

/// When a texture is declared, its relative size is computed: Graph::desc() returns size and number of mips.
struct TexDesc {
    gpu::Format format = gpu::Format::none;
    std::uint32_t width = 1, height = 1, layers = 1;
    std::uint32_t mips = 1, samples = 1;
    SizeOf size_of = SizeOf::absolute;
    std::uint32_t divisor = 1; ///< of a relative size; the result is rounded up
    bool array = false;        ///< shaders read it as an array even if it has one layer
    bool operator==(const TexDesc&) const = default;
};

/// A texture of the render size or output size; each side is divided by `divisor` and rounded up.
[[nodiscard]] constexpr TexDesc render_sized(gpu::Format format, std::uint32_t divisor = 1)
{
    return {.format = format, .size_of = SizeOf::render, .divisor = divisor};
}
[[nodiscard]] constexpr TexDesc output_sized(gpu::Format format, std::uint32_t divisor = 1)
{
    return {.format = format, .size_of = SizeOf::output, .divisor = divisor};
}

/// Facts of the frame that a graph is built for.
struct FrameInfo {
    uvec2 render_size{0}, output_size{0}; ///< pixels
    /// Name of the view. Views that take turns on one runner have separate histories.
    std::string view = "main";
    bool cut = false; ///< the view shows something unrelated to its previous frame: no history is valid
};

/// Which views share a persistent resource, and when it is released.
enum class Owner : std::uint8_t {
    view,    ///< each view has its own; released after several frames of the view that did not declare it
    scene,   ///< one for all views; released the same way, counting frames of the view that declared it last
    program, ///< one for all views, as long as the runner lives
};

struct PersistentOptions {
    Owner owner = Owner::view;
    std::string key{}; ///< identifies it from frame to frame; empty: its name
};

/// The previous frame's contents of a persistent image or buffer.
template <class Handle>
struct History {
    Handle before{};    ///< empty if there are no contents at all
    bool valid = false; ///< the view's previous frame wrote it at this size, and there was no cut
};

/// A declared persistent resource. Internal to the graph.
struct PersistentUse {
    std::string key;
    std::uint64_t hash = 0;
    Owner owner = Owner::view;
    bool is_image = true;
    TexDesc desc;
    std::uint64_t bytes = 0;
    ResourceIndex now = no_resource, before = no_resource;
    bool history = false;
    std::vector<std::byte> note;
};

enum class CullMode : std::uint8_t { none, back };
enum class PassKind : std::uint8_t { raster, compute, transfer };

class Persistents;
class Runner;
class Uploads;

/// What a pass records with. Images and buffers that it declared are bound already (set 2, in order of declaration).
class Cmd {
public:
    /// Push constants: one plain struct shared with the shader, at most gpu::Descriptors::push_bytes.
    template <class T>
    void push(const T& constants)
    {
        static_assert(sizeof(T) <= gpu::Descriptors::push_bytes);
        push_bytes(&constants, sizeof(T));
    }
    void bind(std::size_t pipeline = 0); ///< the pass's n-th pipeline
    void cull(CullMode mode);
    /// Draws into a part of the targets, `origin` its upper left pixel, until the pass ends or the next call.
    void viewport(uvec2 origin, uvec2 size);
    /// Draws only into that part, with the viewport as it is.
    void scissor(uvec2 origin, uvec2 size);
    void clear_depth(uvec2 origin, uvec2 size, float depth); ///< a part of the depth target
    void draw_fullscreen();
    void bind_geometry(const gpu::Buffer& vertices, const gpu::Buffer& indices);
    void bind_geometry(const gpu::Buffer& vertices, Buf indices);
    void bind_indices(Buf indices); ///< for shaders that pull their vertices
    void draw_indexed(std::uint32_t first_index, std::uint32_t index_count, std::uint32_t first_instance);
    void draw_indexed_indirect(Buf commands, std::uint32_t first, std::uint32_t count);
    /// Enough work groups for this number of items, in several rows if one row would be too long: shaders take the
    /// index of an item from shaders/lib/dispatch.glsl.
    void dispatch(std::uint32_t items, std::uint32_t group_size);
    /// Enough work groups of 8 x 8 for the texels of a mip.
    void dispatch_over(Tex image, std::uint32_t mip = 0);
    void copy(Tex from, Buf to, std::uint32_t mip = 0); ///< all texels of a mip, rows tightly packed
    void copy(Buf from, Tex to);                        ///< the same the other way, mip 0
    void copy(Tex from, Tex to); ///< all texels as they stand, whatever both formats make of them
    void copy(Buf from, Buf to, std::uint64_t bytes);
    void fill(Buf buffer, std::uint32_t word);

    [[nodiscard]] VkCommandBuffer handle() const { return commands_; }

private:
    friend class Runner;
    Cmd(Runner& runner, VkCommandBuffer commands) : runner_(runner), commands_(commands) {}
    void push_bytes(const void* data, std::size_t size);
    Runner& runner_;
    VkCommandBuffer commands_;
    const struct Pass* pass_ = nullptr;
    std::uint32_t draws_ = 0, pipeline_binds_ = 0;
};

enum class Load : std::uint8_t {
    discard, ///< every pixel is written
    clear,
    keep, ///< drawn over or blended with what is there
};

struct Attachment {
    Tex texture;
    Load load = Load::discard;
    vec4 clear{0};
    std::uint32_t layer = 0, mip = 0;
    std::size_t use = 0; ///< index into Pass::uses
    Tex resolve{};       ///< of a multisampled target: the image that it is resolved into, if any
};

/// A declared use that shaders reach through set 2.
struct BoundUse {
    gpu::PassBinding at;
    std::size_t use = 0; ///< index into Pass::uses
};

/// A declared pass. Built by PassBuilder.
struct Pass {
    std::string name;
    PassKind kind = PassKind::raster;
    std::vector<Use> uses;
    std::vector<Attachment> colors;
    std::optional<Attachment> depth;
    bool depth_writes = false, side_effect = false;
    std::vector<gpu::GraphicsPipelineDesc> graphics;
    std::vector<gpu::ComputePipelineDesc> compute;
    std::vector<BoundUse> bound; ///< set 2, found by the runner, as is its layout
    gpu::PassLayout layout = 0;
    std::function<void(Cmd&)> record;
};

/// Chained declarations; see techniques/ for what they look like in use.
class PassBuilder {
public:
    PassBuilder& reads(Tex texture); ///< sampled, at the next binding of set 2; transfer: copied from
    PassBuilder& reads_layer(Tex texture, std::uint32_t layer); ///< one layer of it, bound as an image of its own
    PassBuilder& reads_mip(Tex texture, std::uint32_t mip);     ///< one mip, bound as an image with only this mip
    PassBuilder& reads(Buf buffer);
    PassBuilder& reads(Buf buffer, Access access);
    /// All texels of mip 0, or those of another mip or layer. Raster: the next colour target; compute: the next storage
    /// image of set 2; transfer: copied to.
    PassBuilder& writes(Tex texture, Load load = Load::discard, vec4 clear = vec4(0));
    PassBuilder& writes_layer(Tex texture, std::uint32_t layer, Load load = Load::discard, vec4 clear = vec4(0));
    PassBuilder& writes_mip(Tex texture, std::uint32_t mip, Load load = Load::discard, vec4 clear = vec4(0));
    /// Resolves the multisampled colour target declared last into this texture, which has one sample.
    PassBuilder& resolves(Tex texture);
    /// Writes a part, or also reads: what earlier passes wrote is kept. Compute and raster: the next storage image.
    PassBuilder& updates(Tex texture, std::uint32_t mip = 0);
    /// All of it. Compute: storage, at the next buffer binding of set 2; transfer: copied to.
    PassBuilder& writes(Buf buffer);
    PassBuilder& writes(Buf buffer, Access access);
    /// Part of it, or what is read too: what earlier passes wrote stays.
    PassBuilder& updates(Buf buffer);
    PassBuilder& updates(Buf buffer, Access access);
    PassBuilder& depth(Tex texture, Load load, float clear = 0); ///< tested and written
    PassBuilder& depth_test(Tex texture);                        ///< tested only
    PassBuilder& pipeline(gpu::GraphicsPipelineDesc desc);
    PassBuilder& pipeline(gpu::ComputePipelineDesc desc);
    PassBuilder& always(); ///< runs although nobody reads what it writes
    PassBuilder& record(std::function<void(Cmd&)> function);

    /// A full-screen triangle with this fragment shader, its specialisation constants 0, 1, … and push constants.
    PassBuilder& fullscreen(const std::string& fragment, std::vector<std::uint32_t> constants = {})
    {
        return fullscreen_pipeline(fragment, std::move(constants)).record([](Cmd& cmd) {
            cmd.bind();
            cmd.draw_fullscreen();
        });
    }
    template <class Push>
    PassBuilder& fullscreen(const std::string& fragment, std::vector<std::uint32_t> constants, const Push& push)
    {
        return fullscreen_pipeline(fragment, std::move(constants)).record([push](Cmd& cmd) {
            cmd.bind();
            cmd.push(push);
            cmd.draw_fullscreen();
        });
    }

private:
    friend class Graph;
    PassBuilder& fullscreen_pipeline(const std::string& fragment, std::vector<std::uint32_t> constants);
    PassBuilder& use(Tex texture, Access access, SubresourceRange range, bool discard = false);
    PassBuilder& write(Tex texture, std::uint32_t mip, std::uint32_t layer, Load load, vec4 clear);
    PassBuilder(class Graph& graph, std::size_t pass) : graph_(graph), pass_(pass) {}
    Pass& pass();
    Graph& graph_;
    std::size_t pass_;
};

class Graph {
public:
    Graph() = default; ///< without textures of a relative size
    explicit Graph(const FrameInfo& frame) : frame_(frame) {}
    Graph(Runner& runner, const FrameInfo& frame); ///< with persistent resources, which the runner keeps

    [[nodiscard]] Tex texture(std::string name, const TexDesc& desc);
    /// A buffer of the frame, `bytes` long, in device memory.
    [[nodiscard]] Buf buffer(std::string name, std::uint64_t bytes);
    /// An image or buffer that is kept from frame to frame, identified by its key. With another description it is
    /// created again, without contents, and must be written before it is read. Throws std::logic_error in a graph
    /// without a runner, and if the graph already has one with the same key and another description.
    [[nodiscard]] Tex persistent(std::string name, const TexDesc& desc, const PersistentOptions& options = {});
    [[nodiscard]] Buf persistent(std::string name, std::uint64_t bytes, const PersistentOptions& options = {});
    /// The previous frame's contents of a persistent resource. The resource itself then has other memory in this frame,
    /// without contents until it is written. Call it before the resource's first use.
    [[nodiscard]] History<Tex> history(Tex texture);
    [[nodiscard]] History<Buf> history(Buf buffer);
    /// Whether a persistent resource has contents that some earlier frame wrote.
    [[nodiscard]] bool holds(Tex texture) const { return resources_[texture.index].holds; }
    [[nodiscard]] bool holds(Buf buffer) const { return resources_[buffer.index].holds; }
    /// The persistent image with that key, if there is one that views share and it has contents.
    [[nodiscard]] std::optional<Tex> kept(const std::string& key);
    /// An image (R32F) of one texel, filled once: the result of a technique that is off. Call it before declaring the
    /// pass that reads it, because the pass that fills it must come first.
    [[nodiscard]] Tex constant(float value);
    /// The same for shaders that bind an array of images.
    [[nodiscard]] Tex constant_array(float value);
    /// The value of such an image; nothing for any other image. It has only one texel, so shaders that read at pixel
    /// positions must not read it.
    [[nodiscard]] std::optional<float> constant_value(Tex texture) const { return resources_[texture.index].constant; }
    /// Describes the contents that a persistent resource will have after the frame. Stored with the contents if the
    /// frame is submitted; contents written by a frame without a note have none.
    template <class T, class Handle>
    void note(Handle resource, const T& what)
    {
        static_assert(std::is_trivially_copyable_v<T>);
        write_note(resource.index, std::as_bytes(std::span(&what, 1)));
    }
    /// The note of its present contents (for a history: of the previous frame's).
    template <class T, class Handle>
    [[nodiscard]] std::optional<T> noted(Handle resource) const
    {
        static_assert(std::is_trivially_copyable_v<T>);
        const std::span<const std::byte> bytes = read_note(resource.index);
        if (bytes.size() != sizeof(T)) return std::nullopt;
        std::array<std::byte, sizeof(T)> copy;
        std::copy(bytes.begin(), bytes.end(), copy.begin());
        return std::bit_cast<T>(copy);
    }
    /// A buffer of the frame that holds a copy of these items; its memory may be longer. Throws std::logic_error in a
    /// graph without a runner.
    template <class T>
    [[nodiscard]] Buf upload(const std::string& name, const std::vector<T>& items)
    {
        static_assert(std::is_trivially_copyable_v<T>);
        return upload_bytes(name, std::as_bytes(std::span(items)));
    }
    /// A buffer that outlives the frame, such as one the CPU reads afterwards. `initial`: how it was last used.
    [[nodiscard]] Buf import(std::string name, const gpu::Buffer& buffer, Access initial = Access::none);
    /// The same of an image. Its own usage must allow what passes do with it.
    [[nodiscard]] Tex import(std::string name, const gpu::Image& image, Access initial = Access::none);
    /// The resource's contents are wanted after the frame, in the state of `access`.
    void keep(Buf buffer, Access access) { keep(buffer.index, access); }
    void keep(Tex texture, Access access) { keep(texture.index, access); }

    PassBuilder raster(std::string name) { return add(std::move(name), PassKind::raster); }
    PassBuilder compute(std::string name) { return add(std::move(name), PassKind::compute); }
    PassBuilder transfer(std::string name) { return add(std::move(name), PassKind::transfer); }

    [[nodiscard]] const TexDesc& desc(Tex texture) const { return resources_[texture.index].desc; }
    /// Texels of a mip.
    [[nodiscard]] uvec2 size(Tex texture, std::uint32_t mip = 0) const;
    [[nodiscard]] std::size_t pass_count() const { return passes_.size(); }
    [[nodiscard]] std::uint64_t bytes(Buf buffer) const { return resources_[buffer.index].bytes; }
    [[nodiscard]] std::optional<Tex> find(const std::string& name) const; ///< the image called so, if any
    /// Images with one sample that the passes declared so far can read, by name: imported ones, persistent ones with
    /// contents, and those that a pass writes.
    [[nodiscard]] std::vector<std::pair<std::string, Tex>> readable_images() const;

private:
    friend class PassBuilder;
    friend class Runner;
    struct Resource {
        std::string name;
        bool is_image = true;
        TexDesc desc;
        std::uint64_t bytes = 0;
        const gpu::Buffer* imported = nullptr; ///< one of these, or none where the resource is the frame's own
        const gpu::Image* imported_image = nullptr;
        [[nodiscard]] bool is_imported() const { return imported || imported_image; }
        Access initial = Access::none;
        bool keep = false;
        std::uint32_t persistent = no_resource; ///< index into persistents_, if it is one
        bool is_history = false, holds = false;
        std::optional<float> constant; ///< constant_value()
        [[nodiscard]] bool is_persistent() const { return persistent != no_resource; }
    };
    PassBuilder add(std::string name, PassKind kind);
    void keep(ResourceIndex resource, Access access);
    [[nodiscard]] TexDesc resolved(const std::string& name, TexDesc desc) const;
    [[nodiscard]] Buf upload_bytes(std::string name, std::span<const std::byte> bytes);
    ResourceIndex add_persistent(PersistentUse use, std::string name);
    Tex add_constant(float value, bool array);
    ResourceIndex add_history(ResourceIndex now, bool& valid);
    void write_note(ResourceIndex resource, std::span<const std::byte> bytes);
    [[nodiscard]] std::span<const std::byte> read_note(ResourceIndex resource) const;
    FrameInfo frame_;
    Uploads* uploads_ = nullptr; ///< of the frame in flight, if there is a runner
    const Persistents* store_ = nullptr;
    std::uint32_t view_ = 0;  ///< of the store
    std::uint64_t epoch_ = 0; ///< of the store, at the first declaration
    std::vector<PersistentUse> persistents_;
    std::vector<Resource> resources_;
    std::vector<Pass> passes_;
    std::vector<FinalUse> finals_;
};

} // namespace atrium::graph
