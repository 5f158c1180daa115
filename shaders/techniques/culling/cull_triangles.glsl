// One subgroup per draw command: copies the indices of those of its triangles that are to be drawn, in their order, and
// makes the command draw the copy. Which ones, the including shader says in keep_triangle().
// With REMEMBERS, those are for the next frame to begin with, and a second list holds those of them that this frame has
// not drawn yet.
// Source: Wihlidal 2016, "Optimizing the Graphics Pipeline with Compute", GDC.
#extension GL_KHR_shader_subgroup_ballot : require
#include "lib/dispatch.glsl"
#include "lib/pass.glsl"
#include "lib/scene.glsl"
#include "shared/culling.h"
#ifdef REMEMBERS
#include "techniques/culling/cluster_sphere.glsl"
#endif

layout(local_size_x_id = 0) in; // a subgroup
layout(set = 1, binding = 4, scalar) readonly buffer TaskTable { DrawTask task_table[]; };
layout(set = 1, binding = 5, scalar) readonly buffer OrderTable { uint order_table[]; };
layout(set = 1, binding = 6, scalar) readonly buffer VertexTable { PackedVertex vertex_table[]; };
layout(set = 1, binding = 7, scalar) readonly buffer IndexTable { uint index_table[]; };
layout(PASS_BUFFER(0), scalar) buffer Commands { DrawCommand commands[]; };
layout(PASS_BUFFER(1), scalar) writeonly buffer Kept { uint kept_indices[]; };
#ifdef REMEMBERS
layout(PASS_BUFFER(3), scalar) writeonly buffer SeenCommands { DrawCommand seen_commands[]; };
layout(PASS_BUFFER(4), scalar) writeonly buffer SeenOccluders { DrawCommand seen_occluder_commands[]; };
layout(PASS_BUFFER(5), scalar) writeonly buffer Seen { uint seen_indices[]; };
layout(PASS_BUFFER(6), scalar) buffer SeenIn { uint seen_in[]; }; // frame in which a triangle was last seen
#endif

// How far rasterisation may move a position, pixels: what comes nearer than that to covering a pixel's centre is kept.
layout(constant_id = 1) const float snap = 1.0 / 16.0;

/// A triangle on the screen.
struct ScreenTriangle {
    bool covers;    // it may cover the centre of a pixel
    bool crosses;   // the near plane; what follows means nothing then
    vec2 low, high; // bounds in pixels, widened by `snap`
    float nearest;  // depth of its nearest corner, reversed
};

/// Number of tasks, one work group each; the dispatch may have more groups.
uint task_count();

/// Whether the triangle is drawn. `instances`: of its cluster's command, as the pass before wrote it.
bool keep_triangle(uint instances, ScreenTriangle t);

/// x, y, w, to the bit as the vertex stage has them.
vec3 clip_position(vec4 rows[3], uint vertex)
{
    precise vec3 world = transform_point(rows, vertex_table[vertex].position);
    precise vec4 clip = frame.clip_from_world * vec4(world, 1);
    return clip.xyw;
}

/// Whether a small triangle covers the centre of any pixel between `low` and `high`. Source: Pineda 1988, "A Parallel
/// Algorithm for Polygon Rasterization".
bool covers_a_centre(vec2 p, vec2 q, vec2 r, float area2, vec2 low, vec2 high)
{
    vec2 size = high - low, from = ceil(low - 0.5) + 0.5;
    float turn = area2 >= 0.0 ? 1.0 : -1.0, slack = 3.0 * snap * (size.x + size.y); // of an edge whose ends move by `snap`
    vec2 a = turn * (q - p), b = turn * (r - q), c = turn * (p - r);
    bool inside = false;
    for (float y = from.y; y <= high.y; y += 1.0) {
        for (float x = from.x; x <= high.x; x += 1.0) {
            vec3 edges = vec3(a.y * (x - p.x) - a.x * (y - p.y), b.y * (x - q.x) - b.x * (y - q.y), c.y * (x - r.x) - c.x * (y - r.y));
            inside = inside || all(greaterThan(edges, vec3(-slack)));
        }
    }
    return inside;
}

