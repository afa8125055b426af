#version 410 core
// SPDX-License-Identifier: GPL-3.0-or-later

// Coverage of a texel after some more dabs: what `Falloff` and `covered` in core/paint/dab.h say,
// at the texel's centroid.
uniform samplerBuffer dabs; // two texels each: `PaintDab` in render/paint_batch.h
uniform sampler2D before;
uniform float hardness;
uniform float fallScale;
uniform float flow;

flat in vec3 anchor;
flat in vec3 across;
flat in vec3 down;
flat in ivec2 anchorPixel;
flat in uint dabMask;
flat in uint kind;
out float coverage;

const uint kFirst = 0x200u;

float falloff(float distance)
{
    float s = clamp((distance - hardness) * fallScale, 0.0, 1.0);
    return 1.0 - s * s * (3.0 - 2.0 * s);
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec2 steps = vec2(pixel - anchorPixel);
    vec3 place = anchor + steps.x * across + steps.y * down;
    float now = (kind & kFirst) != 0u ? 0.0 : texelFetch(before, pixel, 0).r;
    for (uint left = dabMask; left != 0u; left &= left - 1u) {
        int k = findLSB(left);
        vec4 sphere = texelFetch(dabs, 2 * k);
        float cap = texelFetch(dabs, 2 * k + 1).r;
        float strength = flow * falloff(length(place - sphere.xyz) * sphere.w);
        float moved = now + (cap - now) * strength;
        now = max(now, min(moved, cap));
    }
    coverage = now;
}
