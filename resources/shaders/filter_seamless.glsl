
vec4 filteredTexel()
{
    Footprint footprint = pixelFootprint();
    float variance = footprint.majorSigma * footprint.minorSigma;
    return blockValue(record, uv, levelFor(variance, footprint.texel));
}
