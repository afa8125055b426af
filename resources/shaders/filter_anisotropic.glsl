
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

// A guard against rounding, not a measure of work: most ways end after a few faces. A way that it cuts
// short ends a face earlier on one side of an edge than on the other, where both should agree.
const int kMostHops = 64;
// Where the sum over places of texels gives way to probes: about how many faces it reaches, and how
// much longer than wide the footprint is.
const vec2 kFewFaces = vec2(11.5, 15.0);
const vec2 kNotThin = vec2(6.0, 9.0);
const float kByEdge = 0.35; // pixels

// A position on the screen: pixels from a place, times w, and w.
vec3 onScreen(uint vertex, vec2 place)
{
    vec4 clip = toClip * vec4(texelFetch(positions, int(vertex)).xyz, 1.0);
    return vec3(clip.xy * halfViewport - place * clip.w, clip.w);
}

// Straight on over the screen from the pixel, face by face: from a place on an edge that is the same
// way for both of its faces. It ends at borders and contours.
vec4 probe(vec2 offset, vec2 place, vec3 c0, vec3 c1, vec3 c2, float level)
{
    vec3 corners[3] = vec3[3](c0, c1, c2);
    vec3 to = vec3(offset, 1.0);
    int face = faceNumber;
    int entered = -1; // by this edge
    float turn = dot(cross(c0, c1), c2) < 0.0 ? -1.0 : 1.0;
    vec3 inside = vec3(1.0 - uv.x - uv.y, uv);
    for (int hop = 0; hop < kMostHops; ++hop) {
        // How far beyond each corner's edge the pixel and the place lie.
        vec3 here = turn * vec3(cross(corners[1], corners[2]).z,
                                cross(corners[2], corners[0]).z,
                                cross(corners[0], corners[1]).z);
        vec3 there = turn * vec3(dot(cross(corners[1], corners[2]), to),
                                 dot(cross(corners[2], corners[0]), to),
                                 dot(cross(corners[0], corners[1]), to));
        float way = 1.0;
        int edge = -1;
        for (int k = 0; k < 3; ++k) {
            int corner = (k + 2) % 3;
            if (there[corner] < 0.0 && k != entered) {
                float along = max(here[corner], 0.0) / (max(here[corner], 0.0) - there[corner]);
                if (along < way) {
                    way = along;
                    edge = k;
                }
            }
        }
        vec3 shares = max(mix(here, there, way), vec3(0.0));
        float sum = shares.x + shares.y + shares.z;
        if (sum < 1e-30) {
            break; // seen from its edge
        }
        inside = shares / sum;
        uint next = edge < 0 ? kBorder : texelFetch(across, 3 * face + edge).x;
        if (next == kBorder || hop + 1 == kMostHops) {
            break;
        }
        int other = int(next >> 2);
        int theirs = int(next & 3u);
        vec3 start = corners[edge];
        vec3 end = corners[(edge + 1) % 3];
        vec3 apex = onScreen(texelFetch(triangles, other)[(theirs + 2) % 3], place);
        if (turn * dot(cross(end, start), apex) <= 0.0) {
            break; // a contour
        }
        // The same point in the other's corners, should the way end there.
        vec3 own = inside;
        inside[theirs] = own[(edge + 1) % 3];
        inside[(theirs + 1) % 3] = own[edge];
        inside[(theirs + 2) % 3] = 0.0;
        face = other;
        entered = theirs;
        corners[theirs] = end;
        corners[(theirs + 1) % 3] = start;
        corners[(theirs + 2) % 3] = apex;
    }
    inside = max(inside, vec3(0.0));
    inside /= inside.x + inside.y + inside.z;
    uvec2 block = face == faceNumber ? record : texelFetch(records, face).xy;
    return blockValue(block, inside.yz, level);
}

