#version 410 core
// SPDX-License-Identifier: GPL-3.0-or-later

// One triangle that covers the screen; no buffers.
out vec2 position; // [0,1], y upwards

void main()
{
    vec2 corner = vec2((gl_VertexID & 1) << 2, (gl_VertexID & 2) << 1);
    position = corner * 0.5;
    gl_Position = vec4(corner - 1.0, 1.0, 1.0);
}
