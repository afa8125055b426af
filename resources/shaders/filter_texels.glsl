
// The Gaussian over places of texels, for footprints that reach few faces: interpolated averages are
// too soft where footprints are about as wide as texels. A sum over all faces that the footprint
// reaches, each by texels or lattice vertices of its own, so that it is the same whichever of them
// the pixel lies in. Appended to filter_vertices.glsl. Lengths are in pixels' widths at the point
// that is seen.
uniform usamplerBuffer across;       // three a face: neighbour << 2 | its edge, or all bits
uniform usamplerBuffer triangles;    // three mesh vertices a face
uniform samplerBuffer positions;     // xyz a mesh vertex
uniform usamplerBuffer records;      // of faces' lattice vertices
uniform usamplerBuffer texelRecords; // of faces' texels
uniform samplerBuffer faceTexels;
uniform mat4 view;

const uint kBorder = 0xffffffffu;
const int kMostReached = 32; // faces
const float kCut = 3.0;      // where the Gaussian ends, in sigmas
// Amid larger texels it ends where the nearest has been reached for sure, in edges of these.
const float kNearest = 0.8;
// Four times the variance of the hexagon that a lattice vertex averages, in squared edges of the
// lattice.
const float kHexagon = 5.0 / 6.0;
// Largest such edge over the width of the footprint, both squared: what is left for the Gaussian
// must not be narrow beside the lattice.
const float kWidestLattice = 0.6;

struct Footprint
{
    vec2 ray;       // to the point
    vec3 moves;     // products of steps
    float area2;    // their determinant
    float texel2;   // squared edge of a texel about here
    float major;    // standard deviation along the longer axis
    float minor2;   // four times the variance along the shorter one
    float lattice2; // the same by which levels are chosen
};

// A place, or the way from one to another: in space, and on the screen.
struct Way
{
    vec3 space;
    vec2 screen;
};

Way wayOf(Footprint footprint, vec3 space)
{
    return Way(space, space.xy + space.z * footprint.ray);
}

// Squared distance in standard deviations, as a form. In the surface's plane the covariance is a
// quarter of steps' products and of texel2; distances that belong to the former are taken on the
// screen, others in space, so that both are what they are for each face whichever is asked.
struct Metric
{
    float space;
    vec3 screen; // xx, yy, xy
};

Metric metricOf(Footprint footprint, float texel2)
{
    float sum = footprint.moves.x + footprint.moves.y;
    float scale = 4.0 / (footprint.area2 + texel2 * (sum + texel2));
    vec3 screen = vec3(footprint.area2, footprint.area2, 0.0) + min(texel2, 0.0) * footprint.moves;
    return Metric(scale * max(texel2, 0.0), scale * screen);
}

float product(Metric metric, Way a, Way b)
{
    return metric.space * dot(a.space, b.space) +
           dot(metric.screen.xy, a.screen * b.screen) +
           metric.screen.z * (a.screen.x * b.screen.y + a.screen.y * b.screen.x);
}

// What of a face is summed.
struct Samples
{
    int level;
    int begin;       // where their values begin
    bool areTexels;  // or lattice vertices
    bool isConstant; // all have the first value
};

Samples samplesOf(Footprint footprint, int face, float edge2)
{
    uvec2 own = texelFetch(texelRecords, face).xy;
    int here = int(own.y & kLevelMask);
    int finest = int(own.y >> kOwnShift & kLevelMask);
    float wanted = 0.5 * log2(edge2 / (kWidestLattice * footprint.lattice2));
    int enough = max(int(ceil(wanted)), 0);
    bool isConstant = (own.y & kConstant) != 0u;
    // Texels are more accurate, so a few more of them are borne.
    if (isConstant || (finest <= enough + 1 && (own.y & kPending) == 0u)) {
        int level = isConstant ? min(finest, enough) : here;
        return Samples(level, int(own.x), true, isConstant);
    }
    uvec2 block = texelFetch(records, face).xy;
    int level = min(enough, int(block.y & kLevelMask));
    return Samples(level, int(block.x) + levelBegin(level), false, false);
}

