
// By the geometric mean of the footprint's axes, half a texel in both of them.
vec4 filteredTexel()
{
    vec3 moves = steps(tilt);
    float pixel2 = pixelVariance();
    float texel2 = exp2(2.0 * log2Scale.y);
    float least = 0.25 * texel2;
    float area2 = max(moves.x * moves.y - moves.z * moves.z, 0.0);
    float variance =
        sqrt(pixel2 * (pixel2 * area2 + least * (moves.x + moves.y)) + least * least);
    return blockValue(record, uv, levelFor(variance, texel2));
}
