//VTK::System::Dec
//VTK::Output::Dec
// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Several maps at once from the face index map. The values lie in textures used as long arrays.

uniform isampler2D faceMap;
uniform sampler2D triangles;      // three texels a triangle: see OpenGLMapPass.cxx
uniform sampler2D pointValues;    // pointStride texels a point
uniform sampler2D triangleValues; // triangleStride texels a triangle
uniform int pointStride;
uniform int triangleStride;

vec4 fetch(sampler2D store, int index)
{
  return texelFetch(store, ivec2(index & 4095, index >> 12), 0);
}

vec3 barycentric(int face, ivec2 pixel)
{
  vec4 corner = fetch(triangles, 3 * face); // whole pixels, and the rest
  vec4 gradient = fetch(triangles, 3 * face + 1);
  vec2 d = (vec2(pixel) - corner.xy) + (0.5 - corner.zw);
  vec3 b;
  b.y = dot(gradient.xy, d);
  b.z = dot(gradient.zw, d);
  b.x = 1.0 - b.y - b.z;
  b = max(b, 0.0); // the center may be outside by the rounding to subpixels
  return b / (b.x + b.y + b.z);
}

vec4 interpolate(ivec3 corners, vec3 b, int k)
{
  vec4 v = fetch(pointValues, corners.x + k);
  return v + b.y * (fetch(pointValues, corners.y + k) - v) +
    b.z * (fetch(pointValues, corners.z + k) - v);
}

float squares(float mean, float halfDifference)
{
  return 2.0 * (mean * mean + halfDifference * halfDifference);
}

vec4 unit(vec4 v)
{
  float squared = dot(v, v);
  return squared > 0.0 ? v * inversesqrt(squared) : v;
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  int face = texelFetch(faceMap, pixel, 0).r;
  //STIPPLE::Maps
}