ScreenTriangle on_screen(vec3 a, vec3 b, vec3 c, bool one_sided)
{
    ScreenTriangle t = ScreenTriangle(false, false, vec2(0.0), vec2(0.0), 0.0);
    vec3 x = vec3(a.x, b.x, c.x), y = vec3(a.y, b.y, c.y), w = vec3(a.z, b.z, c.z);
    if (all(greaterThan(x, w)) || all(greaterThan(-x, w)) || all(greaterThan(y, w)) || all(greaterThan(-y, w)) ||
        all(lessThan(w, vec3(frame.near)))) {
        return t;
    }
    t.crosses = any(lessThan(w, vec3(frame.near)));
    t.covers = true;
    if (t.crosses) return t; // to be clipped
    vec2 p = (vec2(a.x, -a.y) / a.z * 0.5 + 0.5) * frame.size, q = (vec2(b.x, -b.y) / b.z * 0.5 + 0.5) * frame.size,
         r = (vec2(c.x, -c.y) / c.z * 0.5 + 0.5) * frame.size;
    t.low = min(p, min(q, r)) - snap;
    t.high = max(p, max(q, r)) + snap;
    t.nearest = frame.near / min(a.z, min(b.z, c.z));
    // No centre of a pixel (at .5) between the least and the greatest coordinate.
    if (any(equal(floor(t.low + 0.5), floor(t.high + 0.5)))) t.covers = false;
    vec2 e = q - p, f = r - p, size = t.high - t.low;
    float area2 = e.y * f.x - e.x * f.y; // twice the area, positive from the front
    if (one_sided && area2 <= -2.0 * snap * (abs(e.x) + abs(e.y) + abs(f.x) + abs(f.y))) t.covers = false;
    if (t.covers && max(size.x, size.y) < 4.0) t.covers = covers_a_centre(p, q, r, area2, t.low, t.high);
    return t;
}

/// Where this invocation's triangle goes in a list that has `count` indices so far.
uint place_in(uint slot, uint count, uvec4 ballot)
{
    return slot + count + 3u * subgroupBallotExclusiveBitCount(ballot);
}

DrawCommand command_of(DrawTask task, uint index_count)
{
    return DrawCommand(index_count, index_count > 0u ? 1u : 0u, task.slot, record_table[task.record].vertex_offset,
                       task.record);
}

#ifdef REMEMBERS
void remember(uint i, DrawTask task, uint index_count)
{
    seen_commands[i] = command_of(task, index_count);
    seen_occluder_commands[i] = command_of(task, is_occluder(task, sphere_of(task)) ? index_count : 0u);
}
#endif

void main()
{
    uint i = GROUP_INDEX;
    if (gl_SubgroupID > 0u || i >= task_count()) return;
    DrawTask task = task_table[order_table[i]];
    uint instances = commands[i].instance_count;
    if (instances == 0u) {
#ifdef REMEMBERS
        if (subgroupElect()) remember(i, task, 0u);
#endif
        return;
    }
    GpuCluster cluster = cluster_table[task.cluster];
    vec4 rows[3] = record_table[task.record].world_rows;
    uint vertex_offset = uint(record_table[task.record].vertex_offset);
    bool one_sided = (record_table[task.record].flags & record_two_sided) == 0u;
    bool deformed = (record_table[task.record].flags & record_deformed) != 0u;

    uint kept = 0u;
#ifdef REMEMBERS
    uint seen = 0u;
#endif
    for (uint first = 0u; first < cluster.index_count; first += 3u * gl_SubgroupSize) {
        uint index = first + 3u * gl_SubgroupInvocationID;
        bool keep = false;
        uvec3 corners = uvec3(0u);
#ifdef REMEMBERS
        bool drawn = false;
#endif
        if (index < cluster.index_count) {
            uint at = cluster.first_index + index;
            corners = uvec3(index_table[at], index_table[at + 1u], index_table[at + 2u]);
#ifdef REMEMBERS
            drawn = seen_in[(task.slot + index) / 3u] + 1u == push.frame;
            keep = drawn && (i + push.frame) % frames_until_asked_again != 0u;
#endif
        }
        if (index < cluster.index_count && !keep) {
            ScreenTriangle t = on_screen(clip_position(rows, vertex_offset + corners.x),
                                         clip_position(rows, vertex_offset + corners.y),
                                         clip_position(rows, vertex_offset + corners.z), one_sided);
            keep = deformed || keep_triangle(instances, t);
        }
#ifdef REMEMBERS
        uvec4 see = subgroupBallot(keep);
        if (keep) {
            uint to = place_in(task.slot, seen, see), triangle = (task.slot + index) / 3u;
            seen_indices[to] = corners.x;
            seen_indices[to + 1u] = corners.y;
            seen_indices[to + 2u] = corners.z;
            keep = !drawn;
            seen_in[triangle] = push.frame;
        }
        seen += 3u * subgroupBallotBitCount(see);
#endif
        uvec4 ballot = subgroupBallot(keep);
        if (keep) {
            uint to = place_in(task.slot, kept, ballot);
            kept_indices[to] = corners.x;
            kept_indices[to + 1u] = corners.y;
            kept_indices[to + 2u] = corners.z;
        }
        kept += 3u * subgroupBallotBitCount(ballot);
    }
    if (subgroupElect()) {
        commands[i] = command_of(task, kept);
#ifdef REMEMBERS
        remember(i, task, seen);
#endif
    }
}
