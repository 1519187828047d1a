/* SPDX-FileCopyrightText: Copyright (c) Stipple developers
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * A program that links this library before all others draws with OSMesa: being first, it brings OSMesa's
 * OpenGL entry points before those of the system, and it answers GLEW, which asks GLX for the rest. */
typedef void (*StippleProcedure)(void);
StippleProcedure OSMesaGetProcAddress(const char* name);

__attribute__((visibility("default"))) StippleProcedure glXGetProcAddressARB(const unsigned char* name);
__attribute__((visibility("default"))) StippleProcedure glXGetProcAddress(const unsigned char* name);

StippleProcedure glXGetProcAddressARB(const unsigned char* name)
{
  return OSMesaGetProcAddress((const char*)name);
}

StippleProcedure glXGetProcAddress(const unsigned char* name)
{
  return OSMesaGetProcAddress((const char*)name);
}
