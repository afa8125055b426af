#version 410 core
// SPDX-License-Identifier: GPL-3.0-or-later

uniform vec4 lineColor;
uniform float halfWidth;

noperspective in vec2 alongAcross;
flat in float segmentLength;
out vec4 color;

void main()
{
    // Distance to the segment: round ends, so that joints close.
    float beyond = alongAcross.x - clamp(alongAcross.x, 0.0, segmentLength);
    float distance = length(vec2(beyond, alongAcross.y));
    float inside = clamp(halfWidth + 0.5 - distance, 0.0, 1.0);
    if (inside <= 0.0) {
        discard;
    }
    color = vec4(lineColor.rgb, lineColor.a * inside);
}