vec4 probedTexel(vec3 moves, float area2, float pixel2, float texel2)
{
    float mean = 0.5 * (moves.x + moves.y);
    float slant = 0.5 * (moves.x - moves.y);
    float radius = sqrt(slant * slant + moves.z * moves.z);
    float longest = mean + radius;
    float shortest = area2 / longest;
    float major2 = pixel2 * longest + 0.25 * texel2;
    float own2 = max(pixel2 * shortest + 0.25 * texel2, probeThinnest * major2);
    float level = levelFor(log2Scale, own2, texel2);
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

// Of a surface, from the products of its steps.
float longestOf(vec3 moves)
{
    float slant = 0.5 * (moves.x - moves.y);
    return 0.5 * (moves.x + moves.y) + sqrt(slant * slant + moves.z * moves.z);
}

// The tilt of the plane of the pixel's face, which is what the pixel sees; but by an edge, nearer than a
// third of a pixel, it turns over to the one that both of its faces have in common there.
vec2 ownTilt()
{
#if LIMIT == 1
    return tilt;
#else
    vec3 bary = vec3(uv, 1.0 - uv.x - uv.y);
    vec3 right = vec3(dFdx(uv), 0.0);
    vec3 up = vec3(dFdy(uv), 0.0);
    right.z = -right.x - right.y;
    up.z = -up.x - up.y;
    vec3 pixels = bary * inversesqrt(max(right * right + up * up, vec3(1e-20)));
    float share = smoothstep(0.0, kByEdge, min(pixels.x, min(pixels.y, pixels.z)));
    uvec3 triangle = texelFetch(triangles, faceNumber).xyz;
    vec3 from = texelFetch(positions, int(triangle.x)).xyz;
    vec3 normal = mat3(view) * cross(texelFetch(positions, int(triangle.y)).xyz - from,
                                     texelFetch(positions, int(triangle.z)).xyz - from);
    float along = dot(normal, viewPosition);
    float least = 0.01 * length(viewPosition) * length(normal);
    along = along < 0.0 ? min(along, -least) : max(along, least);
    return along == 0.0 ? tilt : mix(tilt, normal.xy * (-viewPosition.z / along), share);
#endif
}

vec4 filteredTexel()
{
    vec2 own = ownTilt();
    vec3 moves = steps(viewPosition, own);
    float pixel2 = pixelVariance(viewPosition);
    float texel2 = texelSize2(log2Scale);
    float pixel = 2.0 * sqrt(pixel2);
    float longest = longestOf(moves);

    Footprint footprint;
    footprint.ray = rayTo(viewPosition);
    footprint.moves = moves;
    footprint.area2 = areaOf(viewPosition, own);
    footprint.texel2 = texel2 / (pixel * pixel);
    footprint.minor2 = footprint.area2 / longest + footprint.texel2;
    float major2 = longest + footprint.texel2; // four times
    footprint.major = 0.5 * sqrt(major2);
    // Where tilts turn over, by edges, levels are not to switch.
    vec3 shared = steps(viewPosition, tilt);
    footprint.lattice2 = areaOf(viewPosition, tilt) / longestOf(shared) + footprint.texel2;
    float thinness = sqrt(major2 / footprint.minor2);
    // Of equilateral faces whose middles the ellipse holds, and those that it cuts.
    float edge = exp2(log2Scale.x) / pixel;
    float reach = kCut * footprint.major / edge;
    float faces = 7.3 * (reach + 0.5) * (reach / thinness + 0.5);
    float toProbes = max(smoothstep(kFewFaces.x, kFewFaces.y, faces),
                         smoothstep(kNotThin.x, kNotThin.y, thinness));
    vec4 value = vec4(0.0);
    if (toProbes < 1.0) {
        bool isWhole;
        value = (1.0 - toProbes) * texelsAbout(footprint, pixel, isWhole);
        toProbes = isWhole ? toProbes : 1.0;
    }
    if (toProbes > 0.0) {
        value += toProbes * probedTexel(moves, footprint.area2, pixel2, texel2);
    }
    return value;
}
