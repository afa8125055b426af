#version 410 core
// SPDX-License-Identifier: GPL-3.0-or-later

uniform sampler2D picture; // rows from the top

out vec4 color;

void main()
{
    ivec2 size = textureSize(picture, 0);
    ivec2 pixel = ivec2(gl_FragCoord.x, size.y - 1 - int(gl_FragCoord.y));
    if (any(lessThan(pixel, ivec2(0))) || any(greaterThanEqual(pixel, size))) {
        discard;
    }
    color = texelFetch(picture, pixel, 0);
}
