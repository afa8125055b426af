
// How coarse a pixel sees the surface. Appended to surface.frag, and to surface.vert where levels are
// found a vertex.
uniform float unitsPerPixel; // world length of a device pixel at distance 1
uniform float levelCut; // by which all is shown coarser than a pixel, where it does not fit the card
uniform float levelsDropped; // by which texels are shown coarser than they are

// What a pixel averages, in view space. Everything in it is the same on both sides of an edge: it
// comes from the point and from what is interpolated between mesh vertices. A face's own plane
// would give each side of an edge another footprint, and so another level.
//
// With the ray (x, y, -1) to the point, a step of a pixel to the right moves the point by
// (1,0,0) - tilt.x ray, a step upwards by (0,1,0) - tilt.y ray, both by depth and size of a pixel.
vec2 rayTo(vec3 point)
{
    return point.xy / max(-point.z, 1e-30);
}

// The products of these two, by the tilt of the surface.
vec3 steps(vec3 point, vec2 tilt)
{
    vec2 ray = rayTo(point);
    float size = dot(ray, ray) + 1.0;
    return vec3(1.0 + tilt.x * (tilt.x * size - 2.0 * ray.x),
                1.0 + tilt.y * (tilt.y * size - 2.0 * ray.y),
                tilt.x * tilt.y * size - tilt.y * ray.x - tilt.x * ray.y);
}

// Their determinant: the square of the cross product of both steps. From the products themselves it
// would be a difference of large numbers where the surface is seen from near its edge.
float areaOf(vec3 point, vec2 tilt)
{
    float facing = 1.0 - dot(tilt, rayTo(point));
    return dot(tilt, tilt) + facing * facing;
}

// Of a pixel's quarter, as variances are.
float pixelVariance(vec3 point)
{
    float pixel = point.z * unitsPerPixel;
    return 0.25 * pixel * pixel;
}

// Squared edge of the texels that are shown about here. None is larger than its face.
// \param scale  log2 of the length of edges about here, and of that of texels as they are
float texelSize2(vec2 scale)
{
    return exp2(2.0 * min(scale.y + levelsDropped, scale.x));
}

// The level at which interpolation averages with a variance. A vertex's hexagon and the slopes about
// it have 0.2917 of a texel's edge squared more than the texel, whose own is 1/24; base texels count
// as points.
// \param scale  log2 of the length of edges about here, and of that of texels
float levelFor(vec2 scale, float variance, float texel2)
{
    float edge2 = (variance + texel2 / 24.0) / (1.0 / 24.0 + 0.2917);
    return scale.x - 0.5 * log2(edge2) - levelCut;
}

// By the geometric mean of the footprint's axes, half a texel in both of them.
float seamlessLevel(vec3 point, vec2 tilt, vec2 scale)
{
    vec2 ray = rayTo(point);
    float tilt2 = dot(tilt, tilt);
    float along = dot(tilt, ray);
    float sum = 2.0 - 2.0 * along + tilt2 * (dot(ray, ray) + 1.0);
    float pixel2 = pixelVariance(point);
    float texel2 = texelSize2(scale);
    float least = 0.25 * texel2;
    float variance = sqrt(pixel2 * (pixel2 * areaOf(point, tilt) + least * sum) + least * least);
    return levelFor(scale, variance, texel2);
}