// \param a, b, c  the face's corners from the pixel's point
// \return which of its edges the footprint goes on beyond, as bits; negative where it does not reach
//         the face
int addFace(Footprint footprint, int face, vec3 a, vec3 b, vec3 c, inout vec4 sum, inout float weights)
{
    vec3 e1 = b - a;
    vec3 e2 = c - a;
    vec3 normal = cross(e1, e2);
    float twice2 = dot(normal, normal);
    if (twice2 < 1e-30) {
        return dot(a, a) < kCut * kCut * footprint.major * footprint.major ? 7 : -1;
    }
    float twice = sqrt(twice2);
    float edge2 = 1.1547005 * twice; // of an equilateral face as large
    Samples samples = samplesOf(footprint, face, edge2);
    float r = float(1 << samples.level);
    float step2 = edge2 / (r * r);
    float cut = max(kCut, kNearest * sqrt(step2) / footprint.major);
    float texel2 = footprint.texel2;
    if (!samples.areTexels) {
        texel2 -= min(kHexagon * step2, 0.9 * footprint.minor2);
    }
    Metric metric = metricOf(footprint, texel2);
    Way origin = wayOf(footprint, a);
    Way alongU = wayOf(footprint, e1);
    Way alongV = wayOf(footprint, e2);
    float uu = product(metric, alongU, alongU);
    float uv2 = product(metric, alongU, alongV);
    float vv = product(metric, alongV, alongV);
    float u0 = product(metric, alongU, origin);
    float v0 = product(metric, alongV, origin);
    float zero = product(metric, origin, origin);
    float cut2 = cut * cut;
    // The ellipse in the face's coordinates, by the directions across its edges.
    float det = uu * vv - uv2 * uv2;
    vec2 at = vec2(uv2 * v0 - vv * u0, uv2 * u0 - uu * v0) / det;
    float left = cut2 - (zero + dot(at, vec2(u0, v0)));
    vec3 reach = sqrt(max(left, 0.0) / det * vec3(vv, uu, uu + vv - 2.0 * uv2));
    if (det < 1e-6 * uu * vv) {
        // Seen from its edge: as if nothing were larger here than texels about the pixel are.
        at = vec2(dot(cross(e2, a), normal), dot(cross(a, e1), normal)) / twice2;
        reach = cut * footprint.major / twice * vec3(length(e2), length(e1), length(e2 - e1));
        left = cut2;
    }
    vec3 inside = vec3(at, 1.0 - at.x - at.y);
    if (left < 0.0 || any(lessThan(inside, -reach))) {
        return -1;
    }
    ivec3 beyond = ivec3(lessThan(inside, reach)); // where u is 0, v, w
    uu /= r * r;
    uv2 /= r * r;
    vv /= r * r;
    u0 /= r;
    v0 /= r;
    float least = exp(-0.5 * cut2);

    int size = 1 << samples.level;
    for (int upper = 0; upper < (samples.areTexels ? 2 : 1); ++upper) {
        float offset = samples.areTexels ? float(1 + upper) / 3.0 : 0.0;
        int last = samples.areTexels ? size - 1 - upper : size;
        vec2 lowest = floor((at - reach.xy) * r - offset);
        vec2 highest = ceil((at + reach.xy) * r - offset);
        int j0 = int(clamp(lowest.y, 0.0, float(last + 1)));
        int j1 = int(clamp(highest.y, -1.0, float(last)));
        for (int j = j0; j <= j1; ++j) {
            // Along a row the squared distance is uu i² + 2 b i + c.
            float y = float(j) + offset;
            float b1 = uv2 * y + u0 + uu * offset;
            float c1 = (vv * y + 2.0 * v0) * y + zero + (2.0 * (uv2 * y + u0) + uu * offset) * offset;
            float under = b1 * b1 - uu * (c1 - cut2);
            if (under <= 0.0) {
                continue;
            }
            float root = sqrt(under);
            float per = 1.0 / max(uu, 1e-20);
            // Clamped as floats: integers do not hold what comes of edges seen from their end.
            float most = float(last - j);
            int i0 = int(clamp(max(ceil((-b1 - root) * per), lowest.x), 0.0, most + 1.0));
            int i1 = int(clamp(min(floor((-b1 + root) * per), highest.x), -1.0, most));
            int row = !samples.areTexels ? (j * (2 * size + 3 - j)) >> 1
                      : upper == 0       ? j * size
                                         : size * size - 1 - j;
            int stride = upper == 0 ? 1 : -size;
            for (int i = i0; i <= i1; ++i) {
                float x = float(i);
                float q = (uu * x + 2.0 * b1) * x + c1;
                float weight = max(exp(-0.5 * q) - least, 0.0);
                if (!samples.areTexels) {
                    // Of the two triangles' area that a vertex stands for, others have what lies
                    // beyond the face's edges.
                    int edges = int(i == 0) + int(j == 0) + int(i + j == size);
                    weight *= edges == 0 ? 2.0 : edges == 1 ? 1.0 : 1.0 / 3.0;
                }
                weight *= step2;
                int index = samples.isConstant ? 0 : row + stride * i;
                sum += weight * (samples.areTexels ? texelFetch(faceTexels, samples.begin + index)
                                                   : texelFetch(texels, samples.begin + index));
                weights += weight;
            }
        }
    }
    return beyond.y | beyond.z << 1 | beyond.x << 2;
}

