// Where a cluster is, and whether it hides much.
/// A cluster's bounding sphere, from the eye, world axes.
struct ClusterSphere {
    vec3 d;
    float radius;
};

ClusterSphere sphere_of(DrawTask task)
{
    GpuCluster cluster = cluster_table[task.cluster];
    return ClusterSphere(transform_point(record_table[task.record].world_rows, cluster.centre) - frame.eye,
                         cluster.radius * record_table[task.record].max_scale);
}

/// Large triangles without holes: few of them hide much.
bool is_occluder(DrawTask task, ClusterSphere s)
{
    float triangles = float(cluster_table[task.cluster].index_count) / 3.0;
    bool large = s.radius * s.radius > occluder_angle2 * triangles * dot(s.d, s.d);
    return large && (record_table[task.record].flags & record_has_holes) == 0u;
}
