#pragma once
// Images and buffers that are kept from frame to frame, and the state of their contents. The Runner owns them; graphs
// read the state at declaration, and the Runner updates it only after the frame has been submitted.

#include "renderer/graph/graph.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace atrium::graph {

/// One piece of memory.
struct PersistentSlot {
    gpu::Image image;
    gpu::Buffer buffer;
    std::vector<PartState> parts; ///< empty: no memory yet
    std::vector<std::byte> note;  ///< Graph::note() of the frame that wrote the contents
    [[nodiscard]] bool holds() const;
};

class Persistents {
public:
    using Slot = PersistentSlot;
    /// One declared resource: a slot, and a second slot if it has a history.
    struct Entry {
        std::uint64_t hash = 0; ///< of `key`
        std::string key;
        Owner owner = Owner::view;
        bool is_image = true;
        TexDesc desc;
        std::uint64_t bytes = 0;
        std::array<Slot, 2> slots;
        std::uint32_t current = 0; ///< the slot with the contents of the last frame that wrote them
        std::uint32_t view = 0;    ///< that declared it last
        std::uint32_t unused = 0;  ///< graphs of that view since
        std::uint64_t written = 0; ///< frame number of that view; 0: never
        [[nodiscard]] bool matches(const PersistentUse& use) const;
    };

    explicit Persistents(const gpu::Device& device) : device_(device) {}

    [[nodiscard]] std::uint32_t view(std::string_view name); ///< its index
    /// Number of the view's last frame that was submitted, from 1; 0: none was.
    [[nodiscard]] std::uint64_t last_frame(std::uint32_t view) const { return views_[view].frames; }
    [[nodiscard]] const Entry* find(std::uint64_t hash, std::string_view key) const;
    /// Changes whenever the state that a graph has read may be out of date.
    [[nodiscard]] std::uint64_t epoch() const { return epoch_; }

    /// Allocates memory for everything that is declared. Resources with the same description keep memory and contents.
    void create(const std::vector<PersistentUse>& uses);
    /// The slot behind a declared resource, after create(); `history`: the one of the frame before.
    [[nodiscard]] Slot& slot(const PersistentUse& use, bool history);
    /// A frame of `view` was submitted. `written`: by resource of the graph.
    void commit(const std::vector<PersistentUse>& uses, std::uint32_t view, const Plan& plan,
                const std::vector<bool>& written);
    /// Releases resources that no recent frame declared. The device must be idle.
    void release_unused();
    void forget(); ///< releases everything except Owner::program. The device must be idle.

private:
    struct View {
        std::string name;
        std::uint64_t frames = 0;
    };
    [[nodiscard]] Entry& entry(const PersistentUse& use);
    void make(Entry& entry, Slot& slot) const;

    const gpu::Device& device_;
    std::vector<Entry> entries_;
    std::vector<View> views_;
    std::uint64_t epoch_ = 0;
};

} // namespace atrium::graph
