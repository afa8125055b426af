
// Gaussian probes along the footprint's major axis; the numbers are those of
// core/filter/probe_plan.h. A probe is a place on the screen beside the pixel, followed over the
// mesh: across an edge it is seen in the neighbour's plane, so that both sides of the edge ask for
// the same places.
uniform mat4 toClip;
uniform vec2 halfViewport; // device pixels
uniform float probeSpacing; // in sigmas of a probe, of a round footprint
uniform float probeFalloff;
uniform float probeSupport; // in sigmas of the weights
uniform float probeThinnest;
uniform int probesAside; // at most, of one side

const int kMostHops = 8;
// Where the sum over places of texels gives way to probes: how far it reaches, in heights of faces,
// because it knows but the faces about; and how much longer than wide the footprint is.
const vec2 kNearFace = vec2(1.6, 1.9);
const vec2 kNotThin = vec2(4.0, 6.0);

// A position on the screen: pixels from a place, times w, and w.
vec3 onScreen(uint vertex, vec2 place)
{
    vec4 clip = toClip * vec4(texelFetch(positions, int(vertex)).xyz, 1.0);
    return vec3(clip.xy * halfViewport - place * clip.w, clip.w);
}

// The share that the end of an edge has of the edge's point nearest to a place on the screen: the
// same whichever of the two faces asks.
float alongEdge(vec2 at, vec3 start, vec3 end)
{
    if (min(start.z, end.z) <= 0.0) {
        return 0.5; // behind the camera
    }
    vec2 from = start.xy / start.z;
    vec2 way = end.xy / end.z - from;
    float t = clamp(dot(at - from, way) / max(dot(way, way), 1e-20), 0.0, 1.0);
    float ofEnd = t * start.z;
    return ofEnd / (ofEnd + (1.0 - t) * end.z);
}

vec4 probe(vec2 offset, vec2 place, vec3 c0, vec3 c1, vec3 c2, float level)
{
    vec3 corners[3] = vec3[3](c0, c1, c2);
    vec3 at = vec3(offset, 1.0);
    int face = faceNumber;
    int entered = -1; // by this edge
    vec3 inside = vec3(1.0 - uv.x - uv.y, uv);
    for (int hop = 0; hop < kMostHops; ++hop) {
        vec3 shares = vec3(dot(cross(corners[1], corners[2]), at),
                           dot(cross(corners[2], corners[0]), at),
                           dot(cross(corners[0], corners[1]), at));
        float sum = shares.x + shares.y + shares.z;
        if (abs(sum) < 1e-30) {
            break; // seen from its edge
        }
        inside = shares / sum;
        float least = min(inside.x, min(inside.y, inside.z));
        if (least >= 0.0) {
            break;
        }
        int edge = inside.z == least ? 0 : inside.x == least ? 1 : 2;
        uint next = texelFetch(across, 3 * face + edge).x;
        if (next == kBorder || edge == entered || hop + 1 == kMostHops) {
            // Beyond a border; or beyond a contour, where either face sends on to the other.
            float t = alongEdge(offset, corners[edge], corners[(edge + 1) % 3]);
            inside = edge == 0   ? vec3(1.0 - t, t, 0.0)
                     : edge == 1 ? vec3(0.0, 1.0 - t, t)
                                 : vec3(t, 0.0, 1.0 - t);
            break;
        }
        face = int(next >> 2);
        int theirs = int(next & 3u);
        entered = theirs;
        vec3 start = corners[edge];
        vec3 end = corners[(edge + 1) % 3];
        uint far = texelFetch(triangles, face)[(theirs + 2) % 3];
        corners[theirs] = end;
        corners[(theirs + 1) % 3] = start;
        corners[(theirs + 2) % 3] = onScreen(far, place);
    }
    inside = max(inside, vec3(0.0));
    inside /= inside.x + inside.y + inside.z;
    uvec2 block = face == faceNumber ? record : texelFetch(records, face).xy;
    return blockValue(block, inside.yz, level);
}

