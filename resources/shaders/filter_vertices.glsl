
// Interpolation between the lattice vertices of a face: the block of core/texture/vertex_block.h,
// levels 0 to the record's, coarse first. Appended to surface.frag.

// Vertices of the levels below one.
int levelBegin(int level)
{
    int r = 1 << level;
    return ((r * r - 1) / 3 + 3 * (r - 1) + 2 * level) / 2;
}

// The value between the three vertices about a point.
vec4 levelValue(uvec2 block, vec2 at, int level)
{
    int r = 1 << level;
    vec2 p = at * float(r);
    ivec2 cell = clamp(ivec2(p), ivec2(0), ivec2(r - 1));
    cell.y = min(cell.y, r - 1 - cell.x);
    vec2 f = p - vec2(cell);
    int below = cell.y * (2 * r + 3 - cell.y) / 2 + cell.x; // vertex (i, j)
    int above = below + r + 1 - cell.y;                     // vertex (i, j + 1)
    // The cell below the hypotenuse has no upper texel.
    bool upper = f.x + f.y > 1.0 && cell.x + cell.y < r - 1;
    int begin = int(block.x) + levelBegin(level);
    int one = 1;
    if ((block.y & kConstant) != 0u) {
        begin = int(block.x);
        below = 0;
        above = 0;
        one = 0;
    }
    vec4 own = texelFetch(texels, begin + (upper ? above + one : below));
    vec4 right = texelFetch(texels, begin + below + one);
    vec4 left = texelFetch(texels, begin + above);
    vec2 weights = upper ? 1.0 - f.yx : f;
    return own * (1.0 - weights.x - weights.y) + right * weights.x + left * weights.y;
}

// Between two levels. A face that has not the finer one shows what it has.
vec4 blockValue(uvec2 block, vec2 at, float level)
{
    int finest = int(block.y & kLevelMask);
    float wanted = clamp(level, 0.0, float(finest));
    int coarse = int(wanted);
    vec4 value = levelValue(block, at, coarse);
    vec4 finer = levelValue(block, at, min(coarse + 1, finest));
    return mix(value, finer, wanted - float(coarse));
}

// What a pixel averages, in view space. Everything in it is the same on both sides of an edge: it
// comes from the point and from what is interpolated between mesh vertices. A face's own plane
// would give each side of an edge another footprint, and so another level.
struct Footprint
{
    float majorSigma;    // of the ellipse, world units, the floor of half a texel in it
    float minorSigma;
    vec2 majorDirection; // on the screen
    float perPixel;      // world length along it of one pixel
    float texel;         // edge of a texel
};

Footprint pixelFootprint()
{
    float depth = max(-viewPosition.z, 1e-30);
    vec3 ray = viewPosition / depth;
    // How the surface falls away to the right and upwards. Where the faces about a vertex lie in
    // different planes no one tilt fits them: there it counts for little.
    float cosine = dot(meanNormal, ray);
    float least = 0.04 * length(meanNormal) * length(ray) + 1e-20;
    cosine = cosine < 0.0 ? min(cosine, -least) : max(cosine, least);
    vec2 tilt = meanNormal.xy / cosine * smoothstep(0.55, 0.9, flatness);
    // Wx = (1,0,0) - tilt.x ray and Wy = (0,1,0) - tilt.y ray, by depth and size of a pixel.
    float size = dot(ray, ray);
    float xx = 1.0 - 2.0 * tilt.x * ray.x + tilt.x * tilt.x * size;
    float yy = 1.0 - 2.0 * tilt.y * ray.y + tilt.y * tilt.y * size;
    float xy = -tilt.y * ray.x - tilt.x * ray.y + tilt.x * tilt.y * size;
    float mean = 0.5 * (xx + yy);
    float slant = 0.5 * (xx - yy);
    float radius = sqrt(slant * slant + xy * xy);
    float major = mean + radius;
    float minor = max(xx * yy - xy * xy, 0.0) / major;
    float pixel = depth * unitsPerPixel;

    Footprint result;
    result.texel = exp2(log2Scale.y);
    float least2 = 0.25 * result.texel * result.texel;
    result.majorSigma = sqrt(0.25 * pixel * pixel * major + least2);
    result.minorSigma = sqrt(0.25 * pixel * pixel * minor + least2);
    vec2 direction = slant >= 0.0 ? vec2(slant + radius, xy) : vec2(xy, radius - slant);
    float strength = length(direction);
    result.majorDirection = strength > 1e-20 ? direction / strength : vec2(1.0, 0.0);
    result.perPixel = pixel * sqrt(major);
    return result;
}

// The level at which interpolation averages with a variance. A vertex's hexagon and the slopes about
// it have 0.2917 of a texel's edge squared more than the texel, whose own is 1/24; base texels count
// as points.
float levelFor(float variance, float texel)
{
    float edge2 = (variance + texel * texel / 24.0) / (1.0 / 24.0 + 0.2917);
    return log2Scale.x - 0.5 * log2(edge2);
}
