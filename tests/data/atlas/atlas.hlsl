// What a shader in HLSL defines before atlas.glsl; compiled by the test, nothing more.
#define ATLAS_HLSL
Buffer<uint> atlasNumbers;
Texture2DArray<float4> pages;
SamplerState bilinear;
#define ATLAS_NUMBER(k) atlasNumbers[k]
#define ATLAS_FETCH(page, pixel) pages.Load(int4(pixel, page, 0))
#define ATLAS_SAMPLE(page, place) pages.SampleLevel(bilinear, float3((place) / 1024.0, page), 0)
#include "atlas.glsl"
float4 main(float4 at : SV_Position, nointerpolation int face : FACE, float2 uv : UV) : SV_Target
{
    return atlasNearest(face, atlasLevel(face), uv) + atlasTrilinear(face, 2.5, uv);
}
