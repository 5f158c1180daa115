// Fragment stage of casters with holes, after a material class has been included. One mip level finer than a picture
// would read, so that thin leaves still cast.
layout(location = 0) in vec2 v_uv;
layout(location = 1) flat in uint v_record;

void main()
{
    GpuMaterial packed = material_table[record_table[v_record].material];
    Material m = unpack_material(packed.factors, packed.slots, packed.flags | v_record);
    if (is_hole(m, v_uv, -1.0)) discard;
}