// A mesh vertex from the pixel's point, which lies `there` from the place that `from` names: of
// large numbers neighbours would not agree to the last bits where the point is.
vec3 seen(uint vertex, vec3 from, float pixel, vec3 there)
{
    return mat3(view) * (texelFetch(positions, int(vertex)).xyz - from) / pixel - there;
}

// From the pixel's face on to all that the footprint reaches through faces that it reaches: the same
// ones whichever of two faces a pixel on their edge belongs to.
// \param isWhole  whether they were few enough; else there is no answer
vec4 texelsAbout(Footprint footprint, float pixel, out bool isWhole)
{
    isWhole = false;
    uvec3 triangle = texelFetch(triangles, faceNumber).xyz;
    vec3 from = texelFetch(positions, int(triangle.x)).xyz;
    vec3 e1 = seen(triangle.y, from, pixel, vec3(0.0));
    vec3 e2 = seen(triangle.z, from, pixel, vec3(0.0));
    vec3 there = uv.x * e1 + uv.y * e2;
    int reached[kMostReached]; // and the edges to go on across
    int count = 0;
    vec4 sum = vec4(0.0);
    float weights = 0.0;
    int first = addFace(footprint, faceNumber, -there, e1 - there, e2 - there, sum, weights);
    reached[count++] = faceNumber << 3 | (first < 0 ? 7 : first);
    for (int n = 0; n < count; ++n) {
        int face = reached[n] >> 3;
        int edges = reached[n] & 7;
        uvec3 own = texelFetch(triangles, face).xyz;
        vec3 corners[3] = vec3[3](seen(own.x, from, pixel, there),
                                  seen(own.y, from, pixel, there),
                                  seen(own.z, from, pixel, there));
        for (int k = 0; k < 3; ++k) {
            if ((edges >> k & 1) == 0) {
                continue;
            }
            uint next = texelFetch(across, 3 * face + k).x;
            int other = int(next >> 2);
            bool isKnown = next == kBorder;
            for (int m = 0; m < count && !isKnown; ++m) {
                isKnown = reached[m] >> 3 == other;
            }
            if (isKnown) {
                continue;
            }
            int edge = int(next & 3u);
            vec3 apex = seen(texelFetch(triangles, other)[(edge + 2) % 3], from, pixel, there);
            vec3 start = corners[(k + 1) % 3]; // of the edge as the other face goes about it
            vec3 end = corners[k];
            int beyond = addFace(footprint,
                                 other,
                                 edge == 0 ? start : edge == 1 ? apex : end,
                                 edge == 0 ? end : edge == 1 ? start : apex,
                                 edge == 0 ? apex : edge == 1 ? end : start,
                                 sum,
                                 weights);
            if (beyond >= 0) {
                if (count == kMostReached) {
                    return vec4(0.0);
                }
                reached[count++] = other << 3 | (beyond & ~(1 << edge));
            }
        }
    }
    isWhole = weights > 0.0;
    return sum / max(weights, 1e-30);
}
