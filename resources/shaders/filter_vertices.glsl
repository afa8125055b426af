
// Interpolation between the lattice vertices of a face: the block of core/texture/vertex_block.h,
// levels 0 to the record's, coarse first. Appended to surface.frag.

// Vertices of the levels below one: the sums of 4^n, masked, of 3 2^n and of 2, halved.
int levelBegin(int level)
{
    int r = 1 << level;
    return (((r * r - 1) & 0x55555555) + 3 * (r - 1) + 2 * level) >> 1;
}

// The value between the three vertices about a point of a level that begins here.
vec4 levelValue(int begin, vec2 at, int r)
{
    vec2 p = at * float(r);
    ivec2 cell = min(ivec2(p), ivec2(r - 1)); // not below 0: points lie in the face
    cell.y = min(cell.y, r - 1 - cell.x);
    vec2 f = p - vec2(cell);
    int below = begin + ((cell.y * (2 * r + 3 - cell.y)) >> 1) + cell.x; // vertex (i, j)
    int above = below + r + 1 - cell.y;                                  // vertex (i, j + 1)
    // The cell below the hypotenuse has no upper texel.
    bool upper = f.x + f.y > 1.0 && cell.x + cell.y < r - 1;
    vec4 own = texelFetch(texels, upper ? above + 1 : below);
    vec4 right = texelFetch(texels, below + 1);
    vec4 left = texelFetch(texels, above);
    vec2 weights = upper ? 1.0 - f.yx : f;
    return own * (1.0 - weights.x - weights.y) + right * weights.x + left * weights.y;
}

// Between two levels. A face that has not the finer one shows what it has.
vec4 blockValue(uvec2 block, vec2 at, float level)
{
    int finest = int(block.y & kLevelMask);
    float wanted = clamp(level, 0.0, float(finest));
    int coarse = min(int(wanted), max(finest - 1, 0));
    float part = wanted - float(coarse);
    vec2 point = max(at, vec2(0.0));
    int r = 1 << coarse;
    int begin = int(block.x) + levelBegin(coarse);
    vec4 value = levelValue(begin, point, r);
    if (part > 0.0) {
        value = mix(value, levelValue(begin + (((r + 1) * (r + 2)) >> 1), point, 2 * r), part);
    }
    return value;
}
