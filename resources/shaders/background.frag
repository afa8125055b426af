#version 410 core
// SPDX-License-Identifier: GPL-3.0-or-later

// Neutral, so that it does not tint how colours are judged; darker towards floor and corners.
in vec2 position;
out vec4 color;

void main()
{
    vec3 floorColor = vec3(0.125, 0.128, 0.135);
    vec3 skyColor = vec3(0.265, 0.275, 0.290);
    float height = smoothstep(0.0, 1.0, position.y);
    vec2 fromMiddle = position - vec2(0.5, 0.55);
    float vignette = 1.0 - 0.45 * dot(fromMiddle, fromMiddle);
    // Half a step of noise hides the bands of eight bits.
    float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    color = vec4(mix(floorColor, skyColor, height) * vignette + (noise - 0.5) / 255.0, 1.0);
}
