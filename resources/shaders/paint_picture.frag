#version 410 core
// SPDX-License-Identifier: GPL-3.0-or-later

// What of a picture lands on a texel's centroid: its colour, and how far it covers. `projectedAt` in
// core/paint/project_picture.h says the same.
uniform sampler2D picture; // R G B A, the first row is the upper one
uniform mat4 toClip;       // of what is relative to the batch's origin
uniform float opacity;

flat in vec3 anchor;
flat in vec3 across;
flat in vec3 down;
flat in ivec2 anchorPixel;
out vec4 lands;

vec4 weighed(ivec2 at, ivec2 size)
{
    vec4 pixel = texelFetch(picture, clamp(at, ivec2(0), size - 1), 0);
    return vec4(pixel.rgb * pixel.a, pixel.a);
}

void main()
{
    vec2 steps = vec2(ivec2(gl_FragCoord.xy) - anchorPixel);
    vec4 clip = toClip * vec4(anchor + steps.x * across + steps.y * down, 1.0);
    vec2 place = vec2(clip.x, -clip.y) / clip.w * 0.5 + 0.5;
    bool isInside = clip.w > 0.0 && all(greaterThanEqual(place, vec2(0.0))) &&
                    all(lessThanEqual(place, vec2(1.0)));
    ivec2 size = textureSize(picture, 0);
    vec2 p = clamp(place, 0.0, 1.0) * vec2(size) - 0.5;
    ivec2 at = ivec2(floor(p));
    vec2 f = p - vec2(at);
    vec4 mixed = mix(mix(weighed(at, size), weighed(at + ivec2(1, 0), size), f.x),
                     mix(weighed(at + ivec2(0, 1), size), weighed(at + ivec2(1, 1), size), f.x),
                     f.y);
    lands = isInside && mixed.a > 0.0 ? vec4(mixed.rgb / mixed.a, mixed.a * opacity) : vec4(0.0);
}
