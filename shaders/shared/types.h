// Read by C++ and GLSL: what lets one header declare structs and functions for both. Scalar block layout on both sides: every member
// stands at a multiple of its component's size, as glm lays it out.
#ifdef __cplusplus
#pragma once
#include "renderer/core/math.hpp"
#include <cstddef>
#include <cstdint>
#define SHARED_BEGIN namespace atrium::shared {
#define SHARED_END }
#define SHARED_FUNCTION [[nodiscard]] inline
namespace atrium::shared {
using uint = std::uint32_t;
}
#else
#extension GL_EXT_scalar_block_layout : require
#define SHARED_BEGIN
#define SHARED_END
#define SHARED_FUNCTION
#endif
