#version 410 core
// SPDX-License-Identifier: GPL-3.0-or-later

// From one sheet to the same place of another.
uniform sampler2D before;
out vec4 texel;

void main()
{
    texel = texelFetch(before, ivec2(gl_FragCoord.xy), 0);
}
