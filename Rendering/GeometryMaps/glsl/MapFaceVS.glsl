//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// Draws a chart's triangles over its rectangle, three vertices a triangle.

in vec3 vertex; // device coordinates, and the triangle's depth: the smaller its area in space, the nearer

flat out int face;
flat out float depth;

void main()
{
  gl_Position = vec4(vertex.xy, 0.0, 1.0);
  face = gl_VertexID / 3;
  depth = vertex.z;
}
