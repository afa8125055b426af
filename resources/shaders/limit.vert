#version 410 core
// SPDX-License-Identifier: GPL-3.0-or-later

// Corners of a tessellated limit surface, `LimitVertex` in core/mesh/limit_tessellation.h: what
// surface.vert gives on for the corners of whole faces.
layout(location = 0) in vec3 position;
layout(location = 1) in uint normal; // octahedral
layout(location = 2) in vec2 faceUv;
layout(location = 3) in uint ofFace;

uniform usamplerBuffer records; // a face: first texel, level and flags
uniform mat4 view;
uniform mat4 projection;

out vec2 place;
out vec3 viewPosition;
out vec3 viewNormal;
flat out uvec2 record;
flat out int faceNumber;
flat out int labels;
#if FILTERING >= 3
uniform usamplerBuffer triangles; // three mesh vertices a face
uniform usamplerBuffer scales;    // a mesh vertex: `VertexScale` in render/filter_mesh.h
out vec2 log2Scale;
out vec2 tilt;
#endif

vec3 unpackNormal(uint bits)
{
    vec2 p = (vec2(bits & 0xffffu, bits >> 16) - 32768.0) / 32767.0;
    vec3 n = vec3(p, 1.0 - abs(p.x) - abs(p.y));
    float fold = max(-n.z, 0.0);
    n.x += n.x < 0.0 ? fold : -fold;
    n.y += n.y < 0.0 ? fold : -fold;
    return normalize(n);
}

void main()
{
    vec4 seen = view * vec4(position, 1.0);
    int face = int(ofFace);
    faceNumber = face;
    place = faceUv;
    labels = 1 | 2 << 2;
    record = texelFetch(records, face).xy;
    viewPosition = seen.xyz;
    viewNormal = mat3(view) * unpackNormal(normal);
#if FILTERING >= 3
    // What whole faces have at their corners, as it is between these; but the surface's own tilt.
    uvec3 corners = texelFetch(triangles, face).xyz;
    vec3 weights = vec3(1.0 - place.x - place.y, place);
    log2Scale = vec2(0.0);
    for (int k = 0; k < 3; ++k) {
        log2Scale +=
            weights[k] * uintBitsToFloat(texelFetch(scales, int(corners[k])).xy);
    }
    float along = dot(viewNormal, seen.xyz);
    float smallest = 0.04 * length(seen.xyz) + 1e-20;
    along = along < 0.0 ? min(along, -smallest) : max(along, smallest);
    tilt = viewNormal.xy * (-seen.z / along);
#endif
    gl_Position = projection * seen;
}
