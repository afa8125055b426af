#version 410 core
// SPDX-License-Identifier: GPL-3.0-or-later

// LIT, WIREFRAME, TEXEL_GRID, ALPHA, MARKS and PAINTED are defined as 0 or 1, LOOK as 0 to 4: a program for
// each way of drawing, because a processor that draws runs both sides of every branch.
// LOOK is 0 for values as they are, 1 for colours in a range, 2 for a number as grey, 3 for a number
// in false colour: what render/look.cpp does on the processor; and 4 for a colour a face.
// VERTEX_LEVELS is 1 where the level of a filtered pixel was found at the corners of its face.
// LIMIT is 1 where pieces of the limit surface are drawn in place of whole faces.
// FILTERING is the number of `Filtering` in render/filtering.h. From 2 on a piece that follows has
// `filteredTexel`.
uniform samplerBuffer texels;
uniform samplerBuffer faceColors;  // one a face, or three, one at each corner
uniform int colorsPerFace;
uniform samplerBuffer scaleColors; // of false colour
uniform vec3 markColors[5];        // by the kind of mark
uniform float black;               // a value is shown at (value - black) * scale
uniform float scale;
uniform float most;    // larger values are clipped
uniform int component; // that is the number, or -1 for the luminance
uniform usamplerBuffer squares;    // a face: its square in the sheet, 0 where it has none
uniform sampler2D sheet;           // of paint: how far a stroke covers each texel
uniform vec4 paint;                // that the stroke moves texels towards
uniform bool paintIsPicture;       // or colours of its own a texel, and how far they cover
uniform ivec3 paintParts;          // of those colours that the first three channels take
uniform bool paintIsUnit;          // texels cannot leave [0, 1]
uniform bool hasNormals;
uniform float lineWidth; // device pixels

in vec2 place; // by the labels 1 and 2
in vec3 viewPosition;
in vec3 viewNormal;
flat in uvec2 record;
flat in int faceNumber;
flat in int labels; // of the face's corner 1, and four times that of its corner 2
#if VERTEX_LEVELS == 1
in float level;
#elif FILTERING >= 3
in vec2 log2Scale; // of the length of edges, and of texels, about here
in vec2 tilt;
#endif
out vec4 color;

vec2 uv; // in the face

// Bits of a face's record, as `FaceRecord` in render/display_texels.h has them.
const uint kLevelMask = 0xffu;
const uint kConstant = 0x100u;
const uint kPending = 0x200u;
const uint kOwnShift = 16u; // of the level that the face has, whatever of it is here

const vec3 kPendingColor = vec3(0.45);
const vec3 kWireColor = vec3(0.02, 0.03, 0.05);
// Lines that stand closer than so many pixels vanish, or they would turn into a grey film.
const float kFadeFrom = 3.0;
const float kFadeTo = 9.0;

// Packed index of the texel that holds a point, in texel units. The cell is clamped before its
// fractions are taken: v = 1 would read outside, u = 1 wrap into the next row.
int texelIndex(vec2 p, int resolution)
{
#if FILTERING == 1
    // What programs do that take the face's square for a picture: the pixel at (u, v), drawn in by
    // an epsilon, or the hypotenuse would show the other half, mirrored.
    ivec2 pixel = ivec2(p * (1.0 - 1e-4));
    pixel = clamp(pixel, ivec2(0), ivec2(resolution - 1));
    return pixel.x + min(pixel.y, resolution - 1 - pixel.x) * resolution;
#endif
    ivec2 cell = clamp(ivec2(floor(p)), ivec2(0), ivec2(resolution - 1));
    vec2 f = p - vec2(cell);
    bool upper = f.x + f.y > 1.0;
    return upper ? resolution * resolution - 1 - (cell.y + cell.x * resolution)
                 : cell.x + cell.y * resolution;
}

// What a texel shows: a colour and opacity, or the place of a number on its scale in x, -1 where
// that is NaN; and what mark it deserves, worse ones being greater.
struct Shown
{
    vec4 parts;
    float mark;
};

// By their bits, because compilers take it that no number is NaN.
uint magnitude(float x)
{
    return floatBitsToUint(x) & 0x7fffffffu;
}

const uint kInfinite = 0x7f800000u;

float markOf(float x, float limit)
{
    uint bits = magnitude(x);
    return bits > kInfinite ? 4.0 : bits == kInfinite ? 3.0 : x < 0.0 ? 2.0 : x > limit ? 1.0 : 0.0;
}

float markOf(vec4 texel)
{
    if (LOOK >= 2 && component >= 0) {
        return markOf(texel[component], most);
    }
    float mark = max(markOf(texel.r, most), max(markOf(texel.g, most), markOf(texel.b, most)));
    return ALPHA == 1 ? max(mark, markOf(texel.a, 1.0)) : mark;
}

