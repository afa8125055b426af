
// Trilinear at one place. Appended to filter_vertices.glsl.
vec4 filteredTexel()
{
#if VERTEX_LEVELS == 1
    return blockValue(record, uv, level);
#else
    return blockValue(record, uv, seamlessLevel(viewPosition, tilt, log2Scale));
#endif
}
