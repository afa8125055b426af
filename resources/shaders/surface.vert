#version 410 core
// SPDX-License-Identifier: GPL-3.0-or-later

// Corners that faces share, `SharedCorner` in render/shared_corners.h; where there are none, three
// vertices a face, pulled by number: face = gl_VertexID / 3.
layout(location = 0) in uint sharedVertex;
layout(location = 1) in uint sharedBits;
layout(location = 2) in uint sharedNormal; // octahedral
uniform bool areShared;
uniform samplerBuffer positions;  // xyz a mesh vertex
uniform usamplerBuffer triangles; // three mesh vertices a face
uniform usamplerBuffer records;   // a face: first texel, level and flags
uniform bool hasNormals;
uniform mat4 view;
uniform mat4 projection;

out vec2 place;
out vec3 viewPosition;
out vec3 viewNormal;
flat out uvec2 record;
flat out int faceNumber;
flat out int labels;
#if FILTERING >= 3
uniform usamplerBuffer scales; // a mesh vertex: `VertexScale` in render/filter_mesh.h
#if VERTEX_LEVELS == 1
out float level;
float seamlessLevel(vec3 point, vec2 tilt, vec2 scale); // filter_levels.glsl
#else
out vec2 log2Scale;
out vec2 tilt;
#endif
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
    int face = gl_VertexID / 3;
    int label = gl_VertexID - 3 * face;
    uint vertex = sharedVertex;
    labels = 1 | 2 << 2;
    if (areShared) {
        face = int(sharedBits >> 6);
        label = int(sharedBits & 3u);
        labels = int(sharedBits >> 2 & 15u);
    } else {
        vertex = texelFetch(triangles, face)[label];
    }
    faceNumber = face;
    vec4 position = view * vec4(texelFetch(positions, int(vertex)).xyz, 1.0);

    place = vec2(label == 1 ? 1.0 : 0.0, label == 2 ? 1.0 : 0.0);
    record = texelFetch(records, face).xy;
    viewPosition = position.xyz;
    viewNormal = vec3(0.0);
    if (hasNormals) {
        viewNormal = mat3(view) * unpackNormal(sharedNormal);
    }
#if FILTERING >= 3
    uvec4 scale = texelFetch(scales, int(vertex));
    // How the surface falls away to the right and upwards: the normal over its part along the ray
    // to the point. On a plane that is linear, so that what is interpolated is right even where a
    // corner lies behind the eye.
    vec3 normal = vec3(unpackUnorm2x16(scale.z), unpackUnorm2x16(scale.w).x) * 2.0 - 1.0;
    float flatness = unpackUnorm2x16(scale.w).y;
    vec3 turned = mat3(view) * normal;
    float along = dot(turned, position.xyz);
    float least = 0.04 * length(position.xyz) + 1e-20;
    along = along < 0.0 ? min(along, -least) : max(along, least);
    vec2 fall = turned.xy * (-position.z * flatness / along);
#if VERTEX_LEVELS == 1
    level = seamlessLevel(position.xyz, fall, uintBitsToFloat(scale.xy));
#else
    log2Scale = uintBitsToFloat(scale.xy);
    tilt = fall;
#endif
#endif
    gl_Position = projection * position;
}
