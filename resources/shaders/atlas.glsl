// Addresses of a packed atlas of triangle textures, as Trixel writes it. For GLSL 3.30 and later
// and for HLSL: define ATLAS_HLSL there. Before this file define
//   ATLAS_NUMBER(k)             number k of the atlas's table: "table" in its JSON, as 32-bit unsigned
//   ATLAS_FETCH(page, pixel)    the value of one pixel
//   ATLAS_SAMPLE(page, place)   the value at a place in pixels, interpolated by the hardware: with
//                               normalised coordinates, divide by the page's size; no mip levels
// A face's point is (u,v) of its barycentrics: its vertices are (0,0), (1,0), (0,1).
#ifdef ATLAS_HLSL
#define ivec2 int2
#define vec2 float2
#define vec4 float4
#define mix lerp
#endif

struct AtlasTile
{
    int page;
    ivec2 origin;
    int resolution;
    int border;
};

// The face's own level.
int atlasLevel(int face)
{
    return int(ATLAS_NUMBER(int(ATLAS_NUMBER(3)) + face) & 15u);
}

// The square that the face takes at a level that the atlas has of it.
AtlasTile atlasTile(int face, int level)
{
    int levelNumbers = 4 + 3 * level;
    uint rank = ATLAS_NUMBER(int(ATLAS_NUMBER(3)) + face) >> 4;
    if (ATLAS_NUMBER(1) == 0u) {
        rank -= ATLAS_NUMBER(levelNumbers + 2);
    }
    int grid = int(ATLAS_NUMBER(2)) + 6 * int(ATLAS_NUMBER(levelNumbers));
    int last = grid + 6 * (int(ATLAS_NUMBER(levelNumbers + 1)) - 1);
    while (grid < last && rank >= ATLAS_NUMBER(grid + 6)) {
        grid += 6;
    }
    uint k = rank - ATLAS_NUMBER(grid);
    uint perRow = ATLAS_NUMBER(grid + 2);
    AtlasTile tile;
    tile.resolution = 1 << level;
    tile.border = int(ATLAS_NUMBER(0));
    int side = tile.resolution + 4 * tile.border;
    tile.page = int(ATLAS_NUMBER(grid + 3));
    tile.origin = ivec2(int(ATLAS_NUMBER(grid + 4)), int(ATLAS_NUMBER(grid + 5))) +
                  side * ivec2(int(k % perRow), int(k / perRow));
    return tile;
}

// The pixel of the texel that holds a point. Cells are clamped before their fractions are taken.
ivec2 atlasPixel(AtlasTile tile, vec2 uv)
{
    vec2 p = uv * float(tile.resolution);
    ivec2 cell = ivec2(floor(p));
    int last = tile.resolution - 1;
    cell.x = cell.x < 0 ? 0 : cell.x > last ? last : cell.x;
    cell.y = cell.y < 0 ? 0 : cell.y > last ? last : cell.y;
    bool isUpper = (p.x - float(cell.x)) + (p.y - float(cell.y)) > 1.0;
    int lower = tile.border;
    int upper = last + 3 * tile.border;
    return tile.origin + (isUpper ? ivec2(upper - cell.y, upper - cell.x)
                                  : ivec2(lower + cell.x, lower + cell.y));
}

vec4 atlasNearest(int face, int level, vec2 uv)
{
    AtlasTile tile = atlasTile(face, level);
    return ATLAS_FETCH(tile.page, atlasPixel(tile, uv));
}

// Where a point lies among the lower texels (xy) and among the upper ones (zw), in pixels.
vec4 atlasPlaces(AtlasTile tile, vec2 uv)
{
    vec2 p = uv * float(tile.resolution);
    vec2 origin = vec2(float(tile.origin.x), float(tile.origin.y));
    float lower = float(tile.border) + 1.0 / 6.0;
    float upper = float(tile.resolution + 3 * tile.border) + 1.0 / 6.0;
    return vec4(origin.x + lower + p.x, origin.y + lower + p.y,
                origin.x + upper - p.y, origin.y + upper - p.x);
}

// The atlas must have borders. The mean of both halves: lower texels go on as the neighbour's upper.
vec4 atlasBilinear(int face, int level, vec2 uv)
{
    AtlasTile tile = atlasTile(face, level);
    vec4 places = atlasPlaces(tile, uv);
    return 0.5 * (ATLAS_SAMPLE(tile.page, places.xy) + ATLAS_SAMPLE(tile.page, places.zw));
}

// The atlas must have borders and mips.
vec4 atlasTrilinear(int face, float level, vec2 uv)
{
    float finest = float(atlasLevel(face));
    float clamped = level > 0.0 ? (level < finest ? level : finest) : 0.0;
    int coarse = int(floor(clamped));
    float toFine = clamped - float(coarse);
    vec4 value = atlasBilinear(face, coarse, uv);
    if (toFine > 0.0) {
        value = mix(value, atlasBilinear(face, coarse + 1, uv), toFine);
    }
    return value;
}
