
// Hardware bilinear in the packed squares, each with a border of two texels about both halves
// (core/atlas/atlas_tile.h). A record's first number is where the tile begins: x, y, layer.
uniform sampler2DArray atlas;

vec4 filteredTexel()
{
    float r = float(1 << int(record.y & kLevelMask));
    vec2 p = uv * r;
    vec2 f = fract(p);
    // The half that the texel under the pixel belongs to.
    vec2 at = f.x + f.y > 1.0 ? vec2(r) - p.yx + 3.0 + 1.0 / 6.0 : p + 1.0 + 1.0 / 6.0;
    vec2 origin = vec2(float(record.x & 0xfffu), float((record.x >> 12) & 0xfffu));
    vec2 size = vec2(textureSize(atlas, 0).xy);
    return textureLod(atlas, vec3((origin + at) / size, float(record.x >> 24)), 0.0);
}
