#version 410 core
// SPDX-License-Identifier: GPL-3.0-or-later

// A quad around one segment of a line: six vertices an instance.
uniform mat4 view;
uniform mat4 projection;
uniform vec2 viewport;  // device pixels
uniform float halfWidth; // device pixels

in vec3 from;
in vec3 to;

noperspective out vec2 alongAcross; // device pixels from the segment's start
flat out float segmentLength;       // device pixels

// Towards the eye by a part of the distance: the place on the screen stays, the line lies on the
// surface instead of in it.
const float kBias = 0.004;
const float kNear = 1e-6;

void main()
{
    vec3 a = (view * vec4(from, 1.0)).xyz * (1.0 - kBias);
    vec3 b = (view * vec4(to, 1.0)).xyz * (1.0 - kBias);
    // What lies behind the eye is cut off before it is divided by its depth.
    if (a.z > -kNear && b.z > -kNear) {
        gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
        alongAcross = vec2(0.0);
        segmentLength = 0.0;
        return;
    }
    if (a.z > -kNear) {
        a = mix(b, a, (-kNear - b.z) / (a.z - b.z));
    }
    if (b.z > -kNear) {
        b = mix(a, b, (-kNear - a.z) / (b.z - a.z));
    }
    vec4 clipA = projection * vec4(a, 1.0);
    vec4 clipB = projection * vec4(b, 1.0);
    vec2 screenA = clipA.xy / clipA.w * 0.5 * viewport;
    vec2 screenB = clipB.xy / clipB.w * 0.5 * viewport;
    vec2 along = screenB - screenA;
    segmentLength = length(along);
    along = segmentLength > 1e-4 ? along / segmentLength : vec2(1.0, 0.0);
    vec2 across = vec2(-along.y, along.x);

    int corner = gl_VertexID; // 0 1 2, 2 1 3: bit 0 is the end, bit 1 the side
    int index = corner < 3 ? corner : (corner == 3 ? 2 : (corner == 4 ? 1 : 3));
    bool atEnd = (index & 1) == 1;
    float side = (index & 2) == 2 ? 1.0 : -1.0;
    float reach = halfWidth + 1.0;
    vec4 clip = atEnd ? clipB : clipA;
    vec2 offset = (atEnd ? reach : -reach) * along + side * reach * across;
    alongAcross = vec2(atEnd ? segmentLength + reach : -reach, side * reach);
    gl_Position = clip + vec4(offset / (0.5 * viewport) * clip.w, 0.0, 0.0);
}
