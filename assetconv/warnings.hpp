#pragma once
// What a bake noticed but could live with: counted by kind, the first place of each kept.

#include "renderer/scene/scene.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace atrium {

/// What one kind of warning means to the user. Kinds are listed in docs/assetconv.md.
struct WarningKind {
    const char* name;
    const char* meaning; ///< "…, so …": what was found and what was done
    const char* next;    ///< what the user can do
    bool strict;         ///< an error under --strict
};

[[nodiscard]] std::span<const WarningKind> warning_kinds();

/// Not thread-safe: jobs fill their own and merge() them in order, so that the first place does not depend on timing.
class Warnings {
public:
    explicit Warnings(bool strict = false) : strict_(strict) {}

    /// `kind` is one of warning_kinds(); `where` tells the place ("file:line, …"). Throws Error(input) for kinds that
    /// --strict refuses.
    void add(std::string_view kind, const std::string& where, std::uint64_t count = 1);
    void merge(const Warnings& other);

    /// In order of first appearance.
    [[nodiscard]] const std::vector<BakeWarning>& list() const { return list_; }
    [[nodiscard]] std::uint64_t count(std::string_view kind) const;

private:
    std::vector<BakeWarning> list_;
    bool strict_;
};

} // namespace atrium
