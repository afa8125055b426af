#version 410 core
// SPDX-License-Identifier: GPL-3.0-or-later

// One half of a face in its square of the sheet: the whole triangle, by its paint projection, of
// which no more is drawn than dabs may reach. Three vertices an entry, pulled by number: `PaintEntry`
// in render/paint_batch.h.
uniform usamplerBuffer entries;
uniform vec2 sheetSize;
uniform float offset; // that brings pixel centres onto centroids: a sixth

flat out vec3 anchor;
flat out vec3 across;
flat out vec3 down;
flat out ivec2 anchorPixel; // in the sheet
flat out uint dabMask;
flat out uint kind;
out float gl_ClipDistance[4];

const uint kUpper = 0x100u;

vec2 pair(uint word)
{
    return vec2(word & 0xffffu, word >> 16);
}

void main()
{
    int entry = gl_VertexID / 3;
    int corner = gl_VertexID - 3 * entry;
    uvec4 a = texelFetch(entries, 4 * entry);
    uvec4 b = texelFetch(entries, 4 * entry + 1);
    uvec4 c = texelFetch(entries, 4 * entry + 2);
    uvec4 d = texelFetch(entries, 4 * entry + 3);
    anchor = uintBitsToFloat(a.xyz);
    across = uintBitsToFloat(b.xyz);
    down = uintBitsToFloat(c.xyz);
    dabMask = a.w;
    kind = b.w;
    vec2 place = pair(c.w);
    anchorPixel = ivec2(place + pair(d.x));

    float resolution = float(1 << int(kind & 0xffu));
    vec2 uv = vec2(corner == 1 ? 1.0 : 0.0, corner == 2 ? 1.0 : 0.0);
    vec2 pixel = ((kind & kUpper) != 0u ? 1.0 - uv.yx : uv) * resolution + offset;
    vec2 low = pair(d.y);
    vec2 high = pair(d.z);
    gl_ClipDistance[0] = pixel.x - low.x;
    gl_ClipDistance[1] = pixel.y - low.y;
    gl_ClipDistance[2] = high.x - pixel.x;
    gl_ClipDistance[3] = high.y - pixel.y;
    gl_Position = vec4((place + pixel) / sheetSize * 2.0 - 1.0, 0.0, 1.0);
}
