//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) Stipple developers
// SPDX-License-Identifier: BSD-3-Clause
// The face index map: the integer itself, not a color to decode.

flat in int face;
flat in float depth;

out int faceIndex;

void main()
{
  faceIndex = face;
  gl_FragDepth = depth;
}
