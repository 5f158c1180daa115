#include "renderer/techniques/lighting/ltc_table.hpp"

namespace atrium {
namespace {

const shared::LtcEntry table[] = {
#include "assets/ltc/table.inc"
};
static_assert(std::size(table) == shared::ltc_size * shared::ltc_size);

} // namespace

std::span<const shared::LtcEntry> ltc_table()
{
    return table;
}

} // namespace atrium