// Into [0, 1]; NaN becomes 0.
float inside(float x)
{
    return magnitude(x) > kInfinite ? 0.0 : clamp(x, 0.0, 1.0);
}

vec4 inside(vec4 x)
{
    return vec4(inside(x.r), inside(x.g), inside(x.b), inside(x.a));
}

float numberOf(vec4 texel)
{
    return component >= 0 ? texel[component]
                          : 0.2126 * texel.r + 0.7152 * texel.g + 0.0722 * texel.b;
}

Shown shownOf(vec4 texel)
{
    Shown result;
    result.mark = MARKS == 1 ? markOf(texel) : 0.0;
    if (LOOK <= 1) {
        vec3 parts = LOOK == 1 ? (texel.rgb - black) * scale : texel.rgb;
        result.parts = inside(vec4(parts, texel.a));
    } else {
        float place = (numberOf(texel) - black) * scale;
        bool isNone = LOOK == 3 && magnitude(place) > kInfinite;
        result.parts = vec4(isNone ? -1.0 : inside(place), 0.0, 0.0, 1.0);
    }
    return result;
}

// The face's square: `PaintSquare::word` in render/paint_squares.h.
uint squareWord()
{
    return PAINTED == 1 ? texelFetch(squares, faceNumber).x : 0u;
}

// A texel as the stroke in progress leaves it: what `TexelBlend` does on the processor.
vec4 painted(vec4 texel, vec2 p, int resolution)
{
    uint word = squareWord();
    if (word == 0u) {
        return texel;
    }
    int level = int(word >> 26 & 0xfu);
    int side = 1 << level;
    int index = texelIndex(p * (float(side) / float(resolution)), side);
    ivec2 place = ivec2(word & 0x1fffu, word >> 13 & 0x1fffu);
    vec4 cover = texelFetch(sheet, place + ivec2(index & (side - 1), index >> level), 0);
    float part = paintIsPicture ? cover.a : cover.r;
    vec4 target = paintIsPicture ? vec4(cover[paintParts.x], cover[paintParts.y], cover[paintParts.z], 1.0)
                                 : paint;
    vec4 moved = part < 1.0 ? texel + part * (target - texel) : target;
    moved = paintIsUnit ? clamp(moved, 0.0, 1.0) : moved;
    return part > 0.0 ? moved : texel;
}

Shown texelAt(vec2 p, int resolution)
{
    bool isConstant = PAINTED == 1 && (record.y & kConstant) != 0u;
    int index = isConstant ? 0 : texelIndex(p, resolution);
    return shownOf(painted(texelFetch(texels, int(record.x) + index), p, resolution));
}

Shown both(Shown a, Shown b)
{
    bool isNone = LOOK == 3 && min(a.parts.x, b.parts.x) < 0.0;
    return Shown(isNone ? vec4(-1.0) : a.parts + b.parts, max(a.mark, b.mark));
}

#if FILTERING >= 2
vec4 filteredTexel();

Shown shownTexel(int resolution)
{
    return shownOf(painted(filteredTexel(), uv * float(resolution), resolution));
}
#else
// The texel under the pixel; where a pixel spans several, the mean of four places within it, which
// calms what a single one would let flicker.
Shown shownTexel(int resolution)
{
    if ((record.y & kConstant) != 0u && squareWord() == 0u) {
        return shownOf(texelFetch(texels, int(record.x)));
    }
    vec2 p = uv * float(resolution);
    vec2 alongX = dFdx(p);
    vec2 alongY = dFdy(p);
    if (max(dot(alongX, alongX), dot(alongY, alongY)) < 1.0) {
        return texelAt(p, resolution);
    }
    vec2 a = 0.125 * alongX + 0.375 * alongY;
    vec2 b = 0.375 * alongX - 0.125 * alongY;
    Shown sum = both(both(texelAt(p + a, resolution), texelAt(p - a, resolution)),
                     both(texelAt(p + b, resolution), texelAt(p - b, resolution)));
    sum.parts *= 0.25;
    return sum;
}
#endif

const vec3 kNoNumber = vec3(255.0, 0.0, 170.0) / 255.0;

vec3 scaleColor(float place)
{
    int last = textureSize(scaleColors) - 1;
    return place < 0.0 ? kNoNumber
                       : texelFetch(scaleColors, int(place * float(last) + 0.5)).rgb;
}

// The pattern of a mark: `hasInk` in render/look.h.
bool hasInk(int mark)
{
    // From the lower left, so that what rises there falls here.
    ivec2 p = ivec2(floor(gl_FragCoord.xy / lineWidth));
    if (mark == 4) {
        return (((p.x >> 2) + (p.y >> 2)) & 1) != 0;
    }
    int along = mark == 3 ? p.y : mark == 2 ? p.x + p.y : p.x - p.y;
    return (along & 7) < 3;
}

vec3 markColor(int mark)
{
    return hasInk(mark) ? vec3(0.0) : markColors[mark];
}