vec4 probedTexel(vec3 moves, float pixel2, float texel2)
{
    float mean = 0.5 * (moves.x + moves.y);
    float slant = 0.5 * (moves.x - moves.y);
    float radius = sqrt(slant * slant + moves.z * moves.z);
    float longest = mean + radius;
    float shortest = max(moves.x * moves.y - moves.z * moves.z, 0.0) / longest;
    float major2 = pixel2 * longest + 0.25 * texel2;
    float own2 = max(pixel2 * shortest + 0.25 * texel2, probeThinnest * major2);
    float level = levelFor(own2, texel2);
    float own = sqrt(own2);
    float support = probeSupport * sqrt(max(major2 - own2, 0.0));
    // Thin footprints bear wider steps: of many probes each matters less.
    float wanted = probeSpacing * own * pow(major2 / own2, 0.15);
    float least = support / (float(probesAside) + 0.5);
    float most = 2.0 * support / probeSupport; // two probes then have the right variance
    float stride = max(min(wanted, most), least);
    if (support < 1e-3 * own) {
        return blockValue(record, uv, level);
    }

    uvec3 triangle = texelFetch(triangles, faceNumber).xyz;
    vec3 c0 = onScreen(triangle.x, vec2(0.0));
    vec3 c1 = onScreen(triangle.y, vec2(0.0));
    vec3 c2 = onScreen(triangle.z, vec2(0.0));
    // Where the cage's face has the point: the limit surface lies elsewhere.
    vec3 point = (1.0 - uv.x - uv.y) * c0 + uv.x * c1 + uv.y * c2;
    vec2 origin = point.xy / max(point.z, 1e-20);
    c0.xy -= origin * c0.z;
    c1.xy -= origin * c1.z;
    c2.xy -= origin * c2.z;
    // The major axis on the screen, in pixels for a unit of length along it.
    vec2 axis = slant >= 0.0 ? vec2(slant + radius, moves.z) : vec2(moves.z, radius - slant);
    vec2 direction = axis / max(length(axis), 1e-20) / (2.0 * sqrt(pixel2 * longest));
    float end = exp(-probeFalloff);
    vec4 sum = vec4(0.0);
    float weights = 0.0;
    for (int k = 0; k < probesAside; ++k) {
        float place = (float(k) + 0.5) * stride;
        float x = place / support;
        float weight = exp(-probeFalloff * x * x) - end;
        if (weight <= 0.0) {
            break;
        }
        sum += weight * (probe(place * direction, origin, c0, c1, c2, level) +
                         probe(-place * direction, origin, c0, c1, c2, level));
        weights += 2.0 * weight;
    }
    return sum / weights;
}

vec4 filteredTexel()
{
    vec3 moves = steps();
    float pixel2 = pixelVariance();
    float texel2 = exp2(2.0 * log2Scale.y);
    float mean = 0.5 * (moves.x + moves.y);
    float slant = 0.5 * (moves.x - moves.y);
    float longest = mean + sqrt(slant * slant + moves.z * moves.z);
    float pixel = 2.0 * sqrt(pixel2);

    Footprint footprint;
    footprint.ray = viewPosition.xy / max(-viewPosition.z, 1e-30);
    footprint.moves = moves;
    footprint.area2 = max(moves.x * moves.y - moves.z * moves.z, 0.0);
    footprint.texel2 = texel2 / (pixel * pixel);
    footprint.minor2 = footprint.area2 / longest + footprint.texel2;
    float major2 = longest + footprint.texel2; // four times
    footprint.major = 0.5 * sqrt(major2);
    float reach = kCut * footprint.major * pixel * exp2(-room);
    float thinness = sqrt(major2 / footprint.minor2);
    float toProbes = max(smoothstep(kNearFace.x, kNearFace.y, reach),
                         smoothstep(kNotThin.x, kNotThin.y, thinness));
    vec4 value = vec4(0.0);
    if (toProbes < 1.0) {
        value = (1.0 - toProbes) * texelsAbout(footprint, pixel);
    }
    if (toProbes > 0.0) {
        value += toProbes * probedTexel(moves, pixel2, texel2);
    }
    return value;
}