// A screen-fixed checker behind what is not opaque.
vec3 overChecker(vec4 texel)
{
    ivec2 square = ivec2(gl_FragCoord.xy / (8.0 * lineWidth));
    float checker = ((square.x + square.y) & 1) == 0 ? 0.42 : 0.58;
    return mix(vec3(checker), texel.rgb, texel.a);
}

// Headlight from the upper left, a sky and a thin rim; a white texel facing the light stays white.
// Light adds up in squares of what is shown: near enough to linear, and cheap.
vec3 shade(vec3 base, vec3 normal)
{
    vec3 toEye = normalize(-viewPosition);
    float key = max(dot(normal, normalize(vec3(-0.35, 0.45, 1.0))), 0.0);
    float sky = 0.5 + 0.5 * normal.y;
    float turned = 1.0 - clamp(dot(normal, toEye), 0.0, 1.0);
    float rim = 0.045 * turned * turned * turned * turned;
    float light = 0.05 + 0.80 * key + 0.15 * sky;
    return sqrt(base * base * light + rim);
}

vec3 shadingNormal()
{
    vec3 flatNormal = cross(dFdx(viewPosition), dFdy(viewPosition));
    vec3 normal = hasNormals ? viewNormal : flatNormal;
    float size = dot(normal, normal);
    normal = size > 0.0 ? normal * inversesqrt(size) : vec3(0.0, 0.0, 1.0);
    return (hasNormals && !gl_FrontFacing) || (!hasNormals && dot(normal, viewPosition) > 0.0)
               ? -normal
               : normal;
}

// Which of the places that corners' labels span is the face's own.
vec2 faceUv()
{
    float rest = 1.0 - place.x - place.y;
    int one = labels & 3;
    int two = labels >> 2;
    return vec2(one == 1 ? place.x : one == 2 ? place.y : rest,
                two == 2 ? place.y : two == 1 ? place.x : rest);
}

// How much of a line of the given half width covers this pixel. Three families of lines, each
// standing 1 apart in its own unit; x are the distances to the nearest of each, perPixel their
// change from pixel to pixel.
float coverage(vec3 x, vec3 perPixel, float halfWidth)
{
    vec3 perStep = max(perPixel, vec3(1e-9));
    vec3 inside = clamp(halfWidth + 0.5 - x / perStep, 0.0, 1.0);
    vec3 visible = smoothstep(vec3(kFadeFrom), vec3(kFadeTo), 1.0 / (perStep * lineWidth));
    vec3 covered = inside * visible;
    return max(covered.x, max(covered.y, covered.z));
}

void main()
{
    uv = faceUv();
    int resolution = 1 << int(record.y & kLevelMask);
    vec3 bary = vec3(uv, 1.0 - uv.x - uv.y);
    vec3 baryPerPixel = max(fwidth(bary), vec3(1e-12));

    Shown texel = Shown(vec4(0.0, 0.0, 0.0, 1.0), 0.0);
    vec3 own = kPendingColor;
    if (LOOK == 4) {
        own = texelFetch(faceColors, faceNumber * colorsPerFace).rgb;
        if (colorsPerFace == 3) {
            own = bary.z * own + bary.x * texelFetch(faceColors, 3 * faceNumber + 1).rgb +
                  bary.y * texelFetch(faceColors, 3 * faceNumber + 2).rgb;
        }
    } else if ((record.y & kPending) == 0u) {
        texel = shownTexel(resolution);
        own = LOOK == 3   ? scaleColor(texel.parts.x)
              : LOOK == 2 ? texel.parts.xxx
              : ALPHA == 1 ? overChecker(texel.parts)
                           : texel.parts.rgb;
    }
    vec3 shown = own;
    if (LIT == 1) {
        shown = shade(shown, shadingNormal());
    }
    if (LOOK < 3 && !gl_FrontFacing) {
        shown *= 0.72;
    }
    if (MARKS == 1 && texel.mark > 0.0) {
        own = markColor(int(texel.mark));
        shown = own;
    }
    if (TEXEL_GRID == 1) {
        float rows = float(1 << int((record.y >> kOwnShift) & kLevelMask));
        vec3 p = bary * rows;
        float line = coverage(abs(p - round(p)), baryPerPixel * rows, 0.5 * lineWidth);
        // By the texel's own colour: by the shaded one lines would turn over within a face.
        float luma = dot(own, vec3(0.2126, 0.7152, 0.0722));
        shown = mix(shown, vec3(luma > 0.45 ? 0.0 : 1.0), 0.38 * line);
    }
    if (WIREFRAME == 1) {
        float line = coverage(max(bary, vec3(0.0)), baryPerPixel, 0.5 * lineWidth);
        shown = mix(shown, kWireColor, 0.85 * line);
    }
    color = vec4(shown, 1.0);
}
